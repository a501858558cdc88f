// A jet of air, its mean over time: it must carry its momentum on, and it widens.
//
// A free round jet keeps its flux of momentum int u^2 dA from section to section, its speed falls as 1 / x, and its half-width,
// the radius at which the mean wind is half of that on the axis, grows by 0.094 to 0.102 a metre, since eddies of all sizes mix
// it. A grid of a few cells a width holds the largest of them at best, and no model stands for the others: what is told here is
// how far that goes. The jet lies askew to the cells, since one on an axis of symmetry stays as it is for good. Based on: Pope
// 2000, Turbulent Flows, section 5.1 (the figures are those of the experiments in its table 5.1).
#include "cli/verify/whole_step.h"

#include <algorithm>
#include <limits>

namespace windrow::cli {
namespace {

constexpr double k_spreading = 0.096;             ///< published, a metre; between 0.094 and 0.102
constexpr double k_length = 48.0;                 ///< [m] of the box, which is half as high and wide
constexpr glm::dvec3 k_nozzle(4.0, 12.27, 11.69); ///< [m] from the box's low corner; it blows along x
constexpr double k_from = 10.0, k_to = 24.0;      ///< [m] from the nozzle, beyond the 6 m in which the motor pushes

struct MeanJet {
    std::vector<double> u, u_squared; ///< [m/s], [m^2/s^2] a cell
    double cfl = 0.0;
};

// The last ten seconds of thirty, when the front has long left the box.
MeanJet mean_of_jet(CommandWind& wind) {
    constexpr double k_seconds = 30.0, k_counted = 10.0;
    const double dt = static_cast<double>(wind.box().cell_size) / 30.0;
    const int steps = static_cast<int>(std::lround(k_seconds / dt)), counted = static_cast<int>(std::lround(k_counted / dt));
    const std::size_t cells = wind.box().cell_count();
    MeanJet mean{.u = std::vector<double>(cells), .u_squared = std::vector<double>(cells)};
    for (int step = 0; step < steps; ++step) {
        mean.cfl = worse(mean.cfl, wind.step(dt).cfl);
        if (step < steps - counted)
            continue;
        const std::span<const glm::vec4> field = wind.field();
        for (std::size_t n = 0; n < cells; ++n) {
            const double u = field[n].x;
            mean.u[n] += u / counted;
            mean.u_squared[n] += u * u / counted;
        }
    }
    return mean;
}

// One plane of cells across the jet.
struct Section {
    double distance = 0.0; ///< [m] from the nozzle
    double flux = 0.0;     ///< [m^4/s^2]
    /// [m] where the mean over a ring about the axis is half of the innermost's
    double half_width = std::numeric_limits<double>::quiet_NaN();
};

Section section_of(const Box& box, const MeanJet& mean, int i) {
    const double h = box.cell_size;
    struct Ring {
        double speed = 0.0, radius = 0.0, count = 0.0;
    };
    std::vector<Ring> rings(static_cast<std::size_t>(box.cells.y / 2));
    Section section{.distance = (i + 0.5) * h - k_nozzle.x};
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j) {
            const std::size_t n = box.index(i, j, k);
            section.flux += mean.u_squared[n] * h * h;
            const double r = std::hypot((j + 0.5) * h - k_nozzle.y, (k + 0.5) * h - k_nozzle.z);
            if (const auto ring = static_cast<std::size_t>(r / h); ring < rings.size()) {
                rings[ring].speed += mean.u[n];
                rings[ring].radius += r;
                rings[ring].count += 1.0;
            }
        }
    for (Ring& ring : rings) {
        ring.speed /= ring.count;
        ring.radius /= ring.count;
    }
    const double half = 0.5 * rings[0].speed;
    const auto outer = std::find_if(rings.begin() + 1, rings.end(), [&](const Ring& ring) { return ring.speed < half; });
    if (outer != rings.end()) {
        const Ring& inner = *(outer - 1);
        section.half_width = inner.radius + (outer->radius - inner.radius) * (inner.speed - half) / (inner.speed - outer->speed);
    }
    return section;
}

VerifyRows jet_spreading(const VerifySetting& setting, int size) {
    const Box box{.cells = {size, size / 2, size / 2}, .cell_size = static_cast<float>(k_length / size)};
    Config config = raw_config(box, 0.0, setting);
    config.max_cfl = Config{}.max_cfl; // a jet's first steps
    config.max_substeps = Config{}.max_substeps;
    const auto wind = wind_of(config, setting);
    static_cast<void>(wind->motors().add(JetMotor{.position = k_nozzle})); // legal
    const MeanJet mean = mean_of_jet(*wind);
    // The line of least squares through the half-widths.
    double count = 0.0, sum_x = 0.0, sum_w = 0.0, sum_xx = 0.0, sum_xw = 0.0, least = std::numeric_limits<double>::infinity(),
           most = 0.0;
    for (int i = 0; i < size; ++i) {
        const Section section = section_of(box, mean, i);
        if (section.distance < k_from || section.distance > k_to)
            continue;
        count += 1.0;
        sum_x += section.distance;
        sum_w += section.half_width;
        sum_xx += section.distance * section.distance;
        sum_xw += section.distance * section.half_width;
        least = std::min(least, section.flux);
        most = std::max(most, section.flux);
    }
    const double slope = (count * sum_xw - sum_x * sum_w) / (count * sum_xx - sum_x * sum_x);
    return std::vector<VerifyRow>{
        {.cells = box.cells, .cfl = mean.cfl, .error = 1.0 - least / most, .bound = 0.15, .label = "flux of momentum"},
        {.cells = box.cells,
         .cfl = mean.cfl,
         .error = std::abs(slope - k_spreading),
         .bound = 0.103,
         .label = "half-width a metre"}};
}

} // namespace

std::vector<VerifyCase> jet_cases() {
    return {
        {.name = "jet_spreading",
         .what = "A jet, its mean over ten seconds, 10 to 24 m from the nozzle; the share by which its flux of momentum changes, "
                 "and how far the growth of its half-width is off the published 0.096 a metre.",
         .source = "Pope 2000, Turbulent Flows, section 5.1: momentum is kept; 0.094 to 0.102 a metre in experiments",
         .reason = "stated, not met: the half-width grows by 0.014 a metre at 1 m cells, 0.010 at half of that, a seventh of "
                   "what eddies below a cell would do; the flux changes by 12 and 3 %; of the worse a fifth more is admitted",
         .sizes = {48, 96},
         .run = jet_spreading},
    };
}

} // namespace windrow::cli
