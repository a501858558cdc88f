// A host with axes and a unit of its own, and what it heard: the test's own matrices, which know nothing of c_api/source/axes.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <vector>
#include <windrow/windrow.h>

namespace windrow::test {

using Numbers = std::array<double, 3>;

struct Host {
    const char* name;
    windrow_axes axes;
    double unit;
    bool exact;                                  ///< axes alone, or a unit that is a power of two
    std::array<std::array<double, 3>, 3> matrix; ///< from the library's axes to the host's
    double hand;                                 ///< -1: left-handed

    [[nodiscard]] double scale(int power) const { return std::pow(unit, -power); }
    [[nodiscard]] Numbers there(Numbers own) const {
        Numbers host{};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                host[row] += matrix[row][column] * own[column];
        return host;
    }
    [[nodiscard]] Numbers back(Numbers host) const {
        Numbers own{};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                own[column] += matrix[row][column] * host[row];
        return own;
    }

    // --- Given in the library's own, as the host says it -------------------------------------------------------------
    [[nodiscard]] double number(double own, int power = 1) const { return own * scale(power); }
    [[nodiscard]] float single(double own, int power = 1) const { return static_cast<float>(number(own, power)); }
    [[nodiscard]] windrow_dvec3 place(double x, double y, double z) const {
        const Numbers p = there({x, y, z});
        return {number(p[0]), number(p[1]), number(p[2])};
    }
    [[nodiscard]] windrow_vec3 vector(double x, double y, double z, int power) const {
        const Numbers p = there({x, y, z});
        return {single(p[0], power), single(p[1], power), single(p[2], power)};
    }
    [[nodiscard]] windrow_vec4 vector4(double x, double y, double z, int power, float w = 0.0f) const {
        const windrow_vec3 v = vector(x, y, z, power);
        return {v.x, v.y, v.z, w};
    }
    [[nodiscard]] windrow_vec3 axial(double x, double y, double z) const { return vector(hand * x, hand * y, hand * z, 0); }
    /// Sizes along the axes.
    [[nodiscard]] windrow_vec3 extents(double x, double y, double z, int power) const {
        const Numbers p = there({x, y, z});
        return {single(std::fabs(p[0]), power), single(std::fabs(p[1]), power), single(std::fabs(p[2]), power)};
    }
    [[nodiscard]] windrow_ivec3 cells(int x, int y, int z) const {
        const windrow_vec3 p = extents(x, y, z, 0);
        return {static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)};
    }
    /// x and z.
    [[nodiscard]] windrow_vec2 level(double x, double z, int power) const {
        const Numbers p = there({x, 0.0, z});
        return {single(p[0], power), single(axes < WINDROW_AXES_Z_UP_RIGHT ? p[2] : p[1], power)};
    }
    [[nodiscard]] windrow_quat turn(double x, double y, double z, double angle) const {
        const Numbers axis = there({hand * x, hand * y, hand * z});
        const double s = std::sin(0.5 * angle) / std::sqrt(x * x + y * y + z * z);
        return {static_cast<float>(s * axis[0]), static_cast<float>(s * axis[1]), static_cast<float>(s * axis[2]),
                static_cast<float>(std::cos(0.5 * angle))};
    }
    /// The host's face that is one of the library's: axis 0 to 2, low or high.
    [[nodiscard]] windrow_boundary& face(windrow_boundaries& of, std::size_t axis, bool high) const {
        Numbers normal{};
        normal[axis] = high ? 1.0 : -1.0;
        const Numbers p = there(normal);
        if (p[0] != 0.0)
            return p[0] > 0.0 ? of.x_high : of.x_low;
        if (p[1] != 0.0)
            return p[1] > 0.0 ? of.y_high : of.y_low;
        return p[2] > 0.0 ? of.z_high : of.z_low;
    }
    /// Where a cell of the library is in an array of the host with these sizes of the library.
    [[nodiscard]] std::size_t index(std::array<int, 3> own, std::array<int, 3> size) const {
        Numbers centre{}, whole{};
        for (std::size_t n = 0; n < 3; ++n) {
            centre[n] = own[n] - 0.5 * (size[n] - 1);
            whole[n] = size[n];
        }
        const Numbers at = there(centre), sizes = there(whole);
        double place = 0.0, step = 1.0;
        for (std::size_t n = 0; n < 3; ++n) {
            const double count = std::fabs(sizes[n]);
            place += step * (at[n] + 0.5 * (count - 1.0));
            step *= count;
        }
        return static_cast<std::size_t>(std::lround(place));
    }
};

