// Based on: ephtracy, "MagicaVoxel .vox File Format", version 150.
#include "scene/vox_file.h"

#include "fluid/core/bytes.h"
#include "fluid/core/message.h"

#include <span>

namespace windrow::scene {
namespace {

using detail::message;

constexpr int k_most_cells = 256; // a coordinate is a byte
constexpr std::size_t k_head = 12;

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
        data_.cells = {size_.x, size_.z, size_.y};
        data_.closed.assign(static_cast<std::size_t>(size_.x) * size_.y * size_.z, 0);
        for (std::size_t n = 0, count = number(at); n < count; ++n) {
            const std::byte* const cell = &bytes_[at + 4 + 4 * n];
            const glm::ivec3 place(std::to_integer<int>(cell[0]), std::to_integer<int>(cell[1]), std::to_integer<int>(cell[2]));
            if (place.x >= size_.x || place.y >= size_.y || place.z >= size_.z)
                return fail(at + 4 + 4 * n, "the cell ", place, " is outside of the model of ", size_,
                            "; export the file again.");
            const glm::ivec3 own(place.x, place.z, size_.y - 1 - place.y);
            data_.closed[(static_cast<std::size_t>(own.z) * data_.cells.y + own.y) * data_.cells.x + own.x] = 1;
        }
    }

    std::span<const std::byte> bytes_;
    const std::string& name_;
    glm::ivec3 size_{0};
    int models_ = 0;
    VoxelData data_;
    std::string fault_;
};

} // namespace

Result<VoxelData> read_vox(std::string_view bytes, const std::string& name) {
    return detail::where_memory_lasts([&] { return VoxReader(bytes, name).run(); });
}

} // namespace windrow::scene
