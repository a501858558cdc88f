// A mesh as bytes: what `create` was given, and all that it found. In the envelope of core/bytes.h: lists as u64 count and items, each a
// row of 32-bit numbers, or bytes.
#include "fluid/core/bytes.h"
#include "fluid/shapes/triangle_mesh.h"
#include "fluid/solids/mesh_signs.h"
#include "fluid/solids/mesh_surface.h"
#include "fluid/solids/mesh_tree.h"

#include <bit>
#include <cmath>

namespace windrow {
namespace {

using detail::MeshEdges, detail::MeshSigns, detail::MeshTree;

constexpr detail::Format k_mesh_format{"WINDMESH", 1, "made mesh", "TriangleMesh::save"};

template <class Item>
void copy_words(std::byte* to, const std::byte* from, std::size_t bytes) {
    static_assert(std::is_trivially_copyable_v<Item> && (sizeof(Item) == 1 || sizeof(Item) % 4 == 0));
    if constexpr (std::endian::native == std::endian::little || sizeof(Item) == 1)
        std::memcpy(to, from, bytes);
    else
        for (std::size_t n = 0; n < bytes; ++n)
            to[n] = from[(n & ~std::size_t{3}) + 3 - (n & 3)];
}

class WordWriter {
  public:
    static constexpr bool k_reads = false;

    template <class Item>
    void value(const Item& item) {
        append<Item>(&item, sizeof item);
    }
    template <class Item>
    void list(const std::vector<Item>& items) {
        const auto count = static_cast<std::uint64_t>(items.size());
        bytes_.resize(bytes_.size() + sizeof count);
        detail::store_number(&bytes_[bytes_.size() - sizeof count], count);
        append<Item>(items.data(), items.size() * sizeof(Item));
    }
    [[nodiscard]] std::vector<std::byte> finish() && {
        detail::seal(bytes_, k_mesh_format);
        return std::move(bytes_);
    }

  private:
    template <class Item>
    void append(const void* items, std::size_t size) {
        if (size == 0)
            return;
        bytes_.resize(bytes_.size() + size);
        copy_words<Item>(bytes_.data() + bytes_.size() - size, static_cast<const std::byte*>(items), size);
    }

    std::vector<std::byte> bytes_ = detail::begin_bytes(0);
};

class WordReader {
  public:
    static constexpr bool k_reads = true;

    explicit WordReader(std::span<const std::byte> rest) : rest_(rest) {}

    template <class Item>
    void value(Item& item) {
        take<Item>(&item, 1);
    }
    template <class Item>
    void list(std::vector<Item>& items) {
        if (rest_.size() < sizeof(std::uint64_t))
            whole_ = false;
        if (!whole_)
            return;
        const auto count = detail::load_number<std::uint64_t>(rest_.data());
        rest_ = rest_.subspan(sizeof count);
        whole_ = count <= rest_.size() / sizeof(Item);
        if (!whole_)
            return;
        items.resize(static_cast<std::size_t>(count));
        take<Item>(items.data(), items.size());
    }
    [[nodiscard]] bool ended() const { return whole_ && rest_.empty(); }

  private:
    template <class Item>
    void take(void* items, std::size_t count) {
        whole_ = whole_ && count <= rest_.size() / sizeof(Item);
        if (!whole_ || count == 0)
            return;
        copy_words<Item>(static_cast<std::byte*>(items), rest_.data(), count * sizeof(Item));
        rest_ = rest_.subspan(count * sizeof(Item));
    }

    std::span<const std::byte> rest_;
    bool whole_ = true;
};

/// A part behind a pointer, which may be null.
template <class Part>
void pass_part(auto& archive, auto& part) {
    std::uint32_t there = part != nullptr ? 1 : 0;
    archive.value(there);
    if constexpr (std::remove_cvref_t<decltype(archive)>::k_reads) {
        if (there == 0)
            return;
        auto made = std::make_unique<Part>();
        Part::pass(archive, *made);
        part = std::move(made);
    } else if (part != nullptr) {
        Part::pass(archive, *part);
    }
}

} // namespace

void detail::MeshEdges::pass(auto& archive, auto& edges) {
    archive.list(edges.edges);
    pass_part<MeshTree>(archive, edges.tree);
}

void TriangleMesh::pass(auto& archive, auto& mesh) {
    archive.list(mesh.data_.vertices);
    archive.list(mesh.data_.triangles);
    archive.value(mesh.low_);
    archive.value(mesh.high_);
    archive.value(mesh.thickness_);
    pass_part<MeshTree>(archive, mesh.tree_);
    pass_part<MeshTree>(archive, mesh.surface_);
    pass_part<MeshSigns>(archive, mesh.signs_);
    pass_part<MeshEdges>(archive, mesh.edges_);
}

Result<std::vector<std::byte>> TriangleMesh::save() const {
    return detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        WordWriter writer;
        pass(writer, *this);
        return std::move(writer).finish();
    });
}

Result<std::shared_ptr<const TriangleMesh>> TriangleMesh::load(std::span<const std::byte> bytes) {
    return detail::where_memory_lasts([&]() -> Result<std::shared_ptr<const TriangleMesh>> {
        const auto content = detail::unseal(bytes, k_mesh_format);
        if (!content)
            return content.failure();
        std::shared_ptr<TriangleMesh> mesh(new TriangleMesh());
        WordReader reader(*content);
        pass(reader, *mesh);
        // Nothing in the bytes leads out of a list, whoever wrote them.
        if (!reader.ended() || !detail::check_parts(mesh->data_) || !mesh->is_sound())
            return Error{detail::message(k_mesh_format.name, " cannot be used: its parts do not fit one another; give what ",
                                         k_mesh_format.writer, " returned.")};
        mesh->hash_ = hash_of(mesh->data_);
        return std::shared_ptr<const TriangleMesh>(std::move(mesh));
    });
}

bool TriangleMesh::is_sound() const {
    if (!tree_ || !signs_ || !edges_ || !std::isfinite(thickness_))
        return false;
    return tree_->is_sound(data_.triangles.size()) && (!surface_ || surface_->is_sound(~std::size_t{0})) && signs_->is_sound() &&
           (edges_->tree == nullptr || edges_->tree->is_sound(edges_->edges.size()));
}

} // namespace windrow
