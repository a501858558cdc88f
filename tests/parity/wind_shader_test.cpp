// What a shader that includes shaders/coupling/windrow_wind.glsl finds in the textures of a recording.
#include "shader_words/sample_wind.h"
#include "shader_words/sample_wind_exact.h"
#include "shader_words/sample_wind_exact_three.h"
#include "shader_words/sample_wind_hlsl.h"
#include "shader_words/sample_wind_three.h"
#include "tests/parity/wind_shader.h"

#include <array>

namespace windrow::vulkan {
namespace {

// In the order of the shader: now, before, felt.
constexpr std::size_t k_winds = 3;

class WindInShaders : public WindShader {
  protected:
    std::vector<glm::vec4> winds_at(std::span<const std::uint32_t> code, const Wind& wind, TextureSet textures,
                                    const std::vector<glm::vec4>& places, glm::dvec3 anchor = {}, const Sampling& sampling = {}) {
        return sampled(code, wind, textures, places, k_winds, wind.frame_block(anchor, sampling), {}, [](VkDescriptorSet) {});
    }
};

// With float weights a shader that includes windrow_wind.glsl samples the wind that the CPU's query returns from the same cells.
TEST_F(WindInShaders, AnOutsideShaderSamplesWhatAQueryFinds) {
    const std::array<Config, 4> configs = {{
        {.cells = {20, 12, 16},
         .boundaries = Boundaries::open_over_floor(),
         .centre = {1e6, 6.0, -1e6},
         .ambient = {3.0f, 0.0f, 1.0f},
         .profile = LogProfile{},
         .gusts = {.intensity = 0.25f}},
        {.cells = {9, 7, 11},
         .cell_size = 0.5f,
         .boundaries = Boundaries::all(BoundaryKind::periodic),
         .ambient = {1.0f, 0.5f, -2.0f}},
        {.cells = {12, 12, 12},
         .ambient = {0.0f, 0.0f, 2.0f},
         .gusts = {.tile = GustTile::bake(3)},
         .blend_width = 0.0f}, // for detail alone
        {.cells = {16, 14, 12},
         .boundaries = Boundaries::open_over_floor(),
         .centre = {0.0, 6.0, 0.0},
         .ambient = {3.0f, 0.0f, 1.0f},
         .profile = LogProfile{},
         .gusts = {.intensity = 0.25f},
         .rows = Rows{.first = 0.3f, .uniform = 3, .ratio = 1.25f}},
    }};
    for (const Config& config : configs) {
        TwoWinds pair = make(config, 0, {.texel = Texel::single, .textures = TextureSet::both});
        pair.add(VortexMotor{.position = config.centre, .radius = 3.0f});
        for (int n = 0; n < 20; ++n) {
            const glm::dvec3 player = config.centre + glm::dvec3(0.3 * n, 0.0, 0.1 * n);
            pair.follow(player);
            frame(pair, 1.0 / 50.0);
        }
        const glm::dvec3 anchor = config.centre + glm::dvec3(12.3, -4.5, 6.7);
        const std::vector<glm::vec4> places =
            places_around(glm::vec3(config.centre - anchor), 0.9f * config.cell_size * glm::vec3(config.cells), 10000);
        const Sampling sampling{.strength = 1.3f, .limit = 20.0f, .detail = 0.2f};
        const std::vector<glm::vec4> winds =
            winds_at(shader_words::sample_wind_exact, pair.device, TextureSet::vectors, places, anchor, sampling);
        EXPECT_EQ(winds, winds_at(shader_words::sample_wind_exact_three, pair.device, TextureSet::axes, places, anchor, sampling))
            << "three textures hold what one holds";
        const std::vector<glm::vec4> by_hlsl =
            winds_at(shader_words::sample_wind_hlsl, pair.device, TextureSet::vectors, places, anchor, sampling);
        double worst_hlsl = 0.0;
        for (std::size_t n = 0; n < winds.size(); ++n)
            worst_hlsl = std::max(worst_hlsl, difference(by_hlsl[n], glm::vec3(winds[n])));
        WINDROW_EXPECT_FIGURE("shader_query.hlsl", worst_hlsl, 1e-6); // of one text
        // The cells of the last frame are read by an empty one.
        run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = 0.0})); });
        const auto view = *pair.device.queried();
        const auto before = pair.cpu.previous_view();
        double worst = 0.0, worst_before = 0.0, worst_felt = 0.0;
        for (std::size_t n = 0; n < places.size(); ++n) {
            const glm::dvec3 world = anchor + glm::dvec3(places[n]);
            worst = std::max(worst, difference(winds[3 * n], view.velocity(world)));
            worst_before = std::max(worst_before, difference(winds[3 * n + 1], before.velocity(world)));
            worst_felt = std::max(worst_felt, difference(winds[3 * n + 2], view.felt(world, sampling)));
        }
        WINDROW_EXPECT_FIGURE("shader_query.now", worst, 1e-5);
        WINDROW_EXPECT_FIGURE("shader_query.before", worst_before, 3e-5); // of the CPU's own cells
        WINDROW_EXPECT_FIGURE("shader_query.felt", worst_felt, 2e-5);
    }
}

