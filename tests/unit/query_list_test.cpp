// Lists of points: a point has the same bits in every list, on every SIMD level, and as a single call.

#include "fluid/cpu/kernels/kernels.h"
#include "fluid/cpu/point_tasks.h"
#include "tests/query_scenes.h"

#include <algorithm>
#include <cstring>
#include <random>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr Simd k_levels[] = {Simd::baseline, Simd::avx2, Simd::avx512};

WindView on_level(const WindView& view, Simd level) {
    return {view.box(), view.window(), view.blend_zone(), view.ambient(), view.field(), level};
}

template <class Velocity>
std::size_t that_differ(const std::vector<Velocity>& a, const std::vector<Velocity>& b) {
    std::size_t differing = 0;
    for (std::size_t n = 0; n < a.size(); ++n)
        differing += std::memcmp(&a[n], &b[n], sizeof(Velocity)) != 0;
    return differing + (a.size() != b.size() ? 1 : 0);
}

TEST(QueryList, APointHasTheBitsOfASingleCallOnEachLevel) {
    for (const QueryScene& scene : query_scenes()) {
        const Wind wind = noisy(scene);
        const WindView view = wind.view();
        const std::vector<glm::dvec3> points = points_of(scene, wind, 4000);
        std::vector<glm::vec3> alone(points.size()), felt_alone(points.size());
        for (std::size_t n = 0; n < points.size(); ++n) {
            alone[n] = on_level(view, Simd::baseline).velocity(points[n]);
            felt_alone[n] = on_level(view, Simd::baseline).felt(points[n], k_rippled);
        }
        for (const Simd level : k_levels) {
            if (!runs(level))
                continue;
            const WindView here = on_level(view, level);
            std::vector<glm::vec3> list(points.size()), felt(points.size());
            std::vector<glm::vec4> list4(points.size(), glm::vec4(7.0f)), alone4, felt4(points.size(), glm::vec4(7.0f)),
                felt_alone4;
            here.velocity(points, list);
            here.velocity(points, list4);
            here.felt(points, k_rippled, felt);
            here.felt(points, k_rippled, felt4);
            for (std::size_t n = 0; n < points.size(); ++n) {
                alone4.emplace_back(alone[n], 0.0f);
                felt_alone4.emplace_back(felt_alone[n], 0.0f);
            }
            EXPECT_EQ(that_differ(list, alone), 0u) << scene.name << " " << name_of(level);
            EXPECT_EQ(that_differ(list4, alone4), 0u) << scene.name << " " << name_of(level);
            EXPECT_EQ(that_differ(felt, felt_alone), 0u) << scene.name << " " << name_of(level);
            EXPECT_EQ(that_differ(felt4, felt_alone4), 0u) << scene.name << " " << name_of(level);
        }
    }
}

TEST(QueryList, NeitherNeighboursNorLengthMatter) {
    for (const QueryScene& scene : query_scenes()) {
        const Wind wind = noisy(scene);
        const std::vector<glm::dvec3> points = points_of(scene, wind, 700);
        std::vector<glm::vec3> list(points.size());
        wind.velocity(points, list);
        std::vector<std::size_t> order(points.size());
        for (std::size_t n = 0; n < order.size(); ++n)
            order[n] = n;
        std::mt19937 random(91);
        for (int turn = 0; turn < 4; ++turn) {
            std::shuffle(order.begin(), order.end(), random);
            std::vector<glm::dvec3> asked;
            std::vector<glm::vec3> expected;
            for (const std::size_t n : order) {
                asked.push_back(points[n]);
                expected.push_back(list[n]);
            }
            std::vector<glm::vec3> answered(asked.size());
            wind.velocity(asked, answered);
            EXPECT_EQ(that_differ(answered, expected), 0u) << scene.name;
        }
        for (std::size_t length = 0; length <= 33; ++length)
            for (const std::size_t first : {std::size_t{0}, std::size_t{5}, std::size_t{640}}) {
                const glm::vec3 untouched(12345.0f);
                std::vector<glm::vec3> some(length + 2, untouched);
                wind.velocity(std::span(points).subspan(first, length), std::span(some).subspan(1, length));
                std::vector<glm::vec3> expected(list.begin() + std::ptrdiff_t(first),
                                                list.begin() + std::ptrdiff_t(first + length));
                expected.insert(expected.begin(), untouched);
                expected.push_back(untouched);
                EXPECT_EQ(that_differ(some, expected), 0u) << scene.name << ", " << length << " points";
            }
    }
}

