#include "fluid/solids/wholes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <tuple>

namespace windrow {
namespace {

// [cells] Sides within it are sorted as equal. No round number, so that lengths people choose are hardly ever at a limit.
constexpr float k_same_side = 7.3e-3f;

} // namespace

void Wholes::find(std::span<const PlacedObstacle> bodies, float cell, bool rest_as_before) {
    bodies_ = bodies;
    cell_ = cell;
    at_rest_.clear();
    for (std::uint32_t n = 0; n < bodies.size(); ++n)
        if (!bodies[n].moves())
            at_rest_.push_back(n);
    if (!rest_as_before || at_rest_.size() != whole_at_rest_.size())
        join();
    whole_of_.assign(bodies.size(), k_none);
    for (std::size_t n = 0; n < at_rest_.size(); ++n)
        whole_of_[at_rest_[n]] = whole_at_rest_[n];
    wholes_.clear();
    for (const auto& [first, part] : firsts_) {
        wholes_.push_back(bodies[at_rest_[first]]);
        wholes_.back().position += part.from;
        wholes_.back().shape = Block{.half_size = part.half};
    }
    if (part_.capacity() < bodies.size())
        part_.reserve(2 * bodies.size());
    part_.resize(bodies.size());
    for (std::size_t n = 0; n < bodies.size(); ++n)
        if (is_part(n)) {
            const glm::vec3 middle = glm::transpose(bodies[n].axes) * (bodies[n].position - of(n).position);
            const glm::vec3 half = std::get<Block>(bodies[n].shape).half_size;
            part_[n] = {middle - half, middle + half};
        }
}

void Wholes::join() {
    const auto body = [&](std::uint32_t at_rest) -> const PlacedObstacle& { return bodies_[at_rest_[at_rest]]; };
    rows_.clear();
    for (std::uint32_t n = 0; n < at_rest_.size(); ++n)
        if (const auto* const block = std::get_if<Block>(&body(n).shape)) {
            const glm::vec3 middle = glm::transpose(body(n).axes) * body(n).position;
            rows_.push_back({middle - block->half_size, middle + block->half_size, n, n, 0, {}});
        }
    const auto kind = [&](const Row& row) {
        const glm::mat3& a = body(row.first).axes;
        return std::tuple(body(row.first).surface, a[0].x, a[0].y, a[0].z, a[1].x, a[1].y, a[1].z);
    };
    std::sort(rows_.begin(), rows_.end(), [&](const Row& a, const Row& b) { return kind(a) < kind(b); });
    for (std::size_t n = 1; n < rows_.size(); ++n)
        rows_[n].kind = rows_[n - 1].kind + (kind(rows_[n]) == kind(rows_[n - 1]) ? 0 : 1);
    next_.assign(at_rest_.size(), k_none);
    for (int axis = 0, since = 0; since < 3; axis = (axis + 1) % 3)
        since = join_along(axis) ? 0 : since + 1;
    whole_at_rest_.assign(at_rest_.size(), k_none);
    firsts_.clear();
    for (const Row& row : rows_) {
        if (row.first == row.last)
            continue;
        for (std::uint32_t n = row.first; n != k_none; n = next_[n])
            whole_at_rest_[n] = static_cast<std::uint32_t>(firsts_.size());
        const glm::vec3 middle = body(row.first).axes * (0.5f * (row.low + row.high));
        firsts_.push_back({row.first, {.half = 0.5f * (row.high - row.low), .from = middle - body(row.first).position}});
    }
}

bool Wholes::join_along(int axis) {
    const float sides_a_metre = 1.0f / (k_same_side * cell_);
    for (Row& row : rows_)
        for (int n = 0; n < 4; ++n) {
            const glm::vec3& end = n % 2 == 0 ? row.low : row.high;
            row.sides[static_cast<std::size_t>(n)] = static_cast<int>(std::lround(end[(axis + 1 + n / 2) % 3] * sides_a_metre));
        }
    const auto order = [&](const Row& row) {
        const auto& [u_low, u_high, v_low, v_high] = row.sides;
        return std::tuple(row.kind, u_low, u_high, v_low, v_high, row.low[axis], row.first);
    };
    std::sort(rows_.begin(), rows_.end(), [&](const Row& a, const Row& b) { return order(a) < order(b); });
    std::size_t count = 0;
    for (const Row& row : rows_) {
        Row* const before = count > 0 ? &rows_[count - 1] : nullptr;
        if (before == nullptr || before->kind != row.kind || before->sides != row.sides ||
            std::abs(row.low[axis] - before->high[axis]) > k_seam * cell_) {
            rows_[count++] = row;
            continue;
        }
        before->high[axis] = row.high[axis];
        next_[before->last] = row.first;
        before->last = row.last;
    }
    const bool joined = count < rows_.size();
    rows_.resize(count);
    return joined;
}

Wholes::Part Wholes::part(std::size_t body) const {
    if (!is_part(body))
        return {};
    return {std::get<Block>(of(body).shape).half_size, of(body).position - bodies_[body].position};
}

bool Wholes::is_same(const Part& a, const Part& b) const {
    const auto near = [&](glm::vec3 one, glm::vec3 other) {
        return glm::all(glm::lessThan(glm::abs(one - other), glm::vec3(k_seam * cell_)));
    };
    return near(a.half, b.half) && near(a.from, b.from);
}

bool Wholes::is_anothers(std::size_t body, glm::vec3 place) const {
    if (!is_part(body))
        return false;
    const PlacedObstacle& whole = of(body);
    const glm::vec3 half = std::get<Block>(whole.shape).half_size, nearest = glm::clamp(place, -half, half);
    const auto outside = [&](std::size_t part) { // [m]
        const glm::vec3 away = glm::max(part_[part].low - nearest, nearest - part_[part].high);
        return std::max({away.x, away.y, away.z});
    };
    const float seam = k_seam * cell_, own = outside(body);
    if (std::abs(own) > seam)
        return own > 0.0f;
    for (std::size_t other = 0; other < body; ++other)
        if (whole_of_[other] == whole_of_[body] && outside(other) <= seam)
            return true;
    return false;
}

} // namespace windrow
