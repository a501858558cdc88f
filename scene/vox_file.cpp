// Based on: ephtracy, "MagicaVoxel .vox File Format", version 150.
#include "scene/vox_file.h"

#include "fluid/core/bytes.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <span>

namespace windrow::scene {
namespace {

using detail::message;

constexpr int k_most_cells = 256; // a coordinate is a byte
constexpr std::size_t k_head = 12;

/// Turns and mirrors along the axes: component n of the result is sign[n] times component from[n].
struct Turn {
    std::array<int, 3> from{0, 1, 2}, sign{1, 1, 1};

    [[nodiscard]] bool is_whole() const {
        return std::all_of(from.begin(), from.end(), [](int axis) { return axis >= 0 && axis < 3; }) && from[0] != from[1] &&
               from[1] != from[2] && from[0] != from[2];
    }
    /// First `inner`, then this.
    [[nodiscard]] Turn after(const Turn& inner) const {
        Turn both;
        for (std::size_t n = 0; n < 3; ++n) {
            const auto axis = static_cast<std::size_t>(from[n]);
            both.from[n] = inner.from[axis];
            both.sign[n] = sign[n] * inner.sign[axis];
        }
        return both;
    }
};

/// A byte of two indices, of the first and the second row's entry that is not 0, and three signs.
Turn turn_of(int bits) {
    Turn turn;
    turn.from = {bits & 3, bits >> 2 & 3, 3 - (bits & 3) - (bits >> 2 & 3)};
    for (int row = 0; row < 3; ++row)
        turn.sign[static_cast<std::size_t>(row)] = (bits >> (4 + row) & 1) != 0 ? -1 : 1;
    return turn;
}

class VoxReader {
  public:
    VoxReader(std::string_view bytes, const std::string& name) : bytes_(std::as_bytes(std::span(bytes))), name_(name) {}

    Result<VoxelData> run() {
        if (bytes_.size() < 8 + k_head || letters(0) != "VOX " || letters(8) != "MAIN")
            return Error{
                message(name_, ": is no MagicaVoxel file: it does not begin with \"VOX \" and a chunk MAIN; export one.")};
        read_chunks();
        if (fault_.empty() && models_ != 1)
            fault_ = models_ == 0 ? message(name_, ": has no model: give a file with one.")
                                  : message(name_, ": has ", models_, " models: merge them, or save each in a file of its own.");
        if (fault_.empty())
            turn();
        if (!fault_.empty())
            return Error{fault_};
        return std::move(data_);
    }

  private:
    template <class... Words>
    void fail(std::size_t at, const Words&... words) {
        fault_ = message(name_, ": byte ", at, ": ", words...);
    }
    [[nodiscard]] std::string_view letters(std::size_t at) const { return {reinterpret_cast<const char*>(&bytes_[at]), 4}; }
    [[nodiscard]] std::uint32_t number(std::size_t at) const { return detail::load_number<std::uint32_t>(&bytes_[at]); }

    void read_chunks() {
        for (std::size_t at = 8 + k_head + number(12); fault_.empty() && at < bytes_.size();) {
            const std::size_t left = bytes_.size() - at;
            if (left < k_head || number(at + 4) > left - k_head)
                return fail(at, "a chunk ends beyond the file: the file is truncated; copy it again.");
            const std::size_t content = at + k_head, size = number(at + 4);
            if (letters(at) == "SIZE")
                read_size(content, size);
            else if (letters(at) == "XYZI")
                read_cells(content, size);
            else if (letters(at) == "nTRN" || letters(at) == "nGRP" || letters(at) == "nSHP")
                read_node(content, content + size);
            at = content + size; // chunks within it are read as if they were behind it
        }
    }

    void read_size(std::size_t at, std::size_t size) {
        if (size < 12)
            return fail(at, "the chunk SIZE has ", size, " bytes: 12 are needed; export the file again.");
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint32_t cells = number(at + 4 * static_cast<std::size_t>(axis));
            if (cells < 1 || cells > k_most_cells)
                return fail(at, "a model has ", cells, " cells along an axis: give 1 to ", k_most_cells, ".");
            size_[axis] = static_cast<int>(cells);
        }
        ++models_;
    }

    void read_cells(std::size_t at, std::size_t size) {
        if (models_ == 0)
            return fail(at, "the chunk XYZI has no chunk SIZE before it; export the file again.");
        if (size < 4 || number(at) > (size - 4) / 4)
            return fail(at, "the chunk XYZI has ", size, " bytes, too few for its cells; export the file again.");
        if (models_ > 1) // only counted
            return;
        if (has_cells_)
            return fail(at, "the model has a second chunk XYZI; export the file again.");
        has_cells_ = true;
        if (number(at) == 0)
            return fail(at, "the model has no voxel: fill one at least.");
        model_.assign(static_cast<std::size_t>(size_.x) * size_.y * size_.z, 0);
        model_size_ = size_;
        for (std::size_t n = 0, count = number(at); n < count; ++n) {
            const std::byte* const cell = &bytes_[at + 4 + 4 * n];
            const glm::ivec3 place(std::to_integer<int>(cell[0]), std::to_integer<int>(cell[1]), std::to_integer<int>(cell[2]));
            if (place.x >= size_.x || place.y >= size_.y || place.z >= size_.z)
                return fail(at + 4 + 4 * n, "the cell ", place, " is outside of the model of ", size_,
                            "; export the file again.");
            model_[(static_cast<std::size_t>(place.z) * size_.y + place.y) * size_.x + place.x] = 1;
        }
    }

