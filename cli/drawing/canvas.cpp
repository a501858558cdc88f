#include "cli/drawing/canvas.h"

#include "cli/output_file.h"
#include "cli/pictures.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <cairo.h>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace windrow::cli {
namespace {

constexpr std::string_view k_minus = "\xe2\x88\x92";       // U+2212
constexpr std::string_view k_replacement = "\xef\xbf\xbd"; // U+FFFD

std::string with_real_minus(std::string_view digits) {
    const bool negative = digits.starts_with('-');
    if (negative)
        digits.remove_prefix(1);
    const bool zero = digits.find_first_not_of("0.") == std::string_view::npos;
    return (negative && !zero ? std::string(k_minus) : std::string()) + std::string(digits);
}

/// Bytes of the character that begins `text`, or 0 where it is no valid UTF-8 (overlong forms and surrogates included).
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t index) { return static_cast<unsigned char>(text[index]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length)
        return 0;
    for (std::size_t index = 1; index < length; ++index)
        if ((byte(index) & 0xC0) != 0x80)
            return 0;
    const unsigned char second = byte(1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
    return overlong || beyond ? 0 : length;
}

} // namespace

std::string fixed(double value, int decimals) {
    if (!std::isfinite(value))
        return "?";
    return with_real_minus(to_fixed(value, decimals));
}

std::string brief(double value, int digits) {
    if (!std::isfinite(value))
        return "?";
    return with_real_minus(to_digits(value, digits));
}

std::string printable(std::string_view text) {
    std::string clean;
    clean.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const auto lead = static_cast<unsigned char>(text.front());
        if (length == 0)
            clean += k_replacement;
        else if (lead < 0x20 || lead == 0x7F)
            clean += ' ';
        else
            clean += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return clean;
}

std::string_view without_last(std::string_view text) {
    while (!text.empty()) {
        const bool continues = (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80;
        text.remove_suffix(1);
        if (!continues)
            break;
    }
    return text;
}

Colour to_colour(Rgb8 colour) {
    return {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0, 1.0};
}

double shared_area(const Rect& a, const Rect& b) {
    const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
    const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
    return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

void Canvas::Release::operator()(_cairo* cairo) const {
    cairo_destroy(cairo);
}
void Canvas::Release::operator()(_cairo_surface* surface) const {
    cairo_surface_destroy(surface);
}

Canvas::Canvas(int width_px, int height_px, double unit, Colour paper)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)), cairo_(cairo_create(surface_.get())),
      unit_(unit) {
    set(paper);
    cairo_paint(cairo_.get());
    cairo_scale(cairo_.get(), unit, unit);
    cairo_set_line_join(cairo_.get(), CAIRO_LINE_JOIN_ROUND);
    // Grey smoothing and unhinted widths: the same picture on every display, and words that scale with the sheet.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo_.get(), options);
    cairo_font_options_destroy(options);
}

Canvas::~Canvas() = default;

double Canvas::snapped(double coordinate) const {
    return std::round(coordinate * unit_) / unit_;
}

void Canvas::set(Colour colour) {
    cairo_set_source_rgba(cairo_.get(), colour.red, colour.green, colour.blue, colour.alpha);
}

void Canvas::trace(std::span<const glm::dvec2> points, bool closed) {
    cairo_new_path(cairo_.get());
    for (const glm::dvec2 point : points)
        cairo_line_to(cairo_.get(), point.x, point.y);
    if (closed)
        cairo_close_path(cairo_.get());
}

void Canvas::trace(const Rect& rect, double corner) {
    cairo_t* cr = cairo_.get();
    cairo_new_path(cr);
    if (corner <= 0.0) {
        cairo_rectangle(cr, rect.x, rect.y, rect.width, rect.height);
        return;
    }
    const double quarter = 0.5 * std::numbers::pi;
    cairo_arc(cr, rect.right() - corner, rect.y + corner, corner, -quarter, 0.0);
    cairo_arc(cr, rect.right() - corner, rect.bottom() - corner, corner, 0.0, quarter);
    cairo_arc(cr, rect.x + corner, rect.bottom() - corner, corner, quarter, 2.0 * quarter);
    cairo_arc(cr, rect.x + corner, rect.y + corner, corner, 2.0 * quarter, 3.0 * quarter);
    cairo_close_path(cr);
}

