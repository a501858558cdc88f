#include "cases/backend_wind.h"

#if WINDROW_WITH_VULKAN
#include "cases/device_wind.h"
#endif

#include <utility>

namespace windrow::cases {
namespace {

class CpuWind final : public BackendWind {
  public:
    explicit CpuWind(Wind wind) : wind_(std::move(wind)) {}

    Diagnostics step(double dt) override { return wind_.step(dt); }
    Motors& motors() override { return wind_.motors(); }
    const Motors& motors() const override { return wind_.motors(); }
    Result<void> set_sides(const Sides& sides) override { return wind_.set_sides(sides); }
    Result<void> follow(glm::dvec3 point) override { return wind_.follow(point); }
    Result<void> set_floor(double height) override { return wind_.set_floor(height); }
    void set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at) override { wind_.set_velocity(velocity_at); }
    Result<void> set_velocity(std::span<const glm::vec4> field) override { return wind_.set_velocity(field); }
    void reset() override { wind_.reset(); }
    const Config& config() const override { return wind_.config(); }
    glm::dvec3 origin() const override { return wind_.origin(); }
    glm::vec3 ambient() const override { return wind_.ambient(); }
    WindView view() const override { return wind_.view(); }

  private:
    Wind wind_;
};

} // namespace

Result<std::unique_ptr<BackendWind>> BackendWind::create(const Config& config, const Backend& backend,
                                                         [[maybe_unused]] StageClock clock) {
#if WINDROW_WITH_VULKAN
    if (!backend.is_cpu())
        return DeviceWind::create(config, backend, clock);
#else
    static_cast<void>(backend); // no other is ever opened
#endif
    auto wind = Wind::create(config);
    if (!wind)
        return Error{wind.error()};
    return std::unique_ptr<BackendWind>(std::make_unique<CpuWind>(*std::move(wind)));
}

} // namespace windrow::cases
