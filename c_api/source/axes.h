// Axes and unit of the host (windrow_set_axes): each number of a call on its way into the library and back.
//
// The library has its own axes, right-handed with y up, and metres; so have the objects behind the handles, snapshots, logs and files. A
// call that has a length, a place or a direction is compiled as own_windrow_... (axes_names.inl), and the function that hosts call converts
// what goes in and what comes out (axes_calls.inl, made from the kinds of tools/c_kinds.py; axes.cpp by hand). A host whose axes are the
// library's passes through one test of a flag.
//
// A place p of the host is p'_i = s_i u p_a(i) in the library: s_i is a sign, a a permutation, u the unit. det = s_0 s_1 s_2 sign(a) is -1 in
// a left-handed host. A quantity with the length to the power k in its unit is scaled by u^k. What turns about an axis is det times that.
#pragma once

#include "c_api/source/guard.h"
#include "c_api/windrow.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace windrow::c_api {

struct HostAxes {
    bool turned = false;                           ///< else they are the library's
    std::array<int, 3> from{0, 1, 2};              ///< the host's axis that is axis i of the library
    std::array<double, 3> sign{1.0, 1.0, 1.0};     ///< and its sign there
    double unit = 1.0;                             ///< [m]
    double hand = 1.0;                             ///< -1: left-handed
    [[nodiscard]] double factor(int power) const { ///< of a quantity of the host
        double result = 1.0;
        for (int n = 0; n < (power < 0 ? -power : power); ++n)
            result *= unit;
        return power < 0 ? 1.0 / result : result;
    }
};
/// Set by windrow_set_axes, while no other thread is inside the library.
extern HostAxes host_axes;

enum class Way { in, out };

/// Memory of what a call converts, until it returns.
class Keep {
  public:
    [[nodiscard]] std::byte* room(std::size_t bytes) {
        blocks_.emplace_back((bytes + sizeof(Block) - 1) / sizeof(Block));
        return reinterpret_cast<std::byte*>(blocks_.back().data());
    }

  private:
    using Block = std::max_align_t;
    std::vector<std::vector<Block>> blocks_;
};

// --- Kinds ---------------------------------------------------------------------------------------------------------------

template <class Number>
[[nodiscard]] Number scaled(Way way, int power, Number value) {
    const double factor = host_axes.factor(power);
    return static_cast<Number>(way == Way::in ? static_cast<double>(value) * factor : static_cast<double>(value) / factor);
}
/// 0 - v: still air stays 0 and does not become -0.
template <class Number>
[[nodiscard]] Number signed_by(double sign, Number value) {
    return sign < 0.0 ? Number(0) - value : value;
}
template <class Vector>
[[nodiscard]] auto parts_of(const Vector& v) {
    return std::array{v.x, v.y, v.z};
}
/// Axes change places; `turn_sign(i)` is the sign of axis i of the library.
template <class Vector, class Sign>
void permute(Way way, Vector& v, const Sign& sign) {
    const auto given = parts_of(v);
    auto made = given;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto a = static_cast<std::size_t>(host_axes.from[i]);
        if (way == Way::in)
            made[i] = signed_by(sign(i), given[a]);
        else
            made[a] = signed_by(sign(i), given[i]);
    }
    v.x = made[0];
    v.y = made[1];
    v.z = made[2];
}

