// Triangles of an OBJ file. Faces are cut by their ears: a corner whose neighbours see each other within the face.
//
// Based on: Meisters 1975, "Polygons have ears", The American Mathematical Monthly 82.
#include "fluid/files/text_lines.h"
#include "scene/obj_text.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <span>

namespace windrow::scene {
namespace {

using detail::take_word;

template <class Number>
Number number_of(std::string_view word) {
    Number number{};
    std::from_chars(word.data(), word.data() + word.size(), number);
    return number;
}

/// Twice the area of a triangle, positive counter-clockwise.
double area_of(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// One face, seen along the axis that its normal is nearest to.
class Face {
  public:
    Face(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> corners) {
        glm::dvec3 normal(0.0); // Newell's: the sum over its edges
        for (std::size_t n = 0; n < corners.size(); ++n)
            normal += glm::cross(glm::dvec3(vertices[corners[n]]), glm::dvec3(vertices[corners[(n + 1) % corners.size()]]));
        const glm::dvec3 size = glm::abs(normal);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const std::uint32_t corner : corners) {
            const glm::dvec3 place(vertices[corner]);
            corners_.push_back({corner, normal[axis] >= 0.0 ? glm::dvec2(place[u], place[v]) : glm::dvec2(place[v], place[u])});
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
        std::uint32_t vertex;
        glm::dvec2 place;
    };

    [[nodiscard]] const Corner& around(std::size_t n) const { return corners_[n % corners_.size()]; }
    [[nodiscard]] glm::uvec3 at(std::size_t n) const {
        return {around(n + corners_.size() - 1).vertex, around(n).vertex, around(n + 1).vertex};
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

MeshData mesh_of_obj(const ObjText& obj) {
    MeshData data;
    std::vector<std::uint32_t> corners;
    detail::TextLines lines(obj.text);
    for (std::string_view line; lines.next(line);) {
        const std::string_view key = take_word(line);
        if (key == "v") {
            glm::vec3& place = data.vertices.emplace_back();
            for (int n = 0; n < 3; ++n)
                place[n] = number_of<float>(take_word(line));
        } else if (key == "f") {
            corners.clear();
            for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
                corners.push_back(number_of<std::uint32_t>(word.substr(0, word.find('/'))) - 1);
            Face(data.vertices, corners).cut(data.triangles);
        }
    }
    return data;
}

} // namespace windrow::scene
