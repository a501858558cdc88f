// Based on: Khronos, SPIR-V Specification 1.6, sections 2.3 (layout of a module), 3.20 (decorations), 3.49 (instructions).
// `readonly` of GLSL becomes NonWritable and `writeonly` NonReadable, on the variable or on each member of its block.
#include "fluid/vulkan/spirv_access.h"

#include <map>

namespace windrow::vulkan {
namespace {

constexpr std::uint32_t k_op_pointer = 32, k_op_variable = 59, k_op_decorate = 71, k_op_member_decorate = 72;
constexpr std::uint32_t k_non_writable = 24, k_non_readable = 25, k_binding = 33;
constexpr std::size_t k_header_words = 5;

} // namespace

std::vector<Access> access_of(std::span<const std::uint32_t> spirv, std::size_t bindings) {
    std::map<std::uint32_t, Access> named;                  // what a variable or a block may do
    std::map<std::uint32_t, std::uint32_t> at, pointee, of; // variable: binding; pointer: block; variable: pointer
    const auto note = [&](std::uint32_t id, std::uint32_t decoration) {
        if (decoration == k_non_writable)
            named[id].writes = false;
        if (decoration == k_non_readable)
            named[id].reads = false;
    };
    for (std::size_t word = k_header_words; word < spirv.size();) {
        const std::uint32_t length = spirv[word] >> 16, operation = spirv[word] & 0xffffu;
        if (length == 0 || word + length > spirv.size())
            break; // no module: nothing more is known of it
        const auto operand = [&](std::size_t n) { return spirv[word + n]; };
        if (operation == k_op_decorate && length >= 3) {
            note(operand(1), operand(2));
            if (operand(2) == k_binding && length >= 4)
                at[operand(1)] = operand(3);
        } else if (operation == k_op_member_decorate && length >= 4) {
            note(operand(1), operand(3));
        } else if (operation == k_op_pointer && length >= 4) {
            pointee[operand(1)] = operand(3);
        } else if (operation == k_op_variable && length >= 4) {
            of[operand(2)] = operand(1);
        }
        word += length;
    }
    std::vector<Access> access(bindings, {.reads = false, .writes = false});
    for (const auto& [variable, binding] : at) {
        if (binding >= bindings)
            continue;
        const Access own = named[variable], block = named[pointee[of[variable]]];
        access[binding] = {.reads = own.reads && block.reads, .writes = own.writes && block.writes};
    }
    return access;
}

} // namespace windrow::vulkan
