#include "vegetation/fur/coat_pictures.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <glm/packing.hpp>

namespace windrow::vegetation::fur {
namespace {

using windrow::Error;
using windrow::Result;

Result<void> judged(const CoatPicture& picture, const char* name) {
    const std::string field = std::string("pictures.") + name;
    if (picture.columns < 0 || picture.rows < 0 || picture.columns > k_max_picture_side || picture.rows > k_max_picture_side)
        return Error{detail::message(field, " is ", picture.columns, " x ", picture.rows, " texels; give at most ",
                                     k_max_picture_side, " a side.")};
    const auto wanted = static_cast<std::size_t>(picture.columns) * static_cast<std::size_t>(picture.rows);
    if (picture.texels.size() != wanted)
        return Error{detail::message(field, " has ", picture.texels.size(), " texels; give columns times rows, ", wanted, ".")};
    for (const glm::vec4& texel : picture.texels)
        for (int channel = 0; channel < 3; ++channel)
            if (!std::isfinite(texel[channel]))
                return Error{field + " has a texel that is not finite; give finite numbers."};
    return {};
}

CoatPicture halved(const CoatPicture& picture) {
    CoatPicture made{std::max(picture.columns / 2, 1), std::max(picture.rows / 2, 1), {}};
    made.texels.reserve(static_cast<std::size_t>(made.columns) * static_cast<std::size_t>(made.rows));
    for (int row = 0; row < made.rows; ++row)
        for (int column = 0; column < made.columns; ++column) {
            glm::vec4 sum(0.0f);
            for (int part = 0; part < 4; ++part) {
                const int x = std::min(2 * column + part % 2, picture.columns - 1),
                          y = std::min(2 * row + part / 2, picture.rows - 1);
                sum += picture.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.columns) +
                                      static_cast<std::size_t>(x)];
            }
            made.texels.push_back(0.25f * sum);
        }
    return made;
}

} // namespace

Result<void> validate(const CoatPictures& pictures) {
    if (auto each = judged(pictures.length, "length"); !each)
        return each;
    if (auto each = judged(pictures.colour, "colour"); !each)
        return each;
    if (auto each = judged(pictures.noise_a, "noise_a"); !each)
        return each;
    return judged(pictures.noise_b, "noise_b");
}

PackedPictures packed(const CoatPictures& pictures) {
    PackedPictures made;
    const std::array all{&pictures.length, &pictures.colour, &pictures.noise_a, &pictures.noise_b};
    for (std::size_t n = 0; n < all.size(); ++n) {
        CoatPicture level = *all[n];
        if (level.texels.empty())
            continue;
        made.places[n] = {static_cast<int>(made.texels.size()), level.columns, level.rows, 0};
        for (;; level = halved(level)) {
            ++made.places[n].w;
            for (const glm::vec4& texel : level.texels)
                made.texels.emplace_back(glm::packHalf2x16({texel.x, texel.y}), glm::packHalf2x16({texel.z, texel.w}));
            if (level.columns == 1 && level.rows == 1)
                break;
        }
    }
    if (made.texels.empty())
        made.texels.emplace_back(0u, 0u);
    return made;
}

std::uint64_t packed_bytes(const CoatPictures& pictures) {
    std::uint64_t texels = 0;
    for (const CoatPicture* picture : {&pictures.length, &pictures.colour, &pictures.noise_a, &pictures.noise_b}) {
        if (picture->texels.empty())
            continue;
        for (int columns = picture->columns, rows = picture->rows;;
             columns = std::max(columns / 2, 1), rows = std::max(rows / 2, 1)) {
            texels += static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
            if (columns == 1 && rows == 1)
                break;
        }
    }
    return std::max<std::uint64_t>(texels, 1) * sizeof(glm::uvec2);
}

} // namespace windrow::vegetation::fur
