#include "coupling/ground_config.h"
#include "coupling/ground_host.h"
#include "fluid/core/message.h"

#include <cmath>
#include <optional>

namespace windrow::detail {
namespace {

constexpr Format k_format{"WINDTRAI", Layout("ground 2").with<GroundConfig>().version(), "saved ground", "GroundMemory::save"};

template <class Archive, class Ground>
void fields(Archive& archive, Ground& ground) {
    constexpr bool reads = Reading<Archive>;
    constexpr float k_most_lean = 1e6f, k_most_velocity = 1e10f; // beyond what springs reach
    const auto within = [](const auto& vector, float most) {
        for (int n = 0; n < vector.length(); ++n)
            if (!(std::abs(vector[n]) <= most))
                return false;
        return true;
    };
    GroundHost::fields(archive, ground.host);
    archive(ground.stepped);
    if constexpr (reads)
        if (!archive.can_hold(ground.texels.size(), 13 * sizeof(float)))
            return;
    for (std::size_t n = 0; n < ground.texels.size(); ++n) {
        auto& texel = ground.texels[n];
        auto& lean = ground.leans_before[n];
        auto& shown = ground.shown_before[n];
        archive(texel.lean, texel.velocity, texel.trail, texel.trample, lean, shown);
        if constexpr (reads)
            archive.require(within(texel.lean, k_most_lean) && within(texel.velocity, k_most_velocity) &&
                                within(texel.trail, k_most_lean) && texel.trample >= 0.0f && texel.trample <= 1.0f &&
                                within(lean, WINDROW_GROUND_MOST_LEAN) && within(shown, k_most_lean),
                            "a texel is out of range.");
    }
}

} // namespace

Result<std::vector<std::byte>> to_bytes(const SavedGround& ground) {
    return where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        Writer writer(256 + 13 * ground.texels.size() * sizeof(float));
        writer(ground.host.config());
        fields(writer, ground);
        return std::move(writer).finish(k_format);
    });
}

Result<SavedGround> ground_of(std::span<const std::byte> bytes) {
    return where_memory_lasts([&]() -> Result<SavedGround> {
        std::optional<SavedGround> ground;
        auto read = read_sealed(bytes, k_format, [&](Reader& reader) {
            GroundConfig config;
            reader(config);
            if (reader.rejected())
                return;
            if (auto valid = validate(config); !valid)
                return reader.reject(valid.error());
            ground.emplace(config);
            fields(reader, *ground);
        });
        if (!read)
            return read.failure();
        return *std::move(ground);
    });
}

} // namespace windrow::detail