struct Same {
    template <class Value>
    static void turn(Way, Value&) {}
};
template <int power>
struct Number {
    template <class Value>
    static void turn(Way way, Value& value) {
        value = scaled(way, power, value);
    }
};
/// Places, velocities, forces, directions; the fourth number of four stays.
template <int power>
struct Vector {
    template <class Value>
    static void turn(Way way, Value& v) {
        permute(way, v, [](std::size_t i) { return host_axes.sign[i]; });
        if constexpr (power != 0) {
            v.x = scaled(way, power, v.x);
            v.y = scaled(way, power, v.y);
            v.z = scaled(way, power, v.z);
        }
    }
};
/// Axes of rotation and moments.
template <int power>
struct Axial {
    template <class Value>
    static void turn(Way way, Value& v) {
        Vector<power>::turn(way, v);
        if (host_axes.hand < 0.0)
            v = {signed_by(-1.0, v.x), signed_by(-1.0, v.y), signed_by(-1.0, v.z)};
    }
};
/// A quaternion x, y, z, w: its vector is an axis of rotation.
struct Turn {
    template <class Value>
    static void turn(Way way, Value& v) {
        auto axis = v;
        permute(way, axis, [](std::size_t i) { return host_axes.hand * host_axes.sign[i]; });
        axis.w = v.w;
        v = axis;
    }
};
/// Sizes, numbers of cells, factors along x, y, z.
template <int power>
struct Extents {
    template <class Value>
    static void turn(Way way, Value& v) {
        permute(way, v, [](std::size_t) { return 1.0; });
        if constexpr (power != 0) {
            v.x = scaled(way, power, v.x);
            v.y = scaled(way, power, v.y);
            v.z = scaled(way, power, v.z);
        }
    }
};
/// x and z of a vector: in a host with z up, x and y. Axis x is the same in all of them.
template <int power>
struct Level {
    template <class Value>
    static void turn(Way way, Value& v) {
        v.y = signed_by(host_axes.sign[2], v.y);
        if constexpr (power != 0) {
            v.x = scaled(way, power, v.x);
            v.y = scaled(way, power, v.y);
        }
    }
};
/// An angle about the vertical, from x to the other level axis.
struct LevelSign {
    template <class Value>
    static void turn(Way, Value& value) {
        value = signed_by(host_axes.sign[2], value);
    }
};
/// What changes its sign in a left-handed host.
struct Handed {
    template <class Value>
    static void turn(Way, Value& value) {
        value = signed_by(host_axes.hand, value);
    }
};
/// A struct, by its own turn() of axes_structs.inl.
struct Whole {};

// --- What pointers point to ------------------------------------------------------------------------------------------------

template <class Value>
concept Sized = requires(Value value) {
    value.struct_size;
};

/// A struct of which the host has `size` bytes: fields that it lacks are 0 while it is converted.
template <class Value>
void turn_sized(Keep& keep, Way way, std::byte* memory, std::size_t size) {
    Value value{};
    // No struct of a host ends within a field; a size that does would leave a part of a pointer.
    const std::size_t there = std::min(size, sizeof value) / alignof(Value) * alignof(Value);
    std::memcpy(static_cast<void*>(&value), memory, there);
    turn(keep, way, value);
    std::memcpy(memory, static_cast<const void*>(&value), there);
}
constexpr std::size_t k_largest_struct = 1u << 16;

/// A copy, converted, of what goes in. What the library rejects at first sight goes in as it is.
template <class Kind, class Value>
[[nodiscard]] const Value* turned_in(Keep& keep, const Value* from, std::uint64_t count) {
    if (from == nullptr || count == 0)
        return from;
    if constexpr (std::is_same_v<Kind, Whole> && Sized<Value>) {
        const std::size_t size = from->struct_size;
        if (size < sizeof from->struct_size || size > k_largest_struct || size % alignof(Value) != 0 ||
            count > k_largest_struct * 8)
            return from;
        std::byte* const made = keep.room(std::max(size * static_cast<std::size_t>(count), sizeof(Value)));
        std::memcpy(made, from, size * static_cast<std::size_t>(count));
        for (std::uint64_t n = 0; n < count; ++n)
            turn_sized<Value>(keep, Way::in, made + n * size, size);
        return reinterpret_cast<const Value*>(made);
    } else {
        if (count > SIZE_MAX / sizeof(Value) / 2)
            return from;
        auto* const made = reinterpret_cast<Value*>(keep.room(sizeof(Value) * static_cast<std::size_t>(count)));
        std::memcpy(static_cast<void*>(made), from, sizeof(Value) * static_cast<std::size_t>(count));
        for (std::uint64_t n = 0; n < count; ++n)
            if constexpr (std::is_same_v<Kind, Whole>)
                turn(keep, Way::in, made[n]);
            else
                Kind::turn(Way::in, made[n]);
        return made;
    }
}
/// Converts in its place what came out.
template <class Kind, class Value>
void turn_out(Keep& keep, Value* to, std::uint64_t count) {
    if (to == nullptr)
        return;
    for (std::uint64_t n = 0; n < count; ++n)
        if constexpr (!std::is_same_v<Kind, Whole>)
            Kind::turn(Way::out, to[n]);
        else if constexpr (Sized<Value>)
            turn_sized<Value>(keep, Way::out, reinterpret_cast<std::byte*>(to + n), to[n].struct_size);
        else
            turn(keep, Way::out, to[n]);
}
/// What a field points to. On its way out it is memory of the wind that the call has filled (windrow_wind_config).
template <class Kind, class Value>
void turn_behind(Keep& keep, Way way, const Value*& pointer, std::uint64_t count) {
    if (way == Way::in)
        pointer = turned_in<Kind>(keep, pointer, count);
    else
        turn_out<Kind>(keep, const_cast<Value*>(pointer), pointer != nullptr ? count : 0);
}

