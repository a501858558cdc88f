// One description of each struct's fields, read by the writer and by the reader of bytes, so that the two cannot drift apart.
//
//     void fields(auto& archive, Like<Sphere> auto& sphere) {
//         auto& [radius] = sphere;
//         archive(radius);
//     }
//
// A struct is taken apart by name: one that gains a member no longer compiles here. That each name is also handed on is
// for the tests of the round trip. Variants and enumerations go by index, optionals by a flag before them.
#pragma once

#include "fluid/bytes.h"
#include "fluid/motor.h"
#include "fluid/sides.h"

#include <cmath>
#include <concepts>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace windrow::detail {

/// U or const U: the writer reads from const structs.
template <class T, class U>
concept Like = std::same_as<std::remove_const_t<T>, U>;

/// How many values an enumeration has, from 0 on.
template <class Enumeration>
inline constexpr std::uint8_t k_values_of = 0;
template <>
inline constexpr std::uint8_t k_values_of<SideKind> = 4;

class Writer {
  public:
    explicit Writer(std::size_t expected_content) : bytes_(begin_bytes(expected_content)) {}

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }
    /// Cells alone; whoever reads them knows how many.
    void cells(std::span<const glm::vec4> values) {
        static_assert(sizeof(glm::vec4) == 4 * sizeof(float));
        std::byte* const to = grow(values.size_bytes());
        if constexpr (std::endian::native == std::endian::little) {
            if (!values.empty())
                std::memcpy(to, values.data(), values.size_bytes());
        } else {
            for (std::size_t n = 0; n < 4 * values.size(); ++n)
                store_number(to + 4 * n, values[n / 4][static_cast<int>(n % 4)]);
        }
    }
    [[nodiscard]] std::vector<std::byte> finish(const Format& format) && {
        seal(bytes_, format);
        return std::move(bytes_);
    }

  private:
    [[nodiscard]] std::byte* grow(std::size_t size) {
        bytes_.resize(bytes_.size() + size);
        return bytes_.data() + bytes_.size() - size;
    }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    void put(const Number& value) { store_number(grow(sizeof value), value); }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void put(const Enumeration& value) {
        static_assert(k_values_of<Enumeration> > 0, "say how many values it has");
        put(static_cast<std::uint8_t>(value));
    }
    template <class Number, glm::qualifier Q>
    void put(const glm::vec<3, Number, Q>& vector) {
        (*this)(vector.x, vector.y, vector.z);
    }
    template <class Value>
    void put(const std::optional<Value>& value) {
        put(value.has_value());
        if (value)
            put(*value);
    }
    template <class... Kinds>
    void put(const std::variant<Kinds...>& value) {
        put(static_cast<std::uint8_t>(value.index()));
        std::visit([&](const auto& kind) { put(kind); }, value);
    }
    template <class Struct>
    void put(const Struct& value) {
        fields(*this, value);
    }

    std::vector<std::byte> bytes_;
};

/// Once refused, it reads nothing more: values stay as they are, and the first reason stands.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> content) : rest_(content) {}

    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }
    void cells(std::span<glm::vec4> values) {
        const std::byte* const from = take(values.size_bytes());
        if (from == nullptr || values.empty())
            return;
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(static_cast<void*>(values.data()), from, values.size_bytes());
        else
            for (std::size_t n = 0; n < 4 * values.size(); ++n)
                values[n / 4][static_cast<int>(n % 4)] = load_number<float>(from + 4 * n);
    }
    /// Asked before room is made for what a count promises: whether so many items of at least `bytes_each` can follow.
    [[nodiscard]] bool can_hold(std::uint64_t count, std::size_t bytes_each) {
        if (!refused() && count > rest_.size() / bytes_each)
            refuse("it promises ", count, " items of ", bytes_each, " bytes or more, but only ", rest_.size(), " bytes follow.");
        return !refused();
    }
    template <class... Parts>
    void refuse(const Parts&... parts) {
        if (reason_.empty())
            reason_ = message(parts...);
    }
    void require(bool valid, std::string_view reason) {
        if (!valid)
            refuse(reason);
    }
    [[nodiscard]] bool refused() const { return !reason_.empty(); }
    [[nodiscard]] const std::string& reason() const { return reason_; }
    /// Refuses what is left over.
    void end() { require(rest_.empty(), "bytes follow its last field."); }

  private:
    [[nodiscard]] const std::byte* take(std::size_t size) {
        if (refused() || !can_hold(size, 1))
            return nullptr;
        const std::byte* const from = rest_.data();
        rest_ = rest_.subspan(size);
        return from;
    }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    void get(Number& value) {
        if (const std::byte* const from = take(sizeof value))
            value = load_number<Number>(from);
        if constexpr (std::same_as<Number, double>) // places and times; a float may be an infinite hold, or air that broke
            require(std::isfinite(value), "a place or a time is not finite.");
    }
    void get(bool& value) { value = index(2, "a flag") != 0; }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void get(Enumeration& value) {
        static_assert(k_values_of<Enumeration> > 0, "say how many values it has");
        value = static_cast<Enumeration>(index(k_values_of<Enumeration>, "a choice"));
    }
    template <class Number, glm::qualifier Q>
    void get(glm::vec<3, Number, Q>& vector) {
        (*this)(vector.x, vector.y, vector.z);
    }
    template <class Value>
    void get(std::optional<Value>& value) {
        bool there = false;
        get(there);
        value.reset();
        if (there)
            get(value.emplace());
    }
    template <class... Kinds>
    void get(std::variant<Kinds...>& value) {
        const std::uint8_t chosen = index(sizeof...(Kinds), "a kind");
        [&]<std::size_t... Index>(std::index_sequence<Index...>) {
            ((chosen == Index ? get(value.template emplace<Index>()) : void()), ...);
        }
        (std::index_sequence_for<Kinds...>());
    }
    template <class Struct>
    void get(Struct& value) {
        fields(*this, value);
    }

    /// One of `count` values; 0 where it is none of them.
    [[nodiscard]] std::uint8_t index(std::size_t count, std::string_view what) {
        std::uint8_t value = 0;
        get(value);
        if (value < count)
            return value;
        refuse(what, " has the unknown value ", value, ".");
        return 0;
    }

    std::span<const std::byte> rest_;
    std::string reason_;
};

