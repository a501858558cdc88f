#include "vegetation/files/gltf_text.h"

#include "fluid/core/message.h"
#include "scene/json_document.h"
#include "vegetation/files/gltf_buffers.h"
#include "vegetation/files/mesh_file.h"

#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

using nlohmann::json;

constexpr std::size_t k_max_nodes = 65536;
constexpr int k_deepest_node = 24; // Assimp walks them by recursion
// Assimp copies the numbers of an accessor for each primitive that names it. Some files share their vertices among parts: so many
// vertices, and as many corners, beside those that the bytes of the buffers can hold.
constexpr std::size_t k_max_copies = 2 * k_max_vertices;
enum ComponentType : std::size_t { k_byte = 5121, k_short = 5123, k_int = 5125, k_float = 5126 };

// Stops the walk at the first fault; caught in check_gltf, so that no exception leaves this file.
struct Fault {
    std::string text;
};

// A kept accessor.
struct Accessor {
    std::size_t number = 0, count = 0;
};

class Copier {
  public:
    Copier(const json& source, std::string_view binary, const std::filesystem::path& path, windrow::detail::InputBudget& budget)
        : source_(source), binary_(binary), path_(path), budget_(budget) {}

    GltfText run() {
        if (!source_.is_object())
            fail("$", "is not an object: give a glTF 2.0 file.");
        if (source_.contains("extensionsRequired") && !source_["extensionsRequired"].empty())
            fail("$.extensionsRequired", "is not empty: save the file without compression and other extensions.");
        out_ = {{"asset", {{"version", "2.0"}}},
                {"accessors", json::array()},
                {"bufferViews", json::array()},
                {"buffers", json::array()},
                {"meshes", json::array()}};
        for (std::size_t i = 0; i < list("materials").size(); ++i) {
            const json& material = item("materials", i);
            const bool named = material.contains("name") && material["name"].is_string();
            out_["materials"].push_back(
                {{"name", named ? material["name"].get<std::string>().substr(0, 255) : message("material ", i)}});
        }
        for (std::size_t i = 0; i < list("meshes").size(); ++i)
            out_["meshes"].push_back({{"primitives", primitives(item("meshes", i), message("$.meshes[", i, "]"))}});
        nodes();
        GltfText result;
        result.json = out_.dump(-1, ' ', true, json::error_handler_t::replace);
        result.buffers = std::move(buffers_);
        return result;
    }

  private:
    template <class... Words>
    [[noreturn]] void fail(const std::string& place, const Words&... words) const {
        throw Fault{message(path_.string(), ": ", place, " ", words...)};
    }

    const json& list(const char* key) const {
        static const json none = json::array();
        const auto found = source_.find(key);
        if (found == source_.end())
            return none;
        if (!found->is_array() || found->size() > k_max_nodes)
            fail(message("$.", key), "is not a list, or has more items than ", k_max_nodes, ": give a list.");
        return *found;
    }
    const json& item(const char* key, std::size_t index) const {
        const json& items = list(key);
        if (index >= items.size() || !items[index].is_object())
            fail(message("$.", key, "[", index, "]"), "is missing or not an object: add it.");
        return items[index];
    }
    // A count or index; `missing` where there is none.
    std::size_t whole(const json& object, const char* key, std::size_t missing, const std::string& place) const {
        const auto found = object.find(key);
        if (found == object.end())
            return missing;
        if (!found->is_number_unsigned() || found->get<std::uint64_t>() > k_max_bytes)
            fail(place + "." + key, "is not a count: give 0 to ", k_max_bytes, ".");
        return found->get<std::size_t>();
    }

    std::size_t buffer(std::size_t index) {
        if (const auto known = buffer_numbers_.find(index); known != buffer_numbers_.end())
            return known->second;
        auto bytes = read_gltf_buffer(item("buffers", index), index, binary_, path_, budget_);
        if (!bytes)
            throw Fault{bytes.error()};
        if ((bytes_ += bytes->size()) > k_max_bytes)
            fail("$.buffers", "have more than ", k_max_bytes, " bytes: give fewer.");
        return buffer_numbers_[index] = keep_buffer(*std::move(bytes));
    }

