// Based on: Batty, Bertails & Bridson 2007, ACM Transactions on Graphics 26; Ng, Min & Gibou 2009, Journal of Computational Physics
// 228 (fractions of faces). Flux, slope and diffusion: shaders/numerics/closed_face.glsl, slip: slip.glsl. The
// projection that uses them: pressure.cpp, solve_around; its equation: fluid/solids/solids.h.
#include "fluid/cpu/solid_flow.h"

#include "fluid/core/numerics.h"
#include "fluid/cpu/kernels/kernels.h"
#include "fluid/grid/box_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <span>
#include <vector>

namespace windrow::cpu {

namespace {

// Factors of a face beside those of cubes: on what the operator takes from the slope over it, and on what passes it into its cells.
struct FaceScales {
    float link = 1.0f, cell[2] = {1.0f, 1.0f};
};

FaceScales scales_in(const RowTable& rows, const ClosedFace& face) {
    if (face.axis != 1)
        return {};
    const std::size_t low = face.place[1];
    if (face.ends_box())
        return {.link = 1.0f, .cell = {rows.scales()[low], rows.scales()[low]}};
    return {.link = rows.links()[low + 1], .cell = {rows.scales()[low], rows.scales()[low + 1]}};
}

// visit(n, face, scales) for each: in cubes the factors are constants, which cost nothing.
template <class Visit>
void for_each_face(const Box& box, std::span<const ClosedFace> faces, const Visit& visit) {
    if (box.rows)
        for (std::size_t n = 0; n < faces.size(); ++n)
            visit(n, faces[n], scales_in(*box.rows, faces[n]));
    else
        for (std::size_t n = 0; n < faces.size(); ++n)
            visit(n, faces[n], FaceScales{});
}

float slope_over(const ClosedFace& face, const float* potential) {
    return numerics::windrow_closed_slope(face.closed, potential[face.potential[0]], potential[face.potential[1]]);
}

// Where fields hold the cells of the lists.
struct Unmoved {
    [[nodiscard]] std::uint32_t place_of(std::uint32_t cell) const { return cell; }
    [[nodiscard]] bool holds(std::uint32_t, std::span<const Solids::GhostSource>) const { return true; }
};

constexpr std::uint32_t k_nowhere = ~std::uint32_t{0};

// The box has moved since. The fourth component of a velocity marks ghosts that lack some of their sources.
struct Moved {
    static constexpr float k_missing = 4.0f; // in a fourth component, beyond any lee
    const Solids& solids;
    const Box& box;
    glm::ivec3 shift;
    std::span<glm::vec4> velocity;

