#include "fluid/vulkan/solid_tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>

namespace windrow::vulkan {
namespace {

constexpr std::uint32_t k_none = ~std::uint32_t{0};
constexpr std::uint8_t k_out_of_reach = 255;

std::int32_t word(float value) {
    return std::bit_cast<std::int32_t>(value);
}
std::int32_t word(std::uint32_t value) {
    return static_cast<std::int32_t>(value);
}

} // namespace

SolidTables::SolidTables(const Box& box, float max_cfl, bool loads)
    : box_(box), loads_(loads), farthest_(static_cast<int>(std::min(std::ceil(1.5f * max_cfl), 4.0f)) + 2),
      solids_(box, box.cells.x), ghost_of_(box.cell_count(), k_none), reaches_(box.cell_count()), smeared_(box.cell_count()) {
    static_assert(WINDROW_FARTHEST_REACH == 6 && WINDROW_BYTE_REACH_SHIFT == 5, "a reach takes three bits");
}

int SolidTables::flags() const {
    if (!solids_.any())
        return 0;
    const auto bodies = solids_.bodies();
    const bool moves = std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.moves(); });
    return WINDROW_OBSTACLES | (solids_.rooms().empty() ? 0 : WINDROW_ROOMS) | (solids_.any_thin() ? WINDROW_THIN : 0) |
           (moves ? WINDROW_BODIES_MOVE : 0);
}

void SolidTables::begin_anew(const Box& box, bool keeps_faces) {
    solids_ = Solids(box, box.cells.x);
    box_ = box;
    if (!keeps_faces)
        keys_.clear();
}

void SolidTables::place(std::span<const detail::PlacedObstacle> obstacles, glm::ivec3 shift) {
    solids_.place(obstacles, shift);
    keys_before_.swap(keys_);
    words_.assign(sizeof(WindrowSolids) / sizeof(std::int32_t), 0);
    flatten_ghosts();
    add_records();
    add_faces();
    add_bodies();
    add_surface();
    add_rooms(shift);
    add_sealed();
    add_bytes();
    add_origins(shift);
    if (loads_)
        add_loads();
    for (const Solids::Ghost& ghost : solids_.ghosts())
        ghost_of_[ghost.cell] = k_none;
}

std::span<const std::byte> SolidTables::bytes() {
    std::memcpy(words_.data(), &head_, sizeof(head_));
    return std::as_bytes(std::span(words_));
}

// Ghosts further inside take the mean of those before them: in the end all is air.
void SolidTables::flatten_ghosts() {
    terms_.clear();
    first_terms_.clear();
    const auto sources = solids_.ghost_sources();
    std::uint32_t number = 0;
    for (const Solids::Ghost& ghost : solids_.ghosts()) {
        const std::size_t first = terms_.size();
        first_terms_.push_back(static_cast<std::uint32_t>(first));
        const auto add_term = [&](const Term& term) {
            const auto same =
                std::find_if(terms_.begin() + static_cast<std::ptrdiff_t>(first), terms_.end(),
                             [&](const Term& other) { return other.cell == term.cell && other.normal == term.normal; });
            if (same == terms_.end())
                return terms_.push_back(term);
            const float weight = same->weight + term.weight; // a body that turns has another speed at each place
            same->wall += term.weight / weight * (term.wall - same->wall);
            same->weight = weight;
        };
        const float part = 1.0f / static_cast<float>(ghost.count);
        for (const Solids::GhostSource& source : sources.subspan(ghost.first, ghost.count)) {
            const std::uint32_t before = ghost_of_[source.cell];
            if (before == k_none) {
                add_term({source.cell, part, source.normal, source.wall});
                continue;
            }
            for (std::uint32_t n = first_terms_[before]; n < first_terms_[before + 1]; ++n) {
                Term term = terms_[n];
                term.weight *= part;
                add_term(term);
            }
        }
        ghost_of_[ghost.cell] = number++;
    }
    first_terms_.push_back(static_cast<std::uint32_t>(terms_.size()));
}

