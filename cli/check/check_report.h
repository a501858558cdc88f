// What `windrow check` prints and keeps.
#pragma once

#include "cli/check/check_result.h"
#include "cli/console.h"

#include <string>

namespace windrow::cli {

void report_check_start(const vulkan::DeviceFacts& device, const Console& console);
/// Before the first story of a run, and after each.
void report_stories_start(const CheckedStories& run, const Console& console);
void report_story(const ParityResult& story, const Console& console);
void report_messages(const CheckedStories& run, const Console& console);
void report_verdict(const CheckResult& result, const Console& console);

[[nodiscard]] std::string check_json(const CheckResult& result);

} // namespace windrow::cli
