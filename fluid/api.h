// Demands of the public headers on a host's compiler and GLM, each a sentence at compile time, and the mark of what is exported.
//
// The library takes and returns GLM's types by value. Macros of GLM change how these are laid out and passed, so that a host that
// defines one would crash in a library that was built without it.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) < 202002L
#error "Windrow needs C++20: compile with -std=c++20, with /std:c++20 (MSVC), or with target_compile_features(... cxx_std_20)."
#endif

#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <type_traits>

/// Marks each class and function that a shared library exports; all others are hidden. On Windows the shared library is the C
/// interface alone.
#if defined(WINDROW_STATIC) || defined(_WIN32)
#define WINDROW_API
#else
#define WINDROW_API __attribute__((visibility("default")))
#endif
/// Of a class within an exported one: not exported with it.
#if defined(_WIN32)
#define WINDROW_HIDDEN
#else
#define WINDROW_HIDDEN __attribute__((visibility("hidden")))
#endif
/// Exported for Windrow's own other libraries; no promise to users.
#define WINDROW_INTERNAL WINDROW_API

namespace windrow::detail {

template <class... Types>
inline constexpr bool k_trivial = ((std::is_trivially_default_constructible_v<Types> &&
                                    std::is_trivially_copyable_v<Types>)&&...);
template <class Number, int count, class Vector>
inline constexpr bool k_packed = sizeof(Vector) == count * sizeof(Number) && alignof(Vector) == alignof(Number);

static_assert(k_trivial<glm::vec3, glm::vec4, glm::ivec3, glm::dvec3, glm::bvec3, glm::quat, glm::mat4>,
              "Windrow is built without GLM_FORCE_CTOR_INIT, which changes how GLM's types are passed: do not define it where "
              "Windrow's headers are included, or use the C interface, which has no GLM.");
static_assert(
    k_packed<float, 3, glm::vec3> && k_packed<float, 4, glm::vec4> && k_packed<int, 3, glm::ivec3> &&
        k_packed<double, 3, glm::dvec3> && k_packed<float, 4, glm::quat> && k_packed<float, 16, glm::mat4>,
    "Windrow is built without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES, which changes the size and alignment of GLM's types: do "
    "not define it where Windrow's headers are included, or use the C interface, which has no GLM.");
static_assert(std::is_same_v<glm::vec3, glm::vec<3, float, glm::packed_highp>> &&
                  std::is_same_v<glm::dvec3, glm::vec<3, double, glm::packed_highp>> &&
                  std::is_same_v<glm::ivec3, glm::vec<3, int, glm::packed_highp>>,
              "Windrow is built without GLM_FORCE_PRECISION_..., which makes glm::vec3 another type: do not define it where "
              "Windrow's headers are included, or use the C interface, which has no GLM.");
static_assert(
    offsetof(glm::quat, w) == 3 * sizeof(float),
    "Windrow is built without GLM_FORCE_QUAT_DATA_WXYZ, which changes the order of a quaternion's numbers: do not define "
    "it where Windrow's headers are included, or use the C interface, which has no GLM.");

} // namespace windrow::detail
