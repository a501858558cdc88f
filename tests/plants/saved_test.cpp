// What is saved in mid-motion and loaded goes on to the bit: trails, lag, springs and smoke, beside the wind in one file. Damaged bytes
// are rejected or give a state that goes on with finite numbers.
#include "coupling/cascade.h"
#include "coupling/ground_memory.h"
#include "coupling/spring.h"
#include "fluid/core/bytes.h"
#include "fluid/saved_parts.h"
#include "fluid/tracer.h"
#include "tests/winds.h"

#include <cstring>

namespace windrow {
namespace {

using Bytes = std::vector<std::byte>;

/// Calls go_on(bytes) for the same bytes with each one of them changed, sealed again, so that the checksum does not reject them. Returns
/// how many it accepted.
int with_each_byte_changed(const Bytes& bytes, const std::function<bool(const Bytes&)>& go_on) {
    int accepted = 0;
    for (std::size_t n = 0; n < bytes.size(); ++n)
        for (const int change : {0xff, 0x80, 0x01}) {
            Bytes changed = bytes;
            changed[n] ^= static_cast<std::byte>(change);
            EXPECT_FALSE(go_on(changed)) << "byte " << n << ": its checksum does not match";
            const std::size_t end = changed.size() - detail::k_checksum_bytes;
            detail::store_number(&changed[end], detail::checksum(std::span(changed).first(end)));
            accepted += go_on(changed) ? 1 : 0;
        }
    for (std::size_t n = 0; n < bytes.size(); n += 7)
        EXPECT_FALSE(go_on(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)))) << "cut at " << n;
    return accepted;
}

