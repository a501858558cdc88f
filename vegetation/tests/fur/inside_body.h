// Which points lie inside of a closed body, by the parity of the triangles that a ray from the point crosses. It uses the posed
// triangles alone: no normal, no field, nothing that the coat itself is kept outside with.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::fur::test {

/// Triangles seen along one direction, in squares across it.
class RayParity {
  public:
    RayParity(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> indices, glm::dvec3 way) {
        const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0.31, -0.77, 0.56)));
        turn_ = glm::transpose(glm::dmat3(side, glm::cross(way, side), way));
        low_ = glm::dvec2(1e30);
        glm::dvec2 high(-1e30);
        for (std::size_t n = 0; n < indices.size(); ++n) {
            corners_.push_back(turn_ * positions[indices[n]]);
            low_ = glm::min(low_, glm::dvec2(corners_.back()));
            high = glm::max(high, glm::dvec2(corners_.back()));
        }
        square_ = glm::max((high - low_) / double(k_squares), glm::dvec2(1e-9));
        squares_.resize(k_squares * k_squares);
        for (std::uint32_t n = 0; n < corners_.size(); n += 3) {
            const glm::dvec2 a(corners_[n]), b(corners_[n + 1]), c(corners_[n + 2]);
            const glm::ivec2 from = square_of(glm::min(a, glm::min(b, c))), to = square_of(glm::max(a, glm::max(b, c)));
            for (int row = from.y; row <= to.y; ++row)
                for (int column = from.x; column <= to.x; ++column)
                    squares_[static_cast<std::size_t>(row * k_squares + column)].push_back(n);
        }
    }

    [[nodiscard]] bool inside(glm::dvec3 place) const {
        const glm::dvec3 p = turn_ * place;
        const glm::ivec2 square = square_of(glm::dvec2(p));
        bool odd = false;
        for (const std::uint32_t n : squares_[static_cast<std::size_t>(square.y * k_squares + square.x)]) {
            const glm::dvec3 a = corners_[n] - p, b = corners_[n + 1] - p, c = corners_[n + 2] - p;
            const double u = b.x * c.y - b.y * c.x, v = c.x * a.y - c.y * a.x, w = a.x * b.y - a.y * b.x;
            if ((u > 0.0) != (v > 0.0) || (v > 0.0) != (w > 0.0))
                continue;
            odd ^= (u * a.z + v * b.z + w * c.z) / (u + v + w) > 0.0;
        }
        return odd;
    }

  private:
    static constexpr int k_squares = 64;
    [[nodiscard]] glm::ivec2 square_of(glm::dvec2 at) const {
        return glm::clamp(glm::ivec2(glm::floor((at - low_) / square_)), glm::ivec2(0), glm::ivec2(k_squares - 1));
    }

    glm::dmat3 turn_{1.0};
    glm::dvec2 low_{0.0}, square_{1.0};
    std::vector<glm::dvec3> corners_{};
    std::vector<std::vector<std::uint32_t>> squares_{};
};

/// By the majority of three rays: a mesh may have a hole or a fold that one of them goes through.
class InsideBody {
  public:
    InsideBody(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> indices)
        : rays_{RayParity(positions, indices, glm::normalize(glm::dvec3(0.613, 0.242, -0.752))),
                RayParity(positions, indices, glm::normalize(glm::dvec3(-0.214, 0.931, 0.296))),
                RayParity(positions, indices, glm::normalize(glm::dvec3(-0.688, -0.337, -0.643)))} {}

    [[nodiscard]] bool operator()(glm::dvec3 place) const {
        int votes = 0;
        for (const RayParity& ray : rays_)
            votes += ray.inside(place);
        return votes >= 2;
    }

  private:
    std::array<RayParity, 3> rays_;
};

} // namespace windrow::vegetation::fur::test
