#include "scene/obj_file.h"

#include "fluid/core/message.h"
#include "fluid/files/text_lines.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <span>

namespace windrow::scene {
namespace {

using detail::message, detail::number_of, detail::take_word, detail::trimmed;

constexpr std::size_t k_max_libraries = 64;

// --- Faces of more corners than three ---------------------------------------------------------------------------------------

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

// By its ears: corners whose neighbours see each other within the face. Two triangles fewer than corners, as numbers of corners, within
// the outline as it is seen along the axis that the face's normal is nearest to.
// Based on: Meisters 1975, "Polygons have ears", The American Mathematical Monthly 82.
std::vector<glm::uvec3> cut_face(std::span<const glm::vec3> outline) {
    std::vector<glm::uvec3> triangles;
    Face(outline).cut(triangles);
    return triangles;
}

// --- The file ---------------------------------------------------------------------------------------------------------------

class Scanner {
  public:
    Scanner(std::string_view text, const std::string& name, const ObjLimits& limits)
        : lines_(text), name_(name), limits_(limits) {}

    Result<ObjFile> run() {
        for (std::string_view line; fault_.empty() && lines_.next(line);)
            statement(line);
        if (fault_.empty() && triangles_ == 0)
            return Error{message(name_, " has no faces: give a mesh of triangles.")};
        if (!fault_.empty())
            return Error{fault_};
        std::erase_if(out_.parts, [](const ObjPart& part) { return part.corners.empty(); });
        return std::move(out_);
    }

  private:
    // Index kinds of a corner, in the order in which they are written.
    enum Kind { position, uv, normal };
    static constexpr std::array<std::string_view, 3> k_keys{"v", "vt", "vn"};

    template <class... Words>
    void fail(const Words&... words) {
        fault_ = message(name_, ":", lines_.number(), ": ", words...);
    }

    void statement(std::string_view line) {
        if (line.find('\0') != std::string_view::npos)
            return fail("the line has a zero byte: give text.");
        const std::string_view key = take_word(line);
        if (!key.empty() && key.front() != '#' && !line.empty() && line.back() == '\\')
            return fail("the line ends in a backslash: join it with the next.");
        if (key == "v")
            vector(position, line, 3, out_.positions);
        else if (key == "vt")
            vector(uv, line, 1, out_.uvs);
        else if (key == "vn")
            vector(normal, line, 3, out_.normals);
        else if (key == "f")
            face(line);
        else if (key == "usemtl")
            material(trimmed(line));
        else if (key == "mtllib")
            library(trimmed(line));
    }

    // The part that the next faces belong to.
    void material(std::string_view name) {
        if (name.size() > 255)
            return fail("the material's name has ", name.size(), " bytes: give at most 255.");
        const auto [known, is_new] = part_numbers_.try_emplace(name.empty() ? "none" : std::string(name), out_.parts.size());
        if (is_new)
            out_.parts.push_back({known->first});
        if (out_.parts.size() > k_max_materials)
            return fail("there are more than ", k_max_materials, " materials: give fewer.");
        part_ = known->second;
    }

    void library(std::string_view words) {
        if (out_.libraries.size() == k_max_libraries)
            return fail("there are more than ", k_max_libraries, " mtllib lines: give fewer.");
        out_.libraries.emplace_back(words);
    }

    // The first `least` numbers are needed; those behind the vector's (w, colours) are left out.
    template <class Vector>
    void vector(Kind kind, std::string_view words, int least, std::vector<Vector>& list) {
        if (++counts_[kind] > limits_.vertices)
            return fail("there are more than ", limits_.vertices, " lines ", k_keys[kind], ": give fewer.");
        Vector& values = list.emplace_back(0.0f);
        for (int i = 0; i < Vector::length(); ++i) {
            const std::string_view word = take_word(words);
            if (word.empty() && i >= least)
                return;
            const auto number = number_of<float>(word);
            if (!number || !(std::abs(*number) <= 1e30f))
                return fail(k_keys[kind], " has '", word, "': give ", least, " finite numbers.");
            values[i] = *number;
        }
    }

    // One index of a corner, from 1; 0: rejected.
    std::size_t index(Kind kind, std::string_view word) {
        const long long value = number_of<long long>(word).value_or(0);
        const auto count = static_cast<long long>(counts_[kind]);
        if (value == 0 || value > count || value < -count) {
            fail("the face's index '", word, "' means no ", k_keys[kind], " above it: give 1 to ", count, ".");
            return 0;
        }
        return static_cast<std::size_t>(value < 0 ? count + value + 1 : value);
    }

    void face(std::string_view words) {
        std::size_t count = 0;
        std::array<bool, 3> first{};
        std::array<ObjCorner, k_max_corners> corners;
        std::array<glm::vec3, k_max_corners> outline;
        for (std::string_view word = take_word(words); !word.empty(); word = take_word(words), ++count) {
            std::array<std::string_view, 3> parts;
            std::size_t part = 0;
            for (; part < 3; ++part) {
                const std::size_t slash = word.find('/');
                parts[part] = word.substr(0, slash);
                if (slash == std::string_view::npos)
                    break;
                word.remove_prefix(slash + 1);
            }
            const std::array<bool, 3> has{true, !parts[uv].empty(), !parts[normal].empty()};
            if (count == 0)
                first = has;
            if (part == 3 || has != first)
                return fail("the face's corners are of different kinds: give all as v, v/vt, v//vn or v/vt/vn.");
            ObjCorner corner;
            for (const Kind kind : {position, uv, normal}) {
                const std::size_t number = has[kind] ? index(kind, parts[kind]) : 0;
                if (has[kind] && number == 0)
                    return;
                (kind == position ? corner.position
                 : kind == uv     ? corner.uv
                                  : corner.normal) = static_cast<std::uint32_t>(number) - 1; // 0 becomes k_none
            }
            if (count < k_max_corners) {
                corners[count] = corner;
                outline[count] = out_.positions[corner.position];
            }
        }
        if (count < 3 || count > k_max_corners)
            return fail("the face has ", count, " corners: give 3 to ", k_max_corners, ".");
        triangles_ += count - 2;
        if (triangles_ > limits_.triangles)
            return fail("there are more than ", limits_.triangles, " triangles: give fewer.");
        if (out_.parts.empty())
            material("none");
        for (const glm::uvec3& triangle : cut_face(std::span(outline).first(count)))
            for (int n = 0; n < 3; ++n)
                out_.parts[part_].corners.push_back(corners[triangle[n]]);
    }

    detail::TextLines lines_;
    const std::string& name_;
    const ObjLimits& limits_;
    ObjFile out_;
    std::map<std::string, std::size_t> part_numbers_;
    std::size_t part_ = 0;
    std::array<std::size_t, 3> counts_{};
    std::size_t triangles_ = 0;
    std::string fault_;
};

} // namespace

Result<ObjFile> read_obj(std::string_view text, const std::string& name, const ObjLimits& limits) {
    return Scanner(text, name, limits).run();
}

MeshData mesh_of_obj(const ObjFile& obj) {
    MeshData data{.vertices = obj.positions};
    for (const ObjPart& part : obj.parts)
        for (std::size_t i = 0; i < part.corners.size(); i += 3)
            data.triangles.emplace_back(part.corners[i].position, part.corners[i + 1].position, part.corners[i + 2].position);
    return data;
}

} // namespace windrow::scene
