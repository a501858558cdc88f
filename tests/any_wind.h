// Random winds, one a seed: a box of any kind, with bodies, ground, plants and motors in it that rest or move, and what a
// game does to them on the way. The scenario table has each feature alone; this has those that nobody thought of together.
#pragma once

#include "tests/frame.h"
#include "tests/scenario_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace windrow::test {

/// Numbers of a seed, the same on every platform.
class Chance {
  public:
    explicit Chance(std::uint32_t seed) : random_(seed) {}
    [[nodiscard]] double share() { return static_cast<double>(random_() % 100000) / 100000.0; }
    [[nodiscard]] double between(double low, double high) { return low + (high - low) * share(); }
    /// As often between 1 and 2 as between 2 and 4.
    [[nodiscard]] double spread(double low, double high) { return low * std::pow(high / low, share()); }
    [[nodiscard]] int whole(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<std::uint32_t>(high - low + 1));
    }
    [[nodiscard]] bool happens(double probability) { return share() < probability; }
    [[nodiscard]] float size(double low, double high) { return static_cast<float>(spread(low, high)); }
    [[nodiscard]] glm::dvec3 in_cube() {
        const double x = between(-1.0, 1.0), y = between(-1.0, 1.0);
        return {x, y, between(-1.0, 1.0)};
    }

  private:
    std::mt19937 random_;
};

class AnyWind {
  public:
    explicit AnyWind(std::uint32_t seed, const std::optional<Frame>& frame = {}) : chance_(seed), frame_(frame) {
        name_ = std::to_string(seed);
        choose_box();
        choose_bodies();
        choose_ground();
        choose_plants();
        choose_motors();
        choose_events();
        choose_method();
        choose_calls();
    }

    /// What a test plays. It copies all that it needs.
    [[nodiscard]] static Scenario scenario(std::uint32_t seed) { return played(std::make_shared<const AnyWind>(seed)); }
    /// The same without what no frame has a like of: gusts, grounds, and a box that walks. The box has an even number of cells, and its
    /// middle is that of the scene.
    [[nodiscard]] static Scenario scenario(std::uint32_t seed, const Frame& frame) {
        return played(std::make_shared<const AnyWind>(seed, frame));
    }
    /// Meshes and voxels are not made again as their mirror image.
    [[nodiscard]] bool has_mirror_image() const {
        return std::none_of(bodies_.begin(), bodies_.end(), [](const Body& body) {
            const Shape& shape = body.obstacle.shape;
            return std::holds_alternative<MeshShape>(shape) || std::holds_alternative<VoxelShape>(shape);
        });
    }

  private:
    [[nodiscard]] static Scenario played(const std::shared_ptr<const AnyWind>& any) {
        return {.name = any->name_,
                .config = [any](Config& c) { c = any->framed_config(); },
                .begin = [any](WindControl& wind) { any->begin(wind); },
                .step = [any](WindControl& wind, int n) { any->step(wind, n); }};
    }

    struct Body {
        Obstacle obstacle;
        glm::dvec3 speed{0.0}; ///< [m/s]
        double spin = 0.0;     ///< [1/s] about y
        [[nodiscard]] bool moves() const { return speed != glm::dvec3(0.0) || spin != 0.0; }
    };
    enum class Act {
        add_block,
        remove_body,
        add_omni,
        gusts,
        ambient,
        add_plant,
        reset,
        add_fan,
        remove_motor,
        remove_plant,
        blast
    };
    struct Event {
        int step = 0;
        Act act = Act::reset;
        glm::dvec3 by{0.0}; ///< numbers from -1 to 1, to whatever use
    };
    /// What few hosts do, in no frame.
    enum class Call { shift_origin, set_floor, set_boundaries, set_velocity };
    struct RareCall {
        int step = 0;
        Call call = Call::shift_origin;
        glm::dvec3 by{0.0}; ///< the same
    };

