// Small scenes with large costs: each is rejected in a sentence, within seconds and 1 GiB.
#include "scene/motion_path.h"
#include "scene/scene_reader.h"
#include "tests/cost.h"
#include "tests/own_folder.h"

#include <sys/stat.h>

namespace windrow::scene {
namespace {

namespace fs = std::filesystem;

class SceneCost : public test::FolderTest {
  protected:
    [[nodiscard]] std::string fault(const std::string& text) const {
        return test::sentence_of_cheap([&] {
            const auto scene = read_scene_text(text, folder / "a.json");
            return scene ? "read" : scene.error();
        });
    }
    void expect_fault(const std::string& text, const std::string& sentence) const {
        const std::string found = fault(text);
        EXPECT_NE(found.find(sentence), std::string::npos) << found;
    }
};

std::string repeated(const std::string& item, int count) {
    std::string list = item;
    for (int i = 1; i < count; ++i)
        list += "," + item;
    return list;
}

TEST_F(SceneCost, OneTableNamed4096Times) {
    std::ofstream table(folder / "table.csv");
    for (int i = 0; i < 50'000; ++i)
        table << i << ",0,0,0\n";
    table.close();
    std::string paths;
    for (int i = 0; i < 4096; ++i)
        paths += (i == 0 ? "\"p" : ",\"p") + std::to_string(i) + R"(":{"file":"table.csv"})";
    expect_fault(R"({"paths":{)" + paths + "}}", "a scene takes at most 8000000 points in tables: give fewer or smaller files.");
}

TEST_F(SceneCost, ALineOfCommas) {
    const std::string sentence = test::sentence_of_cheap([] {
        const auto path = parse_path_csv(std::string(std::size_t{64} << 20, ','), "p.csv");
        return path ? "read" : path.error();
    });
    EXPECT_EQ(sentence, "p.csv:1: has 67108865 fields: give four, t,x,y,z, with commas between them.");
}

TEST_F(SceneCost, UnknownKeys) {
    std::string text = "{";
    for (int i = 0; i < 1'500'000; ++i)
        text += (i == 0 ? "\"unknown" : ",\"unknown") + std::to_string(i) + "\":0";
    expect_fault(text + "}", "$.unknown0 is not a known key");
}

TEST_F(SceneCost, ManyNamesThatNameNothing) {
    std::string paths, motors;
    for (int i = 0; i < 4096; ++i) {
        const std::string name = std::to_string(i) + std::string(50, 'n');
        paths += (i == 0 ? "\"p" : ",\"p") + name + R"(":{"points":[[0,0,0,0]]})";
        motors += (i == 0 ? R"({"kind":"wake","path":"m)" : R"(,{"kind":"wake","path":"m)") + name + "\"}";
    }
    expect_fault(R"({"paths":{)" + paths + R"(},"motors":[)" + motors + "]}", "which is not in $.paths");
    // One name of megabytes.
    expect_fault(R"({"paths":{")" + std::string(15'000'000, 'n') + R"(":{"points":[[0,0,0,0]]}},"floor":"x"})",
                 "which is not in $.paths");
}

TEST_F(SceneCost, TextThatIsManyValues) {
    for (const char* item : {"0", "[0]"})
        expect_fault(R"({"motors":[)" + repeated(item, 8'000'000 / static_cast<int>(1 + std::string(item).size())) + "]}",
                     "$.motors");
    expect_fault(R"({"motors":[)" + repeated("0", 6'000'000) + "]}",
                 "has more than 6000000 values: give fewer, or put paths in tables.");
}

TEST_F(SceneCost, FilesThatAreNone) {
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("/etc/passwd", folder / "link.csv");
    EXPECT_EQ(test::sentence_of_cheap([&] {
                  const auto scene = read_scene(folder / "pipe");
                  return scene ? "read" : scene.error();
              }),
              (folder / "pipe").string() + ": is a pipe or a device: name a regular file.");
    expect_fault(R"({"paths":{"p":{"file":"pipe"}}})", "pipe: is a pipe or a device: name a regular file.");
    expect_fault(R"({"paths":{"p":{"file":"link.csv"}}})", "link.csv: is a link out of its folder: put the file itself there.");
}

} // namespace
} // namespace windrow::scene
