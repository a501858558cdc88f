#include "vegetation/files/three_ds_chunks.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

constexpr std::size_t k_head = 6; // kind and length
constexpr unsigned k_unknown = 0xfefe;
constexpr std::size_t k_longest_name = 64;

class ChunkWalker {
  public:
    ChunkWalker(std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    std::string run() {
        if (bytes_.size() < k_head || word(0) != 0x4d4d)
            return message(name_, " is not a 3DS file: its first chunk is of another kind; give another file.");
        children(0, bytes_.size(), 0);
        if (fault_.empty() && triangles_ == 0)
            return message(name_, " has no triangles: give a mesh of triangles.");
        return fault_;
    }

  private:
    // The one mesh of an object.
    struct Lists {
        std::size_t vertices = 0, faces = 0, uvs = 0;
        unsigned highest = 0;
    };

    unsigned byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }
    unsigned word(std::size_t at) const { return byte(at) | byte(at + 1) << 8; }
    std::size_t length(std::size_t at) const { return word(at + 2) | static_cast<std::size_t>(word(at + 4)) << 16; }
    float real(std::size_t at) const {
        float value;
        std::memcpy(&value, bytes_.data() + at, sizeof value);
        return value;
    }
    void hide(std::size_t at) { bytes_[at] = bytes_[at + 1] = static_cast<char>(k_unknown & 0xff); }

    template <class... Words>
    void fail(std::size_t at, const Words&... words) {
        if (fault_.empty())
            fault_ = message(name_, ": the chunk at byte ", at, " ", words...);
    }

    // The chunks from `at` to `end`, which lie in one of the kind `parent`.
    void children(std::size_t at, std::size_t end, unsigned parent) {
        while (fault_.empty() && at < end) {
            if (end - at < k_head || length(at) < k_head || length(at) > end - at)
                return fail(at, "does not fit into its parent chunk: give the whole file.");
            chunk(at, at + length(at), parent);
            at += length(at);
        }
    }

    void chunk(std::size_t at, std::size_t end, unsigned parent) {
        const std::size_t content = at + k_head;
        switch (parent << 16 | word(at)) {
        case 0x0000'4d4d:
        case 0x4d4d'3d3d:
        case 0x3d3d'afff:
            return children(content, end, word(at));
        case 0xafff'a000:
            text(at, content, end);
            return;
        case 0x3d3d'4000:
            lists_ = {};
            return children(text(at, content, end), end, 0x4000);
        case 0x4000'4100:
            return mesh(at, content, end);
        case 0x4100'4110:
            lists_.vertices = list(at, content, end, 12, true, lists_.vertices);
            for (std::size_t i = 0; i < 3 * lists_.vertices; ++i)
                if (!std::isfinite(real(content + 2 + 4 * i)))
                    return fail(at, "has a vertex that is not finite: give finite ones.");
            return;
        case 0x4100'4120:
            return faces(at, content, end);
        case 0x4120'4130:
            return faces_of_material(at, content, end);
        case 0x4100'4140:
            lists_.uvs = list(at, content, end, 8, true, lists_.uvs);
            return;
        default:
            hide(at);
        }
    }

    void mesh(std::size_t at, std::size_t content, std::size_t end) {
        lists_ = {};
        children(content, end, 0x4100);
        if (!fault_.empty())
            return;
        if (lists_.vertices == 0 || lists_.faces == 0)
            return hide(at);
        if (lists_.highest >= lists_.vertices)
            return fail(at, "has a face with the vertex ", lists_.highest, ": give 0 to ", lists_.vertices - 1, ".");
        if (lists_.uvs != 0 && lists_.uvs != lists_.vertices)
            return fail(at, "has ", lists_.uvs, " uv: give one for each of ", lists_.vertices, " vertices.");
        triangles_ += lists_.faces;
        vertices_ += lists_.vertices;
        if (triangles_ > k_max_triangles || vertices_ > k_max_vertices)
            fail(at, "exceeds the limits: give at most ", k_max_vertices, " vertices and ", k_max_triangles, " triangles.");
    }

    // A list that begins with its number of entries, which it must hold (and fill, if it is `alone`), once.
    std::size_t list(std::size_t at, std::size_t content, std::size_t end, std::size_t entry, bool alone, std::size_t before) {
        const std::size_t count = end - content >= 2 ? word(content) : 0;
        const std::size_t size = 2 + count * entry;
        if (end - content < size || (alone && end - content != size) || before != 0) {
            fail(at, "has a list of ", count, " entries in ", end - content, " bytes, or a second one: give one complete list.");
            return 0;
        }
        return count;
    }

    void faces(std::size_t at, std::size_t content, std::size_t end) {
        lists_.faces = list(at, content, end, 8, false, lists_.faces);
        for (std::size_t i = 0; i < lists_.faces; ++i)
            for (std::size_t corner = 0; corner < 3; ++corner)
                lists_.highest = std::max(lists_.highest, word(content + 2 + 8 * i + 2 * corner));
        if (fault_.empty())
            children(content + 2 + 8 * lists_.faces, end, 0x4120);
    }

    void faces_of_material(std::size_t at, std::size_t content, std::size_t end) {
        const std::size_t after = text(at, content, end);
        const std::size_t count = list(at, after, end, 2, true, 0);
        for (std::size_t i = 0; i < count; ++i)
            if (word(after + 2 + 2 * i) >= lists_.faces)
                return fail(at, "names the face ", word(after + 2 + 2 * i), ": give 0 to ", lists_.faces - 1, ".");
    }

    // Where the text ends that a zero byte ends.
    std::size_t text(std::size_t at, std::size_t content, std::size_t end) {
        const std::size_t zero = bytes_.find('\0', content);
        if (zero >= std::min(end, content + k_longest_name)) {
            fail(at, "has an unterminated name: give one of at most ", k_longest_name - 1, " bytes.");
            return end;
        }
        return zero + 1;
    }

    std::string& bytes_;
    const std::string& name_;
    Lists lists_;
    std::size_t triangles_ = 0, vertices_ = 0;
    std::string fault_;
};

} // namespace

Result<std::string> check_three_ds(std::string bytes, const std::string& name) {
    if (std::string fault = ChunkWalker(bytes, name).run(); !fault.empty())
        return Error{std::move(fault)};
    return bytes;
}

} // namespace windrow::vegetation::fur
