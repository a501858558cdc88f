// A setting is its declaration and its row: validation, reader, writer, bytes, schema and the tables in docs/ follow from the row.
#include "fluid/core/archive.h"
#include "fluid/core/validation.h"
#include "scene/setting_reader.h"
#include "scene/setting_writer.h"
#include "tests/scene_schema.h"

#include <gtest/gtest.h>
#include <string>

namespace windrow::test {

// With names that other files could see: a struct that has none makes clang ask for the body of what counts its members.
enum class Shade : std::uint8_t { bright, dull };

struct Bulb {
    static constexpr const char* k_name = "bulb";
    static constexpr const char* k_meaning = "Electric.";
    float power = 40.0f;

    static constexpr auto settings() {
        return std::tuple{Setting("power", &Bulb::power, Range::above(0.0, 1e3, "W"), "How bright it is.")};
    }
};
struct Candle {
    static constexpr const char* k_name = "candle";
    static constexpr const char* k_meaning = "Of wax.";
    int wicks = 1;

    static constexpr auto settings() { return std::tuple{Setting("wicks", &Candle::wicks, {1.0, 9.0}, "Flames.")}; }
};

struct Lantern {
    float height = 2.5f;
    glm::vec3 aim{0.0f, -1.0f, 0.0f};
    Shade shade = Shade::dull;
    std::variant<Bulb, Candle> light = Candle{};
    std::optional<Bulb> spare{};
    bool lit = true;
    double age = 0.0;
    void* host = nullptr;

    static constexpr auto settings() {
        return std::tuple{
            Setting("height", &Lantern::height, {0.0, 10.0, "m", "on the ground"}, "Where it hangs."),
            Setting("aim", &Lantern::aim, Range::direction(), "Where it shines."),
            Setting("shade", &Lantern::shade, "Its glass."),
            Setting("light", &Lantern::light, "What burns."),
            Setting("spare", &Lantern::spare, "Another."),
            Setting("lit", &Lantern::lit, "Whether it burns."),
            Setting("age", &Lantern::age, "How old it is.", k_in_snapshots),
            Setting("host", &Lantern::host, "The host's.", k_not_stored),
        };
    }
};

struct Street {
    Candle first{};
    std::vector<Bulb> lamps{};
    glm::dvec2 end{0.0};
    glm::dvec3 sign{0.0};
    std::optional<double> length{};
    std::string name{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("", &Street::first, "Its settings are the street's own."),
            Setting("lamps", &Street::lamps, {0.0, 2.0}, "Along it."),
            Setting("end", &Street::end, {-10.0, 10.0, "m"}, "Where it ends."),
            Setting("sign", &Street::sign, {-100.0, 1e12, "m"}, "Where its sign is."),
            Setting("length", &Street::length, {0.0, 100.0, "m"}, "Where known."),
            Setting("name", &Street::name, "For people."),
        };
    }
};

} // namespace windrow::test

template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::test::Shade>{"bright", "dull"};

