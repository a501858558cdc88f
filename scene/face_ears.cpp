#include "scene/face_ears.h"

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace windrow::scene {
namespace {

/// Twice the area of a triangle, positive counter-clockwise.
double area_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One face, seen along the axis that its normal is nearest to.
class Face {
  public:
    explicit Face(std::span<const glm::vec3> outline) {
        glm::dvec3 normal(0.0); // Newell's: the sum over its edges
        for (std::size_t n = 0; n < outline.size(); ++n)
            normal += glm::cross(glm::dvec3(outline[n]), glm::dvec3(outline[(n + 1) % outline.size()]));
        const glm::dvec3 size = glm::abs(normal);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (std::uint32_t n = 0; n < outline.size(); ++n) {
            const glm::dvec3 place(outline[n]);
            corners_.push_back({n, normal[axis] >= 0.0 ? glm::dvec2(place[u], place[v]) : glm::dvec2(place[v], place[u])});
        }
    }

    void cut(std::vector<glm::uvec3>& triangles) {
        while (corners_.size() > 3) {
            const std::size_t ear = find_ear();
            triangles.push_back(at(ear));
            corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        triangles.push_back(at(1));
    }

  private:
    struct Corner {
        std::uint32_t number;
        glm::dvec2 place;
    };

    [[nodiscard]] const Corner& around(std::size_t n) const { return corners_[n % corners_.size()]; }
    [[nodiscard]] glm::uvec3 at(std::size_t n) const {
        return {around(n + corners_.size() - 1).number, around(n).number, around(n + 1).number};
    }

    // Any corner where there is none, as in a face without area.
    [[nodiscard]] std::size_t find_ear() const {
        for (std::size_t n = 0; n < corners_.size(); ++n)
            if (is_ear(n))
                return n;
        return 1;
    }

    [[nodiscard]] bool is_ear(std::size_t n) const {
        const glm::dvec2 a = around(n + corners_.size() - 1).place, b = around(n).place, c = around(n + 1).place;
        if (!(area_of(a, b, c) > 0.0))
            return false;
        for (const Corner& other : corners_)
            if (const glm::dvec2 p = other.place;
                p != a && p != b && p != c && area_of(a, b, p) >= 0.0 && area_of(b, c, p) >= 0.0 && area_of(c, a, p) >= 0.0)
                return false;
        return true;
    }

    std::vector<Corner> corners_;
};

} // namespace

std::vector<glm::uvec3> cut_face(std::span<const glm::vec3> outline) {
    std::vector<glm::uvec3> triangles;
    Face(outline).cut(triangles);
    return triangles;
}

} // namespace windrow::scene
