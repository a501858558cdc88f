// Gust tile: sum of waves with random phases on the texels.
//
//   wave vector        k = 2 pi (a, c) / 128 level, q = pi b / 16 vertical, e = k / |k|, e' = e turned by a quarter
//   turning part       u = A e' cos(k x + p) cos(q y)
//   rising part        v = B cos(k x + p') sin(q y),   u = -B (q / |k|) e sin(k x + p') cos(q y)       div = 0 for each
//   power of a wave    S(m) / m, m = |(a, c)|: a ring of waves of one length then holds S(m). S peaks at 12 texels. S is 0
//                      from 8 texels down, which blending resolves badly. A weaker hump from 13 to 40 texels varies the
//                      strength of the gusts. The spectrum is isotropic.
//   texels             Blending weakens a wave, by 2 % at 12 texels. The stored amplitude of each wave compensates for this:
//                      blended gusts have the declared strength and the least mean square error.
//
// Bits: phases are whole 1024ths of a turn from an integer hash. Sines are of such angles only, by a polynomial. All other
// operations are sums, products and roots, which IEEE arithmetic rounds alike everywhere.
// Based on: Kraichnan 1970, Diffusion by a random velocity field (random solenoidal waves); Hunt & Graham 1978, Free-stream
// turbulence near plane boundaries (images; here the mirror at the ground).
#include "fluid/gust_tile.h"

#include "fluid/core/ambient_numerics.h"
#include "fluid/core/message.h"
#include "fluid/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <numbers>

namespace windrow {
namespace {

constexpr int k_side = GustTile::k_side;
constexpr int k_max_waves = k_side / 8; // the shortest wave: 8 texels
constexpr int k_turn = 1024;            // angles that the table holds
// Power by number of half waves over the tile's height. The spectrum is flatter than it is wide, with mostly tall gusts: the mean
// square near the ground, where every cos(q y) is 1, is then close to that aloft.
constexpr std::array k_turning_power{0.55, 0.24, 0.14, 0.07};
constexpr std::array k_rising_power{0.0, 0.5, 0.35, 0.15};
constexpr int k_layers = static_cast<int>(k_turning_power.size());
constexpr double k_vertical_power = 0.25; // 0.5 squared

struct Complex {
    double real, imaginary;
};

// cos and sin of whole 1024ths of a turn. Up to an eighth of a turn the series below is exact to about the last bit.
class Circle {
  public:
    Circle() {
        for (int n = 0; n < k_turn; ++n) {
            constexpr int k_quarter = k_turn / 4;
            const int axis = (n + k_turn / 8) / k_quarter; // the nearest one
            const double angle = 2.0 * std::numbers::pi * (n - axis * k_quarter) / k_turn;
            double cosine = 0.0, sine = 0.0;
            for (int order = 18; order >= 0; order -= 2) { // Horner: sum of angle^order / order! with alternating signs
                cosine = 1.0 - cosine * angle * angle / ((order + 1) * (order + 2));
                sine = 1.0 - sine * angle * angle / ((order + 2) * (order + 3));
            }
            sine *= angle;
            const std::array<Complex, 4> turned{Complex{cosine, sine}, {-sine, cosine}, {-cosine, -sine}, {sine, -cosine}};
            table_[static_cast<std::size_t>(n)] = turned[static_cast<std::size_t>(axis & 3)];
        }
    }
    [[nodiscard]] Complex operator()(int turns) const { return table_[static_cast<std::size_t>(turns & (k_turn - 1))]; }

