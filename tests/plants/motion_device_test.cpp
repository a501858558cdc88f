// The formulas of plants in motion on a device against the same text as C++.
#include "coupling/motion_numerics.h"
#include "coupling/spring.h"
#include "shader_words/motion.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <random>

namespace windrow::vulkan {
namespace {

using namespace numerics;

class MotionDevice : public Gpu {};

glm::mat4 on_the_cpu(const glm::mat4& i, const WindrowSpringStep& spring) {
    const glm::vec2 place(i[0].x, i[0].y), velocity(i[0].z, i[0].w), before(i[1].x, i[1].y), now(i[1].z, i[1].w);
    glm::mat4 out(0.0f);
    out[0] = glm::vec4(place + windrow_spring_place(spring, place, velocity, before, now),
                       velocity + windrow_spring_velocity(spring, place, velocity, before, now));
    out[1] = glm::vec4(windrow_direction_memory(0.5f * glm::vec3(i[2]), glm::normalize(glm::vec3(i[3])), 10.0f, std::abs(i[2].w)),
                       0.0f);
    const float height = std::abs(i[3].w);
    const WindrowPose low{i[0], i[1]}, high{i[2], i[3]};
    const WindrowPose pose = windrow_pose_between(low, high, windrow_cascade_fraction(height, 7));
    out[2] = glm::vec4(windrow_posed(pose, glm::vec3(i[1])), static_cast<float>(windrow_cascade_stage(height, 7)));
    out[3] = pose.rotation;
    return out;
}

// Bounds: all inputs lie within 1, so does what comes out, but for poses (up to 3). A device may round each of some twenty
// operations once, and divisions and exponentials to 3 units: 1e-5. The direction of a quaternion that nearly cancels is worth
// less; those are left out (shorter than 0.1).
TEST_F(MotionDevice, FormulasAreTheSameForRandomInput) {
    constexpr std::size_t k_count = 100000;
    ASSERT_TRUE(device);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    std::vector<glm::mat4> inputs(k_count);
    for (glm::mat4& input : inputs)
        for (int c = 0; c < 4; ++c)
            input[c] = {unit(random), unit(random), unit(random), unit(random)};
    const WindrowSpringStep spring = std::bit_cast<WindrowSpringStep>(spring_step(springs::wheat, 1.0 / 60.0)->block());

    const Buffer in = uploaded(inputs), out = buffer(k_count * sizeof(glm::mat4), MemoryUse::readback);
    dispatch(shader_words::motion,
             {{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = in.handle()},
              {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = out.handle()}},
             k_count, std::as_bytes(std::span(&spring, 1)));
    const auto outputs = read<glm::mat4>(out, k_count);
    double spring_apart = 0.0, direction_apart = 0.0, pose_apart = 0.0;
    for (std::size_t n = 0; n < k_count; ++n) {
        const glm::mat4 wanted = on_the_cpu(inputs[n], spring);
        spring_apart = std::max(spring_apart, static_cast<double>(glm::length(outputs[n][0] - wanted[0])));
        direction_apart = std::max(direction_apart, static_cast<double>(glm::length(outputs[n][1] - wanted[1])));
        const float share = windrow_cascade_fraction(std::abs(inputs[n][3].w), 7);
        if (glm::length(inputs[n][1] + share * (inputs[n][3] - inputs[n][1])) > 0.1f)
            pose_apart = std::max({pose_apart, static_cast<double>(glm::length(outputs[n][2] - wanted[2])),
                                   static_cast<double>(glm::length(outputs[n][3] - wanted[3]))});
    }
    WINDROW_EXPECT_FIGURE("motion_device/spring", spring_apart, 1e-5);
    WINDROW_EXPECT_FIGURE("motion_device/direction", direction_apart, 1e-5);
    WINDROW_EXPECT_FIGURE("motion_device/pose", pose_apart, 1e-5);
}

} // namespace
} // namespace windrow::vulkan
