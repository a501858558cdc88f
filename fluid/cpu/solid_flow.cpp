#include "fluid/cpu/solid_flow.h"

#include "fluid/cpu/box_rules.h"
#include "fluid/cpu/kernels/kernels.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::cpu {

namespace {

// Factors of a face beside those of cubes: on what the operator takes from the slope over it, and on what passes it into its cells.
struct FaceScales {
    float link = 1.0f, cell[2] = {1.0f, 1.0f};

    FaceScales(const Box& box, const ClosedFace& face) {
        if (!box.rows || face.axis != 1)
            return;
        const std::size_t low = face.place[1];
        link = box.rows->links()[low + 1];
        cell[0] = box.rows->scales()[low];
        cell[1] = box.rows->scales()[low + 1];
    }
};

// `push` holds the sum of the potential over its surface.
Push finished(Push push, float cell_size) {
    if (push.wetted > 0.0)
        push.potential *= static_cast<double>(cell_size) / push.wetted;
    return push;
}

} // namespace

glm::vec3 SolidFlow::ambient_at(const PrescribedFlow& given, std::uint32_t cell) const {
    const float* const around = given.ambient + 4 * padded_index(box_.cells, solids_.place_of(cell));
    return {around[0], around[1], around[2]};
}

glm::vec3 SolidFlow::given_at(const PrescribedFlow& given, std::uint32_t cell) const {
    return solids_.is_sheltered(cell) ? glm::vec3(0.0f) : ambient_at(given, cell);
}

// across(source): the velocity of the wall along a source's normal.
template <class Across>
void SolidFlow::extend_by(std::span<glm::vec4> field, const Across& across) const {
    const std::span<const Solids::GhostSource> sources = solids_.ghost_sources();
    for (const Solids::Ghost& ghost : solids_.ghosts()) {
        glm::vec4 sum(0.0f);
        for (std::uint32_t n = ghost.first; n < ghost.first + ghost.count; ++n) {
            const Solids::GhostSource& source = sources[n];
            const glm::vec4 value = field[source.cell];
            sum += glm::vec4(source.slipping(glm::vec3(value), across(source)), value.w);
        }
        field[ghost.cell] = ghost.count > 1 ? sum / static_cast<float>(ghost.count) : sum;
    }
}

void SolidFlow::extend(std::span<glm::vec4> velocity, const PrescribedFlow& given) const {
    if (given.any())
        extend_by(velocity, [&](const Solids::GhostSource& source) {
            return source.wall - glm::dot(given_at(given, source.cell), source.normal);
        });
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
    const bool prescribed = given.any(), rooms = prescribed && !solids_.rooms().empty();
    for (const ClosedFace& face : solids_.faces()) {
        float both = velocity[face.cell[0]][face.axis] + velocity[face.cell[1]][face.axis];
        if (prescribed)
            both += ambient_at(given, face.cell[0])[face.axis] + ambient_at(given, face.cell[1])[face.axis];
        const float flux = 0.5f * face.closed * both - (bodies_move ? face.wall : 0.0f);
        const FaceScales scales(box_, face);
        for (int end = 0; end < 2; ++end)
            if (!face.shut[end])
                potential[face.potential[end]] +=
                    (end == 0 ? -scales.cell[end] : scales.cell[end]) * (flux - (rooms ? blown_past(given, face, end) : 0.0f));
    }
}

// What a face's flux counts of the wind although the cell at its end is sheltered: there the velocity is the whole, and the wind is
// part of the velocity beyond the face.
float SolidFlow::blown_past(const PrescribedFlow& given, const ClosedFace& face, int end) const {
    if (!solids_.is_sheltered(face.cell[end]))
        return 0.0f;
    const std::uint32_t here = face.cell[end], other = face.cell[1 - end];
    const float beyond = ambient_at(given, other)[face.axis];
    const float both = ambient_at(given, here)[face.axis] + beyond;
    return 0.5f * (face.closed * both + (solids_.is_sheltered(other) ? 0.0f : (1.0f - face.closed) * beyond));
}

void SolidFlow::closed_slopes(const float* potential, std::span<float> slope) const {
    const std::span<const ClosedFace> faces = solids_.faces();
    for (std::size_t n = 0; n < faces.size(); ++n)
        slope[n] = faces[n].closed * (potential[faces[n].potential[1]] - potential[faces[n].potential[0]]);
}

