#include "vegetation/grass/grass_settings.h"

#include "vegetation/grass/refusals.h"

namespace windrow::vegetation::grass {

windrow::Result<void> validate(const GrassSettings& settings) {
    Refusals refusals;
    const auto between = [&](const char* field, float value, double least, double most, const char* unit) {
        refusals.between(field, static_cast<double>(value), least, most, unit);
    };
    if (auto fits = windrow::validate(settings.blade); !fits)
        refusals.add(fits.error());
    between("grass.density", settings.density, 0.1, 64.0, " 1/m");
    between("grass.jitter", settings.jitter, 0.0, 1.0, "");
    refusals.between("grass.chunk_cells", settings.chunk_cells, 8, 256, "");
    between("grass.split_distance", settings.split_distance, 1e-3, 1e4, " m");
    between("grass.cut_distance", settings.cut_distance, 1e-3, 1e4, " m");
    if (!(settings.split_distance < settings.cut_distance))
        refusals.add("grass.split_distance is " + text(static_cast<double>(settings.split_distance)) +
                     " m: give less than grass.cut_distance, which is " + text(static_cast<double>(settings.cut_distance)) +
                     " m.");
    between("grass.morph_from", settings.morph_from, 0.0, 0.99, "");
    between("grass.fade_from", settings.fade_from, 0.0, 0.99, "");
    between("grass.shadow_distance", settings.shadow_distance, 0.0, 1e4, " m");
    between("grass.least_width", settings.least_width, 0.0, 0.01, " rad");
    between("grass.thin_from", settings.thin_from, 0.1, 1e4, " m");
    between("grass.thin_power", settings.thin_power, 0.0, 3.0, "");
    between("grass.thin_widen", settings.thin_widen, 0.0, 1.0, "");
    between("grass.clump_size", settings.clump_size, 0.01, 100.0, " m");
    between("grass.clump_height", settings.clump_height, 0.0, 0.9, "");
    between("grass.clump_lean", settings.clump_lean, 0.0, 1.0, "");
    between("grass.clump_fan", settings.clump_fan, 0.0, 1.0, "");
    between("grass.patch_size", settings.patch_size, 0.1, 1000.0, " m");
    between("grass.patch_height", settings.patch_height, 0.0, 0.9, "");
    refusals.between("grass.most_chunks", settings.most_chunks, 1, 32767, "");
    return refusals.outcome();
}

} // namespace windrow::vegetation::grass
