// A uniform wind is a solution of every stage, and stays what it is to the bit: no weight that fails to sum to 1, no ghost that
// is not its neighbour, no mode of the pressure that rounding feeds. 600 steps, steps of two lengths so that every factor of the
// history differs from 1.
#include "figures.h"
#include "flows.h"

#include <cstdint>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_most;

enum class Surroundings { same, still };

struct UniformSetting {
    const char* name;
    Boundaries boundaries;
    glm::vec3 wind;
    /// The ambient wind: the same wind, or none.
    Surroundings surroundings = Surroundings::same;
    /// Settling needs an ambient wind to settle to.
    float relaxation_time = 0.0f;
};

void PrintTo(const UniformSetting& value, std::ostream* out) {
    *out << value.name;
}

// Cells that are not exactly the wind.
std::int64_t changed_cells(const UniformSetting& setting, glm::ivec3 cells, Scheme scheme, Interpolation interpolation,
                           float viscosity) {
    Config config{.cells = cells, .boundaries = setting.boundaries};
    config.ambient = setting.surroundings == Surroundings::same ? setting.wind : glm::vec3(0.0f);
    config.viscosity = viscosity;
    config.relaxation_time = setting.relaxation_time;
    config.scheme = scheme;
    config.interpolation = interpolation;
    Wind wind = *Wind::create(config);
    wind.set_velocity([&](glm::dvec3) { return setting.wind; });
    for (int step = 0; step < 600; ++step)
        wind.step(step % 3 == 0 ? 1.0 / 60.0 : 1.0 / 45.0);
    std::int64_t changed = 0;
    for (const glm::vec4& u : wind.field())
        changed += u != glm::vec4(setting.wind, 0.0f);
    return changed;
}

class UniformWindStays : public ::testing::TestWithParam<UniformSetting> {};

TEST_P(UniformWindStays, ToTheBit) {
    std::int64_t changed = 0;
    for (const glm::ivec3 cells : {glm::ivec3(32, 16, 32), glm::ivec3(17, 9, 23)})
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
            for (const Interpolation interpolation : {Interpolation::cubic, Interpolation::linear, Interpolation::cubic_32})
                changed += changed_cells(GetParam(), cells, scheme, interpolation, 1.5e-5f);
    expect_at_most(std::string("uniform.changed_cells.") + GetParam().name, static_cast<double>(changed), 0);
}

// One pass of diffusion is a sum of differences from the cell; the implicit solve works about the ambient wind.
TEST_P(UniformWindStays, ToTheBitWithViscosity) {
    std::int64_t changed = changed_cells(GetParam(), {17, 9, 23}, Scheme::second_order, Interpolation::cubic, 1.0f);
    if (GetParam().surroundings == Surroundings::same)
        changed += changed_cells(GetParam(), {17, 9, 23}, Scheme::second_order, Interpolation::cubic, 50.0f);
    expect_at_most(std::string("uniform.viscous_changed_cells.") + GetParam().name, static_cast<double>(changed), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Boxes, UniformWindStays,
    ::testing::Values(
        UniformSetting{"open", Boundaries::all(k_open), {3.3f, 0.7f, -1.9f}},
        UniformSetting{"open_settling", Boundaries::all(k_open), {3.3f, 0.7f, -1.9f}, Surroundings::same, 20.0f},
        UniformSetting{"over_floor", Boundaries::open_over_floor(), {-2.7f, 0.0f, 1.1f}},
        UniformSetting{"over_floor_settling", Boundaries::open_over_floor(), {-2.7f, 0.0f, 1.1f}, Surroundings::same, 20.0f},
        UniformSetting{"periodic", Boundaries::all(k_periodic), {0.1f, -4.3f, 2.2f}, Surroundings::still},
        UniformSetting{"free_slip_channel",
                       sides_of({k_periodic, k_periodic}, {k_slip, k_slip}, {k_slip, k_slip}),
                       {3.3f, 0.0f, 0.0f},
                       Surroundings::still},
        UniformSetting{
            "free_slip_duct_open_ends", sides_of({k_slip, k_slip}, {k_slip, k_slip}, {k_open, k_open}), {0.0f, 0.0f, 5.7f}},
        UniformSetting{
            "between_plates", sides_of({k_open, k_open}, {k_slip, k_slip}, {k_periodic, k_periodic}), {1.3f, 0.0f, -0.9f}}),
    [](const auto& suite) { return suite.param.name; });

} // namespace
} // namespace windrow
