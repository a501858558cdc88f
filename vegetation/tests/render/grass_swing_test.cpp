// Blades with springs: the same motion at any frame rate, as the library's own spring has it in the wind that the blades felt, and
// one motion of a blade in the picture and in its shadow.
#include "coupling/motion_numerics.h"
#include "coupling/plant_numerics.h"
#include "coupling/spring.h"
#include "tests/figure.h"
#include "tests/tier.h"
#include "vegetation/tests/render/grass_stage.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_swing_corner{2e5, 0.0, -7e4}; // [m]
constexpr double k_settled = 1.0;                    // [s] a spring of 3.5 Hz and a damping of 0.5 forgets by e^-11

using Series = std::vector<std::vector<glm::dvec2>>; // [frame][blade], bend [rad]

Scene gusty_scene(float detail) {
    Scene scene;
    scene.ground = {.corner = k_swing_corner, .heights = *HeightMap::create({13, 13}, 2.0f, std::vector<float>(169, 0.0f))};
    scene.wind.wind.cells = {8, 4, 8};
    scene.wind.wind.centre = k_swing_corner + glm::dvec3(12.0, 2.0, 12.0);
    scene.wind.wind.ambient = {3.4f, 0.0f, 4.2f}; // of examples/scenes/meadow.json
    scene.wind.wind.profile = {.roughness_length = 0.05f};
    scene.wind.wind.gusts = {.intensity = 0.4f, .length = 14.0f};
    scene.wind.sampling = {.detail = detail, .detail_length = 0.5f};
    return scene;
}

Camera camera_at_the_side() {
    Camera camera;
    camera.position = k_swing_corner + glm::dvec3(12.0, 3.0, 23.0);
    camera.target = k_swing_corner + glm::dvec3(12.0, 0.0, 12.0);
    return camera;
}

struct Swinging {
    explicit Swinging(int shadows = 0, float detail = 0.6f)
        : stage(gusty_scene(detail), {.width = 64, .height = 36, .samples = 1, .shadow_texels = 64, .anchor = k_swing_corner}) {
        const auto mask = *grass::PlacementMask::create({33, 33}, stage.scene.ground.heights.extent(), 1.0f);
        const grass::GrassSettings field{.density = 2.0f, .split_distance = 12.0f, .cut_distance = 30.0f, .max_chunks = 16};
        swings = &stage.grow(mask, {.field = field, .shadows = shadows});
        stiff = &stage.grow(mask, {.field = field, .shadows = shadows, .springs = false});
    }
    void step(double frame_time) {
        swings->set_time_step(frame_time);
        stage.draw(camera_at_the_side(), frame_time);
    }
    std::vector<glm::dvec2> bends(GrassLayer& layer) {
        std::vector<glm::dvec2> found;
        for (const FieldBlade& blade : stage.values_of<FieldBlade>(layer.visible_blades(), stage.drawn(layer)))
            found.emplace_back(blade.bend.x, blade.bend.y);
        return found;
    }

    // The band of springs of each blade.
    std::vector<std::size_t> bands() {
        const auto block =
            std::bit_cast<windrow::numerics::WindrowBlade>(windrow::Blades::create(grass::GrassSettings{}.blade)->block());
        std::vector<std::size_t> found;
        for (const FieldBlade& blade : stage.values_of<FieldBlade>(swings->visible_blades(), stage.drawn(*swings)))
            found.push_back(static_cast<std::size_t>(windrow::numerics::windrow_spring_band(
                windrow::numerics::windrow_blade_quickness(block, {blade.traits.x, blade.traits.y}))));
        return found;
    }

    test::GrassStage stage;
    GrassLayer *swings = nullptr, *stiff = nullptr;
};

// Reference: the library's springs, one per blade, in the wind that the blades felt.
struct Reference {
    void step(const windrow::SpringClass& spring, const std::vector<glm::dvec2>& targets, double duration) {
        if (place.empty()) {
            place = before = targets;
            velocity.assign(targets.size(), glm::dvec2(0.0));
        }
        const auto numbers = [](auto& vectors) { return std::span(&vectors.data()->x, 2 * vectors.size()); };
        EXPECT_TRUE(windrow::advance_springs<double>(*windrow::spring_step(spring, duration),
                                                     {numbers(place), numbers(velocity), numbers(before), numbers(targets)}));
        before = targets;
    }
    std::vector<glm::dvec2> place, velocity, before;
};

