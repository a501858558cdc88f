// A small pool of threads for hosts without a job system of their own.
//
//     windrow::ThreadPool pool(4);
//     auto wind = windrow::Wind::create({.parallel_for = pool.parallel_for()});
//
// The calling thread works too. Waiting threads look for work for at most 20 microseconds, then sleep: when
// another program keeps the cores busy, waiting threads take no time from it.
#pragma once

#include "api.h"
#include "parallel.h"

#include <memory>

namespace windrow {

class WINDROW_API ThreadPool {
  public:
    /// `threads` in all, the caller's included; 0 takes one a core. One starts no thread. Where the system gives fewer (a limit on
    /// processes, no memory), the pool goes on with those: size().
    explicit ThreadPool(int threads = 0);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    /// Threads in all.
    [[nodiscard]] int size() const;
    /// The loop to hand to a Config. The pool must outlive what holds it; loops from several threads take turns. A task
    /// must not ask the same pool for a loop (it would wait for itself; asserted), nor throw.
    [[nodiscard]] ParallelFor parallel_for();

  private:
    struct State;
    std::unique_ptr<State> state_; ///< null: the caller works alone
};

} // namespace windrow
