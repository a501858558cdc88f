// Layouts, render passes and pipelines that owners on one device have together: made once, there as long as one of them needs them.
#include "vegetation/render/bodies.h"
#include "vegetation/tests/render/grass_stage.h"

#include <string>
#include <vector>

namespace windrow::vegetation::render {
namespace {

Scene small_scene() {
    Scene scene;
    scene.wind.wind.cells = {8, 8, 8};
    return scene;
}

const RenderSettings k_small{.width = 64, .height = 48, .samples = 1, .shadow_texels = 64};

std::unique_ptr<Bodies> a_fan(engine::Device& device, const DrawTargets& targets) {
    return engine::must(Bodies::create(device, targets, std::array{fan_blades(0.8f)}));
}

TEST(SharedObjects, AreMadeOnceAndStayForTheLastWhoNeedsThem) {
    std::vector<std::string> messages;
    {
        test::GrassStage stage(small_scene(), k_small,
                               {.validation = true, .on_message = [&](const std::string& text) { messages.push_back(text); }});
        const engine::SharedObjects& there = stage.device->shared_objects();
        const std::size_t before = there.count();
        auto first = a_fan(*stage.device, stage.renderer->draw_targets());
        const std::size_t with_one = there.count();
        EXPECT_GT(with_one, before);
        auto second = a_fan(*stage.device, stage.renderer->draw_targets());
        EXPECT_EQ(there.count(), with_one);

        first.reset();
        EXPECT_EQ(there.count(), with_one);
        glm::mat4 placed(1.0f);
        placed[3] = {0.0f, 1.0f, -6.0f, 1.0f};
        second->place(0, placed);
        stage.renderer->add(*second);
        stage.draw(stage.scene.camera, 1.0 / 30.0);
        const Picture8 alone = stage.renderer->images().picture();
        // A second renderer's passes are those of the first, too.
        const auto other = engine::must(Renderer::create(*stage.device, stage.scene, k_small));
        EXPECT_EQ(there.count(), with_one);
        stage.draw(stage.scene.camera, 0.0);
        EXPECT_EQ(stage.renderer->images().picture().values, alone.values);
    }
    for (const std::string& message : messages)
        ADD_FAILURE() << "the validation layer reports: " << message;
}

TEST(SharedObjects, EndWithTheLastOwner) {
    const auto device = engine::must(engine::Device::create());
    {
        const auto renderer = engine::must(Renderer::create(*device, small_scene(), k_small));
        const auto fan = a_fan(*device, renderer->draw_targets());
        EXPECT_GT(device->shared_objects().count(), 0u);
    }
    EXPECT_EQ(device->shared_objects().count(), 0u);
}

// Another render pass may have the handle of one that its host has ended: a pipeline found by it would be of other formats.
TEST(SharedObjects, AreNotMadeOfWhatIsNotShared) {
    const auto device = engine::must(engine::Device::create());
    engine::Objects objects(*device);
    engine::SharedKey key(engine::SharedKind::pipeline);
    key.add_part(engine::SharedKind::render_pass, engine::HandleBits{42}); // a host's
    int made = 0;
    const auto make = [&](engine::Objects& owner) {
        ++made;
        return owner.sampler(engine::Sampler::texels);
    };
    for (int asked = 1; asked <= 2; ++asked) {
        (void)objects.shared(key, make);
        EXPECT_EQ(made, asked);
    }
    EXPECT_EQ(device->shared_objects().count(), 0u);
}

} // namespace
} // namespace windrow::vegetation::render
