// A cloak that blows: a sheet of columns that hang from the shoulders, each row of them a spring that leans with the wind.
//
// A column's link at a row leans from the vertical by a = q C / w along the wind that passes it, q = 1.2/2 u^2 the pressure, C and w
// the drag coefficient and weight [N/m2] of cloth: the tangent of a hanging sheet's angle. What would press it into the wearer is
// taken out, the wind along the body stays. Springs (coupling/spring.h) follow a, the slower the lower: a gust runs down the cloak. Each
// point is one link below the one above, then is moved out of the wearer's flesh. Ripples that run down with the wind are added on
// top; they are drawn, not solved.
#pragma once

#include "../../fluid/result.h"
#include "person.h"

#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::render {

class Cloak {
  public:
    static constexpr std::size_t k_columns = 19, k_rows = 11; ///< points across and down
    static constexpr float k_link = 0.105f;                   ///< [m] between two rows
    static constexpr float k_margin = 0.02f;                  ///< [m] of cloth to flesh

    Cloak();

    /// A sheet of cloth and its lining; its parts begin at `first_part`, column by column.
    [[nodiscard]] static Solid solid(std::size_t first_part);

    /// What it hangs on, at a moment.
    struct Wearer {
        PersonParts parts{};  ///< in its own space
        float yaw = 0.0f;     ///< [rad] of that space in the world
        glm::vec3 high{0.0f}; ///< [m/s] of the air past the wearer at the shoulders, in the world
        glm::vec3 low{0.0f};  ///< the same at the knees
    };
    /// `seconds` later, 0 or more; 0 changes nothing but the wearer. At most 60 s.
    void advance(double seconds, const Wearer& wearer);

    /// Points and normals in the wearer's own space, k_columns times k_rows, column by column.
    [[nodiscard]] std::span<const glm::vec3> points() const { return points_; }
    /// A placement a point: there, z along the sheet's normal.
    [[nodiscard]] std::vector<glm::mat4> placements() const;

  private:
    void lean(double seconds, const Wearer& wearer);
    void hang(const Wearer& wearer);

    std::vector<double> place_, velocity_, target_, before_; ///< leans in the world, [row][column][x, z]
    double ripple_ = 0.0;                                    ///< turns
    float speed_ = 0.0f;                                     ///< [m/s]
    bool begun_ = false;
    std::vector<glm::vec3> points_;
};

} // namespace windrow::vegetation::render
