// The tables of a report: printed as each section ends, and as Markdown at the end.
#pragma once

#include "cli/device_report/report_section.h"

namespace windrow::cli {

/// The figures of a section: a line for each value, a table for each list of objects, whose keys are the columns.
[[nodiscard]] std::string section_text(const ReportJson& section);
/// The page of a whole report: the device, times beside the copy floor, parity, pictures. Sections that did not run are named.
[[nodiscard]] std::string report_page(const ReportJson& report);
/// One row a grid for a README; a software device's figures are called so.
[[nodiscard]] std::string readme_table(const ReportJson& report);

} // namespace windrow::cli
