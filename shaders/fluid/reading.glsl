// Cells as textures and points show them: filled beside surfaces, and over the law of the wall (fluid/solids/reading.h, which makes
// the tables). Before this text: shown.glsl, and WINDROW_READING, the binding of the tables.
#include "numerics/slip.glsl"

layout(std430, set = 0, binding = WINDROW_READING) readonly buffer Reading {
    WindrowReading reading;
    int reading_words[];
};

// Passes of a wind without surfaces hold no code for them.
layout(constant_id = 9) const bool k_samples = false;

float reading_float(int at) { return intBitsToFloat(reading_words[at]); }
vec3 reading_vec3(int at) { return vec3(reading_float(at), reading_float(at + 1), reading_float(at + 2)); }

// Where the entry of a cell of the tables' box begins; -1: none.
int reading_entry(ivec3 place) {
    const int row = reading.rows + place.z * tick.cells.y + place.y, last = reading_words[row + 1];
    int first = reading_words[row], end = last;
    while (first < end) {
        const int middle = (first + end) / 2;
        if (reading_words[reading.columns + middle] < place.x)
            first = middle + 1;
        else
            end = middle;
    }
    return first < last && reading_words[reading.columns + first] == place.x ? reading.entries + WINDROW_READING_ENTRY * first
                                                                             : -1;
}

bool in_box(ivec3 cell) { return all(greaterThanEqual(cell, ivec3(0))) && inside(cell, tick.cells); }

struct SampledCell {
    vec3 velocity; // over the law's share
    float height;
    vec3 plain; // without the law
};

// `shift`: cells by which the box has moved since the tables were made.
SampledCell sampled_cell(ivec3 cell, float factor, ivec3 shift) {
    const vec3 own = shown_cell(cell_index(cell), factor).xyz;
    SampledCell sampled;
    sampled.velocity = sampled.plain = own;
    sampled.height = 0.0f;
    if (!k_samples || reading.on == 0)
        return sampled;
    if (reading.laws >= 0) {
        sampled.height = reading_float(reading.laws + 2 * cell.y);
        sampled.velocity = reading_float(reading.laws + 2 * cell.y + 1) * own;
    }
    const ivec3 place = cell + shift;
    const int entry = in_box(place) ? reading_entry(place) : -1;
    if (entry < 0)
        return sampled;
    const int count = reading_words[entry + 1];
    const float raise = reading_float(entry + 4);
    sampled.height = reading_float(entry + 3);
    if (count == 0) {
        sampled.velocity = raise * own;
        return sampled;
    }
    vec3 raised = vec3(0.0f), plain = vec3(0.0f);
    float lost = 0.0f;
    for (int n = 0; n < count; ++n) {
        const int term = reading.terms + WINDROW_READING_TERM * (reading_words[entry] + n), number = reading_words[term];
        const int row = number / tick.cells.x;
        const ivec3 from = ivec3(number - row * tick.cells.x, row % tick.cells.y, row / tick.cells.y) - shift;
        const float weight = reading_float(term + 1);
        if (!in_box(from)) {
            lost += weight;
            continue;
        }
        const vec3 u = shown_cell(cell_index(from), factor).xyz;
        plain += weight * u;
        raised += reading_float(term + 2) * u;
    }
    const float whole = lost > 0.0f && lost < 1.0f ? 1.0f / (1.0f - lost) : 1.0f;
    const int wall = reading.walls + WINDROW_READING_WALL * reading_words[entry + 2];
    const vec3 normal = reading_vec3(wall), velocity = reading_vec3(wall + 4);
    const float across = reading_float(wall + 3), keep = reading_float(wall + 7);
    sampled.plain = windrow_beside_surface(whole * plain, normal, across, velocity, keep);
    sampled.velocity = windrow_beside_surface(whole * raised, normal, raise * across, raise * velocity, keep);
    return sampled;
}
