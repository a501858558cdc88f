// `windrow view`: opens a window on a scene (vegetation/view/view.h), where that was built in.
#pragma once

#include "cli/console.h"

#include <functional>

namespace CLI {
class App;
}

namespace windrow::cli {

/// Adds the command; where it is chosen, `chosen` runs it.
void add_view(CLI::App& app, std::function<int()>& chosen, const Console& console);

} // namespace windrow::cli
