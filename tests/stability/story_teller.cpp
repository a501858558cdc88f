#include "fluid/thread_pool.h"
#include "tests/fields.h"
#include "tests/stability/input.h"
#include "tests/stability/report_check.h"
#include "tests/stability/story.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>
#include <utility>

namespace windrow::test {
namespace {

ThreadPool& three_threads() {
    static ThreadPool pool(3);
    return pool;
}

Field start_field(const Wind& wind, const story::StartAir& start) {
    const glm::ivec3 cells = wind.box().cells;
    switch (start.kind) {
    case story::StartAir::Pattern::ambient:
        break;
    case story::StartAir::Pattern::white:
        return white_noise(cells, start.speed, start.seed);
    case story::StartAir::Pattern::smooth:
        return smooth_noise(cells, start.speed, start.seed);
    case story::StartAir::Pattern::shear:
        return shear_layer(cells, start.speed, start.seed);
    }
    return copy(wind.field());
}

class Teller {
  public:
    Teller(const Story& story, const Claims& claims) : story_(story), claims_(claims) {}

    StoryOutcome tell() {
        if (begin())
            for (number_ = 0; number_ < story_.events.size() && told_.fault.empty(); ++number_)
                std::visit([&](const auto& event) { happen(event); }, story_.events[number_]);
        return std::move(told_);
    }

  private:
    /// What the story knows of a motor.
    struct Known {
        MotorId id;
        MotorInput input;
        glm::dvec3 position;
        double swept = 0.0;                                        ///< [m] path given that no step may have seen yet
        double shortest = std::numeric_limits<double>::infinity(); ///< [s] least time of a piece of it
        double given = 0.0;                                        ///< [m] path given since the last step or frame
        int moves = 0;                                             ///< pieces of it
    };

    bool begin() {
        Config config = story_.config;
        auto alone = Wind::create(config);
        config.parallel_for = three_threads().parallel_for();
        auto threaded = Wind::create(config);
        if (!alone || !threaded)
            return fail("the config is rejected: " + alone.error());
        winds_.push_back(*std::move(alone));
        winds_.push_back(*std::move(threaded));
        meet_outside();
        input_.meets(story_.config.boundaries);
        if (story_.start.kind == story::StartAir::Pattern::ambient)
            return true;
        Field field = start_field(winds_[0], story_.start);
        if (story_.start.projected)
            field = projected(std::move(field), winds_[0].box());
        input_.meets(largest_speed(field));
        start_energy_ = energy_of(field);
        start_speed_ = largest_speed(field);
        for (Wind& wind : winds_)
            expect(wind.set_velocity(field), "set_velocity");
        return told_.fault.empty();
    }

