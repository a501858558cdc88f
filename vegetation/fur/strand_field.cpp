#include "vegetation/fur/strand_field.h"

#include "fluid/core/validation.h"

namespace windrow::vegetation::fur {

using windrow::detail::FieldPath, windrow::detail::Reasons;

windrow::Result<void> validate(const StrandFieldSettings& settings) {
    return windrow::detail::validate_settings(settings, "strands");
}

void check_rules(Reasons& reasons, const FieldPath& path, const StrandFieldSettings& settings) {
    if (settings.low > settings.high)
        reasons.add(FieldPath{&path, "low"}, " is ", settings.low, ": give at most ", FieldPath{&path, "high"}, ", which is ",
                    settings.high, ".");
    if (settings.shape == StrandShape::round)
        return;
    if (settings.half_length + settings.bow > 1.0f)
        reasons.add(FieldPath{&path, "half_length"}, " and bow make ", settings.half_length + settings.bow,
                    " cells: lower one, since the search ends at 1.");
    if (settings.profile == StrandProfile::edge)
        reasons.add(FieldPath{&path, "shape"},
                    " is not round beside the profile edge, which has the shape of its cells: give another profile.");
}

StrandFieldBlock block(const StrandFieldSettings& settings) {
    // Where rows are shifted by half a cell, the whole jitter leaves one place in 1e5 with an edge toward a point beyond the nine
    // cells that are searched; nine tenths of it none (vegetation/tests/fur/strand_cells_test.cpp).
    const float jitter = settings.jitter * (1.0f - 0.2f * settings.row_shift);
    StrandFieldBlock field{};
    field.cells = {settings.density, settings.stretch, settings.row_shift, static_cast<float>(settings.seed)};
    field.points = {jitter, settings.wriggle, settings.phase, static_cast<float>(settings.profile)};
    field.reach = {settings.low, settings.high, settings.lift, static_cast<float>(settings.shape)};
    field.cut = {settings.cut_min, settings.cut_max, settings.cut_exponent, settings.half_length};
    if (settings.profile == StrandProfile::cone)
        field.cut = {settings.thickness, 0.0f, 1.0f, settings.half_length};
    field.bow = {settings.bow, settings.bow_turns, settings.tuft, 1.0f / settings.tuft_size};
    field.shaft = {settings.shaft, 0.0f, 0.0f, 0.0f};
    return field;
}

StrandHit strand_at(const StrandFieldBlock& field, glm::vec2 uv, float h) {
    return numerics::windrow_strand_uv(field, uv, h);
}

StrandHit strand_on(const StrandFieldBlock& field, glm::vec3 x, glm::vec3 n, float h) {
    return numerics::windrow_strand_surface(field, x, n, h);
}

float strand_top(const StrandFieldSettings& settings) {
    return numerics::windrow_strand_top(block(settings));
}

bool layer_empty(const StrandFieldSettings& settings, float h) {
    return numerics::windrow_layer_empty(block(settings), h);
}

} // namespace windrow::vegetation::fur
