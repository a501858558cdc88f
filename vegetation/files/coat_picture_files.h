// The pictures of a coat from files: PNG, PGM, EXR and what else OpenImageIO reads.
//
//     auto pictures = fur::read_pictures(settings.maps, folder_of_the_scene, budget);
//     if (!pictures)
//         return std::fprintf(stderr, "%s\n", pictures.error().c_str()), 2;
//     auto coat = fur::Coat::create(device, targets, mesh, {}, settings, *pictures, body, anchor);
//
// A file is data from anywhere: its size is checked before memory is taken, and links that lead out of the folder are rejected.
#pragma once

#include "fluid/input_budget.h"
#include "vegetation/fur/coat_pictures.h"

#include <filesystem>

namespace windrow::vegetation::fur {

/// Files are relative to `folder`. A colour is converted to linear where its file has 8 bits and does not declare itself linear.
/// Rejects, with the file's name:
/// - a file that is not a picture, or that is outside of the folder;
/// - no texel, or more than k_most_picture_side of them along a side;
/// - a texel that is not finite.
/// - more bytes or memory than `budget` has left, which are those of a scene.
/// A map without a name gives an empty picture.
[[nodiscard]] windrow::Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder,
                                                          windrow::detail::InputBudget& budget);

} // namespace windrow::vegetation::fur