    void choose_box() {
        Config& c = config_;
        c.cells = {chance_.whole(5, 22), chance_.whole(4, 14), chance_.whole(5, 20)};
        c.ambient = {static_cast<float>(chance_.between(-9.0, 9.0)), 0.0f, static_cast<float>(chance_.between(-5.0, 5.0))};
        c.cell_size = chance_.happens(0.5) ? 1.0f : chance_.size(0.2, 3.0);
        h_ = static_cast<double>(c.cell_size);
        half_ = glm::dvec3(c.cells) * 0.5 * h_;
        floor_ = chance_.happens(0.5);
        if (floor_)
            c.boundaries = Boundaries::open_over_floor();
        else if (chance_.happens(0.4))
            choose_sides();
        const auto maybe = [&](double probability, const char* word) {
            const bool yes = chance_.happens(probability);
            if (yes)
                name_ += std::string(" ") + word;
            return yes;
        };
        // A wind that differs from place to place is torn where a box repeats: there the last bit of a trajectory decides.
        for (int axis = 0; axis < 3; ++axis)
            repeats_ = repeats_ || c.boundaries.periodic(axis);
        if (!repeats_ && maybe(0.3, "gusts"))
            c.gusts.intensity = static_cast<float>(chance_.between(0.05, 0.5));
        if (floor_ && maybe(0.4, "profile"))
            c.profile = LogProfile{};
        if (c.profile && maybe(0.5, "rough"))
            c.roughness = Roughness{};
        if (floor_ && maybe(0.3, "rows"))
            c.rows =
                Rows{.first = static_cast<float>(h_ * chance_.between(0.2, 0.9)), .uniform = chance_.whole(1, 4), .ratio = 1.2f};
        if (maybe(0.2, "viscous"))
            c.viscosity = chance_.size(0.001, 3.0);
        if (maybe(0.12, "classic"))
            c.scheme = Scheme::stable_fluids;
        if (maybe(0.3, "relaxes"))
            c.relaxation_time = chance_.size(0.1, 50.0);
        if (maybe(0.3, "calm"))
            c.ambient = glm::vec3(0.0f);
        if (floor_ && maybe(0.15, "canopy"))
            c.canopy = Canopy{};
        turns_ = maybe(0.15, "turning");
    }

    void choose_sides() {
        name_ += " sides";
        Boundaries& sides = config_.boundaries;
        Boundary* const ends[3][2] = {
            {&sides.x_low, &sides.x_high}, {&sides.y_low, &sides.y_high}, {&sides.z_low, &sides.z_high}};
        for (auto& axis : ends) {
            const bool periodic = chance_.happens(0.25);
            for (Boundary* const side : axis)
                side->kind = periodic ? BoundaryKind::periodic : static_cast<BoundaryKind>(chance_.whole(0, 2));
        }
    }

    /// [m] Anywhere in the box.
    [[nodiscard]] glm::dvec3 place(glm::dvec3 in_cube) const {
        return in_cube * half_ + glm::dvec3(0.0, floor_ ? half_.y : 0.0, 0.0);
    }

    void choose_bodies() {
        const auto shapes = scenario_parts::scenario_shapes();
        for (int left = chance_.happens(0.2) ? 0 : chance_.whole(1, 4); left > 0; --left) {
            const auto& kind = shapes[static_cast<std::size_t>(chance_.whole(0, static_cast<int>(shapes.size()) - 1))];
            const float size = static_cast<float>(h_) * chance_.size(0.15, 1.2);
            Body body{.obstacle = {.position = place(chance_.in_cube()), .shape = resized(kind.shape, size)}};
            if (chance_.happens(0.5)) {
                const bool upright = chance_.happens(0.4);
                const glm::vec3 axis = upright ? glm::vec3(0.0f) : glm::vec3(chance_.in_cube());
                body.obstacle.orientation = glm::angleAxis(static_cast<float>(chance_.between(0.0, 3.0)),
                                                           glm::normalize(glm::vec3(axis.x, 1.0f, axis.z)));
            }
            if (chance_.happens(0.15))
                body.obstacle.surface = Surface::no_slip;
            if (chance_.happens(0.5))
                body.speed = 4.0 * chance_.in_cube() * glm::dvec3(1.0, chance_.happens(0.5) ? 0.0 : 0.5, 1.0);
            if (chance_.happens(0.5))
                body.spin = chance_.between(-3.0, 3.0);
            name_ += std::string(" ") + kind.name + (body.moves() ? "*" : "");
            bodies_.push_back(body);
        }
    }

    void choose_ground() {
        if (!floor_ || !chance_.happens(0.25))
            return;
        const int tiles = chance_.whole(0, 2);
        name_ += " ground" + std::to_string(tiles);
        if (tiles == 0)
            ground_.push_back(scenario_parts::hills({-40.0, -0.8, -40.0}));
        for (int n = 0; n < tiles; ++n) {
            ground_.push_back(scenario_parts::tile_of_hills({-12 + 10 * n, -9}, {-2 + 10 * n, 9}));
            ground_.back().position.y = -0.7;
        }
    }