// RMS difference of two motions.
double apart(const Series& a, const Series& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (std::size_t blade = 0; blade < a[n].size(); ++blade)
            sum += glm::dot(a[n][blade] - b[n][blade], a[n][blade] - b[n][blade]);
    return std::sqrt(sum / static_cast<double>(a.size() * a.front().size()));
}

// What moves: root mean square about each blade's own mean.
double moving_rms(const Series& series) {
    double sum = 0.0;
    for (std::size_t blade = 0; blade < series.front().size(); ++blade) {
        glm::dvec2 mean(0.0);
        for (const auto& frame : series)
            mean += frame[blade] / static_cast<double>(series.size());
        for (const auto& frame : series)
            sum += glm::dot(frame[blade] - mean, frame[blade] - mean);
    }
    return std::sqrt(sum / static_cast<double>(series.size() * series.front().size()));
}

// Power at a frequency, summed over the blades, of a window that fades at both ends (Hann).
double power_at(const Series& series, double frequency, double frame_time) {
    double power = 0.0;
    for (std::size_t blade = 0; blade < series.front().size(); ++blade) {
        glm::dvec2 real(0.0), imaginary(0.0);
        for (std::size_t n = 0; n < series.size(); ++n) {
            const double angle = 2.0 * std::numbers::pi * frequency * frame_time * static_cast<double>(n);
            const double window =
                0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(series.size()));
            real += window * std::cos(angle) * series[n][blade];
            imaginary += window * std::sin(angle) * series[n][blade];
        }
        power += glm::dot(real, real) + glm::dot(imaginary, imaginary);
    }
    return power;
}

// The parts of a frame are at most 1/60 s long, over which targets are linear: a wave of the spring's 3.5 Hz is off by
// (omega h)^2 / 12 = 1.1 %. Between frames at 24 Hz the wind's textures are linear as well, whose waves of 2 Hz are off by 2.3 %.
// Together and at a resonance of 1 / (2 zeta) = 2.5 times, less than a tenth of what moves.
TEST(GrassSwing, IsTheSameAtAnyFrameRate) {
    constexpr int k_compared = 6; // a second
    const std::vector<int> rates = windrow::test::whole_sweeps() ? std::vector{144, 60, 30, 24} : std::vector{60, 24};
    Series finest;
    for (const int rate : rates) {
        Swinging meadow;
        Series series;
        for (int frame = 1; frame <= 2 * rate; ++frame) {
            meadow.step(1.0 / rate);
            if (frame % (rate / k_compared) == 0 && frame > k_settled * rate)
                series.push_back(meadow.bends(*meadow.swings));
        }
        ASSERT_GT(series.front().size(), 300u);
        if (rate == rates.front())
            finest = series;
        double apart = 0.0;
        for (std::size_t n = 0; n < series.size(); ++n) {
            ASSERT_EQ(series[n].size(), finest[n].size());
            for (std::size_t blade = 0; blade < series[n].size(); ++blade)
                apart += glm::dot(series[n][blade] - finest[n][blade], series[n][blade] - finest[n][blade]);
        }
        apart = std::sqrt(apart / static_cast<double>(series.size() * series.front().size())) / moving_rms(finest);
        WINDROW_EXPECT_FIGURE(
            "render/grass/swing_at_" + std::to_string(rate) + "_hz_from_" + std::to_string(rates.front()) + "_hz", apart, 0.1);
    }
}

