// Small meshes as files: a cube of side 2 with its corner cut open or not, as OBJ, glTF and GLB.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::vegetation::fur::test {

inline const std::string k_cube_obj = "mtllib cube.mtl\no cube\nusemtl coat\n"
                                      "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                                      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nusemtl skin\nf 3 4 8 7\nf -8 -4 -1 -5\nf 2 3 7 6\n";
inline const std::string k_cube_mtl = "newmtl coat\nKd 1 1 1\nfur 48 0.419 2.753 11\nnewmtl skin\nKd 0 0 0\n";

template <class Number>
void put(std::string& bytes, Number value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value); // little-endian, as the machine
    bytes.append(raw, sizeof raw);
}

inline constexpr std::array<std::array<float, 3>, 8> k_corners{
    {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
inline constexpr std::array<std::array<std::uint16_t, 3>, 12> k_faces{{{3, 2, 1},
                                                                       {3, 1, 0},
                                                                       {4, 5, 6},
                                                                       {4, 6, 7},
                                                                       {0, 1, 5},
                                                                       {0, 5, 4},
                                                                       {2, 3, 7},
                                                                       {2, 7, 6},
                                                                       {0, 4, 7},
                                                                       {0, 7, 3},
                                                                       {1, 2, 6},
                                                                       {1, 6, 5}}};

/// 12 triangles on 8 vertices; 96 bytes of positions, then 72 of indices.
inline std::string cube_buffer() {
    std::string bytes;
    for (const auto& corner : k_corners)
        for (const float value : corner)
            put(bytes, value);
    for (const auto& face : k_faces)
        for (const std::uint16_t index : face)
            put(bytes, index);
    return bytes;
}

/// `buffer`: the members of the one buffer beside its length, such as `,"uri":"cube.bin"`.
inline std::string cube_gltf(const std::string& buffer) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"children":[1]},{"mesh":0,"scale":[1,2,1]}],)"
           R"("materials":[{"name":"coat"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-1,-1,-1],"max":[1,1,1]},)"
           R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],)"
           R"("buffers":[{"byteLength":168)" +
           buffer + "}]}";
}

inline std::string cube_glb() {
    std::string json = cube_gltf("");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer = cube_buffer();
    std::string bytes = "glTF";
    put(bytes, std::uint32_t{2});
    put(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
    put(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    put(bytes, static_cast<std::uint32_t>(buffer.size()));
    bytes += std::string_view("BIN\0", 4);
    return bytes + buffer;
}

} // namespace windrow::vegetation::fur::test
