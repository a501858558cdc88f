// Each barrier of a recording, left out once: the layer's synchronisation checks notice 214 of 274. The rest (layer 1.3.239)
//   stand between passes of a direct solve of viscosity that change one buffer in place. The layer takes a buffer that a pass
//   reads and writes as written alone, and does not speak of two such writes in a row
//   stand between two transfers of which the later touches nothing of the earlier
//   stand at the start of a command buffer, for what the host or a recording without a read-back did before, or hand the textures
//   to the host's shaders and the read-back to the host: none of these is in this story
//
// The host hands out its calls by vkGetInstanceProcAddr; ours puts its own in place of the one that records barriers.
#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"
#include "tests/parity/submitter.h"
#include "tests/tier.h"

#include <cstring>
#include <span>

namespace windrow::vulkan {
namespace {

// What the calls below know; Vulkan's calls carry no pointer of ours.
struct Dropping {
    PFN_vkGetInstanceProcAddr instance_call = nullptr;
    PFN_vkGetDeviceProcAddr device_call = nullptr;
    PFN_vkCmdPipelineBarrier barrier = nullptr;
    int drop = -1; ///< the one that is left out, counted from 0; -1: none
    int seen = 0;
};
Dropping g_dropping;

void VKAPI_CALL drop_barrier(VkCommandBuffer commands, VkPipelineStageFlags from, VkPipelineStageFlags to,
                             VkDependencyFlags dependencies, std::uint32_t memory_count, const VkMemoryBarrier* memory,
                             std::uint32_t buffer_count, const VkBufferMemoryBarrier* buffers, std::uint32_t image_count,
                             const VkImageMemoryBarrier* images) {
    if (g_dropping.seen++ == g_dropping.drop)
        return;
    g_dropping.barrier(commands, from, to, dependencies, memory_count, memory, buffer_count, buffers, image_count, images);
}

PFN_vkVoidFunction VKAPI_CALL device_call(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkCmdPipelineBarrier") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&drop_barrier);
    return g_dropping.device_call(device, name);
}

PFN_vkVoidFunction VKAPI_CALL instance_call(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&device_call);
    return g_dropping.instance_call(instance, name);
}

class WindBarriers : public Gpu {
  protected:
    void SetUp() override {
        setenv("VK_LAYER_ENABLES", "VALIDATION_CHECK_ENABLE_SYNCHRONIZATION_VALIDATION_QUEUE_SUBMIT", 1);
        make_own({.validation = true});
        unsetenv("VK_LAYER_ENABLES");
        ASSERT_TRUE(own);
        host = own->host();
        g_dropping = {};
        g_dropping.instance_call = host.get_instance_proc_addr;
        g_dropping.device_call =
            reinterpret_cast<PFN_vkGetDeviceProcAddr>(host.get_instance_proc_addr(host.instance, "vkGetDeviceProcAddr"));
        g_dropping.barrier =
            reinterpret_cast<PFN_vkCmdPipelineBarrier>(g_dropping.device_call(host.device, "vkCmdPipelineBarrier"));
        host.get_instance_proc_addr = &instance_call;
    }

    static constexpr int k_frames = 4, k_in_one = 2; ///< of a story, and of a command buffer

    // Everything that a recording may hold, in two command buffers that nobody waits for.
    void live(Wind& wind, Submitter& submitter, const std::vector<glm::vec4>& cells) {
        wind.forget();
        const MotorId blast = *wind.motors().add(OmniMotor{.position = {1.0, 0.0, 1.0}});
        int n = 0;
        for (int buffer = 0; buffer < k_frames / k_in_one; ++buffer)
            submitter.frame([&](VkCommandBuffer commands, int) {
                for (int frame = 0; frame < k_in_one; ++frame, ++n) {
                    (void)wind.follow({1.2 * n, 0.0, 0.0});
                    if (n == 1)
                        (void)wind.set_ambient({2.0f, 0.0f, 0.1f * static_cast<float>(++turns_ % 7)});
                    if (n == 2)
                        (void)wind.set_velocity(cells);
                    if (n == 3) {
                        (void)wind.motors().remove(blast);
                        (void)wind.set_gusts({.intensity = 0.2f, .seed = static_cast<std::uint32_t>(++turns_)});
                        (void)wind.set_boundaries(turns_ % 2 == 0 ? Boundaries{} : Boundaries::open_over_floor());
                    }
                    held(wind.record(commands, {.dt = n == 1 ? 1.0 / 15.0 : 1.0 / 30.0, .slot = n}));
                }
            });
        submitter.wait();
        (void)wind.set_gusts({});
    }

