// Small meshes with large costs, and meshes that are no files: each is rejected in a sentence, within seconds and 1 GiB.
#include "tests/cost.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/tests/fur/fixtures.h"
#include "vegetation/tests/fur/folder.h"

#include <cmath>
#include <numbers>
#include <sys/stat.h>

namespace windrow::vegetation::fur {
namespace {

using test::Folder;

void expect_cheap(const std::filesystem::path& path, const std::string& why, const MeshLoad& load = {}) {
    const std::string sentence = windrow::test::sentence_of_cheap([&] {
        windrow::detail::InputBudget budget;
        const auto mesh = read_mesh(path, load, path.parent_path(), budget);
        return mesh ? "read" : mesh.error();
    });
    EXPECT_NE(sentence.find(why), std::string::npos) << sentence;
}

// Two points with 20,000 triangles each: a collapse beside them would look at all of these.
TEST(MeshCost, FansAreNotSimplifiedForMinutes) {
    constexpr int k_rim = 20'000;
    const Folder folder;
    std::string text = "v 0 1 0\nv 0 -1 0\n";
    for (int i = 0; i < k_rim; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / k_rim;
        text += "v " + std::to_string(std::cos(angle)) + " 0 " + std::to_string(std::sin(angle)) + "\n";
    }
    for (int i = 0; i < k_rim; ++i) {
        const std::string one = std::to_string(3 + i) + " ", next = std::to_string(3 + (i + 1) % k_rim) + " ";
        text += "f 1 " + next + one + "\nf 2 " + one + next + "\n";
    }
    expect_cheap(folder.write("fan.obj", text), "cannot be simplified below", {.max_triangles = 100});
}

TEST(MeshCost, PrimitivesThatShareAnAccessorCountEachUse) {
    constexpr std::size_t k_vertices = 19'998;
    const Folder folder;
    std::string bytes;
    for (std::size_t i = 0; i < k_vertices; ++i)
        for (const double value : {std::cos(i), 1e-4 * static_cast<double>(i), std::sin(i)}) {
            const auto number = static_cast<float>(value);
            bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
        }
    folder.write("many.bin", bytes);
    const std::string length = std::to_string(bytes.size());
    std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"uri":"many.bin","byteLength":)" + length +
                       R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + length +
                       R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
                       std::to_string(k_vertices) + R"(}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)";
    for (int i = 0; i < 4096; ++i)
        text += i == 0 ? R"({"attributes":{"POSITION":0}})" : R"(,{"attributes":{"POSITION":0}})";
    expect_cheap(folder.write("many.gltf", text + "]}]}"), "counting each place");
}

TEST(MeshCost, FilesThatAreNone) {
    const Folder folder;
    ASSERT_EQ(::mkfifo(folder.at("pipe.obj").c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", folder.at("zero.obj"));
    folder.write("../outside.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::filesystem::create_symlink("../outside.obj", folder.at("link.obj"));
    expect_cheap(folder.at("pipe.obj"), "is a pipe or a device");
    expect_cheap(folder.at("zero.obj"), "is a link out of its folder");
    expect_cheap(folder.at("link.obj"), "is a link out of its folder");
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    expect_cheap(folder.write("mesh.obj", "mtllib pipe.obj\n" + triangle), "pipe.obj: is a pipe or a device");
}

} // namespace
} // namespace windrow::vegetation::fur
