#include "cli/drawing/streamlines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

constexpr double k_step = 0.2;          // of the spacing
constexpr double k_nearest = 0.5;       // of the spacing, between lines that run beside each other
constexpr double k_shortest = 2.0;      // spacings; what is shorter shows no way
constexpr double k_clear_of_body = 0.3; // of the spacing, for seeds
constexpr int k_most_steps = 20'000;    // one way from a seed

/// The points of all lines, by squares of one spacing.
class Occupied {
  public:
    Occupied(glm::dvec2 low, glm::dvec2 extent, double spacing)
        : low_(low), spacing_(spacing), columns_(static_cast<int>(std::ceil(extent.x / spacing)) + 1),
          rows_(static_cast<int>(std::ceil(extent.y / spacing)) + 1),
          squares_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

    void add(const Streamline& line) {
        for (const glm::dvec2 point : line) {
            const glm::ivec2 square = square_of(point);
            squares_[static_cast<std::size_t>(square.y) * columns_ + square.x].push_back(point);
        }
    }
    /// Whether a point of a line is nearer than `distance`, at most the spacing.
    [[nodiscard]] bool near(glm::dvec2 place, double distance) const {
        const glm::ivec2 square = square_of(place);
        for (int row = std::max(square.y - 1, 0); row <= std::min(square.y + 1, rows_ - 1); ++row)
            for (int column = std::max(square.x - 1, 0); column <= std::min(square.x + 1, columns_ - 1); ++column)
                for (const glm::dvec2 point : squares_[static_cast<std::size_t>(row) * columns_ + column])
                    if (glm::distance(point, place) < distance)
                        return true;
        return false;
    }

  private:
    [[nodiscard]] glm::ivec2 square_of(glm::dvec2 place) const {
        return {std::clamp(static_cast<int>((place.x - low_.x) / spacing_), 0, columns_ - 1),
                std::clamp(static_cast<int>((place.y - low_.y) / spacing_), 0, rows_ - 1)};
    }

    glm::dvec2 low_;
    double spacing_;
    int columns_, rows_;
    std::vector<std::vector<glm::dvec2>> squares_;
};

class Tracer {
  public:
    Tracer(const SlicedAir& air, const Plane& plane, std::span<const CutBody> bodies, double spacing, double calm)
        : air_(air), plane_(plane), bodies_(bodies), spacing_(spacing), calm_(calm), low_(plane.in_plane(air.origin)),
          extent_(plane.in_plane(air.extent())), occupied_(low_, extent_, spacing) {}

    std::vector<Streamline> trace_all() {
        std::vector<Streamline> lines;
        std::size_t beside = 0; // the line whose sides are searched next
        const auto grow = [&](glm::dvec2 seed) {
            if (!free(seed))
                return;
            Streamline line = line_from(seed);
            if (length(line) < k_shortest * spacing_)
                return;
            occupied_.add(line);
            lines.push_back(std::move(line));
        };
        const auto grow_beside = [&] {
            for (; beside < lines.size(); ++beside)
                for (std::size_t n = 0; n + 1 < lines[beside].size(); ++n) {
                    const glm::dvec2 at = lines[beside][n], way = lines[beside][n + 1] - at;
                    const glm::dvec2 across = glm::dvec2(-way.y, way.x) * (spacing_ / std::max(glm::length(way), 1e-12));
                    grow(at + across);
                    grow(at - across);
                }
        };
        grow(low_ + 0.5 * extent_);
        grow_beside();
        for (double y = 0.5 * spacing_; y < extent_.y; y += spacing_)
            for (double x = 0.5 * spacing_; x < extent_.x; x += spacing_) {
                grow(low_ + glm::dvec2(x, y));
                grow_beside();
            }
        return lines;
    }

  private:
    [[nodiscard]] bool inside(glm::dvec2 place) const {
        const glm::dvec2 from = place - low_;
        return from.x >= 0.0 && from.y >= 0.0 && from.x <= extent_.x && from.y <= extent_.y;
    }

    [[nodiscard]] bool free(glm::dvec2 place) const {
        if (!inside(place) || occupied_.near(place, spacing_ * (1.0 - 1e-6)))
            return false;
        const glm::dvec3 world = plane_.to_world(place);
        return std::none_of(bodies_.begin(), bodies_.end(), [&](const CutBody& body) {
            return static_cast<double>(body.distance(world)) < k_clear_of_body * spacing_;
        });
    }

    /// Of length 1; 0 where the air is calm.
    [[nodiscard]] glm::dvec2 direction(glm::dvec2 place) const {
        const glm::dvec3 at = plane_.to_world(place);
        glm::vec3 velocity(0.0f);
        air_.velocity(std::span(&at, 1), std::span(&velocity, 1));
        const glm::dvec2 flow = plane_.in_plane(glm::dvec3(velocity));
        const double speed = std::hypot(flow.x, flow.y);
        return speed > calm_ && std::isfinite(speed) ? flow / speed : glm::dvec2(0.0);
    }

    [[nodiscard]] bool blocked(glm::dvec2 from, glm::dvec2 to) const {
        const glm::dvec3 a = plane_.to_world(from), b = plane_.to_world(to);
        return std::any_of(bodies_.begin(), bodies_.end(), [&](const CutBody& body) {
            return static_cast<double>(body.distance(a)) <= glm::distance(a, b) && body.blocks(a, b);
        });
    }

    /// Whether a line has come back to itself: a point of it that is far along it is near.
    [[nodiscard]] bool closes(const Streamline& line, glm::dvec2 place) const {
        const auto recent = static_cast<std::size_t>(std::ceil(2.0 / k_step));
        for (std::size_t n = 0; n + recent < line.size(); ++n)
            if (glm::distance(line[n], place) < k_nearest * spacing_)
                return true;
        return false;
    }

    /// One way from a seed, which it begins with.
    [[nodiscard]] Streamline trace(glm::dvec2 seed, double way) const {
        Streamline line{seed};
        const double step = k_step * spacing_;
        for (int n = 0; n < k_most_steps; ++n) {
            const glm::dvec2 here = line.back();
            const glm::dvec2 middle = here + 0.5 * way * step * direction(here);
            const glm::dvec2 there = here + way * step * direction(middle); // midpoint rule
            if (there == here || !inside(there) || occupied_.near(there, k_nearest * spacing_) || blocked(here, there) ||
                closes(line, there))
                break;
            line.push_back(there);
        }
        return line;
    }

    [[nodiscard]] Streamline line_from(glm::dvec2 seed) const {
        Streamline line = trace(seed, -1.0);
        std::reverse(line.begin(), line.end());
        const Streamline onward = trace(seed, 1.0);
        line.insert(line.end(), onward.begin() + 1, onward.end());
        return line;
    }

    [[nodiscard]] double length(const Streamline& line) const { return k_step * spacing_ * static_cast<double>(line.size() - 1); }

    const SlicedAir& air_;
    const Plane& plane_;
    std::span<const CutBody> bodies_;
    double spacing_, calm_;
    glm::dvec2 low_, extent_;
    Occupied occupied_;
};

} // namespace

std::vector<Streamline> streamlines(const SlicedAir& air, const Plane& plane, std::span<const CutBody> bodies, double spacing,
                                    double calm) {
    return Tracer(air, plane, bodies, spacing, calm).trace_all();
}

} // namespace windrow::cli
