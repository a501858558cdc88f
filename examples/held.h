// The value of a Result, or the end of an example: its sentence on the console, and an exit code.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <windrow/fluid/result.h>

[[noreturn]] inline void give_up(const std::string& sentence, int code = 2) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::exit(code);
}

template <class T>
T held(windrow::Result<T> result, int code = 2) {
    if (!result)
        give_up(result.error(), code);
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}
