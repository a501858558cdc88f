// Small pictures with large costs, and pictures that are no files: masks, heights and the maps of coats.
#include "tests/cost.h"
#include "vegetation/files/coat_picture_files.h"
#include "vegetation/program/picture_reader.h"

#include <OpenImageIO/imageio.h>
#include <fstream>
#include <sys/stat.h>

namespace windrow::vegetation::program {
namespace {

namespace fs = std::filesystem;

class PictureCost : public testing::Test {
  protected:
    PictureCost() {
        fs::create_directories(folder);
        fs::create_symlink("/dev/zero", folder / "zero");
        ::mkfifo((folder / "pipe").c_str(), 0600);
    }
    ~PictureCost() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }

    /// What reading a map says: its size, or the sentence.
    [[nodiscard]] std::string map(const std::string& name) const {
        return windrow::test::sentence_of_cheap([&]() -> std::string {
            windrow::detail::InputBudget budget;
            const auto pictures = fur::read_pictures({.length = name}, folder, budget);
            return pictures ? std::to_string(pictures->length.texels.size()) + " texels" : pictures.error();
        });
    }
    void expect_fault(const std::string& picture, const std::string& why) const {
        const std::string sentence = windrow::test::sentence_of_cheap([&] {
            const auto scene = read_picture_scene_text(R"({"picture": )" + picture + "}", folder / "a.json");
            return scene ? "read" : scene.error();
        });
        EXPECT_NE(sentence.find(why), std::string::npos) << sentence;
    }
    void expect_faults(const std::string& name, const std::string& why) const {
        expect_fault(R"({"ground": {"high": 2, "heights": ")" + name + "\"}}", why);
        expect_fault(R"({"grass": [{"mask": {"file": ")" + name + "\"}}]}", why);
    }

    fs::path folder = fs::path(testing::TempDir()) / ("windrow_picture_cost_" + std::to_string(::getpid()));
};

TEST_F(PictureCost, ASparseImage) {
    std::ofstream(folder / "sparse.pgm") << "P5\n2 2\n255\n";
    fs::resize_file(folder / "sparse.pgm", std::uintmax_t{44} * 100'000'000);
    expect_faults("sparse.pgm", "sparse.pgm: is larger than 512 MiB");
}

// Half a megabyte that holds 16 channels of 4096 x 4096: three of them are read.
TEST_F(PictureCost, AnImageOfManyChannels) {
    // In a process of its own: a fork has none of the threads that OpenEXR begins.
    const std::string written = windrow::test::sentence_of_cheap([&] {
        OIIO::ImageSpec spec(4096, 4096, 16, OIIO::TypeDesc::HALF);
        spec.channelnames.clear();
        for (int i = 0; i < 16; ++i)
            spec.channelnames.push_back("c" + std::to_string(10 + i));
        spec.attribute("compression", "rle");
        const auto output = OIIO::ImageOutput::create("openexr");
        bool good = output && output->open((folder / "many.exr").string(), spec);
        const std::vector<std::uint16_t> row(4096 * 16, 0x3800); // 0.5
        for (int y = 0; good && y < spec.height; ++y)
            good = output->write_scanline(y, 0, OIIO::TypeDesc::HALF, row.data());
        return good && output->close() ? "written" : "not written";
    });
    ASSERT_EQ(written, "written");
    EXPECT_EQ(map("many.exr"), "16777216 texels");
}

TEST_F(PictureCost, ManyMapsTogether) {
    windrow::detail::InputBudget budget;
    ASSERT_TRUE(budget.take_memory("masks", windrow::detail::InputBudget::k_max_memory - 100));
    std::ofstream(folder / "map.pgm") << "P5\n4 4\n255\n0123456789abcdef";
    const auto pictures = fur::read_pictures({.length = "map.pgm"}, folder, budget);
    ASSERT_FALSE(pictures);
    EXPECT_NE(pictures.error().find("map.pgm: a scene takes at most 768 MiB of masks, heights, meshes and maps"),
              std::string::npos)
        << pictures.error();
}

TEST_F(PictureCost, FilesThatAreNone) {
    expect_faults("zero", "zero: is a link out of its folder: put the file itself there.");
    expect_faults("pipe", "pipe: is a pipe or a device: name a regular file.");
    EXPECT_NE(map("zero").find("is a link out of its folder"), std::string::npos);
    EXPECT_NE(map("pipe").find("is a pipe or a device"), std::string::npos);
}

} // namespace
} // namespace windrow::vegetation::program