void SolidTables::add_records() {
    cells_.clear();
    for (const auto& cell : solids_.surface())
        cells_.push_back(cell.cell);
    for (const auto& cell : solids_.inside())
        cells_.push_back(cell.cell);
    cells_.insert(cells_.end(), solids_.sheltered().begin(), solids_.sheltered().end());
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());

    const auto width = static_cast<std::uint32_t>(box_.cells.x);
    const auto rows = static_cast<std::uint32_t>(box_.cells.y * box_.cells.z);
    const int rows_at = here();
    std::uint32_t next = 0;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        while (next < cells_.size() && cells_[next] < row * width)
            ++next;
        words_.push_back(word(next));
    }
    const int columns_at = here();
    for (const std::uint32_t cell : cells_)
        words_.push_back(word(cell % width));

    const int records_at = here();
    auto inside = solids_.inside().begin();
    auto surface = solids_.surface().begin();
    for (const std::uint32_t cell : cells_) {
        while (inside != solids_.inside().end() && inside->cell < cell)
            ++inside;
        while (surface != solids_.surface().end() && surface->cell < cell)
            ++surface;
        const bool within = inside != solids_.inside().end() && inside->cell == cell;
        const bool at_surface = surface != solids_.surface().end() && surface->cell == cell;
        std::int32_t flags = solids_.is_sheltered(cell) ? WINDROW_SHELTERED : 0;
        if (within)
            flags |= WINDROW_INSIDE | (inside->shut ? WINDROW_SHUT : 0) | inside->body << WINDROW_BODY_SHIFT;
        if (solids_.in_room(cell))
            flags |= WINDROW_ROOM;
        words_.push_back(flags);
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                std::uint32_t low = cell;
                const bool there = side > 0 || solids_.low_neighbour(cell, axis, low);
                const ClosedFace* const face = there ? solids_.face(low, axis) : nullptr;
                words_.push_back(face == nullptr ? -1 : static_cast<std::int32_t>(face - solids_.faces().data()));
            }
        const std::uint32_t ghost = ghost_of_[cell];
        words_.push_back(ghost == k_none ? 0 : word(first_terms_[ghost]));
        words_.push_back(ghost == k_none ? 0 : word(first_terms_[ghost + 1] - first_terms_[ghost]));
        words_.push_back(at_surface ? static_cast<std::int32_t>(surface - solids_.surface().begin()) : -1);
        words_.push_back(word(solids_.change_in(cell)));
    }
    const std::span<std::int32_t> records = std::span(words_).last(static_cast<std::size_t>(here() - records_at));
    for (const ClosedFace& face : solids_.end_faces()) { // of one cell alone
        const auto record = std::lower_bound(cells_.begin(), cells_.end(), face.cell[0]) - cells_.begin();
        const std::ptrdiff_t of_face = 1 + 2 * face.axis + (face.shut[1] ? 1 : 0);
        records[static_cast<std::size_t>(WINDROW_RECORD * record + of_face)] =
            static_cast<std::int32_t>(&face - solids_.faces().data());
    }
    const int terms_at = here();
    for (const Term& term : terms_)
        for (const std::int32_t each :
             {word(term.cell), word(term.weight), word(term.normal.x), word(term.normal.y), word(term.normal.z), word(term.wall)})
            words_.push_back(each);
    head_.rows = rows_at;
    head_.columns = columns_at;
    head_.records = records_at;
    head_.terms = terms_at;
}

void SolidTables::add_faces() {
    const int at = here();
    for (const ClosedFace& face : solids_.faces()) {
        int flags = face.axis;
        for (int end = 0; end < 2; ++end)
            flags |= (solids_.is_sheltered(face.cell[end]) ? WINDROW_LOW_SHELTERED << end : 0) |
                     (face.shut[end] ? WINDROW_LOW_SHUT << end : 0);
        if (solids_.bodies()[face.body].surface == Surface::no_slip)
            flags |= WINDROW_FACE_NO_SLIP;
        for (const std::int32_t each :
             {word(face.cell[0]), word(face.cell[1]), word(face.surface[0]), word(face.surface[1]), word(face.closed),
              word(face.wall), flags, std::int32_t{face.body}, word(face.facing[0]), word(face.facing[1])})
            words_.push_back(each);
    }
    head_.faces = at;
    head_.face_count = static_cast<int>(solids_.faces().size());
}

void SolidTables::add_bodies() {
    const int at = here();
    for (const detail::PlacedObstacle& body : solids_.bodies())
        for (const glm::vec3& each : {body.velocity, body.spin, body.position})
            for (int axis = 0; axis < 3; ++axis)
                words_.push_back(word(each[axis]));
    head_.bodies = at;
}

