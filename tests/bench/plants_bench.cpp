// What bending plants costs, beside a pass that only moves the same bytes.
//
//     windrow_plants_bench [blades] [threads...]          default 1000000, 1 and 2
//
// CPU: loads of all blades (keys and winds in, loads out), their vertices (5 rows, 10 vertices with normals, blade by blade), and
// the vertices of shells (a skin of as many vertices, one layer). Each turn runs every pass once, in blocks of 65536 blades so
// that the output fits where a renderer's ring of buffers would; least times of 7 turns. The copy reads and writes the same
// numbers of bytes. Device: one vertex an invocation against copy_plants.comp, which moves the same 64 bytes.
#include "coupling/blade.h"
#include "coupling/shell.h"
#include "fluid/thread_pool.h"
#include "tests/fields.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#if __has_include("shader_words/time_plants.h")
#include "fluid/vulkan/own_device.h"
#include "gpu/buffer.h"
#include "gpu/descriptor_sets.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "shader_words/copy_plants.h"
#include "shader_words/time_plants.h"
#define WITH_DEVICE 1
#endif

namespace {

using namespace windrow;

constexpr std::size_t k_block = 65536, k_rows = 5, k_vertices = 2 * k_rows;
constexpr int k_turns = 7;

template <class Body>
double seconds(const Body& body) {
    const auto start = std::chrono::steady_clock::now();
    body();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct BenchMeadow {
    std::vector<PlantKey> keys;
    std::vector<glm::vec4> roots, winds, normals, loads, positions, out_normals;
    std::vector<float> heights{0.0f, 0.25f, 0.5f, 0.75f, 1.0f};

    explicit BenchMeadow(std::size_t count)
        : keys(count), roots(count), winds(count), normals(count), loads(count), positions(k_vertices * std::min(count, k_block)),
          out_normals(positions.size()) {
        test::Random random(1);
        for (std::size_t n = 0; n < count; ++n) {
            keys[n] = {static_cast<std::uint32_t>(n % 1000), static_cast<std::uint32_t>(n / 1000)};
            roots[n] = glm::vec4(random.vector(100.0f), 1.0f);
            winds[n] = glm::vec4(random.vector(10.0f), 0.0f);
            normals[n] = glm::vec4(glm::vec3(random.direction()), 0.0f);
        }
    }
};

void must(const Result<void>& result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().c_str());
        std::exit(1);
    }
}

// Bytes of `from` into `to`, as often as they fit, by the pool.
void copy(std::span<const std::byte> from, std::span<std::byte> to, const ParallelFor& parallel_for) {
    constexpr std::size_t k_piece = 1 << 16;
    parallel_for(static_cast<int>((to.size() + k_piece - 1) / k_piece), [&](int piece) {
        const std::size_t at = static_cast<std::size_t>(piece) * k_piece, size = std::min(k_piece, to.size() - at);
        std::memcpy(to.data() + at, from.data() + at % (from.size() - size + 1), size);
    });
}

void on_the_cpu(std::size_t count, int threads) {
    ThreadPool pool(threads);
    const ParallelFor run = pool.parallel_for();
    const auto grass = Blades::create({});
    const auto fur = Shells::create({});
    if (!grass || !fur)
        std::exit(1);
    BenchMeadow meadow(count);
    double loads = 1e30, vertices = 1e30, bent = 1e30, pushed = 1e30, copy_loads = 1e30, copy_vertices = 1e30, copy_shell = 1e30;
    const auto blocks = [&](const auto& body) {
        for (std::size_t first = 0; first < count; first += k_block)
            body(first, std::min(k_block, count - first));
    };
    const auto part = [](auto& values, std::size_t first, std::size_t size) { return std::span(values).subspan(first, size); };
    for (int turn = 0; turn < k_turns; ++turn) {
        loads = std::min(loads, seconds([&] { must(grass->loads(meadow.keys, meadow.winds, meadow.loads, run)); }));
        copy_loads = std::min(
            copy_loads,
            seconds([&] { copy(std::as_bytes(std::span(meadow.winds)), std::as_writable_bytes(std::span(meadow.loads)), run); }));
        must(grass->loads(meadow.keys, meadow.winds, meadow.loads, run));
        vertices = std::min(vertices, seconds([&] {
                                blocks([&](std::size_t first, std::size_t size) {
                                    must(grass->vertices(part(meadow.keys, first, size), part(meadow.roots, first, size),
                                                         part(meadow.loads, first, size), meadow.heights,
                                                         {part(meadow.positions, 0, k_vertices * size),
                                                          part(meadow.out_normals, 0, k_vertices * size)},
                                                         {0.0f, 0.0f, 1.0f}, run));
                                });
                            }));
        copy_vertices = std::min(copy_vertices, seconds([&] {
                                     blocks([&](std::size_t first, std::size_t size) {
                                         const auto from = std::as_bytes(part(meadow.roots, first, size));
                                         copy(from, std::as_writable_bytes(part(meadow.positions, 0, k_vertices * size)), run);
                                         copy(from, std::as_writable_bytes(part(meadow.out_normals, 0, k_vertices * size)), run);
                                     });
                                 }));
        bent = std::min(bent, seconds([&] {
                            blocks([&](std::size_t first, std::size_t size) {
                                must(fur->bent({part(meadow.roots, first, size), part(meadow.normals, first, size)}, 0.6f,
                                               part(meadow.loads, first, size), part(meadow.positions, 0, size), run));
                            });
                        }));
        pushed = std::min(pushed, seconds([&] {
                              blocks([&](std::size_t first, std::size_t size) {
                                  must(fur->translated({part(meadow.roots, first, size), part(meadow.normals, first, size)}, 0.6f,
                                                       part(meadow.loads, first, size), part(meadow.positions, 0, size), run));
                              });
                          }));
        copy_shell = std::min(copy_shell, seconds([&] {
                                  blocks([&](std::size_t first, std::size_t size) {
                                      for (auto* input : {&meadow.roots, &meadow.normals, &meadow.loads})
                                          copy(std::as_bytes(part(*input, first, size)),
                                               std::as_writable_bytes(part(meadow.positions, 0, size)), run);
                                  });
                              }));
    }
    const double each = 1e9 / static_cast<double>(count);
    std::printf("%d thread%s, %zu plants                     ns each    ns of a copy    ratio\n", threads,
                threads == 1 ? "" : "s", count);
    std::printf("  a blade's load                         %10.2f %14.2f %9.1f\n", loads * each, copy_loads * each,
                loads / copy_loads);
    std::printf("  a blade's 10 vertices with normals     %10.2f %14.2f %9.1f\n", vertices * each, copy_vertices * each,
                vertices / copy_vertices);
    std::printf("  a shell's vertex, stem form            %10.2f %14.2f %9.1f\n", bent * each, copy_shell * each,
                bent / copy_shell);
    std::printf("  a shell's vertex, translate form       %10.2f %14.2f %9.1f\n", pushed * each, copy_shell * each,
                pushed / copy_shell);
}