/// The result of a call that has kept its sentence.
struct AlreadySaid {
    windrow_result result;
};
[[nodiscard]] inline windrow_result done(AlreadySaid said) noexcept {
    return said.result;
}

// --- Calls -----------------------------------------------------------------------------------------------------------------

template <class Value>
struct SameArgument {
    Value raw;
    [[nodiscard]] Value in(Keep&) const { return raw; }
    void out(Keep&) const {}
};
template <class Kind, class Value>
struct InArgument {
    Value raw;
    [[nodiscard]] Value in(Keep&) const {
        Value value = raw;
        Kind::turn(Way::in, value);
        return value;
    }
    void out(Keep&) const {}
};
template <class Kind, class Value>
struct InArrayArgument {
    const Value* raw;
    std::uint64_t count;
    [[nodiscard]] const Value* in(Keep& keep) const { return turned_in<Kind>(keep, raw, count); }
    void out(Keep&) const {}
};
template <class Kind, class Value>
struct OutArrayArgument {
    Value* raw;
    std::uint64_t count;
    [[nodiscard]] Value* in(Keep&) const { return raw; }
    void out(Keep& keep) const { turn_out<Kind>(keep, raw, count); }
};
/// Goes in and comes out: by a copy, so that a call that fails changes nothing.
template <class Kind, class Value>
struct BothArgument {
    Value* raw;
    Value* copy = nullptr;
    [[nodiscard]] Value* in(Keep& keep) {
        return copy = const_cast<Value*>(turned_in<Kind>(keep, static_cast<const Value*>(raw), 1));
    }
    void out(Keep& keep) {
        if (copy == nullptr)
            return;
        turn_out<Kind>(keep, copy, 1);
        *raw = *copy;
    }
};
template <class Value>
SameArgument<Value> same(Value value) {
    return {value};
}
template <class Kind, class Value>
InArgument<Kind, Value> in(Value value) {
    return {value};
}
template <class Kind, class Value>
InArrayArgument<Kind, Value> in_array(const Value* values, std::uint64_t count) {
    return {values, count};
}
template <class Kind, class Value>
OutArrayArgument<Kind, Value> out_array(Value* values, std::uint64_t count) {
    return {values, count};
}
template <class Kind, class Value>
BothArgument<Kind, Value> both(Value* value, std::uint64_t) {
    return {value};
}
[[nodiscard]] inline std::uint64_t count_of(const windrow_skin* skin) {
    return skin != nullptr ? skin->count : 0;
}

/// guarded() for all calls that convert: one handler of exceptions, and not one a call.
[[nodiscard]] windrow_result run_guarded(windrow_result (*run)(const void* body), const void* body) noexcept;

/// Calls `own` with what the arguments are to the library; `Kind` is that of the result. A function of its own: a host whose axes are the
/// library's jumps past it, with its arguments where they are.
template <class Kind, class Result, class... Parameters, class... Arguments>
[[gnu::noinline]] Result turned(Result (*own)(Parameters...), Arguments... arguments) noexcept {
    if constexpr (std::is_same_v<Result, windrow_result>) {
        const auto body = [&] {
            Keep keep;
            const windrow_result result = own(arguments.in(keep)...);
            if (result == WINDROW_OK)
                (arguments.out(keep), ...);
            return result;
        };
        return run_guarded([](const void* it) { return (*static_cast<const decltype(body)*>(it))(); }, &body);
    } else {
        Keep keep; // a call that returns a value takes numbers alone, which need no memory
        Result result = own(arguments.in(keep)...);
        if constexpr (std::is_same_v<Kind, Whole>)
            turn(keep, Way::out, result);
        else
            Kind::turn(Way::out, result);
        return result;
    }
}

void turn_by_hand(Keep& keep, Way way, windrow_config& value);
void turn_by_hand(Keep& keep, Way way, windrow_query& value);
void turn_by_hand(Keep& keep, Way way, windrow_roughness_map& value);
void turn_by_hand(Keep& keep, Way way, windrow_vdb_film& value);

} // namespace windrow::c_api