    // --- Events ---------------------------------------------------------------------------------------------------------
    void happen(const story::Steps& event) {
        for (int n = 0; n < event.count && told_.fault.empty(); ++n) {
            const std::int64_t broken = nonfinite_cells(winds_[0].field());
            const bool was_asleep = asleep_;
            // A frame that was begun is ended by a step: what was told in it happens in this step, the way of the box too.
            const bool moved = std::exchange(ticking_, false);
            sweep(event.dt, moved ? event.dt / (event.dt + 1.0 / story_.config.ticks.hz) : 1.0);
            forget_sweeps();
            act(event.dt);
            const Diagnostics report = winds_[0].step(event.dt);
            winds_[1].step(event.dt);
            asleep_ = report.asleep;
            check(&report, {event.dt, broken, was_asleep, moved});
        }
    }
    // Ticks: several a frame or none; each sees the way that the motors have gone by then.
    void happen(const story::Advances& event) {
        const double tick = 1.0 / story_.config.ticks.hz;
        ticking_ = true;
        for (int n = 0; n < event.count && told_.fault.empty(); ++n) {
            const std::int64_t broken = nonfinite_cells(winds_[0].field());
            sweep(event.dt, 1.0);
            act(event.dt + tick);
            const Advance done = winds_[0].advance(event.dt);
            winds_[1].advance(event.dt);
            if (done.ticks == 0) {
                if (broken == 0)
                    check(nullptr, {});
                continue;
            }
            // Of several ticks the last one's report is told: cells are repaired in the first.
            const bool was_asleep = asleep_ && done.ticks == 1;
            asleep_ = done.last.asleep;
            check(done.ticks == 1 || !asleep_ ? &done.last : nullptr, {tick, done.ticks == 1 ? broken : 0, was_asleep, true});
        }
    }
    void happen(const story::Add& event) {
        std::vector<MotorId> ids;
        for (Wind& wind : winds_)
            if (const auto id = wind.motors().add(event.motor))
                ids.push_back(*id);
            else
                return void(fail("add: " + id.error()));
        if (ids[0] != ids[1])
            return void(fail("the motors of both winds have different names"));
        const MotorId of_both{.slot = ids[0].slot, .generation = ids[0].generation};
        motors_.push_back({of_both, input_of(event.motor, h()), position_of(event.motor)});
    }
    void happen(const story::Replace& event) {
        if (Known* known = living(event.which)) {
            for (Wind& wind : winds_)
                expect(wind.motors().set(known->id, event.motor), "set");
            *known = {known->id, input_of(event.motor, h()), position_of(event.motor)};
        }
    }
    void happen(const story::Move& event) {
        if (Known* known = living(event.which)) {
            for (Wind& wind : winds_)
                expect(wind.motors().move(known->id, event.position), "move");
            const double way = glm::length(event.position - known->position);
            known->given += way;
            known->swept += way;
            known->position = event.position;
            ++known->moves;
        }
    }
    void happen(const story::Remove& event) {
        if (Known* known = living(event.which)) {
            for (Wind& wind : winds_)
                expect(wind.motors().remove(known->id), "remove");
            motors_.erase(motors_.begin() + (known - motors_.data()));
        }
    }
    void happen(const story::Follow& event) {
        for (Wind& wind : winds_)
            expect(wind.follow(event.point), "follow");
        meet_outside();
    }
    void happen(const story::Floor& event) {
        if (!winds_[0].box().boundaries.y_low.solid())
            return;
        for (Wind& wind : winds_)
            expect(wind.set_floor(event.height), "set_floor");
        meet_outside();
    }
    void happen(const story::ChangeSides& event) {
        for (Wind& wind : winds_)
            expect(wind.set_boundaries(event.boundaries), "set_boundaries");
        input_.meets(event.boundaries);
        meet_outside();
        // Walls take gusts away along their axis, open boundaries give them back, while the air stays as it is.
        input_.adds(gust());
    }
    // The air of the box changes with it.
    void happen(const story::ChangeAmbient& event) {
        const glm::vec3 before = winds_[0].ambient();
        for (Wind& wind : winds_)
            expect(wind.set_ambient(event.ambient), "set_ambient");
        meet_outside();
        input_.adds(profile() * glm::length(glm::dvec3(event.ambient) - glm::dvec3(before)));
    }
    void happen(const story::ChangeGusts& event) {
        const double before = gust();
        for (Wind& wind : winds_)
            expect(wind.set_gusts(event.gusts), "set_gusts");
        meet_outside();
        input_.adds(before + gust());
    }
    void happen(const story::Break& event) {
        Field field = copy(winds_[0].field());
        field[static_cast<std::size_t>(event.cell) % field.size()][event.cell % 3] = event.value;
        for (Wind& wind : winds_)
            expect(wind.set_velocity(field), "set_velocity");
    }
    void happen(const story::SaveAndLoad&) {
        const std::vector<std::byte> bytes = *winds_[0].save();
        if (bytes != *winds_[1].save())
            return void(fail("equal winds give different snapshots"));
        auto loaded = Wind::load(bytes);
        if (!loaded)
            return void(fail("load: " + loaded.error()));
        winds_[0] = *std::move(loaded);
        if (*winds_[0].save() != bytes)
            fail("a loaded wind gives another snapshot");
    }
    void happen(const story::Reset&) {
        for (Wind& wind : winds_)
            wind.reset();
    }

    // --- What is put in ---------------------------------------------------------------------------------------------------
    [[nodiscard]] double h() const { return static_cast<double>(story_.config.cell_size); }