// The frame before the first recording of a loaded wind is the one that was saved.
TEST_F(WindInShaders, ALoadedWindHasTheFrameBefore) {
    auto cpu = windrow::Wind::create({.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.3f}});
    ASSERT_TRUE(cpu) << cpu.error();
    ASSERT_TRUE(cpu->motors().add(VortexMotor{.radius = 3.0f}));
    for (int n = 0; n < 10; ++n) {
        ASSERT_TRUE(cpu->follow({0.4 * n, 0.0, 0.0}));
        (void)cpu->advance(1.0 / 50.0);
    }
    auto loaded = Wind::load(own->host(), *cpu->save(), {.texel = Texel::single});
    ASSERT_TRUE(loaded) << loaded.error();
    const std::vector<glm::vec4> places = places_around(glm::vec3(3.6f, 0.0f, 0.0f), glm::vec3(5.0f), 500);
    for (const double dt : {1.0 / 50.0, 0.0}) { // a pause shows the frame twice
        run([&](VkCommandBuffer commands) { held(loaded->record(commands, {.dt = dt})); });
        (void)cpu->advance(dt);
        const std::vector<glm::vec4> winds = winds_at(shader_words::sample_wind_exact, *loaded, TextureSet::vectors, places);
        double worst = 0.0;
        for (std::size_t n = 0; n < places.size(); ++n) {
            worst = std::max(worst, difference(winds[k_winds * n], cpu->velocity(glm::dvec3(places[n]))));
            worst = std::max(worst, difference(winds[k_winds * n + 1], cpu->previous_view().velocity(glm::dvec3(places[n]))));
        }
        WINDROW_EXPECT_FIGURE("shader_query.loaded", worst, 3e-5);
    }
}

// Half textures round to 11 bits: to half a unit in the last of them.
TEST_F(WindInShaders, HalfTexturesHoldElevenBits) {
    TwoWinds pair = make({.cells = {12, 10, 11}, .ambient = {2.0f, 0.0f, 1.0f}, .blend_width = 0.0f}, 0,
                         {.texel = Texel::half, .textures = TextureSet::both});
    pair.add(VortexMotor{});
    for (int n = 0; n < 20; ++n)
        frame(pair, 1.0 / 50.0);
    const std::vector<glm::vec4> places = places_around({}, glm::vec3(4.0f), 1000);
    const std::vector<glm::vec4> winds = winds_at(shader_words::sample_wind_exact, pair.device, TextureSet::vectors, places);
    EXPECT_EQ(winds, winds_at(shader_words::sample_wind_exact_three, pair.device, TextureSet::axes, places));
    run([&](VkCommandBuffer commands) { held(pair.device.record(commands, {.dt = 0.0})); });
    const auto view = *pair.device.queried();
    double worst = 0.0, fastest = 0.0;
    for (const glm::vec4& u : view.field())
        fastest = std::max(fastest, difference(u, glm::vec3(0.0f)));
    for (std::size_t n = 0; n < places.size(); ++n)
        worst = std::max(worst, difference(winds[k_winds * n], view.velocity(glm::dvec3(places[n]))));
    // The place itself is rounded too: 1e-5 m/s, as with whole textures.
    WINDROW_EXPECT_FIGURE("shader_query.half", worst, fastest / 2048.0 + 1e-5);
    EXPECT_GT(worst, 2e-5) << "these are not half";
}

// Largest difference of a component among the eight cells around a place.
double contrast(const WindView& view, glm::dvec3 place) {
    const Box& box = view.box();
    const glm::dvec3 below = glm::floor((place - view.origin()) / static_cast<double>(box.cell_size) - 0.5);
    glm::vec3 least(std::numeric_limits<float>::max()), most(-least);
    for (int corner = 0; corner < 8; ++corner) {
        glm::ivec3 cell = glm::ivec3(below) + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
        for (int axis = 0; axis < 3; ++axis) {
            const int cells = box.cells[axis];
            cell[axis] =
                box.boundaries.periodic(axis) ? ((cell[axis] % cells) + cells) % cells : std::clamp(cell[axis], 0, cells - 1);
        }
        const glm::vec3 u(view.field()[box.index(cell.x, cell.y, cell.z)]);
        least = glm::min(least, u);
        most = glm::max(most, u);
    }
    return difference(glm::vec4(most, 0.0f), least);
}

