// Not compiled here: it needs godot-cpp. A node of Godot 4 that owns a wind; Godot's axes and unit are the library's.
//
//     var wind = WindrowNode.new()
//     wind.ambient = Vector3(3, 0, 0)
//     wind.player = $Player.get_path()
//     ...
//     leaf.bend(wind.velocity_at(leaf.global_position))
//
// 1. Build it as a GDExtension with godot-cpp, linked with libwindrow, and register WindrowNode in the module's initialiser.
// 2. `_ready` creates the wind over a floor at height 0; a fault is one sentence in Godot's output.
// 3. `_process` follows the player and advances; the fixed ticks are inside.
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/utility_functions.hpp>
#include <windrow/windrow.h>

namespace godot {

class WindrowNode : public Node3D {
    GDCLASS(WindrowNode, Node3D)

  public:
    ~WindrowNode() override { windrow_wind_destroy(wind_); }

    void _ready() override {
        windrow_config config;
        windrow_config_init(&config, sizeof config);
        config.boundaries = windrow_boundaries_open_over_floor();
        config.ambient = {static_cast<float>(ambient_.x), static_cast<float>(ambient_.y), static_cast<float>(ambient_.z)};
        report(windrow_wind_create(&config, &wind_));
    }
    void _process(double seconds) override {
        if (wind_ == nullptr)
            return;
        if (const Node3D* const player = get_node<Node3D>(player_)) {
            const Vector3 place = player->get_global_position();
            report(windrow_wind_follow(wind_, {place.x, place.y, place.z}));
        }
        report(windrow_wind_advance(wind_, seconds, nullptr, nullptr));
    }
    Vector3 velocity_at(const Vector3& place) const {
        windrow_vec3 velocity{};
        if (wind_ != nullptr)
            report(windrow_wind_velocity(wind_, {place.x, place.y, place.z}, &velocity));
        return {velocity.x, velocity.y, velocity.z};
    }

    void set_ambient(const Vector3& ambient) { ambient_ = ambient; }
    Vector3 get_ambient() const { return ambient_; }
    void set_player(const NodePath& player) { player_ = player; }
    NodePath get_player() const { return player_; }

  protected:
    static void _bind_methods() {
        ClassDB::bind_method(D_METHOD("velocity_at", "place"), &WindrowNode::velocity_at);
        ClassDB::bind_method(D_METHOD("set_ambient", "ambient"), &WindrowNode::set_ambient);
        ClassDB::bind_method(D_METHOD("get_ambient"), &WindrowNode::get_ambient);
        ClassDB::bind_method(D_METHOD("set_player", "player"), &WindrowNode::set_player);
        ClassDB::bind_method(D_METHOD("get_player"), &WindrowNode::get_player);
        ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "ambient"), "set_ambient", "get_ambient");
        ADD_PROPERTY(PropertyInfo(Variant::NODE_PATH, "player"), "set_player", "get_player");
    }

  private:
    static void report(windrow_result result) {
        if (result != WINDROW_OK)
            UtilityFunctions::printerr(windrow_last_error());
    }

    windrow_wind* wind_ = nullptr;
    Vector3 ambient_{3.0f, 0.0f, 0.0f}; // [m/s] a breeze
    NodePath player_;
};

} // namespace godot
