// Methods timed in one interleaved run: what the machine does meanwhile meets all of them alike.
//
// A round gives each contestant one turn; the order rotates from round to round and turns about, so that nobody always follows
// the same. A turn is one call that is not timed, which brings the contestant's memory back into cache (left out where a call is
// so long that it makes no difference), and then samples for a millisecond, at least one. A ratio of two contestants is the
// median over the rounds of the ratio of their turns, which lie next to each other in time: the machine's own wandering cancels.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace windrow::cli {

/// Samples from which on a 99 % quantile is more than the largest.
inline constexpr std::size_t k_enough_samples = 100;

/// What the samples of one figure say. The quantiles are nearest ranks.
struct Spread {
    double min = 0.0;
    double median = 0.0;
    double p99 = 0.0;
    std::size_t samples = 0;
};
[[nodiscard]] Spread spread_of(const std::vector<float>& values);

struct Contestant {
    std::function<void()> run;             ///< what is timed
    std::function<void()> prepare = [] {}; ///< before each sample, not timed
    std::function<void()> note = [] {};    ///< after each sample, not timed
    bool repeats = true;                   ///< a sample may be several runs behind one `prepare`, as short ones need
};

class Contest {
  public:
    /// Returns the contestant's number.
    std::size_t add(Contestant contestant);
    /// Rounds for `seconds`, and on until each contestant has enough samples, at most ten times as long. False if stopped.
    [[nodiscard]] bool hold(double seconds, const std::function<bool()>& stopped);

    [[nodiscard]] Spread milliseconds(std::size_t contestant) const;
    /// Median over the rounds of the time of `a` over that of `b`.
    [[nodiscard]] double ratio(std::size_t a, std::size_t b) const;
    [[nodiscard]] std::size_t rounds() const { return rounds_; }

  private:
    struct Entry {
        Contestant contestant;
        int runs_a_sample = 0;        ///< 0: not known yet
        double expected_ms = 0.0;     ///< of a sample
        std::vector<float> samples{}; ///< [ms] of a run
        std::vector<float> turns{};   ///< [ms] of a run, the median of each turn
    };
    static void take_turn(Entry& entry);

    std::vector<Entry> entries_;
    std::size_t rounds_ = 0;
};

} // namespace windrow::cli
