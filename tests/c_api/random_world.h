// What random calls of the C interface are made of: numbers, memory, objects of all kinds, and what must hold after a call.
#pragma once

#include "tests/fields.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>
#include <windrow/windrow.h>

namespace windrow::test {

[[noreturn]] void fail(const std::string& what);

class World {
  public:
    World(std::uint32_t seed, std::filesystem::path folder) : random_(seed), folder_(std::move(folder)) {}
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World();

    void begin();
    void begin_call() {
        rooms_.clear();
        depth_ = 0;
    }

    // --- Numbers

    bool one_in(int many) { return random_.integer(1, many) == 1; }
    bool changes() { return one_in(8); }
    template <class Number>
    void number(Number& value, std::string_view name);
    void choose(std::int32_t& value, std::initializer_list<int> values) {
        constexpr std::int32_t k_none[] = {-1, 99, std::numeric_limits<std::int32_t>::min()};
        value =
            one_in(20) ? k_none[random_.integer(0, 2)] : values.begin()[random_.integer(0, static_cast<int>(values.size()) - 1)];
    }
    std::uint32_t size_of(std::size_t whole) { // a size above that of the struct would name memory that is not there
        const auto size = static_cast<std::uint32_t>(whole);
        return one_in(40) ? random_.bits() % size : size;
    }
    /// Of entries: the right number for the most part.
    std::uint64_t count(std::uint64_t right) {
        return right > 0 && !one_in(8) ? right : static_cast<std::uint64_t>(random_.integer(0, 40));
    }
    const char* text();

    // --- Memory: of exact size, so that a sanitizer sees what is read beyond it

