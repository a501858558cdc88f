#include "fluid/cpu/solid_flow.h"

#include "fluid/cpu/box_rules.h"
#include "fluid/cpu/kernels/kernels.h"

#include <algorithm>

namespace windrow::cpu {
namespace {

constexpr std::size_t k_chunk = 256; // cells a task: the same for any number of threads

std::size_t chunks_of(std::size_t count) {
    return (count + k_chunk - 1) / k_chunk;
}

// visit(chunk, first, end)
template <class Visit>
void for_each_chunk_of(const ParallelFor& parallel_for, std::size_t count, const Visit& visit) {
    parallel_for(static_cast<int>(chunks_of(count)), [&](int chunk) {
        const std::size_t first = k_chunk * static_cast<std::size_t>(chunk);
        visit(static_cast<std::size_t>(chunk), first, std::min(first + k_chunk, count));
    });
}

template <class Visit>
void for_each_chunk(const ParallelFor& parallel_for, std::size_t count, const Visit& visit) {
    for_each_chunk_of(parallel_for, count, [&](std::size_t, std::size_t first, std::size_t end) {
        for (std::size_t n = first; n < end; ++n)
            visit(n);
    });
}

} // namespace

template <class Visit>
void SolidFlow::for_each_surface_cell(const Visit& visit) const {
    const std::span<const SurfaceCell> cells = solids_.surface();
    for_each_chunk(parallel_for_, cells.size(), [&](std::size_t n) { visit(n, cells[n]); });
}

glm::vec3 SolidFlow::given_at(const PrescribedFlow& given, std::uint32_t cell) const {
    glm::vec3 wind(0.0f);
    if (given.ambient != nullptr) {
        const glm::ivec3 padded = box_.cells + k_halo, at = solids_.place_of(cell) + k_halo_low;
        const float* const around = given.ambient + 4 * ((static_cast<std::size_t>(at.z) * padded.y + at.y) * padded.x + at.x);
        wind += glm::vec3(around[0], around[1], around[2]);
    }
    if (!given.source_flow.empty())
        wind += glm::vec3(given.source_flow[cell]);
    return wind;
}

glm::vec3 SolidFlow::body_velocity(std::uint16_t body, glm::vec3 place_cells) const {
    return solids_.bodies()[body].velocity_at(place_cells * box_.cell_size);
}

// wall(source): the velocity across a source's face that the field is mirrored about.
template <class Wall>
void SolidFlow::extend_by(std::span<glm::vec4> field, const Wall& wall) const {
    std::size_t first = 0;
    for (const std::uint32_t end : solids_.layer_ends()) {
        const auto ghosts = solids_.ghosts().subspan(first, end - first);
        for_each_chunk(parallel_for_, ghosts.size(), [&](std::size_t n) {
            const Solids::Ghost& ghost = ghosts[n];
            glm::vec4 sum(0.0f);
            for (const Solids::GhostSource& source : solids_.ghost_sources().subspan(ghost.first, ghost.count)) {
                glm::vec4 value = field[source.cell];
                if (source.closed > 0.0f)
                    value[source.axis] += 2.0f * source.closed * (wall(source) - value[source.axis]);
                sum += value;
            }
            field[ghost.cell] = sum / static_cast<float>(ghost.count);
        });
        first = end;
    }
}

void SolidFlow::extend(std::span<glm::vec4> velocity, const PrescribedFlow& given) const {
    const bool prescribed = given.ambient != nullptr || !given.source_flow.empty();
    extend_by(velocity, [&](const Solids::GhostSource& source) {
        float wall = 0.0f;
        if (const PlacedObstacle& body = solids_.bodies()[source.body]; body.moves()) {
            glm::vec3 face = glm::vec3(solids_.place_of(source.cell)) + 0.5f;
            face[source.axis] += source.high ? -0.5f : 0.5f;
            wall = body_velocity(source.body, face)[source.axis];
        }
        return prescribed ? wall - given_at(given, source.cell)[source.axis] : wall;
    });
}

void SolidFlow::extend_history(std::span<glm::vec4> history) const {
    extend_by(history, [](const Solids::GhostSource&) { return 0.0f; });
}

void SolidFlow::close_divergence(std::span<const glm::vec4> velocity, const PrescribedFlow& given, bool bodies_move,
                                 float* potential) const {
    const Solids::Strides strides = solids_.cell_strides();
    const bool prescribed = given.ambient != nullptr || !given.source_flow.empty();
    for_each_surface_cell([&](std::size_t, const SurfaceCell& cell) {
        if (cell.shut) {
            potential[cell.potential] = 0.0f;
            return;
        }
        float change = bodies_move ? cell.wall : 0.0f;
        for (int slot = 0; slot < 6; ++slot) {
            if (!(cell.closed[slot] > 0.0f))
                continue;
            const auto next = static_cast<std::uint32_t>(cell.cell + solids_.to_neighbour(cell, slot, strides));
            const int axis = slot / 2;
            float both = velocity[cell.cell][axis] + velocity[next][axis];
            if (prescribed)
                both += given_at(given, cell.cell)[axis] + given_at(given, next)[axis];
            change -= (slot % 2 == 0 ? -0.5f : 0.5f) * cell.closed[slot] * both;
        }
        potential[cell.potential] += change;
    });
    const auto inside = solids_.inside();
    for_each_chunk(parallel_for_, inside.size(), [&](std::size_t n) {
        if (inside[n].deep)
            potential[inside[n].potential] = 0.0f;
    });
}

void SolidFlow::closed_slopes(const float* potential, std::span<float> term) const {
    const Solids::Strides strides = solids_.potential_strides();
    for_each_surface_cell([&](std::size_t n, const SurfaceCell& cell) {
        const float here = potential[cell.potential];
        float sum = 0.0f;
        for (int slot = 0; slot < 6; ++slot)
            if (cell.closed[slot] > 0.0f)
                sum += cell.closed[slot] * (potential[cell.potential + solids_.to_neighbour(cell, slot, strides)] - here);
        term[n] = sum;
    });
}

void SolidFlow::open_gradient(const float* potential, float scale, std::span<glm::vec4> velocity, std::span<glm::vec4> note,
                              float weight) const {
    const Solids::Strides strides = solids_.potential_strides();
    for_each_surface_cell([&](std::size_t, const SurfaceCell& cell) {
        const float here = potential[cell.potential];
        glm::vec3 fix(0.0f);
        for (int slot = 0; slot < 6; ++slot)
            if (cell.closed[slot] > 0.0f) {
                const float slope = potential[cell.potential + solids_.to_neighbour(cell, slot, strides)] - here;
                fix[slot / 2] += (slot % 2 == 0 ? -0.5f : 0.5f) * cell.closed[slot] * slope;
            }
        fix *= scale;
        velocity[cell.cell] += glm::vec4(fix, 0.0f);
        if (!note.empty())
            note[cell.cell] -= weight * glm::vec4(fix, 0.0f);
    });
}

void SolidFlow::hold_bodies(const PrescribedFlow& given, bool bodies_move, std::span<glm::vec4> velocity) const {
    const auto inside = solids_.inside();
    const bool prescribed = given.ambient != nullptr || !given.source_flow.empty();
    for_each_chunk(parallel_for_, inside.size(), [&](std::size_t n) {
        const PlacedObstacle& body = solids_.bodies()[inside[n].body];
        glm::vec3 u(0.0f);
        if (bodies_move && body.moves())
            u = body_velocity(inside[n].body, glm::vec3(solids_.place_of(inside[n].cell)) + 0.5f);
        if (prescribed)
            u -= given_at(given, inside[n].cell);
        velocity[inside[n].cell] = glm::vec4(u, 0.0f);
    });
}

glm::vec3 SolidFlow::push_on(std::size_t body, const float* potential) const {
    glm::dvec3 sum(0.0);
    for (const SurfaceCell& cell : solids_.surface())
        for (int slot = 0; slot < 6 && !cell.shut; ++slot)
            if (cell.closed[slot] > 0.0f && cell.body[slot] == body)
                sum[slot / 2] +=
                    (slot % 2 == 0 ? -1.0 : 1.0) * static_cast<double>(cell.closed[slot] * potential[cell.potential]);
    return glm::vec3(sum);
}

SolidFlow::Correction SolidFlow::correct_survey(std::span<const glm::vec4> velocity, std::span<const float> expansion) const {
    const std::span<const SurfaceCell> cells = solids_.surface();
    const Solids::Strides strides = solids_.cell_strides();
    const float scale = 0.5f / box_.cell_size;
    thread_local std::vector<Correction> parts;
    parts.resize(chunks_of(cells.size()));
    const std::span<Correction> results = parts; // within a task the name is that thread's own vector
    for_each_chunk_of(parallel_for_, cells.size(), [&](std::size_t chunk, std::size_t first, std::size_t end) {
        Correction part;
        for (std::size_t n = first; n < end; ++n) {
            const SurfaceCell& cell = cells[n];
            const glm::ivec3 place = cell.at_edge ? solids_.place_of(cell.cell) : glm::ivec3(0);
            float empty = 0.0f, closed = 2.0f * cell.wall;
            for (int slot = 0; slot < 6; ++slot) {
                const int axis = slot / 2, end_of_axis = slot % 2;
                const float outward = end_of_axis == 0 ? -1.0f : 1.0f;
                float beyond;
                if (cell.at_edge && place[axis] == end_of_axis * (box_.cells[axis] - 1)) {
                    const NormalGhost ghost = velocity_ghost(box_, axis, end_of_axis);
                    glm::ivec3 source = place;
                    source[axis] = ghost.source;
                    beyond = ghost.scale * velocity[box_.index(source.x, source.y, source.z)][axis];
                } else {
                    beyond = velocity[static_cast<std::size_t>(cell.cell + solids_.to_neighbour(cell, slot, strides))][axis];
                }
                empty += outward * beyond;
                closed += outward * (beyond - cell.closed[slot] * (beyond + velocity[cell.cell][axis]));
            }
            const float wanted = expansion.empty() ? 0.0f : expansion[cell.cell];
            const float before = scale * empty - wanted, after = scale * closed - wanted;
            const bool air = !solids_.inside(cell.cell);
            part.divergence_squares += static_cast<double>((air ? after * after : 0.0f) - before * before);
        }
        results[chunk] = part;
    });
    Correction whole;
    for (const Correction& part : parts)
        whole.divergence_squares += part.divergence_squares;
    for (const Solids::InsideCell& cell : solids_.inside())
        whole.speed_squares += static_cast<double>(glm::dot(velocity[cell.cell], velocity[cell.cell]));
    return whole;
}

void SolidFlow::close_diffusion(std::span<const glm::vec4> field, float ratio, std::span<glm::vec4> result) const {
    const Solids::Strides strides = solids_.cell_strides();
    for_each_surface_cell([&](std::size_t, const SurfaceCell& cell) {
        const glm::vec3 here(field[cell.cell]);
        glm::vec3 change(0.0f);
        for (int slot = 0; slot < 6; ++slot) {
            if (!(cell.closed[slot] > 0.0f))
                continue;
            const int axis = slot / 2;
            const PlacedObstacle& body = solids_.bodies()[cell.body[slot]];
            glm::vec3 face = glm::vec3(solids_.place_of(cell.cell)) + 0.5f;
            face[axis] += slot % 2 == 0 ? -0.5f : 0.5f;
            const glm::vec3 stuck = 2.0f * (body_velocity(cell.body[slot], face) - here);
            glm::vec3 flux(0.0f);
            if (body.surface == Surface::no_slip)
                flux = stuck;
            else
                flux[axis] = stuck[axis];
            const glm::vec3 empty = glm::vec3(field[cell.cell + solids_.to_neighbour(cell, slot, strides)]) - here;
            change += cell.closed[slot] * (flux - empty);
        }
        result[cell.cell] += glm::vec4(ratio * change, 0.0f);
    });
}

} // namespace windrow::cpu
