// Direction memory: within the unit ball, the same at any frame rate, and the limit of the source's rule.
#include "coupling/motion_numerics.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace windrow {
namespace {

using numerics::windrow_direction_memory;

constexpr float k_rate = 10.0f; // [1/s] of the source

// Where the object is steered in second n; 0: nowhere. Without input the memory droops, as in the source.
glm::vec3 input(int second) {
    constexpr glm::vec3 k_inputs[] = {{1, 0, 0}, {0, 0, 0}, {0.6f, 0, 0.8f}, {-1, 0, 0}, {0, 0, 0}, {0, 0, -1}};
    return k_inputs[second % 6];
}

// A push lasts a sixth of a second, shorter and longer than the ball's radius takes.
glm::vec3 push(int sixth) {
    const glm::vec3 steer = input(sixth);
    return steer == glm::vec3(0.0f) ? glm::vec3(0.0f, -1.0f, 0.0f) : -steer;
}

std::vector<glm::vec3> history(int rate) {
    std::vector<glm::vec3> found;
    glm::vec3 memory(0.0f);
    const int frames = rate / 6;
    for (int sixth = 0; sixth < 36; ++sixth) {
        for (int frame = 0; frame < frames; ++frame)
            memory = windrow_direction_memory(memory, push(sixth), k_rate, 1.0f / static_cast<float>(rate));
        found.push_back(memory);
    }
    return found;
}

double apart(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    double worst = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        worst = std::max(worst, static_cast<double>(glm::length(a[n] - b[n])));
    return worst;
}

TEST(MotionDirection, IsTheSameAtAnyFrameRate) {
    const std::vector<glm::vec3> once = history(6);
    WINDROW_EXPECT_FIGURE("motion/direction/30_against_240_hz", apart(history(30), history(240)), 0.01);
    for (const int rate : {12, 30, 60, 240, 1200})
        WINDROW_EXPECT_FIGURE("motion/direction/rate_" + std::to_string(rate), apart(history(rate), once), 1e-5);
}

TEST(MotionDirection, NeverLeavesTheBall) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f), decade(-6.0f, 6.0f);
    double longest = 0.0;
    glm::vec3 memory(0.0f);
    for (int n = 0; n < 200000; ++n) {
        glm::vec3 toward(unit(random), unit(random), unit(random));
        toward = n % 50 == 0 ? -memory : toward; // straight back too
        const float length = glm::length(toward);
        memory =
            windrow_direction_memory(memory, length > 0.0f ? toward / length : toward, k_rate, std::pow(10.0f, decade(random)));
        longest =
            std::max(longest, std::sqrt(static_cast<double>(memory.x) * memory.x + static_cast<double>(memory.y) * memory.y +
                                        static_cast<double>(memory.z) * memory.z));
        ASSERT_TRUE(std::isfinite(memory.x) && std::isfinite(memory.y) && std::isfinite(memory.z)) << n;
    }
    // A vector of length 1 in float has a length of 1 to rounding.
    WINDROW_EXPECT_FIGURE("motion/direction/longest", longest, 1.0 + 2e-7);
}

// The source adds the push of a frame and shortens to 1. As its frames shrink it comes to ours, in the first order.
TEST(MotionDirection, IsTheLimitOfTheSourcesRule) {
    double errors[3];
    const int rates[] = {6000, 12000, 24000};
    const std::vector<glm::vec3> exact = history(6);
    for (int k = 0; k < 3; ++k) {
        glm::dvec3 memory(0.0);
        errors[k] = 0.0;
        for (int sixth = 0; sixth < 36; ++sixth) {
            for (int frame = 0; frame < rates[k] / 6; ++frame) {
                memory += static_cast<double>(k_rate) / rates[k] * glm::dvec3(push(sixth));
                if (glm::length(memory) > 1.0)
                    memory = glm::normalize(memory);
            }
            errors[k] = std::max(errors[k], glm::length(memory - glm::dvec3(exact[static_cast<std::size_t>(sixth)])));
        }
    }
    test::figure("motion/direction/source_at_24000_hz", errors[2]);
    test::figure("motion/direction/source_slope", std::log2(errors[0] / errors[1]));
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 1.0, 0.15);
}

TEST(MotionDirection, RestsWithoutAPush) {
    const glm::vec3 memory(0.3f, -0.4f, 0.5f);
    EXPECT_EQ(windrow_direction_memory(memory, glm::vec3(0.0f), k_rate, 1.0f), memory);
    EXPECT_EQ(windrow_direction_memory(memory, glm::vec3(1.0f, 0.0f, 0.0f), k_rate, 0.0f), memory);
}

} // namespace
} // namespace windrow