    void choose_plants() {
        for (int left = chance_.happens(0.3) ? chance_.whole(1, 6) : 0; left > 0; --left) {
            glm::dvec3 at = place(chance_.in_cube());
            if (floor_)
                at.y = 0.0;
            const auto h = static_cast<float>(h_);
            if (chance_.happens(0.6)) {
                plants_.emplace_back(PlantDrag{.position = at,
                                               .radius = h * chance_.size(0.2, 4.0),
                                               .height = h * chance_.size(0.5, 5.0),
                                               .area = h * h * chance_.size(0.2, 10.0)});
            } else {
                const glm::dvec3 along = h_ * (glm::dvec3(4.0, 0.0, 0.0) + chance_.in_cube() * glm::dvec3(3.0, 0.5, 8.0));
                plants_.emplace_back(BeltDrag{.start = at,
                                              .end = at + along,
                                              .width = h * chance_.size(0.2, 3.0),
                                              .height = h * chance_.size(0.5, 5.0),
                                              .resistance = chance_.size(0.2, 8.0)});
            }
            name_ += " plants";
        }
    }

    void choose_motors() {
        for (int left = chance_.happens(0.5) ? chance_.whole(1, 3) : 0; left > 0; --left) {
            const glm::dvec3 at = place(chance_.in_cube());
            const float size = static_cast<float>(h_) * chance_.size(0.4, 4.0);
            const int kind = chance_.whole(0, 4);
            const glm::vec3 along{1.0f, 0.2f, 0.3f};
            if (kind == 0)
                motors_.emplace_back(DirectionalMotor{.position = at, .direction = along, .region = Sphere{size}});
            else if (kind == 1)
                motors_.emplace_back(OmniMotor{.position = at});
            else if (kind == 2)
                motors_.emplace_back(VortexMotor{.position = at, .radius = size, .half_length = size});
            else if (kind == 3)
                motors_.emplace_back(JetMotor{.position = at, .direction = -along});
            else
                motors_.emplace_back(WakeMotor{.position = at, .radius = size});
            name_ += " motor" + std::to_string(kind);
        }
    }

    void choose_events() {
        bool open = true; // where the box may walk
        for (const int axis : {0, 2})
            for (int end = 0; end < 2; ++end)
                open = open && config_.boundaries.at(axis, end).kind == BoundaryKind::open;
        open = open && (floor_ || (config_.boundaries.y_low.kind == BoundaryKind::open &&
                                   config_.boundaries.y_high.kind == BoundaryKind::open));
        if (open && chance_.happens(0.4) && (ground_.empty() || !config_.rows)) {
            walk_ = 6.0 * chance_.in_cube() * glm::dvec3(1.0, floor_ ? 0.0 : 0.1, 1.0);
            name_ += " walk";
        }
        for (int left = chance_.whole(1, 5); left > 0; --left) {
            const int step = chance_.whole(1, 22), act = chance_.whole(0, static_cast<int>(Act::blast));
            events_.push_back({step, static_cast<Act>(act), chance_.in_cube()});
            name_ += " act" + std::to_string(act) + "@" + std::to_string(step);
        }
    }

    // The winds of a seed were chosen before this: it adds to them.
    void choose_method() {
        const auto maybe = [&](double probability, const char* word) {
            const bool yes = chance_.happens(probability);
            if (yes)
                name_ += std::string(" ") + word;
            return yes;
        };
        Config& c = config_;
        if (maybe(0.2, "linear"))
            c.interpolation = Interpolation::linear;
        else if (maybe(0.4, "cubic_32"))
            c.interpolation = Interpolation::cubic_32;
        if (maybe(0.25, "solves"))
            c.pressure_solves = chance_.whole(1, 4);
        if (maybe(0.2, "cfl"))
            c.max_cfl = chance_.size(0.3, 4.0);
        if (maybe(0.2, "substeps"))
            c.max_substeps = chance_.whole(1, 8);
        if (maybe(0.2, "blend"))
            c.blend_width = static_cast<float>(chance_.between(0.0, 5.0));
        if (maybe(0.3, "ticks"))
            c.ticks.hz = chance_.spread(12.0, 150.0);
        if (maybe(0.1, "jumps"))
            c.jump_speed = chance_.size(2.0, 30.0);
        for (Motor& motor : motors_)
            if (maybe(0.3, "eddies"))
                std::visit(
                    [&](auto& kind) {
                        if constexpr (requires { kind.turbulence; })
                            kind.turbulence.intensity = static_cast<float>(chance_.between(0.05, 0.5));
                    },
                    motor);
    }