    std::size_t keep_buffer(std::string bytes) {
        const std::size_t number = buffers_.size();
        out_["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", message(number, ".bin")}});
        buffers_.push_back(std::move(bytes));
        return number;
    }

    // An accessor of this type, copied with a view of its own.
    Accessor accessor(const json& owner, const char* key, const char* type, std::size_t components, const std::string& place) {
        constexpr std::size_t k_none = k_max_bytes + 1;
        const std::size_t index = whole(owner, key, k_none, place);
        const json& source = item("accessors", index);
        const std::string here = message("$.accessors[", index, "]");
        const std::size_t component = whole(source, "componentType", 0, here), count = whole(source, "count", 0, here);
        const bool indices = components == 1;
        const bool fits = indices ? component == k_byte || component == k_short || component == k_int : component == k_float;
        if (!fits || !source.contains("type") || source["type"] != type)
            fail(here, "is the ", key, " of ", place, " and not ",
                 indices ? "SCALAR of unsigned integers" : std::string(type) + " of floats", ": give those.");
        if (source.contains("sparse") || !source.contains("bufferView"))
            fail(here, "is sparse or has no view: give all of its numbers.");
        if (count == 0 || count > 3 * k_max_triangles || (!indices && count > k_max_vertices))
            fail(here + ".count", "is ", count, ": give at least 1, and at most ", k_max_vertices, " vertices.");

        const std::size_t view_index = whole(source, "bufferView", 0, here);
        const json& view = item("bufferViews", view_index);
        const std::string there = message("$.bufferViews[", view_index, "]");
        const std::size_t entry = components * (component == k_byte ? 1 : component == k_short ? 2 : 4);
        const std::size_t stride = whole(view, "byteStride", entry, there);
        const std::size_t begin = whole(view, "byteOffset", 0, there), length = whole(view, "byteLength", 0, there);
        const std::size_t offset = whole(source, "byteOffset", 0, here);
        const std::size_t number = buffer(whole(view, "buffer", k_none, there));
        if (stride < entry || stride > 252 || (indices && stride != entry))
            fail(there + ".byteStride", "is ", stride, ": give ", entry, indices ? "." : " to 252.");
        if (begin > buffers_[number].size() || length > buffers_[number].size() - begin)
            fail(there, "reaches beyond its buffer: give a whole buffer.");
        if (offset > length || (count - 1) * stride + entry > length - offset)
            fail(here, "reaches beyond its view: give a whole view.");
        check_numbers(std::string_view(buffers_[number]).substr(begin + offset), count, stride, components, component, here);

        const Accessor kept{out_["accessors"].size(), count};
        json view_copy{{"buffer", number}, {"byteOffset", begin + offset}, {"byteLength", length - offset}};
        if (stride != entry)
            view_copy = packed(index, std::string_view(buffers_[number]).substr(begin + offset), count, stride, entry);
        out_["bufferViews"].push_back(std::move(view_copy));
        out_["accessors"].push_back(
            {{"bufferView", out_["bufferViews"].size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
        return kept;
    }

    // A view of a buffer of its own, with the entries alone: of interleaved ones Assimp expects a whole stride behind the last too.
    json packed(std::size_t accessor, std::string_view bytes, std::size_t count, std::size_t stride, std::size_t entry) {
        if (const auto known = packed_.find(accessor); known != packed_.end())
            return known->second;
        // Accessors of a mesh interleave and do not overlap; others would make many times the file's bytes.
        if ((packed_bytes_ += count * entry) > bytes_)
            fail(message("$.accessors[", accessor, "]"), "overlaps others with a stride: give accessors that do not overlap.");
        std::string entries;
        entries.reserve(count * entry);
        for (std::size_t i = 0; i < count; ++i)
            entries += bytes.substr(i * stride, entry);
        return packed_[accessor] = {{"buffer", keep_buffer(std::move(entries))}, {"byteLength", count * entry}};
    }

    // Floats are finite; of indices the highest is noted.
    void check_numbers(std::string_view bytes, std::size_t count, std::size_t stride, std::size_t components,
                       std::size_t component, const std::string& here) {
        highest_ = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const char* entry = bytes.data() + i * stride;
            for (std::size_t c = 0; component == k_float && c < components; ++c) {
                float value;
                std::memcpy(&value, entry + 4 * c, sizeof value);
                if (!std::isfinite(value))
                    fail(here, "has a number that is not finite, entry ", i, ": give finite ones.");
            }
            std::uint32_t value = 0;
            if (component != k_float)
                std::memcpy(&value, entry,
                            component == k_byte    ? 1
                            : component == k_short ? 2
                                                   : 4); // little-endian, as the machine
            highest_ = std::max(highest_, value);
        }
    }

    json primitives(const json& mesh, const std::string& place) {
        json kept = json::array();
        if (!mesh.contains("primitives") || !mesh["primitives"].is_array() || mesh["primitives"].size() > k_max_parts)
            fail(place + ".primitives", "is missing, or a list of more than ", k_max_parts, ": give a list.");
        for (const json& source : mesh["primitives"]) {
            if (!source.is_object() || !source.contains("attributes") || !source["attributes"].is_object())
                fail(place + ".primitives", "has one without attributes: give them.");
            const std::size_t mode = whole(source, "mode", 4, place);
            if (mode < 4) // points and lines
                continue;
            if (mode != 4)
                fail(place + ".primitives", "has one of mode ", mode, ": give triangles, mode 4.");
            kept.push_back(primitive(source, place + ".primitives"));
        }
        return kept;
    }

    json primitive(const json& source, const std::string& place) {
        const json& attributes = source["attributes"];
        const Accessor positions = accessor(attributes, "POSITION", "VEC3", 3, place);
        json kept{{"mode", 4}, {"attributes", {{"POSITION", positions.number}}}};
        const auto other = [&](const char* key, const char* type, std::size_t components) {
            if (!attributes.contains(key))
                return;
            const Accessor numbers = accessor(attributes, key, type, components, place);
            if (numbers.count != positions.count)
                fail(place, "has ", numbers.count, " entries of ", key, " and ", positions.count, " of POSITION: give as many.");
            kept["attributes"][key] = numbers.number;
        };
        other("NORMAL", "VEC3", 3);
        other("TEXCOORD_0", "VEC2", 2);
        std::size_t corners = positions.count;
        if (source.contains("indices")) {
            const Accessor indices = accessor(source, "indices", "SCALAR", 1, place);
            if (highest_ >= positions.count)
                fail(place, "has the index ", highest_, ": give 0 to ", positions.count - 1, ".");
            corners = indices.count;
            kept["indices"] = indices.number;
        }
        vertices_ += positions.count;
        corners_ += corners;
        if (vertices_ > k_max_copies + bytes_ / sizeof(glm::vec3) || corners_ > k_max_copies + bytes_)
            fail(place, "take ", vertices_, " vertices and ", corners_, " corners, counting each use of an accessor, from ",
                 bytes_, " bytes: name each accessor once, or a few times.");
        if (corners % 3 != 0)
            fail(place, "has ", corners, " corners: give three a triangle.");
        if (source.contains("material")) {
            const std::size_t material = whole(source, "material", 0, place);
            (void)item("materials", material);
            kept["material"] = material;
        }
        return kept;
    }

    json numbers(const json& node, const char* key, std::size_t count, const std::string& place) const {
        const json& values = node[key];
        bool fits = values.is_array() && values.size() == count;
        for (const json& value : values)
            fits = fits && value.is_number() && std::abs(value.get<double>()) <= 1e9;
        if (!fits)
            fail(place + "." + key, "is not ", count, " finite numbers: give those.");
        return values;
    }

    void nodes() {
        const json& sources = list("nodes");
        std::vector<std::size_t> parents(sources.size(), k_max_nodes);
        out_["nodes"] = json::array();
        for (std::size_t i = 0; i < sources.size(); ++i) {
            const json& source = item("nodes", i);
            const std::string place = message("$.nodes[", i, "]");
            json kept = json::object();
            for (const auto& [key, count] :
                 {std::pair("matrix", 16), std::pair("translation", 3), std::pair("rotation", 4), std::pair("scale", 3)})
                if (source.contains(key))
                    kept[key] = numbers(source, key, static_cast<std::size_t>(count), place);
            if (source.contains("mesh")) {
                const std::size_t mesh = whole(source, "mesh", 0, place);
                (void)item("meshes", mesh);
                if (!out_["meshes"][mesh]["primitives"].empty())
                    kept["mesh"] = mesh;
            }
            if (source.contains("children")) {
                kept["children"] = children(source["children"], i, parents, place);
                if (kept["children"].empty())
                    kept.erase("children");
            }
            out_["nodes"].push_back(std::move(kept));
        }
        json roots = json::array();
        for (std::size_t i = 0; i < parents.size(); ++i) {
            int depth = 0;
            for (std::size_t at = i; parents[at] < k_max_nodes; at = parents[at])
                if (++depth > k_deepest_node)
                    fail(message("$.nodes[", i, "]"), "is in a cycle, or deeper than ", k_deepest_node, " nodes: give a tree.");
            if (parents[i] == k_max_nodes)
                roots.push_back(i);
        }
        out_["scenes"] = {{{"nodes", roots}}};
        out_["scene"] = 0;
    }

    json children(const json& values, std::size_t parent, std::vector<std::size_t>& parents, const std::string& place) const {
        for (const json& child : values) {
            if (!values.is_array() || !child.is_number_unsigned() || child.get<std::uint64_t>() >= parents.size())
                fail(place + ".children", "names a node that does not exist: give 0 to ", parents.size() - 1, ".");
            std::size_t& known = parents[child.get<std::size_t>()];
            if (known != k_max_nodes)
                fail(place + ".children", "names a node that has a parent: give each node one.");
            known = parent;
        }
        return values;
    }

    const json& source_;
    std::string_view binary_;
    const std::filesystem::path& path_;
    windrow::detail::InputBudget& budget_;
    json out_;
    std::vector<std::string> buffers_;
    std::map<std::size_t, std::size_t> buffer_numbers_;
    std::size_t bytes_ = 0, packed_bytes_ = 0, vertices_ = 0, corners_ = 0;
    std::map<std::size_t, json> packed_;
    std::uint32_t highest_ = 0;
};

} // namespace

Result<GltfText> check_gltf(const std::string& bytes, const std::filesystem::path& path, windrow::detail::InputBudget& budget) {
    const auto parts = split_gltf(bytes, path.string());
    if (!parts)
        return Error{parts.error()};
    const auto source = windrow::scene::parse_json(parts->json, path.string());
    if (!source)
        return Error{source.error()};
    try {
        return Copier(*source, parts->binary, path, budget).run();
    } catch (const Fault& fault) {
        return Error{fault.text};
    }
}

} // namespace windrow::vegetation::fur
