#include "cli/drawing/frame.h"

#include "cli/drawing/layout.h"
#include "cli/drawing/overlay.h"
#include "cli/pictures.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace windrow::cli {

using namespace cases;

namespace {

// The batch query is what a plant reads; the picture shows nothing else.
SlicedAir air_of(const BackendWind& wind, std::span<const NamedObstacle> obstacles = {}) {
    const Config& config = wind.config();
    return {.box = wind.box(),
            .origin = wind.origin(),
            .ambient = wind.ambient(),
            .profile_height = config.profile ? config.profile->reference_height : 0.0f,
            .gust_intensity = config.gusts.intensity,
            .velocity = [&wind](std::span<const glm::dvec3> positions,
                                std::span<glm::vec3> velocities) { wind.velocity(positions, velocities); },
            .obstacles = {obstacles.begin(), obstacles.end()}};
}

PixelRect to_pixels(const Rect& rect, double unit) {
    const auto px = [&](double coordinate) { return static_cast<int>(std::lround(coordinate * unit)); };
    return {px(rect.x), px(rect.y), px(rect.right()) - px(rect.x), px(rect.bottom()) - px(rect.y)};
}

constexpr std::string_view k_times = " \xc3\x97 ";

void draw_header(Canvas& canvas, const FrameLayout& layout, const SlicedAir& air, double time, const std::string& title) {
    const Rect& header = layout.header;
    const std::string clock = time_text(time);
    const double clock_width = canvas.width_of(clock, 26.0, true);
    canvas.words(clock, {header.right(), 46.0}, {.size = 26.0, .colour = k_ink, .bold = true, .align = Align::right});

    const double room = header.width - clock_width - 40.0;
    const std::string shown = printable(title.empty() ? "Windrow" : title);
    canvas.words(canvas.fitted(shown, 26.0, room, true), {header.x, 46.0}, {.size = 26.0, .colour = k_ink, .bold = true});
    const glm::ivec3 cells = air.box.cells;
    std::string grid = std::to_string(cells.x);
    grid += k_times;
    grid += std::to_string(cells.y);
    grid += k_times;
    grid += std::to_string(cells.z) + " cells of " + brief(air.box.cell_size, 4) + " m";
    if (const auto& rows = air.box.rows)
        grid += ", rows of " + brief(rows->thickness(0), 2) + " to " + brief(rows->thickness(rows->count() - 1), 2) + " m";
    canvas.words(canvas.fitted(grid, 15.0, header.width), {header.x, 69.0}, {.size = 15.0, .colour = k_dim_ink});
}

/// "Level slice  y = 1.0 m, looking down", as many of the words as there is room for.
void draw_caption(Canvas& canvas, const Panel& panel, const SlicedAir& air) {
    const double cell_size = air.box.cell_size;
    const bool level = panel.plane.normal == Normal::y;
    const std::string name = level ? "Level slice" : "Upright slice";
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(cell_size))), 0, 6);
    std::string place = "  " + std::string(1, "xyz"[panel.plane.across()]) + " = " + fixed(panel.plane.position, decimals) + " m";
    const double stretch = panel.scale.y / panel.scale.x;
    if (air.ground)
        place = "  " + fixed(panel.plane.position - air.origin.y, decimals) + " m above ground";
    if (const double step = air.ground ? contour_step(air) : 0.0; step > 0.0)
        place += ", lines every " + brief(step, 2) + " m of height";
    std::string more = level ? ", looking down" : ", looking along \xe2\x88\x92z";
    if (stretch > 1.02 || stretch < 0.98)
        more = ", not to scale: " + std::string(1, "xyz"[panel.plane.along_height()]) + std::string(k_times) + brief(stretch, 2);
    const double base = panel.rect.y - 11.0;
    const double width = canvas.width_of(name, 16.0, true);
    canvas.words(name, {panel.rect.x, base}, {.size = 16.0, .colour = k_ink, .bold = true});
    const double room = panel.caption_width - width;
    if (canvas.width_of(place + more, 15.0) <= room)
        place += more;
    canvas.words(canvas.fitted(place, 15.0, room), {panel.rect.x + width, base}, {.size = 15.0, .colour = k_dim_ink});
}

