// Times of a step and of a walk by the device's clock, the read-back in an interval of its own, beside the time in which this
// device copies as many bytes.
#include "cases/parity_story.h"
#include "cli/bench/obstacle_scenes.h"
#include "cli/bench/vulkan/wind_recordings.h"
#include "cli/bench/wind_contestant.h"
#include "cli/device_report/report_section.h"
#include "cli/table.h"
#include "fluid/core/message.h"
#include "gpu/device.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace windrow::cli {
namespace {

using namespace cases;
using detail::message;

constexpr double k_step_warm_fraction = 0.3;
constexpr int k_many_substeps = 8;
constexpr glm::ivec3 k_largest_grid{256, 128, 256}; // behind k_bench_grids, where memory allows
constexpr double k_heap_fraction = 0.8;             // of the device's memory, that the winds of a grid may take

// [GB/s] Of a footprint, between the sizes that were measured, by their logarithms; nothing where none was.
std::optional<double> bandwidth_at(const ReportJson& sections, std::uint64_t bytes) {
    const auto costs = sections.find("costs");
    if (costs == sections.end() || !costs->contains("bandwidth"))
        return std::nullopt;
    const double at = std::log2(static_cast<double>(bytes) / 1024.0);
    double below = 0.0, rate = 0.0;
    bool first = true;
    for (const ReportJson& row : (*costs)["bandwidth"]) {
        if (row.contains("left_out"))
            break;
        const double size = std::log2(row["footprint_KiB"].get<double>()), here = row["GB_per_s"].get<double>();
        if (size >= at)
            return first ? here : rate + (here - rate) * (at - below) / (size - below);
        below = size;
        rate = here;
        first = false;
    }
    return first ? std::nullopt : std::optional(rate);
}

ReportJson floor_json(const SectionRun& run, std::uint64_t bytes, std::uint64_t footprint) {
    const auto rate = bandwidth_at(run.sections, footprint);
    return rate && bytes > 0 ? ReportJson(four_digits(1e-3 * static_cast<double>(bytes) / *rate)) : ReportJson();
}

struct Recorded {
    const char* name;
    std::unique_ptr<WindRecordings> wind;
    std::size_t number = 0;
    bool has_floor = false;
    const char* timed = nullptr; ///< its passes are: what stands in the air, behind the grid in their table
};

/// Recordings of a grid, of a wind each: all, or the step and its passes where time or memory allows no more.
enum class Recordings { all, step };
constexpr std::uint64_t winds_of(Recordings which) {
    return which == Recordings::all ? 14 : 2;
}

/// [s] That a round takes.
struct RoundSeconds {
    double all = 0.0, step = 0.0;
    [[nodiscard]] double of(Recordings which) const { return which == Recordings::all ? all : step; }
};

class GridTimes {
  public:
    GridTimes(SectionRun& run, glm::ivec3 cells, Recordings which)
        : run_(run), cells_(cells), which_(which), flow_(jets(bench_box(cells))) {}

    /// Nothing where it was stopped.
    Result<std::optional<RoundSeconds>> measure(double seconds) {
        auto lent = vulkan::Device::create(run_.own.host());
        if (!lent)
            return lent.failure();
        auto contest = DeviceContest::create(run_.own, **lent);
        if (!contest)
            return contest.failure();
        if (auto added = add_all(*contest); !added)
            return added.failure();
        const double before = run_.clock.past();
        const auto held = contest->hold({.seconds = seconds, .warm_seconds = k_step_warm_fraction * seconds},
                                        [&] { return run_.clock.stopped(); });
        if (!held)
            return held.failure();
        if (*held == DeviceContest::End::stopped)
            return std::optional<RoundSeconds>();
        report(*contest);
        // A turn records twice.
        const double step =
            2e-6 * (contest->microseconds(all_.front().number).median + contest->microseconds(all_.back().number).median);
        const double whole = (run_.clock.past() - before) / static_cast<double>(contest->rounds() + 1);
        return std::optional(RoundSeconds{.all = whole, .step = std::min(step, whole)});
    }