namespace windrow::test {
namespace {

using nlohmann::json;

/// Reads the text; the faults, a line each.
template <class Struct>
std::string read(const char* text, Struct& value, std::vector<scene::KnownKey>* known = nullptr) {
    detail::InputBudget budget;
    scene::ReadLog log("a.json", budget, known);
    const json document = json::parse(text);
    scene::read_object(scene::JsonObject(document, "$", "$", log), value);
    return log.faults() == 0 ? "" : log.error().message;
}

TEST(Setting, OutOfRangeIsASentenceWithPathValueAndRange) {
    Lantern lantern{.height = 11.0f, .aim = {}, .shade = static_cast<Shade>(7), .light = Bulb{0.0f}, .spare = Bulb{NAN}};
    EXPECT_EQ(detail::validate_settings(lantern, "lantern").error(),
              "lantern.height is 11 m: give 0 (on the ground) to 10 m.\n"
              "lantern.aim is (0, 0, 0): give a finite vector that is not 0.\n"
              "lantern.shade is 7: give bright or dull.\n"
              "lantern.light.bulb.power is 0 W: give a number above 0, at most 1000 W.\n"
              "lantern.spare.power is nan W: give a number above 0, at most 1000 W.");
    EXPECT_TRUE(detail::validate_settings(Lantern{}, "lantern"));
}

TEST(Setting, IsReadWithItsRangeAndKeepsItsDefault) {
    Lantern lantern;
    EXPECT_EQ(read(R"({"aim": [1, 2, 3], "shade": "bright", "light": {"bulb": {}}, "spare": {"power": 9}})", lantern), "");
    EXPECT_EQ(lantern.height, 2.5f);
    EXPECT_EQ(lantern.aim, glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(lantern.shade, Shade::bright);
    EXPECT_EQ(std::get<Bulb>(lantern.light).power, 40.0f);
    EXPECT_EQ(lantern.spare->power, 9.0f);
    EXPECT_EQ(read(R"({"height": 11, "aim": [0, 0, 0], "age": 1, "light": {"candle": {"wicks": 0}}})", lantern),
              "a.json: $.height is 11 m: give 0 (on the ground) to 10 m.\n"
              "a.json: $.aim is [0,0,0]: give a finite vector that is not 0.\n"
              "a.json: $.light.candle.wicks is 0: give 1 to 9.\n"
              "a.json: $.age is not a known key (known: height, aim, shade, light, spare, lit): rename or remove it.");
}

TEST(Setting, IsWrittenSoThatItIsReadAgain) {
    const Lantern lantern{
        .height = 0.1f, .aim = {0.5f, 0.0f, -2.0f}, .shade = Shade::bright, .light = Bulb{60.0f}, .spare = Bulb{}, .lit = false};
    const json text = scene::write_object(lantern);
    EXPECT_EQ(
        text.dump(),
        R"({"aim":[0.5,0,-2],"height":0.1,"light":{"bulb":{"power":60}},"lit":false,"shade":"bright","spare":{"power":40}})");
    Lantern again;
    EXPECT_EQ(read(text.dump().c_str(), again), "");
    EXPECT_EQ(scene::write_object(again), text);
    EXPECT_EQ(again.height, 0.1f);
}

TEST(Setting, IsStoredInBytesUnlessItIsTheHosts) {
    constexpr detail::Format k_format{"LANTERNS", 1, "lantern", "a test"};
    int host = 0;
    const Lantern lantern{.height = 3.0f, .light = Bulb{7.0f}, .spare = Bulb{8.0f}, .lit = false, .age = 12.0, .host = &host};
    detail::Writer writer(64);
    writer(lantern);
    const auto bytes = std::move(writer).finish(k_format);
    detail::Reader reader(*detail::unseal(bytes, k_format));
    Lantern again;
    reader(again);
    reader.end();
    EXPECT_FALSE(reader.rejected()) << reader.reason();
    EXPECT_EQ(scene::write_object(again), scene::write_object(lantern));
    EXPECT_EQ(again.age, 12.0);
    EXPECT_EQ(again.host, nullptr);
}

// What a snapshot is made of names its layout, so that one of another layout is rejected.
struct Renamed {
    float power = 40.0f;
    static constexpr auto settings() { return std::tuple{Setting("watts", &Renamed::power, {}, "")}; }
};
struct Widened {
    double power = 40.0;
    static constexpr auto settings() { return std::tuple{Setting("power", &Widened::power, {}, "")}; }
};
struct Longer {
    float power = 40.0f;
    bool lit = true;
    static constexpr auto settings() {
        return std::tuple{Setting("power", &Longer::power, {}, ""), Setting("lit", &Longer::lit, "")};
    }
};
struct Hosted {
    float power = 40.0f;
    void* host = nullptr;
    static constexpr auto settings() {
        return std::tuple{Setting("power", &Hosted::power, {}, ""), Setting("host", &Hosted::host, "", k_not_stored)};
    }
};

TEST(Setting, NamesTheLayoutOfBytes) {
    constexpr auto version = []<class Struct>(Struct) { return detail::Layout("a").with<Struct>().version(); };
    constexpr auto k_bulb = version(Bulb{});
    EXPECT_NE(version(Renamed{}), k_bulb);
    EXPECT_NE(version(Widened{}), k_bulb);
    EXPECT_NE(version(Longer{}), k_bulb);
    EXPECT_EQ(version(Hosted{}), k_bulb);
    EXPECT_NE(detail::Layout("b").with<Bulb>().version(), k_bulb);
}

TEST(Setting, IsInSchemaAndTables) {
    std::vector<scene::KnownKey> known;
    Lantern lantern;
    EXPECT_EQ(read(R"({"light": {"bulb": {}}})", lantern, &known), "");
    SchemaNode root;
    for (const scene::KnownKey& key : known)
        root.add(key);
    const OrderedJson schema = root.object_schema();
    EXPECT_EQ(
        schema["properties"]["height"].dump(),
        R"({"description":"[m] Where it hangs. 0: on the ground.","type":"number","minimum":0,"maximum":10,"default":2.5})");
    EXPECT_EQ(schema["properties"]["light"]["properties"]["bulb"]["properties"]["power"]["exclusiveMinimum"], 0);
    EXPECT_EQ(schema["properties"]["shade"]["enum"].dump(), R"(["bright","dull"])");
    EXPECT_FALSE(schema["properties"].contains("age"));
    std::string tables;
    root.write_tables(tables);
    EXPECT_NE(tables.find("| `height` | 0 (on the ground) to 10 m | `2.5` | Where it hangs. |\n"), std::string::npos) << tables;
}

TEST(Setting, ListsAndStructsWithoutANameAreReadWrittenAndJudged) {
    Street street;
    const char* const text = R"({"end":[1,-2],"lamps":[{"power":3},{"power":40}],"length":5,"sign":[0,-100,7.5],"wicks":4})";
    EXPECT_EQ(read(text, street), "");
    EXPECT_EQ(street.first.wicks, 4);
    EXPECT_EQ(street.lamps.at(0).power, 3.0f);
    EXPECT_EQ(street.end, glm::dvec2(1.0, -2.0));
    EXPECT_EQ(scene::write_object(street).dump(), text);
    EXPECT_TRUE(detail::validate_settings(street, "street"));
    EXPECT_EQ(read(R"({"end": [1, 11], "lamps": [{}, {"power": 0}], "sign": [0, -101, 2e9], "length": -1, "wicks": 0})", street),
              "a.json: $.wicks is 0: give 1 to 9.\n"
              "a.json: $.lamps[1].power is 0 W: give a number above 0, at most 1000 W.\n"
              "a.json: $.end[1] is 11 m: give -10 to 10 m.\n"
              "a.json: $.sign[1] is -101 m: give -100 to 1e9 m.\n"
              "a.json: $.sign[2] is 2e9 m: give -100 to 1e9 m.\n"
              "a.json: $.length is -1 m: give 0 to 100 m.");
    EXPECT_EQ(read(R"({"lamps": [{}, {}, {}]})", street), "a.json: $.lamps holds 3 items: give at most 2.");
    street = {.first = {0}, .lamps = {{}, {0.0f}}, .end = {0.0, NAN}};
    EXPECT_EQ(detail::validate_settings(street, "street").error(),
              "street.wicks is 0: give 1 to 9.\n"
              "street.lamps[1].power is 0 W: give a number above 0, at most 1000 W.\n"
              "street.end is (0, nan) m: give each component -10 to 10 m.");
    street = {.lamps = std::vector<Bulb>(3)};
    EXPECT_EQ(detail::validate_settings(street).error(), "lamps has 3 entries: give 0 to 2.");
}

} // namespace
} // namespace windrow::test
