#include "cli/pictures.h"

#include "cli/drawing/frame.h"
#include "cli/drawing/image.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/text.h"
#include "fluid/message.h"

#include <cmath>

namespace windrow::cli {

namespace {

// The batch query is what a plant reads; the picture shows nothing else.
Air air_of(const CommandWind& wind) {
    const Config& config = wind.config();
    return {.box = wind.box(),
            .origin = wind.origin(),
            .ambient = wind.ambient(),
            .profile_height = config.profile ? config.profile->reference_height : 0.0f,
            .gust_intensity = config.gusts.intensity,
            .velocity = [&wind](std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) {
                wind.velocity(positions, velocities);
            }};
}

PixelRect to_pixels(const Rect& rect, double unit) {
    const auto px = [&](double coordinate) { return static_cast<int>(std::lround(coordinate * unit)); };
    return {px(rect.x), px(rect.y), px(rect.right()) - px(rect.x), px(rect.bottom()) - px(rect.y)};
}

} // namespace

FrameParts frame_parts(const CommandWind& wind, const PictureSettings& settings) {
    const Layout layout = lay_out(air_of(wind), settings.slice_point, settings.width);
    return {to_pixels(layout.level.whole(), layout.unit), to_pixels(layout.upright.whole(), layout.unit),
            to_pixels(layout.legend.grown(14.0), layout.unit)};
}

Result<void> draw_frame(const CommandWind& wind, double time, std::span<const Trail> trails, std::span<const NamedMotor> motors,
                        const PictureSettings& settings, const std::filesystem::path& file) {
    const auto image = compose_frame(air_of(wind), time, trails, motors, settings);
    if (!image)
        return Error{detail::message("picture ", file.string(), ": ", image.error())};
    return write_png(*image, {printable(settings.title), time_text(time)}, file);
}

} // namespace windrow::cli
