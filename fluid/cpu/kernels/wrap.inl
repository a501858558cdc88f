// Remainders of coordinates: where a point lies in what repeats, a periodic box or the gust tile. Exact for any coordinate.
//
// fmod rounds nothing, so that points a whole number of periods apart have the same place to the bit, but it takes one value at a
// time. For up to 2^26 periods the same remainder is c - q P_high - q P_low, with q = c / P cut to whole numbers. P_high has the
// first 26 digits of the period, so that both products are exact; the first difference is exact (Sterbenz), and the second is a
// number that a double holds.
//
// The kernels include this text, and fluid/cpu/point_tasks.cpp.
// Based on: Cody & Waite 1980, Software Manual for the Elementary Functions (reduction in parts).

inline Period period_of(double whole) {
    const double high = __builtin_bit_cast(double, __builtin_bit_cast(std::uint64_t, whole) & ~((std::uint64_t{1} << 27) - 1));
    return {whole, high, whole - high};
}

constexpr double k_most_periods = 67108864.0;   // 2^26: both products are exact
constexpr double k_most_counted = 2147483000.0; // that an int holds; a power of two has one product, which is exact up to there
// Few enough periods for `wrapped_near` to be exact.
inline bool is_near(double value, const Period& period) {
    return __builtin_fabs(value) < k_most_periods * period.high;
}
inline double remainder_near(double value, const Period& period) {
    const double periods = value / period.whole;
    const double counted = __builtin_fabs(periods) <= k_most_counted ? periods : 0.0;
    const auto whole = static_cast<double>(static_cast<std::int32_t>(counted));
    return (value - whole * period.high) - whole * period.low;
}
// The quotient may be rounded up to a whole number: then the remainder has the other sign, and either way one period is added.
inline double raised(double rest, const Period& period) {
    return rest < 0.0 ? rest + period.whole : rest;
}
// From 0 to the period.
inline double wrapped_near(double value, const Period& period) {
    return raised(remainder_near(value, period), period);
}
inline double wrapped(double value, const Period& period) {
    return is_near(value, period) ? wrapped_near(value, period) : raised(__builtin_fmod(value, period.whole), period);
}

struct TilePlace {
    double texel, fraction; // the texel whose centre is below, -1 to n - 1, and the distance from that centre, 0 to 1
};
// The coordinate is wrapped before the phase is subtracted, so the difference keeps its digits. Repeating detail is wrapped at
// the gusts' period: places a whole number of tiles apart have the same detail to the bit.
inline TilePlace place_of_wrapped(const TileAxis& axis, double from_origin) {
    const double along = from_origin - axis.phase;
    const double in_texels = wrapped_near(along / axis.texel * axis.repeats, axis.texels) - 0.5;
    // In texels, -1/2 to n - 1/2.
    const auto cut = static_cast<double>(static_cast<std::int32_t>(in_texels));
    const double below = cut > in_texels ? cut - 1.0 : cut;
    return {below, in_texels - below};
}
