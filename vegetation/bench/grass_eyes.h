// The field and the cameras that the benchmark of the grass measures.
#pragma once

#include "fluid/shapes/height_map.h"
#include "vegetation/grass/grass_view.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::grass::bench {

inline constexpr int k_frames = 16; // once around

/// Hills of 3 m and 90 m across, two metres a corner.
inline windrow::Result<HeightMap> rolling_hills(float metres) {
    const int corners = static_cast<int>(std::lround(metres / 2.0f)) + 1;
    return HeightMap::create({corners, corners}, 2.0f,
                             [](glm::vec2 p) { return 3.0f * std::sin(0.07f * p.x) * std::cos(0.06f * p.y); });
}

/// 50 degrees high, 16 to 9, from the middle of the field.
inline GrassCamera camera_at(const HeightMap& heights, int frame) {
    const glm::vec2 middle = 0.5f * heights.extent();
    const glm::vec3 eye(middle.x, heights.height(middle) + 1.7f, middle.y);
    const float yaw = 6.2831853f * static_cast<float>(frame) / static_cast<float>(k_frames);
    glm::mat4 projection = glm::perspectiveRH_ZO(glm::radians(50.0f), 16.0f / 9.0f, 0.1f, 1000.0f);
    projection[1][1] = -projection[1][1];
    const glm::vec3 toward(std::cos(yaw), -0.08f, std::sin(yaw));
    return {.view_projection = projection * glm::lookAtRH(eye, eye + toward, glm::vec3(0.0f, 1.0f, 0.0f)), .eye = eye};
}

} // namespace windrow::vegetation::grass::bench
