#include "vegetation/program/furred_body.h"

#include "vegetation/files/coat_picture_files.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace windrow::vegetation::program {
namespace {

using windrow::Error;
using windrow::Result;

struct MakeMesh {
    std::filesystem::path folder;
    windrow::detail::InputBudget& budget;

    Result<fur::Mesh> operator()(const MeshSource& source) const {
        fur::MeshLoad load = source.load;
        return fur::read_mesh(folder / std::filesystem::path(source.name).lexically_normal(), load, folder, budget);
    }
    Result<fur::Mesh> operator()(const fur::Sheet& shape) const { return fur::sheet(shape); }
    Result<fur::Mesh> operator()(const fur::GlobeSphere& shape) const { return fur::globe_sphere(shape); }
    Result<fur::Mesh> operator()(const fur::CubeSphere& shape) const { return fur::cube_sphere(shape); }
    Result<fur::Mesh> operator()(const fur::Wing& shape) const { return fur::wing(shape); }
    Result<fur::Mesh> operator()(const fur::Beast& shape) const { return fur::beast_mesh(shape); }
};

// [s] How often a frame tells the tips' lag where the body is: its way is taken as straight between.
constexpr double k_longest_step = 1.0 / 960.0;

std::vector<glm::mat4> bones_of(const Body& body, const BodyModel& model, double time) {
    if (!model.skeleton)
        return {};
    return fur::pose(*model.skeleton, body.skeleton.pace * time + body.skeleton.phase);
}

} // namespace

Result<BodyModel> model_of(const PictureScene& scene, const Body& body, windrow::detail::InputBudget& budget) {
    BodyModel model;
    auto mesh = std::visit(MakeMesh{scene.air.file.parent_path(), budget}, body.mesh);
    if (!mesh)
        return mesh.failure();
    model.mesh = *std::move(mesh);
    switch (body.skeleton.kind) {
    case SkeletonKind::none:
        return model;
    case SkeletonKind::beast: {
        const auto* beast = std::get_if<fur::Beast>(&body.mesh);
        auto bones = fur::beast_skeleton(beast != nullptr ? *beast : fur::Beast{}, 0.8f, body.skeleton.gait);
        if (!bones)
            return bones.failure();
        model.skeleton = *std::move(bones);
        break;
    }
    case SkeletonKind::horse: {
        const auto* file = std::get_if<MeshSource>(&body.mesh);
        auto bones = fur::horse_skeleton(file != nullptr ? file->load.size : 1.0f);
        if (!bones)
            return bones.failure();
        model.skeleton = *std::move(bones);
        break;
    }
    case SkeletonKind::own:
        model.skeleton = fur::Skeleton{body.skeleton.bones};
        break;
    }
    if (auto bound = fur::bind(model.mesh, *model.skeleton); !bound)
        return bound.failure();
    return model;
}

Result<std::vector<fur::MeshPart>> parts_of(const fur::Mesh& mesh, const BodyCoat& coat) {
    std::vector<fur::MeshPart> parts;
    std::string names;
    for (const fur::MeshPart& part : mesh.parts) {
        if (coat.material.empty() || part.material == coat.material)
            parts.push_back(part);
        names += (names.empty() ? "\"" : ", \"") + part.material + "\"";
    }
    if (parts.empty())
        return Error{"material is \"" + coat.material + "\", and the mesh has " + names +
                     "; name one of these, or none for all."};
    return parts;
}

glm::dvec2 drift_of(const PictureScene& scene, const Body& body, double time) {
    const windrow::Config& air = scene.air.air;
    const double ground = scene.air.has_floor() ? scene.air.floor_height(0.0) : 0.0;
    const auto wind = windrow::AmbientWind::create({.mean = air.ambient, .profile = air.profile, .ground = ground});
    if (!wind)
        return glm::dvec2(0.0);
    const glm::vec3 speed = wind->velocity(pose_of(scene, body, 0.0).position);
    return time * glm::dvec2(speed.x, speed.z);
}

Result<FurredBodies> FurredBodies::create(engine::Device& device, const render::DrawTargets& targets, const PictureScene& scene,
                                          glm::dvec3 anchor) {
    FurredBodies made(scene);
    for (const Body& body : scene.picture.bodies)
        if (auto furred = made.dress(device, targets, body, anchor); !furred)
            return furred.failure().after("$.picture.bodies, " + body.name + ": ");
    return made;
}

