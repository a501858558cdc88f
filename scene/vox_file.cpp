// Based on: ephtracy, "MagicaVoxel .vox File Format", version 150.
#include "scene/vox_file.h"

#include "fluid/core/bytes.h"
#include "fluid/core/message.h"
#include "fluid/files/text_lines.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <glm/vector_relational.hpp>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace windrow::scene {
namespace {

using detail::message;

constexpr int k_most_cells = 256; // a coordinate is a byte
constexpr std::size_t k_head = 12;
constexpr std::size_t k_most_voxels = std::size_t{1} << 26; // a model may stand at many places

/// Turns and mirrors along the axes, and a way: component n of the result is sign[n] times component from[n], and then by[n] more.
struct Pose {
    std::array<int, 3> from{0, 1, 2}, sign{1, 1, 1};
    std::array<std::int64_t, 3> by{0, 0, 0};

    [[nodiscard]] bool turns_whole() const {
        return std::all_of(from.begin(), from.end(), [](int axis) { return axis >= 0 && axis < 3; }) && from[0] != from[1] &&
               from[1] != from[2] && from[0] != from[2];
    }
    /// Of a cell, by its low corner: a mirrored cell has it where its high corner was.
    [[nodiscard]] std::array<std::int64_t, 3> of(const std::array<std::int64_t, 3>& cell) const {
        std::array<std::int64_t, 3> to;
        for (std::size_t n = 0; n < 3; ++n) {
            const std::int64_t at = cell[static_cast<std::size_t>(from[n])];
            to[n] = (sign[n] > 0 ? at : -1 - at) + by[n];
        }
        return to;
    }
    /// First `inner`, then this.
    [[nodiscard]] Pose after(const Pose& inner) const {
        Pose both;
        for (std::size_t n = 0; n < 3; ++n) {
            const auto axis = static_cast<std::size_t>(from[n]);
            both.from[n] = inner.from[axis];
            both.sign[n] = sign[n] * inner.sign[axis];
            both.by[n] = sign[n] * inner.by[axis] + by[n];
        }
        return both;
    }
};

/// A byte of two indices, of the first and the second row's entry that is not 0, and three signs.
Pose turn_of(int bits) {
    Pose turn;
    turn.from = {bits & 3, bits >> 2 & 3, 3 - (bits & 3) - (bits >> 2 & 3)};
    for (int row = 0; row < 3; ++row)
        turn.sign[static_cast<std::size_t>(row)] = (bits >> (4 + row) & 1) != 0 ? -1 : 1;
    return turn;
}

class VoxReader {
  public:
    VoxReader(std::string_view bytes, const std::string& name)
        : bytes_(std::as_bytes(std::span(bytes.data(), bytes.size()))), name_(name) {}

    Result<VoxelData> run() {
        if (bytes_.size() < 8 + k_head || letters(0) != "VOX " || letters(8) != "MAIN")
            return Error{
                message(name_, ": is no MagicaVoxel file: it does not begin with \"VOX \" and a chunk MAIN; export one.")};
        read_chunks();
        if (fault_.empty() && models_.empty())
            fault_ = message(name_, ": has no model: give a file with one.");
        if (fault_.empty())
            place_models();
        if (fault_.empty())
            fill();
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
        Model& model = models_.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint32_t cells = number(at + 4 * static_cast<std::size_t>(axis));
            if (cells < 1 || cells > k_most_cells)
                return fail(at, "a model has ", cells, " cells along an axis: give 1 to ", k_most_cells, ".");
            model.size[axis] = static_cast<int>(cells);
        }
    }

    void read_cells(std::size_t at, std::size_t size) {
        if (models_.empty())
            return fail(at, "the chunk XYZI has no chunk SIZE before it; export the file again.");
        if (size < 4 || number(at) > (size - 4) / 4)
            return fail(at, "the chunk XYZI has ", size, " bytes, too few for its cells; export the file again.");
        Model& model = models_.back();
        if (model.first != 0)
            return fail(at, "the model has a second chunk XYZI; export the file again.");
        model.first = at + 4;
        model.count = number(at);
        for (std::size_t n = 0; n < model.count; ++n)
            if (const glm::ivec3 place = cell_of(model, n); glm::any(glm::greaterThanEqual(place, model.size)))
                return fail(model.first + 4 * n, "the cell ", place, " is outside of the model of ", model.size,
                            "; export the file again.");
    }