// Texture units weigh with subTexelPrecisionBits: an axis is off by half a unit in the last of them times the difference along it.
// The worst boxes: random cells, walls, periodic axes of odd size, one cell; places at and beyond the faces.
TEST_F(WindInShaders, HardwareFilteringIsOffByItsBitsAtMost) {
    const BoundaryKind periodic = BoundaryKind::periodic;
    Boundaries lane = Boundaries::open_over_floor();
    lane.x_low.kind = lane.x_high.kind = periodic;
    const std::array<Config, 4> configs = {{
        {.cells = {9, 7, 11}, .cell_size = 0.5f, .boundaries = Boundaries::all(periodic)},
        {.cells = {16, 9, 5}, .boundaries = lane, .ambient = {1.0f, 0.0f, 2.0f}},
        {.cells = {8, 6, 7}, .cell_size = 0.3f, .ambient = {1.0f, -3.0f, 2.0f}, .blend_width = 0.0f},
        {.cells = {1, 5, 1}, .boundaries = lane, .ambient = {1.0f, 0.0f, 2.0f}},
    }};
    const double unit = std::ldexp(1.0, -static_cast<int>(device->limits().subTexelPrecisionBits));
    for (const Config& config : configs) {
        Wind wind = *Wind::create(
            own->host(), config,
            {.texel = Texel::single, .textures = TextureSet::both, .frames_in_flight = 1, .queries = ReadBack::cells});
        std::mt19937 random(11);
        std::uniform_real_distribution<float> speed(-10.0f, 10.0f);
        std::vector<glm::vec4> cells(wind.box().cell_count());
        const auto record = [&] { run([&](VkCommandBuffer commands) { held(wind.record_step(commands, {.dt = 0.0})); }); };
        for (int frame = 0; frame < 2; ++frame) { // now and before differ
            for (glm::vec4& u : cells)
                u = {speed(random), speed(random), speed(random), 0.0f};
            ASSERT_TRUE(wind.set_velocity(cells));
            record();
        }
        const glm::vec3 reach = 0.5f * config.cell_size * glm::vec3(config.cells);
        std::vector<glm::vec4> places = places_around({}, reach + 1.5f * config.cell_size, 4000);
        for (int n = 0; n < 1000; ++n) // on a face, or at a cell's centre beside it
            places[static_cast<std::size_t>(n)][n % 3] =
                (n & 8 ? 1.0f : -1.0f) * (reach[n % 3] - (n & 16 ? 0.5f * config.cell_size : 0.0f));
        const auto winds_of = [&](std::span<const std::uint32_t> code, TextureSet textures) {
            return winds_at(code, wind, textures, places);
        };
        const std::vector<glm::vec4> exact = winds_of(shader_words::sample_wind_exact, TextureSet::vectors),
                                     one = winds_of(shader_words::sample_wind, TextureSet::vectors),
                                     three = winds_of(shader_words::sample_wind_three, TextureSet::axes);
        record(); // reads the one before
        const WindView view = *wind.queried();
        double worst = 0.0, worst_bits = 0.0, excess = -1.0;
        for (std::size_t n = 0; n < places.size(); ++n) {
            const glm::dvec3 place(places[n]);
            worst = std::max(worst, difference(exact[k_winds * n], view.velocity(place)));
            const double most = contrast(view, place);
            for (const std::vector<glm::vec4>* filtered : {&one, &three}) {
                const double off = difference((*filtered)[k_winds * n], glm::vec3(exact[k_winds * n]));
                worst_bits = std::max(worst_bits, most > 0.0 ? off / most : 0.0);
                excess = std::max(excess, off - 1.5 * unit * most);
                EXPECT_LT(difference((*filtered)[k_winds * n + 1], glm::vec3(exact[k_winds * n + 1])), 1.5 * unit * 20.0 + 2e-5);
            }
        }
        WINDROW_EXPECT_FIGURE("shader_query.faces", worst, 2e-5);
        WINDROW_EXPECT_FIGURE("shader_query.filtered_over_contrast", worst_bits, 1.5 * unit + 1e-5);
        EXPECT_LT(excess, 2e-5);
    }
}

// What Settings::textures leaves out is neither created nor held in memory.
TEST_F(WindInShaders, OnlyTheTexturesAskedForExist) {
    const Config config{.cells = {16, 16, 16}};
    const auto made = [&](TextureSet textures) { return *Wind::create(sharing_host(), config, {.textures = textures}); };
    const Wind vectors = made(TextureSet::vectors), axes = made(TextureSet::axes), both = made(TextureSet::both);
    const auto has = [](const Wind& wind) {
        const Textures textures = wind.textures();
        return std::pair(textures.vectors.view != VK_NULL_HANDLE, textures.axes[2].image != VK_NULL_HANDLE);
    };
    EXPECT_EQ(has(vectors), std::pair(true, false));
    EXPECT_EQ(has(axes), std::pair(false, true));
    EXPECT_EQ(has(both), std::pair(true, true));
    EXPECT_GE(both.memory_bytes(), axes.memory_bytes() + 2 * 8 * 4096);
    EXPECT_GE(both.memory_bytes(), vectors.memory_bytes() + 2 * 6 * 4096);
}

} // namespace
} // namespace windrow::vulkan
