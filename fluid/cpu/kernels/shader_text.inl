// Formulas of shaders/numerics for the kernels: the text that shaders and the rest of the library include, with as much of GLSL's
// vectors as it needs. GLM's own functions must not be emitted here (kernels.h).
//
// Functions take one point. A loop over the lanes of a group calls them, and the compiler makes vectors of it. Each operation is
// one of IEEE arithmetic and no product is fused into a sum, so that all levels and machines give the same bits.

namespace text {

struct ivec3 {
    std::int32_t x, y, z;
    ivec3(std::int32_t x_, std::int32_t y_, std::int32_t z_) : x(x_), y(y_), z(z_) {}
    explicit inline ivec3(const struct vec3& v);
};
struct vec3 {
    float x, y, z;
    vec3() = default;
    vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
};
inline ivec3::ivec3(const vec3& v)
    : x(static_cast<std::int32_t>(v.x)), y(static_cast<std::int32_t>(v.y)), z(static_cast<std::int32_t>(v.z)) {}
inline ivec3 operator+(const ivec3& a, const ivec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline vec3 operator+(const vec3& a, const vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline void operator+=(vec3& a, const vec3& b) {
    a = a + b;
}
inline vec3 operator-(const vec3& a, const vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline vec3 operator*(const vec3& a, const vec3& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline vec3 operator*(float a, const vec3& b) {
    return {a * b.x, a * b.y, a * b.z};
}
inline vec3 operator/(const vec3& a, float b) {
    return {a.x / b, a.y / b, a.z / b};
}

// As glm's: a comparison with NaN keeps the first.
inline float min(float a, float b) {
    return b < a ? b : a;
}
inline float max(float a, float b) {
    return a < b ? b : a;
}
inline float clamp(float value, float low, float high) {
    return min(max(value, low), high);
}
inline std::int32_t clamp(std::int32_t value, std::int32_t low, std::int32_t high) {
    const std::int32_t raised = value < low ? low : value;
    return high < raised ? high : raised;
}
inline float abs(float value) {
    return __builtin_fabsf(value);
}
// Of a value that an int holds.
inline float floor(float value) {
    return floor_small(value);
}
inline vec3 floor(const vec3& v) {
    return {floor(v.x), floor(v.y), floor(v.z)};
}
inline float length(const vec3& v) {
    return __builtin_sqrtf(v.x * v.x + v.y * v.y + v.z * v.z);
}
inline std::uint32_t floatBitsToUint(float value) {
    return __builtin_bit_cast(std::uint32_t, value);
}
inline float exp(float value) { // no kernel calls it
    return __builtin_expf(value);
}
// Within one unit in the last place, for x from 1 up, as far as floats go: x = 2^k (1 + f), s = f / (2 + f), and log(1 + f) = 2
// atanh s by a polynomial. Based on: Sun Microsystems 1993, fdlibm, e_logf.c.
inline float log(float x) {
    constexpr std::uint32_t k_half_root = 0x3f3504f3u; // sqrt(1/2): f is from there to sqrt(2), minus 1
    const std::uint32_t bits = __builtin_bit_cast(std::uint32_t, x) + (0x3f800000u - k_half_root);
    const auto k = static_cast<float>(static_cast<std::int32_t>(bits >> 23) - 127);
    const float f = __builtin_bit_cast(float, (bits & 0x007fffffu) + k_half_root) - 1.0f;
    const float s = f / (2.0f + f), z = s * s, w = z * z;
    const float series = z * (0xaaaaaap-24f + w * 0x91e9eep-25f) + w * (0xccce13p-25f + w * 0xf89e26p-26f);
    const float half_square = 0.5f * f * f;
    return s * (half_square + series) + k * 0x1.2fefa2p-17f - half_square + f + k * 0x1.62e3p-1f;
}

#define WINDROW_FN inline
#define WINDROW_TILE const float*
inline vec3 windrow_tile_texel(const float* tile, const ivec3& texel) {
    const float* const at = tile + 4 * ((static_cast<std::ptrdiff_t>(texel.z) * 16 + texel.y) * 128 + texel.x);
    return {at[0], at[1], at[2]};
}
#include "shaders/numerics/ambient.glsl"
#include "shaders/numerics/lee.glsl"
#include "shaders/numerics/wall_law.glsl"
#include "shaders/numerics/window.glsl"
#undef WINDROW_TILE
#undef WINDROW_FN

} // namespace text