void SolidFlow::add_masked(std::span<const float> slope, float factor, std::span<float> terms, bool potential) const {
    const std::span<const ClosedFace> faces = solids_.faces();
    for (std::size_t n = 0; n < faces.size(); ++n) {
        const ClosedFace& face = faces[n];
        const std::uint32_t* const at = potential ? face.potential : face.surface;
        const FaceScales scales(box_, face);
        const float passed = factor * (scales.link * slope[n]);
        terms[at[0]] += scales.cell[0] * passed;
        terms[at[1]] -= scales.cell[1] * passed;
    }
}

void SolidFlow::open_gradient(std::span<const float> slope, std::span<glm::vec4> velocity, std::span<glm::vec4> note,
                              float weight) const {
    const std::span<const ClosedFace> faces = solids_.faces();
    for (std::size_t n = 0; n < faces.size(); ++n) {
        const FaceScales scales(box_, faces[n]);
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t cell = faces[n].cell[end];
            const float fix = 0.5f * scales.cell[end] * slope[n];
            velocity[cell][faces[n].axis] += fix;
            if (!note.empty())
                note[cell][faces[n].axis] -= weight * fix;
        }
    }
}

void SolidFlow::hold_bodies(const PrescribedFlow& given, bool bodies_move, std::span<glm::vec4> velocity) const {
    const bool prescribed = given.any();
    for (const Solids::InsideCell& cell : solids_.inside()) {
        const PlacedObstacle& body = solids_.bodies()[cell.body];
        glm::vec3 u(0.0f);
        if (bodies_move && body.moves())
            u = body.velocity_at(box_.metres(glm::vec3(solids_.place_of(cell.cell)) + 0.5f));
        if (prescribed)
            u -= given_at(given, cell.cell);
        velocity[cell.cell] = glm::vec4(u, 0.0f);
    }
}

