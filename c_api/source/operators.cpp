// Calls of operators.h.
#include "fluid/operators.h"

#include "c_api/operators.h"
#include "c_api/source/tables.h"
#include "fluid/core/message.h"
#include "fluid/core/window_history.h"
#include "fluid/wind.h"

#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

struct windrow_workspace {
    Workspace work;
    std::size_t obstacles = 0;
};

namespace windrow::c_api {

// Defaults; what a host must set is null.
struct TransportDefaults {
    float extrapolation = 1.0f;
    float relaxation = 1.0f;
    Interpolation interpolation = Interpolation::cubic;
};
WINDROW_C_STRUCT(windrow_transport, TransportDefaults, extrapolation, relaxation, interpolation);
struct ScalarTransportDefaults {
    Interpolation interpolation = Interpolation::cubic;
};
WINDROW_C_STRUCT(windrow_scalar_transport, ScalarTransportDefaults, interpolation);

} // namespace windrow::c_api

namespace {

constexpr float k_most_viscosity = 1e9f; // [m^2/s] as in a config

/// The fields of a call, which have `count` cells each.
class Call {
  public:
    Call(const windrow_workspace& work, std::uint64_t count) : count_(static_cast<std::size_t>(count)) {
        if (const std::size_t wanted = work.work.box().cell_count(); count != wanted)
            reasons_.add("count is ", count, ": give ", wanted, ", the number of cells of the workspace.");
    }

    void time(float dt) {
        if (!(std::isfinite(dt) && dt >= 0.0f))
            reasons_.add("dt is ", dt, " s: give a finite time of 0 or more.");
    }
    void within(const char* name, float value, float least, float most) {
        if (!(value >= least && value <= most))
            reasons_.add(std::string_view(name), " is ", value, ": give ", least, " to ", most, ".");
    }
    /// Null where `required` is false: an empty span.
    template <class To, class From>
    std::span<To> field(const char* name, From* values, bool required = true) {
        if (values == nullptr) {
            if (required)
                reasons_.add(std::string_view(name), " is null: give an array of ", count_, " cells.");
            return {};
        }
        if (sizeof(From) == sizeof(windrow_vec4) && reinterpret_cast<std::uintptr_t>(values) % sizeof(windrow_vec4) != 0)
            reasons_.add(std::string_view(name), " is not aligned to ", sizeof(windrow_vec4), " bytes.");
        return {same_layout<To>(values), count_};
    }
    /// `same`: they may be one array.
    template <class A, class B>
    void apart(const char* name, std::span<A> result, const char* other_name, std::span<B> other, bool same = false) {
        if (!reasons_.empty() || result.empty() || other.empty())
            return;
        const auto begin = reinterpret_cast<std::uintptr_t>(result.data()),
                   other_begin = reinterpret_cast<std::uintptr_t>(other.data());
        if (!(same && begin == other_begin) && begin < other_begin + other.size_bytes() &&
            other_begin < begin + result.size_bytes())
            reasons_.add(std::string_view(name), " is within the memory of ", std::string_view(other_name),
                         ": give an array of its own.");
    }
    Reasons& reasons() { return reasons_; }
    /// Runs use() where nothing is wrong.
    template <class Use>
    windrow_result run(const Use& use) {
        return reasons_.empty() ? done(use()) : fail(WINDROW_REJECTED, reasons_.take());
    }

  private:
    Reasons reasons_;
    std::size_t count_;
};

/// A struct of the host's as this library has it, with its interpolation.
template <class C>
bool read(Call& asked, const char* name, const C* from, C& taken, Interpolation& interpolation) {
    const Path path{nullptr, name};
    return take(asked.reasons(), path, from, taken) &&
           read_choice(asked.reasons(), Path{&path, "interpolation"}, taken.interpolation, interpolation);
}

} // namespace