void Canvas::paint_line(const Line& line) {
    cairo_t* cr = cairo_.get();
    const double dashes[] = {line.dash, line.gap};
    cairo_set_dash(cr, dashes, line.dash > 0.0 ? 2 : 0, 0.0);
    // Round ends on solid lines only: they would close the gaps of a dashed one.
    cairo_set_line_cap(cr, line.dash > 0.0 ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    if (line.casing_width > 0.0) {
        set(line.casing);
        cairo_set_line_width(cr, line.width + 2.0 * line.casing_width);
        cairo_stroke_preserve(cr);
    }
    set(line.colour);
    cairo_set_line_width(cr, line.width);
    cairo_stroke(cr);
}

void Canvas::stroke(std::span<const glm::dvec2> points, const Line& line, bool closed) {
    trace(points, closed);
    paint_line(line);
}

void Canvas::fill(std::span<const glm::dvec2> points, Colour colour) {
    trace(points, true);
    set(colour);
    cairo_fill(cairo_.get());
}

void Canvas::stroke(const Rect& rect, const Line& line, double corner) {
    trace(rect, corner);
    paint_line(line);
}

void Canvas::fill(const Rect& rect, Colour colour, double corner) {
    trace(rect, corner);
    set(colour);
    cairo_fill(cairo_.get());
}

void Canvas::stroke_circle(glm::dvec2 middle, double radius, const Line& line) {
    cairo_new_path(cairo_.get());
    cairo_arc(cairo_.get(), middle.x, middle.y, radius, 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(cairo_.get());
    paint_line(line);
}

void Canvas::fill_circle(glm::dvec2 middle, double radius, Colour colour) {
    cairo_new_path(cairo_.get());
    cairo_arc(cairo_.get(), middle.x, middle.y, radius, 0.0, 2.0 * std::numbers::pi);
    set(colour);
    cairo_fill(cairo_.get());
}

void Canvas::image(const Image& image, glm::dvec2 corner) {
    cairo_surface_t* pixels = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
    if (cairo_surface_status(pixels) == CAIRO_STATUS_SUCCESS) {
        cairo_surface_flush(pixels);
        unsigned char* data = cairo_image_surface_get_data(pixels);
        const int stride = cairo_image_surface_get_stride(pixels);
        for (int row = 0; row < image.height; ++row) {
            auto* target = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(row) * stride);
            for (int column = 0; column < image.width; ++column) {
                const Rgb8 colour = image.at(column, row);
                target[column] = (std::uint32_t{colour[0]} << 16) | (std::uint32_t{colour[1]} << 8) | colour[2];
            }
        }
        cairo_surface_mark_dirty(pixels);
    }
    cairo_t* cr = cairo_.get();
    cairo_save(cr);
    cairo_identity_matrix(cr);
    const double x = std::round(corner.x * unit_), y = std::round(corner.y * unit_);
    // A surface in error hands its error on to the sheet, and finish() reports it.
    cairo_set_source_surface(cr, pixels, x, y);
    cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
    cairo_rectangle(cr, x, y, image.width, image.height);
    cairo_fill(cr);
    cairo_restore(cr);
    cairo_surface_destroy(pixels);
}

void Canvas::set_font(double size, bool bold) {
    cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), size);
}

double Canvas::width_of(std::string_view text, double size, bool bold) {
    set_font(size, bold);
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo_.get(), std::string(text).c_str(), &extents);
    return extents.x_advance;
}

std::string Canvas::fitted(std::string_view text, double size, double width, bool bold) {
    if (width_of(text, size, bold) <= width)
        return std::string(text);
    // A text far too long is first cut to what could fit at all, four bytes a letter a fifth of its size wide, so that the loop
    // stays short.
    std::string_view rest = text;
    const auto most = static_cast<std::size_t>(4.0 * std::clamp(width / (0.2 * size), 1.0, 4096.0));
    if (rest.size() > most)
        rest = without_last(rest.substr(0, most));
    std::string shorter;
    do {
        rest = without_last(rest);
        while (rest.ends_with(' '))
            rest.remove_suffix(1);
        shorter = std::string(rest) + "\xe2\x80\xa6"; // U+2026
    } while (!rest.empty() && width_of(shorter, size, bold) > width);
    return shorter;
}

void Canvas::words(std::string_view text, glm::dvec2 at, const Words& words) {
    cairo_t* cr = cairo_.get();
    const double width = width_of(text, words.size, words.bold);
    const double back = words.align == Align::left ? 0.0 : words.align == Align::centre ? 0.5 * width : width;
    set(words.colour);
    cairo_save(cr);
    cairo_translate(cr, at.x, at.y);
    if (words.upward)
        cairo_rotate(cr, -0.5 * std::numbers::pi);
    cairo_move_to(cr, -back, 0.0);
    cairo_show_text(cr, std::string(text).c_str());
    cairo_restore(cr);
}

void Canvas::clip(const Rect& rect) {
    cairo_save(cairo_.get());
    trace(rect, 0.0);
    cairo_clip(cairo_.get());
}

void Canvas::unclip() {
    cairo_restore(cairo_.get());
}

Result<Image> Canvas::finish() {
    cairo_surface_flush(surface_.get());
    cairo_status_t status = cairo_status(cairo_.get());
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(surface_.get());
    if (status != CAIRO_STATUS_SUCCESS)
        return Error{detail::message("drawing failed (", cairo_status_to_string(status), "); draw a smaller picture")};
    Image image(cairo_image_surface_get_width(surface_.get()), cairo_image_surface_get_height(surface_.get()));
    const unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int row = 0; row < image.height; ++row) {
        const auto* source = reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(row) * stride);
        for (int column = 0; column < image.width; ++column) {
            const std::uint32_t pixel = source[column];
            image.set(column, row,
                      {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
                       static_cast<std::uint8_t>(pixel)});
        }
    }
    return image;
}

Result<void> write_png(const Image& image, const PngWords& words, const std::filesystem::path& file) {
    // Plain rows: a frame is mostly even paper and few colours; the filters that libpng would try take twice the time and make
    // the file no smaller.
    const auto bytes = pictures::encode_png(image, words, pictures::PngRows::plain, file);
    if (!bytes)
        return bytes.failure();
    OutputFile output(file);
    output.write({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (const Fault fault = output.publish())
        return Error{(fault.machine ? std::string(k_disk_fault) : std::string()) + fault.sentence};
    return {};
}

} // namespace windrow::cli
