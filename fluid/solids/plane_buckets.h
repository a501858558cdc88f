// Boxes in a level plane, by place: what is near a place is found without a look at all. Each box is in all squares that it
// touches; squares are as large as the mean box, so that each is in few.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace windrow {

class PlaneBuckets {
  public:
    /// [m] The first is at `low`, the last at `high`; it holds what it touches.
    struct Rectangle {
        glm::vec2 low{0.0f}, high{0.0f};
    };

    void clear() {
        squares_ = glm::ivec2(1);
        low_ = squares_a_metre_ = glm::vec2(0.0f);
        ends_.assign(2, 0);
        in_squares_.clear();
        first_squares_.clear();
    }

    /// Of `count` boxes; rectangle_of(n) is that of box n. `slack` [m]: beyond a box it is still found.
    template <class RectangleOf>
    void fill(std::size_t count, float slack, const RectangleOf& rectangle_of) {
        clear();
        Rectangle all{glm::vec2(std::numeric_limits<float>::max()), glm::vec2(-std::numeric_limits<float>::max())};
        glm::vec2 sum(0.0f);
        for (std::size_t n = 0; n < count; ++n) {
            const Rectangle one = rectangle_of(n);
            all = {glm::min(all.low, one.low), glm::max(all.high, one.high)};
            sum += one.high - one.low;
        }
        const glm::vec2 size = all.high - all.low;
        if (count > k_few && std::isfinite(size.x) && std::isfinite(size.y)) {
            const glm::vec2 boxes = size * static_cast<float>(count) / glm::max(sum, slack);
            const float most = std::min(k_most_squares, k_squares_a_root * std::sqrt(static_cast<float>(count)));
            squares_ = glm::ivec2(glm::clamp(boxes, 1.0f, most));
            squares_a_metre_ = glm::vec2(squares_) / glm::max(size, slack);
            low_ = all.low;
        }
        first_squares_.resize(count);
        const auto each_square = [&](const auto& visit) {
            for (std::size_t n = 0; n < count; ++n) {
                const Rectangle one = rectangle_of(n);
                const glm::ivec2 from = square_of(one.low - slack), to = square_of(one.high + slack);
                first_squares_[n] = from;
                for (int y = from.y; y <= to.y; ++y)
                    for (int x = from.x; x <= to.x; ++x)
                        visit(number_of({x, y}), static_cast<std::uint32_t>(n));
            }
        };
        ends_.assign(static_cast<std::size_t>(squares_.x) * static_cast<std::size_t>(squares_.y) + 1, 0);
        each_square([&](std::size_t square, std::uint32_t) { ++ends_[square + 1]; });
        std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
        in_squares_.resize(ends_.back());
        // Each moves from its square's begin to its end: ends_[n] is the end of square n from here on.
        each_square([&](std::size_t square, std::uint32_t box) { in_squares_[ends_[square]++] = box; });
    }

    /// Numbers of the boxes that may hold a place, in their order.
    [[nodiscard]] std::span<const std::uint32_t> at(glm::vec2 place) const { return square(square_of(place)); }

    /// visit(number) for each box that may touch a rectangle, once; false from it ends the search.
    template <class Visit>
    void each_in(const Rectangle& place, const Visit& visit) const {
        const glm::ivec2 from = square_of(place.low), to = square_of(place.high);
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                for (const std::uint32_t n : square({x, y}))
                    if (glm::max(first_squares_[n], from) == glm::ivec2(x, y) && !visit(n))
                        return;
    }

    [[nodiscard]] std::size_t memory_bytes() const {
        return (ends_.capacity() + in_squares_.capacity()) * sizeof(std::uint32_t) +
               first_squares_.capacity() * sizeof(glm::ivec2);
    }

  private:
    static constexpr std::size_t k_few = 8;                                  ///< boxes: all of them are looked at
    static constexpr float k_most_squares = 256.0f, k_squares_a_root = 8.0f; ///< along an axis; of the root of the boxes

    [[nodiscard]] std::size_t number_of(glm::ivec2 square) const {
        return static_cast<std::size_t>(square.y) * static_cast<std::size_t>(squares_.x) + static_cast<std::size_t>(square.x);
    }
    [[nodiscard]] glm::ivec2 square_of(glm::vec2 place) const {
        const glm::vec2 square = (place - low_) * squares_a_metre_;
        return glm::ivec2(glm::clamp(square, glm::vec2(0.0f), glm::vec2(squares_ - 1)));
    }
    [[nodiscard]] std::span<const std::uint32_t> square(glm::ivec2 at) const {
        const std::size_t n = number_of(at);
        const std::uint32_t first = n > 0 ? ends_[n - 1] : 0;
        return std::span(in_squares_).subspan(first, ends_[n] - first);
    }

    glm::ivec2 squares_{1};
    glm::vec2 low_{0.0f}, squares_a_metre_{0.0f};
    std::vector<std::uint32_t> ends_ = std::vector<std::uint32_t>(2), in_squares_;
    std::vector<glm::ivec2> first_squares_; ///< of each box
};

} // namespace windrow
