#include "fluid/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace windrow {
namespace {

constexpr auto k_spin = std::chrono::microseconds(20);

void relax() {
#if defined(__x86_64__)
    _mm_pause();
#endif
}

// True as soon as `ready` is; false after the spin time.
template <class Ready>
bool spin_until(const Ready& ready) {
    const auto end = std::chrono::steady_clock::now() + k_spin;
    do {
        for (int n = 0; n < 32; ++n) {
            if (ready())
                return true;
            relax();
        }
    } while (std::chrono::steady_clock::now() < end);
    return ready();
}

} // namespace

struct ThreadPool::State {
    // One loop at a time. `ticket` packs the loop's number (high half) with the next index to take (low half), so that a worker
    // that wakes late cannot take an index of a loop that it did not see.
    std::atomic<std::uint64_t> ticket{0};
    std::atomic<int> done{0};
    int count = 0;
    void (*task)(void*, int) = nullptr;
    void* argument = nullptr;

    std::mutex loop_mutex; ///< held by the thread whose loop runs
    std::mutex mutex;
    std::condition_variable start, finish;
    std::atomic<std::uint32_t> loop{0};
    std::atomic<int> inside{0}; ///< workers that may read the fields above
    std::atomic<bool> stop{false};
    std::vector<std::thread> workers;

    void take_indices(std::uint32_t number) {
        std::uint64_t seen = ticket.load(std::memory_order_acquire);
        for (;;) {
            if (static_cast<std::uint32_t>(seen >> 32) != number)
                return;
            const auto index = static_cast<int>(seen & 0xffffffffu);
            if (index >= count)
                return;
            if (!ticket.compare_exchange_weak(seen, seen + 1, std::memory_order_acq_rel))
                continue;
            task(argument, index);
            if (done.fetch_add(1, std::memory_order_acq_rel) + 1 == count) {
                const std::lock_guard lock(mutex);
                finish.notify_all();
            }
            seen = ticket.load(std::memory_order_acquire);
        }
    }

    void work() {
        std::uint32_t seen = 0;
        for (;;) {
            const auto ready = [&] { return stop.load(std::memory_order_acquire) || loop.load(std::memory_order_acquire) != seen; };
            if (!spin_until(ready)) {
                std::unique_lock lock(mutex);
                start.wait(lock, ready);
            }
            if (stop.load(std::memory_order_acquire))
                return;
            inside.fetch_add(1, std::memory_order_acq_rel);
            seen = loop.load(std::memory_order_acquire);
            take_indices(seen);
            inside.fetch_sub(1, std::memory_order_acq_rel);
        }
    }

    void run(int indices, void (*body)(void*, int), void* body_argument) {
        const std::lock_guard turn(loop_mutex);
        // A late worker of the last loop may still be looking at its fields.
        while (inside.load(std::memory_order_acquire) != 0)
            relax();
        const std::uint32_t number = loop.load(std::memory_order_relaxed) + 1;
        count = indices;
        task = body;
        argument = body_argument;
        done.store(0, std::memory_order_relaxed);
        ticket.store(static_cast<std::uint64_t>(number) << 32, std::memory_order_release);
        {
            const std::lock_guard lock(mutex);
            loop.store(number, std::memory_order_release);
        }
        start.notify_all();
        take_indices(number);
        const auto finished = [&] { return done.load(std::memory_order_acquire) == indices; };
        if (!spin_until(finished)) {
            std::unique_lock lock(mutex);
            finish.wait(lock, finished);
        }
    }
};

ThreadPool::ThreadPool(int threads) : state_(std::make_unique<State>()) {
    const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    for (int n = 1; n < wanted; ++n)
        state_->workers.emplace_back([state = state_.get()] { state->work(); });
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->stop.store(true, std::memory_order_release);
    }
    state_->start.notify_all();
    for (std::thread& worker : state_->workers)
        worker.join();
}

int ThreadPool::size() const { return static_cast<int>(state_->workers.size()) + 1; }

ParallelFor ThreadPool::parallel_for() {
    if (state_->workers.empty())
        return {};
    return {[](void* context, int count, void (*task)(void*, int), void* argument) { static_cast<State*>(context)->run(count, task, argument); },
            state_.get()};
}

} // namespace windrow