// The bounds are those that grass has to keep: less motion would be stiff grass, none frozen grass.
TEST(GrassSwing, IsTheSpringOfTheLibraryInTheWindOfTheBlades) {
    constexpr double k_frame = 1.0 / 60.0;
    constexpr int k_frames = 300;
    Swinging meadow;
    Series made, wanted, held;
    Reference spring;
    for (int frame = 0; frame < k_frames; ++frame) {
        meadow.step(k_frame);
        const std::vector<glm::dvec2> targets = meadow.bends(*meadow.stiff);
        spring.step(windrow::springs::grass, targets, k_frame);
        if (frame * k_frame < k_settled)
            continue;
        made.push_back(meadow.bends(*meadow.swings));
        held.push_back(targets);
        wanted.push_back(spring.place);
    }
    const double rms = moving_rms(made) / moving_rms(wanted);
    windrow::test::figure("render/grass/swing_rms_of_the_spring", rms);
    EXPECT_GE(rms, 0.8);
    EXPECT_LE(rms, 1.05);
    double worst = 0.0;
    for (const double frequency : {0.5, 1.0, 1.5, 1.9}) {
        const double decibels = 10.0 * std::log10(power_at(made, frequency, k_frame) / power_at(wanted, frequency, k_frame));
        worst = std::max(worst, std::abs(decibels));
    }
    WINDROW_EXPECT_FIGURE("render/grass/swing_spectrum_below_2_hz_db", worst, 3.0);
    // Stiff grass does what passes it at 5 Hz and more; a spring of 3.5 Hz does not.
    const double fast = 10.0 * std::log10(power_at(made, 8.0, k_frame) / power_at(held, 8.0, k_frame));
    windrow::test::figure("render/grass/swing_at_8_hz_of_stiff_db", fast);
    EXPECT_LT(fast, -20.0 * std::log10((8.0 / 3.5) * (8.0 / 3.5) - 1.0));
}

// Short blades swing faster than long ones. Without detail each follows the spring of its own band, except for the rounding of its
// state to halves. The spring of the class is seven times further off than the bound.
TEST(GrassSwing, HasItsOwnTime) {
    constexpr double k_frame = 1.0 / 60.0;
    Swinging meadow(0, 0.0f);
    const windrow::SpringClass drawn = GrassLayerSettings{}.spring;
    const auto bands = *windrow::spring_bands(drawn);
    Series made, in_one_time, in_own_times;
    std::vector<std::size_t> band_of;
    std::array<Reference, 4> springs;
    Reference alike;
    for (int frame = 0; frame < 90; ++frame) {
        meadow.step(k_frame);
        const std::vector<glm::dvec2> targets = meadow.bends(*meadow.stiff);
        if (frame == 0)
            band_of = meadow.bands();
        made.push_back(meadow.bends(*meadow.swings));
        alike.step(drawn, targets, k_frame);
        in_one_time.push_back(alike.place);
        for (std::size_t band = 0; band < bands.size(); ++band)
            springs[band].step(bands[band], targets, k_frame);
        auto& own = in_own_times.emplace_back();
        for (std::size_t n = 0; n < targets.size(); ++n)
            own.push_back(springs[band_of[n]].place[n]);
    }
    for (std::size_t band = 0; band < bands.size(); ++band)
        EXPECT_GT(std::ranges::count(band_of, band), 20) << band;
    const double moving = moving_rms(in_own_times);
    WINDROW_EXPECT_FIGURE("render/grass/swing_off_springs_of_own_times", apart(made, in_own_times) / moving, 0.005);
    const double off_class = apart(made, in_one_time) / moving;
    windrow::test::figure("render/grass/swing_off_springs_of_one_time", off_class);
    EXPECT_GT(off_class, 0.02);
}

TEST(GrassSwing, IsOneInThePictureAndInItsShadow) {
    Swinging meadow(1);
    for (int frame = 0; frame < 20; ++frame)
        meadow.step(1.0 / 30.0);
    const auto all = meadow.stage.values_of<FieldBlade>(meadow.swings->visible_blades(), 2 * meadow.stage.drawn(*meadow.swings));
    std::map<std::pair<float, float>, glm::vec4> first;
    int twice = 0;
    for (const FieldBlade& blade : all) {
        const auto [found, is_new] = first.try_emplace({blade.root.x, blade.root.z}, blade.bend);
        twice += is_new ? 0 : 1;
        EXPECT_EQ(found->second, blade.bend) << blade.root.x << ' ' << blade.root.z;
    }
    EXPECT_GT(twice, 100);
}