#ifdef WITH_DEVICE
void on_the_device(std::size_t count) {
    using namespace vulkan;
    auto own = OwnDevice::create({});
    if (!own) {
        std::printf("no device: %s\n", own.error().c_str());
        return;
    }
    auto device = Device::create((*own)->host());
    if (!device) {
        std::printf("no device: %s\n", device.error().c_str());
        return;
    }
    const auto grass = Blades::create({});
    const VkDeviceSize bytes = 2 * count * sizeof(glm::vec4);
    Buffer in = *Buffer::create(**device, bytes, MemoryUse::upload), out = *Buffer::create(**device, bytes, MemoryUse::device),
           block = *Buffer::create(**device, sizeof(BladeBlock), MemoryUse::upload);
    test::Random random(1);
    auto* values = reinterpret_cast<glm::vec4*>(in.mapped());
    for (std::size_t n = 0; n < count; ++n) {
        values[2 * n] = glm::vec4(random.vector(100.0f), 1.0f);
        values[2 * n + 1] = glm::vec4(random.vector(10.0f), random.uniform(0.0f, 1.0f));
    }
    std::memcpy(block.mapped(), &grass->block(), sizeof(BladeBlock));
    (void)in.flush();
    (void)block.flush();
    constexpr VkDescriptorType k_storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    const std::vector<VkDescriptorType> three(3, k_storage), two(2, k_storage);
    Pipeline bend =
        *Pipeline::create(**device, {.code = shader_words::time_plants, .bindings = three, .constants = {}, .name = "bend"});
    Pipeline copied =
        *Pipeline::create(**device, {.code = shader_words::copy_plants, .bindings = two, .constants = {}, .name = "copy"});
    const Binding from{.type = k_storage, .buffer = in.handle()}, to{.type = k_storage, .buffer = out.handle()},
        classes{.type = k_storage, .buffer = block.handle()};
    const Sets::Content contents[] = {{&bend, {from, to, classes}}, {&copied, {from, to}}};
    Sets sets = *Sets::create(**device, contents);
    double least[2] = {1e30, 1e30};
    for (int turn = 0; turn < k_turns; ++turn)
        for (std::size_t kind = 0; kind < 2; ++kind) {
            const Pipeline& pipeline = kind == 0 ? bend : copied;
            const double taken = seconds([&] {
                const auto done = (*own)->run([&](VkCommandBuffer commands) {
                    const Functions& call = (*device)->functions();
                    pipeline.bind(call, commands, sets.at(kind));
                    call.vkCmdDispatch(commands, static_cast<std::uint32_t>((count + 63) / 64), 1, 1);
                });
                must(done);
            });
            least[kind] = std::min(least[kind], taken);
        }
    const double each = 1e9 / static_cast<double>(count);
    std::printf("device, %zu vertices, submit to idle    ns each    ns of a copy    ratio\n", count);
    std::printf("  a blade's vertex, load included        %10.3f %14.3f %9.1f\n", least[0] * each, least[1] * each,
                least[0] / least[1]);
}
#endif

} // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 1'000'000;
    if (count < 1 || count > 50'000'000)
        return std::fprintf(stderr, "give 1 to 50000000 blades\n"), 2;
    if (argc > 2)
        for (int n = 2; n < argc; ++n)
            on_the_cpu(count, std::max(1, std::atoi(argv[n])));
    else
        for (const int threads : {1, 2})
            on_the_cpu(count, threads);
#ifdef WITH_DEVICE
    on_the_device(count);
#endif
}
