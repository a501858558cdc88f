// Runs a fuzz target without libFuzzer: each seed must be accepted, each finding must come back, within the limits that every
// input is held to: 10 s and 1 GB.
//
// WINDROW_PARSERS is PARSER(name) for each that the build has: tests/fuzz/CMakeLists.txt.
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace windrow::fuzz {
#define PARSER(name) ReadOutcome read_##name(std::string_view bytes);
WINDROW_PARSERS
#undef PARSER
} // namespace windrow::fuzz

namespace {

namespace fs = std::filesystem;
using windrow::fuzz::ReadOutcome;

constexpr unsigned k_max_seconds = 10;
constexpr long k_max_kilobytes = 1'000'000;

using Parser = ReadOutcome (*)(std::string_view);

#define PARSER(name) {#name, windrow::fuzz::read_##name},
const std::map<std::string_view, Parser> k_parsers{WINDROW_PARSERS};
#undef PARSER

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Prints the file's name first: where the process ends, it is the last line.
ReadOutcome read_file(Parser parser, const fs::path& path) {
    std::printf("%s\n", path.c_str());
    std::fflush(stdout);
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    alarm(k_max_seconds);
    const ReadOutcome outcome = parser(bytes);
    alarm(0);
    return outcome;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 4 || !k_parsers.contains(arguments[1])) {
        std::fprintf(stderr, "usage: %s PARSER SEEDS FINDINGS\n", arguments[0]);
        return 2;
    }
    const Parser parser = k_parsers.at(arguments[1]);
    const auto seeds = files_of(arguments[2]);
    int faults = seeds.empty() ? 1 : 0;
    for (const fs::path& seed : seeds)
        if (read_file(parser, seed) != ReadOutcome::accepted) {
            std::printf("    is not accepted: write it again\n");
            ++faults;
        }
    for (const fs::path& finding : files_of(arguments[3]))
        (void)read_file(parser, finding);
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    std::printf("%zu seeds, %d faults, %ld kB\n", seeds.size(), faults, used.ru_maxrss);
    return faults == 0 && used.ru_maxrss <= k_max_kilobytes ? 0 : 1;
}
