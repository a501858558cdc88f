// Serialisation of structs by the rows of their fields (setting.h). A struct without rows has one function for both directions,
// so that writer and reader cannot differ:
//
//     void fields(auto& archive, Like<Stepped> auto& event) {
//         auto& [dt] = event;
//         archive(dt);
//     }
//
// Variants and enumerations go by index, optionals by a flag before them. What is shared (a mesh) is written once, where it is first
// met: a number, from 0 in the order of the first, and behind a new number its data. Equal contents are one.
#pragma once

#include "fluid/core/bytes.h"
#include "fluid/core/validation.h"
#include "fluid/shapes/height_map.h"
#include "fluid/shapes/triangle_mesh.h"
#include "fluid/shapes/voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace windrow::detail {

/// U or const U: the writer reads from const structs.
template <class T, class U>
concept Like = std::same_as<std::remove_const_t<T>, U>;

template <class T>
inline constexpr bool k_is_shared = false;
template <class T>
inline constexpr bool k_is_shared<std::shared_ptr<const T>> = true;

/// What an archive has met, in the order of its numbers.
struct SharedMet {
    static constexpr std::uint32_t k_null = ~std::uint32_t{0}; ///< the number of a null pointer

    template <class Kind>
    [[nodiscard]] auto& of() {
        return std::get<std::vector<std::shared_ptr<const Kind>>>(lists_);
    }
    /// Place in the list; its end where it is new.
    template <class Kind>
    [[nodiscard]] auto find(const Kind& one) {
        return std::find_if(of<Kind>().begin(), of<Kind>().end(), [&](const auto& met) { return *met == one; });
    }

  private:
    std::tuple<std::vector<std::shared_ptr<const TriangleMesh>>, std::vector<std::shared_ptr<const VoxelGrid>>,
               std::vector<std::shared_ptr<const HeightMap>>>
        lists_;
};

/// Hands every stored field of a struct to the archive.
template <class Archive, class Struct>
void pass_fields(Archive& archive, Struct& value) {
    if constexpr (HasSettings<Struct>)
        for_each_setting(value, [&]<class Row>(const Row&, auto& member) {
            if constexpr (Row::k_stored != Stored::nowhere)
                archive(member);
        });
    else
        fields(archive, value);
}

/// Names the layout of structs in bytes: another name, kind, word or type of a stored setting is another layout.
class Layout {
  public:
    /// `rest` names what is stored beside settings; change it with that.
    explicit constexpr Layout(std::string_view rest) { mix(rest); }

    template <class Value>
    constexpr Layout& with() {
        if constexpr (HasSettings<Value>) {
            std::apply([&](const auto&... rows) { (row(rows), ...); }, Value::settings());
        } else if constexpr (std::is_enum_v<Value>) {
            for (const char* word : k_words<Value>)
                mix(word);
        } else if constexpr (k_is_optional<Value>) {
            mix("?");
            with<typename Value::value_type>();
        } else if constexpr (k_is_variant<Value>) {
            [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>>) {
                ((mix(Kinds::k_name), with<Kinds>()), ...);
            }(std::type_identity<Value>());
        } else if constexpr (k_is_shared<Value>) {
            mix("shared 2"); // change it with shape_record.h
        } else if constexpr (k_is_number_list<Value>) {
            mix("list");
        } else {
            mix(std::is_floating_point_v<Value> ? "f" : "i");
            hash_ = (hash_ ^ static_cast<std::uint32_t>(sizeof(Value))) * k_prime;
        }
        return *this;
    }
    [[nodiscard]] constexpr std::uint32_t version() const { return hash_; }

  private:
    static constexpr std::uint32_t k_prime = 0x01000193; // FNV-1a

    template <class Row>
    constexpr void row(const Row& row) {
        if constexpr (Row::k_stored != Stored::nowhere) {
            mix(row.name);
            with<std::remove_cvref_t<decltype(std::declval<typename Row::Owner>().*row.member)>>();
        }
    }
    constexpr void mix(std::string_view text) {
        for (const char letter : text)
            hash_ = (hash_ ^ static_cast<std::uint8_t>(letter)) * k_prime;
        hash_ = (hash_ ^ 0xffu) * k_prime; // no letter: where one ends
    }

    std::uint32_t hash_ = 0x811c9dc5;
};

