// Nothing but a whole, unchanged snapshot loads, and no bytes do harm.

#include "fluid/core/bytes.h"
#include "fluid/wind_state.h"
#include "tests/tier.h"
#include "tests/unit/snapshot_session.h"

namespace {

using namespace windrow;
using namespace windrow::test;

// With the layout that a snapshot of today has.
const detail::Format k_format{
    "WINDSNAP", detail::load_number<std::uint32_t>(Wind::create({.cells = {1, 1, 1}})->save()->data() + detail::k_letters),
    "snapshot", "Wind::save"};

std::string rejection(std::span<const std::byte> bytes) {
    const auto wind = Wind::load(bytes);
    EXPECT_FALSE(wind);
    return wind ? std::string() : wind.error();
}

// As a file whose checksum is right whatever it holds.
Bytes sealed(std::span<const std::byte> content, detail::Format format = k_format) {
    Bytes bytes = detail::begin_bytes(content.size());
    bytes.insert(bytes.end(), content.begin(), content.end());
    detail::seal(bytes, format);
    return bytes;
}

std::span<const std::byte> content_of(const Bytes& bytes) {
    return std::span(bytes).subspan(detail::k_header_bytes, bytes.size() - detail::k_header_bytes - detail::k_checksum_bytes);
}

Bytes small_snapshot(float gust_intensity = 0.0f) {
    static const auto tile = GustTile::standard(); // held: else each load of a motor with eddies makes its own
    const Gusts gusts{.intensity = gust_intensity};
    Session session{made({.cells = {2, 2, 3}, .ambient = {2.0f, 0.0f, 1.0f}, .profile = LogProfile{}, .gusts = gusts}), {}};
    session.add_all_kinds();
    for (int n = 0; n < 7; ++n) {
        session.act(n);
        (void)session.wind.advance(1.0 / 80.0);
    }
    session.act(1);
    return *session.wind.save();
}

TEST(SnapshotRejection, SaysWhatIsWrong) {
    const Bytes bytes = small_snapshot();
    EXPECT_EQ(rejection({}), "these bytes are not a Windrow snapshot: give what Wind::save returned.");
    const std::string_view words = "A letter to somebody, long enough for a header.";
    EXPECT_EQ(rejection(std::as_bytes(std::span(words))),
              "these bytes are not a Windrow snapshot: give what Wind::save returned.");
    EXPECT_EQ(rejection(sealed(content_of(bytes), {"WINDSNAP", 0x00c0ffee, "", ""})),
              detail::message("snapshot has the layout 00c0ffee, this library reads ", detail::Hex{k_format.version},
                              ": use the release that wrote it."));
    EXPECT_NE(rejection(std::span(bytes).first(bytes.size() - 1)).find("snapshot is truncated: it holds "), std::string::npos);
    Bytes longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_NE(rejection(longer).find("has changed since it was written: its length"), std::string::npos);
    Bytes changed = bytes;
    changed[bytes.size() / 2] ^= std::byte{1};
    EXPECT_EQ(rejection(changed), "snapshot has changed since it was written: its checksum does not match; take another copy.");
    Bytes content(content_of(bytes).begin(), content_of(bytes).end());
    content.push_back(std::byte{0});
    EXPECT_EQ(rejection(sealed(content)), "snapshot cannot be used: bytes follow its last field.");
}

TEST(SnapshotRejection, MeetsWhatValidateRejects) {
    Wind wind = made({.cells = {4, 4, 4}});
    const MotorId id = *wind.motors().add(JetMotor{});
    wind.state().core.config.blend_width = -1.0f;
    wind.state().core.config.max_substeps = 99;
    const std::string config = rejection(*wind.save());
    EXPECT_NE(config.find("blend_width is -1"), std::string::npos) << config;
    EXPECT_NE(config.find("max_substeps is 99"), std::string::npos) << config;
    wind = made({.cells = {4, 4, 4}});
    const MotorId again = *wind.motors().add(JetMotor{});
    ASSERT_EQ(again, id);
    std::get<JetMotor>(const_cast<Motor&>(*wind.motors().find(again))).length = std::numeric_limits<float>::quiet_NaN();
    const std::string motor = rejection(*wind.save());
    EXPECT_NE(motor.find("motor 0 cannot be used: motor.length is nan"), std::string::npos) << motor;
}

TEST(SnapshotRejection, BelievesNoPromiseOfCells) {
    Wind wind = made({.cells = {2, 2, 2}});
    wind.state().core.config.cells = {2048, 2048, 16}; // 2^26 cells, 1 GiB a field
    const std::string reason = rejection(*wind.save());
    EXPECT_NE(reason.find("its length is 67108864 items of 16 bytes or more, but only "), std::string::npos) << reason;
}

TEST(SnapshotRejection, EveryTruncation) {
    const Bytes bytes = small_snapshot();
    for (std::size_t size = 0; size < bytes.size(); ++size)
        ASSERT_FALSE(Wind::load(std::span(bytes).first(size))) << size;
    for (std::size_t size = 0; size < content_of(bytes).size(); ++size)
        ASSERT_FALSE(Wind::load(sealed(content_of(bytes).first(size)))) << size << ", sealed again";
}

TEST(SnapshotRejection, EveryChangedByte) {
    const Bytes bytes = small_snapshot();
    Random random(31);
    for (int n = 0; n < 2000; ++n) {
        Bytes changed = bytes;
        const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
        changed[at] ^= static_cast<std::byte>(random.integer(1, 255));
        ASSERT_FALSE(Wind::load(changed)) << at;
    }
}

// Nobody but a forger makes these: they load or are rejected, and what loads can be used.
TEST(SnapshotRejection, ForgedBytesDoNoHarm) {
    const Bytes calm = small_snapshot(), gusty = small_snapshot(0.2f);
    Random random(32);
    int usable = 0;
    for (int n = 0; n < sampled(3000, 400); ++n) {
        const Bytes& bytes = n % 10 == 0 ? gusty : calm; // a load makes its tile: 5 ms
        Bytes content(content_of(bytes).begin(), content_of(bytes).end());
        for (int changes = random.integer(1, 3); changes > 0; --changes)
            content[static_cast<std::size_t>(random.integer(0, static_cast<int>(content.size()) - 1))] =
                static_cast<std::byte>(random.bits());
        auto wind = Wind::load(sealed(content));
        if (!wind)
            continue;
        ++usable;
        (void)wind->velocity(glm::dvec3(0.5));
        (void)wind->advance(0.03);
        (void)wind->follow(glm::dvec3(3.0));
        (void)wind->step(0.02);
        EXPECT_FALSE(wind->save()->empty());
    }
    figure("snapshot_forged_and_usable", usable);
    EXPECT_GT(usable, 100);
}

} // namespace