    // --- Nodes of the editor's scene -------------------------------------------------------------------------------------

    struct Node {
        Pose pose{};
        bool hidden = false;
        std::optional<std::uint32_t> parent{};
        std::optional<std::uint32_t> model{}; ///< of a shape
        bool is_placed = false;               ///< from here on pose and hidden are those in the scene
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
    // Pairs of a key and a value: a frame's turn (_r) and way (_t), a node's own _hidden.
    void take_pairs(std::size_t& at, std::size_t end, Node& node) {
        const auto count = take(at, end);
        for (std::uint32_t n = 0; count && n < *count && fault_.empty(); ++n) {
            const auto key = take_text(at, end);
            const auto value = key ? take_text(at, end) : std::nullopt;
            if (!value)
                return;
            if (*key == "_hidden")
                node.hidden = *value == "1";
            if (*key == "_t")
                take_way(at, *value, node.pose);
            if (*key == "_r") {
                const int bits = detail::number_of<int>(*value).value_or(-1);
                const Pose turn = turn_of(bits & 127);
                if (bits < 0 || bits > 127 || !turn.turns_whole())
                    return fail(at, "a node's _r is no turn along the axes; export the file again.");
                node.pose.from = turn.from;
                node.pose.sign = turn.sign;
            }
        }
    }
    void take_way(std::size_t at, std::string_view words, Pose& pose) {
        constexpr int k_farthest = 1'000'000; // thousands of these in a row are far from the ends of 64 bits
        for (std::int64_t& by : pose.by) {
            const auto cells = detail::number_of<std::int64_t>(detail::take_word(words));
            if (!cells || *cells > k_farthest || *cells < -k_farthest)
                return fail(at, "a node's _t is not three whole numbers of cells within +-", k_farthest,
                            "; export the file again.");
            by = *cells;
        }
    }

    void read_node(std::size_t at, std::size_t end) {
        const std::string_view kind = letters(at - k_head);
        const auto name = take(at, end);
        if (!name)
            return;
        Node& node = nodes_[*name];
        take_pairs(at, end, node);
        const auto own = [&](std::optional<std::uint32_t> child) {
            if (!child)
                return;
            Node& below = nodes_[*child];
            if (below.parent)
                fail(at, "the node ", *child, " is in two groups; export the file again.");
            below.parent = name;
        };
        if (!fault_.empty())
            return;
        if (kind == "nTRN") {
            own(take(at, end));
            (void)take(at, end); // reserved
            (void)take(at, end); // layer
            const auto frames = take(at, end);
            if (frames && *frames > 0 && fault_.empty())
                take_pairs(at, end, node); // as it is at the first frame
        } else if (const auto count = take(at, end); kind == "nGRP") {
            for (std::uint32_t n = 0; count && n < *count && fault_.empty(); ++n)
                own(take(at, end));
        } else if (count && *count > 0) {
            node.model = take(at, end); // the first of an animation
        }
    }

    // --- The cells -------------------------------------------------------------------------------------------------------

    struct Model {
        glm::ivec3 size{0};
        std::size_t first = 0, count = 0; ///< its cells in the file
    };
    struct Placement {
        const Model* model;
        Pose pose;
    };

    [[nodiscard]] glm::ivec3 cell_of(const Model& model, std::size_t n) const {
        const std::byte* const cell = &bytes_[model.first + 4 * n];
        return {std::to_integer<int>(cell[0]), std::to_integer<int>(cell[1]), std::to_integer<int>(cell[2])};
    }

    // A model turns about its middle, which is rounded down to a cell's low corner.
    void add(const Model& model, const Pose& pose) {
        Pose middle;
        for (std::size_t axis = 0; axis < 3; ++axis)
            middle.by[axis] = -(model.size[static_cast<int>(axis)] / 2);
        placements_.push_back({&model, pose.after(middle)});
    }

