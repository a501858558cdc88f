// The pool runs each index once, returns when all have run, and ends cleanly, whoever asks and however often.

#include "fluid/thread_pool.h"
#include "tests/fields.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

#if !defined(_WIN32)
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace {

using namespace windrow;

int loops(int wanted) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    return wanted / 10; // each is ten times as slow there, and races are found by reasoning, not by luck
#else
    return wanted;
#endif
}

TEST(ThreadPool, RunsEachIndexOnceInLoopsOfAnySize) {
    for (const int threads : {2, 3, 8}) { // more threads than cores: workers that come late
        ThreadPool pool(threads);
        ASSERT_EQ(pool.size(), threads);
        const ParallelFor parallel_for = pool.parallel_for();
        test::Random random(91);
        std::vector<int> calls(300); // not atomic: a race is for the sanitizer to see
        int wrong = 0;
        for (int n = 0; n < loops(20'000); ++n) {
            // Small after large and large after small: an index left over from the last loop would show in either.
            const int count = n % 2 == 0 ? random.integer(0, 4) : random.integer(0, 300);
            std::fill(calls.begin(), calls.end(), 0);
            parallel_for(count, [&](int index) { ++calls[static_cast<std::size_t>(index)]; });
            for (int index = 0; index < 300; ++index)
                wrong += calls[static_cast<std::size_t>(index)] != (index < count ? 1 : 0);
        }
        EXPECT_EQ(wrong, 0) << threads << " threads";
    }
}

TEST(ThreadPool, RunsEachIndexOnceInLoopsOfMillions) {
    ThreadPool pool(3);
    for (const int count : {65'535, 65'536, 131'071, 3'000'001}) {
        std::vector<std::uint8_t> calls(static_cast<std::size_t>(count));
        pool.parallel_for()(count, [&](int index) { ++calls[static_cast<std::size_t>(index)]; });
        EXPECT_EQ(std::count(calls.begin(), calls.end(), 1), count);
    }
}

TEST(ThreadPool, WhatTheTasksWroteIsThereWhenTheLoopReturns) {
    ThreadPool pool(4);
    const ParallelFor parallel_for = pool.parallel_for();
    std::vector<std::uint64_t> values(64, 1);
    for (int n = 0; n < loops(5'000); ++n) {
        // Each loop reads what the last one wrote in other threads.
        std::vector<std::uint64_t> next(64);
        parallel_for(64, [&](int i) { next[i] = values[i] + 3 * values[(i + 1) % 64] + values[(i + 63) % 64]; });
        values = next;
    }
    EXPECT_TRUE(std::all_of(values.begin(), values.end(), [&](std::uint64_t value) { return value == values[0]; }));
}

TEST(ThreadPool, SeveralHostThreadsTakeTurns) {
    ThreadPool pool(3);
    const ParallelFor parallel_for = pool.parallel_for();
    std::atomic<int> wrong{0};
    std::vector<std::thread> hosts;
    for (int host = 0; host < 4; ++host)
        hosts.emplace_back([&, host] {
            for (int n = 0; n < loops(2'000); ++n) {
                const int count = 2 + (n * 7 + host * 13) % 40;
                std::vector<int> calls(static_cast<std::size_t>(count), 0);
                parallel_for(count, [&](int index) { calls[static_cast<std::size_t>(index)] += host + 1; });
                wrong += std::accumulate(calls.begin(), calls.end(), 0) != count * (host + 1);
            }
        });
    for (std::thread& host : hosts)
        host.join();
    EXPECT_EQ(wrong.load(), 0);
}

TEST(ThreadPool, OnePoolMayWorkInsideAnother) {
    ThreadPool outer(3), inner(2);
    const ParallelFor outside = outer.parallel_for(), inside = inner.parallel_for();
    std::vector<int> calls(6 * 50, 0);
    for (int n = 0; n < loops(200); ++n)
        outside(6, [&](int i) { inside(50, [&, i](int j) { ++calls[static_cast<std::size_t>(i * 50 + j)]; }); });
    EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](int count) { return count == loops(200); }));
}

TEST(ThreadPool, EndsAtOnce) {
    for (int n = 0; n < loops(300); ++n) {
        ThreadPool unused(1 + n % 8);
        ThreadPool used(1 + n % 8);
        std::atomic<int> sum{0};
        used.parallel_for()(5, [&](int index) { sum += index; });
        EXPECT_EQ(sum.load(), 10);
    }
}

// Long after the last loop the workers sleep: a loop wakes them, and so does the end.
TEST(ThreadPool, WakesThoseWhoSleep) {
    for (int n = 0; n < 20; ++n) {
        ThreadPool pool(2 + n % 3);
        for (int loop = 0; loop < 3; ++loop) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            std::atomic<int> sum{0};
            pool.parallel_for()(100, [&](int index) { sum += index; });
            EXPECT_EQ(sum.load(), 4950);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

TEST(ThreadPool, WithOneThreadItIsThePlainLoop) {
    ThreadPool one(1);
    EXPECT_EQ(one.size(), 1);
    EXPECT_EQ(one.parallel_for().run, nullptr);
    EXPECT_GE(ThreadPool(0).size(), 1);
    std::vector<int> order;
    one.parallel_for()(5, [&](int index) { order.push_back(index); });
    EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
    one.parallel_for()(0, [&](int) { ADD_FAILURE(); });
    one.parallel_for()(-3, [&](int) { ADD_FAILURE(); });
}

TEST(ThreadPool, AWorkloadOfUnevenTasksEnds) {
    ThreadPool pool(4);
    std::atomic<std::uint64_t> sum{0};
    for (int n = 0; n < loops(200); ++n)
        pool.parallel_for()(16, [&](int index) {
            std::uint64_t value = 1;
            for (int turn = 0; turn < (index % 5 == 0 ? 20'000 : 1); ++turn)
                value = value * 6364136223846793005u + 1442695040888963407u;
            sum += value != 0;
        });
    EXPECT_EQ(sum.load(), 16u * loops(200));
}

#if !defined(_WIN32)
// As a container or `ulimit -u` limits them. A process of its own, as a user whose limit holds: the superuser has none.
TEST(ThreadPool, GoesOnWithTheThreadsThatTheSystemGives) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "ThreadSanitizer watches no threads of a process that was forked";
#endif
    for (const rlim_t most : {rlim_t{1}, rlim_t{4}}) {
        const pid_t child = ::fork();
        if (child == 0) {
            const rlimit limit{most, most};
            if (::setrlimit(RLIMIT_NPROC, &limit) != 0 || (::geteuid() == 0 && ::setuid(65534) != 0))
                ::_exit(9);
            ThreadPool pool(64);
            std::vector<int> calls(1000);
            const auto count = [&](int n) { ++calls[static_cast<std::size_t>(n)]; };
            pool.parallel_for()(1000, count);
            const bool once = std::all_of(calls.begin(), calls.end(), [](int n) { return n == 1; });
            ::_exit(once ? std::min(pool.size(), 100) : 200);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
        if (WEXITSTATUS(status) == 9)
            GTEST_SKIP() << "this user may not set a limit";
        EXPECT_GE(WEXITSTATUS(status), 1);
        EXPECT_LT(WEXITSTATUS(status), 64);
    }
}
#endif

#if !defined(NDEBUG) && !defined(__SANITIZE_THREAD__)
TEST(ThreadPoolDeathTest, ALoopWithinALoopIsNamed) {
    testing::FLAGS_gtest_death_test_style = "threadsafe"; // this program has threads
    ThreadPool pool(2);
    const ParallelFor loop = pool.parallel_for();
    EXPECT_DEATH(loop(8, [&](int) { loop(8, [](int) {}); }), "would wait for itself");
}
#endif

#if defined(__unix__) && !defined(__SANITIZE_THREAD__)
// A child of fork has none of its parent's threads: its loops run in its own, and it ends (Python's multiprocessing before 3.14).
TEST(ThreadPool, WorksAloneInAChildOfFork) {
    ThreadPool pool(4);
    const ParallelFor loop = pool.parallel_for();
    std::atomic<int> sum{0};
    loop(100, [&](int n) { sum += n; });
    ASSERT_EQ(sum, 4950);
    const pid_t child = fork();
    if (child == 0) {
        alarm(20); // a child that waits for threads is killed
        sum = 0;
        {
            ThreadPool own(2);
            own.parallel_for()(100, [&](int n) { sum += n; });
        }
        loop(100, [&](int n) { sum += n; });
        _exit(sum == 9900 ? 0 : 1);
    }
    ASSERT_GT(child, 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    loop(100, [&](int n) { sum += n; });
    EXPECT_EQ(sum, 9900) << "the parent goes on";
}
#endif

} // namespace
