#include "fluid/vulkan/wind.h"

#include "fluid/core/message.h"
#include "fluid/vulkan/wind_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <utility>

namespace windrow::vulkan {

Wind::State::State(std::unique_ptr<Air> air, const Config& config, const Settings& how, const AmbientWind& ambient,
                   std::shared_ptr<const windrow::Wind> outer)
    : core(config, ambient, cells, std::move(outer)), cells(core, read_backs, std::move(air)), settings(how) {
    core.start();
    this->cells.when_shifted = [this](const OriginShift& shift) {
        read_backs.shift_origin(shift);
        for (std::optional<ShownFrame>* const frame : {&recorded, &recorded_before})
            if (*frame)
                (*frame)->shift_origin(shift);
    };
}

Wind::Wind(std::unique_ptr<State> state) : WindControl(state->core), state_(std::move(state)) {}
Wind::Wind(Wind&&) noexcept = default;
Wind& Wind::operator=(Wind&&) noexcept = default;
Wind::~Wind() = default;

namespace {

// Maximum number of dispatches in a recording: its ticks with all their sub-steps, one shift of the box per tick, and the host's
// requests between two frames. Few recordings approach it; a pool of timestamps takes 8 bytes each.
std::uint32_t laps_of(const Config& config, const Passes& passes) {
    constexpr std::uint64_t k_beside = 32, k_a_tick = 16, k_most = 16384;
    // Around obstacles: six passes a solve and three for rooms; the first step runs twice, and sources are solved once.
    const auto passes_of = [&](int most) { return 6 * static_cast<std::uint64_t>(std::max(config.pressure_solves, most)); };
    const std::uint64_t around = passes_of(k_solves) + 3, first = 3 * passes_of(k_first_solves) + 1;
    const std::uint64_t substep = passes.substep(DiffusionMethod::implicit).size() + around;
    const std::uint64_t tick =
        k_a_tick + first + passes.source_solve().size() + static_cast<std::uint64_t>(config.max_substeps) * substep;
    return static_cast<std::uint32_t>(std::min(k_most, k_beside + static_cast<std::uint64_t>(config.ticks.max_per_call) * tick));
}

void check_reads(windrow::detail::Reasons& reasons, const Config& config, const Settings& settings) {
    const glm::ivec3 size = settings.read_cells;
    if (settings.queries == ReadBack::box &&
        (glm::any(glm::lessThan(size, glm::ivec3(1))) || glm::any(glm::greaterThan(size, config.cells))))
        reasons.add("read_cells is ", size.x, " x ", size.y, " x ", size.z, ": give 1 x 1 x 1 to the box's ", config.cells.x,
                    " x ", config.cells.y, " x ", config.cells.z, ".");
    if (settings.queries == ReadBack::points && (settings.read_points < 1 || settings.read_points > k_max_read_points))
        reasons.add("read_points is ", settings.read_points, ": give 1 to ", k_max_read_points, ".");
    if (settings.forces < 0 || settings.forces > static_cast<int>(Obstacles::k_capacity))
        reasons.add("forces is ", settings.forces, ": give 0 to ", Obstacles::k_capacity, ".");
}

// A slot more than frames in flight: the one that the host holds.
Reads reads_of(const Config& config, const Settings& settings) {
    Reads reads{.kind = settings.queries, .forces = settings.forces, .slots = settings.frames_in_flight + 1};
    if (settings.queries == ReadBack::points)
        reads.points = settings.read_points;
    else if (settings.queries != ReadBack::none)
        reads.cells = settings.queries == ReadBack::box ? settings.read_cells : config.cells;
    return reads;
}

Result<void> check(const Config& config, const Settings& settings, const windrow::Wind* outer) {
    detail::Reasons reasons;
    if (auto valid = validate(config); !valid)
        reasons.add(valid.error());
    else if (outer != nullptr)
        detail::check_within(reasons, config, *outer);
    if (config.rows && settings.queries == ReadBack::box && settings.read_cells.y != config.cells.y)
        reasons.add("read_cells has ", settings.read_cells.y, " rows of a box whose rows differ: give all ", config.cells.y, ".");
    if (settings.frames_in_flight < 1 || settings.frames_in_flight > 8)
        reasons.add("frames_in_flight is ", settings.frames_in_flight, ": give 1 to 8, as many as the host has.");
    check_reads(reasons, config, settings);
    return reasons.outcome();
}

Air::Settings air_settings(const Config& config, const Settings& settings, const windrow::Wind* outer) {
    return {.texel = settings.texel,
            .textures = settings.textures,
            .gusts = settings.gusts || config.gusts.intensity > 0.0f || config.gusts.tile, // detail needs the tile alone
            .reads = reads_of(config, settings),
            .exported = settings.export_textures,
            .obstacles = settings.obstacles,
            .outer = outer};
}

} // namespace

Result<RequiredBytes> required_bytes(const Host& host, const Config& wanted, const Settings& settings,
                                     const windrow::Wind* outer) {
    return windrow::detail::where_memory_lasts([&]() -> Result<RequiredBytes> {
        const Config config = outer != nullptr ? windrow::detail::config_within(wanted, *outer) : wanted;
        if (auto checked = check(wanted, settings, outer); !checked)
            return checked.failure();
        auto device = Device::create(host);
        if (!device)
            return device.failure();
        const auto measured = Air::measure(*std::move(device), config, air_settings(config, settings, outer));
        if (!measured)
            return measured.failure();
        return RequiredBytes{.memory = measured->given, .reserved = measured->taken};
    });
}

Result<Wind> Wind::create(const Host& host, const Config& config, const Settings& settings,
                          std::shared_ptr<const windrow::Wind> outer) {
    return windrow::detail::where_memory_lasts([&]() -> Result<Wind> {
        if (auto checked = check(config, settings, outer.get()); !checked)
            return checked.failure();
        return make(host, config, settings, std::move(outer), false);
    });
}

// `outer` has been checked.
Result<Wind> Wind::make(const Host& host, const Config& wanted, const Settings& settings,
                        std::shared_ptr<const windrow::Wind> outer, bool loads) {
    return windrow::detail::where_memory_lasts([&]() -> Result<Wind> {
        OuterUndo undo(outer);
        const Config config = !outer  ? wanted
                              : loads ? windrow::detail::config_loaded(wanted, *outer)
                                      : windrow::detail::config_within(wanted, *outer);
        if (auto checked = check(config, settings, nullptr); !checked)
            return checked.failure();
        const glm::vec3 mean = admissible_ambient(config.boundaries, config.ambient);
        auto ambient = AmbientWind::create({.mean = mean, .profile = config.profile, .gusts = config.gusts});
        if (!ambient)
            return ambient.failure();
        if (outer)
            ambient->set_phase(outer->ambient_wind().phase());
        auto air = Air::create(host, config, air_settings(config, settings, outer.get()));
        if (!air)
            return air.failure();
        auto state = std::make_unique<State>(*std::move(air), config, settings, *ambient, std::move(outer));
        Air& cells = *state->cells.air;
        state->read_backs.make(cells, settings.frames_in_flight, state->frame_now());
        if (settings.timestamps) {
            auto clock = PassClock::create(cells.device(), settings.frames_in_flight, laps_of(config, cells.passes()));
            if (!clock)
                return clock.failure();
            state->clock = *std::move(clock);
            cells.set_clock(&*state->clock);
        }
        undo.succeed();
        return Wind(std::move(state));
    });
}

Result<Advance> Wind::record(VkCommandBuffer commands, const Frame& frame) {
    return state_->record(commands, frame);
}
Result<Diagnostics> Wind::record_step(VkCommandBuffer commands, const Frame& frame) {
    return state_->record_step(commands, frame);
}
bool Wind::collect(int slot) {
    return state_->collect(slot);
}

void Wind::forget() {
    state_->forget();
}

// --- For shaders ------------------------------------------------------------------------------------------------------------

namespace {

Textures textures_of(const Fields& fields, int set) {
    Textures textures;
    const auto of = [](const Image3D& image) { return Texture{image.handle(), image.view()}; };
    textures.vectors = of(fields.vectors[set]);
    for (std::size_t axis = 0; axis < 3; ++axis)
        textures.axes[axis] = of(fields.axes[set][axis]);
    return textures;
}

} // namespace

Textures Wind::textures() const {
    return textures_of(state_->cells.air->fields(), state_->textures.current);
}
Textures Wind::previous_textures() const {
    return textures_of(state_->cells.air->fields(), state_->textures.current ^ 1);
}

namespace {

// Calls use(view of the frame last recorded, view of the one before). The views are valid during the call. They hold no cells.
template <class Use>
auto with_views(const Wind::State& state, const Use& use) {
    const Box box = state.core.box();
    const auto& reading = state.cells.air->reading();
    const ShownCells shown{.law = reading ? reading->law() : WallLaw{}};
    const auto view = [&](const ShownFrame& frame) {
        return WindView(box, frame.window, state.core.blend_zone(frame.blend_centre), frame.ambient, {}, Simd::best, shown);
    };
    const ShownFrame unrecorded = state.core.shown();
    const ShownFrame& now = state.recorded ? *state.recorded : unrecorded;
    const ShownFrame& before = state.recorded_before ? *state.recorded_before : now;
    return use(view(now), view(before));
}

} // namespace

// The set of textures of a frame depends on the recordings, including pauses, not on the steps.
WindowBlock Wind::window_block(glm::dvec3 anchor) const {
    return with_views(*state_, [&](const WindView& now, const WindView& before) {
        WindowBlock block = state_->core.window_block(anchor, now, before);
        const WindowBlock earlier = before.block(anchor);
        block.previous_origin = earlier.origin;
        block.previous_blend_centre = earlier.blend_centre;
        return block;
    });
}

FrameBlock Wind::frame_block(glm::dvec3 anchor, const Sampling& sampling) const {
    return with_views(*state_, [&](const WindView& now, const WindView& before) {
        return windrow::frame_block(window_block(anchor), now.ambient().block(anchor, sampling),
                                    before.ambient().block(anchor, sampling), state_->core.rows.get());
    });
}

std::vector<ExportedImage> Wind::exported_images() const {
    const Settings& settings = state_->settings;
    std::vector<ExportedImage> images;
    if (settings.export_textures == VkExternalMemoryHandleTypeFlagBits{})
        return images;
    const glm::uvec3 cells(state_->core.config.cells);
    const Fields& fields = state_->cells.air->fields();
    const bool half = settings.texel == Texel::half;
    const auto add = [&](const Image3D& image, VkFormat format) {
        images.push_back({.image = image.handle(),
                          .memory = image.memory().memory,
                          .offset = image.memory().offset,
                          .size = image.memory_bytes(),
                          .handle_type = settings.export_textures,
                          .format = format,
                          .extent = {cells.x, cells.y, cells.z}});
    };
    (void)windrow::detail::memory_lasts([&] {
        for (int set = 0; set < 2; ++set) {
            if (has_vectors(settings.textures))
                add(fields.vectors[set], half ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT);
            for (int axis = 0; axis < 3 && has_axes(settings.textures); ++axis)
                add(fields.axes[set][axis], half ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R32_SFLOAT);
        }
    });
    return images;
}

VkBuffer Wind::gust_buffer() const {
    return state_->cells.air->fields().tile.handle();
}

const AmbientWind& Wind::ambient_wind() const {
    const WindCore& core = state_->core;
    return core.frames ? core.frames->shown.ambient : core.ambient;
}

// --- For the host -----------------------------------------------------------------------------------------------------------

namespace {

// The last read-back where it is of this kind, as a view with the cells given.
std::optional<WindView> view_of(const Wind::State& state, std::span<const glm::vec4> cells, const ShownCells& shown) {
    const RecordedFrame* const read = state.read_backs.frame();
    if (read == nullptr)
        return std::nullopt;
    return WindView(read->box, read->frame.window, read->blend_zone, read->frame.ambient, cells, Simd::best, shown,
                    {state.core.outer.get(), false});
}

template <class Value>
std::span<const Value> values(std::span<const std::byte> bytes, std::size_t count) {
    return {reinterpret_cast<const Value*>(bytes.data()), std::min(count, bytes.size() / sizeof(Value))};
}

} // namespace

std::optional<WindView> Wind::queried() const {
    const ReadBack kind = state_->settings.queries;
    if (kind != ReadBack::cells && kind != ReadBack::box)
        return std::nullopt;
    const auto bytes = state_->read_backs.bytes(*state_->cells.air);
    const auto cells = values<glm::vec4>(bytes, bytes.size());
    return view_of(*state_, cells, state_->sampled([&] { return cells; }));
}

std::optional<HalfView> Wind::queried_halves() const {
    if (state_->settings.queries != ReadBack::halves)
        return std::nullopt;
    const auto bytes = state_->read_backs.bytes(*state_->cells.air);
    const auto halves = values<glm::u16vec4>(bytes, bytes.size());
    std::vector<glm::vec4> cells;
    const ShownCells shown = state_->sampled([&] {
        std::ranges::transform(halves, std::back_inserter(cells), vector_of);
        return std::span<const glm::vec4>(cells);
    });
    const auto place = view_of(*state_, {}, shown);
    return place ? std::optional(HalfView(*place, halves, !shown.cells.empty())) : std::nullopt;
}

std::optional<PointWinds> Wind::queried_points() const {
    const ReadBacks& read = state_->read_backs;
    if (state_->settings.queries != ReadBack::points || read.frame() == nullptr)
        return std::nullopt;
    return PointWinds{.positions = read.points(),
                      .velocities = values<glm::vec4>(read.bytes(*state_->cells.air), read.points().size())};
}

double Wind::query_age() const {
    const RecordedFrame* const read = state_->read_backs.frame();
    return read != nullptr ? state_->time - read->time : 0.0;
}

Result<ObstacleForce> Wind::force_on(ObstacleId id) const {
    const State& state = *state_;
    if (auto known = state.core.obstacles.check(id); !known)
        return known.failure();
    if (state.settings.forces == 0)
        return Error{"no forces come back from the device: create the wind with Settings::forces."};
    if (state.core.sleep.asleep())
        return ObstacleForce{};
    return state.read_backs.force_on(*state.cells.air, id.slot, id.generation);
}

Result<DragForce> Wind::force_on(DragId id) const {
    const State& state = *state_;
    if (auto known = state.core.drag.check(id); !known)
        return known.failure();
    if (state.settings.queries != ReadBack::cells)
        return Error{"no cells come back from the device: create the wind with Settings::queries of cells."};
    const auto read = queried();
    if (!read)
        return Error{"no cells have come back yet: record and submit a frame, wait for it, and ask again."};
    return state.core.drag.force_on(id, state.read_backs.frame()->frame.window, state.core.config.boundaries, read->field());
}

Result<void> Wind::write_obstacles(std::span<float> cells) const {
    const RecordedFrame* const read = state_->read_backs.frame();
    const ReadBack kind = state_->settings.queries;
    const bool has_cells = kind == ReadBack::cells || kind == ReadBack::box || kind == ReadBack::halves;
    const bool whole = has_cells && read != nullptr && read->frame.window.cells == box().cells;
    return state_->core.write_obstacles(cells, whole ? read->frame.window : state_->core.window());
}

Result<void> Wind::write_pressure(std::span<float>) {
    return Error{"a device hands out no pressure: run the air on the CPU."};
}

Diagnostics Wind::diagnostics() const {
    return state_->diagnostics();
}
Diagnostics Wind::reported() {
    return state_->reported();
}
bool Wind::waits() const {
    return state_->cells.waits();
}

Result<WindView> Wind::read_view() const {
    const ReadBack kind = state_->settings.queries;
    if (kind != ReadBack::cells && kind != ReadBack::box)
        return Error{"no cells come back from the device: create the wind with Settings::queries of cells or box."};
    if (auto read = queried())
        return *std::move(read);
    return Error{"no cells have come back yet: record and submit a frame, wait for it, and ask again."};
}

Result<WindView> Wind::read_previous_view() const {
    return Error{"the frame before is on the device alone: sample its textures in a shader."};
}

glm::vec3 Wind::velocity(glm::dvec3 position) const {
    if (const auto view = queried())
        return view->velocity(position);
    if (const auto halves = queried_halves())
        return halves->velocity(position);
    if (const auto& outer = state_->core.outer)
        return outer->velocity(position);
    return ambient_wind().velocity(position);
}

int Wind::dispatches() const {
    return state_->dispatches;
}
int Wind::barriers() const {
    return state_->barriers;
}
std::optional<PassTimes> Wind::pass_times() const {
    std::optional<PassTimes> times;
    (void)windrow::detail::memory_lasts([&] {
        if (state_->clock)
            times = state_->clock->times();
    });
    return times;
}
std::uint64_t Wind::memory_bytes() const {
    return state_->cells.air->device().memory().given();
}
std::uint64_t Wind::reserved_bytes() const {
    return state_->cells.air->device().memory().taken();
}

} // namespace windrow::vulkan
