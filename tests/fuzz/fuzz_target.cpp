// libFuzzer's entry. Executions are counted in a mapped file, so that a crash loses no count.
#include "tests/fuzz/fuzz_target.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace windrow::fuzz {
namespace {

struct Counts {
    std::uint64_t executions = 0, accepted = 0;
};

/// The file that WINDROW_FUZZ_COUNTS names, or memory of the process where it names none.
Counts& counts() {
    static Counts own;
    static Counts* const mapped = [] {
        const char* const name = std::getenv("WINDROW_FUZZ_COUNTS");
        const int file = name != nullptr ? open(name, O_RDWR | O_CREAT, 0644) : -1;
        if (file < 0 || ftruncate(file, sizeof(Counts)) != 0)
            return &own;
        void* const memory = mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
        return memory == MAP_FAILED ? &own : static_cast<Counts*>(memory);
    }();
    return *mapped;
}

constexpr std::size_t k_remembered = 256, k_longest = 16384;
std::size_t remembered_count = 0;

/// Room for the inputs is made before the first: an execution that keeps memory makes LeakSanitizer look through all of it.
std::string& remembered(std::size_t index) {
    static std::array<std::string, k_remembered> inputs;
    return inputs[index % k_remembered];
}

[[maybe_unused]] const bool room = [] {
    for (std::size_t n = 0; n < k_remembered; ++n)
        remembered(n).reserve(k_longest);
    return true;
}();

} // namespace

std::string_view accepted_input(std::uint32_t random) {
    const std::size_t count = remembered_count < k_remembered ? remembered_count : k_remembered;
    return count == 0 ? std::string_view() : remembered(random % count);
}

} // namespace windrow::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace windrow::fuzz;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const ReadOutcome outcome = read_input(bytes);
    if (outcome == ReadOutcome::skipped)
        return 0;
    ++counts().executions;
    if (outcome == ReadOutcome::accepted) {
        ++counts().accepted;
        if (size <= k_longest)
            remembered(remembered_count++) = bytes;
    }
    return 0;
}