    template <class Kind>
    Kind* array(std::uint64_t count) {
        if (count > 100'000 || one_in(40))
            return nullptr;
        Kind* const values = zeroed<Kind>(count);
        for (std::uint64_t i = 0; i < std::min<std::uint64_t>(count, 64); ++i)
            put(values[i]);
        return values;
    }
    /// A struct with any content, or null.
    template <class Kind>
    Kind* maybe() {
        if (depth_ > 3 || one_in(4))
            return nullptr;
        ++depth_;
        Kind* const value = array<Kind>(1);
        --depth_;
        return value;
    }
    template <class Kind>
    Kind* room() {
        return array<Kind>(1);
    }
    template <class Kind>
    Kind* rarely_null(Kind& made) {
        return one_in(40) ? nullptr : &made;
    }
    const void* bytes(std::uint64_t& size);
    void read(const void* data, const std::uint64_t* count) {
        if (data != nullptr && count != nullptr && *count > 0)
            (void)*static_cast<const volatile unsigned char*>(data);
    }

    // --- Objects

    template <class Kind>
    Kind* handle() {
        const auto& pool = std::get<std::vector<Kind*>>(pools_);
        return pool.empty() || one_in(30) ? nullptr : pool[random_.bits() % pool.size()];
    }
    template <class Kind>
    Kind* take();
    template <class Kind>
    void keep(Kind* made);
    template <class Kind>
    void got(const Kind* value) {
        if (value == nullptr)
            return;
        if constexpr (std::is_same_v<Kind, windrow_motor_id>)
            motors_.push_back(*value);
        if constexpr (std::is_same_v<Kind, windrow_obstacle_id>)
            obstacles_.push_back(*value);
        if constexpr (std::is_same_v<Kind, windrow_drag_id>)
            deposits_.push_back(*value);
    }
    template <class Id>
    void any_id(Id& value, const std::vector<Id>& known) {
        value = {random_.bits() % 8, random_.bits() % 4, random_.bits() % 4};
        if (!known.empty() && !one_in(10))
            value = known[random_.bits() % known.size()];
    }
    const std::vector<windrow_motor_id>& motors() const { return motors_; }
    const std::vector<windrow_obstacle_id>& obstacles() const { return obstacles_; }
    const std::vector<windrow_drag_id>& deposits() const { return deposits_; }
    windrow_velocity_at velocity_at() {
        if (one_in(20))
            return nullptr;
        return [](void* user, const windrow_dvec3*, windrow_vec3* velocity) { static_cast<World*>(user)->put(*velocity); };
    }

    windrow_debug_draw debug_draw() {
        if (one_in(20))
            return nullptr;
        return [](void*, const windrow_debug_line* line) {
            if (line->kind < WINDROW_DEBUG_BOX || line->kind > WINDROW_DEBUG_ARROW)
                std::abort();
        };
    }

    // --- Verdicts

    template <class Made>
    void judge(windrow_wind* wind, const Made& call);
    bool worked() const { return worked_; }

    template <class Kind>
    void put(Kind& value);
    template <class Struct>
    void tame(Struct& value);

  private:
    template <class Kind>
    Kind* zeroed(std::uint64_t count) {
        rooms_.emplace_back(std::calloc(std::max<std::uint64_t>(count * sizeof(Kind), 1), 1), &std::free);
        return static_cast<Kind*>(rooms_.back().get());
    }
    std::string saved(windrow_wind* wind);
    void must_heal(windrow_wind* wind);

    Random random_;
    std::filesystem::path folder_;
    std::string text_;
    std::vector<std::unique_ptr<void, decltype(&std::free)>> rooms_;
    int depth_ = 0;
    bool worked_ = false, loaded_ = false;
    std::vector<windrow_motor_id> motors_;
    std::vector<windrow_obstacle_id> obstacles_;
    std::vector<windrow_drag_id> deposits_;
    std::vector<std::string> saved_; // bytes of winds and of logs
    std::tuple<std::vector<windrow_thread_pool*>, std::vector<windrow_mesh*>, std::vector<windrow_voxels*>,
               std::vector<windrow_height_map*>, std::vector<windrow_gust_tile*>, std::vector<windrow_bytes*>,
               std::vector<windrow_event_log*>, std::vector<windrow_wind*>, std::vector<windrow_ambient_wind*>,
               std::vector<windrow_tracer*>, std::vector<windrow_ground*>, std::vector<windrow_cascade*>,
               std::vector<windrow_cascade_step*>, std::vector<windrow_blades*>, std::vector<windrow_shells*>,
               std::vector<windrow_tree*>, std::vector<windrow_workspace*>, std::vector<windrow_scene*>>
        pools_;
};

/// What most calls need: a form of each kind, a pool, a log, a wind.
inline void World::begin() {
    windrow_config config;
    (void)windrow_config_init(&config, sizeof config);
    config.cells = {10, 6, 8};
    config.ambient = {3.0f, 0.0f, 1.0f};
    windrow_wind* wind = nullptr;
    (void)windrow_wind_create(&config, &wind);
    keep(wind);
    windrow_config within = config;
    within.cells = {5, 4, 4};
    within.ambient = {};
    windrow_wind* inner = nullptr;
    windrow_bytes* saved_inner = nullptr;
    // None where a story before has set a unit in which 3 a second is too fast.
    if (windrow_wind_create_inside(&within, wind, &inner) == WINDROW_OK)
        (void)windrow_wind_save(inner, &saved_inner);
    keep(inner);
    keep(saved_inner);
    const windrow_vec3 corners[] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    const std::uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    windrow_mesh* mesh = nullptr;
    (void)windrow_mesh_create(corners, 4, triangles, 4, &mesh);
    keep(mesh);
    const std::uint8_t closed[] = {1, 0, 1, 1, 0, 1, 1, 1};
    windrow_voxels* voxels = nullptr;
    (void)windrow_voxels_create({2, 2, 2}, closed, 8, &voxels);
    keep(voxels);
    const float heights[] = {0.0f, 1.0f, .5f, -1.0f, 0.0f, 2.0f};
    windrow_height_map* map = nullptr;
    (void)windrow_height_map_create({3, 2}, 4.0f, heights, 6, &map);
    keep(map);
    const std::uint8_t open[] = {0, 0, 0, 1, 0, 0};
    (void)windrow_height_map_create_with_holes({3, 2}, 4.0f, heights, 6, {3, 2}, open, 6, &map);
    keep(map);
    windrow_thread_pool* pool = nullptr;
    (void)windrow_thread_pool_create(2, &pool);
    keep(pool);
    windrow_workspace* work = nullptr;
    (void)windrow_workspace_create(&config, &work);
    keep(work);
    constexpr std::string_view k_scene =
        R"({"duration": 1, "air": {"cells": [8, 6, 8], "ambient": [2, 0, 0], "outer": {"cells": [8, 5, 8], "cell_size": 3}},
        "motors": [{"name": "fan", "kind": "directional"}], "obstacles": [{"name": "house", "shape": {"block": {}}}]})";
    windrow_scene* scene = nullptr;
    if (windrow_scene_parse(k_scene.data(), k_scene.size(), "story.json", nullptr, &scene) != WINDROW_OK)
        fail(std::string("the scene: ") + windrow_last_error());
    keep(scene);
}

} // namespace windrow::test
