#include "cli/bench/contest.h"

#include "cli/timings.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace windrow::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double k_sample_ms = 0.02; // a sample is at least so long: a hundred times what reading the clock takes
constexpr double k_turn_ms = 1.0;
constexpr double k_long_call_ms = 5.0; // such a call walks through more memory than what a cache keeps from the turn before
constexpr std::size_t k_max_in_turn = 32;
constexpr int k_max_runs = 1000;
constexpr double k_patience = 10.0; // budgets

double since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace

Spread spread_of(const std::vector<float>& values) {
    return {quantile(values, 0.0), quantile(values, 0.5), quantile(values, 0.99), values.size()};
}

std::size_t Contest::add(Contestant contestant) {
    entries_.push_back({.contestant = std::move(contestant)});
    return entries_.size() - 1;
}

void Contest::take_turn(Entry& entry) {
    const Contestant& contestant = entry.contestant;
    const auto timed = [&](int runs) {
        contestant.prepare();
        const auto start = Clock::now();
        for (int n = 0; n < runs; ++n)
            contestant.run();
        return since(start);
    };
    if (entry.runs_a_sample == 0) {
        timed(1);
        const double once = timed(1);
        entry.runs_a_sample =
            contestant.repeats ? std::clamp(static_cast<int>(std::ceil(k_sample_ms / std::max(once, 1e-5))), 1, k_max_runs) : 1;
        entry.expected_ms = once;
    } else if (entry.expected_ms < k_long_call_ms) {
        timed(1);
    }
    double spent = 0.0;
    std::vector<float> turn;
    do {
        const double sample = timed(entry.runs_a_sample);
        contestant.note();
        spent += sample;
        turn.push_back(static_cast<float>(sample / entry.runs_a_sample));
    } while (spent < k_turn_ms && turn.size() < k_max_in_turn);
    entry.samples.insert(entry.samples.end(), turn.begin(), turn.end());
    entry.turns.push_back(quantile(std::move(turn), 0.5));
}

bool Contest::hold(double seconds, const std::function<bool()>& stopped) {
    const auto start = Clock::now();
    const auto enough = [&] {
        const double spent = since(start) / 1000.0;
        const bool sampled = std::all_of(entries_.begin(), entries_.end(),
                                         [](const Entry& entry) { return entry.samples.size() >= k_enough_samples; });
        return rounds_ > 0 && spent >= seconds && (sampled || spent >= k_patience * seconds);
    };
    const std::size_t count = entries_.size();
    while (!enough()) {
        for (std::size_t n = 0; n < count; ++n) {
            if (stopped())
                return false;
            const std::size_t place = rounds_ % 2 == 0 ? n : count - 1 - n;
            take_turn(entries_[(place + rounds_ / 2) % count]);
        }
        ++rounds_;
    }
    return true;
}

Spread Contest::milliseconds(std::size_t contestant) const {
    return spread_of(entries_[contestant].samples);
}

double Contest::ratio(std::size_t a, std::size_t b) const {
    std::vector<float> ratios;
    for (std::size_t round = 0; round < rounds_; ++round)
        ratios.push_back(entries_[a].turns[round] / entries_[b].turns[round]);
    return quantile(std::move(ratios), 0.5);
}

} // namespace windrow::cli
