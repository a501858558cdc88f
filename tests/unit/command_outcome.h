// The command run as a user runs it: what it printed and how it ended.
#pragma once

#include "cli/console.h"
#include "tests/own_folder.h"

#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace windrow::cli {

struct CommandOutcome {
    int code;
    std::string out, err;
};

/// `windrow` with these words behind it.
inline CommandOutcome run_windrow(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "windrow");
    std::ostringstream out, err;
    const int code =
        run_command_line(static_cast<int>(arguments.size()), arguments.data(), {.out = out, .err = err, .progress = nullptr});
    return {code, out.str(), err.str()};
}
inline CommandOutcome run_windrow(const char* command, std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), command);
    return run_windrow(std::move(arguments));
}

/// What runs a command on a request of the test's own; `signal` asks it to stop.
template <class Request>
CommandOutcome run_request(int (*run)(const Request&, const Console&, const std::function<int()>&), const Request& request,
                           int signal) {
    std::ostringstream out, err;
    const int code = run(request, {.out = out, .err = err, .progress = nullptr}, [=] { return signal; });
    return {code, out.str(), err.str()};
}

/// A JSON file that a command wrote.
inline nlohmann::json json_in(const std::filesystem::path& file) {
    return nlohmann::json::parse(std::ifstream(file));
}

inline void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* const word : words)
        EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

/// Wrong use: one sentence, and nothing else.
inline void expect_rejected(const CommandOutcome& outcome, const std::string& sentence) {
    EXPECT_EQ(outcome.code, k_exit_wrong_use);
    EXPECT_EQ(outcome.err, "windrow: " + sentence + "\n");
    EXPECT_EQ(outcome.out, "");
}

} // namespace windrow::cli
