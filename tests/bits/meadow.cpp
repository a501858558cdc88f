// Every motor in a meadow. A frame is 1/144 to 1/20 s long; the wind is saved and loaded on the way, between two ticks.
#include "fluid/event_log.h"
#include "fluid/wind.h"
#include "tests/bits/stories.h"

namespace windrow::bits {
namespace {

constexpr int k_meadow_frames = 150;
constexpr double k_frame_times[] = {1.0 / 60.0, 1.0 / 144.0, 1.0 / 30.0, 1.0 / 50.0, 1.0 / 20.0};

void add_motors(Motors& motors) {
    (void)must(motors.add(DirectionalMotor{.position = {-9.0, 1.5, 2.0}, .direction = {2.0f, 0.3f, -1.0f}}));
    (void)must(motors.add(DirectionalMotor{.position = {4.0, 3.0, -6.0},
                                           .direction = {0.0f, -1.0f, 0.2f},
                                           .region = Capsule{.half_axis = {1.0f, 0.5f, 2.0f}, .radius = 1.7f},
                                           .law = Force{14.0f},
                                           .envelope = {.attack = 0.4f, .hold = 1.1f, .decay = 0.7f, .delay = 0.3f}}));
    (void)must(motors.add(DirectionalMotor{.position = {0.0, 2.0, 7.0},
                                           .direction = {0.0f, 0.0f, 1.0f},
                                           .region = AlignedBox{.half_size = {3.0f, 1.0f, 2.0f}},
                                           .law = Drive{.speed = 5.0f, .rate = 3.0f},
                                           .turbulence = {.intensity = 0.3f, .length = 2.5f, .seed = 7}}));
    (void)must(motors.add(DirectionalMotor{
        .position = {-3.0, 1.0, -8.0}, .region = Cone{.axis = {4.0f, 1.0f, 1.0f}, .start_radius = 0.4f, .end_radius = 1.6f}}));
    (void)must(motors.add(JetMotor{.position = {6.0, 1.0, 3.0}, .direction = {-1.0f, 0.4f, 0.2f}}));
    (void)must(motors.add(JetMotor{.position = {2.0, 4.0, 1.0},
                                   .direction = {0.1f, 0.2f, -1.0f},
                                   .length = 5.0f,
                                   .start_radius = 1.1f,
                                   .end_radius = 1.1f,
                                   .law = Force{30.0f},
                                   .turbulence = {.intensity = 0.0f}}));
    (void)must(motors.add(VortexMotor{.position = {-5.0, 3.0, -1.0}, .radius = 3.5f, .half_length = 3.0f, .lift = 0.5f}));
    (void)must(motors.add(VortexMotor{.position = {9.0, 2.0, -9.0}, .axis = {1.0f, 2.0f, 0.5f}, .law = Force{-9.0f}}));
    (void)must(motors.add(OmniMotor{.position = {1.0, 2.0, -3.0}, .speed = 3.0f, .envelope = {.hold = 1.5f, .decay = 0.5f}}));
    (void)must(motors.add(OmniMotor{.position = {-24.0, 2.0, 0.0}, .radius = 3.0f, .speed = -6.0f})); // outside of the box
}

void hash_points(Hashes& hashes, const std::string& frame, const Wind& wind) {
    constexpr Sampling k_sampling{.strength = 1.2f, .limit = 20.0f, .detail = 0.4f, .detail_length = 0.7f};
    Numbers numbers(9);
    std::vector<glm::dvec3> places;
    for (int n = 0; n < 200; ++n) { // one after the other: the order of arguments is the compiler's
        const float x = numbers.between(-20.0f, 20.0f), y = numbers.between(0.0f, 18.0f), z = numbers.between(-18.0f, 18.0f);
        places.emplace_back(x, y, z);
    }
    std::vector<glm::vec3> found(places.size());
    wind.velocity(places, found);
    hashes.add("points/" + frame, found);
    for (std::size_t n = 0; n < places.size(); ++n)
        found[n] = wind.felt(places[n], k_sampling);
    hashes.add("felt/" + frame, found);
    std::vector<std::uint16_t> halves(4 * wind.box().cell_count());
    must(wind.write_vectors(halves));
    hashes.add("half_texels/" + frame, halves);
}

} // namespace

std::vector<Hash> meadow(Simd level, ParallelFor parallel_for) {
    Hashes hashes("meadow");
    Wind wind = must(Wind::create({.cells = {33, 17, 29},
                                   .boundaries = Boundaries::open_over_floor(),
                                   .ambient = {4.0f, 0.0f, 1.5f},
                                   .profile = LogProfile{},
                                   .gusts = {.intensity = 0.25f, .length = 14.0f, .seed = 3},
                                   .canopy = Canopy{.height = 1.3f},
                                   .roughness = Roughness{.length = 0.05f, .longest_mixing = 2.0f},
                                   .simd = level,
                                   .parallel_for = parallel_for}));
    EventLog log;
    wind.record_to(&log);
    add_motors(wind.motors());
    const MotorId runner = must(wind.motors().add(WakeMotor{.position = {0.0, 0.9, 0.0}}));
    const MotorId cart = must(wind.motors().add(WakeMotor{
        .position = {0.0, 1.0, 4.0}, .radius = 1.2f, .law = WakeForce{.strength = 0.8f}, .turbulence = {.intensity = 0.2f}}));
    for (int frame = 0; frame < k_meadow_frames; ++frame) {
        const glm::dvec3 player(0.11 * frame, 0.9, 3.0 * swing(frame, 40));
        must(wind.motors().move(runner, player));
        must(wind.motors().move(cart, {4.0 * swing(frame, 70), 1.0, 4.0 + 2.0 * swing(frame, 34)}));
        must(wind.follow(player));
        if (frame == 30)
            (void)must(wind.motors().add(PressureMotor{.position = player + glm::dvec3(3.0, 1.0, 2.0)}));
        if (frame >= 50 && frame < 70)
            must(wind.set_ambient({4.0f - 0.3f * static_cast<float>(frame - 50), 0.0f, 1.5f}));
        if (frame == 80)
            must(wind.set_gusts({.intensity = 0.1f, .length = 20.0f, .seed = 5}));
        wind.advance(k_frame_times[frame % 5]);
        if (frame == 74) {
            const std::vector<std::byte> saved = must(wind.save());
            hashes.add("snapshot/74", saved);
            wind = must(Wind::load(saved, parallel_for));
            wind.record_to(&log);
        }
        if (frame % 50 == 49) {
            const std::string name = std::to_string(frame);
            hashes.add("cells/" + name, std::as_bytes(wind.field()));
            hash_points(hashes, name, wind);
        }
    }
    hashes.add("snapshot/end", must(wind.save()));
    hashes.add("log", must(log.to_bytes()));
    return hashes.list();
}

} // namespace windrow::bits