template <class Value>
bool same_bits(std::span<const Value> a, std::span<const Value> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

template <class Value>
bool all_finite(std::span<const Value> values) {
    const std::span<const float> floats(reinterpret_cast<const float*>(values.data()), values.size_bytes() / sizeof(float));
    return std::ranges::all_of(floats, [](float value) { return std::isfinite(value); });
}

// --- Ground ------------------------------------------------------------------------------------------------------------------

void walk(GroundMemory& ground, int frame) {
    const double at = 0.13 * frame, before = 0.13 * (frame - 1);
    const GroundWalker walker{.position = {at, 0.0, 0.4}, .previous = {before, 0.0, 0.4}, .radius = 0.6f};
    ASSERT_TRUE(ground.follow({at, 0.0, 0.0}));
    ASSERT_TRUE(
        ground.advance({.duration = 0.03, .walkers = {&walker, 1}, .wind_lean = {0.1f * static_cast<float>(frame % 5), 0.2f}}));
}

TEST(Saved, GroundGoesOnToTheBit) {
    auto ground = GroundMemory::create({.texels = 24, .texel_size = 0.5f});
    ASSERT_TRUE(ground);
    for (const int frames : {0, 1, 9}) {
        for (int frame = 0; frame < frames; ++frame)
            walk(*ground, frame);
        const auto bytes = ground->save();
        ASSERT_TRUE(bytes) << bytes.error();
        auto loaded = GroundMemory::load(*bytes);
        ASSERT_TRUE(loaded) << loaded.error();
        EXPECT_EQ(*loaded->save(), *bytes);
        GroundMemory other = *ground;
        for (int frame = frames; frame < frames + 10; ++frame) {
            ASSERT_TRUE(same_bits(other.texels(), loaded->texels())) << frame;
            ASSERT_TRUE(same_bits(other.previous_texels(), loaded->previous_texels())) << frame;
            ASSERT_EQ(other.at({0.3, 0.0, 0.2}).lean, loaded->at({0.3, 0.0, 0.2}).lean);
            ASSERT_EQ(other.previous_at({0.3, 0.0, 0.2}).trail, loaded->previous_at({0.3, 0.0, 0.2}).trail);
            walk(other, frame);
            walk(*loaded, frame);
        }
        EXPECT_GT(loaded->at({0.3, 0.0, 0.2}).trail, 0.0f) << "a trail is there";
    }
}

TEST(Saved, GroundOfDamagedBytes) {
    auto ground = GroundMemory::create({.texels = 8, .texel_size = 1.0f});
    ASSERT_TRUE(ground);
    for (int frame = 0; frame < 4; ++frame)
        walk(*ground, frame);
    const int accepted = with_each_byte_changed(*ground->save(), [](const Bytes& bytes) {
        auto loaded = GroundMemory::load(bytes);
        if (!loaded) {
            EXPECT_NE(loaded.error().find("saved ground"), std::string::npos) << loaded.error();
            return false;
        }
        for (int frame = 4; frame < 7; ++frame)
            walk(*loaded, frame);
        EXPECT_TRUE(all_finite(loaded->texels()) && all_finite(loaded->previous_texels()));
        return true;
    });
    EXPECT_GT(accepted, 1000) << "the ranges let through what may be";
}

// --- Cascade -----------------------------------------------------------------------------------------------------------------

Pose pose(int frame) {
    const double turn = 0.2 * frame;
    return {.position = {0.1 * frame, std::sin(turn), 5.0}, .rotation = {0.0, std::sin(turn), 0.0, std::cos(turn)}, .scale = 1.5};
}

TEST(Saved, CascadeGoesOnToTheBit) {
    auto tail = Cascade::create({.stages = 7}, pose(0));
    ASSERT_TRUE(tail);
    for (int frame = 1; frame < 8; ++frame)
        ASSERT_TRUE(tail->advance(0.02, pose(frame)));
    const auto bytes = tail->save();
    ASSERT_TRUE(bytes) << bytes.error();
    auto loaded = Cascade::load(*bytes);
    ASSERT_TRUE(loaded) << loaded.error();
    for (int frame = 8; frame < 18; ++frame) {
        ASSERT_EQ(*tail->save(), *loaded->save());
        ASSERT_TRUE(same_bits(tail->shader_poses({}), loaded->shader_poses({})));
        ASSERT_TRUE(same_bits(tail->previous_shader_poses({}), loaded->previous_shader_poses({})));
        ASSERT_TRUE(tail->advance(0.02, pose(frame)) && loaded->advance(0.02, pose(frame)));
    }
    const int accepted = with_each_byte_changed(*bytes, [](const Bytes& damaged) {
        auto other = Cascade::load(damaged);
        if (!other) {
            EXPECT_NE(other.error().find("saved cascade"), std::string::npos) << other.error();
            return false;
        }
        for (int frame = 8; frame < 12; ++frame)
            EXPECT_TRUE(other->advance(0.02, pose(frame)));
        const Pose tip = other->at(1.0);
        EXPECT_TRUE(std::isfinite(tip.position.x + tip.position.y + tip.position.z + tip.rotation.w));
        return true;
    });
    EXPECT_GT(accepted, 100);
}

// --- Springs -----------------------------------------------------------------------------------------------------------------

template <class Real>
struct Springs {
    std::vector<Real> place, velocity, before, now, place_rest, velocity_rest, previous;

    explicit Springs(std::size_t count)
        : place(count), velocity(count), before(count), now(count), place_rest(count), velocity_rest(count), previous(count) {}
    [[nodiscard]] SpringBatch<Real> batch() { return {place, velocity, before, now, place_rest, velocity_rest, previous}; }
    void step(int frame) {
        before = now;
        for (std::size_t n = 0; n < now.size(); ++n)
            now[n] = static_cast<Real>(std::sin(0.3 * frame + static_cast<double>(n)));
        ASSERT_TRUE(advance_springs<Real>(*spring_step(springs::wheat, 0.02), batch()));
    }
};

template <class Real>
void expect_springs_go_on() {
    Springs<Real> springs(5), loaded(5);
    for (int frame = 0; frame < 8; ++frame)
        springs.step(frame);
    const auto bytes = save_springs<Real>(springs.batch());
    ASSERT_TRUE(bytes) << bytes.error();
    const auto read = load_springs<Real>(*bytes, loaded.batch(), std::span(loaded.now));
    ASSERT_TRUE(read) << read.error();
    for (int frame = 8; frame < 18; ++frame) {
        ASSERT_EQ(*save_springs<Real>(springs.batch()), *save_springs<Real>(loaded.batch()));
        springs.step(frame);
        loaded.step(frame);
    }
    const int accepted = with_each_byte_changed(*bytes, [](const Bytes& damaged) {
        Springs<Real> other(5);
        if (!load_springs<Real>(damaged, other.batch(), std::span(other.now)))
            return false;
        for (int frame = 8; frame < 12; ++frame)
            other.step(frame);
        EXPECT_TRUE(std::ranges::all_of(other.place, [](Real value) { return std::isfinite(value); }));
        return true;
    });
    EXPECT_GT(accepted, 100);
    Springs<Real> fewer(4);
    EXPECT_EQ(
        load_springs<Real>(*bytes, fewer.batch(), std::span(fewer.now)).error(),
        "saved springs cannot be used: it has 5 springs with remainders and with previous places, and the arrays are of 4: give "
        "arrays as they were saved.");
}

TEST(Saved, SpringsGoOnToTheBit) {
    expect_springs_go_on<float>();
    expect_springs_go_on<double>();
}

// --- Smoke, and all in one file ----------------------------------------------------------------------------------------------

/// A wind that follows a player through a moving body, with smoke.
void blow(Wind& wind, Tracer& smoke, int frame) {
    ASSERT_TRUE(wind.follow({0.7 * frame, 3.0, 0.0}));
    ASSERT_TRUE(wind.step(0.05).stepped);
    ASSERT_TRUE(smoke.step(wind.view(), wind.obstacles().in_reach(), 0.05));
    smoke.blow({0.7 * frame - 1.0, 3.0, 0.0}, 1.2f);
}

TEST(Saved, SmokeGoesOnToTheBitWithItsWind) {
    auto wind = Wind::create({.cells = {12, 8, 10}, .ambient = {3.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->obstacles().add({.position = {2.0, 3.0, 0.0}, .shape = Block{glm::vec3(0.8f, 2.0f, 1.1f)}}));
    auto smoke = Tracer::create(wind->view());
    ASSERT_TRUE(smoke);
    for (int frame = 0; frame < 8; ++frame)
        blow(*wind, *smoke, frame);
    const auto air = wind->save(), puffs = smoke->save();
    ASSERT_TRUE(air && puffs);
    const SavedPart parts[] = {{"wind", *air}, {"smoke", *puffs}};
    const auto file = join_parts(parts);
    ASSERT_TRUE(file) << file.error();

    const auto found = split_parts(*file);
    ASSERT_TRUE(found) << found.error();
    auto loaded_wind = Wind::load(*find_part(*found, "wind"));
    ASSERT_TRUE(loaded_wind) << loaded_wind.error();
    auto loaded = Tracer::load(*find_part(*found, "smoke"), loaded_wind->view(), loaded_wind->obstacles().in_reach());
    ASSERT_TRUE(loaded) << loaded.error();
    // Before a step, beside the block: the faces of the last step are known.
    smoke->blow({2.0, 3.0, 1.5}, 1.5f);
    loaded->blow({2.0, 3.0, 1.5}, 1.5f);
    for (int frame = 8; frame < 18; ++frame) {
        ASSERT_TRUE(same_bits(smoke->cells(), loaded->cells())) << frame;
        blow(*wind, *smoke, frame);
        blow(*loaded_wind, *loaded, frame);
    }
    auto other = Wind::create({.cells = {12, 8, 11}});
    EXPECT_FALSE(Tracer::load(*puffs, other->view(), {})) << "another wind";
}

TEST(Saved, SmokeOfDamagedBytes) {
    auto wind = Wind::create({.cells = {4, 4, 4}, .ambient = {3.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(wind) << wind.error();
    auto smoke = Tracer::create(wind->view());
    ASSERT_TRUE(smoke);
    for (int frame = 0; frame < 3; ++frame)
        blow(*wind, *smoke, frame);
    const int accepted = with_each_byte_changed(*smoke->save(), [&](const Bytes& bytes) {
        auto loaded = Tracer::load(bytes, wind->view(), {});
        if (!loaded)
            return false;
        EXPECT_TRUE(loaded->step(wind->view(), {}, 0.05));
        EXPECT_TRUE(std::ranges::all_of(loaded->cells(), [](float value) { return value >= 0.0f && value <= 1.0f; }));
        return true;
    });
    EXPECT_GT(accepted, 10);
}

TEST(Saved, PartsOfDamagedBytes) {
    const Bytes one(5, std::byte{1}), other(3, std::byte{2});
    const SavedPart parts[] = {{"a", one}, {"bc", other}, {"empty", {}}};
    const auto file = join_parts(parts);
    ASSERT_TRUE(file);
    const auto found = split_parts(*file);
    ASSERT_TRUE(found) << found.error();
    ASSERT_EQ(found->size(), 3u);
    EXPECT_TRUE(same_bits<std::byte>(*find_part(*found, "bc"), other) && find_part(*found, "empty")->empty());
    EXPECT_EQ(find_part(*found, "d").error(), "the file has no part \"d\": save it with the others.");
    (void)with_each_byte_changed(*file, [](const Bytes& bytes) {
        const auto read = split_parts(bytes);
        std::size_t sum = 0;
        if (read)
            for (const SavedPart& part : *read)
                for (const std::byte byte : part.bytes)
                    sum += std::to_integer<std::size_t>(byte);
        EXPECT_LT(sum, 10'000u);
        return read.has_value();
    });
    const SavedPart twice[] = {{"a", one}, {"a", other}}, unnamed[] = {{"", one}};
    EXPECT_EQ(join_parts(twice).error(), "two parts have the name \"a\": give each its own.");
    EXPECT_EQ(join_parts(unnamed).error(), "a part's name has 0 letters: give 1 to 64.");
}

} // namespace
} // namespace windrow