// Many small chunks about an eye that looks along -z or +z: no chunk is in both views.
struct Cut {
    explicit Cut(int max_chunks)
        : stage(gusty_scene(0.6f), {.width = 96, .height = 54, .samples = 1, .shadow_texels = 64, .anchor = k_swing_corner}) {
        const auto mask = *grass::PlacementMask::create({33, 33}, stage.scene.ground.heights.extent(), 1.0f);
        layer = &stage.grow(
            mask,
            {.field = {.density = 3.0f, .chunk_cells = 9, .split_distance = 4.0f, .cut_distance = 9.0f, .max_chunks = max_chunks},
             .shadows = 0});
    }
    static Camera looking(float y, float z) {
        Camera camera;
        camera.position = k_swing_corner + glm::dvec3(12.0, 1.2, 12.0);
        camera.target = camera.position + glm::dvec3(0.0, y, z);
        return camera;
    }
    Picture8 view(float y, float z, double frame_time) {
        layer->set_time_step(frame_time);
        stage.draw(looking(y, z), frame_time);
        EXPECT_EQ(layer->report().left_out, 0);
        return stage.renderer->images().picture();
    }
    // Frames that see no blade, in air that stays as it is.
    void look_away(int frames) {
        Drawable* const one = layer;
        for (int n = 0; n < frames; ++n) {
            const engine::Frame frame = engine::must(stage.frames->begin());
            engine::must(stage.wind->record(frame.commands, {.dt = 0.0, .slot = frame.slot}));
            engine::must(stage.renderer->keep_up(frame, looking(3.0f, 1.0f), *stage.wind, std::span(&one, 1)));
            EXPECT_EQ(layer->report().orders, 0);
            engine::must(stage.frames->submit(frame));
        }
        engine::must(stage.frames->wait());
    }
    test::GrassStage stage;
    GrassLayer* layer = nullptr;
};

// A slot that another chunk gets at a cut: blades that go on as those that stood there bend as they did.
TEST(GrassSwing, BeginsAnewInASlotThatWasAnotherChunks) {
    Cut few(24), many(64);
    for (int frame = 0; frame < 12; ++frame) {
        (void)few.view(-0.4f, 1.0f, 1.0 / 30.0);
        (void)many.view(-0.4f, 1.0f, 1.0 / 30.0);
    }
    EXPECT_GT(few.layer->report().colour_chunks, 12); // a view takes more than half of the slots
    const Picture8 before = many.stage.renderer->images().picture();
    for (int frame = 0; frame < 2; ++frame) {
        const Picture8 reused = few.view(-0.4f, -1.0f, 1.0 / 30.0), own = many.view(-0.4f, -1.0f, 1.0 / 30.0);
        EXPECT_EQ(reused.values, own.values) << frame;
        EXPECT_NE(own.values, before.values);
    }
}

// What has not been listed yet, or 1024 frames ago, is not what the frame before listed.
TEST(GrassSwing, BeginsAnewAtAnyFrame) {
    Cut cut(64);
    for (int frame = 0; frame < 2; ++frame)
        (void)cut.view(-0.4f, 1.0f, 1.0 / 30.0);
    cut.look_away(1022);
    const Picture8 at_1025 = cut.view(-0.4f, -1.0f, 0.0);
    cut.look_away(2);
    EXPECT_EQ(cut.view(-0.4f, -1.0f, 0.0).values, at_1025.values);
}

// Where a blade was a frame ago is where the frame before drew it.
TEST(GrassSwing, RemembersTheFrameBefore) {
    Swinging meadow;
    meadow.step(1.0 / 24.0);
    const auto first = meadow.bends(*meadow.swings);
    meadow.step(1.0 / 24.0);
    const auto now = meadow.stage.values_of<FieldBlade>(meadow.swings->visible_blades(), first.size());
    double moved = 0.0;
    for (std::size_t n = 0; n < now.size(); ++n) {
        EXPECT_EQ(glm::dvec2(now[n].bend.z, now[n].bend.w), first[n]);
        moved = std::max(moved, static_cast<double>(std::abs(now[n].bend.x - now[n].bend.z)));
    }
    EXPECT_GT(moved, 1e-3);
}

} // namespace
} // namespace windrow::vegetation::render
