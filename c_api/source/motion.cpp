// Calls of motion.h.
#include "c_api/motion.h"

#include "c_api/source/plant_tables.h"
#include "coupling/cascade_step.h"
#include "fluid/core/message.h"

#include <array>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

struct windrow_cascade_step {
    CascadeStep step;
};
struct windrow_cascade {
    Cascade cascade;
};
struct windrow_ground {
    GroundMemory ground;
};

namespace {

constexpr std::array k_springs{springs::grass, springs::wheat, springs::alfalfa, springs::reed,
                               springs::leaf,  springs::twig,  springs::branch,  springs::trunk};

template <class Real>
windrow_result advance(const windrow_spring_step* step, const windrow_spring_batch* batch,
                       const windrow_parallel_for* parallel_for) {
    return call({{step, "step"}, {batch, "batch"}}, [&]() -> Result<void> {
        const std::uint64_t count = batch->count;
        for (const void* array : {static_cast<const void*>(batch->place), static_cast<const void*>(batch->velocity),
                                  batch->target_before, batch->target_now})
            if (array == nullptr && count > 0)
                return Error{detail::message("batch lacks an array: give place, velocity, target_before and target_now of ",
                                             count, " numbers.")};
        return advance_springs<Real>(plain(*step),
                                     {.place = numbers<Real>(batch->place, count),
                                      .velocity = numbers<Real>(batch->velocity, count),
                                      .target_before = numbers<const Real>(batch->target_before, count),
                                      .target_now = numbers<const Real>(batch->target_now, count),
                                      .place_remainder = numbers<Real>(batch->place_remainder, count),
                                      .velocity_remainder = numbers<Real>(batch->velocity_remainder, count),
                                      .place_previous = numbers<Real>(batch->place_previous, count)},
                                     loop_of(parallel_for));
    });
}

template <class Real>
windrow_result advance(const windrow_cascade_step* step, const windrow_cascade_batch* batch,
                       const windrow_parallel_for* parallel_for) {
    return call({{step, "step"}, {batch, "batch"}}, [&]() -> Result<void> {
        const std::uint64_t rows = batch->rows;
        for (const void* array : {static_cast<const void*>(batch->value), batch->body_before, batch->body_now})
            if (array == nullptr && rows > 0)
                return Error{detail::message("batch lacks an array: give value, body_before and body_now for ", rows, " rows.")};
        const std::uint64_t values = rows * static_cast<std::uint64_t>(step->step.stages());
        return advance_cascades<Real>(step->step,
                                      {.value = numbers<Real>(batch->value, values),
                                       .body_before = numbers<const Real>(batch->body_before, rows),
                                       .body_now = numbers<const Real>(batch->body_now, rows),
                                       .remainder = numbers<Real>(batch->remainder, values)},
                                      loop_of(parallel_for));
    });
}

windrow_result give_poses(std::span<const PoseBlock> made, const windrow_pose_block** poses, uint64_t* count) {
    *poses = same_layout<const windrow_pose_block>(made.data());
    *count = made.size();
    return WINDROW_OK;
}

const windrow_vec4* texels_of(std::span<const glm::vec4> texels, uint64_t* count) {
    if (count != nullptr)
        *count = texels.size();
    return same_layout<const windrow_vec4>(texels.data());
}

} // namespace

