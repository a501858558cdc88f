// The field's own vertex stage in Windrow's wind, as a host binds it: even air gives the picture of that even wind, and a fan
// another.
#include "fluid/vulkan/wind.h"
#include "shader_words/grass_wind_vert.h"
#include "shader_words/windy_frag.h"
#include "tests/figure.h"
#include "vegetation/tests/grass/device.h"
#include "vegetation/tests/grass/picture.h"

#include <array>
#include <cstring>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::grass {
namespace {

using windrow::vulkan::Buffer;
using windrow::vulkan::Place;

// The wind's set, as shaders/coupling/windrow_wind.glsl lists it.
class WindSet {
  public:
    explicit WindSet(VkDevice device) : device_(device) {
        VkDescriptorSetLayoutBinding bindings[8]{};
        for (std::uint32_t n = 0; n < 8; ++n)
            bindings[n] = {n, kind(n), 1, VK_SHADER_STAGE_VERTEX_BIT, nullptr};
        VkDescriptorSetLayoutCreateInfo layout_info{};
        layout_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        layout_info.bindingCount = 8;
        layout_info.pBindings = bindings;
        EXPECT_EQ(vkCreateDescriptorSetLayout(device_, &layout_info, nullptr, &layout), VK_SUCCESS);
        const VkDescriptorPoolSize sizes[] = {{kind(0), 1}, {kind(1), 6}, {kind(7), 1}};
        VkDescriptorPoolCreateInfo pool_info{};
        pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
        pool_info.maxSets = 1;
        pool_info.poolSizeCount = 3;
        pool_info.pPoolSizes = sizes;
        EXPECT_EQ(vkCreateDescriptorPool(device_, &pool_info, nullptr, &pool_), VK_SUCCESS);
        VkDescriptorSetAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        info.descriptorPool = pool_;
        info.descriptorSetCount = 1;
        info.pSetLayouts = &layout;
        EXPECT_EQ(vkAllocateDescriptorSets(device_, &info, &set), VK_SUCCESS);
        VkSamplerCreateInfo sampler_info{};
        sampler_info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
        EXPECT_EQ(vkCreateSampler(device_, &sampler_info, nullptr, &sampler_), VK_SUCCESS);
    }
    WindSet(const WindSet&) = delete;
    WindSet& operator=(const WindSet&) = delete;
    ~WindSet() {
        vkDestroySampler(device_, sampler_, nullptr);
        vkDestroyDescriptorPool(device_, pool_, nullptr);
        vkDestroyDescriptorSetLayout(device_, layout, nullptr);
    }
    void point_at(const windrow::vulkan::Wind& wind, VkBuffer block) {
        const windrow::vulkan::Textures now = wind.textures(), before = wind.previous_textures();
        for (std::uint32_t n = 0; n < 8; ++n) {
            const VkDescriptorBufferInfo buffer{n == 0 ? block : wind.gust_buffer(), 0, VK_WHOLE_SIZE};
            const VkDescriptorImageInfo image{sampler_,
                                              n == 0 || n == 7 ? VK_NULL_HANDLE
                                              : n <= 3         ? now.views[n - 1]
                                                               : before.views[n - 4],
                                              VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            VkWriteDescriptorSet write{};
            write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
            write.dstSet = set;
            write.dstBinding = n;
            write.descriptorCount = 1;
            write.descriptorType = kind(n);
            write.pBufferInfo = &buffer;
            write.pImageInfo = &image;
            vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
        }
    }
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    VkDescriptorSet set = VK_NULL_HANDLE;

  private:
    static VkDescriptorType kind(std::uint32_t n) {
        return n == 0   ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
               : n == 7 ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                        : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    }
    VkDevice device_;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkSampler sampler_ = VK_NULL_HANDLE;
};

using GrassInTheWind = test::GrassOnTheDevice;

TEST_F(GrassInTheWind, LeansAsTheAirBlows) {
    GrassSettings settings = test::small_field();
    settings.least_width = 0.005f;
    make_field(settings);
    const glm::dvec3 corner(3.0e4, 0.0, -2.0e4), middle = corner + glm::dvec3(16.0, 2.0, 25.0);
    ASSERT_TRUE(field->place(corner));
    const test::Eye eye = test::eye_at({16.0f, 3.5f, 8.0f}, {0.0f, -0.2f, 1.0f});
    const GrassCamera camera{.anchor = corner, .view_projection = eye.view_projection, .eye = eye.at};
    auto wind = windrow::vulkan::Wind::create(
        own->host(), {.cells = {24, 8, 24}, .centre = middle, .ambient = {1.5f, 0.0f, 0.0f}}, {.frames_in_flight = 1});
    ASSERT_TRUE(wind) << wind.error();
    {
        WindSet wind_set(own->host().device);
        const test::Picture still(own->host(), test::Picture::still(*field));
        const test::Picture windy(own->host(), {{wind_set.layout, field->layout()},
                                                windrow::vulkan::shader_words::grass_wind_vert,
                                                windrow::vulkan::shader_words::windy_frag});
        const Buffer pixels = buffer(4 * test::Picture::k_pixels, Place::readback);
        const Buffer block =
            *Buffer::create(*device, sizeof(windrow::FrameBlock), Place::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        const auto draw = [&](const test::Picture& picture) {
            run([&](VkCommandBuffer commands) {
                (void)wind->record(commands, {.dt = 1.0 / 30.0});
                const windrow::FrameBlock told = wind->frame_block(corner);
                std::memcpy(block.mapped(), &told, sizeof told);
                EXPECT_EQ(block.flush(), VK_SUCCESS);
                wind_set.point_at(*wind, block.handle());
                EXPECT_TRUE(field->record_cull(commands, camera));
                picture.record(commands, *field, eye.view_projection, View::colour, pixels.handle(),
                               &picture == &windy ? wind_set.set : VK_NULL_HANDLE);
                barrier(commands);
            });
            return read<std::uint32_t>(pixels, test::Picture::k_pixels);
        };
        const auto changed = [](const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
            std::size_t count = 0;
            for (std::size_t n = 0; n < a.size(); ++n)
                count += a[n] != b[n];
            return static_cast<double>(count);
        };
        const auto wanted = draw(still), even = draw(windy);
        double covered = 0.0;
        for (const std::uint32_t pixel : wanted)
            covered += pixel != 0;
        EXPECT_GT(covered, 10'000.0);
        // Sampled air is 1.5 m/s to rounding, so that an edge may pass a pixel's centre: in less than a thousandth.
        WINDROW_EXPECT_FIGURE("grass/wind/share_of_pixels_of_even_air_unlike_an_even_wind", changed(wanted, even) / covered,
                              1e-3);
        ASSERT_TRUE(wind->motors().add(
            windrow::JetMotor{.position = middle + glm::dvec3(-4.0, -1.0, -6.0), .direction = {0.0f, 0.0f, 1.0f}}));
        for (int n = 0; n < 20; ++n)
            run([&](VkCommandBuffer commands) { (void)wind->record(commands, {.dt = 1.0 / 30.0}); });
        const double moved = changed(even, draw(windy));
        windrow::test::figure("grass/wind/share_of_grass_pixels_changed_by_a_jet", moved / covered);
        EXPECT_GT(moved, 0.02 * covered);
    }
}

} // namespace
} // namespace windrow::vegetation::grass
