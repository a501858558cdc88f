#include "fluid/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#endif
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace windrow {
namespace {

constexpr auto k_spin = std::chrono::microseconds(20);
constexpr std::size_t k_cache_line = 64;
constexpr int k_patience = 48; ///< pauses, about a microsecond: the cost of fetching another core's planes

void relax() {
#if defined(__x86_64__)
    _mm_pause();
#endif
}

// How often the process has become a child of itself. A pool's threads stay with the parent: loops of the child run in its own.
std::atomic<int> forks{0};

void count_forks() {
#if defined(__unix__) || defined(__APPLE__)
    static const int counted = pthread_atfork(nullptr, nullptr, [] { forks.fetch_add(1, std::memory_order_relaxed); });
    (void)counted;
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

// A thread's range of a loop, in one word: the loop, the first free block, and the end of the range. A thread that wakes late
// and takes from an ended loop fails: the range is used up, or the word has changed.
struct Share {
    std::uint32_t loop = 0;
    std::uint16_t next = 0, end = 0;

    Share() = default;
    explicit Share(std::uint64_t word)
        : loop(static_cast<std::uint32_t>(word >> 32)), next(static_cast<std::uint16_t>(word >> 16)),
          end(static_cast<std::uint16_t>(word)) {}
    [[nodiscard]] std::uint64_t word() const {
        return (static_cast<std::uint64_t>(loop) << 32) | (static_cast<std::uint64_t>(next) << 16) | end;
    }
};
constexpr int k_max_blocks = 0xffff; ///< of a loop

struct alignas(k_cache_line) ShareWord {
    std::atomic<std::uint64_t> word{0};
};

} // namespace

// One loop at a time. Each thread has the same range of every loop, so that its last results are still in its cache. It takes
// from the ranges of late threads: long runs first and single blocks at the end, so that a thread whose core is taken away
// delays the loop little. A waiting thread spins briefly, then sleeps.
//
// A loop is written before its ranges open, and the next one when all ranges are used up. A thread that takes from a range has
// read the loop of that range.
struct WINDROW_HIDDEN ThreadPool::State {
    using Task = void (*)(void*, int);

    std::mutex turn; ///< held by the thread whose loop runs
    std::atomic<Task> task{nullptr};
    std::atomic<void*> argument{nullptr};
    std::atomic<int> count{0};
    std::atomic<int> block{1}; ///< indices that are taken together: 1, except for loops of more than k_max_blocks
    std::atomic<bool> stop{false};
    alignas(k_cache_line) std::atomic<int> left{0}; ///< blocks whose tasks have not returned

    alignas(k_cache_line) std::mutex mutex; ///< for sleeping only
    std::condition_variable start, finish;
    std::atomic<int> asleep{0}; ///< workers that a new loop must wake
    std::atomic<bool> caller_asleep{false};

    const int made_in = forks.load(std::memory_order_relaxed);
    std::uint32_t loops = 0;             ///< so far; under `turn`
    std::unique_ptr<ShareWord[]> shares; ///< one a thread, the caller's first
    std::vector<std::thread> workers;

    [[nodiscard]] int threads() const { return static_cast<int>(workers.size()) + 1; }
    /// The threads are another process's.
    [[nodiscard]] bool forked() const { return forks.load(std::memory_order_relaxed) != made_in; }

#ifndef NDEBUG
    static inline thread_local const State* running = nullptr; ///< the pool whose task this thread runs
#endif

    void run_task(Task run_one, void* context, int index) {
#ifndef NDEBUG
        running = this;
#endif
        run_one(context, index);
#ifndef NDEBUG
        running = nullptr;
#endif
    }

    // Runs blocks of a range until none is left; returns their number.
    int take_from(std::atomic<std::uint64_t>& share, std::uint32_t loop) {
        int taken = 0;
        std::uint64_t word = share.load(std::memory_order_acquire);
        const Task run_one = task.load(std::memory_order_acquire);
        void* const context = argument.load(std::memory_order_acquire);
        const std::int64_t end = count.load(std::memory_order_acquire), size = block.load(std::memory_order_acquire);
        for (;;) {
            Share rest(word);
            if (rest.loop != loop || rest.next >= rest.end)
                return taken;
            const int first = rest.next, blocks = std::max(1, (rest.end - first) / 3);
            rest.next = static_cast<std::uint16_t>(first + blocks);
            if (!share.compare_exchange_weak(word, rest.word(), std::memory_order_acq_rel, std::memory_order_acquire))
                continue;
            word = rest.word();
            for (std::int64_t index = first * size; index < std::min(end, rest.next * size); ++index)
                run_task(run_one, context, static_cast<int>(index));
            taken += blocks;
        }
    }

    // The thread's own range first; then, after a short wait, the rest of the others' ranges. True if this thread ended the loop.
    bool take(int own, std::uint32_t loop) {
        const auto ends_with = [this](int taken) {
            return taken > 0 && left.fetch_sub(taken, std::memory_order_seq_cst) == taken;
        };
        if (ends_with(take_from(shares[static_cast<std::size_t>(own)].word, loop)))
            return true;
        for (int n = 0; n < k_patience; ++n) {
            if (left.load(std::memory_order_acquire) == 0)
                return false;
            relax();
        }
        int taken = 0;
        for (int n = 1; n < threads(); ++n)
            taken += take_from(shares[static_cast<std::size_t>((own + n) % threads())].word, loop);
        return ends_with(taken);
    }

    void work(int own) {
        std::uint32_t seen = 0;
        const std::atomic<std::uint64_t>& share = shares[static_cast<std::size_t>(own)].word;
        const auto ready = [&] {
            return stop.load(std::memory_order_acquire) || Share(share.load(std::memory_order_seq_cst)).loop != seen;
        };
        for (;;) {
            if (!spin_until(ready)) {
                std::unique_lock lock(mutex);
                asleep.fetch_add(1, std::memory_order_seq_cst);
                start.wait(lock, ready);
                asleep.fetch_sub(1, std::memory_order_seq_cst);
            }
            if (stop.load(std::memory_order_acquire))
                return;
            seen = Share(share.load(std::memory_order_acquire)).loop;
            if (take(own, seen) && caller_asleep.load(std::memory_order_seq_cst)) {
                const std::lock_guard lock(mutex); // not between the caller's look and its sleep
                finish.notify_one();
            }
        }
    }

    void run(int wanted, Task wanted_task, void* wanted_argument) {
        assert(running != this && "a task of a pool's loop asked the same pool for a loop: it would wait for itself");
        if (forked()) {
            for (int index = 0; index < wanted; ++index)
                run_task(wanted_task, wanted_argument, index);
            return;
        }
        const std::lock_guard my_turn(turn);
        const int size = (wanted - 1) / k_max_blocks + 1, blocks = (wanted - 1) / size + 1;
        task.store(wanted_task, std::memory_order_release);
        argument.store(wanted_argument, std::memory_order_release);
        count.store(wanted, std::memory_order_release);
        block.store(size, std::memory_order_release);
        left.store(blocks, std::memory_order_relaxed);
        ++loops;
        for (int n = threads() - 1; n >= 0; --n) { // the workers first: they take longer to start
            Share share;
            share.loop = loops;
            share.next = static_cast<std::uint16_t>(static_cast<std::int64_t>(blocks) * n / threads());
            share.end = static_cast<std::uint16_t>(static_cast<std::int64_t>(blocks) * (n + 1) / threads());
            shares[static_cast<std::size_t>(n)].word.store(share.word(), std::memory_order_seq_cst);
        }
        if (asleep.load(std::memory_order_seq_cst) > 0) {
            { const std::lock_guard lock(mutex); } // not between a worker's look and its sleep
            start.notify_all();
        }
        take(0, loops);
        const auto finished = [&] { return left.load(std::memory_order_seq_cst) == 0; };
        if (!spin_until(finished)) {
            std::unique_lock lock(mutex);
            caller_asleep.store(true, std::memory_order_seq_cst);
            finish.wait(lock, finished);
            caller_asleep.store(false, std::memory_order_relaxed);
        }
    }
};

ThreadPool::ThreadPool(int threads) {
    const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    count_forks();
    // On lack of memory or a limit on processes, the pool keeps the threads that it has.
    try {
        state_ = std::make_unique<State>();
        state_->shares = std::make_unique<ShareWord[]>(static_cast<std::size_t>(wanted));
        state_->workers.reserve(static_cast<std::size_t>(wanted) - 1);
        for (int n = 1; n < wanted; ++n)
            state_->workers.emplace_back([state = state_.get(), n] { state->work(n); });
    } catch (const std::bad_alloc&) {
    } catch (const std::system_error&) {
    }
}

ThreadPool::~ThreadPool() {
    if (!state_)
        return;
    if (state_->forked()) { // none to join, and a lock may be held for good
        (void)state_.release();
        return;
    }
    {
        const std::lock_guard lock(state_->mutex);
        state_->stop.store(true, std::memory_order_release);
    }
    state_->start.notify_all();
    for (std::thread& worker : state_->workers)
        worker.join();
}

int ThreadPool::size() const {
    return state_ ? state_->threads() : 1;
}

ParallelFor ThreadPool::parallel_for() {
    if (size() == 1)
        return {};
    return {[](void* context, int count, void (*task)(void*, int), void* argument) {
                static_cast<State*>(context)->run(count, task, argument);
            },
            state_.get()};
}

} // namespace windrow
