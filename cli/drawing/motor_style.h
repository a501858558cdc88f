// What each kind of motor is called and coloured in pictures, and what it covers.
#pragma once

#include "cli/drawing/canvas.h"
#include "fluid/motor.h"

#include <array>
#include <cstddef>
#include <string>
#include <variant>

namespace windrow::cli {

struct MotorStyle {
    const char* name;
    Colour colour;
};

/// In the order of windrow::Motor. Warm colours, pink and violet: the map of speeds holds none of them. Neighbours differ by
/// shape too.
inline constexpr std::array<MotorStyle, std::variant_size_v<Motor>> k_motor_styles{{{"fan, gust", hex(0xFF7A45)},
                                                                                    {"body, its wake", hex(0xFF6FC1)},
                                                                                    {"jet", hex(0xFFC02E)},
                                                                                    {"whirl", hex(0xBE95FF)},
                                                                                    {"blast, suction", hex(0xFF4F55)},
                                                                                    {"burst", hex(0xE040FB)}}};

[[nodiscard]] inline const MotorStyle& style_of(const Motor& motor) {
    return k_motor_styles[motor.index()];
}

/// Where a motor acts, as one of the regions.
struct PlacedRegion {
    Region region;
    glm::dvec3 centre{0.0}; ///< [m] world; first end of a cone
};
[[nodiscard]] PlacedRegion region_of(const Motor& motor);

/// "8 m/s": how strong it is, in few signs; nothing where no one figure says it.
[[nodiscard]] std::string strength_text(const Motor& motor);

} // namespace windrow::cli