class Writer {
  public:
    explicit Writer(std::size_t expected_content) : bytes_(begin_bytes(expected_content)) {}

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }
    /// Cells alone; whoever reads them knows how many.
    void cells(std::span<const glm::vec4> values) {
        static_assert(sizeof(glm::vec4) == 4 * sizeof(float));
        std::byte* const to = grow(values.size_bytes());
        if constexpr (std::endian::native == std::endian::little) {
            if (!values.empty())
                std::memcpy(to, values.data(), values.size_bytes());
        } else {
            for (std::size_t n = 0; n < 4 * values.size(); ++n)
                store_number(to + 4 * n, values[n / 4][static_cast<int>(n % 4)]);
        }
    }
    /// Leaves a gap of zeros, to be filled in later; returns where it begins.
    [[nodiscard]] std::size_t leave(std::size_t size) { return static_cast<std::size_t>(grow(size) - bytes_.data()); }
    /// All so far, unsealed.
    [[nodiscard]] std::vector<std::byte> take() && { return std::move(bytes_); }
    [[nodiscard]] std::vector<std::byte> finish(const Format& format) && {
        seal(bytes_, format);
        return std::move(bytes_);
    }

  private:
    [[nodiscard]] std::byte* grow(std::size_t size) {
        bytes_.resize(bytes_.size() + size);
        return bytes_.data() + bytes_.size() - size;
    }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    void put(const Number& value) { store_number(grow(sizeof value), value); }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void put(const Enumeration& value) { put(static_cast<std::uint8_t>(value)); }
    template <int Count, class Number, glm::qualifier Q>
    void put(const glm::vec<Count, Number, Q>& vector) {
        for (int n = 0; n < Count; ++n)
            put(vector[n]);
    }
    template <class Number, glm::qualifier Q>
    void put(const glm::qua<Number, Q>& orientation) {
        (*this)(orientation.x, orientation.y, orientation.z, orientation.w);
    }
    template <class Value>
    void put(const std::optional<Value>& value) {
        put(value.has_value());
        if (value)
            put(*value);
    }
    void put(const std::vector<float>& values) {
        put(static_cast<std::uint32_t>(values.size()));
        for (const float value : values)
            put(value);
    }
    template <class... Kinds>
    void put(const std::variant<Kinds...>& value) {
        put(static_cast<std::uint8_t>(value.index()));
        std::visit([&](const auto& kind) { put(kind); }, value);
    }
    template <class Kind>
    void put(const std::shared_ptr<const Kind>& shared) {
        if (shared == nullptr)
            return put(SharedMet::k_null);
        auto& list = met_.of<Kind>();
        const auto found = met_.find(*shared);
        put(static_cast<std::uint32_t>(found - list.begin()));
        if (found != list.end())
            return;
        list.push_back(shared);
        put(shared->data());
    }
    template <class Struct>
    void put(const Struct& value) {
        pass_fields(*this, value);
    }

    std::vector<std::byte> bytes_;
    SharedMet met_;
};