WINDROW_EXPORT windrow_result windrow_workspace_create(const windrow_config* config, windrow_workspace** work) {
    return create_from(config, work, [](const Config& wanted) -> Result<Workspace> {
        if (auto valid = validate(wanted); !valid)
            return valid.failure();
        return Workspace::create(
            {.box = detail::box_of(wanted), .ambient = wanted.ambient, .simd = wanted.simd, .parallel_for = wanted.parallel_for});
    });
}
WINDROW_EXPORT void windrow_workspace_destroy(windrow_workspace* work) {
    delete work;
}
WINDROW_EXPORT uint64_t windrow_workspace_cell_count(const windrow_workspace* work) {
    return value_of(work, "work", [&]() -> std::uint64_t { return work->work.box().cell_count(); });
}
WINDROW_EXPORT uint64_t windrow_workspace_memory_bytes(const windrow_workspace* work) {
    return value_of(work, "work", [&]() -> std::uint64_t { return work->work.memory_bytes(); });
}
WINDROW_EXPORT windrow_result windrow_workspace_set_boundaries(windrow_workspace* work, const windrow_boundaries* boundaries) {
    return call({{work, "work"}, {boundaries, "boundaries"}}, [&]() -> windrow_result {
        Reasons reasons;
        Boundaries wanted{};
        read_fields(reasons, Path{nullptr, "boundaries"}, *boundaries, wanted);
        if (!reasons.empty())
            return fail(WINDROW_REJECTED, reasons.take());
        return done(work->work.set_boundaries(wanted));
    });
}
WINDROW_EXPORT windrow_result windrow_workspace_set_ambient(windrow_workspace* work, windrow_vec3 ambient) {
    return call({{work, "work"}}, [&]() -> windrow_result {
        if (!(std::isfinite(ambient.x) && std::isfinite(ambient.y) && std::isfinite(ambient.z)))
            return fail(WINDROW_REJECTED, detail::message("ambient is ", to_cpp(ambient), " m/s: give finite numbers."));
        work->work.set_ambient(to_cpp(ambient));
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_workspace_set_obstacles(windrow_workspace* work, const windrow_obstacle* obstacles,
                                                              const windrow_vec3* velocities, const windrow_vec3* spins,
                                                              uint64_t count) {
    return call({{work, "work"}, {count > 0 ? obstacles : static_cast<const void*>(work), "obstacles"}}, [&]() -> windrow_result {
        if (count > std::uint64_t{65535})
            return fail(WINDROW_REJECTED, detail::message("there are ", count, " obstacles: give at most 65535."));
        Reasons reasons;
        std::vector<PlacedObstacle> placed;
        placed.reserve(static_cast<std::size_t>(count));
        const auto* at = reinterpret_cast<const unsigned char*>(obstacles);
        for (std::uint64_t n = 0; n < count && reasons.empty(); ++n) {
            const auto* const from = reinterpret_cast<const windrow_obstacle*>(at);
            const std::string name = detail::message("obstacles[", n, "]");
            Obstacle wanted;
            if (from->struct_size != obstacles->struct_size || from->struct_size % alignof(windrow_obstacle) != 0) {
                reasons.add(name, " has struct_size ", from->struct_size, ": give all that of windrow_obstacle.");
                break;
            }
            read_versioned(reasons, Path{nullptr, name.c_str()}, from, wanted);
            if (auto valid = validate(wanted); reasons.empty() && !valid)
                reasons.add(name, ": ", valid.error());
            at += from->struct_size;
            const glm::vec3 velocity = velocities != nullptr ? to_cpp(velocities[n]) : glm::vec3(0.0f);
            const glm::vec3 spin = spins != nullptr ? to_cpp(spins[n]) : glm::vec3(0.0f);
            if (!std::isfinite(glm::dot(velocity, velocity) + glm::dot(spin, spin)))
                reasons.add(name, " moves by ", velocity, " m/s and turns by ", spin, " rad/s: give finite numbers.");
            placed.push_back({.shape = wanted.shape,
                              .surface = wanted.surface,
                              .position = glm::vec3(wanted.position),
                              .axes = glm::mat3_cast(glm::normalize(wanted.orientation)),
                              .velocity = velocity,
                              .spin = spin});
        }
        if (!reasons.empty())
            return fail(WINDROW_REJECTED, reasons.take());
        const Result<void> set = work->work.set_obstacles(placed);
        if (set)
            work->obstacles = placed.size();
        return done(set);
    });
}
WINDROW_EXPORT windrow_result windrow_workspace_impulse_on(const windrow_workspace* work, uint64_t obstacle,
                                                           windrow_vec3* impulse) {
    return call({{work, "work"}, {impulse, "impulse"}}, [&]() -> windrow_result {
        if (obstacle >= work->obstacles)
            return fail(WINDROW_REJECTED, detail::message("obstacle is ", obstacle, ": the workspace has ", work->obstacles,
                                                          " of them, from 0 on."));
        *impulse = to_c(work->work.impulse_on(static_cast<std::size_t>(obstacle)));
        return WINDROW_OK;
    });
}

WINDROW_C_INIT(windrow_transport)
WINDROW_C_INIT(windrow_scalar_transport)
WINDROW_EXPORT windrow_result windrow_advect(windrow_workspace* work, const windrow_transport* transport, windrow_vec4* result,
                                             uint64_t count) {
    return call({{work, "work"}, {transport, "transport"}}, [&] {
        Call asked(*work, count);
        windrow_transport taken{};
        Transport wanted;
        const std::span<glm::vec4> to = asked.field<glm::vec4>("result", result);
        if (read(asked, "transport", transport, taken, wanted.interpolation)) {
            wanted.carried = asked.field<const glm::vec4>("transport.carried", taken.carried);
            wanted.velocity = asked.field<const glm::vec4>("transport.velocity", taken.velocity);
            wanted.velocity_old = asked.field<const glm::vec4>("transport.velocity_old", taken.velocity_old, false);
            wanted.history = asked.field<const glm::vec4>("transport.history", taken.history, false);
            wanted.extrapolation = taken.velocity_old != nullptr ? taken.extrapolation : 0.0f;
            wanted.history_scale = taken.history != nullptr ? taken.history_scale : 0.0f;
            wanted.relaxation = taken.relaxation;
            wanted.dt = taken.dt;
            asked.time(taken.dt);
            asked.within("transport.extrapolation", taken.extrapolation, 0.0f, 2.0f);
            asked.within("transport.relaxation", taken.relaxation, 0.0f, 1.0f);
            if (!std::isfinite(taken.history_scale))
                asked.reasons().add("transport.history_scale is ", taken.history_scale, ": give a finite number.");
            asked.apart("result", to, "transport.velocity", wanted.velocity);
            asked.apart("result", to, "transport.carried", wanted.carried, true);
            asked.apart("result", to, "transport.velocity_old", wanted.velocity_old, true);
            asked.apart("result", to, "transport.history", wanted.history, true);
        }
        return asked.run([&]() -> Result<void> {
            advect(work->work, wanted, to);
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_advect_scalar(windrow_workspace* work, const windrow_scalar_transport* transport,
                                                    float* result, uint64_t count) {
    return call({{work, "work"}, {transport, "transport"}}, [&] {
        Call asked(*work, count);
        windrow_scalar_transport taken{};
        ScalarTransport wanted;
        const std::span<float> to = asked.field<float>("result", result);
        if (read(asked, "transport", transport, taken, wanted.interpolation)) {
            wanted.carried = asked.field<const float>("transport.carried", taken.carried);
            wanted.velocity = asked.field<const glm::vec4>("transport.velocity", taken.velocity);
            wanted.dt = taken.dt;
            wanted.outside = taken.outside;
            wanted.clamped = taken.clamped != 0;
            asked.time(taken.dt);
            if (!std::isfinite(taken.outside))
                asked.reasons().add("transport.outside is ", taken.outside, ": give a finite number.");
            asked.apart("result", to, "transport.carried", wanted.carried);
            asked.apart("result", to, "transport.velocity", wanted.velocity);
        }
        return asked.run([&] { return advect(work->work, wanted, to); });
    });
}
WINDROW_EXPORT windrow_result windrow_diffuse(windrow_workspace* work, const windrow_vec4* field, float viscosity, float dt,
                                              windrow_vec4* result, windrow_diffusion_method* method, uint64_t count) {
    return call({{work, "work"}}, [&] {
        Call asked(*work, count);
        const std::span<const glm::vec4> from = asked.field<const glm::vec4>("field", field);
        const std::span<glm::vec4> to = asked.field<glm::vec4>("result", result);
        asked.apart("result", to, "field", from);
        asked.time(dt);
        asked.within("viscosity", viscosity, 0.0f, k_most_viscosity);
        return asked.run([&]() -> Result<void> {
            const Result<DiffusionMethod> taken = diffuse(work->work, from, viscosity, dt, to);
            if (!taken)
                return taken.failure();
            if (method != nullptr)
                *method = static_cast<windrow_diffusion_method>(*taken);
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_workspace_reserve_diffusion(windrow_workspace* work) {
    return call({{work, "work"}}, [&] { return reserve_diffusion(work->work); });
}
WINDROW_EXPORT windrow_result windrow_divergence(windrow_workspace* work, const windrow_vec4* velocity, float* result,
                                                 uint64_t count) {
    return call({{work, "work"}}, [&] {
        Call asked(*work, count);
        const std::span<const glm::vec4> from = asked.field<const glm::vec4>("velocity", velocity);
        const std::span<float> to = asked.field<float>("result", result);
        asked.apart("result", to, "velocity", from);
        return asked.run([&]() -> Result<void> {
            divergence(work->work, from, to);
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_solve_poisson(windrow_workspace* work, float* rhs_then_phi, uint64_t count) {
    return call({{work, "work"}}, [&] {
        Call asked(*work, count);
        const std::span<float> field = asked.field<float>("rhs_then_phi", rhs_then_phi);
        return asked.run([&]() -> Result<void> {
            solve_poisson(work->work, field);
            return {};
        });
    });
}
WINDROW_EXPORT windrow_result windrow_project(windrow_workspace* work, windrow_vec4* velocity, windrow_vec4* gradient,
                                              const float* expansion, uint64_t count) {
    return call({{work, "work"}}, [&] {
        Call asked(*work, count);
        const std::span<glm::vec4> field = asked.field<glm::vec4>("velocity", velocity);
        const std::span<glm::vec4> slope = asked.field<glm::vec4>("gradient", gradient, false);
        const std::span<const float> sources = asked.field<const float>("expansion", expansion, false);
        asked.apart("gradient", slope, "velocity", field);
        asked.apart("expansion", sources, "velocity", field);
        return asked.run([&]() -> Result<void> {
            project(work->work, field, slope, sources);
            return {};
        });
    });
}
