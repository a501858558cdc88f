// Beside surfaces textures, queries of each kind and the CPU find the same wind, in frames and single steps, after save and load.
#include "fluid/core/view_place.h"
#include "shader_words/sample_wind_exact.h"
#include "shader_words/sample_wind_exact_three.h"
#include "shader_words/sample_wind_hlsl.h"
#include "tests/parity/wind_shader.h"
#include "tests/scenarios.h"

namespace windrow::vulkan {
namespace {

using test::Scenario;
constexpr std::size_t k_winds = 3; // of the shader: now, before, felt
constexpr double k_frame = 1.0 / 50.0;

void rough(Config& config) {
    config.boundaries = Boundaries::open_over_floor();
    config.profile = LogProfile{};
    config.roughness = Roughness{};
}

Obstacle house(glm::dvec3 position, Surface surface = Surface::free_slip) {
    return {.position = position,
            .orientation = glm::angleAxis(0.4f, glm::vec3(0.0f, 1.0f, 0.0f)),
            .shape = Block{{2.2f, 2.6f, 1.8f}},
            .surface = surface};
}

std::vector<Scenario> table() {
    using test::scenario_parts::must;
    std::vector<Scenario> rows;
    rows.push_back({.name = "rough_floor", .config = rough});
    rows.push_back({.name = "rough_hills_that_the_box_passes",
                    .config = rough,
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add(test::scenario_parts::hills({-40.0, 0.3, -40.0})));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.follow({0.31 * n, 0.0, -0.17 * n}));
                        }});
    rows.push_back({.name = "house_on_rough_rows",
                    .config =
                        [](Config& config) {
                            rough(config);
                            config.rows = Rows{.first = 0.4f, .uniform = 4, .ratio = 1.2f};
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add(house({0.0, 1.0, 0.0})));
                        }});
    rows.push_back({.name = "lengths_by_place",
                    .config =
                        [](Config& config) {
                            rough(config);
                            config.roughness->map =
                                RoughnessMap{.lengths = test::heights_of({81, 81}, 1.0f,
                                                                         [](double x, double) { return x < 40.0 ? 0.01 : 0.1; }),
                                             .position = {-40.0, 0.0, -40.0}};
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add(house({1.0, 1.0, 0.0})));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.follow({0.2 * n, 0.0, 0.1 * n}));
                        }});
    rows.push_back({.name = "ball_that_moves_in_gusts",
                    .config = [](Config& config) { config.gusts.intensity = 0.2f; },
                    .begin = [](WindControl& wind) { must(wind.obstacles().add({.shape = Sphere{2.3f}})); },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.obstacles().move(test::obstacle_id(), {0.06 * n, 0.02 * n, 0.0}));
                        }});
    rows.push_back(
        {.name = "sticking_house_that_turns",
         .config = [](Config& config) { config.viscosity = 0.1f; },
         .begin = [](WindControl& wind) { must(wind.obstacles().add(house({}, Surface::no_slip))); },
         .step =
             [](WindControl& wind, int n) {
                 must(wind.obstacles().move(test::obstacle_id(), {},
                                            glm::angleAxis(0.03f * static_cast<float>(n), glm::vec3(0.0f, 1.0f, 0.0f))));
             }});
    rows.push_back(
        {.name = "plate_through_a_periodic_side",
         .config = [](Config& config) { config.boundaries.x_low.kind = config.boundaries.x_high.kind = BoundaryKind::periodic; },
         .begin =
             [](WindControl& wind) {
                 must(wind.obstacles().add({.position = {8.0, 0.0, 0.0},
                                            .orientation = glm::angleAxis(0.5f, glm::vec3(0.0f, 1.0f, 0.0f)),
                                            .shape = Plate{{3.0f, 3.0f}}}));
             }});
    rows.push_back({.name = "thin_wall_on_a_rough_floor_in_gusts",
                    .config =
                        [](Config& config) {
                            rough(config);
                            config.gusts.intensity = 0.2f;
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add({.position = {0.3, 1.4, 0.2},
                                                       .orientation = glm::angleAxis(0.7f, glm::vec3(0.0f, 1.0f, 0.0f)),
                                                       .shape = Block{{0.15f, 2.0f, 4.0f}}}));
                        },
                    .step =
                        [](WindControl& wind, int n) {
                            must(wind.follow({0.23 * n, 0.0, 0.19 * n}));
                        }});
    rows.push_back({.name = "house_on_hills_in_a_closed_box",
                    .config =
                        [](Config& config) {
                            rough(config);
                            config.boundaries = Boundaries::all(BoundaryKind::free_slip);
                        },
                    .begin =
                        [](WindControl& wind) {
                            must(wind.obstacles().add(test::scenario_parts::hills({-40.0, 0.2, -40.0})));
                            must(wind.obstacles().add(house({-5.0, 2.0, 1.0})));
                            must(wind.motors().add(DirectionalMotor{.position = {2.0, 3.0, 0.0}}));
                        }});
    return rows;
}

class SurfaceReadings : public WindShader, public testing::WithParamInterface<Scenario> {
  protected:
    void SetUp() override {
        share_device(false);
        if (GetParam().config)
            GetParam().config(config);
    }
    Config config = test::scenario_config();

