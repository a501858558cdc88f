#include "vegetation/files/gltf_file.h"

#include "fluid/core/message.h"
#include "scene/json_document.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/files/mesh_folder.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <fstream> // tinygltf uses it and does not include it without files
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <utility>

// The whole of tinygltf, compiled here, so that sanitizers and the fuzzer see it: no files and no images of its own.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

namespace windrow::vegetation::fur {
namespace {

using nlohmann::json;
using windrow::detail::message;

constexpr std::size_t k_max_items = 65536;      // of a list
constexpr std::size_t k_max_values = 2'000'000; // of the JSON that tinygltf reads: some take 500 bytes there
constexpr int k_deepest_node = 24;
// The URI that the binary chunk of a GLB gets: no file in a folder may have such a name.
constexpr std::string_view k_binary = ":binary";

// Keys of whole numbers, and of nodes those of lists, with their lengths.
constexpr std::array<std::string_view, 14> k_counts{"POSITION",   "NORMAL",     "TEXCOORD_0",    "indices",    "material",
                                                    "mode",       "mesh",       "buffer",        "bufferView", "byteOffset",
                                                    "byteLength", "byteStride", "componentType", "count"};
constexpr std::array<std::pair<std::string_view, std::size_t>, 4> k_lists{
    {{"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}}};

// Stops the walk at the first fault; caught in read_gltf, so that no exception leaves this file.
struct Fault {
    std::string text;
};

// An accessor's entries, all within their buffer.
struct Entries {
    const unsigned char* bytes = nullptr;
    std::size_t count = 0, stride = 0, size = 0;
    int component = TINYGLTF_COMPONENT_TYPE_FLOAT;
    bool normalized = false; // whole numbers: the largest is 1, the least of those with a sign -1

    template <class Vector>
    [[nodiscard]] Vector vector(std::size_t i) const {
        Vector value;
        for (int axis = 0; axis < Vector::length(); ++axis)
            value[axis] = number(i, static_cast<std::size_t>(axis));
        return value;
    }
    [[nodiscard]] float number(std::size_t i, std::size_t axis) const {
        const unsigned char* const at = bytes + i * stride;
        switch (component) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return whole<std::int8_t>(at, axis);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return whole<std::uint8_t>(at, axis);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return whole<std::int16_t>(at, axis);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return whole<std::uint16_t>(at, axis);
        default:
            return plain<float>(at, axis);
        }
    }
    template <class Number>
    [[nodiscard]] static Number plain(const unsigned char* at, std::size_t axis) {
        Number value;
        std::memcpy(&value, at + axis * sizeof value, sizeof value); // little-endian, as the machine
        return value;
    }
    template <class Number>
    [[nodiscard]] float whole(const unsigned char* at, std::size_t axis) const {
        const auto value = static_cast<float>(plain<Number>(at, axis));
        return normalized ? std::max(value / static_cast<float>(std::numeric_limits<Number>::max()), -1.0f) : value;
    }
    [[nodiscard]] std::uint32_t index(std::size_t i) const {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes + i * stride, size); // little-endian, as the machine
        return value;
    }
};

class GltfReader {
  public:
    GltfReader(const std::filesystem::path& path, windrow::detail::InputBudget& budget) : path_(path), budget_(budget) {}

    Soup run(std::string_view bytes) {
        load(text_of(bytes));
        std::vector<bool> is_child(model_.nodes.size());
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            for (const int child : model_.nodes[i].children) {
                (void)item(model_.nodes, child, "nodes");
                if (is_child[static_cast<std::size_t>(child)])
                    fail(message("$.nodes[", i, "].children"), "names a node that has a parent: give each node one.");
                is_child[static_cast<std::size_t>(child)] = true;
            }
        for (std::size_t i = 0; i < model_.nodes.size(); ++i)
            if (!is_child[i])
                add_node(static_cast<int>(i), glm::dmat4(1.0), 0);
        if (nodes_ != model_.nodes.size())
            fail("$.nodes", "has nodes in a cycle: give a tree.");
        if (corners_ == 0)
            throw Fault{message(path_.string(), " has no triangles: give a mesh of triangles.")};
        return std::move(soup_);
    }

  private:
    template <class... Words>
    [[noreturn]] void fail(std::string_view place, const Words&... words) const {
        throw Fault{message(path_.string(), ": ", place, " ", words...)};
    }

    // The JSON for tinygltf, and where the GLB's binary chunk is. tinygltf 2.7 itself reads up to 8 bytes beyond a GLB whose last
    // chunk is longer than the file.
    std::string text_of(std::string_view bytes) {
        std::string_view text = bytes;
        if (bytes.starts_with("glTF")) {
            constexpr std::size_t k_header = 12, k_head = 8;
            const auto word = [&](std::size_t at) {
                std::uint32_t value;
                std::memcpy(&value, bytes.data() + at, sizeof value); // little-endian, as the machine
                return value;
            };
            if (bytes.size() < k_header + k_head || word(4) != 2 || word(8) != bytes.size())
                throw Fault{
                    message(path_.string(), " is not a GLB 2, or has another length than its header: give a complete GLB 2.")};
            text = {};
            for (std::size_t at = k_header; at < bytes.size();) {
                if (bytes.size() - at < k_head || word(at) > bytes.size() - at - k_head)
                    throw Fault{message(path_.string(), " has a chunk at byte ", at,
                                        " that is longer than the file: give a complete GLB.")};
                const std::string_view content = bytes.substr(at + k_head, word(at)), kind = bytes.substr(at + 4, 4);
                if (at == k_header && kind == "JSON")
                    text = content;
                else if (binary_.empty() && kind == std::string_view("BIN\0", 4))
                    binary_ = content;
                at += k_head + content.size();
            }
        }
        auto source = windrow::scene::parse_json(text, path_.string());
        if (!source)
            throw Fault{source.error()};
        return kept(*source).dump();
    }

    // Without what is not used: tinygltf would open images, and follow offsets of theirs that it has not checked.
    json kept(json& source) {
        if (!source.is_object())
            fail("$", "is not an object: give a glTF 2.0 file.");
        if (source.contains("extensionsRequired"))
            for (const json& extension : source["extensionsRequired"]) {
                if (extension != "KHR_mesh_quantization")
                    fail("$.extensionsRequired",
                         "has others than KHR_mesh_quantization: save the file without compression and other extensions.");
                quantized_ = true;
            }
        json result{{"asset", {{"version", "2.0"}}}};
        for (const char* key : {"accessors", "bufferViews", "buffers", "materials", "meshes", "nodes"}) {
            const auto list = source.find(key);
            if (list == source.end())
                continue;
            if (!list->is_array() || list->size() > k_max_items)
                fail(message("$.", key), "is not a list, or has more items than ", k_max_items, ": give a list.");
            for (std::size_t i = 0; i < list->size(); ++i) {
                json& each = (*list)[i];
                const std::string place = message("$.", key, "[", i, "]");
                if (!each.is_object())
                    fail(place, "is not an object: give one.");
                if (key == std::string_view("materials"))
                    each = each.contains("name") ? json{{"name", each["name"]}} : json::object();
                else if (key == std::string_view("buffers"))
                    prepare_buffer(each, place, i);
                strip(each, place);
            }
            result[key] = std::move(*list);
        }
        return result;
    }

    // Also checks what tinygltf replaces by a default where its type is wrong.
    void strip(json& value, const std::string& place) {
        if (++values_ > k_max_values)
            fail("$", "has more than ", k_max_values, " values: give fewer.");
        if (!value.is_structured())
            return;
        if (value.is_object())
            for (const char* key : {"extensions", "extras", "targets"})
                value.erase(key);
        const auto is_count = [](const json& number) { return number.is_number_unsigned() && number <= k_max_bytes; };
        for (auto& [key, each] : value.items()) {
            if (value.is_object() && std::ranges::find(k_counts, key) != k_counts.end() && !is_count(each))
                fail(place + "." + key, "is not a count: give 0 to ", k_max_bytes, ".");
            if (value.is_object() && key == "children" && !(each.is_array() && std::ranges::all_of(each, is_count)))
                fail(place + ".children", "is not a list of nodes: give their numbers.");
            for (const auto& [name, count] : k_lists)
                if (value.is_object() && key == name &&
                    !(each.is_array() && each.size() == count && std::ranges::all_of(each, &json::is_number)))
                    fail(place + "." + key, "is not ", count, " finite numbers: give those.");
            strip(each, place);
        }
    }

    // tinygltf knows few kinds of data, reads + as a blank, and wants files of exactly `byteLength`.
    void prepare_buffer(json& buffer, const std::string& place, std::size_t i) {
        if (!buffer.contains("byteLength") || !buffer["byteLength"].is_number_unsigned() || buffer["byteLength"] > k_max_bytes ||
            buffer["byteLength"] == 0u)
            fail(place + ".byteLength", "is missing or not a count: give 1 to ", k_max_bytes, ".");
        const auto length = buffer["byteLength"].get<std::size_t>();
        if (i == 0 && !binary_.empty() && !buffer.contains("uri"))
            buffer["uri"] = std::string(k_binary);
        if (!buffer.contains("uri") || !buffer["uri"].is_string())
            fail(place + ".uri", "is missing or not a string: name a file or give data.");
        auto& uri = buffer["uri"].get_ref<std::string&>();
        if (!uri.starts_with("data:")) {
            for (std::size_t at = uri.find('+'); at != std::string::npos; at = uri.find('+', at))
                uri.replace(at, 1, "%2B");
            lengths_.push_back(length);
            return;
        }
        constexpr std::string_view k_mark = ";base64,", k_known = "data:application/octet-stream;base64,";
        const std::size_t mark = uri.find(k_mark);
        if (mark == std::string::npos)
            fail(place + ".uri", "has data of another kind than base64: give base64.");
        uri.replace(0, mark + k_mark.size(), k_known);
    }

    void load(const std::string& text) {
        tinygltf::TinyGLTF reader;
        reader.SetFsCallbacks({[](const std::string&, void*) { return true; },
                               [](const std::string& name, void*) { return name; },
                               [](std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* self) {
                                   static_cast<GltfReader*>(self)->read_buffer(*bytes, name);
                                   return true;
                               },
                               nullptr, this});
        std::string fault, warning;
        const bool read =
            text.size() <= std::numeric_limits<unsigned>::max() &&
            reader.LoadASCIIFromString(&model_, &fault, &warning, text.data(), static_cast<unsigned>(text.size()), "");
        if (read && fault.empty())
            return;
        fault.resize(std::min<std::size_t>({fault.size(), fault.find('\n'), 160})); // it may quote a buffer's whole data
        fault.resize(fault.find_last_not_of('.') + 1);
        throw Fault{message(path_.string(), " is not a glTF 2.0 that tinygltf reads: ", fault, ": save it again as glTF 2.0.")};
    }

    // The next buffer that is not data in the text; tinygltf asks for them in order.
    void read_buffer(std::vector<unsigned char>& bytes, const std::string& name) {
        const std::size_t length = lengths_.at(files_++);
        const auto take = [&](std::string_view from) {
            if (from.size() < length)
                throw Fault{message(path_.string(), ": the buffer ", name == k_binary ? "of the GLB" : std::string_view(name),
                                    " has ", from.size(), " bytes, and byteLength is ", length, ": give them all.")};
            if ((bytes_ += length) > k_max_bytes)
                fail("$.buffers", "have more than ", k_max_bytes, " bytes: give fewer.");
            bytes.assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(length));
        };
        if (name == k_binary && !binary_.empty())
            return take(binary_);
        const auto file = read_beside(path_, name, budget_);
        if (!file)
            throw Fault{file.error()};
        take(*file);
    }

    template <class Item>
    const Item& item(const std::vector<Item>& list, int index, const char* name) const {
        if (index < 0 || static_cast<std::size_t>(index) >= list.size())
            fail(message("$.", name, "[", index, "]"), "is missing: add it, or name another.");
        return list[static_cast<std::size_t>(index)];
    }

    // The accessor of this type; of indices where it is a scalar.
    Entries entries(int index, const char* key, int type, const std::string& place) const {
        const tinygltf::Accessor& accessor = item(model_.accessors, index, "accessors");
        const std::string here = message("$.accessors[", index, "]");
        const bool indices = type == TINYGLTF_TYPE_SCALAR;
        const int component = accessor.componentType;
        const bool of_signs = component == TINYGLTF_COMPONENT_TYPE_BYTE || component == TINYGLTF_COMPONENT_TYPE_SHORT;
        const bool of_none =
            component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        // Without the extension, uv alone may be whole numbers.
        const bool fits = indices ? of_none || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT
                                  : component == TINYGLTF_COMPONENT_TYPE_FLOAT || (quantized_ && (of_signs || of_none)) ||
                                        (type == TINYGLTF_TYPE_VEC2 && of_none && accessor.normalized);
        if (!fits || accessor.type != type)
            fail(here, "is the ", key, " of ", place, " and not ",
                 indices                      ? "SCALAR of unsigned integers"
                 : type == TINYGLTF_TYPE_VEC3 ? "VEC3 of floats"
                                              : "VEC2 of floats",
                 !indices && quantized_ ? " or of whole numbers of 8 or 16 bits" : "", ": give those.");
        if (accessor.sparse.isSparse || accessor.bufferView == -1)
            fail(here, "is sparse or has no view: give all of its numbers.");
        if (accessor.count == 0 || accessor.count > 3 * k_max_triangles || (!indices && accessor.count > k_max_vertices))
            fail(here + ".count", "is ", accessor.count, ": give at least 1, and at most ", k_max_vertices, " vertices.");
        const tinygltf::BufferView& view = item(model_.bufferViews, accessor.bufferView, "bufferViews");
        const std::vector<unsigned char>& bytes = item(model_.buffers, view.buffer, "buffers").data;
        const std::string there = message("$.bufferViews[", accessor.bufferView, "]");
        const auto size = static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component)) *
                                                   tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type)));
        const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
        if (stride < size || (indices && stride != size))
            fail(there + ".byteStride", "is ", stride, ": give ", size, indices ? "." : " to 252.");
        if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
            fail(there, "reaches beyond its buffer: give a whole buffer.");
        if (accessor.byteOffset > view.byteLength || (accessor.count - 1) * stride + size > view.byteLength - accessor.byteOffset)
            fail(here, "reaches beyond its view: give a whole view.");
        return {
            bytes.data() + view.byteOffset + accessor.byteOffset, accessor.count, stride, size, component, accessor.normalized};
    }

    void add_node(int index, const glm::dmat4& above, int depth) {
        ++nodes_;
        const std::string place = message("$.nodes[", index, "]");
        if (depth > k_deepest_node)
            fail(place, "is deeper than ", k_deepest_node, " nodes: give a tree of fewer.");
        const tinygltf::Node& node = item(model_.nodes, index, "nodes");
        const glm::dmat4 to_scene = above * place_of(node);
        if (node.mesh != -1)
            for (const tinygltf::Primitive& primitive : item(model_.meshes, node.mesh, "meshes").primitives)
                add_primitive(primitive, message("$.meshes[", node.mesh, "].primitives"), to_scene);
        for (const int child : node.children)
            add_node(child, to_scene, depth + 1);
    }

    static glm::dmat4 place_of(const tinygltf::Node& node) {
        if (!node.matrix.empty())
            return glm::make_mat4(node.matrix.data());
        glm::dmat4 result(1.0);
        if (!node.translation.empty())
            result[3] = glm::dvec4(glm::make_vec3(node.translation.data()), 1.0);
        if (!node.rotation.empty()) // x, y, z, w
            result *= glm::mat4_cast(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
        if (!node.scale.empty())
            for (int axis = 0; axis < 3; ++axis)
                result[axis] *= node.scale[static_cast<std::size_t>(axis)];
        return result;
    }

    void add_primitive(const tinygltf::Primitive& primitive, const std::string& place, const glm::dmat4& to_scene) {
        if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) // points and lines
            return;
        if (primitive.mode != TINYGLTF_MODE_TRIANGLES)
            fail(place, "has one of mode ", primitive.mode, ": give triangles, mode 4.");
        const auto attribute = [&](const char* key, int type, std::size_t count) -> Entries {
            const auto found = primitive.attributes.find(key);
            if (found == primitive.attributes.end())
                return {};
            const Entries numbers = entries(found->second, key, type, place);
            if (count != 0 && numbers.count != count)
                fail(place, "has ", numbers.count, " entries of ", key, " and ", count, " of POSITION: give as many.");
            return numbers;
        };
        const Entries positions = attribute("POSITION", TINYGLTF_TYPE_VEC3, 0);
        if (positions.count == 0)
            fail(place, "has one without POSITION: add it.");
        const Entries normals = attribute("NORMAL", TINYGLTF_TYPE_VEC3, positions.count);
        const Entries uvs = attribute("TEXCOORD_0", TINYGLTF_TYPE_VEC2, positions.count);
        const bool indexed = primitive.indices != -1;
        const Entries indices = indexed ? entries(primitive.indices, "indices", TINYGLTF_TYPE_SCALAR, place) : Entries{};
        const std::size_t corners = indexed ? indices.count : positions.count;
        if (corners % 3 != 0)
            fail(place, "has ", corners, " corners: give three a triangle.");
        corners_ += corners;
        if (corners_ > 3 * k_max_triangles || soup_.size() == k_max_parts)
            throw Fault{message(path_.string(), " has more than ", k_max_triangles, " triangles or ", k_max_parts,
                                " parts, counting each place: give fewer.")};

        SoupPart& part = soup_.emplace_back(SoupPart{material_of(primitive), {}, uvs.count != 0});
        part.corners.reserve(corners);
        const glm::dmat3 turn(to_scene);
        // The inverse's transpose times the determinant, which turns normals of flattened meshes too.
        const glm::dmat3 for_normals(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]), glm::cross(turn[0], turn[1]));
        const double mirrors = glm::determinant(turn) < 0.0 ? -1.0 : 1.0;
        for (std::size_t i = 0; i < corners; ++i) {
            const std::size_t corner = mirrors < 0.0 ? i + 2 - 2 * (i % 3) : i; // clockwise triangles are turned over
            const std::size_t at = indexed ? indices.index(corner) : corner;
            if (at >= positions.count)
                fail(place, "has the index ", at, ": give 0 to ", positions.count - 1, ".");
            Corner& made = part.corners.emplace_back();
            made.position = glm::vec3(to_scene * glm::dvec4(positions.vector<glm::vec3>(at), 1.0));
            if (normals.count != 0) {
                const glm::dvec3 normal = mirrors * (for_normals * glm::dvec3(normals.vector<glm::vec3>(at)));
                made.normal = normal == glm::dvec3(0.0) ? glm::vec3(0.0f) : glm::vec3(glm::normalize(normal));
            }
            if (uvs.count != 0) {
                const auto uv = uvs.vector<glm::vec2>(at);
                made.uv = {uv.x, 1.0f - uv.y}; // glTF's v points down
            }
        }
    }

    std::string material_of(const tinygltf::Primitive& primitive) const {
        if (primitive.material == -1)
            return "none";
        const std::string& name = item(model_.materials, primitive.material, "materials").name;
        return name.empty() ? message("material ", primitive.material) : name.substr(0, 255);
    }

    const std::filesystem::path& path_;
    windrow::detail::InputBudget& budget_;
    std::string_view binary_;
    std::vector<std::size_t> lengths_; // of the buffers that are not data in the text
    std::size_t files_ = 0, bytes_ = 0, values_ = 0, nodes_ = 0, corners_ = 0;
    bool quantized_ = false; // KHR_mesh_quantization
    tinygltf::Model model_;
    Soup soup_;
};

} // namespace

Result<Soup> read_gltf(std::string_view bytes, const std::filesystem::path& path, windrow::detail::InputBudget& budget) {
    try {
        return GltfReader(path, budget).run(bytes);
    } catch (const Fault& fault) {
        return windrow::Error{fault.text};
    } catch (const std::exception& fault) { // of memory, mostly
        return windrow::Error{message(path.string(), " cannot be read: ", fault.what(), ": give a smaller file.")};
    }
}

} // namespace windrow::vegetation::fur
