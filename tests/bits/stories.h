// Stories whose bits are the same on every machine: what is promised is that these hashes are (docs/promises.md).
//
// The stories use sums, products and whole numbers alone to say what happens, so that a difference is the library's.
#pragma once

#include "fluid/parallel.h"
#include "fluid/simd.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace windrow::bits {

/// Of the bytes of one thing, such as meadow/cells/90.
struct Hash {
    std::string name;
    std::uint64_t value = 0;
    friend bool operator==(const Hash&, const Hash&) = default;
};

/// What a story has hashed so far.
class Hashes {
  public:
    explicit Hashes(std::string story) : story_(std::move(story)) {}
    void add(const std::string& what, std::span<const std::byte> bytes);
    template <class Value>
    void add(const std::string& what, const std::vector<Value>& values) {
        add(what, std::as_bytes(std::span(values)));
    }
    [[nodiscard]] const std::vector<Hash>& list() const { return list_; }

  private:
    std::string story_;
    std::vector<Hash> list_;
};

/// Integers that look random, the same everywhere.
class Numbers {
  public:
    explicit Numbers(std::uint32_t seed) : state_(seed) {}
    /// A multiple of 2^-16 from low to high, rounded once.
    float between(float low, float high);

  private:
    std::uint32_t state_;
};

/// Falls and rises evenly between -1 and 1 with a period of so many frames.
[[nodiscard]] double swing(int frame, int period);

/// What a story cannot do without: prints the reason and ends the program.
[[noreturn]] void give_up(const std::string& reason);
template <class Outcome>
decltype(auto) must(Outcome&& outcome) {
    if (!outcome)
        give_up(outcome.error());
    if constexpr (requires { *outcome; })
        return *std::forward<Outcome>(outcome);
}

/// A meadow in gusty wind: every kind of motor, follow, uneven frames, save and load.
[[nodiscard]] std::vector<Hash> meadow(Simd level, ParallelFor parallel_for);
/// Obstacles of every shape at rest, moving and turning, on terrain, in a box with rows of its own.
[[nodiscard]] std::vector<Hash> town(Simd level, ParallelFor parallel_for);
/// Stable fluids between walls of every kind, with viscosity and steps of uneven length.
[[nodiscard]] std::vector<Hash> duct(Simd level, ParallelFor parallel_for);
/// Still air that sleeps, wakes, sleeps again, and is saved asleep.
[[nodiscard]] std::vector<Hash> night(Simd level, ParallelFor parallel_for);
/// Plants in gusts: blades, shells, a tree, springs, a cascade, the memory of the ground. The same at every level.
[[nodiscard]] std::vector<Hash> plants(ParallelFor parallel_for);
/// The elementary functions that the others call. The same at every level.
[[nodiscard]] std::vector<Hash> functions();

/// All of them, names as "baseline/meadow/cells/90".
[[nodiscard]] std::vector<Hash> all_stories(Simd level, ParallelFor parallel_for);

} // namespace windrow::bits