TEST(QueryList, TheShorterSpanCounts) {
    const Wind wind = noisy(query_scenes().front());
    const std::vector<glm::dvec3> points = points_of(query_scenes().front(), wind, 40);
    std::vector<glm::vec3> whole(40), some(40, glm::vec3(7.0f));
    wind.velocity(points, whole);
    wind.velocity(points, std::span(some).first(19));
    wind.velocity(std::span(points).first(17), std::span(some).subspan(20));
    for (std::size_t n = 0; n < 40; ++n) {
        const glm::vec3 expected = n < 19 ? whole[n] : n >= 20 && n < 37 ? whole[n - 20] : glm::vec3(7.0f);
        EXPECT_EQ(some[n], expected) << n;
    }
    wind.velocity({}, std::span(some));
    wind.velocity(points, std::span<glm::vec3>());
}

// A cell that is not finite reaches as far as its weight does.
TEST(QueryList, ABrokenCellIsNotFeltBeyondTheBox) {
    const QueryScene scene = query_scenes().front();
    Wind wind = noisy(scene);
    std::vector<glm::vec4> field(wind.field().size(), glm::vec4(k_nan, k_infinity, -k_infinity, 0.0f));
    ASSERT_TRUE(wind.set_velocity(field));
    std::vector<glm::dvec3> points;
    Random random(92);
    for (int n = 0; n < 200; ++n) // every second one is outside, so that each group has both
        points.push_back(n % 2 == 0 ? wind.origin() + glm::dvec3(wind.box().size()) * (0.5 + random.point(0.2))
                                    : wind.origin() - glm::dvec3(5.0 + n, 1.0, 3.0));
    std::vector<glm::vec3> list(points.size());
    wind.velocity(points, list);
    for (std::size_t n = 1; n < list.size(); n += 2)
        EXPECT_EQ(list[n], wind.ambient()) << n;
}

TEST(QueryList, TheAmbientWindAnswersListsAsSinglePoints) {
    for (const auto& profile : {std::optional<LogProfile>{}, std::optional(LogProfile{})})
        for (const float intensity : {0.0f, 0.4f}) {
            auto wind = AmbientWind::create(
                {.mean = {5.0f, 0.3f, -2.0f}, .profile = profile, .gusts = {.intensity = intensity}, .ground = 3.0});
            ASSERT_TRUE(wind);
            wind->advance(123.4);
            std::vector<glm::dvec3> points;
            Random random(93);
            for (int n = 0; n < 3001; ++n)
                points.push_back(random.direction() * random.spread(1e-3, n % 7 == 0 ? 1e12 : 1e4));
            points[100].x = points[500].y = points[900].z = std::numeric_limits<double>::quiet_NaN();
            points[101].x = points[501].y = points[901].z = std::numeric_limits<double>::infinity();
            points[102] = glm::dvec3(1.7e308);
            std::vector<glm::vec3> list(points.size()), alone, felt, felt_alone;
            wind->velocity(points, list);
            for (const glm::dvec3& point : points)
                alone.push_back(wind->velocity(point));
            EXPECT_EQ(that_differ(list, alone), 0u);
            for (const std::size_t n : {100u, 101u, 500u, 501u, 900u, 901u})
                EXPECT_EQ(list[n], wind->mean());
            felt = alone;
            wind->felt(points, k_rippled, felt);
            for (std::size_t n = 0; n < points.size(); ++n)
                felt_alone.push_back(wind->felt(alone[n], points[n], k_rippled));
            EXPECT_EQ(that_differ(felt, felt_alone), 0u);
        }
}

// --- The parts -----------------------------------------------------------------------------------------------------------------

// The place in the tile by its definition, with fmod, to the bit: near and far, and where a quotient is rounded to a whole number.
TEST(QueryList, ThePlaceInTheTileIsThatOfFmod) {
    Random random(94);
    const auto wrapped = [](double value, double period) {
        const double rest = std::fmod(value, period);
        return rest < 0.0 ? rest + period : rest;
    };
    int differing = 0;
    for (int turn = 0; turn < 200; ++turn) {
        const auto length = static_cast<float>(turn == 0 ? 24.0 : random.spread(0.01, 1e5));
        const auto texel = static_cast<double>(length) / 12.0;
        auto wind = AmbientWind::create({.mean = {3.0f, 0.0f, 1.0f},
                                         .gusts = {.intensity = 0.2f, .length = length, .tile = GustTile::standard()},
                                         .ground = turn % 2 == 0 ? 0.0 : 17.25});
        ASSERT_TRUE(wind);
        wind->advance(random.real(0.0, 1e4));
        for (int n = 0; n < 600; ++n) {
            const int axis = n % 3, texels = axis == 1 ? 32 : 128;
            const double period = texels * texel, origin = axis == 1 ? wind->ground() : 0.0;
            double coordinate = (n % 2 == 0 ? 1.0 : -1.0) * random.spread(1e-9, n % 5 == 0 ? 1e17 : 1e7);
            if (n % 4 == 0) // at a whole number of periods, and the doubles beside it
                coordinate = origin + std::nextafter(std::round(coordinate / period) * period, n % 8 == 0 ? 1e300 : -1e300);
            const double along = wrapped(coordinate - origin, period) - wind->phase()[axis];
            const double in_texels = wrapped(along / texel, texels) - 0.5, whole = std::floor(in_texels);
            const AmbientWind::TilePlace place = wind->gust_place(axis, coordinate);
            differing += !(place.texel == int(whole) && place.fraction == static_cast<float>(in_texels - whole));
        }
    }
    WINDROW_EXPECT_FIGURE("query_list/tile_places_not_fmods", differing, 0.0);
}