    void place_models() {
        const bool has_shapes =
            std::any_of(nodes_.begin(), nodes_.end(), [](const auto& node) { return node.second.model.has_value(); });
        if (!has_shapes && models_.size() > 1)
            fault_ = message(name_, ": has ", models_.size(),
                             " models and no scene that places them: save each in a file of its own.");
        if (!has_shapes)
            return add(models_.front(), {});
        std::vector<Node*> below;
        for (auto& [name, shape] : nodes_) {
            if (!shape.model)
                continue;
            if (*shape.model >= models_.size()) {
                fault_ =
                    message(name_, ": a shape names model ", *shape.model, " of ", models_.size(), "; export the file again.");
                return;
            }
            below.clear();
            for (Node* node = &shape; !node->is_placed; node = &nodes_[*node->parent]) {
                below.push_back(node);
                if (!node->parent)
                    break;
                if (below.size() > nodes_.size()) {
                    fault_ = message(name_, ": its nodes go in a circle; export the file again.");
                    return;
                }
            }
            for (; !below.empty(); below.pop_back()) {
                Node& node = *below.back();
                if (node.parent) {
                    const Node& above = nodes_[*node.parent];
                    node.pose = above.pose.after(node.pose);
                    node.hidden = node.hidden || above.hidden;
                }
                node.is_placed = true;
            }
            if (!shape.hidden)
                add(models_[*shape.model], shape.pose);
        }
        if (placements_.empty())
            fault_ = message(name_, ": all of its models are hidden: show one.");
    }

    // The union of all placements, so that y points up.
    void fill() {
        constexpr std::int64_t k_far = std::numeric_limits<std::int64_t>::max();
        std::array<std::int64_t, 3> low{k_far, k_far, k_far}, high{-k_far, -k_far, -k_far};
        std::size_t closed = 0;
        for (const Placement& placement : placements_) {
            const glm::ivec3 size = placement.model->size;
            for (const auto& corner : {placement.pose.of({0, 0, 0}), placement.pose.of({size.x - 1, size.y - 1, size.z - 1})})
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    low[axis] = std::min(low[axis], corner[axis]);
                    high[axis] = std::max(high[axis], corner[axis] + 1);
                }
            closed += placement.model->count;
        }
        if (closed == 0) {
            fault_ = message(name_, ": its model has no voxel: fill one at least.");
            return;
        }
        std::uint64_t all = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t cells = high[axis] - low[axis];
            if (cells > VoxelGrid::k_max_axis_cells || (all *= static_cast<std::uint64_t>(cells)) > VoxelGrid::k_max_cells) {
                fault_ =
                    message(name_, ": its models reach over more than ", VoxelGrid::k_max_axis_cells, " cells along an axis, or ",
                            VoxelGrid::k_max_cells, " in all: save a part of the scene in a file of its own.");
                return;
            }
        }
        if (closed > k_most_voxels) {
            fault_ =
                message(name_, ": its models have ", closed, " voxels at all their places: give at most ", k_most_voxels, ".");
            return;
        }
        data_.cells = {static_cast<int>(high[0] - low[0]), static_cast<int>(high[2] - low[2]),
                       static_cast<int>(high[1] - low[1])};
        data_.closed.assign(all, 0);
        for (const Placement& placement : placements_)
            for (std::size_t n = 0; n < placement.model->count; ++n) {
                const glm::ivec3 cell = cell_of(*placement.model, n);
                const auto at = placement.pose.of({cell.x, cell.y, cell.z});
                const std::int64_t x = at[0] - low[0], y = at[2] - low[2], z = high[1] - 1 - at[1];
                data_.closed[static_cast<std::size_t>((z * data_.cells.y + y) * data_.cells.x + x)] = 1;
            }
    }

    std::span<const std::byte> bytes_;
    const std::string& name_;
    std::vector<Model> models_;
    std::vector<Placement> placements_;
    std::map<std::uint32_t, Node> nodes_;
    VoxelData data_;
    std::string fault_;
};

} // namespace

Result<VoxelData> read_vox(std::string_view bytes, const std::string& name) {
    return detail::where_memory_lasts([&] { return VoxReader(bytes, name).run(); });
}

} // namespace windrow::scene
