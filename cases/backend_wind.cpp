#include "cases/backend_wind.h"

#if WINDROW_WITH_VULKAN
#include "cases/device_wind.h"
#endif

#include <limits>
#include <utility>

namespace windrow::cases {
namespace {

class CpuWind final : public BackendWind {
  public:
    explicit CpuWind(std::unique_ptr<Wind> wind) : BackendWind(*wind), wind_(std::move(wind)) {}
    Diagnostics step(double dt) override { return wind_->step(dt); }
    [[nodiscard]] Wind* on_cpu() override { return wind_.get(); }
    [[nodiscard]] WindReader& reader() const override { return *wind_; }

  private:
    std::unique_ptr<Wind> wind_;
};

} // namespace

Result<std::unique_ptr<BackendWind>> BackendWind::create(const Config& config, [[maybe_unused]] const Backend& backend,
                                                         [[maybe_unused]] BackendClock clock, std::shared_ptr<const Wind> outer) {
#if WINDROW_WITH_VULKAN
    if (!backend.is_cpu())
        return DeviceWind::create(config, backend, clock, outer);
#endif
    return create(config, std::move(outer));
}

Result<std::unique_ptr<BackendWind>> BackendWind::create(const Config& config, std::shared_ptr<const Wind> outer) {
    auto wind = Wind::create(config, std::move(outer));
    if (!wind)
        return wind.failure();
    return std::unique_ptr<BackendWind>(std::make_unique<CpuWind>(std::make_unique<Wind>(*std::move(wind))));
}

Result<std::unique_ptr<BackendWind>> BackendWind::load(std::span<const std::byte> bytes, const ParallelFor& parallel_for,
                                                       std::shared_ptr<const Wind> outer) {
    auto wind = Wind::load(bytes, parallel_for, std::move(outer));
    if (!wind)
        return wind.failure();
    return std::unique_ptr<BackendWind>(std::make_unique<CpuWind>(std::make_unique<Wind>(*std::move(wind))));
}

WindView BackendWind::view() const {
    const WindReader& air = reader();
    if (const auto now = air.view(); now && !failed())
        return *now;
    broken_.assign(box().cell_count(), glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    return {box(), Window{.cells = box().cells, .cell_size = box().cell_size}, BlendZone{}, air.ambient_wind(), broken_};
}

} // namespace windrow::cases
