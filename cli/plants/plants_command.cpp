#include "cli/plants/plants_command.h"

#include "cli/exit_code.h"
#include "cli/output_file.h"
#include "cli/pareto/svg.h"
#include "cli/plants/motion_plots.h"
#include "cli/plants/plant_plots.h"

namespace windrow::cli {

int run_plants(const std::filesystem::path& out, const Console& console) {
    OutputFolder folder;
    if (const Fault fault = folder.open(out))
        return complain_of(fault, console);
    struct Page {
        const char* name;
        Plot plot;
    };
    for (const Page& page : {Page{"bend.svg", bend_plot()}, Page{"blades.svg", blade_plot()}, Page{"shells.svg", shell_plot()},
                             Page{"spring.svg", spring_plot()}, Page{"cascade.svg", cascade_plot()}}) {
        OutputFile file(out / page.name);
        file.write(svg(page.plot));
        if (const Fault fault = file.publish())
            return complain_of(fault, console);
    }
    console.out << beaufort_table() << "\nIn " << out.string()
                << ": bend.svg, blades.svg, shells.svg, spring.svg, cascade.svg.\n";
    return k_exit_well;
}

} // namespace windrow::cli