// --- Springs -------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_spring_class_of(windrow_spring_plant plant, windrow_spring_class* spring) {
    return call({{spring, "spring"}}, [&]() -> windrow_result {
        if (plant < 0 || plant >= static_cast<int>(k_springs.size()))
            return fail(WINDROW_REJECTED, detail::message("plant is ", plant, ": give 0 to ", k_springs.size() - 1, "."));
        write_fields(k_springs[static_cast<std::size_t>(plant)], *spring);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_spring_step_make(const windrow_spring_class* spring, double duration,
                                                       windrow_spring_step* step) {
    return call({{spring, "spring"}, {step, "step"}}, [&] {
        const Result<SpringStep> made = spring_step(plain(*spring), duration);
        if (made)
            write_fields(*made, *step);
        return done(made);
    });
}
WINDROW_EXPORT windrow_result windrow_spring_step_block(const windrow_spring_step* step, windrow_spring_block* block) {
    return call({{step, "step"}, {block, "block"}}, [&]() -> windrow_result {
        copy_block(plain(*step).block(), block);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_swing_step_make(const windrow_spring_class* spring, double duration,
                                                      windrow_swing_block* block) {
    return call({{spring, "spring"}, {block, "block"}}, [&] {
        const Result<SwingBlock> made = swing_step(plain(*spring), duration);
        if (made)
            copy_block(*made, block);
        return done(made);
    });
}
WINDROW_EXPORT windrow_result windrow_spring_bands(const windrow_spring_class* spring, windrow_spring_class* bands) {
    return call({{spring, "spring"}, {bands, "bands"}}, [&] {
        const auto made = spring_bands(plain(*spring));
        if (made)
            for (std::size_t band = 0; band < made->size(); ++band)
                write_fields((*made)[band], bands[band]);
        return done(made);
    });
}
WINDROW_EXPORT windrow_result windrow_swing_steps_make(const windrow_spring_class* spring, double duration,
                                                       windrow_swing_block* blocks) {
    return call({{spring, "spring"}, {blocks, "blocks"}}, [&] {
        const auto made = swing_steps(plain(*spring), duration);
        if (made)
            for (std::size_t band = 0; band < made->size(); ++band)
                copy_block((*made)[band], &blocks[band]);
        return done(made);
    });
}
WINDROW_EXPORT windrow_result windrow_flutter_step_make(const windrow_flutter_class* flutter, double time, double duration,
                                                        windrow_flutter_block* block) {
    return call({{block, "block"}}, [&] {
        const Result<FlutterBlock> made = flutter_step(flutter != nullptr ? plain(*flutter) : FlutterClass{}, time, duration);
        if (made)
            copy_block(*made, block);
        return done(made);
    });
}
WINDROW_EXPORT windrow_result windrow_springs_advance_float(const windrow_spring_step* step, const windrow_spring_batch* batch,
                                                            const windrow_parallel_for* parallel_for) {
    return advance<float>(step, batch, parallel_for);
}
WINDROW_EXPORT windrow_result windrow_springs_advance_double(const windrow_spring_step* step, const windrow_spring_batch* batch,
                                                             const windrow_parallel_for* parallel_for) {
    return advance<double>(step, batch, parallel_for);
}

// --- Cascades ------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_cascade_step_create(int32_t stages, windrow_cascade_step** step) {
    return create(step, [&] { return CascadeStep::create(stages); });
}
WINDROW_EXPORT void windrow_cascade_step_destroy(windrow_cascade_step* step) {
    delete step;
}
WINDROW_EXPORT windrow_result windrow_cascade_step_set(windrow_cascade_step* step, double rate, double duration) {
    return call({{step, "step"}}, [&] { return step->step.set(rate, duration); });
}
WINDROW_EXPORT windrow_result windrow_cascades_advance_float(const windrow_cascade_step* step, const windrow_cascade_batch* batch,
                                                             const windrow_parallel_for* parallel_for) {
    return advance<float>(step, batch, parallel_for);
}
WINDROW_EXPORT windrow_result windrow_cascades_advance_double(const windrow_cascade_step* step,
                                                              const windrow_cascade_batch* batch,
                                                              const windrow_parallel_for* parallel_for) {
    return advance<double>(step, batch, parallel_for);
}

WINDROW_C_INIT(windrow_cascade_config)
WINDROW_EXPORT windrow_result windrow_cascade_create(const windrow_cascade_config* config, const windrow_pose* body,
                                                     windrow_cascade** cascade) {
    if (cascade != nullptr)
        *cascade = nullptr;
    return call({{body, "body"}}, [&] {
        return create_from(config, cascade, [&](const CascadeConfig& wanted) { return Cascade::create(wanted, plain(*body)); });
    });
}
WINDROW_EXPORT void windrow_cascade_destroy(windrow_cascade* cascade) {
    delete cascade;
}
WINDROW_EXPORT windrow_result windrow_cascade_save(const windrow_cascade* cascade, windrow_bytes** bytes) {
    return cascade == nullptr ? fail_null("cascade") : create(bytes, [&] { return cascade->cascade.save(); });
}
WINDROW_EXPORT windrow_result windrow_cascade_load(const void* bytes, uint64_t size, windrow_cascade** cascade) {
    if (cascade != nullptr)
        *cascade = nullptr;
    return call({{bytes, "bytes"}}, [&] {
        return create(cascade, [&] {
            return Cascade::load(std::span(static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_cascade_advance(windrow_cascade* cascade, double duration, const windrow_pose* body) {
    return call({{cascade, "cascade"}, {body, "body"}}, [&] { return cascade->cascade.advance(duration, plain(*body)); });
}
WINDROW_EXPORT windrow_result windrow_cascade_reset(windrow_cascade* cascade, const windrow_pose* body) {
    return call({{cascade, "cascade"}, {body, "body"}}, [&] { return cascade->cascade.reset(plain(*body)); });
}
WINDROW_EXPORT windrow_result windrow_cascade_move(windrow_cascade* cascade, windrow_dvec3 offset) {
    return call({{cascade, "cascade"}}, [&] { return cascade->cascade.move(to_cpp(offset)); });
}
WINDROW_EXPORT windrow_result windrow_cascade_at(const windrow_cascade* cascade, double height, windrow_pose* pose) {
    return call({{cascade, "cascade"}, {pose, "pose"}}, [&]() -> windrow_result {
        write_fields(cascade->cascade.at(height), *pose);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_cascade_previous_at(const windrow_cascade* cascade, double height, windrow_pose* pose) {
    return call({{cascade, "cascade"}, {pose, "pose"}}, [&]() -> windrow_result {
        write_fields(cascade->cascade.previous_at(height), *pose);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_cascade_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor,
                                                           const windrow_pose_block** poses, uint64_t* count) {
    return call({{cascade, "cascade"}, {poses, "poses"}, {count, "count"}},
                [&] { return give_poses(cascade->cascade.shader_poses(to_cpp(anchor)), poses, count); });
}
WINDROW_EXPORT windrow_result windrow_cascade_previous_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor,
                                                                    const windrow_pose_block** poses, uint64_t* count) {
    return call({{cascade, "cascade"}, {poses, "poses"}, {count, "count"}},
                [&] { return give_poses(cascade->cascade.previous_shader_poses(to_cpp(anchor)), poses, count); });
}

// --- Ground memory -------------------------------------------------------------------------------------------------------
WINDROW_C_INIT(windrow_ground_config)
WINDROW_C_INIT(windrow_ground_step)
WINDROW_EXPORT windrow_result windrow_ground_create(const windrow_ground_config* config, const windrow_parallel_for* parallel_for,
                                                    windrow_ground** ground) {
    return create_from(config, ground,
                       [&](const GroundConfig& wanted) { return GroundMemory::create(wanted, loop_of(parallel_for)); });
}
WINDROW_EXPORT void windrow_ground_destroy(windrow_ground* ground) {
    delete ground;
}
WINDROW_EXPORT windrow_result windrow_ground_save(const windrow_ground* ground, windrow_bytes** bytes) {
    return ground == nullptr ? fail_null("ground") : create(bytes, [&] { return ground->ground.save(); });
}
WINDROW_EXPORT windrow_result windrow_ground_load(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                                  windrow_ground** ground) {
    if (ground != nullptr)
        *ground = nullptr;
    return call({{bytes, "bytes"}}, [&] {
        return create(ground, [&] {
            return GroundMemory::load(std::span(static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)),
                                      loop_of(parallel_for));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_ground_follow(windrow_ground* ground, windrow_dvec3 point) {
    return call({{ground, "ground"}}, [&] { return ground->ground.follow(to_cpp(point)); });
}
WINDROW_EXPORT windrow_result windrow_ground_shift_origin(windrow_ground* ground, windrow_dvec3 offset) {
    return call({{ground, "ground"}}, [&] { return ground->ground.shift_origin(to_cpp(offset)); });
}
WINDROW_EXPORT windrow_result windrow_ground_advance(windrow_ground* ground, const windrow_ground_step* step,
                                                     const windrow_vec2* wind_leans, uint64_t count) {
    return call({{ground, "ground"}, {step, "step"}}, [&] {
        return with_ground_step(step, [&](const GroundStep& wanted) {
            return wind_leans != nullptr ? ground->ground.advance(wanted, span_of<const glm::vec2>(wind_leans, count))
                                         : ground->ground.advance(wanted);
        });
    });
}
WINDROW_EXPORT int32_t windrow_ground_walkers_left_out(const windrow_ground* ground) {
    return value_of(ground, "ground", [&] { return ground->ground.walkers_left_out(); });
}
WINDROW_EXPORT windrow_dvec2 windrow_ground_next_centre(const windrow_ground* ground, windrow_ivec2 slot) {
    return value_of(ground, "ground", [&] { return to_c(ground->ground.next_centre(to_cpp(slot))); });
}
WINDROW_EXPORT windrow_result windrow_ground_at(const windrow_ground* ground, windrow_dvec3 position,
                                                windrow_ground_sample* sample) {
    return call({{ground, "ground"}, {sample, "sample"}}, [&]() -> windrow_result {
        write_fields(ground->ground.at(to_cpp(position)), *sample);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_ground_previous_at(const windrow_ground* ground, windrow_dvec3 position,
                                                         windrow_ground_sample* sample) {
    return call({{ground, "ground"}, {sample, "sample"}}, [&]() -> windrow_result {
        write_fields(ground->ground.previous_at(to_cpp(position)), *sample);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT const windrow_vec4* windrow_ground_texels(const windrow_ground* ground, uint64_t* count) {
    return value_of(ground, "ground", [&] { return texels_of(ground->ground.texels(), count); });
}
WINDROW_EXPORT const windrow_vec4* windrow_ground_previous_texels(const windrow_ground* ground, uint64_t* count) {
    return value_of(ground, "ground", [&] { return texels_of(ground->ground.previous_texels(), count); });
}
WINDROW_EXPORT windrow_result windrow_ground_block_of(const windrow_ground* ground, windrow_dvec3 anchor,
                                                      windrow_ground_block* block) {
    return call({{ground, "ground"}, {block, "block"}}, [&]() -> windrow_result {
        copy_block(ground->ground.block(to_cpp(anchor)), block);
        return WINDROW_OK;
    });
}