    // Where plants stand, and all around: relative to the anchor.
    static std::vector<glm::vec4> places(const windrow::Wind& wind, glm::dvec3 anchor) {
        const Box& box = wind.box();
        const glm::vec3 middle(wind.origin() + 0.5 * glm::dvec3(box.size()) - anchor);
        std::vector<glm::vec4> found = places_around(middle, 0.55f * box.size(), 3000);
        for (std::size_t n = 0; n < found.size(); n += 2)
            found[n].y = static_cast<float>(wind.origin().y - anchor.y) + 0.001f * static_cast<float>(n);
        return found;
    }

    // Largest difference between the textures, now and before, and the CPU's views; over the fastest of these.
    void compare(const windrow::Wind& cpu, const Wind& on_device, const std::string& name, bool before = true) {
        const glm::dvec3 anchor = cpu.origin() + glm::dvec3(3.0, -2.0, 1.0);
        const std::vector<glm::vec4> at = places(cpu, anchor);
        const auto winds = sampled(shader_words::sample_wind_exact, on_device, TextureSet::vectors, at, k_winds,
                                   on_device.frame_block(anchor), {}, [](VkDescriptorSet) {});
        const auto hlsl = sampled(shader_words::sample_wind_hlsl, on_device, TextureSet::vectors, at, k_winds,
                                  on_device.frame_block(anchor), {}, [](VkDescriptorSet) {});
        const WindView now = cpu.view(), then = cpu.previous_view();
        double worst = 0.0, worst_before = 0.0, worst_hlsl = 0.0, fastest = 1e-6;
        for (std::size_t n = 0; n < at.size(); ++n) {
            const glm::dvec3 place = anchor + glm::dvec3(at[n]);
            const glm::vec3 u = now.velocity(place);
            fastest = std::max(fastest, difference(winds[k_winds * n], glm::vec3(0.0f)));
            worst = std::max(worst, difference(winds[k_winds * n], u));
            worst_before = std::max(worst_before, difference(winds[k_winds * n + 1], then.velocity(place)));
            worst_hlsl = std::max(worst_hlsl, difference(hlsl[k_winds * n], glm::vec3(winds[k_winds * n])));
        }
        WINDROW_EXPECT_FIGURE("surface_readings.now." + name, worst / fastest, 1e-4);
        if (before) {
            WINDROW_EXPECT_FIGURE("surface_readings.before." + name, worst_before / fastest, 1e-4);
        }
        WINDROW_EXPECT_FIGURE("surface_readings.hlsl." + name, worst_hlsl / fastest, 1e-6);
    }
};

TEST_P(SurfaceReadings, AreThoseOfTheCpu) {
    const Scenario& row = GetParam();
    auto cpu = windrow::Wind::create(config);
    auto gpu =
        Wind::create(sharing_host(), config, {.texel = Texel::single, .textures = TextureSet::both, .queries = ReadBack::cells});
    ASSERT_TRUE(cpu && gpu) << gpu.error();
    if (row.begin) {
        row.begin(*cpu);
        row.begin(*gpu);
    }
    const auto frame = [&](windrow::Wind& on_cpu, Wind& on_device, int n) {
        if (row.step) {
            row.step(on_cpu, n);
            row.step(on_device, n);
        }
        (void)on_cpu.advance(k_frame);
        run([&](VkCommandBuffer commands) { (void)held(on_device.record(commands, {.dt = k_frame, .slot = 0})); });
        (void)on_device.collect(0);
    };
    int n = 0;
    for (; n < 8; ++n)
        frame(*cpu, *gpu, n);
    compare(*cpu, *gpu, row.name);

    // The host's queries of what came back.
    const glm::dvec3 origin = cpu->origin();
    double worst = 0.0, fastest = 1e-6;
    for (const glm::vec4& place : places(*cpu, origin)) {
        const glm::vec3 u = cpu->velocity(origin + glm::dvec3(place));
        worst = std::max(worst, difference(glm::vec4(gpu->velocity(origin + glm::dvec3(place)), 0.0f), u));
        fastest = std::max(fastest, difference(glm::vec4(u, 0.0f), glm::vec3(0.0f)));
    }
    WINDROW_EXPECT_FIGURE("surface_readings.queries." + row.name, worst / fastest, 1e-4);

    // Three textures are filled without the law.
    std::vector<float> x(cpu->box().cell_count()), y(x.size()), z(x.size());
    ASSERT_TRUE(cpu->view().write_axes(x, y, z));
    std::vector<glm::vec4> centres;
    std::vector<glm::vec3> filled;
    const glm::ivec3 middle = config.cells / 2;
    for (int k = -3; k <= 3; ++k)
        for (int j = 1; j + 1 < config.cells.y; ++j)
            for (int i = -3; i <= 3; ++i) {
                const glm::ivec3 cell{middle.x + i, j, middle.z + k};
                const glm::vec3 centre = cpu->box().centre(cell.x, cell.y, cell.z);
                const std::size_t at = cpu->box().index(cell.x, cell.y, cell.z);
                const WindView view = cpu->view();
                const auto place = windrow::detail::place_in(view.box(), view.window(), view.blend_zone(), view.ambient(),
                                                             origin + glm::dvec3(centre));
                centres.emplace_back(centre, 0.0f);
                filled.push_back(glm::mix(place.fraction < 1.0f ? place.ambient : glm::vec3(0.0f), glm::vec3(x[at], y[at], z[at]),
                                          place.fraction));
            }
    const auto three = sampled(shader_words::sample_wind_exact_three, *gpu, TextureSet::axes, centres, k_winds,
                               gpu->frame_block(origin), {}, [](VkDescriptorSet) {});
    double worst_three = 0.0;
    for (std::size_t m = 0; m < centres.size(); ++m)
        worst_three = std::max(worst_three, difference(three[k_winds * m], filled[m]));
    WINDROW_EXPECT_FIGURE("surface_readings.three." + row.name, worst_three / fastest, 1e-4);

    // Save and load: the frame that is shown, and the next one.
    const auto bytes = cpu->save();
    ASSERT_TRUE(bytes);
    auto same = windrow::Wind::load(*bytes);
    auto loaded = Wind::load(sharing_host(), *bytes, {.texel = Texel::single, .queries = ReadBack::cells});
    ASSERT_TRUE(same && loaded) << loaded.error();
    const auto bodies = cpu->obstacles().in_reach();
    const bool moves = std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.moves(); });
    for (const glm::vec4& place : places(*cpu, origin))
        if (!moves) { // bodies that move are shown at rest until the next tick
            EXPECT_EQ(same->velocity(origin + glm::dvec3(place)), cpu->velocity(origin + glm::dvec3(place)));
        }
    run([&](VkCommandBuffer commands) { (void)held(loaded->record(commands, {.dt = 0.0, .slot = 0})); });
    compare(*same, *loaded, row.name + ".loaded", false);
    frame(*same, *loaded, n);
    compare(*same, *loaded, row.name + ".loaded_and_on");
}