    // Leaves out each barrier once, or one of `stride`: how many were, and how many of them were noticed.
    void try_all(const char* name, int percent, const Config& config, std::span<const Obstacle> obstacles = {}, int stride = 1) {
        auto wind = Wind::create(host, config,
                                 {.frames_in_flight = k_frames,
                                  .gusts = true,
                                  .queries = ReadBack::cells,
                                  .forces = static_cast<int>(obstacles.size())});
        ASSERT_TRUE(wind) << wind.error();
        ASSERT_TRUE(wind->motors().add(VortexMotor{}));
        ASSERT_TRUE(wind->motors().add(DirectionalMotor{.law = Force{}}));
        for (const Obstacle& obstacle : obstacles)
            ASSERT_TRUE(wind->obstacles().add(obstacle));
        const std::vector<glm::vec4> cells(static_cast<std::size_t>(config.cells.x * config.cells.y * config.cells.z),
                                           glm::vec4(1.0f));
        Submitter submitter(own->host(), 2);
        g_dropping.drop = -1;
        g_dropping.seen = 0;
        live(*wind, submitter, cells);
        ASSERT_TRUE(messages.empty()) << messages.front();
        const int barriers = g_dropping.seen;
        int tried = 0, caught = 0;
        for (int n = 0; n < barriers; n += stride, ++tried) {
            g_dropping.drop = n;
            g_dropping.seen = 0;
            live(*wind, submitter, cells);
            caught += messages.empty() ? 0 : 1;
            messages.clear();
        }
        g_dropping.drop = -1;
        live(*wind, submitter, cells); // the layer forgets the last hazard
        messages.clear();
        test::figure(std::string("barriers left out: ") + name, tried);
        test::figure(std::string("barriers noticed: ") + name, caught);
        EXPECT_GE(100 * caught, percent * tried); // a pass that loses its barriers takes several in a hundred
        all_tried_ += tried;
        all_caught_ += caught;
    }

    Host host;
    int turns_ = 0, all_tried_ = 0, all_caught_ = 0;
};

TEST_F(WindBarriers, EachIsMissedWhereItIsLeftOut) {
    try_all("plain", 75, {.cells = {8, 6, 8}, .ambient = {2.0f, 0.0f, 0.0f}, .max_substeps = 2});
    try_all("viscous", 65,
            {// most barriers of the implicit solves are between passes that change one buffer in place
             .cells = {8, 6, 8},
             .boundaries = Boundaries::open_over_floor(),
             .ambient = {2.0f, 0.0f, 0.0f},
             .viscosity = 9.0f,
             .max_substeps = 1},
            {}, test::whole_sweeps() ? 1 : 3);
    EXPECT_GE(10 * all_caught_, 7 * all_tried_);
}

// A block and a fence on rough ground, with two solves, and the forces on them.
TEST_F(WindBarriers, EachIsMissedWhereItIsLeftOutAmongObstacles) {
    const Obstacle obstacles[] = {{.position = {1.0, 0.0, 1.0}, .shape = Block{{1.2f, 1.0f, 1.0f}}},
                                  {.position = {-2.0, 0.0, -1.0}, .shape = Plate{{2.0f, 2.0f}}}};
    Config config{.cells = {8, 6, 8}, .ambient = {2.0f, 0.0f, 0.0f}, .max_substeps = 1};
    config.roughness.emplace();
    config.pressure_solves = 2;
    try_all("obstacles", 65, config, obstacles, test::whole_sweeps() ? 2 : 9);
}

} // namespace
} // namespace windrow::vulkan
