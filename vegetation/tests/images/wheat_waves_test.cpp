// Waves that a gusty wind draws on wheat (wheat.json): bands of brightness that travel with it, and the air above them.
//
// The luminance of the frames is looked up at points of the field, and averaged over squares of 4 m: single stalks swing by
// themselves. Of that and of the air's speed at the ears, what does not change is taken off at each point, and their spread there is
// set to 1. r is then the mean of products, over all points and frames, of two such fields that are apart by some way along the wind
// and some time. A pattern that boils where it stands has no r a few metres further; one that is blown along has.
#include "tests/figure.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/tests/images/drawn.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

namespace windrow::vegetation::program {
namespace {

constexpr double k_wave_rate = 10.0; // [Hz]
constexpr int k_wave_frames = 30;
constexpr glm::ivec2 k_wave_size{240, 135};
constexpr double k_apart = 0.5;               // [m] from point to point
constexpr glm::ivec2 k_points{48, 40};        // along the wind and across it
constexpr int k_square = 8;                   // points
constexpr glm::dvec2 k_middle{1200.0, 974.0}; // x, z, in view
constexpr double k_ears = 0.7;                // [m] above the ground

/// A number at each point and frame; not a number out of view.
class Record {
  public:
    Record() : values_(static_cast<std::size_t>(k_wave_frames * k_points.x * k_points.y), std::nan("")) {}
    [[nodiscard]] double& at(int frame, int along, int across) { return values_[index(frame, along, across)]; }
    [[nodiscard]] double at(int frame, int along, int across) const { return values_[index(frame, along, across)]; }

    [[nodiscard]] Record smoothed() const {
        Record result;
        for (int n = 0; n < k_wave_frames; ++n)
            for (int i = 0; i < k_points.x; ++i)
                for (int j = 0; j < k_points.y; ++j)
                    if (!std::isnan(at(n, i, j)))
                        result.at(n, i, j) = mean_around(n, i, j);
        return result;
    }
    /// Less its mean at each point, over its spread there.
    [[nodiscard]] Record standardised() const {
        Record result;
        for (int i = 0; i < k_points.x; ++i)
            for (int j = 0; j < k_points.y; ++j) {
                double sum = 0.0, squares = 0.0;
                for (int n = 0; n < k_wave_frames; ++n)
                    sum += at(n, i, j);
                const double mean = sum / k_wave_frames;
                for (int n = 0; n < k_wave_frames; ++n)
                    squares += (at(n, i, j) - mean) * (at(n, i, j) - mean);
                for (int n = 0; n < k_wave_frames; ++n)
                    result.at(n, i, j) = (at(n, i, j) - mean) / std::sqrt(squares / k_wave_frames);
            }
        return result;
    }

  private:
    static std::size_t index(int frame, int along, int across) {
        return static_cast<std::size_t>((frame * k_points.x + along) * k_points.y + across);
    }
    [[nodiscard]] double mean_around(int frame, int along, int across) const {
        double sum = 0.0;
        int count = 0;
        for (int i = std::max(along - k_square / 2, 0); i < std::min(along + k_square / 2, k_points.x); ++i)
            for (int j = std::max(across - k_square / 2, 0); j < std::min(across + k_square / 2, k_points.y); ++j)
                if (!std::isnan(at(frame, i, j))) {
                    sum += at(frame, i, j);
                    ++count;
                }
        return sum / count;
    }
    std::vector<double> values_;
};

/// Of `later`, `lag` frames behind and `way` points down the wind.
double r_between(const Record& earlier, const Record& later, int lag, int way) {
    double sum = 0.0;
    int count = 0;
    for (int n = 0; n + lag < k_wave_frames; ++n)
        for (int i = 0; i + way < k_points.x; ++i)
            for (int j = 0; j < k_points.y; ++j) {
                const double product = earlier.at(n, i, j) * later.at(n + lag, i + way, j);
                if (std::isnan(product))
                    continue;
                sum += product;
                ++count;
            }
    return sum / std::max(count, 1);
}

struct Travel {
    double r = -1.0, way = 0.0, speed = 0.0; ///< [m], [m/s]
};

/// The lag whose best way is at least `least` metres, with the largest r.
Travel travel(const Record& record, double least) {
    Travel found;
    for (int lag = 1; lag < k_wave_frames / 3; ++lag) {
        Travel best;
        for (int way = 0; way < k_points.x / 2; ++way)
            if (const double r = r_between(record, record, lag, way); r > best.r)
                best = {.r = r, .way = k_apart * way, .speed = k_apart * way * k_wave_rate / lag};
        if (best.way >= least && best.r > found.r)
            found = best;
    }
    return found;
}

/// Where the field is seen, and what is there.
class Field {
  public:
    explicit Field(const PictureScene& scene)
        : scene_(scene), camera_(camera_at(scene, 0.0)),
          wind_(glm::normalize(glm::dvec2(scene.air.air.ambient.x, scene.air.air.ambient.z))) {}

