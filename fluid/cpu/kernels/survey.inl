// Reduction over the three components of the cells: largest component, non-finite cells and sum of squares in one read. Finiteness is tested on the bits: an exponent of
// all ones is infinity or NaN for any compiler arithmetic mode. Magnitudes compare as integers, as floats of one sign do.

PlaneSurvey survey(const float* velocity, std::size_t cells) {
    typedef std::int32_t Bits __attribute__((vector_size(k_native_lanes * 4)));
    Bits magnitude = Bits{} + 0x7fffffff; // of fourth components 0
    for (int lane = 3; lane < k_native_lanes; lane += 4)
        magnitude[lane] = 0;
    const Bits largest_finite = Bits{} + 0x7f7fffff;
    constexpr std::size_t k_run = 1024; // squares are summed in float over a run only, then in double
    PlaneSurvey found = {};
    Bits largest = {};
    const std::size_t floats = 4 * cells;
    for (std::size_t start = 0; start < floats; start += k_run) {
        const std::size_t end = start + k_run < floats ? start + k_run : floats;
        Native squares = {};
        Bits broken = {};
        const auto take = [&](Native values) {
            const Bits bits = reinterpret_cast<Bits>(values);
            const Bits size = bits & magnitude;
            const Bits bad = size > largest_finite;
            const Bits sound = size & ~bad;
            broken |= bad;
            largest = sound > largest ? sound : largest;
            const Native value = reinterpret_cast<Native>(sound);
            squares += value * value;
        };
        std::size_t n = start;
        for (; n + k_native_lanes <= end; n += k_native_lanes)
            take(load_native(velocity + n));
        if (n < end) {
            float rest[k_native_lanes] = {};
            for (std::size_t lane = 0; n + lane < end; ++lane)
                rest[lane] = velocity[n + lane];
            take(load_native(rest));
        }
        std::int32_t any_broken = 0;
        for (int lane = 0; lane < k_native_lanes; ++lane) {
            any_broken |= broken[lane];
            found.squares += static_cast<double>(squares[lane]);
        }
        for (n = start; any_broken != 0 && n < end; n += 4) {
            std::int32_t bad = 0;
            for (std::size_t axis = 0; axis < 4; ++axis) {
                std::int32_t bits = 0;
                __builtin_memcpy(&bits, velocity + n + axis, sizeof bits);
                bad |= (bits & 0x7fffffff) > 0x7f7fffff ? 1 : 0;
            }
            found.nonfinite_cells += bad;
        }
    }
    std::int32_t most = 0;
    for (int lane = 0; lane < k_native_lanes; ++lane)
        most = largest[lane] > most ? largest[lane] : most;
    __builtin_memcpy(&found.largest_component, &most, sizeof most);
    return found;
}