/// A thin line where the other slice cuts this one, with a mark at its ends outside the panel's frame.
void draw_cut(Canvas& canvas, const Panel& panel, const SlicedAir& air, const Plane& other) {
    const Rect& r = panel.rect;
    std::vector<glm::dvec2> line;
    if (air.ground && other.normal == Normal::y) // follows the ground
        for (int n = 0; n <= 256; ++n) {
            const double x = panel.low.x + panel.extent.x * n / 256.0;
            const double above = other.position - air.origin.y;
            line.push_back(panel.to_page(glm::dvec2(x, air.ground({x, panel.plane.position}) + above)));
        }
    else
        for (const double x : {panel.low.x, panel.low.x + panel.extent.x})
            line.push_back(panel.to_page(glm::dvec2(x, other.position)));
    canvas.stroke(line, {.colour = hex(0xFFFFFF, 0.7),
                         .width = 0.9,
                         .dash = 9.0,
                         .gap = 6.0,
                         .casing = k_casing.faded(0.5),
                         .casing_width = 0.7});
    const double x = r.right() + 5.0, y = line.back().y;
    canvas.fill(std::array{glm::dvec2(x, y), glm::dvec2(x + 8.0, y - 5.0), glm::dvec2(x + 8.0, y + 5.0)}, k_ink);
}

} // namespace

std::string time_text(double time) {
    return "t = " + fixed(time, 2) + " s";
}

Result<Image> compose_frame(const SlicedAir& air, double time, std::span<const Trail> trails, std::span<const NamedMotor> motors,
                            const PictureSettings& settings) {
    if (settings.width < k_smallest_width || settings.width > k_largest_width)
        return Error{detail::message("picture width ", settings.width, " px is outside ", k_smallest_width, " to ",
                                     k_largest_width, "; choose one within, for example 1600")};
    const float scale =
        std::isfinite(settings.speed_scale) && settings.speed_scale > 0.0f ? settings.speed_scale : PictureSettings{}.speed_scale;
    const FrameLayout layout = lay_out(air, settings.slice_point, settings.width);
    Canvas canvas(layout.width_px, layout.height_px, layout.unit, k_paper);

    const SlicedAir over = settings.above_ground ? above_ground(air) : air;
    float largest = 0.0f;
    bool broken = false;
    const std::array panels{&layout.level, &layout.upright};
    for (std::size_t index = 0; index < panels.size(); ++index) {
        const Panel& panel = *panels[index];
        const SlicedAir& shown = index == 0 ? over : air;
        const SlicePicture slice = render_slice(shown, panel.plane, scale, panel.width_px, panel.height_px);
        largest = std::max(largest, slice.largest);
        broken = broken || slice.broken_pixels > 0;
        canvas.image(slice.image, {panel.rect.x, panel.rect.y});
        draw_flow(canvas, panel, shown, slice.image, scale, settings.flow);
        draw_cut(canvas, panel, over, panels[1 - index]->plane);
        draw_axes(canvas, panel, air.box.boundaries);
        draw_things(canvas, panel, shown, trails, motors); // over the frame: a mark may stand on the floor's line
        draw_caption(canvas, panel, shown);
    }
    draw_header(canvas, layout, air, time, settings.title);
    draw_legend(canvas, {air, layout, trails, motors, settings.motors_of_scene, scale, largest, broken, settings.flow});
    return canvas.finish();
}

FrameParts frame_parts(const BackendWind& wind, const PictureSettings& settings) {
    const FrameLayout layout = lay_out(air_of(wind), settings.slice_point, settings.width);
    return {to_pixels(layout.level.whole(), layout.unit), to_pixels(layout.upright.whole(), layout.unit),
            to_pixels(layout.legend.grown(14.0), layout.unit)};
}

Result<void> draw_frame(const BackendWind& wind, double time, std::span<const Trail> trails, std::span<const NamedMotor> motors,
                        std::span<const NamedObstacle> obstacles, const PictureSettings& settings,
                        const std::filesystem::path& file) {
    const auto image = compose_frame(air_of(wind, obstacles), time, trails, motors, settings);
    if (!image)
        return image.failure().after(detail::message("picture ", file.string(), ": "));
    return write_png(*image, {printable(settings.title), time_text(time)}, file);
}

} // namespace windrow::cli