    [[nodiscard]] glm::dvec3 point(int along, int across) const {
        const glm::dvec2 from = k_apart * (glm::dvec2(along, across) - 0.5 * glm::dvec2(k_points));
        const glm::dvec2 at = k_middle + from.x * wind_ + from.y * glm::dvec2(-wind_.y, wind_.x);
        return {at.x, scene_.picture.ground.height(at.x, at.y) + k_ears, at.y};
    }
    void note(const render::Picture8& picture, int frame, Record& record) const {
        const glm::dvec3 forward = glm::normalize(camera_.target - camera_.position);
        const glm::dvec3 right = glm::normalize(glm::cross(forward, {0.0, 1.0, 0.0})), up = glm::cross(right, forward);
        const double lens = 1.0 / std::tan(0.5 * static_cast<double>(camera_.view_deg) * std::numbers::pi / 180.0);
        for (int i = 0; i < k_points.x; ++i)
            for (int j = 0; j < k_points.y; ++j) {
                const glm::dvec3 to = point(i, j) - camera_.position;
                const double depth = glm::dot(to, forward), half = 0.5 * picture.height;
                const auto column = static_cast<int>(0.5 * picture.width + half * lens * glm::dot(to, right) / depth);
                const auto row = static_cast<int>(half - half * lens * glm::dot(to, up) / depth);
                if (depth < 4.0 || column < 1 || row < 1 || column > picture.width - 2 || row > picture.height - 2)
                    continue;
                double sum = 0.0;
                for (int y = row - 1; y <= row + 1; ++y)
                    for (int x = column - 1; x <= column + 1; ++x) {
                        const auto [red, green, blue] = picture.at(x, y);
                        sum += 0.299 * red + 0.587 * green + 0.114 * blue;
                    }
                record.at(frame, i, j) = sum / 9.0;
            }
    }
    void note(const windrow::WindReader& air, int frame, Record& record) const {
        for (int i = 0; i < k_points.x; ++i)
            for (int j = 0; j < k_points.y; ++j)
                record.at(frame, i, j) = static_cast<double>(glm::length(air.velocity(point(i, j))));
    }

  private:
    const PictureScene& scene_;
    render::Camera camera_;
    glm::dvec2 wind_;
};

void well(const windrow::Result<void>& result) {
    if (!result)
        throw std::runtime_error(result.error());
}

TEST(LongWheatWaves, TravelWithTheWind) {
    auto scene = read_picture_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes/wheat.json");
    ASSERT_TRUE(scene) << scene.error();
    auto renderer = SceneRenderer::create(
        *scene, {.size = k_wave_size, .frames_per_second = k_wave_rate, .samples = 1, .backend = Backend::cpu});
    ASSERT_TRUE(renderer) << renderer.error();
    well((*renderer)->warm_up());
    const Field field(*scene);
    Record brightness, speed;
    for (int n = 0; n < k_wave_frames; ++n) {
        well((*renderer)->draw());
        field.note((*renderer)->images().picture(), n, brightness);
        field.note((*renderer)->air().reader(), n, speed);
    }
    const Record seen = brightness.smoothed().standardised(), blown = speed.smoothed().standardised();

    const std::string name = "images/wheat_waves/";
    const Travel band = travel(seen, 5.0);
    const auto wind = static_cast<double>(glm::length(scene->air.air.ambient));
    EXPECT_GE(windrow::test::figure(name + "r_over_5_m", band.r, 0.5), 0.5);
    EXPECT_GE(windrow::test::figure(name + "speed_over_the_wind", band.speed / wind, 0.5), 0.5);
    EXPECT_LE(band.speed / wind, 1.1);
    (void)windrow::test::figure(name + "r_of_the_air_over_5_m", travel(blown, 5.0).r);

    double with_the_air = 0.0;
    for (int lag = 0; lag <= 4; ++lag) // a stalk answers within a swing
        with_the_air = std::max(with_the_air, std::abs(r_between(blown, seen, lag, 0)));
    EXPECT_GE(windrow::test::figure(name + "r_with_the_air", with_the_air, 0.5), 0.5);
}

} // namespace
} // namespace windrow::vegetation::program
