#include "scene/height_files.h"

#include "fluid/core/message.h"
#include "fluid/files/pgm.h"
#include "fluid/files/text_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

namespace windrow::scene {
namespace {

using detail::message;

constexpr std::size_t k_max_pixels = std::size_t{1} << 28;
constexpr double k_most_missing = 0.2;

std::string place_of(std::size_t pixel, int width) {
    const auto across = static_cast<std::size_t>(width);
    return message("row ", pixel / across + 1, ", column ", pixel % across + 1);
}

// --- Formats -----------------------------------------------------------------------------------------------------------------

Result<HeightPicture> parse_pgm(std::string_view bytes, const std::string& name, std::size_t max_pixels) {
    const auto picture = detail::read_pgm(bytes, name, std::min(k_max_pixels, max_pixels));
    if (!picture)
        return picture.failure();
    HeightPicture heights{.data = {.corners = picture->size, .spacing = 1.0f}, .unit = static_cast<double>(picture->white)};
    heights.data.heights.reserve(picture->pixels());
    for (std::size_t n = 0; n < picture->pixels(); ++n)
        heights.data.heights.push_back(picture->value(n));
    return heights;
}

// Sum of the steps between neighbours along a row.
double roughness_of(std::string_view bytes, int corners, ByteOrder order) {
    double sum = 0.0;
    const auto at = [&](std::size_t n) {
        const int first = static_cast<unsigned char>(bytes[2 * n]), second = static_cast<unsigned char>(bytes[2 * n + 1]);
        return order == ByteOrder::low_first ? first + 256 * second : second + 256 * first;
    };
    for (std::size_t n = 1; n < bytes.size() / 2; ++n)
        if (n % static_cast<std::size_t>(corners) != 0)
            sum += std::abs(at(n) - at(n - 1));
    return sum;
}

// A square of whole numbers of 16 bits, as terrain tools write it.
Result<HeightPicture> parse_raw(std::string_view bytes, const std::string& name, ByteOrder order) {
    constexpr double k_much_smoother = 8.0; // ground that rises by a few levels a pixel is a hundred times
    const auto corners = static_cast<int>(std::lround(std::sqrt(static_cast<double>(bytes.size() / 2))));
    if (bytes.size() % 2 != 0 || static_cast<std::size_t>(corners) * static_cast<std::size_t>(corners) * 2 != bytes.size())
        return Error{message(name, " has ", bytes.size(),
                             " bytes, which is no square of heights of 16 bits: cut it square, or give a PGM.")};
    const ByteOrder other = order == ByteOrder::low_first ? ByteOrder::high_first : ByteOrder::low_first;
    if (roughness_of(bytes, corners, order) > k_much_smoother * roughness_of(bytes, corners, other) && corners > 8)
        return Error{message(name, " is much smoother with the ", order == ByteOrder::low_first ? "high" : "low",
                             " byte first: give \"byte_order\": \"", order == ByteOrder::low_first ? "high_first" : "low_first",
                             "\".")};
    HeightPicture heights{.data = {.corners = {corners, corners}, .spacing = 1.0f}, .unit = 65535.0};
    heights.data.heights.reserve(bytes.size() / 2);
    const std::size_t low = order == ByteOrder::low_first ? 0 : 1;
    for (std::size_t n = 0; n < bytes.size(); n += 2) {
        const unsigned level = static_cast<unsigned char>(bytes[n + low]) + 256u * static_cast<unsigned char>(bytes[n + 1 - low]);
        heights.data.heights.push_back(static_cast<float>(level) / 65535.0f);
    }
    return heights;
}

bool same_word(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return std::tolower(static_cast<unsigned char>(x)) == y; });
}

// Words of a text, one after another.
class Words {
  public:
    explicit Words(std::string_view text) : left_(text) {}
    [[nodiscard]] std::string_view next() {
        const std::size_t begin = std::min(left_.find_first_not_of(" \t\r\n"), left_.size());
        const std::size_t end = std::min(left_.find_first_of(" \t\r\n", begin), left_.size());
        const std::string_view word = left_.substr(begin, end - begin);
        left_.remove_prefix(end);
        return word;
    }
    [[nodiscard]] std::optional<double> number() { return number_of(next()); }
    /// Not a number for the words by which grids name a place without data.
    [[nodiscard]] static std::optional<double> number_of(std::string_view word) {
        const auto is_it = [&](const char* none) { return same_word(word, none); };
        if (std::ranges::any_of(std::array{"nan", "-nan", "inf", "-inf"}, is_it))
            return std::numeric_limits<double>::quiet_NaN();
        return detail::number_of<double>(word);
    }

  private:
    std::string_view left_;
};

