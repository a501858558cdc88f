// Tutorial: a player runs through a gusty meadow, and the box of wind runs along. Everything that a game does with the wind in a
// frame.
//
//     follow_player       prints what three leaves feel, eight times a second
//
// 1. Make a wind over ground: a mean wind of 3 m/s at 10 m height that a log profile slows near the ground, with gusts that it
//    carries.
// 2. Give the player a wake. Move it each frame; several positions in a frame make a curve. The wake acts while he moves.
// 3. Call `follow` with the player's place. The box moves in whole cells and keeps the air; sampled wind fades to ambient around
//    the player, not around the box, so that nothing jumps when the box does.
// 4. advance() with the frame's time. The air has fixed ticks (30 a second here), the renderer its own pace: here 144 frames
//    a second, with a hitch now and then. The air is the same to the bit at any frame rate; what is sampled is blended between
//    ticks.
// 5. Fire and forget: a burst is added and removes itself. So does a motor whose envelope ends.
// 6. Ask for the wind. velocity() is the air; felt() adds the small-scale detail that cells of 1 m leave out, and limits it.
//    previous_view() is the wind of the last frame: motion vectors of anything that the wind bends need it.
//
// What to see: the leaf far away feels gusts alone. The leaf by the path is pulled along as the player passes at 1.3 s. The leaf
// by the burst leans out at 2.25 s, as it goes off, and is drawn back a quarter of a second later.

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <windrow/fluid/wind.h>

namespace {

// An S-shaped run at 6 m/s.
glm::dvec3 player_at(double time) {
    return {6.0 * time - 8.0, 0.9, 3.0 * std::sin(0.8 * time)};
}

} // namespace

int main() {
    windrow::Config config;
    config.boundaries = windrow::Boundaries::open_over_floor();
    config.centre = player_at(0.0);
    config.ambient = {3.0f, 0.0f, 0.5f};
    config.profile = windrow::LogProfile{.roughness_length = 0.05f};
    config.gusts = {.intensity = 0.25f};
    config.ticks = {.hz = 30.0};
    auto wind = windrow::Wind::create(config);
    if (!wind) {
        std::fprintf(stderr, "%s\n", wind.error().c_str()); // says which field is wrong, and the fix
        return 2;
    }
    if (auto placed = wind->set_floor(0.0); !placed)
        return 2;
    const auto player = wind->motors().add(
        windrow::WakeMotor{.position = player_at(0.0), .radius = 0.5f, .law = windrow::WakeDrive{.per_metre = 40.0f}});
    if (!player)
        return 2;

    struct Leaf {
        const char* name;
        glm::dvec3 place;
    };
    const Leaf leaves[] = {{"by the path", {0.0, 0.8, 2.6}}, {"by the burst", {4.0, 0.8, -3.0}}, {"far away", {80.0, 0.8, 0.0}}};
    const windrow::Sampling leaf_sampling{.limit = 40.0f, .detail = 0.2f};
    std::printf("  time   ticks  %-22s%-22s%-22s\n", leaves[0].name, leaves[1].name, leaves[2].name);

    double time = 0.0, next_line = 0.125;
    bool burst = false;
    for (int frame = 0; time < 3.5; ++frame) {
        const double frame_seconds = frame % 100 == 99 ? 0.05 : 1.0 / 144.0; // a hitch now and then
        // Two positions a frame: the wake follows the curve between them.
        (void)wind->motors().move(*player, player_at(time + 0.5 * frame_seconds));
        time += frame_seconds;
        (void)wind->motors().move(*player, player_at(time));
        (void)wind->follow(player_at(time));
        if (!burst && time >= 2.2)
            burst = wind->motors()
                        .add(windrow::PressureMotor{.position = {7.0, 1.0, -3.0}, .speed = 15.0f, .duration = 0.25f})
                        .has_value();

        const windrow::Advance done = wind->advance(frame_seconds);
        if (time < next_line)
            continue;
        next_line += 0.125;
        std::printf("%5.2f s   %d/%.2f", time, done.ticks, static_cast<double>(done.factor));
        for (const Leaf& leaf : leaves) {
            const glm::vec3 felt = wind->felt(leaf.place, leaf_sampling);
            std::printf("   (%5.2f,%5.2f,%5.2f)", static_cast<double>(felt.x), static_cast<double>(felt.y),
                        static_cast<double>(felt.z));
        }
        std::printf(" m/s\n");
    }
    const glm::vec3 change = wind->velocity(leaves[0].place) - wind->previous_view().velocity(leaves[0].place);
    std::printf("The leaf by the path saw its wind change by %.4f m/s in the last frame; motors left: %d.\n",
                static_cast<double>(glm::length(change)), wind->motors().count());
    return 0;
}