TEST_P(SurfaceReadings, OfEachKindOfQueryAgree) {
    const Scenario& row = GetParam();
    auto cpu = windrow::Wind::create(config);
    ASSERT_TRUE(cpu);
    const int rows = config.rows ? config.cells.y : config.cells.y - 2; // a part without the floor
    std::vector<Wind> winds;
    for (const ReadBack kind : {ReadBack::halves, ReadBack::box, ReadBack::points}) {
        auto gpu = Wind::create(sharing_host(), config, {.queries = kind, .read_cells = {12, rows, 12}, .read_points = 400});
        ASSERT_TRUE(gpu) << gpu.error();
        winds.push_back(*std::move(gpu));
    }
    if (row.begin) {
        row.begin(*cpu);
        for (Wind& wind : winds)
            row.begin(wind);
    }
    std::vector<glm::dvec3> points;
    for (int n = 0; n < 6; ++n) {
        if (row.step) {
            row.step(*cpu, n);
            for (Wind& wind : winds)
                row.step(wind, n);
        }
        (void)cpu->step(k_frame);
        points.clear();
        const glm::dvec3 middle = cpu->origin() + 0.5 * glm::dvec3(cpu->box().size());
        for (const glm::vec4& place : places(*cpu, middle))
            if (points.size() < 400 && std::max(std::abs(place.x), std::abs(place.z)) < 4.0f) // within the box that is read
                points.push_back(middle + glm::dvec3(place));
        for (Wind& wind : winds) {
            run([&](VkCommandBuffer commands) {
                const glm::dvec3 around = middle + glm::dvec3(0.0, 1.0, 0.0);
                (void)held(wind.record_step(commands, {.dt = k_frame, .slot = 0, .around = around, .points = points}));
            });
            (void)wind.collect(0);
        }
    }
    const auto asked = winds[2].queried_points();
    ASSERT_TRUE(asked);
    double halves = 0.0, box = 0.0, at_points = 0.0, fastest = 1e-6;
    for (std::size_t n = 0; n < points.size(); ++n) {
        const glm::vec3 u = cpu->velocity(points[n]);
        fastest = std::max(fastest, difference(glm::vec4(u, 0.0f), glm::vec3(0.0f)));
        halves = std::max(halves, difference(glm::vec4(winds[0].velocity(points[n]), 0.0f), u));
        if (config.rows || points[n].y > cpu->origin().y + 6.0) // cells at its faces lack the air beyond
            box = std::max(box, difference(glm::vec4(winds[1].velocity(points[n]), 0.0f), u));
        at_points = std::max(at_points, difference(asked->velocities[n], u));
    }
    WINDROW_EXPECT_FIGURE("surface_readings.halves." + row.name, halves / fastest, 2e-3);
    WINDROW_EXPECT_FIGURE("surface_readings.box." + row.name, box / fastest, 1e-4);
    WINDROW_EXPECT_FIGURE("surface_readings.points." + row.name, at_points / fastest, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Table, SurfaceReadings, testing::ValuesIn(table()),
                         [](const testing::TestParamInfo<Scenario>& row) { return row.param.name; });

} // namespace
} // namespace windrow::vulkan
