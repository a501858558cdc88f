#include "cases/backend_wind.h"

#if WINDROW_WITH_VULKAN
#include "cases/device_wind.h"
#endif

#include <algorithm>
#include <utility>
#include <variant>

namespace windrow::cases {

#if WINDROW_WITH_VULKAN
struct BackendWind::EitherWind : std::variant<Wind, DeviceWind> {
    using variant::variant;
};
#else
struct BackendWind::EitherWind : std::variant<Wind> {
    using variant::variant;
};
#endif

BackendWind::BackendWind(std::unique_ptr<EitherWind> wind) : wind_(std::move(wind)) {}
BackendWind::~BackendWind() = default;

Result<std::unique_ptr<BackendWind>> BackendWind::create(const Config& config, const Backend& backend,
                                                         [[maybe_unused]] BackendClock clock) {
    const auto made = [](auto wind) -> Result<std::unique_ptr<BackendWind>> {
        if (!wind)
            return Error{wind.error()};
        return std::unique_ptr<BackendWind>(new BackendWind(std::make_unique<EitherWind>(*std::move(wind))));
    };
#if WINDROW_WITH_VULKAN
    if (!backend.is_cpu())
        return made(DeviceWind::create(config, backend, clock));
#else
    static_cast<void>(backend); // no other is ever opened
#endif
    return made(Wind::create(config));
}

Diagnostics BackendWind::step(double dt) {
    return std::visit([&](auto& wind) { return wind.step(dt); }, *wind_);
}
Motors& BackendWind::motors() {
    return std::visit([](auto& wind) -> Motors& { return wind.motors(); }, *wind_);
}
const Motors& BackendWind::motors() const {
    return std::visit([](const auto& wind) -> const Motors& { return wind.motors(); }, std::as_const(*wind_));
}
Obstacles& BackendWind::obstacles() {
    return std::visit([](auto& wind) -> Obstacles& { return wind.obstacles(); }, *wind_);
}
const Obstacles& BackendWind::obstacles() const {
    return std::visit([](const auto& wind) -> const Obstacles& { return wind.obstacles(); }, std::as_const(*wind_));
}
Result<void> BackendWind::set_boundaries(const Boundaries& boundaries) {
    return std::visit([&](auto& wind) { return wind.set_boundaries(boundaries); }, *wind_);
}
Result<void> BackendWind::follow(glm::dvec3 point) {
    return std::visit([&](auto& wind) { return wind.follow(point); }, *wind_);
}
Result<void> BackendWind::set_floor(double height) {
    return std::visit([&](auto& wind) { return wind.set_floor(height); }, *wind_);
}
void BackendWind::set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) {
    std::visit([&](auto& wind) { wind.set_velocity(velocity_at); }, *wind_);
}
Result<void> BackendWind::set_velocity(std::span<const glm::vec4> field) {
    return std::visit([&](auto& wind) { return wind.set_velocity(field); }, *wind_);
}
void BackendWind::reset() {
    std::visit([](auto& wind) { wind.reset(); }, *wind_);
}
const Config& BackendWind::config() const {
    return std::visit([](const auto& wind) -> const Config& { return wind.config(); }, std::as_const(*wind_));
}
glm::dvec3 BackendWind::origin() const {
    return std::visit([](const auto& wind) { return wind.origin(); }, std::as_const(*wind_));
}
glm::vec3 BackendWind::ambient() const {
    return std::visit([](const auto& wind) { return wind.ambient(); }, std::as_const(*wind_));
}
Result<void> BackendWind::write_obstacles(std::span<float> cells) const {
    if (const auto* const wind = std::get_if<Wind>(wind_.get()))
        return wind->write_obstacles(cells);
    std::fill(cells.begin(), cells.end(), 0.0f);
    return {};
}
Result<void> BackendWind::write_pressure(std::span<float> cells) {
    if (auto* const wind = std::get_if<Wind>(wind_.get()))
        return wind->write_pressure(cells);
    return Error{"a device hands out no pressure: run the air on the CPU."};
}
WindView BackendWind::view() const {
    return std::visit([](const auto& wind) { return wind.view(); }, std::as_const(*wind_));
}

} // namespace windrow::cases