void SolidTables::add_surface() {
    const int at = here();
    std::size_t record = 0;
    for (const auto& cell : solids_.surface()) {
        while (cells_[record] < cell.cell)
            ++record;
        words_.push_back(head_.records + WINDROW_RECORD * static_cast<int>(record));
        words_.push_back(word(cell.cell));
    }
    head_.surface = at;
    head_.surface_count = static_cast<int>(solids_.surface().size());
}

void SolidTables::add_rooms(glm::ivec3 shift) {
    const int at = here();
    std::size_t first = 0;
    for (const std::uint32_t end : solids_.room_ends()) {
        const auto cells = solids_.rooms().subspan(first, end - first);
        const bool came_in =
            std::any_of(cells.begin(), cells.end(), [&](std::uint32_t cell) { return solids_.came_in(cell, shift); });
        words_.push_back(word(end));
        words_.push_back((came_in ? WINDROW_ROOM_CAME_IN : 0) | (solids_.walls_move(cells) ? WINDROW_ROOM_WALLS_MOVE : 0));
        first = end;
    }
    head_.rooms = at;
    head_.room_count = static_cast<int>(solids_.room_ends().size());
    head_.room_cells = here();
    for (const std::uint32_t cell : solids_.rooms())
        words_.push_back(word(cell));
}

void SolidTables::add_sealed() {
    head_.parts = here();
    for (const Solids::SealedPart& part : solids_.sealed_parts()) {
        words_.push_back(word(part.end));
        words_.push_back(word(part.surface_end));
    }
    const auto add = [&](std::span<const std::uint32_t> list) {
        const int at = here();
        words_.insert(words_.end(), list.begin(), list.end());
        return at;
    };
    head_.part_cells = add(solids_.sealed_cells());
    head_.part_surface = add(solids_.sealed_surface());
    head_.part_count = static_cast<int>(solids_.sealed_parts().size());
    head_.other_change = solids_.other_change();
}

// --- One-sided reads ---------------------------------------------------------------------------------------------------------

// The reach from which the reads of each cell are one-sided, as Solids::reach_past_thin: the least r for which a face of a body
// thinner than r is not farther than r away. Distances are largest components, so that the axes are done one after another.
void SolidTables::find_reaches() {
    std::fill(reaches_.begin(), reaches_.end(), k_out_of_reach);
    glm::ivec3 low = box_.cells, high(-1);
    for (const ClosedFace& face : solids_.faces()) {
        const float thickness = solids_.thicknesses()[face.body];
        if (thickness >= static_cast<float>(farthest_))
            continue;
        const auto from = static_cast<std::uint8_t>(std::floor(thickness) + 1.0f);
        for (const std::uint32_t cell : face.cell)
            if (!solids_.inside(cell)) {
                reaches_[cell] = std::min(reaches_[cell], from);
                low = glm::min(low, solids_.place_of(cell));
                high = glm::max(high, solids_.place_of(cell));
            }
    }
    if (high.x < 0)
        return;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = box_.boundaries.periodic(axis) ? 0 : std::max(low[axis] - farthest_, 0);
        high[axis] =
            box_.boundaries.periodic(axis) ? box_.cells[axis] - 1 : std::min(high[axis] + farthest_, box_.cells[axis] - 1);
    }
    const auto row_of = [&](std::vector<std::uint8_t>& field, int j, int k) { return field.data() + box_.index(0, j, k); };
    for (int axis = 0; axis < 3; ++axis) {
        smeared_ = reaches_;
        for (int k = low.z; k <= high.z; ++k)
            for (int j = low.y; j <= high.y; ++j)
                for (int step = -farthest_; step <= farthest_; ++step) {
                    const auto distance = static_cast<std::uint8_t>(std::abs(step));
                    glm::ivec3 from(0, j, k);
                    from[axis] += step;
                    const int count = box_.cells[axis];
                    if (axis > 0 && box_.boundaries.periodic(axis))
                        from[axis] = (from[axis] % count + count) % count;
                    if (axis > 0 && (from[axis] < 0 || from[axis] >= count))
                        continue;
                    std::uint8_t* const to = row_of(smeared_, j, k);
                    const std::uint8_t* const source = row_of(reaches_, from.y, from.z);
                    if (axis > 0) {
                        for (int i = low.x; i <= high.x; ++i)
                            to[i] = std::min(to[i], std::max(source[i], distance));
                        continue;
                    }
                    for (int i = std::max(low.x, -step); i <= std::min(high.x, count - 1 - step); ++i)
                        to[i] = std::min(to[i], std::max(source[i + step], distance));
                    if (!box_.boundaries.periodic(0))
                        continue;
                    for (int i = low.x; i <= high.x; ++i)
                        if (i + step < 0 || i + step >= count)
                            to[i] = std::min(to[i], std::max(source[((i + step) % count + count) % count], distance));
                }
        reaches_.swap(smeared_);
    }
}

