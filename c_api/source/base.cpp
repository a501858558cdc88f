// Version, errors, hooks, threads, bytes.
#include "c_api/base.h"

#include "c_api/source/guard.h"
#include "c_api/source/handles.h"
#include "fluid/allocator.h"
#include "fluid/core/message.h"
#include "fluid/saved_parts.h"

#include <algorithm>
#include <array>

namespace windrow::c_api {
namespace {

/// Arrays alone, and no string: what a thread destroys at its end keeps the library loaded when a host unloads it.
struct LastError {
    std::array<char, 8192> text;
};
thread_local constinit LastError last_error{};

void keep(std::string_view sentence) noexcept {
    constexpr std::string_view k_more = "\nFurther reasons are left out.";
    auto& text = last_error.text;
    const bool fits = sentence.size() < text.size();
    if (!fits) { // whole lines
        sentence = sentence.substr(0, text.size() - 1 - k_more.size());
        sentence = sentence.substr(0, sentence.rfind('\n'));
    }
    auto* const end = std::copy(sentence.begin(), sentence.end(), text.data());
    *(fits ? end : std::copy(k_more.begin(), k_more.end(), end)) = '\0';
}

struct Logger {
    windrow_logger log = nullptr;
    void* user = nullptr;
};
Logger logger;

void log(windrow_severity severity, const char* sentence) noexcept {
    if (logger.log != nullptr)
        logger.log(severity, sentence, logger.user);
}

} // namespace

windrow_result fail(windrow_result result, std::string_view sentence) noexcept {
    keep(sentence);
    log(WINDROW_SEVERITY_ERROR, windrow_last_error());
    return result;
}

windrow_result fail(const Error& error) noexcept {
    switch (error.fault) {
    case Fault::out_of_memory:
        return fail(WINDROW_OUT_OF_MEMORY, error.message);
    case Fault::device_lost:
        return fail(WINDROW_DEVICE_LOST, error.message);
    case Fault::rejected:
    case Fault::system_lacks:
        break;
    }
    const bool lost = error.message == Error::k_out_of_memory; // the sentence itself found no memory
    return fail(lost ? WINDROW_OUT_OF_MEMORY : WINDROW_REJECTED, error.message);
}

windrow_result fail_null(const char* argument) noexcept {
    return fail(WINDROW_REJECTED, detail::message(std::string_view(argument), " is null: give an object."));
}

windrow_result fail_unsupported(const char* part) noexcept {
    return fail(WINDROW_UNSUPPORTED, detail::message("this library was built without ", std::string_view(part),
                                                     ": build it with the component, or ask windrow_has_part first."));
}

void warn(const char* sentence) noexcept {
    log(WINDROW_SEVERITY_WARNING, sentence);
}

} // namespace windrow::c_api

using namespace windrow;
using namespace windrow::c_api;

WINDROW_EXPORT uint32_t windrow_version(void) {
    return WINDROW_VERSION;
}
WINDROW_EXPORT const char* windrow_version_string(void) {
    return WINDROW_VERSION_STRING;
}
WINDROW_EXPORT int32_t windrow_has_part(windrow_part part) {
    switch (part) {
    case WINDROW_PART_COUPLING:
        return WINDROW_C_COUPLING;
    case WINDROW_PART_VDB:
        return WINDROW_C_VDB;
    case WINDROW_PART_VULKAN:
        return WINDROW_C_VULKAN;
    case WINDROW_PART_SCENE:
        return WINDROW_C_SCENE;
    default:
        return 0;
    }
}

WINDROW_EXPORT const char* windrow_last_error(void) {
    return last_error.text.data();
}

WINDROW_EXPORT void windrow_set_logger(windrow_logger log, void* user) {
    logger = {log, user};
}

WINDROW_EXPORT windrow_result windrow_set_allocator(windrow_allocate allocate, windrow_release release, void* user) {
    return guarded([&] { return set_allocator({.allocate = allocate, .release = release, .user = user}); });
}
WINDROW_EXPORT uint64_t windrow_allocated_bytes(void) {
    return allocated_bytes();
}

WINDROW_EXPORT windrow_result windrow_thread_pool_create(int32_t threads, windrow_thread_pool** pool) {
    return create(pool, [&]() -> Result<std::unique_ptr<ThreadPool>> {
        if (threads < 0 || threads > 4096)
            return Error{detail::message("threads is ", threads, ": give 1 to 4096, or 0 for one a core.")};
        auto made = std::make_unique<ThreadPool>(threads);
        if (made->size() < threads)
            warn("the system gives fewer threads than the pool asked for: windrow_thread_pool_size has their number.");
        return made;
    });
}
WINDROW_EXPORT void windrow_thread_pool_destroy(windrow_thread_pool* pool) {
    delete pool;
}
WINDROW_EXPORT int32_t windrow_thread_pool_size(const windrow_thread_pool* pool) {
    return value_of(pool, "pool", [&] { return pool->pool->size(); });
}
WINDROW_EXPORT windrow_parallel_for windrow_thread_pool_parallel_for(windrow_thread_pool* pool) {
    return value_of(pool, "pool", [&] {
        const ParallelFor loop = pool->pool->parallel_for();
        return windrow_parallel_for{loop.run, loop.context};
    });
}

WINDROW_EXPORT const uint8_t* windrow_bytes_data(const windrow_bytes* bytes) {
    return value_of(bytes, "bytes", [&] { return reinterpret_cast<const uint8_t*>(bytes->bytes.data()); });
}
WINDROW_EXPORT uint64_t windrow_bytes_size(const windrow_bytes* bytes) {
    return value_of(bytes, "bytes", [&] { return static_cast<uint64_t>(bytes->bytes.size()); });
}
WINDROW_EXPORT void windrow_bytes_destroy(windrow_bytes* bytes) {
    delete bytes;
}

WINDROW_EXPORT windrow_result windrow_parts_join(const windrow_saved_part* parts, uint64_t count, windrow_bytes** file) {
    return create(file, [&]() -> Result<std::vector<std::byte>> {
        if (count > k_max_parts)
            return Error{detail::message("there are ", count, " parts: give at most ", k_max_parts, ".")};
        std::vector<SavedPart> all;
        for (uint64_t n = 0; n < count; ++n) {
            if (parts == nullptr || parts[n].name == nullptr || (parts[n].bytes == nullptr && parts[n].size > 0))
                return Error{detail::message("part ", n, " is null, or its name or its bytes are: give both.")};
            all.push_back(
                {parts[n].name, {static_cast<const std::byte*>(parts[n].bytes), static_cast<std::size_t>(parts[n].size)}});
        }
        return join_parts(all);
    });
}
WINDROW_EXPORT windrow_result windrow_parts_find(const void* bytes, uint64_t size, const char* name, const void** part,
                                                 uint64_t* part_size) {
    return call({{bytes, "bytes"}, {name, "name"}, {part, "part"}, {part_size, "part_size"}}, [&]() -> windrow_result {
        *part = nullptr;
        *part_size = 0;
        const auto parts = split_parts({static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)});
        if (!parts)
            return done(parts);
        const auto found = find_part(*parts, name);
        if (found) {
            *part = found->data();
            *part_size = found->size();
        }
        return done(found);
    });
}
