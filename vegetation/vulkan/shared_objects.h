// Vulkan objects that several owners on one device use together: layouts, render passes and pipelines, which hold no data. A second coat,
// stand or layer of the same shaders compiles nothing.
//
// The key holds all creation parameters. An object is destroyed with its last owner. An object made of a part that is not shared, such
// as a host's render pass, is not shared: Vulkan may reuse that handle for another object.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace windrow::vegetation::engine {

/// A Vulkan handle of any type, in its bits.
using HandleBits = std::uint64_t;

template <class Handle>
[[nodiscard]] HandleBits bits_of(Handle handle) {
    static_assert(sizeof handle <= sizeof(HandleBits));
    HandleBits bits = 0;
    std::memcpy(&bits, &handle, sizeof handle);
    return bits;
}

template <class Handle>
[[nodiscard]] Handle handle_of(HandleBits bits) {
    Handle handle{};
    std::memcpy(&handle, &bits, sizeof handle);
    return handle;
}

enum class SharedKind : std::uint8_t { set_layout, pipeline_layout, render_pass, pipeline };

/// What a shared object is made of.
class SharedKey {
  public:
    explicit SharedKey(SharedKind kind) { add(kind); }

    /// Numbers, flags and enums.
    template <class Value>
    SharedKey& add(Value value) {
        static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        return *this;
    }
    SharedKey& add_words(std::span<const std::uint32_t> words) {
        add(words.size());
        bytes_.append(reinterpret_cast<const char*>(words.data()), words.size_bytes());
        return *this;
    }
    /// An object that was made before, of that kind.
    template <class Handle>
    SharedKey& add_part(SharedKind kind, Handle handle) {
        parts_.emplace_back(kind, bits_of(handle));
        return add(parts_.back().second);
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] SharedKind kind() const { return static_cast<SharedKind>(bytes_.front()); }
    [[nodiscard]] std::span<const std::pair<SharedKind, HandleBits>> parts() const { return parts_; }

  private:
    std::string bytes_{};
    std::vector<std::pair<SharedKind, HandleBits>> parts_{};
};

class Objects;

/// Shared objects of one device. Not thread-safe, as the device.
class SharedObjects {
  public:
    struct Shared {
        std::vector<std::shared_ptr<const Shared>> parts{};
        std::unique_ptr<Objects> owner{};
        SharedKind kind{};
        HandleBits handle = 0;

        ~Shared();
    };

    /// The object of the key, made by `make` where there is none. Null where a part of it is not shared.
    [[nodiscard]] std::shared_ptr<const Shared> find(Objects& objects, const SharedKey& key,
                                                     const std::function<HandleBits(Objects&)>& make);
    /// Number of live objects.
    [[nodiscard]] std::size_t count() const;

  private:
    std::map<std::string, std::weak_ptr<const Shared>> found_{};
};

} // namespace windrow::vegetation::engine
