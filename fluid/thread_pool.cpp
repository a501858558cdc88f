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

// One loop at a time. Its fields change only under the mutex and while no worker is inside, and a worker enters and
// copies them under the same mutex: a worker that wakes late can take nothing of a loop that it did not enter.
struct ThreadPool::State {
    struct Loop {
        int count = 0;
        void (*task)(void*, int) = nullptr;
        void* argument = nullptr;
    };

    std::mutex turn; ///< held by the thread whose loop runs
    std::mutex mutex;
    std::condition_variable start, finish;
    Loop loop;
    std::atomic<std::uint32_t> number{0}; ///< of the loop
    std::atomic<int> next{0};             ///< first index that nobody has taken
    std::atomic<int> done{0};
    std::atomic<int> inside{0}; ///< workers that hold a copy of the loop
    std::atomic<bool> stop{false};
    std::vector<std::thread> workers;

    void take_indices(const Loop& entered) {
        for (;;) {
            const int index = next.fetch_add(1, std::memory_order_relaxed);
            if (index >= entered.count)
                return;
            entered.task(entered.argument, index);
            done.fetch_add(1, std::memory_order_acq_rel);
        }
    }

    void work() {
        std::uint32_t seen = 0;
        const auto ready = [&] { return stop.load(std::memory_order_acquire) || number.load(std::memory_order_acquire) != seen; };
        for (;;) {
            spin_until(ready);
            Loop entered;
            {
                std::unique_lock lock(mutex);
                start.wait(lock, ready);
                if (stop.load(std::memory_order_relaxed))
                    return;
                seen = number.load(std::memory_order_relaxed);
                entered = loop;
                inside.fetch_add(1, std::memory_order_relaxed);
            }
            take_indices(entered);
            if (inside.fetch_sub(1, std::memory_order_acq_rel) == 1) {
                const std::lock_guard lock(mutex);
                finish.notify_all();
            }
        }
    }

    void run(const Loop& wanted) {
        const std::lock_guard my_turn(turn);
        const auto nobody_inside = [&] { return inside.load(std::memory_order_acquire) == 0; };
        spin_until(nobody_inside);
        {
            std::unique_lock lock(mutex);
            finish.wait(lock, nobody_inside);
            loop = wanted;
            next.store(0, std::memory_order_relaxed);
            done.store(0, std::memory_order_relaxed);
            number.fetch_add(1, std::memory_order_release);
        }
        start.notify_all();
        take_indices(wanted);
        // What is left is in the hands of workers inside; the last one to leave says so.
        const auto finished = [&] { return done.load(std::memory_order_acquire) == wanted.count; };
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

int ThreadPool::size() const {
    return static_cast<int>(state_->workers.size()) + 1;
}

ParallelFor ThreadPool::parallel_for() {
    if (state_->workers.empty())
        return {};
    return {[](void* context, int count, void (*task)(void*, int), void* argument) {
                static_cast<State*>(context)->run({count, task, argument});
            },
            state_.get()};
}

} // namespace windrow
