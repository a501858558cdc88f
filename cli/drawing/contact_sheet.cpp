#include "cli/drawing/canvas.h"
#include "cli/pictures.h"
#include "fluid/core/message.h"
#include "pictures/sheet.h"

#include <algorithm>
#include <cmath>

namespace windrow::cli {
namespace {

constexpr std::size_t k_max_frames = 64;
constexpr int k_tile = 800; // [px] longest of a tile: letters of a frame of 1600 px can just be read
constexpr int k_gap = 28;
constexpr int k_margin = 48;
constexpr int k_narrowest = 640; // room for the title
constexpr int k_title = 64;      // above the tiles
constexpr int k_caption = 44;    // above each tile

int columns_of(std::size_t frames) {
    if (frames <= 3)
        return static_cast<int>(frames);
    return frames == 4 ? 2 : frames <= 9 ? 3 : 4;
}

Image part_of(const Image& image, const PixelRect& part) {
    return pictures::cropped(image, part.x, part.y, part.width, part.height);
}

/// Both slices of a frame, the upright one below or beside the level one, whichever comes nearer to a square.
Image slices_of(const Image& frame, const FrameParts& parts) {
    const Image level = part_of(frame, parts.level), upright = part_of(frame, parts.upright);
    const int wide = level.width + upright.width, widest = std::max(level.width, upright.width);
    const int tall = level.height + upright.height, tallest = std::max(level.height, upright.height);
    const bool stacked =
        std::abs(std::log(static_cast<double>(widest) / tall)) < std::abs(std::log(static_cast<double>(wide) / tallest));
    Image both(stacked ? widest : wide, stacked ? tall : tallest);
    // The frame's own paper: its first pixel.
    for (std::size_t index = 0; index < both.values.size(); ++index)
        both.values[index] = frame.values[index % 3];
    pictures::paste(level, both, 0, 0);
    pictures::paste(upright, both, stacked ? 0 : level.width, stacked ? level.height : 0);
    return both;
}

} // namespace

Result<void> draw_contact_sheet(std::span<const std::filesystem::path> frames, const std::filesystem::path& file,
                                const std::optional<FrameParts>& parts) {
    using detail::message;
    if (frames.empty())
        return Error{message("contact sheet ", file.string(), " has no frames; give at least one")};
    if (frames.size() > k_max_frames)
        return Error{message("contact sheet ", file.string(), " has ", frames.size(), " frames, more than ", k_max_frames,
                             "; choose every nth of them")};

    // Read and shrunk one by one: the frames of a sheet at full size could fill the memory.
    std::vector<Image> tiles;
    std::vector<std::string> captions;
    std::string title;
    Image legend;
    int tile_width = 1, tile_height = 1;
    for (const std::filesystem::path& frame : frames) {
        PngWords words;
        const auto full = read_png(frame, &words);
        if (!full)
            return full.failure();
        const Image& whole = *full;
        const Image slices = parts ? slices_of(whole, *parts) : Image();
        const Image& shown = parts ? slices : whole;
        if (parts && tiles.size() + 1 == frames.size())
            legend = part_of(whole, parts->legend);
        // A whole frame is as wide as a tile may be, however tall its box makes it.
        const double shrink =
            std::min(1.0, static_cast<double>(k_tile) / (parts ? std::max(shown.width, shown.height) : shown.width));
        const int width = std::max(1, static_cast<int>(std::lround(shown.width * shrink)));
        const int height = std::max(1, static_cast<int>(std::lround(shown.height * shrink)));
        auto tile = shrink < 1.0 ? pictures::resized(shown, width, height) : Result<Image>(shown);
        if (!tile)
            return tile.failure();
        tile_width = std::max(tile_width, width);
        tile_height = std::max(tile_height, height);
        tiles.push_back(*std::move(tile));
        captions.push_back(printable(words.description.empty() ? frame.stem().string() : words.description));
        if (title.empty())
            title = printable(words.title);
    }

    const int columns = columns_of(tiles.size());
    const pictures::SheetGrid grid{columns, tile_width, k_caption + tile_height, k_gap, k_margin, k_margin + k_title};
    const int width = 2 * k_margin + std::max(grid.right() - k_margin, std::max(legend.width, k_narrowest));
    const int tiles_end = grid.bottom(tiles.size());
    const int height = tiles_end + (parts ? k_gap + k_caption + legend.height : 0) + k_margin;
    Canvas canvas(width, height, 1.0, k_paper);
    const std::string count = std::to_string(tiles.size()) + (tiles.size() == 1 ? " frame" : " frames");
    canvas.words(canvas.fitted(title.empty() ? file.stem().string() : title, 34.0, width - 2.0 * k_margin - 240.0, true),
                 {k_margin, k_margin + 28.0}, {.size = 34.0, .colour = k_ink, .bold = true});
    canvas.words(count, {width - k_margin, k_margin + 28.0}, {.size = 24.0, .colour = k_dim_ink, .align = Align::right});
    for (std::size_t index = 0; index < tiles.size(); ++index) {
        const double x = grid.x(index), y = grid.y(index);
        canvas.words(canvas.fitted(captions[index], 26.0, tile_width, true), {x, y + 30.0},
                     {.size = 26.0, .colour = k_ink, .bold = true});
        canvas.image(tiles[index], {x, y + k_caption});
        canvas.stroke(Rect{x - 0.5, y + k_caption - 0.5, tiles[index].width + 1.0, tiles[index].height + 1.0},
                      {.colour = k_hairline, .width = 1.0});
    }
    if (parts) {
        canvas.words("All frames; what is counted, at " + captions.back(), {k_margin, tiles_end + k_gap + 24.0},
                     {.size = 20.0, .colour = k_dim_ink});
        canvas.image(legend, {k_margin, static_cast<double>(tiles_end + k_gap + k_caption)});
    }
    const auto sheet = canvas.finish();
    if (!sheet)
        return sheet.failure().after(message("contact sheet ", file.string(), ": "));
    return write_png(*sheet, {title, count}, file);
}

} // namespace windrow::cli