  private:
    Result<void> add(DeviceContest& contest, const char* name, const Config& config, const vulkan::Settings& settings,
                     RecordingPlan plan, const std::vector<StoryMotor>& motors = {}) {
        auto wind = vulkan::Wind::create(run_.own.host(), config, settings);
        if (!wind)
            return wind.failure();
        for (const StoryMotor& one : motors)
            if (const auto id = wind->motors().add(one.motor); !id)
                return id.failure();
        all_.push_back({.name = name, .wind = std::make_unique<WindRecordings>(*std::move(wind), std::move(plan))});
        all_.back().number = contest.add(all_.back().wind->contestant());
        return {};
    }

    Result<void> add_all(DeviceContest& contest) {
        const vulkan::Settings usual{.frames_in_flight = 2};
        Config many = bench_config(cells_, Scheme::second_order, Simd::best, run_.parallel_for);
        many.max_substeps = k_many_substeps;
        Config one = many;
        one.max_substeps = 1;
        Config fine = many; // a CFL number of 0.4 to 0.5 makes eight sub-steps of it
        fine.max_cfl = 0.06f;
        const RecordingPlan step{.flow = flow_};
        RecordingPlan fresh = step;
        fresh.steps_of_flow = 2; // before the flow slows down
        Result<void> added = add(contest, "step, one sub-step", one, usual, step);
        const bool all = which_ == Recordings::all;
        if (added && all)
            added = add(contest, "step, one of up to eight", many, usual, step);
        if (added && all)
            added = add(contest, "step, eight of eight", fine, usual, fresh);
        if (added && all)
            added = add(contest, "step, one sub-step, all cells read back", one,
                        {.frames_in_flight = 2, .queries = vulkan::ReadBack::cells}, step);
        if (added && all)
            added = add_walks(contest, usual);
        if (added && all)
            added = add_obstacles(contest, one, step);
        if (added) {
            added = add(contest, "passes", one, {.frames_in_flight = 2, .timestamps = true}, step);
            all_[0].has_floor = added.has_value();
            all_.back().timed = "";
        }
        return added;
    }

    // What stands in the air, and what it stands on: each beside the step of free air.
    Result<void> add_obstacles(DeviceContest& contest, const Config& free, const RecordingPlan& step) {
        Config twice = free, rough = free;
        twice.pressure_solves = 2;
        rough.roughness.emplace();
        rough.rows.emplace(Rows{.first = 0.5f, .uniform = cells_.y / 4, .top = static_cast<float>(cells_.y)});
        const auto town = [](const BuildingPlace& place) { return build_town(place, 1.0); };
        const struct {
            const char* name;
            const Config& config;
            std::function<bool(const BuildingPlace&)> build;
        } k_scenes[] = {{"step, one cube", free, build_cube},
                        {"step, town", free, town},
                        {"step, town, two solves", twice, town},
                        {"step, hills", free, build_hills},
                        {"step, hills on rough ground, in rows", rough, build_hills}};
        for (const auto& [name, config, build] : k_scenes) {
            if (auto added = add(contest, name, config, {.frames_in_flight = 2, .obstacles = true}, step); !added)
                return added;
            if (!build(place_of(all_.back().wind->wind())))
                return Error{message(name, ": an obstacle was rejected")};
        }
        if (auto added = add(contest, "passes", rough, {.frames_in_flight = 2, .timestamps = true, .obstacles = true}, step);
            !added)
            return added;
        all_.back().timed = ", hills on rough ground, in rows";
        if (!build_hills(place_of(all_.back().wind->wind())))
            return Error{"passes: the hills were rejected"};
        return {};
    }