/// The first is the library's own.
inline const std::array<Host, 6>& hosts() {
    static const std::array<Host, 6> all{{
        {"plain", WINDROW_AXES_Y_UP_RIGHT, 1.0, true, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1.0},
        {"y_up_left", WINDROW_AXES_Y_UP_LEFT, 1.0, true, {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, -1.0},
        {"z_up_right, quarters", WINDROW_AXES_Z_UP_RIGHT, 0.25, true, {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}, 1.0},
        {"z_up_left", WINDROW_AXES_Z_UP_LEFT, 1.0, true, {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}, -1.0},
        {"z_up_left, centimetres", WINDROW_AXES_Z_UP_LEFT, 0.01, false, {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}}, -1.0},
        {"z_up_right, feet", WINDROW_AXES_Z_UP_RIGHT, 0.3048, false, {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}, 1.0},
    }};
    return all;
}

/// What a host heard, in the library's own.
class Record {
  public:
    explicit Record(const Host& host) : host_(host) {}

    void number(const char* what, double value, int power = 0) { add(what, value / host_.scale(power)); }
    template <class V>
    void vector(const char* what, const V& v, int power) {
        put(what, host_.back({static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)}), power);
    }
    template <class V>
    void axial(const char* what, const V& v, int power) {
        put(what,
            host_.back({host_.hand * static_cast<double>(v.x), host_.hand * static_cast<double>(v.y),
                        host_.hand * static_cast<double>(v.z)}),
            power);
    }
    template <class V>
    void extents(const char* what, const V& v, int power) {
        Numbers own = host_.back({static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)});
        for (double& part : own)
            part = std::fabs(part);
        put(what, own, power);
    }
    template <class V>
    void level(const char* what, const V& v, int power) {
        const bool z_up = host_.axes >= WINDROW_AXES_Z_UP_RIGHT;
        const auto other = static_cast<double>(v.y);
        const Numbers own = host_.back({static_cast<double>(v.x), z_up ? other : 0.0, z_up ? 0.0 : other});
        put(what, {own[0], 0.0, own[2]}, power);
    }
    template <class Q>
    void turn(const char* what, const Q& q) {
        axial(what, q, 0);
        add(what, static_cast<double>(q.w));
    }
    /// Bits of a call, or text: equal for each exact host.
    void exact(const char* what, double value) {
        add(what, value);
        exact_.back() = true;
    }
    void bytes(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }

    void expect_equal(const Record& plain) const {
        ASSERT_EQ(names_.size(), plain.names_.size()) << host_.name;
        int faults = 0;
        for (std::size_t n = 0; n < names_.size() && faults < 12; ++n) {
            if (exact_[n] && !host_.exact)
                continue;
            const double bound = host_.exact ? 0.0 : 1e-5 * std::max(1.0, std::fabs(plain.values_[n]));
            const bool near = values_[n] == plain.values_[n] || std::fabs(values_[n] - plain.values_[n]) <= bound;
            EXPECT_TRUE(near) << host_.name << ": " << names_[n] << " (" << n << ") is " << values_[n] << ", plain "
                              << plain.values_[n];
            faults += near ? 0 : 1;
        }
        if (host_.exact) {
            EXPECT_TRUE(bytes_ == plain.bytes_) << host_.name << ": the cells, snapshots or logs have other bits";
        }
        EXPECT_GT(values_.size(), 0u);
    }

  private:
    void put(const char* what, Numbers own, int power) {
        for (const double part : own)
            number(what, part, power);
    }
    void add(const char* what, double value) {
        names_.emplace_back(what);
        values_.push_back(value);
        exact_.push_back(false);
    }

    const Host& host_;
    std::vector<std::string> names_;
    std::vector<double> values_;
    std::vector<bool> exact_;
    std::string bytes_;
};

/// Plays a story as each host, and compares what they heard.
template <class Story>
void expect_same_for_all_hosts(const Story& story) {
    std::vector<Record> heard;
    for (const Host& host : hosts()) {
        ASSERT_EQ(windrow_set_axes(host.axes, host.unit), WINDROW_OK) << windrow_last_error();
        heard.emplace_back(host);
        story(host, heard.back());
    }
    ASSERT_EQ(windrow_set_axes(WINDROW_AXES_Y_UP_RIGHT, 1.0), WINDROW_OK);
    for (std::size_t n = 1; n < heard.size(); ++n)
        heard[n].expect_equal(heard.front());
}

#define WINDROW_AXES_OK(call) ASSERT_EQ((call), WINDROW_OK) << windrow_last_error()

} // namespace windrow::test
