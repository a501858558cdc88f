// The coats that fur_bench.cpp measures, before a plain sky in a wind, and frames of them, timed and counted.
#pragma once

#include "fluid/vulkan/wind.h"
#include "vegetation/bench/fur_counter.h"
#include "vegetation/fur/skeleton.h"
#include "vegetation/render/renderer.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>

namespace windrow::vegetation::bench {

/// A mesh in its coat.
struct Worn {
    fur::Mesh mesh{};
    fur::CoatSettings settings{};
    glm::dvec3 place{0.0};                ///< [m]
    std::optional<fur::Skeleton> bones{}; ///< it walks
};

struct FurCase {
    std::string name{};
    std::vector<Worn> coats{};
    std::vector<fur::Lamp> lamps{};
    glm::dvec3 from{0.0, 0.6, 3.4}, to{0.0}; ///< [m] the eye, and what it looks at
    float view_deg = 34.0f;
    bool wind = true;                    ///< else no step is recorded and nothing blows
    glm::ivec3 cells{16};                ///< of the air, 0.5 m each
    glm::vec3 ambient{4.0f, 0.0f, 1.0f}; ///< [m/s]
    float gusts = 0.3f;                  ///< 0 to 1
    float gust_length = 6.0f;            ///< [m]
    glm::ivec2 size{256};                ///< [px]
    int samples = 1;                     ///< a pixel
};

/// A case that is ready to be drawn.
class FurStage {
  public:
    /// Ends the program with a sentence where the machine lacks something.
    explicit FurStage(FurCase wanted);

    /// Draws a frame, `timed` or to warm up. A thirtieth of a second goes by.
    void draw(bool timed);
    /// Draws a frame whose coats are counted, and one without them; the first becomes a PNG in `folder`, if one is named.
    [[nodiscard]] CoatCosts count(const std::filesystem::path& folder = {});
    /// The light of another frame, linear.
    [[nodiscard]] render::PictureF light();

    /// [ms] Timed frames one by one: of a stage (wind, prepare, shadow, colour, tone), or "frame", their sum.
    [[nodiscard]] const std::vector<double>& times(const std::string& stage) const;
    [[nodiscard]] double median(const std::string& stage) const;
    /// [ms] The least of the timed frames: what is least disturbed by the machine's other work.
    [[nodiscard]] double least(const std::string& stage) const;
    /// Of all meshes.
    [[nodiscard]] std::uint64_t vertices() const;
    [[nodiscard]] const FurCase& wanted() const { return wanted_; }
    [[nodiscard]] const CountedCoats& coats() const { return *coats_; }
    /// Name and driver of the device.
    [[nodiscard]] const std::string& device() const { return device_->name(); }

  private:
    int record(bool copies);
    void write(const std::filesystem::path& folder) const;

    FurCase wanted_;
    double time_ = 0.0; // [s]
    std::unique_ptr<engine::Device> device_{};
    std::unique_ptr<engine::Frames> frames_{};
    std::optional<windrow::vulkan::Wind> wind_{};
    std::unique_ptr<render::Renderer> renderer_{};
    std::unique_ptr<CountedCoats> coats_{};
    std::map<std::string, std::vector<double>> times_{};
};

using FurStages = std::vector<std::unique_ptr<FurStage>>;

[[nodiscard]] double median_of(std::vector<double> values);
/// Median of the ratios of two cases' timed frames, turn by turn: what slows a turn slows both.
[[nodiscard]] double ratio(const FurStage& of, const FurStage& over, const std::string& stage = "frame");
/// Draws frames of all in turn: `warm` untimed ones, then `frames`.
void draw_in_turn(std::span<const std::unique_ptr<FurStage>> stages, int warm, int frames);

} // namespace windrow::vegetation::bench