// An ESRI ASCII grid: ncols, nrows, xllcorner, yllcorner, cellsize, NODATA_value, then heights [m], the northern row first.
Result<HeightPicture> parse_asc(std::string_view bytes, const std::string& name) {
    constexpr const char* k_keys[] = {"ncols",     "nrows",     "xllcorner", "yllcorner",
                                      "xllcenter", "yllcenter", "cellsize",  "nodata_value"};
    const Error no_grid{name + " is no ESRI ASCII grid: its first lines are ncols, nrows, xllcorner, yllcorner, cellsize and "
                               "NODATA_value, a number each."};
    Words words(detail::without_mark(bytes));
    double columns = 0.0, rows = 0.0, cell = 0.0;
    std::optional<double> nodata, first;
    for (std::string_view word = words.next(); !first; word = words.next()) {
        if (word.empty())
            return no_grid;
        first = Words::number_of(word);
        if (first)
            break;
        const bool known =
            std::any_of(std::begin(k_keys), std::end(k_keys), [&](const char* key) { return same_word(word, key); });
        const auto value = known ? words.number() : std::nullopt;
        if (!value && !known && columns > 0.0 && rows > 0.0 && cell > 0.0)
            return Error{message(name, ": row 1, column 1 is \"", word, "\": give a height.")};
        if (!value)
            return no_grid;
        if (same_word(word, "ncols"))
            columns = *value;
        else if (same_word(word, "nrows"))
            rows = *value;
        else if (same_word(word, "cellsize"))
            cell = *value;
        else if (same_word(word, "nodata_value"))
            nodata = value;
    }
    const double most = HeightMap::k_max_corners;
    if (!(columns >= 2.0 && rows >= 2.0 && columns <= most && rows <= most && cell > 0.0) || columns != std::floor(columns) ||
        rows != std::floor(rows))
        return no_grid;
    HeightPicture heights{.data = {.corners = {static_cast<int>(columns), static_cast<int>(rows)}, .spacing = 1.0f},
                          .metres = true,
                          .nodata = nodata,
                          .pixel = glm::dvec2(cell)};
    const auto count = static_cast<std::size_t>(columns * rows);
    if (count / 2 > bytes.size()) // a digit and a blank each
        return Error{message(name, " ends early: give ", count, " heights.")};
    heights.data.heights.reserve(count);
    for (auto height = first; height; height = heights.data.heights.size() < count ? words.number() : std::nullopt)
        heights.data.heights.push_back(static_cast<float>(*height));
    if (heights.data.heights.size() != count)
        return Error{message(name, " has ", heights.data.heights.size(), " heights of ", count, ": the next one at ",
                             place_of(heights.data.heights.size(), heights.data.corners.x), " is missing or no number.")};
    if (!words.next().empty())
        return Error{message(name, " goes on after its ", count, " heights: give ncols times nrows of them.")};
    return heights;
}

// --- What is wrong with the numbers ------------------------------------------------------------------------------------------

// By the file's own word, or what no ground is: voids of surveys, and what no height map holds.
bool is_missing(float height, const HeightPicture& picture) {
    const double own = static_cast<double>(height) * picture.unit;
    if (picture.nodata && (own == *picture.nodata || std::abs(own - *picture.nodata) <= 1e-6 * std::abs(*picture.nodata)))
        return true;
    return !std::isfinite(height) ||
           (picture.metres && (own == -32768.0 || own == -32767.0 || own == -9999.0 || std::abs(own) > 1e5));
}

// Each missing height becomes the mean of its known neighbours, from the edge of the gap inward.
Result<void> fill(HeightPicture& picture, const std::string& name, ReadLog& log) {
    const glm::ivec2 size = picture.data.corners;
    std::vector<float>& heights = picture.data.heights;
    std::vector<std::size_t> missing;
    for (std::size_t n = 0; n < heights.size(); ++n)
        if (is_missing(heights[n], picture))
            missing.push_back(n);
    if (missing.empty())
        return {};
    const std::string found = message(name, " has ", missing.size(), " of ", heights.size(),
                                      " heights without data, the first at ", place_of(missing.front(), size.x));
    if (static_cast<double>(missing.size()) > k_most_missing * static_cast<double>(heights.size()))
        return Error{found + ": fill them (gdal_fillnodata), or cut the part that has heights."};
    constexpr float k_unknown = std::numeric_limits<float>::quiet_NaN();
    for (const std::size_t n : missing)
        heights[n] = k_unknown;
    const auto for_each_beside = [&](std::size_t n, const auto& visit) { // and for itself
        const glm::ivec2 at(n % static_cast<std::size_t>(size.x), n / static_cast<std::size_t>(size.x));
        for (int z = std::max(at.y - 1, 0); z <= std::min(at.y + 1, size.y - 1); ++z)
            for (int x = std::max(at.x - 1, 0); x <= std::min(at.x + 1, size.x - 1); ++x)
                visit(static_cast<std::size_t>(z) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
    };
    std::vector<std::pair<std::size_t, float>> known;
    for (std::vector<std::size_t> front = std::move(missing); !front.empty();) {
        known.clear();
        for (const std::size_t n : front) {
            float sum = 0.0f;
            int count = 0;
            for_each_beside(n, [&](std::size_t beside) {
                if (!std::isnan(heights[beside])) {
                    sum += heights[beside];
                    ++count;
                }
            });
            if (count > 0)
                known.emplace_back(n, sum / static_cast<float>(count));
        }
        for (const auto& [n, height] : known)
            heights[n] = height;
        front.clear();
        for (const auto& [n, height] : known)
            for_each_beside(n, [&](std::size_t beside) {
                if (std::isnan(heights[beside]))
                    front.push_back(beside);
            });
        std::sort(front.begin(), front.end());
        front.erase(std::unique(front.begin(), front.end()), front.end());
    }
    log.warn(found + ": they are filled from those beside them.");
    return {};
}

void report_pixel(const HeightPicture& picture, const std::string& name, bool scaled, ReadLog& log) {
    if (!picture.pixel || scaled || *picture.pixel == glm::dvec2(1.0))
        return;
    log.warn(message(name, " says that its pixels are ", picture.pixel->x, " x ", picture.pixel->y,
                     ", and a pixel counts as a metre: give \"scale\" their size in metres."));
}

} // namespace

