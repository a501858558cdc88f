#include "vegetation/fur/strand_field.h"

#include "vegetation/render/refusals.h"

namespace windrow::vegetation::fur {

windrow::Result<void> validate(const StrandFieldSettings& settings) {
    render::Refusals refusals;
    const auto range = [&](const char* field, float value, double low, double high) { refusals.range(field, value, low, high); };
    range("strands.density", settings.density, 0.01, 1e5);
    range("strands.stretch", settings.stretch, 0.05, 20.0);
    range("strands.row_shift", settings.row_shift, 0.0, 0.5);
    refusals.range("strands.seed", settings.seed, 0.0, 1e6);
    range("strands.jitter", settings.jitter, 0.0, 1.0);
    range("strands.wriggle", settings.wriggle, 0.0, 1.0);
    range("strands.phase", settings.phase, -1e4, 1e4);
    range("strands.low", settings.low, 0.0, 1.0);
    range("strands.high", settings.high, 0.0, 1.0);
    if (settings.low > settings.high)
        refusals.add("strands.low is above strands.high: give them in order.");
    range("strands.thickness", settings.thickness, 0.0, 10.0);
    range("strands.cut_min", settings.cut_min, 0.0, 1.0);
    range("strands.cut_max", settings.cut_max, 0.0, 1.0);
    range("strands.cut_exponent", settings.cut_exponent, 1e-3, 10.0);
    range("strands.half_length", settings.half_length, 0.05, 1.0);
    range("strands.lift", settings.lift, 0.0, 1.0);
    range("strands.shaft", settings.shaft, 0.0, 0.5);
    range("strands.bow", settings.bow, 0.0, 0.5);
    range("strands.bow_turns", settings.bow_turns, -8.0, 8.0);
    range("strands.tuft", settings.tuft, 0.0, 0.9);
    range("strands.tuft_size", settings.tuft_size, 1.0, 1000.0);
    if (settings.profile > StrandProfile::edge)
        refusals.add("strands.profile is none of the three: give cone, centre or edge.");
    if (settings.shape > StrandShape::strip)
        refusals.add("strands.shape is none of the three: give round, oval or strip.");
    if (settings.shape != StrandShape::round && settings.half_length + settings.bow > 1.0f)
        refusals.add("strands.half_length and strands.bow make more than 1 cell, beyond which nothing is searched: lower one.");
    if (settings.shape != StrandShape::round && settings.profile == StrandProfile::edge)
        refusals.add(
            "strands.shape is not round, and strands.profile is edge, which has the shape of its cells: give another profile.");
    return refusals.result();
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