    // --- Nodes of the editor's scene -------------------------------------------------------------------------------------

    struct Node {
        Turn turn{};
        std::optional<std::uint32_t> parent{};
    };

    // Takes a number of a node off its content; nothing, with a fault, beyond its end.
    std::optional<std::uint32_t> take(std::size_t& at, std::size_t end) {
        if (end - at < 4) {
            if (fault_.empty())
                fail(at, "a node ends beyond its chunk; export the file again.");
            return std::nullopt;
        }
        at += 4;
        return number(at - 4);
    }
    std::optional<std::string_view> take_text(std::size_t& at, std::size_t end) {
        const auto length = take(at, end);
        if (!length || *length > end - at) {
            if (fault_.empty())
                fail(at, "a node's text ends beyond its chunk; export the file again.");
            return std::nullopt;
        }
        at += *length;
        return std::string_view(reinterpret_cast<const char*>(bytes_.data()) + at - *length, *length);
    }
    // Pairs of a key and a value. The turn that they hold is that of `node`.
    void take_pairs(std::size_t& at, std::size_t end, Node* node) {
        const auto count = take(at, end);
        for (std::uint32_t n = 0; count && n < *count && fault_.empty(); ++n) {
            const auto key = take_text(at, end);
            const auto value = key ? take_text(at, end) : std::nullopt;
            if (!value || node == nullptr || *key != "_r")
                continue;
            int bits = -1;
            const auto [read, trouble] = std::from_chars(value->data(), value->data() + value->size(), bits);
            const Turn turn = turn_of(bits & 127);
            if (trouble != std::errc() || read != value->data() + value->size() || bits < 0 || bits > 127 || !turn.is_whole())
                return fail(at, "a node's _r is no turn along the axes; export the file again.");
            node->turn = turn;
        }
    }

    void read_node(std::size_t at, std::size_t end) {
        const std::string_view kind = letters(at - k_head);
        const auto name = take(at, end);
        take_pairs(at, end, nullptr);
        if (!name || !fault_.empty())
            return;
        Node& node = nodes_[*name];
        const auto own = [&](std::optional<std::uint32_t> child) {
            if (!child)
                return;
            Node& below = nodes_[*child];
            places_ += below.parent ? 1 : 0;
            below.parent = name;
        };
        if (kind == "nTRN") {
            own(take(at, end));
            (void)take(at, end); // reserved
            (void)take(at, end); // layer
            const auto frames = take(at, end);
            if (frames && *frames > 0 && fault_.empty())
                take_pairs(at, end, &node); // as it is at the first frame
        } else if (kind == "nGRP") {
            const auto count = take(at, end);
            for (std::uint32_t n = 0; count && n < *count && fault_.empty(); ++n)
                own(take(at, end));
        } else {
            ++places_;
            shape_ = *name;
        }
    }

    void turn() {
        if (places_ > 1) {
            fault_ = message(name_, ": its model stands at ", places_, " places: merge them, or save it once.");
            return;
        }
        Turn turn;
        std::optional<std::uint32_t> at = shape_;
        for (std::size_t n = 0; at && n < nodes_.size(); ++n) {
            const Node& node = nodes_[*at];
            turn = node.turn.after(turn);
            at = node.parent;
        }
        if (at) {
            fault_ = message(name_, ": its nodes go in a circle; export the file again.");
            return;
        }
        const auto count = [&](std::size_t axis) { return model_size_[turn.from[axis]]; };
        data_.cells = {count(0), count(2), count(1)};
        data_.closed.assign(model_.size(), 0);
        glm::ivec3 place(0);
        for (const std::uint8_t closed : model_) {
            glm::ivec3 to;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int from = place[turn.from[axis]];
                to[static_cast<int>(axis)] = turn.sign[axis] > 0 ? from : count(axis) - 1 - from;
            }
            const glm::ivec3 own(to.x, to.z, count(1) - 1 - to.y);
            data_.closed[(static_cast<std::size_t>(own.z) * data_.cells.y + own.y) * data_.cells.x + own.x] = closed;
            for (int axis = 0; axis < 3 && ++place[axis] == model_size_[axis]; ++axis)
                place[axis] = 0;
        }
    }

    std::span<const std::byte> bytes_;
    const std::string& name_;
    glm::ivec3 size_{0}, model_size_{0};
    int models_ = 0, places_ = 0;
    bool has_cells_ = false;
    std::vector<std::uint8_t> model_; ///< as the file has it
    std::map<std::uint32_t, Node> nodes_;
    std::optional<std::uint32_t> shape_{};
    VoxelData data_;
    std::string fault_;
};

} // namespace

Result<VoxelData> read_vox(std::string_view bytes, const std::string& name) {
    return detail::where_memory_lasts([&] { return VoxReader(bytes, name).run(); });
}

} // namespace windrow::scene
