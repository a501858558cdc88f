#include "pictures/sheet.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace windrow::pictures {
namespace {

constexpr int k_margin = 6;
constexpr std::uint8_t k_paper = 250;

double light_of(std::uint8_t value) {
    const double share = value / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

std::uint8_t value_of(double light) {
    const double share = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::clamp(255.0 * share + 0.5, 0.0, 255.0));
}

} // namespace

Picture8 cropped(const Picture8& picture, int left, int top, int width, int height) {
    left = std::clamp(left, 0, picture.width - 1);
    top = std::clamp(top, 0, picture.height - 1);
    Picture8 part(std::clamp(width, 1, picture.width - left), std::clamp(height, 1, picture.height - top));
    for (int row = 0; row < part.height; ++row)
        std::copy_n(picture.values.begin() + static_cast<std::ptrdiff_t>(picture.offset(left, top + row)), 3 * part.width,
                    part.values.begin() + static_cast<std::ptrdiff_t>(part.offset(0, row)));
    return part;
}

void paste(const Picture8& picture, Picture8& onto, int left, int top) {
    for (int row = 0; row < picture.height; ++row)
        std::copy_n(picture.values.begin() + static_cast<std::ptrdiff_t>(picture.offset(0, row)), 3 * picture.width,
                    onto.values.begin() + static_cast<std::ptrdiff_t>(onto.offset(left, top + row)));
}

Picture8 shrunk(const Picture8& picture, int width) {
    std::array<double, 256> light{};
    for (std::size_t value = 0; value < light.size(); ++value)
        light[value] = light_of(static_cast<std::uint8_t>(value));
    width = std::clamp(width, 1, picture.width);
    const int height = std::max(1, static_cast<int>(std::lround(static_cast<double>(picture.height) * width / picture.width)));
    Picture8 made(width, height);
    const auto first = [](int n, int of, int all) { return static_cast<int>(static_cast<std::int64_t>(n) * all / of); };
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const int top = first(row, height, picture.height), left = first(column, width, picture.width);
            const int bottom = std::max(top + 1, first(row + 1, height, picture.height)),
                      right = std::max(left + 1, first(column + 1, width, picture.width));
            for (int channel = 0; channel < 3; ++channel) {
                double sum = 0.0;
                for (int y = top; y < bottom; ++y)
                    for (int x = left; x < right; ++x)
                        sum += light[picture.values[3 * (static_cast<std::size_t>(y) * picture.width + x) + channel]];
                made.values[3 * (static_cast<std::size_t>(row) * width + column) + channel] =
                    value_of(sum / ((bottom - top) * (right - left)));
            }
        }
    return made;
}

Result<Picture8> contact_sheet(std::span<const Picture8> pictures, int columns, int width) {
    if (pictures.empty() || columns < 1 || width < 1)
        return Error{detail::message("a contact sheet of ", pictures.size(), " pictures in ", columns, " columns of ", width,
                                     " px cannot be made; give it at least one of each.")};
    for (const Picture8& picture : pictures)
        if (picture.width != pictures.front().width || picture.height != pictures.front().height || picture.values.empty())
            return Error{"a contact sheet needs pictures of one size."};
    columns = std::min(columns, static_cast<int>(pictures.size()));
    width = std::min(width, pictures.front().width);
    const int height = shrunk(pictures.front(), width).height;
    const SheetGrid grid{columns, width, height, k_margin, k_margin, k_margin};
    Picture8 sheet(grid.right() + k_margin, grid.bottom(pictures.size()) + k_margin);
    std::fill(sheet.values.begin(), sheet.values.end(), k_paper);
    for (std::size_t n = 0; n < pictures.size(); ++n)
        paste(shrunk(pictures[n], width), sheet, grid.x(n), grid.y(n));
    return sheet;
}

} // namespace windrow::pictures
