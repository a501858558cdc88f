// The strands' formulas on the device against the CPU: one text, 4e4 random inputs, eight kinds of fields.
#include "shader_words/strands.h"
#include "tests/fields.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"
#include "vegetation/fur/cloud_shell.h"
#include "vegetation/fur/strand_field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;
namespace vulkan = windrow::vulkan;

// As strands.comp has them, std430.
struct StrandQuery {
    glm::vec4 place, x, n, light;
    glm::ivec4 cell;
    glm::uvec4 which;
};
struct Answer {
    glm::uvec4 keys, chosen;
    glm::vec4 chances, uv, uv_root, uv_outward, surface, surface_root, surface_outward, slope, light, gloss, normal, cloud;
};
struct StrandFields {
    StrandFieldBlock fields[8];
    CloudShellBlock cloud;
};

StrandFields fields() {
    const StrandFieldSettings settings[8] = {
        {.density = 16.0f, .jitter = 0.0f},
        {.density = 16.0f, .seed = 5, .thickness = 1.3f},
        {.density = 16.0f, .low = 0.6f, .profile = StrandProfile::centre, .cut_exponent = 0.7f, .bow = 0.3f, .bow_turns = 2.0f},
        {.density = 16.0f, .profile = StrandProfile::edge, .cut_min = 0.0f, .cut_max = 0.6f, .cut_exponent = 0.7f},
        {.density = 16.0f, .wriggle = 1.0f, .phase = 0.37f, .profile = StrandProfile::edge, .cut_min = 0.0f, .cut_max = 0.5f},
        {.density = 16.0f,
         .stretch = 3.0f,
         .row_shift = 0.5f,
         .jitter = 0.3f,
         .shape = StrandShape::oval,
         .lift = 0.7f,
         .shaft = 0.05f},
        {.density = 16.0f,
         .stretch = 2.0f,
         .profile = StrandProfile::centre,
         .cut_max = 0.1f,
         .shape = StrandShape::strip,
         .half_length = 0.5f},
        {.density = 16.0f, .low = 0.8f, .tuft = 0.7f, .tuft_size = 4.0f}};
    StrandFields all{};
    for (std::size_t n = 0; n < 8; ++n) {
        EXPECT_TRUE(validate(settings[n])) << n;
        all.fields[n] = block(settings[n]);
    }
    all.cloud =
        block(CloudShellSettings{.size = 1.0f, .half_size = {4.0f, 3.0f}, .fading = 1.0f, .height = 0.5f}, {0.3, -0.2}, 0.1);
    return all;
}

Answer answer_of(const StrandQuery& c, const StrandFields& all) {
    using namespace numerics;
    const StrandFieldBlock& field = all.fields[c.which.x];
    const glm::vec3 x(c.x), n(c.n), light(c.light);
    const float h = c.place.z;
    const glm::uvec2 key = windrow_strand_key(c.which.y, glm::ivec2(c.cell));
    Answer a{};
    a.keys = glm::uvec4(key, windrow_space_hash(c.which.y, glm::ivec3(c.cell)));
    a.chances = {windrow_strand_chance(key), windrow_strand_other_chance(key), windrow_strand_tone(key, 0.3f),
                 windrow_turn_sine(x.x)};
    const StrandHit hit = strand_at(field, glm::vec2(c.place), h), on = strand_on(field, x, n, h);
    a.uv = {hit.inside, hit.reach, hit.radius, hit.shaft};
    a.uv_root = glm::vec4(hit.root, 0.0f);
    a.uv_outward = glm::vec4(hit.outward, 0.0f);
    a.surface = {on.inside, on.reach, on.radius, windrow_strand_top(field)};
    a.surface_root = glm::vec4(on.root, 0.0f);
    a.surface_outward = glm::vec4(on.outward, 0.0f);
    a.chosen = glm::uvec4(hit.key, on.key);
    a.slope = windrow_simplex_slope(c.which.y, x);
    const glm::vec3 half_way = windrow_half_way(light, n, n);
    const float cosine = glm::dot(n, light);
    a.light = {windrow_strand_occlusion(h, 0.7f, 0.1f), windrow_wrapped(cosine, c.place.w), windrow_cel(c.place.w, 4.0f, 0.3f),
               windrow_noise_pair(h, c.place.w, 0.3f, 0.8f)};
    a.gloss = {windrow_plain_gloss(n, half_way, 24.0f), windrow_hair_sheen(n, half_way, 40.0f), windrow_tips_through(h, cosine),
               0.0f};
    const glm::vec3 g = windrow_strand_gradient(light, x, n, 0.0f);
    a.normal =
        glm::vec4(windrow_strand_sloped(g, n, windrow_strand_slope(field, 0.7f * h, 0.8f) / 3.0f), windrow_strand_patch(3u, x));
    const float heap = windrow_cloud_heap(all.cloud, {x.x, x.z});
    a.cloud = {heap, windrow_cloud_top(heap), windrow_cloud_rim(all.cloud, {x.x, x.z}),
               windrow_cloud_inside(all.cloud, {x.x, x.z}, 0.4f * h, heap)};
    return a;
}