    void choose_calls() {
        for (int left = chance_.happens(0.5) ? chance_.whole(1, 3) : 0; left > 0; --left) {
            const auto call = static_cast<Call>(chance_.whole(0, 3));
            calls_.push_back({.step = chance_.whole(1, 15), .call = call, .by = chance_.in_cube()});
            name_ += " call" + std::to_string(static_cast<int>(call)) + "@" + std::to_string(calls_.back().step);
        }
    }

    [[nodiscard]] Config framed_config() const {
        Config c = config_;
        if (!frame_)
            return c;
        c.cells = frame_->cells((c.cells + glm::ivec3(1, 0, 1)) / glm::ivec3(2, 1, 2) * glm::ivec3(2, 1, 2));
        c.ambient = frame_->way(c.ambient);
        c.boundaries = frame_->boundaries(c.boundaries);
        c.gusts.intensity = 0.0f;
        return c;
    }

    // --- Calls, each in the frame ---------------------------------------------------------------------------------------------------

    void add(WindControl& wind, const Obstacle& body) const {
        scenario_parts::must(wind.obstacles().add(frame_ ? frame_->obstacle(body) : body));
    }
    void add(WindControl& wind, const DragDeposit& plant) const {
        scenario_parts::must(wind.drag().add(frame_ ? frame_->deposit(plant) : plant));
    }
    void add_motor(WindControl& wind, const Motor& motor) const {
        scenario_parts::must(wind.motors().add(frame_ ? frame_->motor(motor) : motor));
    }
    void set_ambient(WindControl& wind, glm::vec3 to) const {
        scenario_parts::must(wind.set_ambient(frame_ ? frame_->way(to) : to));
    }

    void begin(WindControl& wind) const {
        for (const Body& body : bodies_)
            add(wind, body.obstacle);
        for (const Obstacle& ground : ground_)
            if (!frame_)
                add(wind, ground);
        for (const DragDeposit& plant : plants_)
            add(wind, plant);
        for (const Motor& motor : motors_)
            add_motor(wind, motor);
    }

    void step(WindControl& wind, int n) const {
        using scenario_parts::must;
        if (!frame_)
            for (const RareCall& each : calls_)
                if (each.step == n)
                    call(wind, each);
        const glm::dvec3 origin = origin_at(n);
        const double time = (n + 1) * k_scenario_step;
        for (std::uint32_t slot = 0; slot < bodies_.size(); ++slot) {
            const Body& body = bodies_[slot];
            const glm::quat turn = glm::angleAxis(static_cast<float>(body.spin * time), glm::vec3(0.0f, 1.0f, 0.0f));
            const glm::dvec3 at = origin + body.obstacle.position + body.speed * time;
            const glm::quat orientation = turn * body.obstacle.orientation;
            if (body.moves())
                must(wind.obstacles().move(obstacle_id(slot), frame_ ? frame_->place(at) : at,
                                           frame_ ? frame_->orientation(orientation) : orientation));
        }
        for (std::uint32_t slot = 0; slot < motors_.size(); ++slot)
            if (std::holds_alternative<WakeMotor>(motors_[slot]) && !(slot == 0 && removes_motor(n))) {
                const glm::dvec3 at = origin + position_of(motors_[slot]) + walk_ * time;
                must(wind.motors().move(motor_id(slot), frame_ ? frame_->place(at) : at));
            }
        if (walk_ != glm::dvec3(0.0) && !frame_)
            must(wind.follow(origin + walk_ * time));
        for (const Event& event : events_)
            if (event.step == n)
                act(wind, event);
        if (turns_ && n % 5 == 4)
            set_ambient(wind, {config_.ambient.x + 0.3f * static_cast<float>(n), 0.0f, config_.ambient.z});
    }

    // [m] How far the host's origin has moved by step n.
    [[nodiscard]] glm::dvec3 origin_at(int n) const {
        glm::dvec3 origin(0.0);
        for (const RareCall& each : calls_)
            if (!frame_ && each.call == Call::shift_origin && each.step <= n)
                origin += way_of(each);
        return origin;
    }
    [[nodiscard]] glm::dvec3 way_of(const RareCall& shift) const {
        return glm::round(100.0 * shift.by) * glm::dvec3(h_, 0.0, h_);
    }

