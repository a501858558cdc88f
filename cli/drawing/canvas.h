// A sheet of paper to draw on: lines, shapes and words in page units, ready as an image.
//
// A page unit is 1/1600 of the width of a picture of ordinary size, whatever its pixels; x runs right and y down. Everything
// that draws a picture speaks to this class and not to Cairo.
#pragma once

#include "fluid/result.h"
#include "pictures/picture_files.h"

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct _cairo;
struct _cairo_surface;

namespace windrow::cli {

using Image = pictures::Picture8;
using pictures::PngWords;
using pictures::read_png;
using pictures::Rgb8;

/// What stands under the name stays until the new file is whole. Where the disk is to blame the error begins with k_disk_fault.
[[nodiscard]] Result<void> write_png(const Image& image, const PngWords& words, const std::filesystem::path& file);

/// A figure with a fixed number of decimals, a real minus sign and no minus before zero, whatever the locale.
[[nodiscard]] std::string fixed(double value, int decimals);

/// A figure with at most `digits` significant digits and no trailing zeros.
[[nodiscard]] std::string brief(double value, int digits = 3);

/// The text with bytes that are no UTF-8 replaced by U+FFFD and control characters by spaces: names come from users' files, and
/// Cairo stops drawing for good at the first byte that it cannot read.
[[nodiscard]] std::string printable(std::string_view text);

/// The text without its last character (not byte); the text must be valid UTF-8.
[[nodiscard]] std::string_view without_last(std::string_view text);

/// sRGB, each 0 to 1.
struct Colour {
    double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;

    [[nodiscard]] Colour faded(double factor) const { return {red, green, blue, alpha * factor}; }
};
[[nodiscard]] Colour to_colour(Rgb8 colour);
/// 0xRRGGBB.
[[nodiscard]] constexpr Colour hex(unsigned code, double alpha = 1.0) {
    return {((code >> 16) & 255u) / 255.0, ((code >> 8) & 255u) / 255.0, (code & 255u) / 255.0, alpha};
}

struct Rect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;

    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double bottom() const { return y + height; }
    [[nodiscard]] glm::dvec2 middle() const { return {x + 0.5 * width, y + 0.5 * height}; }
    [[nodiscard]] Rect grown(double margin) const {
        return {x - margin, y - margin, width + 2.0 * margin, height + 2.0 * margin};
    }
    [[nodiscard]] bool contains(glm::dvec2 point) const {
        return point.x >= x && point.x <= right() && point.y >= y && point.y <= bottom();
    }
};
/// Area that two rectangles share.
[[nodiscard]] double shared_area(const Rect& a, const Rect& b);

struct Line {
    Colour colour;
    double width = 1.0;
    double dash = 0.0; ///< length of a dash, 0: solid
    double gap = 0.0;
    /// A wider line beneath in this colour, so that the line reads on light and dark air; 0 wide: none.
    Colour casing{};
    double casing_width = 0.0; ///< that the casing stands out on either side
};

enum class Align : std::uint8_t { left, centre, right };

struct Words {
    double size = 14.0;
    Colour colour;
    bool bold = false;
    Align align = Align::left;
    bool upward = false; ///< written from below to above, for the title of a vertical axis
};

class Canvas {
  public:
    /// A sheet of whole pixels, `unit` pixels a page unit, in one colour.
    Canvas(int width_px, int height_px, double unit, Colour paper);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    [[nodiscard]] double unit() const { return unit_; }
    /// The nearest page coordinate that lies between two pixels.
    [[nodiscard]] double snapped(double coordinate) const;

    void stroke(std::span<const glm::dvec2> points, const Line& line, bool closed = false);
    void fill(std::span<const glm::dvec2> points, Colour colour);
    void stroke(const Rect& rect, const Line& line, double corner = 0.0);
    void fill(const Rect& rect, Colour colour, double corner = 0.0);
    void stroke_circle(glm::dvec2 middle, double radius, const Line& line);
    void fill_circle(glm::dvec2 middle, double radius, Colour colour);
    /// Pixels as they are, their first one at the pixel nearest to `corner`.
    void image(const Image& image, glm::dvec2 corner);

    /// `at` is on the base line of the words. The text must be printable().
    void words(std::string_view text, glm::dvec2 at, const Words& words);
    [[nodiscard]] double width_of(std::string_view text, double size, bool bold = false);
    /// The text, its end replaced by an ellipsis where it is wider than `width`.
    [[nodiscard]] std::string fitted(std::string_view text, double size, double width, bool bold = false);

    /// Until unclip() nothing is drawn beyond the rectangle.
    void clip(const Rect& rect);
    void unclip();

    /// The sheet as an image, or why there is none (no memory).
    [[nodiscard]] Result<Image> finish();

  private:
    void trace(std::span<const glm::dvec2> points, bool closed);
    void trace(const Rect& rect, double corner);
    void paint_line(const Line& line);
    void set(Colour colour);
    void set_font(double size, bool bold);

    struct Release {
        void operator()(_cairo* cairo) const;
        void operator()(_cairo_surface* surface) const;
    };
    std::unique_ptr<_cairo_surface, Release> surface_;
    std::unique_ptr<_cairo, Release> cairo_;
    double unit_ = 1.0;
};

inline constexpr Colour k_paper = hex(0xFBFAF7);
inline constexpr Colour k_ink = hex(0x1C222B);
inline constexpr Colour k_dim_ink = hex(0x69717E);
inline constexpr Colour k_hairline = hex(0xD5D4CE);

// On the air: warm colours that the map of speeds does not hold, each with a dark casing, so that they read on calm and on fast
// air.
inline constexpr Colour k_casing = hex(0x0B0F16, 0.72);
inline constexpr Colour k_body = hex(0xFF6FC1); // a path and what moves on it; motors: motor_style.h
// Neutral, between the lightness of calm and of fast air: the map of speeds has no grey.
inline constexpr Colour k_obstacle = hex(0xA7A39C);
inline constexpr Colour k_player = hex(0xFFFFFF);
inline constexpr Colour k_plate = hex(0x10151D, 0.84); // behind names

} // namespace windrow::cli
