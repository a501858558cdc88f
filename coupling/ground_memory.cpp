#include "coupling/ground_memory.h"

#include "coupling/ground_host.h"
#include "coupling/ground_state.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace windrow {

struct WINDROW_HIDDEN GroundMemory::State {
    State(const GroundConfig& config, ParallelFor loop) : host(config), parallel_for(loop) {}

    Result<void> advance(const GroundStep& step, std::span<const glm::vec2> wind_leans);
    void advance_row(const numerics::WindrowGroundStep& step, int row, std::span<const glm::vec2> wind_leans);

    detail::GroundHost host;
    ParallelFor parallel_for;
    std::vector<numerics::WindrowGround> texels;
    std::vector<glm::vec2> leans_before; // of the wind, a step ago
    std::vector<glm::vec4> shown[2];
    int set = 0;
    bool shown_once = false;
};

GroundMemory::GroundMemory(std::unique_ptr<State> state) : state_(std::move(state)) {}
GroundMemory::GroundMemory(GroundMemory&&) noexcept = default;
GroundMemory& GroundMemory::operator=(GroundMemory&&) noexcept = default;
GroundMemory::GroundMemory(const GroundMemory& other) : state_(other.state_ ? std::make_unique<State>(*other.state_) : nullptr) {}
GroundMemory& GroundMemory::operator=(const GroundMemory& other) {
    return *this = GroundMemory(other);
}
GroundMemory::~GroundMemory() = default;

Result<GroundMemory> GroundMemory::create(const GroundConfig& config, ParallelFor parallel_for) {
    if (auto valid = validate(config); !valid)
        return valid.failure();
    return detail::where_memory_lasts([&]() -> Result<GroundMemory> {
        auto state = std::make_unique<State>(config, parallel_for);
        const std::size_t count = state->host.texel_count();
        state->texels.assign(count, numerics::windrow_ground_new({0.0f, 0.0f}));
        state->leans_before.assign(count, glm::vec2(0.0f));
        for (auto& shown : state->shown)
            shown.assign(count, glm::vec4(0.0f));
        return GroundMemory(std::move(state));
    });
}

Result<void> GroundMemory::follow(glm::dvec3 point) {
    return state_->host.follow(point);
}
Result<void> GroundMemory::shift_origin(glm::dvec3 offset) {
    return state_->host.shift_origin(offset);
}

Result<void> GroundMemory::advance(const GroundStep& step) {
    return state_->advance(step, {});
}

Result<void> GroundMemory::advance(const GroundStep& step, std::span<const glm::vec2> wind_leans) {
    if (wind_leans.size() != state_->texels.size())
        return Error{detail::message("GroundMemory::advance got ", wind_leans.size(), " wind leans for ", state_->texels.size(),
                                     " texels: give one each.")};
    return state_->advance(step, wind_leans);
}

// --- A step
// ----------------------------------------------------------------------------------------------------------------------

Result<void> GroundMemory::State::advance(const GroundStep& step, std::span<const glm::vec2> wind_leans) {
    const auto begun = host.begin(step, wind_leans.empty() ? WindLeans::everywhere : WindLeans::each_texel);
    if (!begun)
        return begun.failure();
    set ^= 1;
    parallel_for(host.config().texels, [&](int row) { advance_row(*begun, row, wind_leans); });
    if (!shown_once) // the frame before the first is the first
        shown[set ^ 1] = shown[set];
    shown_once = true;
    return {};
}