    void call(WindControl& wind, const RareCall& each) const {
        using scenario_parts::must;
        switch (each.call) {
        case Call::shift_origin:
            must(wind.shift_origin(way_of(each)));
            return;
        case Call::set_floor:
            if (floor_)
                must(wind.set_floor(3.0 * h_ * each.by.x));
            return;
        case Call::set_boundaries: {
            Boundaries sides = wind.config().boundaries;
            Boundary* const ends[] = {&sides.x_low, &sides.x_high, &sides.z_low, &sides.z_high};
            Boundary& end = *ends[each.by.x < 0.0 ? (each.by.y < 0.0 ? 0 : 1) : (each.by.y < 0.0 ? 2 : 3)];
            if (end.kind == BoundaryKind::free_slip || end.kind == BoundaryKind::no_slip)
                end.kind = each.by.z < 0.0 ? BoundaryKind::open : BoundaryKind::free_slip;
            else if (end.kind == BoundaryKind::open && walk_ == glm::dvec3(0.0))
                end.kind = BoundaryKind::free_slip;
            (void)wind.set_boundaries(sides); // a box that follows keeps its open sides
            return;
        }
        case Call::set_velocity:
            must(wind.set_velocity([&](glm::dvec3 centre) {
                const glm::dvec3 at = (centre - origin_at(each.step)) / h_;
                return glm::vec3(4.0 * each.by) * static_cast<float>(std::sin(at.x * 0.7) * std::cos(at.z * 0.5 + at.y));
            }));
            return;
        }
    }

    [[nodiscard]] bool removes_motor(int n) const {
        return std::any_of(events_.begin(), events_.end(),
                           [n](const Event& event) { return event.act == Act::remove_motor && event.step <= n; });
    }

    void act(WindControl& wind, const Event& event) const {
        using scenario_parts::must;
        const glm::dvec3 at = origin_at(event.step) + place(event.by);
        const glm::vec3 by(event.by);
        const auto h = static_cast<float>(h_);
        switch (event.act) {
        case Act::add_block:
            add(wind, Obstacle{.position = at,
                               .orientation = glm::angleAxis(by.x, glm::vec3(0.0f, 1.0f, 0.0f)),
                               .shape = Block{h * glm::vec3(0.3f + 3.0f * by.y * by.y, 1.0f, 0.2f + 2.0f * by.z * by.z)}});
            return;
        case Act::remove_body:
            if (!bodies_.empty() && !bodies_[0].moves())
                (void)wind.obstacles().remove(obstacle_id(0)); // gone already, perhaps
            return;
        case Act::add_omni:
            add_motor(wind, OmniMotor{.position = at, .speed = 6.0f * by.x});
            return;
        case Act::gusts:
            if (!repeats_ && !frame_)
                must(wind.set_gusts(Gusts{.intensity = 0.4f * by.x * by.x}));
            return;
        case Act::ambient:
            set_ambient(wind, by.z < 0.0f ? glm::vec3(0.0f) : glm::vec3(7.0f * by.x, 0.0f, 7.0f * by.y));
            return;
        case Act::add_plant:
            add(wind, DragDeposit(PlantDrag{.position = at - glm::dvec3(0.0, half_.y, 0.0),
                                            .radius = h * (1.0f + 2.0f * by.x * by.x),
                                            .height = 3.0f * h,
                                            .area = 4.0f * h * h}));
            return;
        case Act::reset:
            wind.reset();
            return;
        case Act::add_fan:
            add_motor(wind, DirectionalMotor{.position = at, .direction = by, .region = Sphere{3.0f * h}});
            return;
        case Act::remove_motor:
            if (!motors_.empty())
                (void)wind.motors().remove(motor_id(0));
            return;
        case Act::remove_plant:
            if (!plants_.empty())
                (void)wind.drag().remove({.slot = 0, .generation = 1});
            return;
        case Act::blast:
            add_motor(wind, PressureMotor{.position = at, .speed = 15.0f * by.x});
            return;
        }
    }

    Chance chance_;
    std::optional<Frame> frame_;
    std::string name_;
    Config config_;
    double h_ = 1.0;       ///< [m] size of a cell
    glm::dvec3 half_{0.0}; ///< [m] size of the box
    bool floor_ = false, turns_ = false, repeats_ = false;
    std::vector<Body> bodies_;
    std::vector<Obstacle> ground_;
    std::vector<DragDeposit> plants_;
    std::vector<Motor> motors_;
    glm::dvec3 walk_{0.0}; ///< [m/s]
    std::vector<Event> events_;
    std::vector<RareCall> calls_;
};

} // namespace windrow::test