// --- TIFF --------------------------------------------------------------------------------------------------------------------

TiffTags tiff_tags(std::string_view bytes) {
    TiffTags tags;
    const bool little = bytes.starts_with("II"), big = bytes.starts_with("MM");
    const auto number = [&](std::size_t at, std::size_t size) -> std::uint64_t {
        std::uint64_t value = 0;
        for (std::size_t n = 0; n < size && at + size <= bytes.size() && at < bytes.size(); ++n)
            value |= std::uint64_t{static_cast<unsigned char>(bytes[at + n])} << 8 * (little ? n : size - 1 - n);
        return value;
    };
    if ((!little && !big) || number(2, 2) != 42)
        return tags;
    const auto directory = static_cast<std::size_t>(number(4, 4));
    const std::uint64_t entries = number(directory, 2);
    for (std::uint64_t n = 0; n < entries; ++n) {
        const std::size_t at = directory + 2 + 12 * static_cast<std::size_t>(n);
        if (at + 12 > bytes.size())
            break;
        const std::uint64_t tag = number(at, 2), kind = number(at + 2, 2), count = number(at + 4, 4);
        const auto far = static_cast<std::size_t>(number(at + 8, 4));
        if (tag == 42113 && kind == 2 && count <= 64) {
            const std::size_t from = count <= 4 ? at + 8 : far;
            if (from + count <= bytes.size())
                tags.nodata = Words(bytes.substr(from, bytes.substr(from, count).find('\0'))).number();
        }
        if (tag == 33550 && kind == 12 && count >= 2 && far + 16 <= bytes.size())
            tags.pixel = glm::dvec2(std::bit_cast<double>(number(far, 8)), std::bit_cast<double>(number(far + 8, 8)));
    }
    if (tags.pixel && !(tags.pixel->x > 0.0 && tags.pixel->y > 0.0))
        tags.pixel.reset();
    return tags;
}

HeightKeys height_keys(JsonObject& object) {
    HeightKeys keys;
    keys.byte_order =
        object.word({"byte_order", "Of a raw file of heights: which byte of a number is first. Other files say it themselves."},
                    ByteOrder::low_first, {{"low_first", ByteOrder::low_first}, {"high_first", ByteOrder::high_first}});
    keys.nodata = object.optional_number(
        {"nodata", "The file's own number of a place without data, which is filled from its neighbours: 0 to "
                   "65535 in pictures of 16 bits. Default: as the file says."},
        {-1e38, 1e38});
    return keys;
}

Result<HeightPicture> read_height_file(std::string_view bytes, const std::string& name, const HeightKeys& keys, bool scaled,
                                       ReadLog& log) {
    return detail::where_memory_lasts([&]() -> Result<HeightPicture> {
        const std::string kind = std::filesystem::path(name).extension().string();
        const bool pgm = bytes.starts_with("P5") || bytes.starts_with("P2") || kind == ".pgm";
        const std::size_t room = log.budget().memory_left() / sizeof(float);
        auto picture = kind == ".raw" || kind == ".r16" ? parse_raw(bytes, name, keys.byte_order)
                       : kind == ".asc"                 ? parse_asc(bytes, name)
                       : log.heights == nullptr || pgm  ? parse_pgm(bytes, name, room)
                                                        : log.heights(bytes, name, room);
        if (!picture)
            return picture;
        const TiffTags tags = tiff_tags(bytes);
        if (keys.nodata || !picture->nodata)
            picture->nodata = keys.nodata ? keys.nodata : tags.nodata;
        if (!picture->pixel)
            picture->pixel = tags.pixel;
        if (auto filled = fill(*picture, name, log); !filled)
            return filled.failure();
        report_pixel(*picture, name, scaled, log);
        return picture;
    });
}

Result<HoleMask> read_holes(std::string_view bytes, const std::string& name, ReadLog& log) {
    constexpr float k_half = 0.5f;
    const auto picture = read_height_file(bytes, name, {}, true, log);
    if (!picture)
        return picture.failure();
    return detail::where_memory_lasts([&]() -> Result<HoleMask> {
        HoleMask holes{.cells = picture->data.corners};
        holes.open.reserve(picture->data.heights.size());
        for (const float white : picture->data.heights)
            holes.open.push_back(white > k_half);
        return holes;
    });
}

} // namespace windrow::scene
