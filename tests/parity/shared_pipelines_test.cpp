// Pipelines that the winds of a device share, the host's pipeline cache, and the names and labels that a debugger reads.
#include "fluid/vulkan/pipeline_store.h"
#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <malloc.h>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace windrow::vulkan {
namespace {

// What the calls below know; Vulkan's calls carry no pointer of ours.
struct Watched {
    PFN_vkGetInstanceProcAddr instance_call = nullptr;
    Functions real;
    int pipelines = 0;
    std::set<VkPipelineCache> caches{};
    std::set<const VkAllocationCallbacks*> callbacks{}; ///< of pipelines
    std::multiset<std::string> names{}, labels{};
    std::vector<std::string> open{};         ///< labels
    std::multiset<std::string> dispatches{}; ///< by the labels that are open, as "windrow tick/advect"
    bool debug = true;                       ///< the extension is there
    int buffers = 0, failing_buffer = -1;    ///< vkCreateBuffer so far, and the one that fails
};
Watched g_watched;
std::mutex g_watching; // winds are made by several threads

VkResult VKAPI_CALL watch_pipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                    const VkComputePipelineCreateInfo* infos, const VkAllocationCallbacks* callbacks,
                                    VkPipeline* made) {
    {
        const std::lock_guard lock(g_watching);
        g_watched.pipelines += static_cast<int>(count);
        g_watched.caches.insert(cache);
        g_watched.callbacks.insert(callbacks);
    }
    return g_watched.real.vkCreateComputePipelines(device, cache, count, infos, callbacks, made);
}

VkResult VKAPI_CALL watch_name(VkDevice device, const VkDebugUtilsObjectNameInfoEXT* info) {
    {
        const std::lock_guard lock(g_watching);
        g_watched.names.insert(info->pObjectName);
    }
    EXPECT_NE(info->objectHandle, 0u) << info->pObjectName;
    return g_watched.real.vkSetDebugUtilsObjectNameEXT(device, info);
}

void VKAPI_CALL watch_begin(VkCommandBuffer commands, const VkDebugUtilsLabelEXT* label) {
    g_watched.labels.insert(label->pLabelName);
    g_watched.open.emplace_back(label->pLabelName);
    g_watched.real.vkCmdBeginDebugUtilsLabelEXT(commands, label);
}

void VKAPI_CALL watch_end(VkCommandBuffer commands) {
    ASSERT_FALSE(g_watched.open.empty());
    g_watched.open.pop_back();
    g_watched.real.vkCmdEndDebugUtilsLabelEXT(commands);
}

void VKAPI_CALL watch_dispatch(VkCommandBuffer commands, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    std::string path;
    for (const std::string& label : g_watched.open)
        path += (path.empty() ? "" : "/") + label;
    g_watched.dispatches.insert(path);
    g_watched.real.vkCmdDispatch(commands, x, y, z);
}

VkResult VKAPI_CALL watch_buffer(VkDevice device, const VkBufferCreateInfo* info, const VkAllocationCallbacks* callbacks,
                                 VkBuffer* made) {
    {
        const std::lock_guard lock(g_watching);
        if (g_watched.buffers++ == g_watched.failing_buffer)
            return VK_ERROR_OUT_OF_HOST_MEMORY;
    }
    return g_watched.real.vkCreateBuffer(device, info, callbacks, made);
}