// With u = 2^-24: the height over z0 and the sum with 1 are rounded, by 3 u of the argument and so of the logarithm; a logarithm is
// off by a unit in its last place, 2 u, the quotient by u.
TEST(QueryList, TheProfileIsALogarithmToRounding) {
    constexpr double u = 0x1p-24;
    Random random(95);
    double worst = 0.0; // over its bound
    for (int turn = 0; turn < 300; ++turn) {
        const auto roughness = static_cast<float>(random.spread(1e-6, 100.0)),
                   reference = static_cast<float>(random.spread(0.01, 1e4));
        auto wind = AmbientWind::create(
            {.mean = {1.0f, 0.0f, 0.0f}, .profile = LogProfile{.roughness_length = roughness, .reference_height = reference}});
        ASSERT_TRUE(wind);
        std::vector<glm::dvec3> points;
        for (int n = 0; n < 300; ++n)
            points.emplace_back(0.0, random.spread(1e-6, 1e12), 0.0);
        std::vector<glm::vec3> list(points.size());
        wind->velocity(points, list);
        for (std::size_t n = 0; n < points.size(); ++n) {
            const double up = std::log1p(points[n].y / double(roughness)),
                         there = std::log1p(double(reference) / double(roughness));
            const double bound = (3.0 / up + 3.0 / there + 5.0) * u;
            worst = std::max(worst, std::abs(double(list[n].x) / (up / there) - 1.0) / bound);
        }
    }
    WINDROW_EXPECT_FIGURE("query_list/profile_error_over_bound", worst, 1.0);
}

// Every half, every tie and the floats beside it, and a million others, in rows of each length.
TEST(QueryList, HalvesHaveTheBitsOfToHalfOnEachLevel) {
    std::vector<float> numbers;
    for (std::uint32_t bits = 0; bits < 65536; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const float value = from_half(half), next = from_half(static_cast<std::uint16_t>(bits + 1));
        const float tie = static_cast<float>(0.5 * (double(value) + double(next)));
        numbers.insert(numbers.end(), {value, tie, std::nextafter(tie, -k_infinity), std::nextafter(tie, k_infinity)});
    }
    for (const float value :
         {65504.0f, 65519.996f, 65520.0f, 65536.0f, 1e30f, std::numeric_limits<float>::max(), k_infinity, 0x1p-24f, 0x1p-25f,
          0x1.8p-25f, 0x1.ffffp-15f, 1e-40f, std::numeric_limits<float>::denorm_min(), k_nan, 0.0f})
        numbers.insert(numbers.end(), {value, -value});
    Random random(96);
    const int count = sampled(1'000'000, 100'000);
    for (int n = 0; n < count; ++n)
        numbers.push_back(std::bit_cast<float>(random.bits()));
    while (numbers.size() % 4 != 3)
        numbers.push_back(1.0f);
    const std::size_t cells = numbers.size() / 4;
    for (const Simd level : k_levels) {
        if (!runs(level))
            continue;
        const cpu::Kernels& kernels = *cpu::kernels_for(level);
        std::size_t differing = 0;
        std::vector<std::uint16_t> vectors(4 * cells + 1, 77), axis(cells + 1, 77);
        kernels.halve_vectors(numbers.data(), cells, vectors.data());
        for (std::size_t n = 0; n < 4 * cells; ++n)
            differing += vectors[n] != (n % 4 < 3 ? to_half(numbers[n]) : std::uint16_t{0});
        for (int component = 0; component < 3; ++component) {
            kernels.halve_axis(numbers.data(), cells, component, axis.data());
            for (std::size_t n = 0; n < cells; ++n)
                differing += axis[n] != to_half(numbers[4 * n + std::size_t(component)]);
        }
        EXPECT_EQ(vectors.back(), 77);
        EXPECT_EQ(axis.back(), 77);
        for (std::size_t length = 0; length <= 33; ++length) {
            std::vector<std::uint16_t> some(4 * length + 1, 77);
            kernels.halve_vectors(numbers.data() + 4, length, some.data());
            differing += !std::equal(some.begin(), some.end() - 1, vectors.begin() + 4) || some.back() != 77;
        }
        WINDROW_EXPECT_FIGURE(std::string("query_list/halves_that_differ_") + name_of(level), double(differing), 0.0);
    }
}

} // namespace
