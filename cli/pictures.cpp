#include "cli/pictures.h"

#include "cli/drawing/frame.h"
#include "cli/drawing/png.h"
#include "cli/drawing/text.h"
#include "fluid/message.h"

namespace windrow::cli {

Result<void> draw_frame(const Wind& wind, double time, std::span<const Trail> trails, std::span<const NamedMotor> motors,
                        const PictureSettings& settings, const std::filesystem::path& file) {
    // The batch query is what a plant reads; the picture shows nothing else.
    const Air air{.box = wind.box(),
                  .origin = wind.origin(),
                  .ambient = wind.ambient(),
                  .velocity = [&wind](std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) {
                      wind.velocity(positions, velocities);
                  }};
    const auto image = compose_frame(air, time, trails, motors, settings);
    if (!image)
        return Error{detail::message("picture ", file.string(), ": ", image.error())};
    return write_png(*image, {printable(settings.title), time_text(time)}, file);
}

} // namespace windrow::cli
