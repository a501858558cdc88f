#include "cli/bench/vulkan/device_bench.h"
#include "cli/check/check_command.h"
#include "cli/info_command.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

constexpr TableFormat k_table{.name_width = 22, .width = 12};

} // namespace

void report_check_start(const vulkan::DeviceFacts& device, const Console& console) {
    console.out << version_line() << " check; " << compiler_name() << "; commit " << commit_name() << "\n"
                << words_of(device) << "\n";
    console.out.flush();
}

void report_stories_start(const CheckedStories& run, const Console& console) {
    console.out << "\nThe device against the CPU, largest difference over the largest velocity; validation: " << run.validation
                << "\n"
                << k_table.line("story", {"cells", "steps", "first step", "bound", "any step", "bound", "sub-steps", "dispatches",
                                          "messages", "verdict"});
    console.out.flush();
}

void report_story(const cases::ParityResult& story, const Console& console) {
    console.out << k_table.line(story.name, {grid_name(story.cells), message(story.steps), to_scientific(story.first, 1),
                                             to_scientific(story.first_bound, 1), to_scientific(story.largest, 1),
                                             to_scientific(story.bound, 1), message(story.max_substeps),
                                             message(story.dispatches), message(story.messages), story.pass() ? "pass" : "FAIL"});
    console.out.flush();
}

void report_messages(const CheckedStories& run, const Console& console) {
    for (const std::string& sentence : run.broken)
        console.complain(sentence);
    for (const std::string& text : run.messages)
        console.complain("the validation layer says: " + text);
    if (run.message_count > static_cast<int>(run.messages.size()))
        console.complain(message("the validation layer reported ", run.message_count, " messages."));
}

void report_verdict(const CheckResult& result, const Console& console) {
    std::size_t stories = 0, passed = 0, broken = 0;
    int messages = 0;
    std::string validation;
    for (const CheckedStories& run : result.runs) {
        stories += run.stories.size() + run.broken.size();
        broken += run.broken.size();
        messages += run.message_count;
        for (const cases::ParityResult& story : run.stories)
            passed += story.pass() ? 1 : 0;
        validation += (validation.empty() ? "" : ", then ") + run.validation;
    }
    console.out << "\n"
                << (result.pass() ? "PASS" : "FAIL") << ": " << result.device.name << " (driver " << result.device.driver
                << (result.device.software ? ", software device" : "") << "): " << passed << " of " << stories
                << " stories within their bounds" << (broken > 0 ? message(", ", broken, " could not run") : std::string())
                << "; validation: " << validation << ", " << messages << (messages == 1 ? " message" : " messages") << ".\n";
    console.out.flush();
}

std::string check_json(const CheckResult& result) {
    using Json = nlohmann::ordered_json;
    Json json = {{"device", result.device.name},   {"software", result.device.software},
                 {"driver", result.device.driver}, {"vulkan", result.device.api_version},
                 {"compiler", compiler_name()},    {"commit", commit_name()},
                 {"pass", result.pass()},          {"runs", Json::array()}};
    for (const CheckedStories& run : result.runs) {
        Json stories = Json::array();
        for (const cases::ParityResult& story : run.stories)
            stories.push_back({{"name", story.name},
                               {"grid", grid_name(story.cells)},
                               {"steps", story.steps},
                               {"first", story.first}, // what is not finite becomes null
                               {"first_bound", story.first_bound},
                               {"last", story.last},
                               {"largest", story.largest},
                               {"bound", story.bound},
                               {"largest_component", story.largest_component},
                               {"max_substeps", story.max_substeps},
                               {"dispatches", story.dispatches},
                               {"barriers", story.barriers},
                               {"messages", story.messages},
                               {"pass", story.pass()}});
        json["runs"].push_back({{"validation", run.validation},
                                {"validated", run.validated},
                                {"messages", run.message_count},
                                {"broken", run.broken},
                                {"stories", stories}});
    }
    json["bench"] = device_bench(result.bench);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace windrow::cli
