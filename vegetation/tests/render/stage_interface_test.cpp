// Floats that a vertex hands to the fragment stage, counted in the SPIR-V: their number bounds the drawing of small triangles.
//
// On an NVIDIA H200 blades took 9.0 ms of a frame with 33 floats and 4.5 with 5, and as long with their arithmetic removed; above
// 16 floats each costs three times as much.
#include "shader_words/field_blade_frag.h"
#include "shader_words/field_blade_vert.h"
#include "shader_words/terrain_frag.h"
#include "shader_words/terrain_vert.h"
#include "tests/figure.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <span>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

// Of SPIR-V's unified specification, 3.32: what names variables and their types.
enum SpirvName : std::uint32_t {
    op_type_int = 21,
    op_type_float = 22,
    op_type_vector = 23,
    op_type_pointer = 32,
    op_variable = 59,
    op_decorate = 71,
    decoration_location = 30,
    storage_input = 1,
    storage_output = 3
};

// Numbers of 32 bits at each location that a stage reads or writes (storage class).
std::map<std::uint32_t, std::uint32_t> numbers_at(std::span<const std::uint32_t> module, std::uint32_t storage) {
    constexpr std::size_t header = 5;
    std::map<std::uint32_t, std::uint32_t> sizes, pointees, locations, found; // by id; the last by location
    for (std::size_t at = header; at < module.size(); at += module[at] >> 16u) {
        const std::uint32_t* const word = &module[at];
        const std::uint32_t operation = *word & 0xffffu;
        if (operation == op_type_int || operation == op_type_float)
            sizes[word[1]] = 1;
        else if (operation == op_type_vector)
            sizes[word[1]] = word[3] * sizes[word[2]];
        else if (operation == op_type_pointer)
            pointees[word[1]] = word[3];
        else if (operation == op_decorate && word[2] == decoration_location)
            locations[word[1]] = word[3];
        else if (operation == op_variable && word[3] == storage && locations.count(word[2]) > 0) {
            const std::uint32_t size = sizes[pointees[word[1]]];
            EXPECT_GT(size, 0u) << "a type that this test does not count";
            found[locations[word[2]]] = size;
        }
    }
    return found;
}

std::uint32_t handed_on(std::span<const std::uint32_t> vertex, std::span<const std::uint32_t> fragment) {
    const auto written = numbers_at(vertex, storage_output);
    EXPECT_EQ(written, numbers_at(fragment, storage_input));
    std::uint32_t sum = 0;
    for (const auto& [location, size] : written)
        sum += size;
    return sum;
}

TEST(StageInterface, HandsFewFloatsOn) {
    const std::uint32_t blade = handed_on(words::field_blade_vert, words::field_blade_frag);
    EXPECT_GE(blade, 5u); // a colour and a motion vector at least: the test counts
    WINDROW_EXPECT_FIGURE("render/stage_interface/floats_of_a_blade", blade, 9.0);
    WINDROW_EXPECT_FIGURE("render/stage_interface/floats_of_the_ground", handed_on(words::terrain_vert, words::terrain_frag),
                          16.0);
}

} // namespace
} // namespace windrow::vegetation::render