  private:
    std::array<Complex, k_turn> table_;
};

// (1 - s^2)^2 within the radius, 0 beyond.
double hump(double distance, double radius) {
    const double rest = 1.0 - (distance / radius) * (distance / radius);
    return rest > 0.0 ? rest * rest : 0.0;
}

// Power of a ring of waves with `m` wavelengths per tile.
double ring_power(double m) {
    const double peak = double(k_side) / GustTile::k_gust_texels;
    return hump(m - peak, k_max_waves - peak) + 0.15 * hump(m - 6.5, 3.3);
}

// All bits of the result depend on all bits of the key (the finaliser of MurmurHash3, Appleby, public domain).
std::uint32_t mixed(std::uint32_t key) {
    key = (key ^ (key >> 16)) * 0x85ebca6bu;
    key = (key ^ (key >> 13)) * 0xc2b2ae35u;
    return key ^ (key >> 16);
}

// Factor on a stored wave for the least mean square error after linear blending along one axis:
// (sin(k/2) / (k/2))^2 over (2 + cos k) / 3, for k = 2 pi waves / 1024 a texel.
double raised(const Circle& circle, int waves) {
    if (waves == 0)
        return 1.0;
    const double half = std::numbers::pi * waves / k_turn;
    const double sine_squared = 0.5 * (1.0 - circle(waves).real); // of k/2
    return sine_squared / (half * half) * 3.0 / (2.0 + circle(waves).real);
}

} // namespace

std::shared_ptr<const GustTile> GustTile::bake(std::uint32_t seed) {
    std::shared_ptr<const GustTile> tile;
    (void)detail::memory_lasts([&] { tile.reset(new GustTile(seed)); }); // without memory: null
    return tile;
}

std::shared_ptr<const GustTile> GustTile::standard() {
    static std::mutex mutex;
    static std::weak_ptr<const GustTile> shared;
    const std::lock_guard lock(mutex);
    std::shared_ptr<const GustTile> tile = shared.lock();
    if (!tile)
        shared = tile = bake(1);
    return tile;
}

GustTile::GustTile(std::uint32_t seed) : seed_(seed) {
    make_modes();
    bake_texels();
}

// One wave of each equal pair (a, c), (-a, -c): amplitudes from the spectrum, random phases.
void GustTile::make_modes() {
    const Circle circle;
    double turning_sum = 0.0, rising_sum = 0.0, rising_level_sum = 0.0; // powers that amplitudes of 1 would give
    const auto for_each_wave = [](const auto& visit) {
        for (int a = 0; a <= k_max_waves; ++a)
            for (int c = a == 0 ? 1 : -k_max_waves; c <= k_max_waves; ++c)
                if (const double m = std::sqrt(double(a * a + c * c)); ring_power(m) > 0.0)
                    for (int b = 0; b < k_layers; ++b)
                        visit(a, b, c, m, ring_power(m) / m);
    };
    // q / |k|: level motion per vertical motion of a rising wave.
    const auto slope = [](int b, double m) { return (b / (2.0 * k_height)) / (m / k_side); };
    for_each_wave([&](int, int b, int, double m, double power) {
        const std::size_t layer = static_cast<std::size_t>(b);
        turning_sum += power * k_turning_power[layer];
        rising_sum += power * k_rising_power[layer];
        rising_level_sum += power * k_rising_power[layer] * slope(b, m) * slope(b, m);
    });
    // The vertical's power is set first. The turning part gets the level power, 1 a component, less that of the rising part.
    const double rising = k_vertical_power / rising_sum;
    const double turning = (2.0 - rising * rising_level_sum) / turning_sum;

    for_each_wave([&](int a, int b, int c, double m, double power) {
        const std::size_t layer = static_cast<std::size_t>(b);
        const std::uint32_t key = mixed(seed_ ^ mixed(static_cast<std::uint32_t>((b * 64 + a) * 64 + c + 32)));
        const Complex p = circle(static_cast<int>(key & 1023u)), rise = circle(static_cast<int>((key >> 10) & 1023u));
        const double average = b == 0 ? 0.5 : 0.25; // mean square of a wave of amplitude 1
        const double A = std::sqrt(turning * power * k_turning_power[layer] / average);
        const double B = std::sqrt(rising * power * k_rising_power[layer] / average);
        const double ex = a / m, ez = c / m, level = B * slope(b, m);
        Mode mode{a, b, c, {}, {}};
        // A wave -sin(w) is the real part of i exp(i w): the level part of the rising wave is multiplied by this i.
        mode.real = {-A * ez * p.real - level * ex * rise.imaginary, B * rise.real,
                     A * ex * p.real - level * ez * rise.imaginary};
        mode.imaginary = {-A * ez * p.imaginary + level * ex * rise.real, B * rise.imaginary,
                          A * ex * p.imaginary + level * ez * rise.real};
        modes_.push_back(mode);
    });
}

// Separable: for one z, the waves of each a and b are summed over c, then along x, then over the layers along y.
void GustTile::bake_texels() {
    const Circle circle;
    const auto at_centre = [&](int waves, int texel) { return circle(waves * (2 * texel + 1) * (k_turn / (2 * k_side))); };
    using Row = std::array<double, k_side>;
    std::vector<Row> cosines(k_max_waves + 1), sines(k_max_waves + 1);
    for (int a = 0; a <= k_max_waves; ++a)
        for (int x = 0; x < k_side; ++x) {
            const Complex wave = at_centre(a, x);
            cosines[a][x] = wave.real;
            sines[a][x] = wave.imaginary;
        }
    std::array<double, k_max_waves + 1> gains{};
    for (int a = 0; a <= k_max_waves; ++a)
        gains[a] = raised(circle, a * (k_turn / k_side));
    struct Sum {
        glm::dvec3 real{0.0}, imaginary{0.0};
    };
    std::vector<Row> rows(3 * k_layers); // [component][layer][x]
    texels_.resize(static_cast<std::size_t>(k_side) * k_height * k_side);
    double largest = 0.0;
    for (int z = 0; z < k_side; ++z) {
        std::array<std::array<Sum, k_max_waves + 1>, k_layers> sums{};
        for (const Mode& mode : modes_) {
            const Complex wave = at_centre(mode.c, z);
            const double gain = gains[mode.a] * gains[std::abs(mode.c)];
            Sum& sum = sums[mode.b][mode.a];
            sum.real += gain * (mode.real * wave.real - mode.imaginary * wave.imaginary);
            sum.imaginary += gain * (mode.real * wave.imaginary + mode.imaginary * wave.real);
        }
        for (int component = 0; component < 3; ++component)
            for (int b = 0; b < k_layers; ++b) {
                Row& row = rows[component * k_layers + b];
                row.fill(0.0);
                for (int a = 0; a <= k_max_waves; ++a) {
                    const double real = sums[b][a].real[component], imaginary = sums[b][a].imaginary[component];
                    for (int x = 0; x < k_side; ++x)
                        row[x] += real * cosines[a][x] - imaginary * sines[a][x];
                }
            }
        for (int y = 0; y < k_height; ++y) {
            glm::vec4* const line = &texels_[(static_cast<std::size_t>(z) * k_height + y) * k_side];
            std::array<Row, 3> sum{};
            for (int b = 0; b < k_layers; ++b) {
                const Complex wave = circle(b * (2 * y + 1) * (k_turn / (4 * k_height)));
                const double gain = raised(circle, b * (k_turn / (2 * k_height)));
                const std::array<double, 3> factor{gain * wave.real, gain * wave.imaginary, gain * wave.real};
                for (int component = 0; component < 3; ++component)
                    for (int x = 0; x < k_side; ++x)
                        sum[component][x] += factor[component] * rows[component * k_layers + b][x];
            }
            for (int x = 0; x < k_side; ++x) {
                line[x] = glm::vec4(glm::vec3(glm::dvec3(sum[0][x], sum[1][x], sum[2][x])), 0.0f);
                const glm::dvec3 stored(line[x]);
                largest = std::max(largest, stored.x * stored.x + stored.y * stored.y + stored.z * stored.z);
            }
        }
    }
    bound_ = static_cast<float>(std::sqrt(largest) * (1.0 + 1e-6)); // room for the rounding of a blend in float
}

glm::vec3 GustTile::sample(glm::dvec3 place) const {
    const glm::dvec3 periods(k_side, 2 * k_height, k_side);
    glm::dvec3 inside;
    for (int axis = 0; axis < 3; ++axis)
        inside[axis] = std::fmod(place[axis], periods[axis]) - 0.5;
    const glm::dvec3 whole = glm::floor(inside);
    return numerics::windrow_tile_at(numerics::TileView{texels_.data()}, glm::ivec3(whole), glm::vec3(inside - whole));
}

glm::vec3 GustTile::procedural(glm::dvec3 place) const {
    glm::dvec3 sum(0.0);
    for (const Mode& mode : modes_) {
        const double level = 2.0 * std::numbers::pi * (mode.a * place.x + mode.c * place.z) / k_side;
        const double vertical = std::numbers::pi * mode.b * place.y / k_height;
        const glm::dvec3 wave = numerics::cos(level) * mode.real - numerics::sin(level) * mode.imaginary;
        sum += wave * glm::dvec3(numerics::cos(vertical), numerics::sin(vertical), numerics::cos(vertical));
    }
    return glm::vec3(sum);
}

std::size_t GustTile::memory_bytes() const {
    return sizeof(GustTile) + modes_.capacity() * sizeof(Mode) + texels_.capacity() * sizeof(glm::vec4);
}

} // namespace windrow
