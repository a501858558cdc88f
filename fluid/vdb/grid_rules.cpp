#include "fluid/vdb/grid_rules.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow::vdb {

namespace {

using windrow::detail::Reasons;

constexpr float k_largest_half = 65504.0f;

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check_field(const VelocityGrid& grid, const Options& options, Reasons& reasons) {
    std::size_t not_finite = 0;
    std::size_t first = 0;
    float largest = std::max({std::abs(grid.outside.x), std::abs(grid.outside.y), std::abs(grid.outside.z)});
    for (std::size_t index = 0; index < grid.field.size(); ++index) {
        const glm::vec3 value(grid.field[index]);
        if (is_finite(value))
            largest = std::max({largest, std::abs(value.x), std::abs(value.y), std::abs(value.z)});
        else if (not_finite++ == 0)
            first = index;
    }
    if (not_finite != 0) {
        const std::size_t row = static_cast<std::size_t>(grid.cells.x);
        const std::size_t slice = row * static_cast<std::size_t>(grid.cells.y);
        const glm::ivec3 cell(first % row, first % slice / row, first / slice);
        reasons.add("field holds NaN or infinity in ", not_finite, " cells, the first ", cell,
                    ": give finite values (Wind::step sets such cells to ambient).");
    }
    if (options.precision == Precision::half && largest > k_largest_half)
        reasons.add("precision is half and the wind reaches ", largest, " m/s: half ends at ", k_largest_half,
                    ", write it with Precision::full.");
}

template <class Grids, class Finite>
void check_more(const Grids& grids, const VelocityGrid& grid, const Options& options, std::vector<std::string>& names,
                Reasons& reasons, const Finite& size_of) {
    for (const auto& more : grids) {
        if (more.name.empty() || !is_plain_name(more.name))
            reasons.add("a grid's name is \"", more.name, "\": name each, without '/' and control characters.");
        if (std::find(names.begin(), names.end(), more.name) != names.end())
            reasons.add("two grids are named \"", more.name, "\": give each its own name.");
        names.push_back(more.name);
        if (more.values.size() != grid.field.size())
            reasons.add(more.name, " holds ", more.values.size(), " values and field ", grid.field.size(), ": give one a cell.");
        float largest = 0.0f;
        const bool finite = std::all_of(more.values.begin(), more.values.end(), [&](const auto& value) {
            const float size = size_of(value);
            largest = std::max(largest, size);
            return std::isfinite(size);
        });
        if (!finite)
            reasons.add(more.name, " holds NaN or infinity: give finite values.");
        else if (options.precision == Precision::half && largest > k_largest_half)
            reasons.add("precision is half and ", more.name, " reaches ", largest, " ", more.units, ": half ends at ",
                        k_largest_half, ", write it with Precision::full.");
    }
}

} // namespace

bool is_plain_name(const std::string& name) {
    return std::none_of(name.begin(), name.end(),
                        [](char letter) { return letter == '/' || static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f; });
}

Result<void> check(const VelocityGrid& grid, const std::filesystem::path& file, const Options& options) {
    Reasons reasons;
    if (!file.has_filename())
        reasons.add("file is \"", file.string(), "\": end it in a file name, such as wind.vdb.");
    if (options.name.empty() || !is_plain_name(options.name))
        reasons.add("name is \"", options.name, "\": name the grid, without '/' and control characters, such as vel.");
    if (options.form > Form::three_scalars)
        reasons.add("form is ", static_cast<int>(options.form), ": give one_vector or three_scalars.");
    if (options.precision > Precision::half)
        reasons.add("precision is ", static_cast<int>(options.precision), ": give full or half.");
    if (options.up > UpAxis::z)
        reasons.add("up is ", static_cast<int>(options.up), ": give y or z.");
    if (options.format > Format::nanovdb)
        reasons.add("format is ", static_cast<int>(options.format), ": give openvdb or nanovdb.");
    else if (options.format == Format::nanovdb && !has_nanovdb())
        reasons.add("format is nanovdb, which is not built in: install libnanovdb-dev and build again, or give openvdb.");
    if (!std::isfinite(options.time))
        reasons.add("time is ", options.time, " s: give a finite time.");
    if (!is_finite(grid.origin))
        reasons.add("origin is ", grid.origin, " m: give finite coordinates.");
    if (options.name == k_obstacle_grid)
        reasons.add("name is \"", k_obstacle_grid, "\", the grid of the cells inside obstacles: give another, such as vel.");
    if (!is_finite(grid.outside))
        reasons.add("outside is ", grid.outside, " m/s: give a finite wind, such as the ambient.");
    const Box box{.cells = grid.cells, .cell_size = grid.cell_size, .boundaries = {}, .rows = grid.rows};
    if (auto valid = validate(box); !valid)
        reasons.add(valid.error());
    else if (grid.field.size() != box.cell_count())
        reasons.add("field holds ", grid.field.size(), " values and cells is ", grid.cells, ", ", box.cell_count(),
                    " in all: give one value a cell.");
    else
        check_field(grid, options, reasons);
    if (!grid.obstacle.empty() && grid.obstacle.size() != grid.field.size())
        reasons.add("obstacle holds ", grid.obstacle.size(), " values and field ", grid.field.size(), ": give as many, or none.");
    if (!std::all_of(grid.obstacle.begin(), grid.obstacle.end(), [](float value) { return value >= 0.0f && value <= 1.0f; }))
        reasons.add("obstacle holds values beyond 0 to 1: give 1 inside obstacles and 0 in the air.");
    if (!(grid.cell_height >= 0.0f && grid.cell_height <= 1e6f))
        reasons.add("cell_height is ", grid.cell_height, " m: give the thickness of a cell along y, or 0 for cell_size.");
    std::vector<std::string> names{options.name, k_obstacle_grid};
    for (const NamedScalar& scalar : grid.scalars)
        if (!std::isfinite(scalar.outside))
            reasons.add(scalar.name, " has the background ", scalar.outside, ": give a finite value.");
    check_more(grid.scalars, grid, options, names, reasons, [](float value) { return std::abs(value); });
    check_more(grid.vectors, grid, options, names, reasons, [](const glm::vec4& v) {
        return is_finite(glm::vec3(v)) ? std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)})
                                       : std::numeric_limits<float>::infinity();
    });
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace windrow::vdb
