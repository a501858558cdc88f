// How many layers a coat has at a distance, what it rejects to draw, and what its pictures become.
#include "tests/figure.h"
#include "vegetation/files/coat_picture_files.h"
#include "vegetation/fur/coat_settings.h"
#include "vegetation/tests/fur/stage.h"

#include <cmath>
#include <glm/packing.hpp>
#include <limits>

namespace windrow::vegetation::fur::test {
namespace {

// Heights of all layers as a function of the distance: none jumps, and a new one begins at the tip.
TEST(CoatLevels, NoLayerPopsAsTheirNumberGrows) {
    CoatSettings settings;
    settings.layers.shells = 40;
    settings.layers.spacing = 1.5f;
    settings.levels = {.min_shells = 6, .full_until = 2.0f};
    const auto height = [&](const LayerCount& count, int layer) {
        return layer < count.layers ? std::pow(std::min(static_cast<float>(layer) / count.divisor, 1.0f), settings.layers.spacing)
                                    : 1.0f;
    };
    double jump = 0.0;
    int most = 0, least = 1000;
    LayerCount last = layers_at(settings, 0.5f, 1.0f);
    for (int n = 1; n < 4000; ++n) {
        const LayerCount count = layers_at(settings, 0.5f + 0.01f * static_cast<float>(n), 1.0f);
        for (int layer = 0; layer < 40; ++layer)
            jump = std::max(jump, static_cast<double>(std::abs(height(count, layer) - height(last, layer))));
        most = std::max(most, count.layers);
        least = std::min(least, count.layers);
        last = count;
    }
    EXPECT_EQ(most, 40);
    EXPECT_EQ(least, 6);
    // 1 cm at 2 m is half a per cent of the layers' number: times the exponent, less than 1 % of the length.
    WINDROW_EXPECT_FIGURE("shells/levels/jump", jump, 0.01);
}

TEST(CoatLevels, LayersAboveEveryStrandAreNotDrawn) {
    CoatSettings settings;
    settings.layers.shells = 33;
    EXPECT_EQ(layers_at(settings, 0.0f, 1.0f).drawn, 33);
    const LayerCount half = layers_at(settings, 0.0f, 0.5f);
    EXPECT_EQ(half.drawn, 17); // heights i / 32 up to the half
    EXPECT_EQ(half.layers, 33);
    settings.levels.skip_empty = false;
    EXPECT_EQ(layers_at(settings, 0.0f, 0.5f).drawn, 33);
    settings.bare = true;
    EXPECT_EQ(layers_at(settings, 0.0f, 1.0f).drawn, 1);
}

TEST(CoatPictures, LevelsAreMeansOfFour) {
    CoatPictures pictures;
    pictures.length = {4, 2, {}};
    for (int n = 0; n < 8; ++n)
        pictures.length.texels.emplace_back(static_cast<float>(n));
    const PackedPictures made = packed(pictures);
    EXPECT_EQ(made.places[0], glm::ivec4(0, 4, 2, 3)); // 4 x 2, 2 x 1, 1 x 1
    EXPECT_EQ(made.places[1].w, 0);
    ASSERT_EQ(made.texels.size(), 11u);
    EXPECT_EQ(glm::unpackHalf2x16(made.texels[8].x).x, 0.25f * (0 + 1 + 4 + 5));
    EXPECT_EQ(glm::unpackHalf2x16(made.texels[10].x).x, 3.5f);
}

TEST(CoatPictures, BadOnesAreRejectedInASentence) {
    CoatPictures pictures;
    pictures.colour = {2, 2, std::vector<glm::vec4>(3)};
    auto judged = validate(pictures);
    ASSERT_FALSE(judged);
    EXPECT_NE(judged.error().find("pictures.colour has 3 texels; give columns times rows, 4"), std::string::npos)
        << judged.error();
    pictures.colour.texels.assign(4, glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    judged = validate(pictures);
    ASSERT_FALSE(judged);
    EXPECT_NE(judged.error().find("not finite"), std::string::npos);
    pictures.colour = {100000, 100000, {}};
    EXPECT_FALSE(validate(pictures));
    const auto missing = read_pictures({.length = "nowhere.png"}, "/tmp");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().find("nowhere.png"), std::string::npos);
}

TEST(Coat, RejectsWhatItCannotDraw) {
    Stage stage({.width = 16, .height = 16});
    const auto rejected = [&](const CoatSettings& settings, const Mesh& mesh, std::span<const MeshPart> parts,
                              const windrow::Pose& body, const char* word) {
        const auto made = Coat::create(*stage.device, stage.renderer->draw_targets(), mesh, parts, settings, {}, body, k_anchor);
        EXPECT_FALSE(made);
        EXPECT_NE((made ? std::string() : made.error()).find(word), std::string::npos) << word;
    };
    const Mesh mesh = square();
    CoatSettings bad;
    bad.layers.shells = 1;
    rejected(bad, mesh, {}, at({}), "shells");
    bad = {};
    bad.look.tip.r = std::numeric_limits<float>::quiet_NaN();
    rejected(bad, mesh, {}, at({}), "tip");
    bad = {};
    bad.spots.resize(k_max_spots + 1);
    rejected(bad, mesh, {}, at({}), "spots");
    Mesh broken = mesh;
    broken.indices[0] = 77;
    rejected({}, broken, {}, at({}), "77");
    const MeshPart part{.material = {}, .first = 3, .count = 6};
    rejected({}, mesh, std::span(&part, 1), at({}), "coat.parts");
    rejected({}, mesh, {}, at({}, -1.0), "scale");

    Coat& coat = stage.dress(mesh, {}, at({}));
    EXPECT_FALSE(coat.move(-1.0, at({})));
    EXPECT_FALSE(coat.move(std::numeric_limits<double>::quiet_NaN(), at({})));
    EXPECT_FALSE(coat.move(k_frame, at({}, 0.0)));
    const std::vector<glm::mat4> bones(1, glm::mat4(std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(coat.move(k_frame, at({}), bones));
    const std::vector<Lamp> many(k_max_lamps + 1);
    EXPECT_FALSE(coat.set_lamps(many));
    EXPECT_TRUE(coat.move(k_frame, at({})));
    // What lies behind the eye is not drawn.
    stage.draw(camera_at({0.0, 1.0, 5.0}, {0.0, 1.0, 10.0}));
    EXPECT_EQ(coat.counts().vertices, 0u);
    stage.draw(camera_at({0.0, 1.0, 5.0}));
    EXPECT_EQ(coat.counts().vertices, 6u * static_cast<unsigned>(coat.counts().layers));
}

} // namespace
} // namespace windrow::vegetation::fur::test