void GroundMemory::State::advance_row(const numerics::WindrowGroundStep& step, int row, std::span<const glm::vec2> wind_leans) {
    const int n = step.window.x;
    const glm::ivec2 corner(step.window.y, step.window.z);
    const auto walkers = host.walkers();
    const float z = static_cast<float>(numerics::windrow_ground_in_slot({0, row}, corner, n).y) + 0.5f;
    // Walkers whose sweep may touch the row; GroundConfig::max_walkers is 256 at most.
    std::uint16_t near[256];
    std::size_t near_count = 0;
    for (std::size_t w = 0; w < walkers.size(); ++w)
        if (std::min(walkers[w].from.y, walkers[w].to.y) - walkers[w].from.w < z &&
            std::max(walkers[w].from.y, walkers[w].to.y) + walkers[w].from.w > z)
            near[near_count++] = static_cast<std::uint16_t>(w);
    for (int x = 0; x < n; ++x) {
        const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(n) + static_cast<std::size_t>(x);
        const glm::ivec2 texel = numerics::windrow_ground_in_slot({x, row}, corner, n);
        glm::vec2 lean(step.wind.x, step.wind.y);
        if (!wind_leans.empty())
            lean = {numerics::windrow_ground_sound(wind_leans[at].x), numerics::windrow_ground_sound(wind_leans[at].y)};
        numerics::WindrowGround ground = numerics::windrow_ground_is_new(texel, {step.moved.x, step.moved.y}, n)
                                             ? numerics::windrow_ground_new(lean)
                                             : numerics::windrow_ground_advanced(texels[at], step, leans_before[at], lean);
        const glm::vec2 centre = glm::vec2(texel) + 0.5f;
        for (std::size_t w = 0; w < near_count; ++w)
            ground = numerics::windrow_ground_touched(ground, step,
                                                      numerics::windrow_ground_contact(walkers[near[w]], centre, step.contact.x));
        texels[at] = ground;
        leans_before[at] = lean;
        shown[set][at] = numerics::windrow_ground_shown(ground);
    }
}

// --- Bytes
// -------------------------------------------------------------------------------------------------------------------------

Result<std::vector<std::byte>> GroundMemory::save() const {
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        detail::SavedGround saved(config());
        saved.host = state_->host;
        saved.stepped = state_->shown_once;
        saved.texels = state_->texels;
        saved.leans_before = state_->leans_before;
        saved.shown_before = state_->shown[state_->set ^ 1];
        return to_bytes(saved);
    });
}

Result<GroundMemory> GroundMemory::load(std::span<const std::byte> bytes, ParallelFor parallel_for) {
    return detail::where_memory_lasts([&]() -> Result<GroundMemory> {
        auto saved = detail::ground_of(bytes);
        if (!saved)
            return saved.failure();
        auto ground = create(saved->host.config(), parallel_for);
        if (!ground)
            return ground;
        State& state = *ground->state_;
        state.host = std::move(saved->host);
        state.shown_once = saved->stepped;
        state.texels = std::move(saved->texels);
        state.leans_before = std::move(saved->leans_before);
        state.shown[state.set ^ 1] = std::move(saved->shown_before);
        if (state.shown_once)
            std::transform(state.texels.begin(), state.texels.end(), state.shown[state.set].begin(),
                           numerics::windrow_ground_shown);
        return ground;
    });
}

// --- Reading
// ---------------------------------------------------------------------------------------------------------------------

int GroundMemory::walkers_left_out() const {
    return state_->host.left_out();
}
glm::dvec2 GroundMemory::next_centre(glm::ivec2 slot) const {
    return state_->host.next_centre(slot);
}

namespace {

GroundSample sample(const std::vector<glm::vec4>& texels, int n, const GroundPlaceBlock& place) {
    const glm::vec4 found =
        numerics::windrow_ground_at({texels.data(), n}, std::bit_cast<numerics::WindrowGroundPlace>(place), glm::vec3(0.0f));
    return {.lean = {found.x, found.y}, .trample = found.z, .trail = found.w};
}

} // namespace

// The anchor is the point itself, so that the result is as exact far away as near the origin.
GroundSample GroundMemory::at(glm::dvec3 position) const {
    return sample(state_->shown[state_->set], config().texels, state_->host.block(position).now);
}
GroundSample GroundMemory::previous_at(glm::dvec3 position) const {
    return sample(state_->shown[state_->set ^ 1], config().texels, state_->host.block(position).before);
}

std::span<const glm::vec4> GroundMemory::texels() const {
    return state_->shown[state_->set];
}
std::span<const glm::vec4> GroundMemory::previous_texels() const {
    return state_->shown[state_->set ^ 1];
}
GroundBlock GroundMemory::block(glm::dvec3 anchor) const {
    return state_->host.block(anchor);
}
std::span<const numerics::WindrowGround> detail::GroundState::of(const GroundMemory& ground) {
    return ground.state_->texels;
}
const GroundConfig& GroundMemory::config() const {
    return state_->host.config();
}

} // namespace windrow