Result<void> FurredBodies::dress(engine::Device& device, const render::DrawTargets& targets, const Body& body,
                                 glm::dvec3 anchor) {
    auto model = model_of(*scene_, body, inputs_);
    if (!model)
        return model.failure();
    Furred furred{.body = &body, .model = *std::move(model), .coats = {}};
    for (const BodyCoat& worn : body.coats) {
        const auto parts = parts_of(furred.model.mesh, worn);
        if (!parts)
            return parts.failure();
        std::optional<fur::FurLine> fur;
        for (const fur::MeshPart& part : *parts)
            if (part.fur && !fur)
                fur = part.fur;
        const fur::CoatSettings settings = settings_of(worn, fur);
        const auto pictures = fur::read_pictures(settings.maps, scene_->air.file.parent_path(), inputs_);
        if (!pictures)
            return pictures.failure();
        auto coat = fur::Coat::create(device, targets, furred.model.mesh, *parts, settings, *pictures,
                                      pose_of(*scene_, body, 0.0), anchor);
        if (!coat)
            return coat.failure();
        if (auto lit = (*coat)->set_lamps(scene_->picture.lamps); !lit)
            return lit;
        furred.coats.push_back(*std::move(coat));
    }
    furred_.push_back(std::move(furred));
    return move(furred_.back(), 0.0, 0.0);
}

void FurredBodies::add_to(render::Renderer& renderer) {
    for (const Furred& furred : furred_)
        for (const auto& coat : furred.coats)
            renderer.add(*coat);
}

Result<void> FurredBodies::move(const Furred& furred, double time, double seconds) {
    const std::vector<glm::mat4> bones = bones_of(*furred.body, furred.model, time);
    fur::CoatAhead ahead;
    ahead.body = pose_of(*scene_, *furred.body, time + ahead.seconds);
    const std::vector<glm::mat4> bones_ahead = bones_of(*furred.body, furred.model, time + ahead.seconds);
    ahead.bones = bones_ahead;
    for (const auto& coat : furred.coats) {
        const int steps =
            coat->settings().inertia ? std::max(1, static_cast<int>(std::ceil(seconds / k_longest_step - 1e-6))) : 1;
        if (std::abs(time - seconds - time_) > 1e-9) // begins elsewhere: tips rest there
            if (auto placed = coat->move(0.0, pose_of(*scene_, *furred.body, time - seconds)); !placed)
                return placed.failure().after("$.picture.bodies, " + furred.body->name + ": ");
        for (int step = 1; step <= steps; ++step) {
            const bool last = step == steps;
            const double at = last ? time : time - seconds * (steps - step) / steps;
            const auto moved = last ? coat->move(seconds / steps, pose_of(*scene_, *furred.body, at), bones, ahead)
                                    : coat->move(seconds / steps, pose_of(*scene_, *furred.body, at));
            if (!moved)
                return moved.failure().after("$.picture.bodies, " + furred.body->name + ": ");
        }
        coat->set_time(time);
        if (coat->settings().drifts)
            coat->drift(drift_of(*scene_, *furred.body, time));
    }
    return {};
}

std::vector<fur::Foot> feet_of(const PictureScene& scene, double time) {
    std::vector<fur::Foot> feet;
    for (const Walker& walker : scene.picture.walkers) {
        if (feet.size() == fur::k_max_feet)
            break;
        const windrow::GroundWalker now = walker_at(scene, walker, time, time);
        const double floor = scene.picture.ground.height(now.position.x, now.position.z);
        feet.push_back({.position = {now.position.x, floor + static_cast<double>(now.foot_height), now.position.z},
                        .radius = now.radius,
                        .weight = now.weight});
    }
    return feet;
}

Result<void> FurredBodies::move(double time, double seconds) {
    const std::vector<fur::Foot> feet = feet_of(*scene_, time);
    for (const Furred& furred : furred_)
        for (const auto& coat : furred.coats)
            if (auto felt = coat->set_feet(feet); !felt)
                return felt.failure().after("$.picture.walkers: ");
    const bool there = seconds <= 0.0 && std::abs(time - time_) <= 1e-9; // after a seek they are elsewhere
    for (const Furred& furred : furred_)
        if (auto moved = there ? Result<void>{} : move(furred, time, seconds); !moved)
            return moved;
    time_ = time;
    return {};
}

void FurredBodies::append_to(std::vector<render::Drawable*>& drawables) const {
    for (const Furred& furred : furred_)
        for (const auto& coat : furred.coats)
            drawables.push_back(coat.get());
}

std::vector<const fur::Coat*> FurredBodies::coats() const {
    std::vector<const fur::Coat*> all;
    for (const Furred& furred : furred_)
        for (const auto& coat : furred.coats)
            all.push_back(coat.get());
    return all;
}

} // namespace windrow::vegetation::program
