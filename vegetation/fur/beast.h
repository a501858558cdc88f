// A wolf-like beast, far larger than a wolf: capsules for its flesh, and bones that walk. It stands on y = 0 and looks along +z.
#pragma once

#include "../../fluid/setting.h"
#include "mesh.h"
#include "skeleton.h"

#include <array>
#include <cstdint>

namespace windrow::vegetation::fur {

enum class BeastGait : std::uint8_t { walk, gallop };

struct Beast {
    static constexpr const char* k_name = "beast";
    static constexpr const char* k_meaning = "A wolf-like beast on y = 0 that looks along +z.";
    float height = 2.0f;
    int detail = 23;

    static constexpr auto settings() {
        return std::tuple{
            Setting("height", &Beast::height, {0.1, 20.0, "m"}, "At the withers; a wolf has 0.8."),
            Setting("detail", &Beast::detail, {20.0, 120.0},
                    "Cells of the skin along that height; below 20 the legs fall apart. 23 has 3,236 vertices, about as many as "
                    "the horse of the shell fur thesis; 40 suits a picture from near."),
        };
    }
};

/// Closed, normals from the flesh's slope; without a map of its own (has_uv is false, uv is a box projection).
[[nodiscard]] Result<Mesh> beast_mesh(const Beast& beast = {});

/// Bones that fit the mesh, in `hz` strides a second, 0 to 5; 0 stands still in mid-stride. Walk: left hind, left fore, right hind,
/// right fore, a quarter of a stride apart, as wolves set their feet. Gallop: the hind feet, then the fore feet, each pair a tenth of a
/// stride apart, the back bent and stretched once a stride, which is some 3 heights long.
[[nodiscard]] Result<Skeleton> beast_skeleton(const Beast& beast = {}, float hz = 0.8f, BeastGait gait = BeastGait::walk);

} // namespace windrow::vegetation::fur

template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::vegetation::fur::BeastGait>{"walk", "gallop"};
