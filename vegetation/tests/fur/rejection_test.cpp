// Meshes that a host may be handed: wrong, absurd, hostile. Each is rejected by a sentence with the file's name, or read whole.
#include "tests/figure.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/tests/fur/fixtures.h"
#include "vegetation/tests/fur/folder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace windrow::vegetation::fur {
namespace {

using test::Folder;

void expect_rejected(const std::filesystem::path& path, const std::string& why, const MeshLoad& load = {}) {
    const auto mesh = read_mesh(path, load);
    ASSERT_FALSE(mesh) << why;
    EXPECT_NE(mesh.error().find(path.string()), std::string::npos) << mesh.error();
    EXPECT_NE(mesh.error().find(why), std::string::npos) << mesh.error();
    EXPECT_EQ(mesh.error().find('\n'), std::string::npos) << mesh.error();
}

TEST(MeshRejections, WhatIsNoMesh) {
    const Folder folder;
    expect_rejected(folder.at("none.obj"), "no such file");
    expect_rejected(folder.at(""), "give a mesh as .obj");
    std::filesystem::create_directory(folder.at("folder.obj"));
    expect_rejected(folder.at("folder.obj"), "is a folder");
    expect_rejected(folder.write("mesh.stl", "solid"), "give a mesh as .obj");
    expect_rejected(folder.write("empty.obj", ""), "has no faces");
    expect_rejected(folder.write("words.obj", "this is\nno mesh\n"), "has no faces");
    expect_rejected(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "has no faces");
    expect_rejected(folder.write("mesh.3ds", "MM"), "give a mesh as .obj");
    expect_rejected(folder.write("empty.gltf", ""), "empty.gltf");
    expect_rejected(folder.write("list.gltf", "[]"), "is not an object");
    expect_rejected(folder.write("empty.glb", "glTF"), "complete GLB");
    std::string glb = test::cube_glb(); // its binary chunk 4 bytes longer than the file
    glb[glb.find(std::string_view("BIN\0", 4)) - 4] += 4;
    expect_rejected(folder.write("short.glb", glb), "longer than the file");
    expect_rejected(folder.write("bare.gltf", R"({"asset":{"version":"2.0"}})"), "has no triangles");
    // A long file is rejected by its length; a sparse one takes no disk.
    std::filesystem::resize_file(folder.write("long.obj", ""), k_max_bytes + 1);
    expect_rejected(folder.at("long.obj"), "is larger than 512 MiB");
}

TEST(MeshRejections, OfObj) {
    const Folder folder;
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::pair<std::string, const char*> wrong[] = {
        {triangle + "f 1 2 4\n", ":4: the face's index '4'"},
        {triangle + "f 1 2 0\n", "index '0'"},
        {triangle + "f 1 2 -4\n", "index '-4'"},
        {triangle + "f 1 2 99999999999999999999\n", "index '9999"},
        {triangle + "f 1/1 2/1 3/1\n", "means no vt"},
        {triangle + "f 1//1 2//1 3//1\n", "means no vn"},
        {triangle + "vt 0 0\nf 1/1 2 3\n", "different kinds"},
        {triangle + "f 1/1/1/1 2 3\n", "different kinds"},
        {triangle + "f 1 2\n", "2 corners"},
        {triangle + "f" + std::string(200, ' ') + "1 2 x\n", "index 'x'"},
        {"v 0 0 nan\n", "'nan'"},
        {"v 0 0 1e39\n", "'1e39'"},
        {"v 0 inf 0\n", "'inf'"},
        {"v 0 0\n", "finite numbers"},
        {"v 0 0 0x10\n", "'0x10'"},
        {triangle + "f 1 2 \\\n3\n", "backslash"},
        {triangle + std::string("f 1 2 3\0\n", 9), "zero byte"},
        {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no triangle with an area"},
        {"v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", "no triangle with an area"},
        {triangle + "vn 0 0 0\nvn 0 0 1\nf 1//1 2//2 3//2\n", "normal of length 0"},
        {triangle + "usemtl " + std::string(300, 'x') + "\nf 1 2 3\n", "300 bytes"}};
    for (const auto& [text, why] : wrong)
        expect_rejected(folder.write("wrong.obj", text), why);
    std::string polygon = triangle + "f";
    for (int i = 0; i < 65; ++i)
        polygon += " 1";
    expect_rejected(folder.write("polygon.obj", polygon), "65 corners");
}

TEST(MeshRejections, FilesOutsideOfTheFolder) {
    const Folder folder;
    folder.write("../outside.mtl", "newmtl coat\n");
    folder.write("../outside.bin", test::cube_buffer());
    std::filesystem::create_symlink(folder.at("../outside.mtl"), folder.at("link.mtl"));
    std::filesystem::create_directory_symlink(folder.at(".."), folder.at("up"));
    const std::string outside = std::filesystem::absolute(folder.at("../outside.mtl")).lexically_normal().string();
    const auto obj = [&](const std::string& library) {
        return folder.write("mesh.obj", "mtllib " + library + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    };
    for (const std::string& name : {outside, std::string("../outside.mtl"), std::string("inner/../../outside.mtl"),
                                    std::string("..\\outside.mtl"), std::string("C:outside.mtl"), std::string(".")})
        expect_rejected(obj(name), "in its own folder");
    expect_rejected(obj("missing.mtl"), "no such file");
    for (const std::string& name : {std::string("link.mtl"), std::string("up/outside.mtl")})
        expect_rejected(obj(name), "a link out of its folder");
    folder.write("coat.mtl", "newmtl coat\nfur 1 2 3 4\n");
    const auto bad_coat = read_mesh(obj("coat.mtl"));
    ASSERT_FALSE(bad_coat);
    EXPECT_NE(bad_coat.error().find("coat.mtl:2: fur.shells is 1"), std::string::npos) << bad_coat.error();
    for (const char* uri : {"../outside.bin", "%2e%2e/outside.bin", "%2E%2E%2Foutside.bin", "/etc/passwd", "file:///etc/passwd",
                            "http://example.org/cube.bin"})
        expect_rejected(folder.write("mesh.gltf", test::cube_gltf(std::string(R"(,"uri":")") + uri + "\"")), "in its own folder");
    expect_rejected(folder.write("mesh.gltf", test::cube_gltf(R"(,"uri":"missing.bin")")), "no such file");
    expect_rejected(folder.write("mesh.gltf", test::cube_gltf(R"(,"uri":"data:application/octet-stream;base64,!!!!")")),
                    "Failed to decode 'uri'");
    expect_rejected(folder.write("mesh.gltf", test::cube_gltf(R"(,"uri":"data:text/plain,cube")")), "base64");
}

// The cube's glTF with one text in it replaced.
TEST(MeshRejections, OfGltf) {
    const Folder folder;
    folder.write("cube.bin", test::cube_buffer());
    struct Change {
        const char *from, *to, *why;
    };
    const Change changes[] = {
        {R"("count":36)", R"("count":37)", "reaches beyond its view"},
        {R"("count":36)", R"("count":35)", "three a triangle"},
        {R"("count":36)", R"("count":4294967296)", ".count is not a count"},
        {R"("count":36)", R"("count":-3)", ".count is not a count"},
        {R"("count":36)", R"("count":400000000)", ".count is"},
        {R"("count":8)", R"("count":7)", "has the index 7"},
        {R"("count":8)", R"("count":0)", ".count is 0"},
        {R"("byteLength":168)", R"("byteLength":169)", "has 168 bytes, and byteLength is 169"},
        {R"("byteLength":168)", R"("byteLength":4000000000)", "byteLength"},
        {R"("byteLength":72)", R"("byteLength":73)", "reaches beyond its buffer"},
        {R"("byteOffset":96)", R"("byteOffset":400000000)", "reaches beyond its buffer"},
        {R"("byteLength":96)", R"("byteLength":96,"byteStride":8)", "byteStride is 8"},
        {R"("type":"VEC3")", R"("type":"VEC2")", "VEC3 of floats"},
        {R"("componentType":5123)", R"("componentType":5126)", "SCALAR of unsigned"},
        {R"("componentType":5126)", R"("componentType":5123)", "VEC3 of floats"},
        {R"("bufferView":0)", R"("bufferView":9)", "$.bufferViews[9] is missing"},
        {R"("buffer":0)", R"("buffer":1)", "$.buffers[1] is missing"},
        {R"("indices":1)", R"("indices":2)", "indices accessor out of bounds"},
        {R"("material":0)", R"("material":1)", "$.materials[1] is missing"},
        {R"("material":0)", R"("material":0,"mode":5)", "mode 5"},
        {R"("mesh":0)", R"("mesh":1)", "$.meshes[1] is missing"},
        {R"("children":[1])", R"("children":[2])", "$.nodes[2] is missing"},
        {R"("children":[1])", R"("children":[1,1])", "has a parent"},
        {R"("children":[1])", R"("children":[0])", "in a cycle"},
        {R"("scale":[1,2,1])", R"("scale":[1,2])", "finite numbers"},
        {R"("scale":[1,2,1])", R"("scale":null)", "finite numbers"},
        {R"("children":[1])", R"("children":["1"])", "not a list of nodes"},
        {R"("byteOffset":96)", R"("byteOffset":-4)", "not a count"},
        {R"("scale":[1,2,1])", R"("scale":[0,0,0])", "no triangle with an area"},
        {R"("attributes":{"POSITION":0})", R"("attributes":{})", "without POSITION"},
        {R"("scene":0)", R"("extensionsRequired":["KHR_draco_mesh_compression"],"scene":0)", "without compression"}};
    const std::string whole = test::cube_gltf(R"(,"uri":"cube.bin")");
    ASSERT_TRUE(read_mesh(folder.write("whole.gltf", whole)));
    for (const Change& change : changes) {
        std::string text = whole;
        const std::size_t at = text.find(change.from);
        ASSERT_NE(at, std::string::npos) << change.from;
        text.replace(at, std::string_view(change.from).size(), change.to);
        expect_rejected(folder.write("wrong.gltf", text), change.why);
    }
    std::string buffer = test::cube_buffer();
    const float nan = std::nanf("");
    std::memcpy(buffer.data() + 4, &nan, 4);
    folder.write("cube.bin", buffer);
    expect_rejected(folder.write("whole.gltf", whole), "give finite ones");
}

TEST(MeshRejections, OfLoads) {
    const Folder folder;
    const auto cube = folder.write("cube.glb", test::cube_glb());
    const auto rejected = [&](const MeshLoad& load, const char* field) {
        const auto mesh = read_mesh(cube, load);
        ASSERT_FALSE(mesh) << field;
        EXPECT_NE(mesh.error().find(field), std::string::npos) << mesh.error();
    };
    rejected({.up = static_cast<UpAxis>(3)}, "load.up");
    rejected({.size = 0.0f}, "load.size");
    rejected({.size = std::nanf("")}, "load.size");
    rejected({.size_of = static_cast<SizeOf>(2)}, "load.size_of");
    rejected({.yaw_deg = 361.0f}, "load.yaw_deg");
    rejected({.max_triangles = 3}, "load.max_triangles");
    expect_rejected(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n"), "is flat", {.size_of = SizeOf::height});
    expect_rejected(folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0 0 2\nv 1 0 2\nv 2 0 2\n"
                                             "f 1 3 2\nf 2 3 4\nf 3 5 4\nf 4 5 6\nf 4 6 7\n"),
                    "cannot be simplified", {.max_triangles = 4});
}

// Truncations and flipped bytes of each kind of file: rejected with a sentence, or read to a mesh that holds; never a fault of
// memory, which a build with sanitizers would tell.
TEST(MeshRejections, BrokenFilesAreRejectedOrSound) {
    const Folder folder;
    folder.write("cube.mtl", test::k_cube_mtl);
    folder.write("cube.bin", test::cube_buffer());
    const std::pair<const char*, std::string> files[] = {{"broken.obj", test::k_cube_obj},
                                                         {"broken.gltf", test::cube_gltf(R"(,"uri":"cube.bin")")},
                                                         {"broken.glb", test::cube_glb()}};
    std::mt19937 chance(9); // the same on every machine
    int read = 0, rejected = 0;
    const auto attempt = [&](const char* name, const std::string& bytes) {
        const auto mesh = read_mesh(folder.write(name, bytes));
        if (mesh) {
            const auto valid = validate(*mesh);
            EXPECT_TRUE(valid) << name << ": " << valid.error();
        } else {
            EXPECT_NE(mesh.error().find("inner"), std::string::npos) << mesh.error(); // the file's folder
        }
        ++(mesh ? read : rejected);
    };
    for (const auto& [name, whole] : files) {
        for (int i = 0; i < 100; ++i)
            attempt(name, whole.substr(0, chance() % whole.size()));
        for (int i = 0; i < 200; ++i) {
            std::string bytes = whole;
            for (auto flips = 1 + chance() % 3; flips > 0; --flips)
                bytes[chance() % bytes.size()] = static_cast<char>(chance());
            attempt(name, bytes);
        }
    }
    windrow::test::figure("shells/broken_files/rejected", rejected);
    windrow::test::figure("shells/broken_files/read", read);
    EXPECT_EQ(read + rejected, 900);
    EXPECT_GT(read, 0);
    EXPECT_GT(rejected, 0);
}

} // namespace
} // namespace windrow::vegetation::fur
