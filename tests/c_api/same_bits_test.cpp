// The C interface beside the C++ one in one program: the same calls give the same bits, and its memory hook covers what it says.
#include "fluid/allocator.h"
#include "fluid/operators.h"
#include "fluid/wind.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>
#include <windrow/windrow.h>

namespace {

struct Destroy {
    void operator()(windrow_wind* wind) const { windrow_wind_destroy(wind); }
    void operator()(windrow_workspace* work) const { windrow_workspace_destroy(work); }
    void operator()(windrow_height_map* map) const { windrow_height_map_destroy(map); }
};
template <class Handle>
using Owned = std::unique_ptr<Handle, Destroy>;

template <class Struct, class Init>
Struct initial(const Init& init) {
    Struct value;
    EXPECT_EQ(init(&value, sizeof value), WINDROW_OK);
    return value;
}

Owned<windrow_wind> make(const windrow_config& config) {
    windrow_wind* wind = nullptr;
    EXPECT_EQ(windrow_wind_create(&config, &wind), WINDROW_OK) << windrow_last_error();
    return Owned<windrow_wind>(wind);
}

// Each operator on the caller's arrays, with an obstacle that moves and an open end, gives what the C++ one does.
TEST(CApi, OperatorsGiveTheBitsOfCpp) {
    using Field = std::vector<glm::vec4>;
    auto config = initial<windrow_config>(windrow_config_init);
    config.cells = {12, 7, 9};
    config.cell_size = 0.5f;
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = {2.0f, 0.0f, 1.0f};
    windrow_workspace* made = nullptr;
    ASSERT_EQ(windrow_workspace_create(&config, &made), WINDROW_OK) << windrow_last_error();
    const Owned<windrow_workspace> c(made);
    auto cpp = windrow::Workspace::create(
        {.box = {.cells = {12, 7, 9}, .cell_size = 0.5f, .boundaries = windrow::Boundaries::open_over_floor()},
         .ambient = {2.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(cpp);
    const std::uint64_t count = windrow_workspace_cell_count(c.get());
    ASSERT_EQ(count, cpp->box().cell_count());

    auto block = initial<windrow_obstacle>(windrow_obstacle_init);
    block.position = {3.0, 1.0, 2.2};
    block.orientation = {0.0f, 0.6f, 0.0f, 1.6f}; // of length 1.7
    const windrow_vec3 velocity{1.0f, 0.0f, 0.5f}, spin{0.0f, 2.0f, 0.0f};
    ASSERT_EQ(windrow_workspace_set_obstacles(c.get(), &block, &velocity, &spin, 1), WINDROW_OK) << windrow_last_error();
    const windrow::PlacedObstacle placed{.position = {3.0f, 1.0f, 2.2f},
                                         .axes = glm::mat3_cast(glm::normalize(glm::quat(1.6f, 0.0f, 0.6f, 0.0f))),
                                         .velocity = {1.0f, 0.0f, 0.5f},
                                         .spin = {0.0f, 2.0f, 0.0f}};
    ASSERT_TRUE(cpp->set_obstacles({&placed, 1}));

    const auto of_c = [](auto& field) { return reinterpret_cast<windrow_vec4*>(field.data()); };
    Field wind(count), old(count);
    std::vector<float> smoke(count), scalar_c(count), scalar_cpp(count);
    for (std::size_t n = 0; n < count; ++n) {
        const auto x = static_cast<float>(n);
        wind[n] = {2.0f + std::sin(0.37f * x), std::sin(0.11f * x), std::cos(0.23f * x), 0.0f};
        old[n] = 0.9f * wind[n];
        smoke[n] = std::sin(0.05f * x);
    }
    Field field_c(count), field_cpp(count), slope_c(count), slope_cpp(count);
    const auto equal = [&](const char* what) {
        EXPECT_EQ(std::memcmp(field_c.data(), field_cpp.data(), count * sizeof(glm::vec4)), 0) << what;
        EXPECT_EQ(std::memcmp(scalar_c.data(), scalar_cpp.data(), count * sizeof(float)), 0) << what;
    };

    auto transport = initial<windrow_transport>(windrow_transport_init);
    transport.dt = 0.1f;
    transport.carried = transport.velocity = of_c(wind);
    transport.velocity_old = of_c(old);
    transport.extrapolation = 0.7f;
    ASSERT_EQ(windrow_advect(c.get(), &transport, of_c(field_c), count), WINDROW_OK) << windrow_last_error();
    windrow::advect(*cpp, {.carried = wind, .velocity = wind, .velocity_old = old, .extrapolation = 0.7f, .dt = 0.1f}, field_cpp);
    equal("advect");

    auto carried = initial<windrow_scalar_transport>(windrow_scalar_transport_init);
    carried.dt = 0.1f;
    carried.carried = smoke.data();
    carried.velocity = of_c(wind);
    carried.clamped = 1;
    carried.outside = 0.25f;
    ASSERT_EQ(windrow_advect_scalar(c.get(), &carried, scalar_c.data(), count), WINDROW_OK);
    ASSERT_TRUE(
        windrow::advect(*cpp, {.carried = smoke, .velocity = wind, .dt = 0.1f, .outside = 0.25f, .clamped = true}, scalar_cpp));
    equal("advect_scalar");

    for (const float viscosity : {0.0f, 0.1f, 5.0f}) {
        windrow_diffusion_method method = -1;
        ASSERT_EQ(windrow_diffuse(c.get(), of_c(wind), viscosity, 0.1f, of_c(field_c), &method, count), WINDROW_OK);
        const auto taken = windrow::diffuse(*cpp, wind, viscosity, 0.1f, field_cpp);
        ASSERT_TRUE(taken);
        EXPECT_EQ(method, static_cast<windrow_diffusion_method>(*taken));
        equal("diffuse");
    }

    ASSERT_EQ(windrow_divergence(c.get(), of_c(wind), scalar_c.data(), count), WINDROW_OK);
    windrow::divergence(*cpp, wind, scalar_cpp);
    equal("divergence");
    scalar_c = scalar_cpp = smoke;
    ASSERT_EQ(windrow_solve_poisson(c.get(), scalar_c.data(), count), WINDROW_OK);
    windrow::solve_poisson(*cpp, scalar_cpp);
    equal("solve_poisson");

    field_c = field_cpp = wind;
    ASSERT_EQ(windrow_project(c.get(), of_c(field_c), of_c(slope_c), smoke.data(), count), WINDROW_OK);
    windrow::project(*cpp, field_cpp, slope_cpp, smoke);
    equal("project");
    EXPECT_EQ(std::memcmp(slope_c.data(), slope_cpp.data(), count * sizeof(glm::vec4)), 0);
    windrow_vec3 impulse{};
    ASSERT_EQ(windrow_workspace_impulse_on(c.get(), 0, &impulse), WINDROW_OK);
    const glm::vec3 wanted = cpp->impulse_on(0);
    EXPECT_EQ(glm::vec3(impulse.x, impulse.y, impulse.z), wanted);
    EXPECT_NE(wanted, glm::vec3(0.0f));
    EXPECT_EQ(windrow_workspace_impulse_on(c.get(), 1, &impulse), WINDROW_REJECTED);
}

TEST(CApi, OperatorsRejectFieldsThatDoNotFit) {
    auto config = initial<windrow_config>(windrow_config_init);
    config.cells = {4, 4, 4};
    windrow_workspace* made = nullptr;
    ASSERT_EQ(windrow_workspace_create(&config, &made), WINDROW_OK);
    const Owned<windrow_workspace> work(made);
    std::vector<windrow_vec4> wind(65);
    const auto rejects = [](windrow_result result, const char* sentence) {
        EXPECT_EQ(result, WINDROW_REJECTED);
        EXPECT_STREQ(windrow_last_error(), sentence);
    };
    rejects(windrow_project(work.get(), wind.data(), nullptr, nullptr, 63),
            "count is 63: give 64, the number of cells of the workspace.");
    rejects(windrow_project(work.get(), nullptr, nullptr, nullptr, 64), "velocity is null: give an array of 64 cells.");
    rejects(windrow_project(work.get(), wind.data(), wind.data() + 1, nullptr, 64),
            "gradient is within the memory of velocity: give an array of its own.");
    auto* const odd = reinterpret_cast<windrow_vec4*>(&wind[0].y);
    rejects(windrow_project(work.get(), odd, nullptr, nullptr, 64), "velocity is not aligned to 16 bytes.");
    rejects(windrow_diffuse(work.get(), wind.data(), -1.0f, 0.1f, wind.data(), nullptr, 64),
            "result is within the memory of field: give an array of its own.\nviscosity is -1: give 0 to 1e+09.");
    auto transport = initial<windrow_transport>(windrow_transport_init);
    transport.carried = transport.velocity = wind.data();
    transport.dt = -1.0f;
    transport.interpolation = 7;
    rejects(windrow_advect(work.get(), &transport, wind.data(), 64), "transport.interpolation is 7: give 0 to 2.");
}

// Defaults are those of C++, to the bit.
TEST(CApi, DefaultsAreThoseOfCpp) {
    const auto c = initial<windrow_config>(windrow_config_init);
    const windrow::Config cpp;
    EXPECT_EQ(c.cells.x, cpp.cells.x);
    EXPECT_EQ(c.cells.y, cpp.cells.y);
    EXPECT_EQ(c.viscosity, cpp.viscosity);
    EXPECT_EQ(c.relaxation_time, -1.0f);
    EXPECT_FALSE(cpp.relaxation_time);
    EXPECT_EQ(c.interpolation, static_cast<int>(cpp.interpolation));
    EXPECT_EQ(c.ticks_hz, cpp.ticks.hz);
    EXPECT_EQ(c.max_substeps, cpp.max_substeps);
    const auto jet = initial<windrow_jet_motor>(windrow_jet_motor_init);
    EXPECT_EQ(jet.law.kind, WINDROW_LAW_DRIVE);
    EXPECT_EQ(jet.law.speed, 12.0f);
    EXPECT_EQ(jet.turbulence.intensity, windrow::JetMotor{}.turbulence.intensity);
    EXPECT_TRUE(std::isinf(jet.envelope.hold));
}

TEST(CApi, GivesTheBitsOfCpp) {
    auto config = initial<windrow_config>(windrow_config_init);
    auto gusts = initial<windrow_gusts>(windrow_gusts_init);
    auto profile = initial<windrow_log_profile>(windrow_log_profile_init);
    gusts.intensity = 0.2f;
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = {4.0f, 0.0f, 1.0f};
    config.gusts = &gusts;
    config.profile = &profile;
    const auto c = make(config);
    auto jet = initial<windrow_jet_motor>(windrow_jet_motor_init);
    jet.direction = {0.0f, 1.0f, 1.0f};
    windrow_motor_id id;
    ASSERT_EQ(windrow_wind_add_jet(c.get(), &jet, &id), WINDROW_OK);
    auto block = initial<windrow_obstacle>(windrow_obstacle_init);
    block.position = {5.0, 0.0, 2.0};
    ASSERT_EQ(windrow_wind_add_obstacle(c.get(), &block, nullptr), WINDROW_OK);

    auto cpp = windrow::Wind::create({.boundaries = windrow::Boundaries::open_over_floor(),
                                      .ambient = {4.0f, 0.0f, 1.0f},
                                      .profile = windrow::LogProfile{},
                                      .gusts = {.intensity = 0.2f}});
    ASSERT_TRUE(cpp);
    const auto cpp_id = cpp->motors().add(windrow::JetMotor{.direction = {0.0f, 1.0f, 1.0f}});
    ASSERT_TRUE(cpp_id);
    ASSERT_TRUE(cpp->obstacles().add({.position = {5.0, 0.0, 2.0}}));

    for (int frame = 0; frame < 20; ++frame) {
        const double x = 0.2 * frame;
        ASSERT_EQ(windrow_wind_follow(c.get(), {x, 0.0, 0.0}), WINDROW_OK);
        ASSERT_EQ(windrow_wind_move_motor(c.get(), id, {x, 1.0, 0.5}), WINDROW_OK);
        ASSERT_EQ(windrow_wind_advance(c.get(), 1.0 / 60.0, nullptr, nullptr), WINDROW_OK);
        ASSERT_TRUE(cpp->follow({x, 0.0, 0.0}));
        ASSERT_TRUE(cpp->motors().move(*cpp_id, {x, 1.0, 0.5}));
        (void)cpp->advance(1.0 / 60.0);
    }
    const windrow_vec4* cells = nullptr;
    std::uint64_t count = 0;
    ASSERT_EQ(windrow_wind_field(c.get(), WINDROW_FRAME_NOW, &cells, &count, nullptr), WINDROW_OK);
    const auto field = cpp->view().field();
    ASSERT_EQ(count, field.size());
    EXPECT_EQ(std::memcmp(cells, field.data(), field.size_bytes()), 0);
    windrow_frame_block block_c;
    ASSERT_EQ(windrow_wind_frame_block(c.get(), {1.0, 0.0, 0.0}, nullptr, &block_c), WINDROW_OK);
    const windrow::FrameBlock block_cpp = cpp->frame_block({1.0, 0.0, 0.0});
    EXPECT_EQ(std::memcmp(&block_c, &block_cpp, sizeof block_c), 0);
}

// --- The allocator --------------------------------------------------------------------------------------------------------
struct Heap {
    std::int64_t held = 0;
    int calls = 0;
    bool fails = false;
};
void* allocate(std::size_t bytes, std::size_t alignment, void* user) {
    auto& heap = *static_cast<Heap*>(user);
    if (heap.fails)
        return nullptr;
    heap.held += static_cast<std::int64_t>(bytes);
    ++heap.calls;
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}
void release(void* memory, std::size_t bytes, std::size_t, void* user) {
    static_cast<Heap*>(user)->held -= static_cast<std::int64_t>(bytes);
    std::free(memory);
}

class HostHeap : public ::testing::Test {
  protected:
    HostHeap() { EXPECT_EQ(windrow_set_allocator(allocate, release, &heap), WINDROW_OK) << windrow_last_error(); }
    ~HostHeap() override {
        EXPECT_EQ(heap.held, 0);
        EXPECT_EQ(windrow_set_allocator(nullptr, nullptr, nullptr), WINDROW_OK);
    }
    // At least 99 % of the wind's memory is the host's.
    void expect_covered(const char* what, const windrow_wind* wind) const {
        const auto all = static_cast<double>(windrow_wind_memory_bytes(wind));
        EXPECT_GE(static_cast<double>(heap.held), 0.99 * all) << what << ": " << heap.held << " of " << all;
    }
    Heap heap;
};

TEST_F(HostHeap, CoversTheMemoryOfEachKindOfWind) {
    auto config = initial<windrow_config>(windrow_config_init);
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = {3.0f, 0.0f, 0.0f};
    {
        const auto wind = make(config);
        expect_covered("default", wind.get());
        ASSERT_EQ(windrow_wind_advance(wind.get(), 0.1, nullptr, nullptr), WINDROW_OK);
        expect_covered("with frames", wind.get());
        auto block = initial<windrow_obstacle>(windrow_obstacle_init);
        for (int n = 0; n < 40; ++n) {
            block.position = {3.0 * (n % 8) - 12.0, 2.0, 3.0 * (n / 8) - 8.0};
            ASSERT_EQ(windrow_wind_add_obstacle(wind.get(), &block, nullptr), WINDROW_OK);
        }
        ASSERT_EQ(windrow_wind_step(wind.get(), 0.02, nullptr), WINDROW_OK);
        expect_covered("with obstacles", wind.get());
    }
    auto gusts = initial<windrow_gusts>(windrow_gusts_init);
    gusts.intensity = 0.2f;
    auto profile = initial<windrow_log_profile>(windrow_log_profile_init);
    auto canopy = initial<windrow_canopy>(windrow_canopy_init);
    auto roughness = initial<windrow_roughness>(windrow_roughness_init);
    auto rows = initial<windrow_rows>(windrow_rows_init);
    config.profile = &profile;
    config.canopy = &canopy;
    config.roughness = &roughness;
    config.rows = &rows;
    {
        const auto wind = make(config);
        ASSERT_EQ(windrow_wind_advance(wind.get(), 0.1, nullptr, nullptr), WINDROW_OK);
        expect_covered("rough ground, canopy, rows", wind.get());
        std::vector<float> heights(65 * 65);
        for (std::size_t n = 0; n < heights.size(); ++n)
            heights[n] = 4.0f + 3.0f * std::sin(0.3f * static_cast<float>(n % 65)) * std::cos(0.3f * static_cast<float>(n / 65));
        windrow_height_map* map = nullptr;
        ASSERT_EQ(windrow_height_map_create({65, 65}, 1.0f, heights.data(), heights.size(), &map), WINDROW_OK);
        const Owned<windrow_height_map> owned(map);
        auto hills = initial<windrow_obstacle>(windrow_obstacle_init);
        hills.shape = windrow_shape_ground(map, {1.0f, 1.0f, 1.0f});
        hills.position = {-32.0, windrow_wind_origin(wind.get()).y, -32.0};
        ASSERT_EQ(windrow_wind_add_obstacle(wind.get(), &hills, nullptr), WINDROW_OK);
        ASSERT_EQ(windrow_wind_step(wind.get(), 0.02, nullptr), WINDROW_OK);
        expect_covered("terrain", wind.get());
        auto blast = initial<windrow_omni_motor>(windrow_omni_motor_init);
        ASSERT_EQ(windrow_wind_add_omni(wind.get(), &blast, nullptr), WINDROW_OK);
        ASSERT_EQ(windrow_wind_step(wind.get(), 0.02, nullptr), WINDROW_OK);
        expect_covered("volume source", wind.get());
    }
    config.gusts = &gusts;
    const auto wind = make(config);
    expect_covered("gusts", wind.get());
    const int calls = heap.calls;
    for (int n = 0; n < 10; ++n)
        ASSERT_EQ(windrow_wind_step(wind.get(), 0.02, nullptr), WINDROW_OK);
    EXPECT_EQ(heap.calls, calls) << "a step allocates";
}

TEST_F(HostHeap, WithoutMemoryIsAnError) {
    const auto config = initial<windrow_config>(windrow_config_init);
    heap.fails = true;
    windrow_wind* wind = nullptr;
    EXPECT_EQ(windrow_wind_create(&config, &wind), WINDROW_OUT_OF_MEMORY);
    EXPECT_EQ(wind, nullptr);
    EXPECT_TRUE(std::string(windrow_last_error()).starts_with("out of memory")) << windrow_last_error();
    heap.fails = false;
}

} // namespace
