// Whether a sanitizer watches: then tests do less of the same.
#pragma once

namespace windrow::test {

/// A sanitizer runs the same steps fifteen times slower, and finds in the first of them what it looks for.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool k_sanitized = true;
#else
inline constexpr bool k_sanitized = false;
#endif

} // namespace windrow::test
