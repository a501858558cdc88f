#include "cli/drawing/canvas.h"
#include "cli/drawing/palette.h"
#include "cli/drawing/png.h"
#include "cli/drawing/text.h"
#include "cli/pictures.h"
#include "fluid/message.h"

#include <algorithm>
#include <cmath>

namespace windrow::cli {
namespace {

constexpr std::size_t k_most_frames = 64;
constexpr int k_tile_width = 800; // [px] letters of a frame of 1600 px can just be read
constexpr int k_gap = 28;
constexpr int k_margin = 48;
constexpr int k_title = 64;   // above the tiles
constexpr int k_caption = 44; // above each tile

int columns_of(std::size_t frames) {
    if (frames <= 3)
        return static_cast<int>(frames);
    return frames == 4 ? 2 : frames <= 9 ? 3 : 4;
}

} // namespace

Result<void> draw_contact_sheet(std::span<const std::filesystem::path> frames, const std::filesystem::path& file) {
    using detail::message;
    if (frames.empty())
        return Error{message("contact sheet ", file.string(), " has no frames; give at least one")};
    if (frames.size() > k_most_frames)
        return Error{message("contact sheet ", file.string(), " has ", frames.size(), " frames, more than ", k_most_frames,
                             "; choose every nth of them")};

    // Read and shrunk one by one: the frames of a sheet at full size could fill the memory.
    std::vector<Image> tiles;
    std::vector<std::string> captions;
    std::string title;
    int tile_height = 1;
    for (const std::filesystem::path& frame : frames) {
        PngWords words;
        const auto full = read_png(frame, &words);
        if (!full)
            return Error{full.error()};
        const double shrink = std::min(1.0, static_cast<double>(k_tile_width) / full->width);
        const int width = std::max(1, static_cast<int>(std::lround(full->width * shrink)));
        const int height = std::max(1, static_cast<int>(std::lround(full->height * shrink)));
        auto tile = shrink < 1.0 ? resized(*full, width, height) : full;
        if (!tile)
            return Error{tile.error()};
        tile_height = std::max(tile_height, height);
        tiles.push_back(*std::move(tile));
        captions.push_back(printable(words.description.empty() ? frame.stem().string() : words.description));
        if (title.empty())
            title = printable(words.title);
    }

    const int columns = columns_of(tiles.size());
    const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
    const int width = 2 * k_margin + columns * k_tile_width + (columns - 1) * k_gap;
    const int height = k_margin + k_title + rows * (k_caption + tile_height) + (rows - 1) * k_gap + k_margin;
    Canvas canvas(width, height, 1.0, k_paper);
    const std::string count = std::to_string(tiles.size()) + (tiles.size() == 1 ? " frame" : " frames");
    canvas.words(canvas.fitted(title.empty() ? file.stem().string() : title, 34.0, width - 2.0 * k_margin - 240.0, true),
                 {k_margin, k_margin + 28.0}, {.size = 34.0, .colour = k_ink, .bold = true});
    canvas.words(count, {width - k_margin, k_margin + 28.0}, {.size = 24.0, .colour = k_dim_ink, .align = Align::right});
    for (std::size_t index = 0; index < tiles.size(); ++index) {
        const int column = static_cast<int>(index) % columns, row = static_cast<int>(index) / columns;
        const double x = k_margin + column * (k_tile_width + k_gap);
        const double y = k_margin + k_title + row * (k_caption + tile_height + k_gap);
        canvas.words(canvas.fitted(captions[index], 26.0, k_tile_width, true), {x, y + 30.0},
                     {.size = 26.0, .colour = k_ink, .bold = true});
        canvas.image(tiles[index], {x, y + k_caption});
        canvas.stroke(Rect{x - 0.5, y + k_caption - 0.5, tiles[index].width + 1.0, tiles[index].height + 1.0},
                      {.colour = k_hairline, .width = 1.0});
    }
    const auto sheet = canvas.finish();
    if (!sheet)
        return Error{message("contact sheet ", file.string(), ": ", sheet.error())};
    return write_png(*sheet, {title, count}, file);
}

} // namespace windrow::cli
