// What reading a file costs: a function is run in a process of its own, so that its peak memory is its own and a hang ends.
#pragma once

#include "tests/tier.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace windrow::test {

/// What `read` returned, an error's sentence. The test fails unless it ends within 10 s of processor time, 30 s of the clock and
/// 1 GiB of memory; under a sanitizer, which takes many times as much, within 300 s of the clock.
inline std::string sentence_of_cheap(const std::function<std::string()>& read) {
    constexpr unsigned k_max_seconds = 10;
    constexpr long k_max_kibibytes = 1L << 20;
    int ends[2] = {};
    if (::pipe(ends) != 0)
        return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        ::alarm(k_sanitized ? 300 : 3 * k_max_seconds);
        if (!k_sanitized) {
            // More than is allowed, so that the excess is seen, but not all of the machine.
            const rlimit seconds{k_max_seconds, k_max_seconds}, bytes{rlim_t{4} << 30, rlim_t{4} << 30};
            ::setrlimit(RLIMIT_CPU, &seconds);
            ::setrlimit(RLIMIT_AS, &bytes);
        }
        const std::string sentence = read().substr(0, 1000);
        const bool written = ::write(ends[1], sentence.data(), sentence.size()) == static_cast<ssize_t>(sentence.size());
        ::_exit(written ? 0 : 1);
    }
    ::close(ends[1]);
    std::string sentence(1000, '\0');
    const ssize_t got = ::read(ends[0], sentence.data(), sentence.size());
    ::close(ends[0]);
    sentence.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    int status = 0;
    rusage used{};
    EXPECT_EQ(::wait4(child, &status, 0, &used), child);
    EXPECT_FALSE(WIFSIGNALED(status)) << "ended by signal " << WTERMSIG(status) << ": too slow, too large or a hang";
    if (!k_sanitized) {
        EXPECT_LT(used.ru_maxrss, k_max_kibibytes) << sentence;
    }
    return sentence;
}

} // namespace windrow::test