    // The parity story of this grid: profile, canopy, gusts, three motors; the box follows a runner.
    Result<void> add_walks(DeviceContest& contest, const vulkan::Settings& settings) {
        const auto stories = parity_stories();
        const std::string name = message("walk_", grid_name(cells_));
        const auto story =
            std::find_if(stories.begin(), stories.end(), [&](const ParityStory& each) { return each.name == name; });
        if (story == stories.end()) {
            run_.leave_out(message("walks at ", grid_name(cells_), ": there is no such story."));
            return {};
        }
        const auto walk = [&](const char* what, int max_substeps, glm::dvec3 velocity) {
            Config config = story->config;
            config.max_substeps = max_substeps;
            const glm::dvec3 centre = config.centre;
            RecordingPlan plan;
            plan.before_step = [=](vulkan::Wind& wind, double time) { (void)wind.follow(centre + time * velocity); };
            return add(contest, what, config, settings, std::move(plan), story->motors);
        };
        Result<void> added = walk("walk, one sub-step", 1, story->walk);
        if (added)
            added = walk("walk, one of up to eight", k_many_substeps, story->walk);
        const glm::dvec3 cell_a_step(static_cast<double>(story->config.cell_size) / k_bench_dt, 0.0, 0.0);
        if (added)
            added = walk("walk, a shift in each step", 1, cell_a_step);
        return added;
    }

    void report(const DeviceContest& contest) {
        const std::string grid = grid_name(cells_);
        DeviceGridResult passes;
        all_.back().wind->add_passes(passes);
        const std::uint64_t footprint = all_[0].wind->wind().memory_bytes();
        for (const Recorded& one : all_) {
            if (one.timed != nullptr)
                continue;
            const DeviceStepResult counts = one.wind->result(one.name);
            const DeviceSpread us = contest.microseconds(one.number);
            const ReportJson floor = one.has_floor ? floor_json(run_, passes.pass_bytes, footprint) : ReportJson();
            run_.json["steps"].push_back(
                {{"recording", one.name},
                 {"grid", grid},
                 {"us", spread_json(us)},
                 {"read_back_us",
                  {{"median", four_digits(contest.microseconds(one.number, 1).median)},
                   {"p99", four_digits(contest.microseconds(one.number, 1).p99)}}},
                 {"substeps", one.wind->max_substeps()},
                 {"dispatches", counts.dispatches},
                 {"barriers", counts.barriers},
                 {"copy_floor_us", floor},
                 {"over_floor", floor.is_null() ? ReportJson() : ReportJson(four_digits(us.median / floor.get<double>()))}});
        }
        run_.json["memory"].push_back({{"grid", grid},
                                       {"bytes", footprint},
                                       {"bytes_moved_by_a_step", passes.pass_bytes},
                                       {"bytes_read_back", passes.read_back_bytes}});
        for (auto one = all_.rbegin(); one != all_.rend(); ++one)
            if (one->timed != nullptr)
                report_passes(*one, grid + one->timed, footprint);
    }

    void report_passes(const Recorded& timed, const std::string& grid, std::uint64_t footprint) {
        DeviceGridResult passes;
        timed.wind->add_passes(passes);
        for (const DevicePassResult& pass : passes.passes) {
            const bool moves = pass.bytes > 0 && pass.us.median > 0.0;
            run_.json["passes"].push_back(
                {{"pass", pass.name},
                 {"grid", grid},
                 {"us", spread_json(pass.us)},
                 {"dispatches", pass.dispatches_ran},
                 {"MiB", four_digits(static_cast<double>(pass.bytes) / (1 << 20))},
                 {"GB_per_s",
                  moves ? ReportJson(four_digits(1e-3 * static_cast<double>(pass.bytes) / pass.us.median)) : ReportJson()},
                 {"copy_floor_us", floor_json(run_, pass.bytes, footprint)}});
        }
        const auto other = [&](const char* name, const DeviceSpread& us, ReportJson floor) {
            run_.json["passes"].push_back({{"pass", name},
                                           {"grid", grid},
                                           {"us", spread_json(us)},
                                           {"dispatches", nullptr},
                                           {"MiB", nullptr},
                                           {"GB_per_s", nullptr},
                                           {"copy_floor_us", std::move(floor)}});
        };
        other("between them, with the clock", passes.between_us, {});
        other("all, with the clock", passes.timed_us, floor_json(run_, passes.pass_bytes, footprint));
    }

