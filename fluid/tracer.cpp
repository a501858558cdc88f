#include "fluid/tracer.h"

#include "fluid/core/archive.h"
#include "fluid/core/message.h"
#include "fluid/core/obstacle_record.h"
#include "fluid/solids/solids.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow {
namespace {

constexpr detail::Format k_smoke_format{"WINDSMOK", detail::Layout("tracer 1").version(), "saved tracer", "Tracer::save"};

} // namespace

Result<Tracer> Tracer::create(const WindView& air, const ParallelFor& parallel_for) {
    auto work = Workspace::create({.box = air.box(), .ambient = air.ambient().mean(), .parallel_for = parallel_for});
    if (!work)
        return work.failure();
    return detail::where_memory_lasts([&]() -> Result<Tracer> { return Tracer(air, *std::move(work)); });
}

Tracer::Tracer(const WindView& air, Workspace work)
    : work_(std::move(work)), window_(air.window()), cells_(air.box().cell_count(), 0.0f), carried_(cells_.size()) {
    window_.rows = work_.box().rows.get();
}

// Rows of their own keep their heights over the box's floor: a cell takes what is linear between the rows around its place.
void Tracer::move_to(const Window& window) {
    const CellIndex by = (window.origin_cells - window.shifted) - (window_.origin_cells - window_.shifted);
    const glm::ivec3 cells = window.cells;
    const double rise = static_cast<double>(by.y) * window.units().y;
    window_ = window;
    window_.rows = work_.box().rows.get();
    if (by == CellIndex(0))
        return;
    const Box& box = work_.box();
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j) {
            const double place = box.rows ? box.rows->place_before(j, rise) : static_cast<double>(j + by.y) + 0.5;
            const bool inside = k + by.z >= 0 && k + by.z < cells.z && place > 0.0 && place < cells.y;
            const double row = inside ? std::clamp(place - 0.5, 0.0, cells.y - 1.0) : 0.0;
            const int below = static_cast<int>(row), above = std::min(below + 1, cells.y - 1);
            const auto part = static_cast<float>(row - below);
            for (int i = 0; i < cells.x; ++i) {
                float& value = carried_[box.index(i, j, k)] = 0.0f;
                if (!inside || i + by.x < 0 || i + by.x >= cells.x)
                    continue;
                const int x = static_cast<int>(i + by.x), z = static_cast<int>(k + by.z);
                value = glm::mix(cells_[box.index(x, below, z)], cells_[box.index(x, above, z)], part);
            }
        }
    cells_.swap(carried_);
}

Result<void> Tracer::step(const WindView& air, std::span<const PlacedObstacle> obstacles, double dt) {
    if (air.window().cells != window_.cells)
        return Error{detail::message("the wind has ", air.window().cells, " cells and the tracer ", window_.cells,
                                     ": make a tracer for each wind.")};
    if (!(work_.box().boundaries == air.box().boundaries))
        if (auto changed = work_.set_boundaries(air.box().boundaries); !changed)
            return changed;
    work_.set_ambient(air.ambient().mean());
    if (auto placed = work_.set_obstacles(obstacles); !placed)
        return placed;
    if (work_.solids() != nullptr && joined_.empty() && !detail::memory_lasts([&] { joined_.resize(cells_.size()); }))
        return detail::out_of_memory();
    move_to(air.window());
    if (!(dt > 0.0))
        return {};
    const ScalarTransport transport{.carried = cells_,
                                    .velocity = air.field(),
                                    .dt = static_cast<float>(dt),
                                    .interpolation = Interpolation::cubic,
                                    .clamped = true};
    if (auto carried = advect(work_, transport, carried_); !carried)
        return carried;
    cells_.swap(carried_);
    return {};
}

Result<std::vector<std::byte>> Tracer::save() const {
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        detail::Writer writer(64 + cells_.size() * sizeof(float));
        writer(window_.cells, window_.cell_size, window_.origin_cells - window_.shifted, work_.ambient(), cells_);
        return std::move(writer).finish(k_smoke_format);
    });
}

Result<Tracer> Tracer::load(std::span<const std::byte> bytes, const WindView& air, std::span<const PlacedObstacle> obstacles,
                            const ParallelFor& parallel_for) {
    return detail::where_memory_lasts([&]() -> Result<Tracer> {
        glm::ivec3 cells(0);
        float cell_size = 0.0f;
        CellIndex origin(0);
        glm::vec3 ambient(0.0f);
        std::vector<float> values;
        auto read = detail::read_sealed(bytes, k_smoke_format, [&](detail::Reader& reader) {
            reader(cells, cell_size, origin, ambient, values);
            reader.require(detail::in_range(origin), "its box is out of range.");
            for (int axis = 0; axis < 3; ++axis)
                reader.require(std::abs(ambient[axis]) <= 1e4f, "its wind is out of range.");
            reader.require(std::ranges::all_of(values, [](float value) { return value >= 0.0f && value <= 1.0f; }),
                           "a cell does not hold 0 to 1.");
        });
        if (!read)
            return read.failure();
        if (cells != air.window().cells || cell_size != air.window().cell_size || values.size() != air.box().cell_count())
            return Error{detail::message("the wind has ", air.window().cells, " cells of ", air.window().cell_size,
                                         " m and the saved tracer ", cells, " of ", cell_size,
                                         " m: load it with the wind of the same moment.")};
        auto work = Workspace::create({.box = air.box(), .ambient = ambient, .parallel_for = parallel_for});
        if (!work)
            return work.failure();
        if (auto placed = work->set_obstacles(obstacles); !placed)
            return placed.failure();
        Tracer tracer(air, *std::move(work));
        tracer.window_.origin_cells = origin + tracer.window_.shifted;
        tracer.cells_ = std::move(values);
        if (tracer.work_.solids() != nullptr)
            tracer.joined_.resize(tracer.cells_.size());
        return tracer;
    });
}

void Tracer::blow(glm::dvec3 point, float radius) {
    const Box& box = work_.box();
    const double h = static_cast<double>(box.cell_size), reach = static_cast<double>(radius) + h;
    const glm::dvec3 low = glm::floor(window_.local(point - reach)), high = glm::ceil(window_.local(point + reach));
    const glm::ivec3 first(glm::clamp(low, glm::dvec3(0.0), glm::dvec3(window_.cells)));
    const glm::ivec3 end(glm::clamp(high, glm::dvec3(0.0), glm::dvec3(window_.cells)));
    if (glm::any(glm::lessThanEqual(end, first)))
        return;
    const Solids* const solids = work_.solids();
    if (solids != nullptr)
        solids->find_joined(window_.local(point), first, end, joined_);
    for (int k = first.z; k < end.z; ++k)
        for (int j = first.y; j < end.y; ++j)
            for (int i = first.x; i < end.x; ++i) {
                if (solids != nullptr && joined_[box.index(i, j, k)] == 0)
                    continue;
                const double beyond = glm::length(window_.centre(i, j, k) - point) - static_cast<double>(radius);
                float& value = cells_[box.index(i, j, k)];
                value = std::max(value, static_cast<float>(std::clamp(1.0 - beyond / h, 0.0, 1.0)));
            }
}

} // namespace windrow