    [[nodiscard]] std::uint32_t place_of(std::uint32_t cell) const {
        const glm::ivec3 place = solids.place_of(cell) - shift;
        return glm::all(glm::greaterThanEqual(place, glm::ivec3(0))) && glm::all(glm::lessThan(place, box.cells))
                   ? static_cast<std::uint32_t>(box.index(place.x, place.y, place.z))
                   : k_nowhere;
    }
    [[nodiscard]] bool holds(std::uint32_t ghost, std::span<const Solids::GhostSource> sources) const {
        if (ghost == k_nowhere)
            return false;
        const bool all = std::all_of(sources.begin(), sources.end(), [&](const Solids::GhostSource& source) {
            const std::uint32_t from = place_of(source.cell);
            return from != k_nowhere && velocity[from].w < k_missing;
        });
        if (!all)
            velocity[ghost].w = k_missing;
        return all;
    }
};

// Of velocities and, as the third field, the history.
constexpr auto k_walls = [](const Solids::GhostSource& source, std::size_t field) { return field == 2 ? 0.0f : source.wall; };

// `push` holds the sum of the potential over its surface.
PressurePush finished(PressurePush push, float cell_size) {
    if (push.wetted > 0.0)
        push.potential *= static_cast<double>(cell_size) / push.wetted;
    return push;
}

} // namespace

glm::vec3 SolidFlow::ambient_at(const PrescribedFlow& prescribed, std::uint32_t cell) const {
    const float* const around = prescribed.ambient + 4 * padded_index(box_.cells, solids_.place_of(cell));
    return {around[0], around[1], around[2]};
}

glm::vec3 SolidFlow::prescribed_at(const PrescribedFlow& prescribed, std::uint32_t cell) const {
    return solids_.is_sheltered(cell) ? glm::vec3(0.0f) : ambient_at(prescribed, cell);
}

// Fields in one pass over the lists, which are long. across(source, field): the velocity of the wall along a source's normal. `map`
// returns where the fields hold a cell of the lists; a ghost without all of its sources keeps its value.
template <std::size_t Count, class Across, class Map>
void SolidFlow::extend_by(const std::array<std::span<glm::vec4>, Count>& fields, const Across& across, const Map& map) const {
    const std::span<const Solids::GhostSource> sources = solids_.ghost_sources();
    for (const Solids::Ghost& ghost : solids_.ghosts()) {
        const auto of_ghost = sources.subspan(ghost.first, ghost.count);
        const std::uint32_t to = map.place_of(ghost.cell);
        if (!map.holds(to, of_ghost))
            continue;
        std::array<glm::vec4, Count> sums{};
        for (const Solids::GhostSource& source : of_ghost) {
            const bool slips = source.normal != glm::vec3(0.0f); // in the first layer, which comes first
            const std::uint32_t from = map.place_of(source.cell);
            for (std::size_t field = 0; field < Count; ++field) {
                const glm::vec4 value = fields[field][from];
                sums[field] +=
                    slips ? glm::vec4(numerics::windrow_slipped(glm::vec3(value), source.normal, across(source, field)), value.w)
                          : value;
            }
        }
        for (std::size_t field = 0; field < Count; ++field)
            fields[field][to] = ghost.count > 1 ? sums[field] / static_cast<float>(ghost.count) : sums[field];
    }
}

void SolidFlow::extend(std::span<glm::vec4> velocity, const PrescribedFlow& prescribed) const {
    const bool any = prescribed.any();
    extend_by(
        std::array{velocity},
        [&](const Solids::GhostSource& source, std::size_t) {
            return source.wall - (any ? glm::dot(prescribed_at(prescribed, source.cell), source.normal) : 0.0f);
        },
        Unmoved{});
}

void SolidFlow::extend_history(std::span<glm::vec4> history) const {
    extend_by(
        std::array{history}, [](const Solids::GhostSource&, std::size_t) { return 0.0f; }, Unmoved{});
}

void SolidFlow::extend_all(std::span<glm::vec4> velocity, std::span<glm::vec4> before, std::span<glm::vec4> history) const {
    extend_by(std::array{velocity, before, history}, k_walls, Unmoved{});
}

void SolidFlow::extend_moved(std::span<glm::vec4> velocity, std::span<glm::vec4> before, std::span<glm::vec4> history,
                             glm::ivec3 shift) const {
    const Moved map{solids_, box_, shift, velocity};
    if (history.empty())
        extend_by(std::array{velocity}, k_walls, map);
    else
        extend_by(std::array{velocity, before, history}, k_walls, map);
    for (const Solids::Ghost& ghost : solids_.ghosts())
        if (const std::uint32_t at = map.place_of(ghost.cell); at != k_nowhere && velocity[at].w >= Moved::k_missing)
            velocity[at].w = 0.0f;
}

void SolidFlow::close_divergence(std::span<const glm::vec4> velocity, const PrescribedFlow& prescribed, bool bodies_move,
                                 std::span<const float> guess, float factor, float* potential, std::span<float> guessed) const {
    std::fill(guessed.begin(), guessed.end(), 0.0f);
    for (const Solids::InsideCell& cell : solids_.inside())
        if (cell.shut)
            potential[cell.potential] = 0.0f;
    const bool any = prescribed.any(), rooms = any && !solids_.rooms().empty();
    for_each_face(box_, solids_.faces(), [&](std::size_t n, const ClosedFace& face, const FaceScales& scales) {
        float both = velocity[face.cell[0]][face.axis] + velocity[face.cell[1]][face.axis];
        if (any)
            both += ambient_at(prescribed, face.cell[0])[face.axis] + ambient_at(prescribed, face.cell[1])[face.axis];
        const float flux = numerics::windrow_closed_flux(face.closed, both, bodies_move ? face.wall : 0.0f);
        for (int end = 0; end < 2; ++end)
            if (!face.shut[end])
                potential[face.potential[end]] += (end == 0 ? -scales.cell[end] : scales.cell[end]) *
                                                  (flux - (rooms ? blown_past(prescribed, face, end) : 0.0f));
        const float passed = factor > 0.0f ? factor * (scales.link * guess[n]) : 0.0f;
        guessed[face.surface[0]] += scales.cell[0] * passed;
        guessed[face.surface[1]] -= scales.cell[1] * passed;
    });
    if (bodies_move)
        spread_changes(potential);
}

void SolidFlow::spread_changes(float* divergence) const {
    if (solids_.other_change() != 0.0f)
        for (std::uint32_t n = 0; n < box_.cell_count(); ++n)
            divergence[solids_.potential_of(solids_.place_of(n))] -= solids_.change_in(n);
    else
        for (const std::uint32_t cell : solids_.sealed_cells())
            divergence[solids_.potential_of(solids_.place_of(cell))] -= solids_.change_in(cell);
}

namespace {

// Takes the mean of values by volume off in each sealed part, whose numbers of `all` end at a member of it.
template <class VolumeOf, class ValueOf>
void take_means(std::span<const Solids::SealedPart> parts, std::uint32_t Solids::SealedPart::*end,
                std::span<const std::uint32_t> all, const VolumeOf& volume_of, const ValueOf& value_of) {
    std::size_t first = 0;
    for (const Solids::SealedPart& part : parts) {
        const auto numbers = all.subspan(first, part.*end - first);
        double sum = 0.0, whole = 0.0;
        for (const std::uint32_t n : numbers) {
            const auto volume = static_cast<double>(volume_of(n));
            sum += volume * static_cast<double>(value_of(n));
            whole += volume;
        }
        const auto mean = static_cast<float>(sum / whole);
        for (const std::uint32_t n : numbers)
            value_of(n) -= mean;
        first = part.*end;
    }
}

} // namespace

void SolidFlow::level(float* potential) const {
    take_means(
        solids_.sealed_parts(), &Solids::SealedPart::end, solids_.sealed_cells(),
        [&](std::uint32_t cell) { return box_.volume(solids_.place_of(cell).y); },
        [&](std::uint32_t cell) -> float& { return potential[solids_.potential_of(solids_.place_of(cell))]; });
}

void SolidFlow::balance(std::span<float> residual) const {
    take_means(
        solids_.sealed_parts(), &Solids::SealedPart::surface_end, solids_.sealed_surface(),
        [&](std::uint32_t n) { return solids_.surface()[n].volume; }, [&](std::uint32_t n) -> float& { return residual[n]; });
}

// Of a face's flux, in the cell at one end.
float SolidFlow::blown_past(const PrescribedFlow& prescribed, const ClosedFace& face, int end) const {
    if (!solids_.is_sheltered(face.cell[end]))
        return 0.0f;
    const std::uint32_t here = face.cell[end], other = face.cell[1 - end];
    const float beyond = ambient_at(prescribed, other)[face.axis];
    const float both = ambient_at(prescribed, here)[face.axis] + beyond;
    return numerics::windrow_blown_past(face.closed, both, beyond, solids_.is_sheltered(other));
}

void SolidFlow::closed_slopes(const float* potential, std::span<float> slope) const {
    const std::span<const ClosedFace> faces = solids_.faces();
    for (std::size_t n = 0; n < faces.size(); ++n)
        slope[n] = slope_over(faces[n], potential);
}

void SolidFlow::add_masked(std::span<const float> slope, float factor, std::span<float> terms) const {
    for_each_face(box_, solids_.faces(), [&](std::size_t n, const ClosedFace& face, const FaceScales& scales) {
        const float passed = factor * (scales.link * slope[n]);
        terms[face.surface[0]] += scales.cell[0] * passed;
        terms[face.surface[1]] -= scales.cell[1] * passed;
    });
}

void SolidFlow::find_residual(const float* potential, std::span<const float> guess, float factor, std::span<float> slope,
                              std::span<float> residual) const {
    std::fill(residual.begin(), residual.end(), 0.0f);
    for_each_face(box_, solids_.faces(), [&](std::size_t n, const ClosedFace& face, const FaceScales& scales) {
        const float here = slope_over(face, potential);
        slope[n] = here;
        const float passed = scales.link * (factor > 0.0f ? here - factor * guess[n] : here);
        residual[face.surface[0]] += scales.cell[0] * passed;
        residual[face.surface[1]] -= scales.cell[1] * passed;
    });
}

void SolidFlow::open_gradient(std::span<const float> slope, std::span<glm::vec4> velocity, std::span<glm::vec4> note,
                              float weight) const {
    for_each_face(box_, solids_.faces(), [&](std::size_t n, const ClosedFace& face, const FaceScales& scales) {
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t cell = face.cell[end];
            const float fix = 0.5f * scales.cell[end] * slope[n];
            velocity[cell][face.axis] += fix;
            if (!note.empty())
                note[cell][face.axis] -= weight * fix;
        }
    });
}