/// Once rejected, it reads nothing more: values stay as they are, and the first reason stands.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> content) : rest_(content) {}

    template <class... Values>
    void operator()(Values&... values) {
        (get(values), ...);
    }
    void cells(std::span<glm::vec4> values) {
        const std::byte* const from = take(values.size_bytes());
        if (from == nullptr || values.empty())
            return;
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(static_cast<void*>(values.data()), from, values.size_bytes());
        else
            for (std::size_t n = 0; n < 4 * values.size(); ++n)
                values[n / 4][static_cast<int>(n % 4)] = load_number<float>(from + 4 * n);
    }
    /// Asked before room is made for what a count promises: whether so many items of at least `bytes_each` can follow.
    [[nodiscard]] bool can_hold(std::uint64_t count, std::size_t bytes_each) {
        if (!rejected() && count > rest_.size() / bytes_each)
            reject("its length is ", count, " items of ", bytes_each, " bytes or more, but only ", rest_.size(),
                   " bytes follow.");
        return !rejected();
    }
    template <class... Parts>
    void reject(const Parts&... parts) {
        if (reason_.empty())
            reason_ = message(parts...);
    }
    void require(bool valid, std::string_view reason) {
        if (!valid)
            reject(reason);
    }
    [[nodiscard]] bool rejected() const { return !reason_.empty(); }
    [[nodiscard]] const std::string& reason() const { return reason_; }
    [[nodiscard]] bool at_end() const { return rest_.empty(); }
    /// Rejects what is left over.
    void end() { require(rest_.empty(), "bytes follow its last field."); }

  private:
    [[nodiscard]] const std::byte* take(std::size_t size) {
        if (rejected() || !can_hold(size, 1))
            return nullptr;
        const std::byte* const from = rest_.data();
        rest_ = rest_.subspan(size);
        return from;
    }

    template <class Number>
    requires std::is_arithmetic_v<Number>
    void get(Number& value) {
        if (const std::byte* const from = take(sizeof value))
            value = load_number<Number>(from);
        if constexpr (std::same_as<Number, double>) // places and times; a float may be an infinite hold, or air that broke
            require(std::isfinite(value), "a place or a time is not finite.");
    }
    void get(bool& value) { value = index(2, "a flag") != 0; }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void get(Enumeration& value) { value = static_cast<Enumeration>(index(k_words<Enumeration>.size(), "a choice")); }
    template <int Count, class Number, glm::qualifier Q>
    void get(glm::vec<Count, Number, Q>& vector) {
        for (int n = 0; n < Count; ++n)
            get(vector[n]);
    }
    template <class Number, glm::qualifier Q>
    void get(glm::qua<Number, Q>& orientation) {
        (*this)(orientation.x, orientation.y, orientation.z, orientation.w);
    }
    template <class Value>
    void get(std::optional<Value>& value) {
        bool there = false;
        get(there);
        value.reset();
        if (there)
            get(value.emplace());
    }
    void get(std::vector<float>& values) {
        std::uint32_t count = 0;
        get(count);
        if (!can_hold(count, sizeof(float)))
            return;
        values.resize(count);
        for (float& value : values)
            get(value);
    }
    template <class... Kinds>
    void get(std::variant<Kinds...>& value) {
        const std::uint8_t chosen = index(sizeof...(Kinds), "a kind");
        [&]<std::size_t... Index>(std::index_sequence<Index...>) {
            ((chosen == Index ? get(value.template emplace<Index>()) : void()), ...);
        }
        (std::index_sequence_for<Kinds...>());
    }
    template <class Kind>
    void get(std::shared_ptr<const Kind>& shared) {
        std::uint32_t number = 0;
        get(number);
        shared.reset();
        if (rejected() || number == SharedMet::k_null)
            return;
        auto& list = met_.of<Kind>();
        if (number > list.size())
            return reject("the form of a body has the number ", number, ", but only ", list.size(), " are before it.");
        if (number == list.size()) {
            const std::span<const std::byte> written = rest_;
            typename Kind::Data data;
            get(data);
            if (rejected())
                return;
            const auto made = Kind::create(data);
            if (!made)
                return reject(made.error());
            // To the bit: what was made of -0 holds 0.
            Writer again(written.size() - rest_.size());
            const std::size_t first = again.leave(0);
            again((*made)->data());
            const std::vector<std::byte> bytes = std::move(again).take();
            require(std::ranges::equal(std::span(bytes).subspan(first), written.first(written.size() - rest_.size())) &&
                        met_.find(**made) == list.end(),
                    "the form of a body is not as it was written.");
            list.push_back(*made);
        }
        shared = list[number];
    }
    template <class Struct>
    void get(Struct& value) {
        pass_fields(*this, value);
    }

    /// One of `count` values; 0 where it is none of them.
    [[nodiscard]] std::uint8_t index(std::size_t count, std::string_view what) {
        std::uint8_t value = 0;
        get(value);
        if (value < count)
            return value;
        reject(what, " has the unknown value ", value, ".");
        return 0;
    }

    std::span<const std::byte> rest_;
    std::string reason_;
    SharedMet met_;
};

/// Hands the content of a sealed file to `read`, which takes a Reader, all of it. An error names the format.
template <class Read>
[[nodiscard]] Result<void> read_sealed(std::span<const std::byte> bytes, const Format& format, const Read& read) {
    const auto content = unseal(bytes, format);
    if (!content)
        return content.failure();
    Reader reader(*content);
    read(reader);
    reader.end();
    if (reader.rejected())
        return Error{message(format.name, " cannot be used: ", reader.reason())};
    return {};
}

/// Operations of a reader only: allocation and checks.
template <class Archive>
concept Reading = std::same_as<std::remove_cvref_t<Archive>, Reader>;

} // namespace windrow::detail