/// What only a reader does: making room, checking.
template <class Archive>
concept Reading = std::same_as<std::remove_cvref_t<Archive>, Reader>;

// --- What snapshots and logs share ----------------------------------------------------------------------------------------

void fields(auto& archive, Like<Side> auto& side) {
    auto& [kind, wall_velocity] = side;
    archive(kind, wall_velocity);
}

void fields(auto& archive, Like<Sides> auto& sides) {
    auto& [x_low, x_high, y_low, y_high, z_low, z_high] = sides;
    archive(x_low, x_high, y_low, y_high, z_low, z_high);
}

void fields(auto& archive, Like<Sphere> auto& sphere) {
    auto& [radius] = sphere;
    archive(radius);
}

void fields(auto& archive, Like<Capsule> auto& capsule) {
    auto& [half_axis, radius] = capsule;
    archive(half_axis, radius);
}

void fields(auto& archive, Like<AlignedBox> auto& box) {
    auto& [half_size] = box;
    archive(half_size);
}

void fields(auto& archive, Like<Cone> auto& cone) {
    auto& [axis, start_radius, end_radius] = cone;
    archive(axis, start_radius, end_radius);
}

void fields(auto& archive, Like<Force> auto& force) {
    auto& [acceleration] = force;
    archive(acceleration);
}

void fields(auto& archive, Like<Drive> auto& drive) {
    auto& [speed, rate] = drive;
    archive(speed, rate);
}

void fields(auto& archive, Like<WakeForce> auto& force) {
    auto& [strength] = force;
    archive(strength);
}

void fields(auto& archive, Like<WakeDrive> auto& drive) {
    auto& [per_metre, entrainment] = drive;
    archive(per_metre, entrainment);
}

void fields(auto& archive, Like<Envelope> auto& envelope) {
    auto& [attack, hold, decay] = envelope;
    archive(attack, hold, decay);
}

void fields(auto& archive, Like<Turbulence> auto& turbulence) {
    auto& [intensity, length, seed] = turbulence;
    archive(intensity, length, seed);
}

void fields(auto& archive, Like<DirectionalMotor> auto& motor) {
    auto& [position, direction, region, law, envelope, turbulence] = motor;
    archive(position, direction, region, law, envelope, turbulence);
}

void fields(auto& archive, Like<WakeMotor> auto& motor) {
    auto& [position, radius, law, envelope, turbulence] = motor;
    archive(position, radius, law, envelope, turbulence);
}

void fields(auto& archive, Like<JetMotor> auto& motor) {
    auto& [position, direction, length, start_radius, end_radius, law, envelope, turbulence] = motor;
    archive(position, direction, length, start_radius, end_radius, law, envelope, turbulence);
}

void fields(auto& archive, Like<VortexMotor> auto& motor) {
    auto& [position, axis, radius, half_length, lift, law, envelope] = motor;
    archive(position, axis, radius, half_length, lift, law, envelope);
}

void fields(auto& archive, Like<OmniMotor> auto& motor) {
    auto& [position, radius, speed, envelope] = motor;
    archive(position, radius, speed, envelope);
}

void fields(auto& archive, Like<PressureMotor> auto& motor) {
    auto& [position, radius, speed, duration] = motor;
    archive(position, radius, speed, duration);
}

} // namespace windrow::detail