using StrandsOnTheDevice = vulkan::Gpu;

TEST_F(StrandsOnTheDevice, AsOnTheCpu) {
    constexpr std::size_t k_count = 40'000;
    const StrandFields all = fields();
    Random random(1);
    std::vector<StrandQuery> cases(k_count);
    for (std::size_t n = 0; n < k_count; ++n) {
        StrandQuery& c = cases[n];
        // 24 cells from the origin at the most, where floats have steps of 2e-6 cells.
        c.place = {random.uniform(-1.5f, 1.5f), random.uniform(-1.5f, 1.5f), n % 16 == 0 ? 0.0f : random.uniform(0.0f, 1.0f),
                   random.uniform(0.0f, 1.0f)};
        c.x = glm::vec4(random.vector(1.5f), 0.0f);
        c.n = glm::vec4(n % 8 == 0 ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(random.direction()), 0.0f);
        c.light = glm::vec4(glm::vec3(random.direction()), 0.0f);
        c.cell = {random.integer(-2'000'000, 2'000'000), random.integer(-2'000'000, 2'000'000), random.integer(-2000, 2000), 0};
        c.which = {static_cast<std::uint32_t>(n / 16) % 8u, static_cast<std::uint32_t>(random.integer(0, 1000)), 0u, 0u};
    }
    constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, uniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    const vulkan::Buffer in = uploaded(cases), fields_block = uploaded(std::span(&all, 1), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT),
                         out = buffer(k_count * sizeof(Answer), vulkan::MemoryUse::readback);
    dispatch(vulkan::shader_words::strands,
             {{.type = storage, .buffer = in.handle()},
              {.type = storage, .buffer = out.handle()},
              {.type = uniform, .buffer = fields_block.handle()}},
             k_count);
    const std::vector<Answer> answers = read<Answer>(out, k_count);

    struct ComparedAnswer {
        const char* name;
        glm::vec4 Answer::*member;
        bool chosen; // only where both chose the same strand
        double bound, largest = 0.0;
    };
    // Of size 1: 1e-5; normals short of the tip, where a blunt one's slope grows without bound. A slope of the noise is up to 7;
    // a root of 0 where two strands are equally near belongs to either.
    ComparedAnswer compared[] = {{"chances", &Answer::chances, false, 1e-5},
                                 {"uv", &Answer::uv, true, 1e-5},
                                 {"uv_root", &Answer::uv_root, true, 1e-5},
                                 {"uv_outward_cells", &Answer::uv_outward, true, 1e-5},
                                 {"surface", &Answer::surface, true, 1e-5},
                                 {"surface_root_m", &Answer::surface_root, true, 1e-5},
                                 {"surface_outward_cells", &Answer::surface_outward, true, 1e-5},
                                 {"noise_slope", &Answer::slope, false, 7e-5},
                                 {"light", &Answer::light, false, 1e-5},
                                 {"gloss", &Answer::gloss, false, 1e-5},
                                 {"normal", &Answer::normal, false, 1e-5},
                                 {"cloud", &Answer::cloud, false, 1e-5}};
    std::size_t hashes = 0, others = 0, drawn = 0, on_drawn = 0;
    for (std::size_t n = 0; n < k_count; ++n) {
        const Answer cpu = answer_of(cases[n], all);
        hashes += cpu.keys != answers[n].keys;
        const bool same = cpu.chosen == answers[n].chosen;
        others += !same;
        drawn += cpu.uv.x > 0.0f;
        on_drawn += cpu.surface.x > 0.0f;
        for (ComparedAnswer& kind : compared) {
            if (kind.chosen && !same)
                continue;
            for (int axis = 0; axis < 4; ++axis) {
                const double a = static_cast<double>((answers[n].*kind.member)[axis]),
                             b = static_cast<double>((cpu.*kind.member)[axis]);
                ASSERT_TRUE(std::isfinite(a) && std::isfinite(b)) << kind.name << " " << n;
                kind.largest = std::max(kind.largest, std::abs(a - b));
            }
        }
    }
    for (const ComparedAnswer& kind : compared)
        WINDROW_EXPECT_FIGURE(std::string("shells/device/") + kind.name, kind.largest, kind.bound);
    EXPECT_EQ(hashes, 0u) << "a key differs by a bit";
    // Points between two strands, or at the end of what is searched, to the last digit: a few at the most.
    WINDROW_EXPECT_FIGURE("shells/device/other_strands", static_cast<double>(others) / k_count, 2e-4);
    EXPECT_GT(drawn, k_count / 10);
    EXPECT_GT(on_drawn, k_count / 20);
}

} // namespace
} // namespace windrow::vegetation::fur
