// The tables of settings and figures as JSON, from which tools/make_bindings.py makes the C interface and its mirrors: of each struct
// the rows with type, unit, range, default and meaning; of each choice the words. tools/field_comments.py writes the comments of the
// fields of C++ from it. Needs no header of c_api, which is made from it.
#include "coupling/blade.h"
#include "coupling/cascade.h"
#include "coupling/ground_config.h"
#include "coupling/shell.h"
#include "coupling/spring.h"
#include "coupling/tree.h"
#include "fluid/config.h"
#include "fluid/debug_draw.h"
#include "fluid/diagnostics.h"
#include "fluid/motor.h"
#include "fluid/obstacle.h"
#include "scene/setting_writer.h"
#include "tests/scene_schema.h"

namespace windrow {
namespace {

/// "AmbientWind::Settings".
template <class Type>
std::string name_of() {
    const std::string_view text = __PRETTY_FUNCTION__, before = "Type = windrow::";
    const std::size_t begin = text.find(before) + before.size();
    return std::string(text.substr(begin, text.find_first_of(";]", begin) - begin));
}

template <class Number>
constexpr const char* k_number = nullptr;
template <>
constexpr const char* k_number<bool> = "bool";
template <>
constexpr const char* k_number<float> = "float";
template <>
constexpr const char* k_number<double> = "double";
template <>
constexpr const char* k_number<int> = "int32";
template <>
constexpr const char* k_number<std::int64_t> = "int64";
template <>
constexpr const char* k_number<std::uint32_t> = "uint32";

/// GLM's name of a vector: "dvec3".
template <class Value>
constexpr const char* k_letter = nullptr;
template <int Count, class Number>
constexpr const char* k_letter<glm::vec<Count, Number>> = std::same_as<Number, float>    ? ""
                                                          : std::same_as<Number, double> ? "d"
                                                          : std::same_as<Number, int>    ? "i"
                                                          : std::same_as<Number, bool>   ? "b"
                                                                                         : "u";

class Tables {
  public:
    template <class... Structs>
    void add() {
        (add_struct<Structs>(), ...);
    }
    template <class Words>
    void add_choice(const std::string& name, const Words& words) {
        choices_[name] = words;
    }
    [[nodiscard]] std::string text() const {
        std::string text = "{\n\"structs\": {";
        const char* before = "\n";
        for (const auto& [name, rows] : structs_.items()) {
            text += before + test::OrderedJson(name).dump() + ": [\n";
            for (std::size_t n = 0; n < rows.size(); ++n)
                text += "    " + rows[n].dump() + (n + 1 < rows.size() ? ",\n" : "\n]");
            before = ",\n";
        }
        text += "\n},\n\"choices\": {";
        before = "\n";
        for (const auto& [name, words] : choices_.items()) {
            text += before + ("    " + test::OrderedJson(name).dump()) + ": " + words.dump();
            before = ",\n";
        }
        return text + "\n}\n}\n";
    }

  private:
    template <class Struct>
    void add_struct() {
        const std::string name = name_of<Struct>();
        if (structs_.contains(name))
            return;
        structs_[name] = test::OrderedJson::array();
        const Struct value{};
        const auto add = [&](const auto& row, const auto& member) { add_row(name, row, member); };
        if constexpr (HasSettings<Struct>)
            for_each_setting(value, add);
        else
            for_each_row(value, add);
    }

    template <class Row, class Value>
    void add_row(const std::string& name, const Row& row, const Value& value) {
        test::OrderedJson item{{"name", row.name}, {"type", type_of<Value>()}, {"meaning", row.meaning}};
        constexpr bool k_setting = requires {
            row.range;
        };
        Range range;
        if constexpr (k_setting)
            range = row.range;
        else
            range.unit = row.unit;
        if (*range.unit != '\0')
            item["unit"] = range.unit;
        range.unit = "";
        if (std::isfinite(range.min) || std::isfinite(range.max))
            item["range"] = range.measure == Measure::component && (std::is_arithmetic_v<Value> || detail::k_is_optional<Value>)
                                ? detail::message(detail::Bounds{range})
                                : detail::message(detail::VectorBounds{range});
        if constexpr (!k_setting) { // a figure has no default
        } else if constexpr (std::is_enum_v<Value>)
            item["default"] = scene::write_value(value);
        else if constexpr (std::floating_point<Value>)
            item["default"] = std::isfinite(value) ? scene::written(value) : nlohmann::json("infinity");
        else if constexpr (std::is_arithmetic_v<Value> || k_letter<Value> != nullptr)
            item["default"] = scene::written(value);
        structs_[name].push_back(item);
    }

    /// A struct or an enumeration that is met is added too.
    template <class Value>
    std::string type_of() {
        if constexpr (k_number<Value> != nullptr)
            return k_number<Value>;
        else if constexpr (std::is_enum_v<Value>) {
            add_choice(name_of<Value>(), k_words<Value>);
            return name_of<Value>();
        } else if constexpr (detail::k_is_optional<Value>)
            return "optional " + type_of<typename Value::value_type>();
        else if constexpr (HasSettings<Value> || requires { Value::rows(); }) {
            add_struct<Value>();
            return name_of<Value>();
        } else if constexpr (k_letter<Value> != nullptr)
            return detail::message(k_letter<Value>, "vec", static_cast<int>(Value::length()));
        else if constexpr (std::same_as<Value, glm::quat>)
            return "quat";
        else
            return "other";
    }

    test::OrderedJson structs_ = test::OrderedJson::object(), choices_ = test::OrderedJson::object();
};

TEST(Tables, AreThoseThatBindingsAreMadeFrom) {
    Tables tables;
    tables.add<Config, Sampling, AmbientWind::Settings, Diagnostics>();
    tables.add<DirectionalMotor, WakeMotor, JetMotor, VortexMotor, OmniMotor, PressureMotor, Obstacle, PlantDrag, BeltDrag>();
    tables
        .add<Drag, BladeSettings, ShellSettings, TreeClasses, TreePart, SpringClass, FlutterClass, CascadeConfig, GroundConfig>();
    // C has their fields in other forms; tools/field_comments.py writes those of C++.
    tables.add<Box, DebugDraw, Sphere, Capsule, AlignedBox, Cone, Force, Drive, WakeForce, WakeDrive>();
    tables.add<Block, Cylinder, Plate, MeshShape, VoxelShape, Ground>();
    tables.add_choice("Region", k_alternatives<Region>);
    tables.add_choice("Law", k_alternatives<std::variant<Force, Drive>>);
    tables.add_choice("Motor", k_alternatives<Motor>);
    tables.add_choice("DragDeposit", k_alternatives<DragDeposit>);
    tables.add_choice("Shape", k_alternatives<Shape>);
    tables.add_choice("Beyond", k_words<Beyond>);
    test::expect_file(std::filesystem::path(WINDROW_SOURCE_DIR) / "c_api/tables.json", tables.text());
}

} // namespace
} // namespace windrow
