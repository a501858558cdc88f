#include "cli/timings_csv.h"

#include "cli/timings.h"
#include "fluid/message.h"

namespace windrow::cli {
namespace {

const char* name_of(DiffusionMethod method) {
    switch (method) {
    case DiffusionMethod::one_pass:
        return "one_pass";
    case DiffusionMethod::implicit:
        return "implicit";
    default:
        return "none";
    }
}

} // namespace

std::string timings_header() {
    std::string text =
        "step,time_s,stepped,max_speed_m_s,cfl,substeps,substeps_capped,limited_cells,repaired_cells,motors_in_reach,"
        "diffusion,divergence_rms_1_s,energy_m5_s2,asleep";
    for (const StageColumn& stage : k_stages)
        text += detail::message(",", stage.name, "_ms");
    return text + "\n";
}

std::string timings_row(std::int64_t step, double time, const Diagnostics& d) {
    std::string text =
        detail::message(step, ",", time, ",", d.stepped ? 1 : 0, ",", d.max_speed, ",", d.cfl, ",", d.substeps, ",",
                        d.substeps_capped ? 1 : 0, ",", d.limited_cells, ",", d.repaired_cells, ",", d.motors_in_reach, ",",
                        name_of(d.diffusion), ",", d.divergence_rms, ",", d.energy, ",", d.asleep ? 1 : 0);
    for (const StageColumn& stage : k_stages)
        text += detail::message(",", d.times_ms.*stage.value);
    return text + "\n";
}

} // namespace windrow::cli
