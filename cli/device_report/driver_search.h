// Where Vulkan's loader and drivers are looked for on this machine, and what is there.
#pragma once

#include "cli/device_report/report_section.h"

namespace windrow::cli {

/// Names the drivers of folders that a loader does not search by itself in VK_ADD_DRIVER_FILES, unless the environment names
/// drivers already.
void add_drivers();
/// For a loader that is older than that variable, after no device was found: the same in VK_DRIVER_FILES. False where there is
/// nothing to add.
[[nodiscard]] bool name_drivers_only();

/// What was tried, a place each: the loader's names, the variables that name drivers, folders with their files.
[[nodiscard]] ReportJson places_tried();

} // namespace windrow::cli
