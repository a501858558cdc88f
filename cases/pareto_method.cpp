#include "cases/pareto_method.h"

#include "fluid/core/message.h"

namespace windrow::cases {

using detail::message;

namespace {

bool is_classic(const Method& method) {
    return method.scheme == Scheme::stable_fluids && method.interpolation == Interpolation::linear &&
           method.pressure != Pressure::direct && method.pressure != Pressure::multigrid;
}

} // namespace

std::vector<Method> pareto_methods(Solves solves) {
    std::vector<Method> methods;
    for (const Scheme scheme : k_schemes)
        for (const Interpolation advection : k_advections)
            for (const Pressure pressure : k_pressures)
                if (solves == Solves::all || pressure == Pressure::direct ||
                    (solves == Solves::voxels && is_classic({scheme, advection, pressure})))
                    methods.push_back({scheme, advection, pressure});
    return methods;
}

Solves solves_of(const ParetoFlow& flow, BackendKind backend) {
    if (backend != BackendKind::cpu || flow.needs_wind())
        return Solves::direct;
    return flow.obstacles.empty() ? Solves::all : Solves::voxels;
}

const char* name_of(Scheme scheme) {
    return scheme == Scheme::second_order ? "second_order" : "stable_fluids";
}

const char* name_of(Interpolation advection) {
    return k_words<Interpolation>[static_cast<std::size_t>(advection)];
}

const char* name_of(Pressure pressure) {
    switch (pressure) {
    case Pressure::direct:
        return "direct";
    case Pressure::multigrid:
        return "multigrid";
    case Pressure::jacobi80:
        return "jacobi80";
    case Pressure::jacobi40:
        return "jacobi40";
    default:
        return "jacobi20";
    }
}

std::string name_of(const Method& method) {
    return message(name_of(method.scheme), " ", name_of(method.interpolation), " ", name_of(method.pressure));
}

} // namespace windrow::cases
