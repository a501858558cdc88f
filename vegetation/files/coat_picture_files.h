// The pictures of a coat from files: PNG, PGM, EXR and what else OpenImageIO reads.
//
//     auto pictures = fur::read_pictures(settings.maps, folder_of_the_scene);
//     if (!pictures)
//         return std::fprintf(stderr, "%s\n", pictures.error().c_str()), 2;
//     auto coat = fur::Coat::create(device, targets, mesh, {}, settings, *pictures, body, anchor);
//
// A file is data from anywhere: its size is checked before memory is taken, and OpenImageIO decodes it from memory.
#pragma once

#include "fluid/files/input_budget.h"
#include "vegetation/fur/coat_pictures.h"

#include <filesystem>

namespace windrow::vegetation::fur {

/// Files are relative to `folder`. A colour is converted to linear where its file has 8 bits and does not declare itself linear.
/// Rejects, with the file's name:
/// - a file that is not a picture, or that is outside of the folder;
/// - no texel, or more than k_max_picture_side of them along a side;
/// - a texel that is not finite.
/// A map without a name gives an empty picture. The files and their texels take their part of a scene's `budget`.
[[nodiscard]] windrow::Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder,
                                                          windrow::detail::InputBudget& budget);
/// The same with a budget of its own, for maps that no scene names.
[[nodiscard]] windrow::Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder);

} // namespace windrow::vegetation::fur
