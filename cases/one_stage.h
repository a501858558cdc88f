// One stage of the step alone: on the CPU the piece itself (fluid/operators.h), on a device a wind whose other stages are off.
#pragma once

#include "cases/whole_step.h"

#include <new>
#include <optional>
#include <span>

namespace windrow::cases {

class OneStage {
  public:
    /// Diffusion of `viscosity` [m^2/s].
    [[nodiscard]] static OneStage diffusion(const Box& box, double viscosity, const VerifySetting& setting) {
        OneStage stage(box, viscosity, setting);
        stage.make_wind({.sources = false, .relaxation = false, .diffusion = true, .advection = false, .projection = false});
        return stage;
    }
    [[nodiscard]] static OneStage projection(const Box& box, const VerifySetting& setting) {
        OneStage stage(box, std::nullopt, setting);
        stage.make_wind({.sources = false, .relaxation = false, .diffusion = false, .advection = false, .projection = true});
        return stage;
    }

    /// Legal sides of the same kinds.
    void set_boundaries(const Boundaries& boundaries) {
        const auto changed = wind_ ? wind_->set_boundaries(boundaries) : work_->set_boundaries(boundaries);
        if (!changed)
            setting_.backend.note_fault(changed.error());
    }
    /// `field` after dt [s] of the stage, up to 1 s; a projection takes no time.
    void run(CellVelocities& field, float dt = 1.0f) {
        if (wind_) {
            static_cast<void>(wind_->set_velocity(field)); // of the box's size
            wind_->step(dt);
            const std::span<const glm::vec4> after = wind_->field();
            field.assign(after.begin(), after.end());
        } else if (viscosity_) {
            next_.resize(field.size());
            if (!diffuse(*work_, field, static_cast<float>(*viscosity_), dt, next_))
                throw std::bad_alloc();
            std::swap(field, next_);
        } else {
            project(*work_, field);
        }
    }

  private:
    OneStage(const Box& box, std::optional<double> viscosity, const VerifySetting& setting)
        : box_(box), viscosity_(viscosity), setting_(setting) {}

    void make_wind(const Stages& stages) {
        if (setting_.backend.is_cpu()) {
            work_.emplace(workspace_of(box_, setting_));
            return;
        }
        Config config = raw_config(box_, viscosity_.value_or(0.0), setting_);
        config.stages = stages;
        wind_ = wind_of(config, setting_);
    }

    Box box_;
    std::optional<double> viscosity_; ///< nothing: the projection
    VerifySetting setting_;
    std::optional<Workspace> work_{};
    std::unique_ptr<BackendWind> wind_{};
    CellVelocities next_{};
};

} // namespace windrow::cases
