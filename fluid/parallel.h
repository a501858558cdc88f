// Parallel loop of the host for the solver; without one the solver runs serially.
//
// The library starts no thread by itself. A host with a job system passes a function pointer and a context; other hosts use
// `ThreadPool` (thread_pool.h). The work is divided in the same way for any number of threads, so results do not depend on it.
#pragma once

#include <type_traits>

namespace windrow {

/// A host's parallel loop, as a function pointer with its context: no allocation, no ownership.
struct ParallelFor {
    /// Calls task(argument, i) once for each i in [0, count), in any order and on any threads, and returns when all are done.
    using Run = void (*)(void* context, int count, void (*task)(void* argument, int index), void* argument);

    Run run = nullptr;       ///< null: a serial loop in the caller's thread.
    void* context = nullptr; ///< Handed to `run`; must outlive every object that holds this ParallelFor.

    /// Runs body(i) for each i in [0, count).
    template <class Body>
    void operator()(int count, Body&& body) const {
        if (run == nullptr || count <= 1) {
            for (int index = 0; index < count; ++index)
                body(index);
            return;
        }
        using Plain = std::remove_reference_t<Body>;
        run(
            context, count, [](void* argument, int index) { (*static_cast<Plain*>(argument))(index); },
            const_cast<std::remove_const_t<Plain>*>(&body));
    }
};

} // namespace windrow