// Half of the sum of differences over two cells.
float SolidFlow::central_divergence(std::span<const glm::vec4> velocity, const Solids::SurfaceCell& cell) const {
    const std::size_t n = cell.cell, row = static_cast<std::size_t>(box_.cells.x),
                      plane = row * static_cast<std::size_t>(box_.cells.y);
    const float along_rows = 1.0f / cell.volume;
    if (!cell.edge)
        return 0.5f * ((velocity[n + 1].x - velocity[n - 1].x) + (along_rows * (velocity[n + row].y - velocity[n - row].y) +
                                                                  (velocity[n + plane].z - velocity[n - plane].z)));
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
            if (axis == 1)
                scale *= along_rows;
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
        const FaceScales scales(box_, face);
        flux[face.surface[0]] -= scales.cell[0] * passed;
        flux[face.surface[1]] += scales.cell[1] * passed;
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

// Of the faces of bodies, one after another.
class SolidFlow::FacePush {
  public:
    FacePush(const Box& box, const float* potential) : box_(box), potential_(potential), h_(box.cell_size) {
        for (int axis = 0; axis < 3; ++axis)
            if (box.boundaries.periodic(axis))
                period_[axis] = h_ * box.cells[axis];
    }
    void add(const ClosedFace& face, const glm::dvec3& position, Push& push) const;

  private:
    const Box& box_;
    const float* potential_;
    double h_;
    glm::dvec3 period_{0.0}; ///< [m] 0: not periodic
};

void SolidFlow::FacePush::add(const ClosedFace& face, const glm::dvec3& position, Push& push) const {
    const double area = face.axis == 1 ? 1.0 : static_cast<double>(box_.volume(face.place[1])); // over that of a cube's face
    double held = 0.0;
    for (int end = 0; end < 2; ++end)
        if (!face.shut[end]) {
            const double here = area * static_cast<double>(face.closed) * static_cast<double>(potential_[face.potential[end]]);
            held += end == 0 ? here : -here;
            push.potential += here;
            push.wetted += area * static_cast<double>(face.closed);
        }
    glm::dvec3 place = glm::dvec3(face.place[0], face.place[1], face.place[2]) + 0.5;
    place[face.axis] += 0.5;
    glm::dvec3 arm = h_ * place - position;
    if (box_.rows)
        arm.y = box_.rows->height_at(place.y) - position.y;
    for (int axis = 0; axis < 3; ++axis)
        if (period_[axis] > 0.0) // from its nearest image
            arm[axis] -= period_[axis] * std::round(arm[axis] / period_[axis]);
    const double along = h_ * h_ * h_ * held; // the impulse, along the axis; the moment is arm x impulse
    const int next = (face.axis + 1) % 3, last = (face.axis + 2) % 3;
    push.impulse[face.axis] += along;
    push.twist[next] += arm[last] * along;
    push.twist[last] -= arm[next] * along;
}

Push SolidFlow::push_on(std::size_t body, const float* potential) const {
    Push push;
    const FacePush faces(box_, potential);
    for (const ClosedFace& face : solids_.faces())
        if (face.body == body)
            faces.add(face, glm::dvec3(solids_.bodies()[body].position), push);
    return finished(push, box_.cell_size);
}

void SolidFlow::find_pushes(const float* potential, std::span<Push> pushes) const {
    std::fill(pushes.begin(), pushes.end(), Push{});
    const FacePush faces(box_, potential);
    const std::span<const ClosedFace> all = solids_.faces();
    for (std::size_t n = 0; n < all.size();) { // those of a body that follow each other, in registers
        const std::uint16_t body = all[n].body;
        const glm::dvec3 position(solids_.bodies()[body].position);
        Push push;
        for (; n < all.size() && all[n].body == body; ++n)
            faces.add(all[n], position, push);
        pushes[body] += push;
    }
    for (Push& push : pushes)
        push = finished(push, box_.cell_size);
}

glm::vec3 SolidFlow::wall_at(const ClosedFace& face) const {
    const PlacedObstacle& body = solids_.bodies()[face.body];
    if (!body.moves())
        return glm::vec3(0.0f);
    glm::vec3 place = glm::vec3(face.place[0], face.place[1], face.place[2]) + 0.5f;
    place[face.axis] += 0.5f;
    return body.velocity_at(box_.metres(place));
}

void SolidFlow::close_diffusion(std::span<const glm::vec4> field, const PrescribedFlow& given, float ratio,
                                std::span<glm::vec4> result) const {
    const bool prescribed = given.any();
    for (const ClosedFace& face : solids_.faces()) {
        const bool sticks = solids_.bodies()[face.body].surface == Surface::no_slip;
        const glm::vec3 wall = wall_at(face);
        const FaceScales scales(box_, face);
        for (int end = 0; end < 2; ++end) {
            const glm::vec3 here(field[face.cell[end]]), next(field[face.cell[1 - end]]);
            const glm::vec3 stuck = 2.0f * (wall - (prescribed ? given_at(given, face.cell[end]) : glm::vec3(0.0f)) - here);
            glm::vec3 flux(0.0f);
            if (sticks)
                flux = stuck;
            else
                flux[face.axis] = stuck[face.axis];
            result[face.cell[end]] +=
                glm::vec4(ratio * scales.cell[end] * scales.link * face.closed * (flux - (next - here)), 0.0f);
        }
    }
}

void SolidFlow::drag_along_walls(const PrescribedFlow& given, float ratio, std::span<glm::vec4> field) const {
    const bool prescribed = given.any();
    for (const ClosedFace& face : solids_.faces()) {
        const bool sticks = solids_.bodies()[face.body].surface == Surface::no_slip;
        const glm::vec3 wall = wall_at(face);
        const FaceScales scales(box_, face);
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t cell = face.cell[end];
            const float way = 2.0f * ratio * scales.cell[end] * scales.link * face.closed, part = way / (1.0f + way);
            const glm::vec3 apart = wall - (prescribed ? given_at(given, cell) : glm::vec3(0.0f)) - glm::vec3(field[cell]);
            for (int axis = 0; axis < 3; ++axis)
                if (sticks || axis == face.axis)
                    field[cell][axis] += part * apart[axis];
        }
    }
    const std::span<const Solids::GhostSource> sources = solids_.ghost_sources();
    for (const Solids::Ghost& ghost : solids_.ghosts()) {
        glm::vec4 sum(0.0f);
        for (std::uint32_t n = ghost.first; n < ghost.first + ghost.count; ++n)
            sum += field[sources[n].cell];
        field[ghost.cell] = sum / static_cast<float>(ghost.count);
    }
}

} // namespace windrow::cpu