    /// The largest factor of a profile in the box.
    [[nodiscard]] double profile() const {
        const auto& profile = story_.config.profile;
        if (!profile)
            return 1.0;
        const double z0 = profile->roughness_length, reference = profile->reference_height;
        const double ground = winds_[0].box().boundaries.y_low.solid() ? winds_[0].origin().y : 0.0;
        const double top = winds_[0].origin().y + (winds_[0].box().cells.y + 2) * h() - ground;
        return std::max(1.0, std::log((std::max(top, 0.0) + z0) / z0) / std::log((reference + z0) / z0));
    }
    /// The strongest gust there may be.
    [[nodiscard]] double gust() const {
        const Gusts& gusts = winds_[0].config().gusts;
        if (gusts.intensity == 0.0f)
            return 0.0;
        static const float bound = GustTile::bake(1)->bound();
        const glm::vec3 mean = winds_[0].ambient();
        return static_cast<double>(gusts.intensity * bound) *
               std::hypot(static_cast<double>(mean.x), static_cast<double>(mean.z));
    }
    void meet_outside() {
        const double mean = profile() * glm::length(glm::dvec3(winds_[0].ambient()));
        input_.meets(mean);
        if (winds_[0].config().gusts.intensity > 0.0f)
            input_.gives(mean + gust()); // then the mean wind is given too
    }
    /// Motors act for a time. [s]
    void act(double duration) {
        double flow = 0.0;
        for (const Known& known : motors_) {
            input_.acts(known.input, duration);
            flow += known.input.flow;
        }
        input_.gives(flow);
    }
    /// What was given is swept in a frame or step, all that a tick has not seen yet in `squeezed` of its time (Wind::step).
    void sweep(double duration, double squeezed) {
        for (Known& known : motors_) {
            if (known.moves > 0) {
                known.shortest = std::min(known.shortest, duration / known.moves);
                input_.pushes_along(known.input, known.given);
            }
            if (known.swept > 0.0)
                input_.drags_along(known.input, known.swept, squeezed * known.shortest);
            known.given = 0.0;
            known.moves = 0;
        }
    }
    void forget_sweeps() {
        for (Known& known : motors_) {
            known.swept = 0.0;
            known.shortest = std::numeric_limits<double>::infinity();
        }
    }
    Known* living(int which) {
        std::erase_if(motors_, [&](const Known& known) { return winds_[0].motors().find(known.id) == nullptr; });
        return motors_.empty() ? nullptr : &motors_[static_cast<std::size_t>(which) % motors_.size()];
    }

    // --- What must hold -------------------------------------------------------------------------------------------------
    void check(const Diagnostics* report, const StepTaken& step) {
        ++told_.steps;
        const Wind& wind = winds_[0];
        const std::span<const glm::vec4> field = wind.field();
        meet_outside(); // the box may have moved
        if (nonfinite_cells(field) > 0)
            return void(fail("a cell holds no number"));
        if (report != nullptr)
            if (const std::string found = disagreement(wind, *report, step); !found.empty())
                return void(fail(found));
        if (cells_that_differ(field, winds_[1].field()) > 0)
            return void(fail("one and three threads give different bits"));

        const double speed = claims_.energy_of_start ? start_speed_ : input_.speed();
        const double measure = claims_.energy_of_start ? start_energy_ : 0.5 * speed * speed * static_cast<double>(field.size());
        const double energy = energy_of(field) / measure, max = largest_speed(field) / speed;
        if (measure == 0.0) {
            if (energy_of(field) != 0.0)
                fail("air moves that nothing moved");
            return;
        }
        told_.energy = std::max(told_.energy, energy);
        told_.max = std::max(told_.max, max);
        const double energy_bound = claims_.energy_of_start.value_or(k_input_energy);
        if (!(energy <= energy_bound))
            fail_above("energy", energy, energy_bound);
        if (!claims_.energy_of_start && !(max <= k_speed_factor))
            fail_above("largest speed", max, k_speed_factor);
    }
    void fail_above(const char* what, double ratio, double bound) {
        std::ostringstream text;
        text << what << " is " << ratio << " of its measure, above " << bound;
        fail(text.str());
    }
    template <class Outcome>
    void expect(const Outcome& outcome, const char* call) {
        if (!outcome)
            fail(std::string(call) + ": " + outcome.error());
    }
    bool fail(const std::string& sentence) {
        if (told_.fault.empty())
            told_.fault = "event " + std::to_string(number_) + ", step " + std::to_string(told_.steps) + ": " + sentence;
        return false;
    }

    const Story& story_;
    const Claims& claims_;
    std::vector<Wind> winds_;
    std::vector<Known> motors_;
    Input input_;
    double start_energy_ = 0.0, start_speed_ = 0.0;
    bool asleep_ = false;
    bool ticking_ = false; ///< the last time was told by frames
    std::size_t number_ = 0;
    StoryOutcome told_;
};

} // namespace

StoryOutcome tell(const Story& story, const Claims& claims) {
    return Teller(story, claims).tell();
}

} // namespace windrow::test
