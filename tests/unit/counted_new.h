// Every operator new of this program counted, the aligned ones too, and failed where a test asks for it.
#pragma once

#include <atomic>
#include <cstdint>

namespace windrow::test {

extern std::atomic<std::int64_t> live_bytes, allocations;

enum class Failing { once, from_then_on };
enum class Whose { all, of_the_program };

/// While it lives, `after` allocations of this thread succeed and the next one fails, or all from there on. Of the program: those
/// that a driver's libraries ask for always succeed.
class FailingMemory {
  public:
    FailingMemory(int after, Failing failing, Whose whose = Whose::all);
    ~FailingMemory();
    FailingMemory(const FailingMemory&) = delete;
    FailingMemory& operator=(const FailingMemory&) = delete;

    /// Some allocation has failed.
    [[nodiscard]] bool failed() const;
};

} // namespace windrow::test