PFN_vkVoidFunction VKAPI_CALL watched_device_call(VkDevice device, const char* name) {
    const auto is = [name](const char* call) { return std::strcmp(name, call) == 0; };
    if (is("vkCreateComputePipelines"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watch_pipelines);
    if (is("vkCmdDispatch"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watch_dispatch);
    if (is("vkCreateBuffer"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watch_buffer);
    return g_watched.real.vkGetDeviceProcAddr(device, name);
}

PFN_vkVoidFunction VKAPI_CALL watched_instance_call(VkInstance instance, const char* name) {
    const auto is = [name](const char* call) { return std::strcmp(name, call) == 0; };
    if (is("vkGetDeviceProcAddr"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watched_device_call);
    if (std::strstr(name, "DebugUtils") != nullptr && !g_watched.debug)
        return nullptr;
    if (is("vkSetDebugUtilsObjectNameEXT"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watch_name);
    if (is("vkCmdBeginDebugUtilsLabelEXT"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watch_begin);
    if (is("vkCmdEndDebugUtilsLabelEXT"))
        return reinterpret_cast<PFN_vkVoidFunction>(&watch_end);
    return g_watched.instance_call(instance, name);
}

// --- The host's memory, which a driver moves too -----------------------------------------------------------------------------

void* VKAPI_CALL allocate(void*, std::size_t bytes, std::size_t alignment, VkSystemAllocationScope) {
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}
void VKAPI_CALL release(void*, void* memory) {
    std::free(memory);
}
void* VKAPI_CALL move(void* user, void* from, std::size_t bytes, std::size_t alignment, VkSystemAllocationScope scope) {
    void* const to = allocate(user, bytes, alignment, scope);
    if (from != nullptr && to != nullptr)
        std::memcpy(to, from, std::min(bytes, malloc_usable_size(from)));
    release(user, from);
    return to;
}

class SharedPipelines : public Gpu {
  protected:
    void SetUp() override {
        Gpu::SetUp();
        ASSERT_TRUE(own);
        host = own->host();
        g_watched = {};
        g_watched.instance_call = host.get_instance_proc_addr;
        g_watched.real = device->functions();
        host.get_instance_proc_addr = &watched_instance_call;
    }

    void TearDown() override {
        host = {}; // the store goes before the device
        Gpu::TearDown();
    }

    [[nodiscard]] Wind wind(const Config& config) const {
        auto made = Wind::create(host, config, {.queries = ReadBack::cells});
        EXPECT_TRUE(made) << made.error();
        return *std::move(made);
    }

    // A frame with a tick; the cells that it reads back.
    std::vector<glm::vec4> blown(Wind& wind) {
        EXPECT_TRUE(wind.motors().add(VortexMotor{}));
        for (int n = 0; n < 3; ++n)
            run([&](VkCommandBuffer commands) { held(wind.record(commands, {.dt = 1.0 / 30.0, .slot = 0})); });
        const auto field = wind.queried()->field();
        return {field.begin(), field.end()};
    }

    static constexpr glm::ivec3 k_cells{16, 8, 16};
    Host host;
};

// The second wind of a box compiles nothing; one of another box compiles what differs.
TEST_F(SharedPipelines, AreMadeOnceForAllWindsOfADevice) {
    const Config config{.cells = k_cells, .ambient = {2.0f, 0.0f, 1.0f}};
    const auto timed = [&] {
        const auto start = std::chrono::steady_clock::now();
        (void)wind(config);
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    };
    (void)timed(); // the driver's own first time
    test::figure("milliseconds of a wind that makes its pipelines", timed());
    const int of_a_wind = g_watched.pipelines / 2;
    EXPECT_GT(of_a_wind, 10);

    auto store = PipelineStore::create(host);
    ASSERT_TRUE(store) << store.error();
    host.pipeline_store = *store;
    g_watched.pipelines = 0;
    Wind first = wind(config);
    EXPECT_EQ(g_watched.pipelines, of_a_wind);
    EXPECT_EQ((*store)->count(), static_cast<std::size_t>(of_a_wind));
    test::figure("milliseconds of a wind whose pipelines are there", timed());
    EXPECT_EQ(g_watched.pipelines, of_a_wind);
    Wind second = wind(config);
    EXPECT_EQ(blown(first), blown(second));

    Wind other = wind({.cells = {16, 8, 20}});
    EXPECT_GT(g_watched.pipelines, of_a_wind);
    EXPECT_LT(g_watched.pipelines, 2 * of_a_wind); // those of columns are the same
}

// A wind keeps the store, which the host may have let go.
TEST_F(SharedPipelines, OutliveTheHostsHandleAndTheWindThatMadeThem) {
    auto store = PipelineStore::create(host);
    ASSERT_TRUE(store) << store.error();
    const std::weak_ptr<PipelineStore> kept = *store;
    host.pipeline_store = *std::move(store);
    std::optional<Wind> first = wind({.cells = k_cells}), second = wind({.cells = k_cells});
    host.pipeline_store.reset();
    first.reset();
    EXPECT_FALSE(blown(*second).empty());
    EXPECT_FALSE(kept.expired());
    second.reset();
    EXPECT_TRUE(kept.expired());
}

TEST_F(SharedPipelines, AreMadeByManyThreadsOnce) {
    (void)wind({.cells = k_cells});
    const int of_a_wind = std::exchange(g_watched.pipelines, 0);
    auto store = PipelineStore::create(host);
    ASSERT_TRUE(store) << store.error();
    host.pipeline_store = *store;
    std::vector<std::thread> threads;
    for (int n = 0; n < 4; ++n)
        threads.emplace_back([&] { (void)wind({.cells = k_cells}); });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(g_watched.pipelines, of_a_wind);
    EXPECT_EQ((*store)->count(), static_cast<std::size_t>(of_a_wind));
}

TEST_F(SharedPipelines, OfAnotherDeviceAreRejected) {
    auto other = OwnDevice::create({});
    ASSERT_TRUE(other) << other.error();
    auto store = PipelineStore::create((*other)->host());
    ASSERT_TRUE(store) << store.error();
    host.pipeline_store = *store;
    expect_error(Wind::create(host, {}), "pipeline_store is of another VkDevice: create a PipelineStore from this host.");
}

TEST_F(SharedPipelines, AreLookedForInTheHostsCacheAndTakeItsMemory) {
    (void)wind({.cells = k_cells});
    EXPECT_EQ(g_watched.caches, std::set<VkPipelineCache>{VK_NULL_HANDLE});
    EXPECT_EQ(g_watched.callbacks, std::set<const VkAllocationCallbacks*>{nullptr});
    const auto call = [&](const char* name) { return g_watched.instance_call(host.instance, name); };
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    ASSERT_EQ(reinterpret_cast<PFN_vkCreatePipelineCache>(call("vkCreatePipelineCache"))(host.device, &info, nullptr,
                                                                                         &host.pipeline_cache),
              VK_SUCCESS);
    const VkAllocationCallbacks callbacks{.pUserData = nullptr,
                                          .pfnAllocation = &allocate,
                                          .pfnReallocation = &move,
                                          .pfnFree = &release,
                                          .pfnInternalAllocation = nullptr,
                                          .pfnInternalFree = nullptr};
    host.allocation_callbacks = &callbacks;
    for (const bool stored : {false, true}) {
        if (stored)
            host.pipeline_store = held(PipelineStore::create(host));
        g_watched.caches.clear();
        g_watched.callbacks.clear();
        (void)wind({.cells = k_cells});
        EXPECT_EQ(g_watched.caches, std::set<VkPipelineCache>{host.pipeline_cache}) << stored;
        EXPECT_EQ(g_watched.callbacks, std::set<const VkAllocationCallbacks*>{&callbacks}) << stored;
    }
    host.pipeline_store.reset();
    reinterpret_cast<PFN_vkDestroyPipelineCache>(call("vkDestroyPipelineCache"))(host.device, host.pipeline_cache, nullptr);
}

// --- Names and labels --------------------------------------------------------------------------------------------------------

TEST_F(SharedPipelines, AndAllElseHaveNames) {
    Wind named = wind({.cells = k_cells});
    for (const char* name : {"windrow velocity", "windrow tile", "windrow advect", "windrow columns"})
        EXPECT_EQ(g_watched.names.count(name), 1u) << name;
    EXPECT_EQ(g_watched.names.count("windrow texture"), 2u);
    (void)blown(named);
    EXPECT_TRUE(g_watched.open.empty());
    EXPECT_EQ(g_watched.labels.count("windrow tick"), 3u);
    EXPECT_EQ(g_watched.dispatches.count(""), 0u);
    EXPECT_GE(g_watched.dispatches.count("windrow tick/advect"), 3u);
    EXPECT_GE(g_watched.dispatches.count("show"), 3u);
}

// No object that was not made is named, whichever buffer fails.
TEST_F(SharedPipelines, HaveNoNameWhereTheyAreNotMade) {
    (void)wind({.cells = k_cells});
    const int buffers = std::exchange(g_watched.buffers, 0);
    for (g_watched.failing_buffer = 0; g_watched.failing_buffer < buffers; g_watched.failing_buffer += 5) {
        EXPECT_FALSE(Wind::create(host, {.cells = k_cells})) << g_watched.failing_buffer;
        g_watched.buffers = 0;
    }
}

TEST_F(SharedPipelines, HaveNoNamesWithoutTheExtension) {
    g_watched.debug = false;
    Wind plain = wind({.cells = k_cells});
    (void)blown(plain);
    EXPECT_TRUE(g_watched.names.empty());
    EXPECT_TRUE(g_watched.labels.empty());
}

} // namespace
} // namespace windrow::vulkan
