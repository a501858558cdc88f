#include "cases/pareto_method.h"

#include "fluid/core/message.h"

namespace windrow::cases {

using detail::message;

std::vector<Method> pareto_methods(Solves solves) {
    std::vector<Method> methods;
    for (const Scheme scheme : k_schemes)
        for (const Interpolation advection : k_advections)
            for (const Pressure pressure : k_pressures)
                if (solves == Solves::all || pressure == Pressure::direct)
                    methods.push_back({scheme, advection, pressure});
    return methods;
}

Solves solves_of(const ParetoFlow& flow, BackendKind backend) {
    return backend == BackendKind::cpu && !flow.needs_wind() ? Solves::all : Solves::direct;
}

const char* name_of(Scheme scheme) {
    return scheme == Scheme::second_order ? "second_order" : "stable_fluids";
}

const char* name_of(Interpolation advection) {
    return advection == Interpolation::cubic ? "cubic" : "linear";
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