    SectionRun& run_;
    glm::ivec3 cells_;
    Recordings which_;
    std::vector<glm::vec4> flow_;
    std::vector<Recorded> all_;
};

double count_of(glm::ivec3 cells) {
    return static_cast<double>(cells.x) * cells.y * cells.z;
}

// [bytes] Of the largest heap on the device.
std::uint64_t device_heap(const ReportJson& sections) {
    std::uint64_t largest = 0;
    for (const ReportJson& heap : sections["facts"]["memory_heaps"])
        if (heap["is"].get<std::string>().find("device local") != std::string::npos)
            largest = std::max(largest, heap["bytes"].get<std::uint64_t>());
    return largest;
}

// What memory allows and, with the seconds that a cell took in a round before, time; or nothing, and why.
std::optional<Recordings> recordings_of(SectionRun& run, glm::ivec3 cells, const RoundSeconds& of_cell) {
    const std::string grid = grid_name(cells);
    const auto leave_out = [&](const char* what, const std::string& why) {
        run.leave_out(message("times at ", grid, ": ", why));
        run.leave_out_row("steps", {{"recording", "step, one sub-step"}, {"grid", grid}}, what);
        return std::optional<Recordings>();
    };
    if (run.clock.over())
        return leave_out("time", "the time is up.");
    const auto bytes = vulkan::required_bytes(run.own.host(), bench_config(cells, Scheme::second_order, Simd::best, {}),
                                              {.frames_in_flight = 2, .queries = vulkan::ReadBack::cells});
    if (!bytes)
        return leave_out("memory", bytes.error());
    const double heap = k_heap_fraction * static_cast<double>(device_heap(run.sections));
    const auto fits = [&](Recordings which) { return static_cast<double>(winds_of(which) * bytes->reserved) <= heap; };
    if (!fits(Recordings::step))
        return leave_out("memory", message("two winds reserve ", four_digits(2e-9 * static_cast<double>(bytes->reserved)),
                                           " GB, and ", four_digits(1e-9 * heap), " GB of the device's memory are for them."));
    // Two rounds at least: one that warms up, one that counts.
    const auto least = [&](Recordings which) { return 2.0 * of_cell.of(which) * count_of(cells); };
    for (const Recordings which : {Recordings::all, Recordings::step})
        if (fits(which) && least(which) <= run.clock.left()) {
            const std::string rest = message("all but the step at ", grid, ": ");
            if (which == Recordings::step && !fits(Recordings::all))
                run.leave_out(rest + message(winds_of(Recordings::all), " winds do not fit in the device's memory."));
            else if (which == Recordings::step)
                run.leave_out(rest + message("all need ", four_digits(least(Recordings::all)), " s, and ",
                                             four_digits(run.clock.left()), " s are left."));
            return which;
        }
    return leave_out("time", message("the step needs ", four_digits(least(Recordings::step)), " s, and ",
                                     four_digits(run.clock.left()), " s are left."));
}

} // namespace

Result<void> report_times(SectionRun& run) {
    std::vector<glm::ivec3> grids(std::begin(k_bench_grids), std::end(k_bench_grids));
    if (!run.quick)
        grids.push_back(k_largest_grid);
    else if (run.own.facts().software)
        grids.resize(1);
    RoundSeconds of_cell; // at the grids before
    for (std::size_t n = 0; n < grids.size(); ++n) {
        const auto which = recordings_of(run, grids[n], of_cell);
        if (!which)
            continue;
        const double seconds = run.clock.left() / (1.0 + k_step_warm_fraction) / static_cast<double>(grids.size() - n);
        const auto round = GridTimes(run, grids[n], *which).measure(seconds);
        if (!round)
            return round.failure();
        if (!*round)
            return {};
        of_cell.step = std::max(of_cell.step, (*round)->step / count_of(grids[n]));
        if (*which == Recordings::all)
            of_cell.all = std::max(of_cell.all, (*round)->all / count_of(grids[n]));
    }
    return {};
}

} // namespace windrow::cli
