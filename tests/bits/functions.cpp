// The elementary functions at many places: a last digit that differs once in a thousand calls may change no story of the air.
#include "fluid/portable_math.h"
#include "tests/bits/stories.h"

namespace windrow::bits {
namespace {

constexpr int k_places = 20000;

template <class Real, class Function>
void play(Hashes& hashes, const std::string& name, Real low, Real high, const Function& function) {
    std::vector<Real> values;
    for (int n = 0; n < k_places; ++n)
        values.push_back(function(low + (high - low) * (static_cast<Real>(n) / static_cast<Real>(k_places))));
    hashes.add(name, values);
}

} // namespace

std::vector<Hash> functions() {
    namespace own = numerics;
    Hashes hashes("functions");
    play(hashes, "exp", -30.0, 30.0, [](double x) { return own::exp(x); });
    play(hashes, "expm1", -3.0, 3.0, [](double x) { return own::expm1(x); });
    play(hashes, "log", 1e-3, 1e3, [](double x) { return own::log(x); });
    play(hashes, "log1p", -0.9, 9.0, [](double x) { return own::log1p(x); });
    play(hashes, "sin", -50.0, 5e5, [](double x) { return own::sin(x); });
    play(hashes, "cos", -9.0, 9.0, [](double x) { return own::cos(x); });
    play(hashes, "atan2", -9.0, 9.0, [](double x) { return own::atan2(x, 4.0 - x); });
    play(hashes, "acos", -1.0, 1.0, [](double x) { return own::acos(x); });
    play(hashes, "power", 0.9, 1.2, [](double x) { return own::power(x, 100); });
    play(hashes, "expf", -30.0f, 30.0f, [](float x) { return own::exp(x); });
    play(hashes, "logf", 1e-3f, 1e3f, [](float x) { return own::log(x); });
    play(hashes, "log1pf", -0.9f, 9.0f, [](float x) { return own::log1p(x); });
    play(hashes, "powf", 1e-3f, 1e3f, [](float x) { return own::pow(x, 1.7f); });
    play(hashes, "sinf", -50.0f, 50.0f, [](float x) { return own::sin(x); });
    play(hashes, "cosf", -50.0f, 50.0f, [](float x) { return own::cos(x); });
    play(hashes, "tanhf", -5.0f, 5.0f, [](float x) { return own::tanh(x); });
    play(hashes, "coshf", -9.0f, 9.0f, [](float x) { return own::cosh(x); });
    play(hashes, "cbrtf", 1.0f, 1e6f, [](float x) { return own::cbrt(x); });
    return hashes.list();
}

} // namespace windrow::bits