void SolidFlow::hold_bodies(const PrescribedFlow& prescribed, bool bodies_move, std::span<glm::vec4> velocity) const {
    const bool any = prescribed.any();
    const std::span<const PlacedObstacle> bodies = solids_.bodies();
    const bool moving = bodies_move && std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.moves(); });
    for (const Solids::InsideCell& cell : solids_.inside()) {
        glm::vec3 u(0.0f);
        if (moving && bodies[cell.body].moves())
            u = bodies[cell.body].velocity_at(box_.metres(glm::vec3(solids_.place_of(cell.cell)) + 0.5f));
        if (any)
            u -= prescribed_at(prescribed, cell.cell);
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

void SolidFlow::find_flux(std::span<const glm::vec4> velocity, std::span<float> flux) const {
    std::fill(flux.begin(), flux.end(), 0.0f);
    for_each_face(box_, solids_.faces(), [&](std::size_t, const ClosedFace& face, const FaceScales& scales) {
        const float both = velocity[face.cell[0]][face.axis] + velocity[face.cell[1]][face.axis];
        const float passed = numerics::windrow_closed_flux(face.closed, both, face.wall);
        if (!face.shut[0])
            flux[face.surface[0]] -= scales.cell[0] * passed;
        if (!face.shut[1])
            flux[face.surface[1]] += scales.cell[1] * passed;
    });
}

void SolidFlow::find_divergence(std::span<const glm::vec4> velocity, std::span<float> flux, std::span<float> divergence) const {
    find_flux(velocity, flux);
    const std::span<const Solids::SurfaceCell> cells = solids_.surface();
    for (std::size_t n = 0; n < cells.size(); ++n)
        divergence[cells[n].cell] = (central_divergence(velocity, cells[n]) + flux[n]) / box_.cell_size;
    for (const Solids::InsideCell& cell : solids_.inside())
        divergence[cell.cell] = 0.0f;
}

double SolidFlow::correct_divergence(std::span<const glm::vec4> velocity, std::span<const float> expansion,
                                     std::span<float> flux) const {
    find_flux(velocity, flux);
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

PressurePush SolidFlow::push_on(std::size_t body, const float* potential) const {
    std::vector<PressurePush> pushes(solids_.bodies().size());
    find_pushes(potential, pushes);
    return pushes[body];
}

// Without a choice by axis or by what is shut, which differ from face to face.
void SolidFlow::find_pushes(const float* potential, std::span<PressurePush> pushes) const {
    constexpr glm::dvec3 k_axes[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    const double h = static_cast<double>(box_.cell_size);
    glm::dvec3 period(0.0); // [m] 0: not periodic
    for (int axis = 0; axis < 3; ++axis)
        if (box_.boundaries.periodic(axis))
            period[axis] = h * box_.cells[axis];
    const bool periodic = period != glm::dvec3(0.0);
    // [m] To a place [cells] from a body's position, from its nearest image.
    const auto arm_to = [&](const glm::dvec3& place, const glm::dvec3& position) {
        glm::dvec3 arm = h * place - position;
        if (box_.rows)
            arm.y = box_.rows->height_at(place.y) - position.y;
        if (periodic)
            for (int along = 0; along < 3; ++along)
                if (period[along] > 0.0)
                    arm[along] -= period[along] * std::round(arm[along] / period[along]);
        return arm;
    };
    std::fill(pushes.begin(), pushes.end(), PressurePush{});
    const std::span<const ClosedFace> all = solids_.faces();
    for (std::size_t n = 0; n < all.size();) { // those of a body that follow each other, in registers
        const std::uint16_t body = all[n].body;
        const glm::dvec3 position(solids_.bodies()[body].position);
        PressurePush push;
        for (; n < all.size() && all[n].body == body; ++n) {
            const ClosedFace& face = all[n];
            const glm::dvec3& axis = k_axes[face.axis];
            double area = static_cast<double>(face.closed); // over that of a cube's face
            if (box_.rows)
                area *= face.axis == 1 ? 1.0 : static_cast<double>(box_.volume(face.place[1]));
            const glm::dvec3 arm = arm_to(glm::dvec3(face.place[0], face.place[1], face.place[2]) + 0.5 + 0.5 * axis, position);
            const double low = face.shut[0] ? 0.0 : area, high = face.shut[1] ? 0.0 : area;
            const double below = low * static_cast<double>(potential[face.potential[0]]),
                         above = high * static_cast<double>(potential[face.potential[1]]);
            const glm::dvec3 impulse = (h * h * h * (below - above)) * axis;
            push += {.impulse = impulse, .twist = glm::cross(arm, impulse), .potential = below + above, .wetted = low + high};
        }
        pushes[body] += push;
    }
    for (const Solids::OpenSide& side : solids_.open_sides()) { // less what cells inside take
        const double slope =
            static_cast<double>(potential[side.potential[1]]) - static_cast<double>(potential[side.potential[0]]);
        const glm::dvec3 impulse = (-h * h * h * static_cast<double>(side.weight) * slope) * k_axes[side.axis];
        const glm::dvec3 arm =
            arm_to(glm::dvec3(solids_.place_of(side.inside)) + 0.5, glm::dvec3(solids_.bodies()[side.body].position));
        pushes[side.body] += {.impulse = impulse, .twist = glm::cross(arm, impulse)};
    }
    for (PressurePush& push : pushes)
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

void SolidFlow::close_diffusion(std::span<const glm::vec4> field, const PrescribedFlow& prescribed, float ratio,
                                std::span<glm::vec4> result) const {
    const bool any = prescribed.any();
    for_each_face(box_, solids_.faces(), [&](std::size_t, const ClosedFace& face, const FaceScales& scales) {
        const bool sticks = solids_.bodies()[face.body].surface == Surface::no_slip;
        const glm::vec3 wall = wall_at(face);
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t cell = face.cell[end];
            const glm::vec3 flux = numerics::windrow_wall_flux(face.facing[end], face.closed, sticks, face.axis,
                                                               glm::vec3(field[cell]), glm::vec3(field[face.cell[1 - end]]),
                                                               wall - (any ? prescribed_at(prescribed, cell) : glm::vec3(0.0f)));
            result[cell] += glm::vec4(ratio * scales.cell[end] * scales.link * flux, 0.0f);
        }
    });
}

void SolidFlow::drag_along_walls(const PrescribedFlow& prescribed, float ratio, std::span<glm::vec4> field) const {
    const bool any = prescribed.any();
    for_each_face(box_, solids_.faces(), [&](std::size_t, const ClosedFace& face, const FaceScales& scales) {
        const bool sticks = solids_.bodies()[face.body].surface == Surface::no_slip;
        const glm::vec3 wall = wall_at(face);
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t cell = face.cell[end];
            const float way = 2.0f * ratio * scales.cell[end] * scales.link * face.facing[end];
            field[cell] =
                glm::vec4(numerics::windrow_wall_dragged(way, sticks, face.axis, glm::vec3(field[cell]),
                                                         wall - (any ? prescribed_at(prescribed, cell) : glm::vec3(0.0f))),
                          field[cell].w);
        }
    });
    const std::span<const Solids::GhostSource> sources = solids_.ghost_sources();
    for (const Solids::Ghost& ghost : solids_.ghosts()) {
        glm::vec4 sum(0.0f);
        for (std::uint32_t n = ghost.first; n < ghost.first + ghost.count; ++n)
            sum += field[sources[n].cell];
        field[ghost.cell] = sum / static_cast<float>(ghost.count);
    }
}

} // namespace windrow::cpu
