#include "vegetation/program/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace windrow::vegetation::program {
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

render::Picture8 shrunk(const render::Picture8& picture, int width) {
    std::array<double, 256> light{};
    for (std::size_t value = 0; value < light.size(); ++value)
        light[value] = light_of(static_cast<std::uint8_t>(value));
    width = std::clamp(width, 1, picture.width);
    const int height = std::max(1, static_cast<int>(std::lround(static_cast<double>(picture.height) * width / picture.width)));
    render::Picture8 made(width, height);
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

windrow::Result<render::Picture8> contact_sheet(std::span<const render::Picture8> pictures, int columns, int width) {
    if (pictures.empty() || columns < 1 || width < 1)
        return windrow::Error{"a contact sheet of " + std::to_string(pictures.size()) + " pictures in " +
                              std::to_string(columns) + " columns of " + std::to_string(width) +
                              " px cannot be made; give it at least one of each."};
    for (const render::Picture8& picture : pictures)
        if (picture.width != pictures.front().width || picture.height != pictures.front().height || picture.values.empty())
            return windrow::Error{"a contact sheet wants pictures of one size."};
    columns = std::min(columns, static_cast<int>(pictures.size()));
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    width = std::min(width, pictures.front().width);
    const int height = shrunk(pictures.front(), width).height;
    render::Picture8 sheet(columns * (width + k_margin) + k_margin, rows * (height + k_margin) + k_margin);
    std::fill(sheet.values.begin(), sheet.values.end(), k_paper);
    for (std::size_t n = 0; n < pictures.size(); ++n) {
        const render::Picture8 small = shrunk(pictures[n], width);
        const int left = k_margin + static_cast<int>(n) % columns * (width + k_margin),
                  top = k_margin + static_cast<int>(n) / columns * (height + k_margin);
        for (int row = 0; row < height; ++row)
            std::copy_n(small.values.begin() + static_cast<std::ptrdiff_t>(3) * row * width, 3 * width,
                        sheet.values.begin() + 3 * (static_cast<std::ptrdiff_t>(top + row) * sheet.width + left));
    }
    return sheet;
}

} // namespace windrow::vegetation::program