void SolidTables::add_bytes() {
    const bool thin = solids_.any_thin();
    if (thin)
        find_reaches();
    head_.thinnest = solids_.thinnest();
    head_.farthest = farthest_;
    head_.bytes = here();
    if (!thin && solids_.rooms().empty())
        return; // none reads them
    const std::size_t count = box_.cell_count(), at = words_.size();
    words_.resize(at + (count + 3) / 4, 0);
    auto* const bytes = reinterpret_cast<std::uint8_t*>(words_.data() + at);
    for (std::uint32_t n = 0; n < count; ++n) {
        unsigned byte = 0;
        for (int axis = 0; axis < 3; ++axis)
            byte |= solids_.blocked(n, axis) ? 1u << axis : 0u;
        byte |= solids_.inside(n) ? unsigned{WINDROW_BYTE_INSIDE} : 0u;
        byte |= solids_.in_room(n) ? unsigned{WINDROW_BYTE_ROOM} : 0u;
        if (thin && reaches_[n] <= farthest_)
            byte |= unsigned{reaches_[n]} << WINDROW_BYTE_REACH_SHIFT;
        bytes[n] = static_cast<std::uint8_t>(byte);
    }
}

// --- The pressure's history --------------------------------------------------------------------------------------------------

void SolidTables::add_origins(glm::ivec3 shift) {
    head_.before = here();
    solids_.name_faces(keys_);
    solids_.find_origins(keys_before_, shift, origins_);
    words_.insert(words_.end(), origins_.begin(), origins_.end());
}

// --- Forces ------------------------------------------------------------------------------------------------------------------

void SolidTables::add_loads() {
    const auto bodies = solids_.bodies();
    head_.body_count = static_cast<int>(bodies.size());
    // Of each body, where its items begin, and behind the last the end; then the items, one body after another.
    const auto list_by_body = [&](const auto& items, std::size_t words_each, std::int32_t& starts, std::int32_t& list,
                                  const auto& write) {
        body_starts_.assign(bodies.size() + 1, 0);
        for (const auto& item : items)
            ++body_starts_[item.body + std::size_t{1}];
        for (std::size_t n = 0; n < bodies.size(); ++n)
            body_starts_[n + 1] += body_starts_[n];
        starts = here();
        words_.insert(words_.end(), body_starts_.begin(), body_starts_.end());
        list = here();
        const std::size_t first = words_.size();
        words_.resize(first + words_each * items.size());
        for (const auto& item : items)
            write(item, &words_[first + words_each * static_cast<std::size_t>(body_starts_[item.body]++)]);
    };
    list_by_body(solids_.faces(), 1, head_.body_faces, head_.body_list, [&](const ClosedFace& face, std::int32_t* to) {
        *to = static_cast<std::int32_t>(&face - solids_.faces().data());
    });
    list_by_body(solids_.open_sides(), WINDROW_OPEN_SIDE, head_.body_open, head_.open_list,
                 [](const Solids::OpenSide& side, std::int32_t* to) {
                     const std::int32_t each[WINDROW_OPEN_SIDE] = {word(side.cell[0]), word(side.cell[1]), word(side.inside),
                                                                   std::int32_t{side.axis}, word(side.weight)};
                     std::copy(std::begin(each), std::end(each), to);
                 });

    names_before_.swap(names_);
    names_.clear();
    by_slot_.clear();
    for (std::size_t n = 0; n < names_before_.size(); ++n) {
        by_slot_.resize(std::max(by_slot_.size(), std::size_t{names_before_[n].first} + 1), -1);
        by_slot_[names_before_[n].first] = static_cast<std::int32_t>(n);
    }
    head_.bodies_before = here();
    for (const detail::PlacedObstacle& body : bodies) {
        names_.emplace_back(body.slot, body.generation);
        const std::int32_t before = body.slot < by_slot_.size() ? by_slot_[body.slot] : -1;
        const bool same = before >= 0 && names_before_[static_cast<std::size_t>(before)] == names_.back();
        words_.push_back(same ? before : -1);
    }
}

} // namespace windrow::vulkan
