#include "tests/parity/counted_functions.h"

#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace windrow::vulkan {
namespace {

/// "Buffer" of vkCreateBuffer and vkDestroyBuffer; empty of a call that neither makes nor ends an object by itself.
std::string kind_of(std::string_view name, std::string_view verb) {
    if (!name.starts_with(verb))
        return {};
    name.remove_prefix(verb.size());
    if (name == "ComputePipelines")
        return "Pipeline";
    return name == "DescriptorSets" ? "" : std::string(name); // sets go with their pool
}

void note_made(std::string_view name) {
    for (const char* verb : {"vkCreate", "vkAllocate"})
        if (const std::string kind = kind_of(name, verb); !kind.empty())
            ++counted_calls().live[kind];
}

void note_ended(std::string_view name) {
    for (const char* verb : {"vkDestroy", "vkFree"})
        if (const std::string kind = kind_of(name, verb); !kind.empty())
            --counted_calls().live[kind];
}

/// True where this is the call that fails.
bool fails(std::string_view name) {
    CountedCalls& calls = counted_calls();
    if (calls.made++ != calls.fail_at)
        return false;
    calls.failed = name;
    return true;
}

// What a failed call leaves in its output is not to be looked at: here it is a handle that nothing may destroy.
template <class Last>
void spoil(Last last) {
    using Handle = std::remove_pointer_t<Last>;
    if constexpr (std::is_pointer_v<Last> && std::is_pointer_v<Handle> && !std::is_const_v<Handle>)
        *last = reinterpret_cast<Handle>(std::uintptr_t{0xdead});
}

template <class Argument>
Argument handed_on(Argument argument) {
    return argument;
}

const VkAllocationCallbacks* handed_on(const VkAllocationCallbacks* callbacks) {
    if (callbacks != counted_calls().callbacks)
        ++counted_calls().without_callbacks;
    return nullptr;
}

template <auto Member, class Name, class Call>
struct Counted;

template <auto Member, class Name, class Return, class... Arguments>
struct Counted<Member, Name, Return(VKAPI_PTR*)(Arguments...)> {
    static VKAPI_ATTR Return VKAPI_CALL call(Arguments... arguments) {
        constexpr std::string_view name = Name::value();
        const auto real = counted_calls().real.*Member;
        if constexpr (std::is_same_v<Return, VkResult>) {
            if (fails(name)) {
                const std::tuple<Arguments...> all(arguments...);
                spoil(std::get<sizeof...(Arguments) - 1>(all));
                return counted_calls().code;
            }
            const VkResult result = real(handed_on(arguments)...);
            if (result == VK_SUCCESS)
                note_made(name);
            return result;
        } else {
            note_ended(name);
            return real(handed_on(arguments)...);
        }
    }
};

} // namespace

CountedCalls& counted_calls() {
    static CountedCalls calls;
    return calls;
}

Functions counted(const Functions& real) {
    counted_calls() = {};
    counted_calls().real = real;
    Functions table = real;
#define WINDROW_COUNT(name)                                                                                                      \
    {                                                                                                                            \
        struct Name {                                                                                                            \
            static constexpr std::string_view value() { return #name; }                                                          \
        };                                                                                                                       \
        table.name = &Counted<&Functions::name, Name, PFN_##name>::call;                                                         \
    }
    WINDROW_DEVICE_FUNCTIONS(WINDROW_COUNT)
    WINDROW_COUNT(vkGetPhysicalDeviceImageFormatProperties)
#undef WINDROW_COUNT
    return table;
}

} // namespace windrow::vulkan
