#include "fluid/cpu/solid_flow.h"

#include "fluid/cpu/box_rules.h"
#include "fluid/cpu/kernels/kernels.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace windrow::cpu {

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

// wall(source): the velocity across a source's face that the field is mirrored about.
template <class Wall>
void SolidFlow::extend_by(std::span<glm::vec4> field, const Wall& wall) const {
    const std::span<const Solids::GhostSource> sources = solids_.ghost_sources();
    for (const Solids::Ghost& ghost : solids_.ghosts()) {
        glm::vec4 sum(0.0f);
        for (std::uint32_t n = ghost.first; n < ghost.first + ghost.count; ++n) {
            const Solids::GhostSource& source = sources[n];
            glm::vec4 value = field[source.cell];
            if (source.closed > 0.0f)
                value[source.axis] += 2.0f * source.closed * (wall(source) - value[source.axis]);
            sum += value;
        }
        field[ghost.cell] = ghost.count > 1 ? sum / static_cast<float>(ghost.count) : sum;
    }
}

void SolidFlow::extend(std::span<glm::vec4> velocity, const PrescribedFlow& given) const {
    if (given.any())
        extend_by(velocity,
                  [&](const Solids::GhostSource& source) { return source.wall - given_at(given, source.cell)[source.axis]; });
    else
        extend_by(velocity, [](const Solids::GhostSource& source) { return source.wall; });
}

void SolidFlow::extend_history(std::span<glm::vec4> history) const {
    extend_by(history, [](const Solids::GhostSource&) { return 0.0f; });
}

void SolidFlow::close_divergence(std::span<const glm::vec4> velocity, const PrescribedFlow& given, bool bodies_move,
                                 float* potential) const {
    for (const Solids::InsideCell& cell : solids_.inside())
        if (cell.shut)
            potential[cell.potential] = 0.0f;
    const bool prescribed = given.any();
    for (const ClosedFace& face : solids_.faces()) {
        float both = velocity[face.cell[0]][face.axis] + velocity[face.cell[1]][face.axis];
        if (prescribed)
            both += given_at(given, face.cell[0])[face.axis] + given_at(given, face.cell[1])[face.axis];
        const float flux = 0.5f * face.closed * both - (bodies_move ? face.wall : 0.0f);
        if (!face.shut[0])
            potential[face.potential[0]] -= flux;
        if (!face.shut[1])
            potential[face.potential[1]] += flux;
    }
}

void SolidFlow::closed_slopes(const float* potential, std::span<float> slope) const {
    const std::span<const ClosedFace> faces = solids_.faces();
    for (std::size_t n = 0; n < faces.size(); ++n)
        slope[n] = faces[n].closed * (potential[faces[n].potential[1]] - potential[faces[n].potential[0]]);
}

void SolidFlow::open_gradient(std::span<const float> slope, std::span<glm::vec4> velocity, std::span<glm::vec4> note,
                              float weight) const {
    const std::span<const ClosedFace> faces = solids_.faces();
    for (std::size_t n = 0; n < faces.size(); ++n)
        for (const std::uint32_t cell : faces[n].cell) {
            const float fix = 0.5f * slope[n];
            velocity[cell][faces[n].axis] += fix;
            if (!note.empty())
                note[cell][faces[n].axis] -= weight * fix;
        }
}

void SolidFlow::hold_bodies(const PrescribedFlow& given, bool bodies_move, std::span<glm::vec4> velocity) const {
    const bool prescribed = given.any();
    for (const Solids::InsideCell& cell : solids_.inside()) {
        const PlacedObstacle& body = solids_.bodies()[cell.body];
        glm::vec3 u(0.0f);
        if (bodies_move && body.moves())
            u = body.velocity_at((glm::vec3(solids_.place_of(cell.cell)) + 0.5f) * box_.cell_size);
        if (prescribed)
            u -= given_at(given, cell.cell);
        velocity[cell.cell] = glm::vec4(u, 0.0f);
    }
}

// Half of the sum of differences over two cells.
float SolidFlow::central_divergence(std::span<const glm::vec4> velocity, const Solids::SurfaceCell& cell) const {
    const std::size_t n = cell.cell, row = static_cast<std::size_t>(box_.cells.x),
                      plane = row * static_cast<std::size_t>(box_.cells.y);
    if (!cell.edge)
        return 0.5f * ((velocity[n + 1].x - velocity[n - 1].x) +
                       ((velocity[n + row].y - velocity[n - row].y) + (velocity[n + plane].z - velocity[n - plane].z)));
    const glm::ivec3 place = solids_.place_of(cell.cell);
    float sum = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            glm::ivec3 source = place;
            float scale = end == 0 ? -0.5f : 0.5f;
            if (place[axis] == end * (box_.cells[axis] - 1)) {
                const NormalGhost ghost = velocity_ghost(box_, axis, end);
                source[axis] = ghost.source;
                scale *= ghost.scale;
            } else {
                source[axis] += end == 0 ? -1 : 1;
            }
            sum += scale * velocity[box_.index(source.x, source.y, source.z)][axis];
        }
    return sum;
}

double SolidFlow::correct_divergence(std::span<const glm::vec4> velocity, std::span<const float> expansion,
                                     std::span<float> flux) const {
    std::fill(flux.begin(), flux.end(), 0.0f);
    for (const ClosedFace& face : solids_.faces()) {
        const float passed =
            0.5f * face.closed * (velocity[face.cell[0]][face.axis] + velocity[face.cell[1]][face.axis]) - face.wall;
        flux[face.surface[0]] -= passed;
        flux[face.surface[1]] += passed;
    }
    double found = 0.0;
    const std::span<const Solids::SurfaceCell> cells = solids_.surface();
    const float scale = 1.0f / box_.cell_size;
    for (std::size_t n = 0; n < cells.size(); ++n) {
        const float empty = central_divergence(velocity, cells[n]);
        const float wanted = expansion.empty() ? 0.0f : expansion[cells[n].cell];
        const float before = scale * empty - wanted, after = scale * (empty + flux[n]) - wanted;
        found += static_cast<double>((solids_.inside(cells[n].cell) ? 0.0f : after * after) - before * before);
    }
    return found;
}

glm::vec3 SolidFlow::push_on(std::size_t body, const float* potential) const {
    glm::dvec3 sum(0.0);
    for (const ClosedFace& face : solids_.faces())
        for (int end = 0; end < 2; ++end)
            if (face.body == body && !face.shut[end])
                sum[face.axis] += (end == 0 ? 1.0 : -1.0) * static_cast<double>(face.closed * potential[face.potential[end]]);
    return glm::vec3(sum);
}

void SolidFlow::close_diffusion(std::span<const glm::vec4> field, float ratio, std::span<glm::vec4> result) const {
    for (const ClosedFace& face : solids_.faces()) {
        const PlacedObstacle& body = solids_.bodies()[face.body];
        glm::vec3 wall(0.0f);
        if (body.moves()) {
            glm::vec3 place = glm::vec3(solids_.place_of(face.cell[0])) + 0.5f;
            place[face.axis] += 0.5f;
            wall = body.velocity_at(place * box_.cell_size);
        }
        for (int end = 0; end < 2; ++end) {
            const glm::vec3 here(field[face.cell[end]]), next(field[face.cell[1 - end]]), stuck = 2.0f * (wall - here);
            glm::vec3 flux(0.0f);
            if (body.surface == Surface::no_slip)
                flux = stuck;
            else
                flux[face.axis] = stuck[face.axis];
            result[face.cell[end]] += glm::vec4(ratio * face.closed * (flux - (next - here)), 0.0f);
        }
    }
}

} // namespace windrow::cpu
