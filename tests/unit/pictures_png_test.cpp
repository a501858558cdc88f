// PNG files of the portable command, read by OpenImageIO.
#include "cli/device_report/png.h"
#include "pictures/picture_files.h"
#include "scene/scene_reader.h"
#include "tests/unit/command_outcome.h"

#include <OpenImageIO/imageio.h>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <vector>

namespace windrow::cli {
namespace {

using Paint = std::function<unsigned(int x, int y, int channel)>;

void expect_same(int width, int height, const Paint& paint) {
    std::vector<std::byte> pixels(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::size_t at = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 4; ++channel)
                pixels[at++] = static_cast<std::byte>(paint(x, y, channel));
    const test::OwnFolder folder;
    std::ofstream(folder / "own.png", std::ios::binary) << png_of(width, height, pixels);
    const auto read = pictures::read_png(folder / "own.png");
    ASSERT_TRUE(read) << read.error();
    int differ = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel)
                differ += read->at(x, y)[static_cast<std::size_t>(channel)] != (paint(x, y, channel) & 255u);
    EXPECT_EQ(differ, 0) << width << " x " << height;
}

TEST(PortablePng, ReadsAsItWasWritten) {
    std::mt19937 random(3);
    expect_same(1, 1, [](int, int, int channel) { return 10u * static_cast<unsigned>(channel); });
    expect_same(7, 3, [](int, int, int) { return 255u; });
    expect_same(640, 360, [](int x, int y, int channel) { return static_cast<unsigned>((x * (channel + 1) + 2 * y) / 5); });
    const auto noise = [](int x, int y, int channel) {
        const auto place = static_cast<unsigned>((y * 301 + x) * 4 + channel);
        return (place * 2654435761u ^ (place * 40503u << 9)) >> 24;
    };
    expect_same(301, 203, noise);
    // Matches of each length and of far distances: tiles that repeat in a row and 40 rows below.
    std::vector<unsigned> tile(3 * 97 * 40);
    for (unsigned& value : tile)
        value = static_cast<unsigned>(random() & 255u);
    expect_same(400, 130, [&](int x, int y, int channel) {
        return tile[static_cast<std::size_t>(((y % 40) * 97 + (x * x / 50) % 97) * 3 + channel % 3)];
    });
}

// What is even is packed.
TEST(PortablePng, IsSmallWhereThePictureIsEven) {
    const std::vector<std::byte> even(4 * 1920 * 1080, std::byte{90});
    EXPECT_LT(png_of(1920, 1080, even).size(), 100'000u);
}

} // namespace
/// A picture of `values`, 3 x 2, in the format of its name's end; of two channels the second is alpha.
template <class Number>
void write_heights(const std::filesystem::path& file, OIIO::TypeDesc type, const std::vector<Number>& values, int channels = 1) {
    const auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output) << OIIO::geterror();
    OIIO::ImageSpec spec(3, 2, channels, type);
    if (channels == 2) {
        spec.channelnames = {"Y", "A"};
        spec.alpha_channel = 1;
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    ASSERT_TRUE(output->open(file.string(), spec) && output->write_image(type, values.data()) && output->close())
        << output->geterror();
}

/// A TIFF of floats, 3 x 2, with GDAL's tags for places without data and the size of a pixel.
void write_gdal_tiff(const std::filesystem::path& file, const std::vector<float>& values, const std::string& nodata,
                     double pixel) {
    std::string bytes = "II*\0";
    bytes.resize(4);
    const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
    constexpr std::uint32_t k_pixels = 8, k_scale = k_pixels + 24, k_directory = k_scale + 24;
    put(k_directory);
    for (const float value : values)
        put(value);
    for (const double size : {pixel, pixel, 0.0})
        put(size);
    struct Entry {
        std::uint16_t tag, kind;
        std::uint32_t count, value;
    };
    std::uint32_t text = 0;
    std::memcpy(&text, nodata.c_str(), std::min<std::size_t>(nodata.size() + 1, 4));
    const Entry entries[] = {
        {256, 3, 1, 3}, {257, 3, 1, 2},          {258, 3, 1, 32},
        {259, 3, 1, 1}, {262, 3, 1, 1},          {273, 4, 1, k_pixels},
        {277, 3, 1, 1}, {278, 3, 1, 2},          {279, 4, 1, 24},
        {339, 3, 1, 3}, {33550, 12, 3, k_scale}, {42113, 2, static_cast<std::uint32_t>(nodata.size() + 1), text}};
    put(static_cast<std::uint16_t>(std::size(entries)));
    for (const Entry& entry : entries) {
        put(entry.tag);
        put(entry.kind);
        put(entry.count);
        put(entry.value);
    }
    put(std::uint32_t{0});
    std::ofstream(file, std::ios::binary) << bytes;
}

// The heights of a ground in a scene, as PNG, as a TIFF of floats and as one of whole metres with a sign.
TEST(HeightPictures, AreReadInFourKindsOfNumbers) {
    const test::OwnFolder folder;
    write_heights<std::uint16_t>(folder / "a.png", OIIO::TypeDesc::UINT16, {0, 65535, 6553, 13107, 32768, 1});
    write_heights<float>(folder / "b.tif", OIIO::TypeDesc::FLOAT, {0.0f, 812.25f, -3.5f, 1e-3f, 40.0f, 7.0f});
    write_heights<std::int16_t>(folder / "c.tif", OIIO::TypeDesc::INT16, {0, 812, -3, 32767, 40, 7});
    std::ofstream(folder / "d.png") << "no picture";
    const auto heights = [&](const char* name) {
        return scene::read_scene_text(std::string(R"({"obstacles": [{"shape": {"ground": {"file": ")") + name + "\"}}}]}",
                                      folder / "scene.json");
    };
    const auto read = [&](const char* name) -> Result<std::vector<float>> {
        std::ofstream(folder / "scene.json") << R"({"obstacles": [{"shape": {"ground": {"file": ")" << name << "\"}}}]}";
        const auto found = scene::read_scene(folder / "scene.json", {.heights = pictures::read_heights});
        if (!found)
            return Error{found.error()};
        return std::get<Ground>(found->obstacles[0].obstacle.shape).heights->data().heights;
    };
    const std::vector<float> shares{0.0f, 1.0f, 6553.0f / 65535.0f, 0.2f, 32768.0f / 65535.0f, 1.0f / 65535.0f};
    const auto png = read("a.png");
    ASSERT_TRUE(png) << png.error();
    for (std::size_t n = 0; n < shares.size(); ++n)
        EXPECT_NEAR((*png)[n], shares[n], 1e-6f);
    const auto floats = read("b.tif");
    ASSERT_TRUE(floats) << floats.error();
    EXPECT_EQ(*floats, (std::vector<float>{0.0f, 812.25f, -3.5f, 1e-3f, 40.0f, 7.0f}));
    const auto metres = read("c.tif");
    ASSERT_TRUE(metres) << metres.error();
    EXPECT_EQ(*metres, (std::vector<float>{0.0f, 812.0f, -3.0f, 32767.0f, 40.0f, 7.0f}));
    EXPECT_NE(read("d.png").error().find("give a PGM, PNG or TIFF."), std::string::npos) << read("d.png").error();
    write_heights<std::uint16_t>(folder / "alpha.png", OIIO::TypeDesc::UINT16,
                                 {0, 9, 65535, 0, 6553, 65535, 13107, 32768, 32768, 1, 1, 0}, 2);
    const auto masked = read("alpha.png");
    ASSERT_TRUE(masked) << masked.error();
    for (std::size_t n = 0; n < shares.size(); ++n)
        EXPECT_NEAR((*masked)[n], shares[n], 1e-6f) << "a transparent height is a height";
    // Coded in colours, as web maps are; the same grey in three channels is none.
    write_heights<std::uint8_t>(folder / "coded.png", OIIO::TypeDesc::UINT8,
                                {1, 1, 1, 5, 5, 5, 7, 7, 7, 9, 9, 9, 1, 134, 160, 2, 2, 2}, 3);
    EXPECT_NE(read("coded.png").error().find("is a picture of colours, first at row 2, column 2: give heights in one channel"),
              std::string::npos)
        << read("coded.png").error();
    write_heights<std::uint8_t>(folder / "grey.png", OIIO::TypeDesc::UINT8,
                                {1, 1, 1, 5, 5, 5, 7, 7, 7, 9, 9, 9, 3, 3, 3, 255, 255, 255}, 3);
    const auto grey = read("grey.png");
    ASSERT_TRUE(grey) << grey.error();
    EXPECT_EQ((*grey)[5], 1.0f);
    // By its header, before memory is taken; colours take twice as much.
    const auto in_room = [&](const char* name, std::size_t pixels) {
        std::ifstream file(folder / name, std::ios::binary);
        return pictures::read_heights(std::string(std::istreambuf_iterator<char>(file), {}), (folder / name).string(), pixels);
    };
    const auto fault = [&](const char* name, std::size_t pixels) {
        const auto read = in_room(name, pixels);
        return read ? std::string() : read.error().substr((folder / name).string().size());
    };
    EXPECT_TRUE(in_room("a.png", 6) && in_room("grey.png", 12));
    EXPECT_EQ(fault("a.png", 5), " is 3 x 2 px: the scene has room for 5 in all; give a smaller picture.");
    EXPECT_EQ(fault("grey.png", 11), " is 3 x 2 px: the scene has room for 5 in all; give a smaller picture.");
    // A void of a survey, and what GDAL says beside the pixels of a TIFF: no data, and pixels of 30 m.
    write_heights<std::int16_t>(folder / "void.tif", OIIO::TypeDesc::INT16, {40, 40, 40, 40, -32768, 40});
    EXPECT_EQ(*read("void.tif"), std::vector<float>(6, 40.0f));
    write_gdal_tiff(folder / "gdal.tif", {9.0f, 9.0f, -77.0f, 9.0f, 9.0f, 9.0f}, "-77", 30.0);
    EXPECT_EQ(*read("gdal.tif"), std::vector<float>(6, 9.0f));
    const auto reported = scene::read_scene(folder / "scene.json", {.heights = pictures::read_heights});
    ASSERT_EQ(reported->warnings.size(), 2u);
    EXPECT_NE(reported->warnings[0].find("has 1 of 6 heights without data, the first at row 1, column 3: they are filled"),
              std::string::npos)
        << reported->warnings[0];
    EXPECT_NE(reported->warnings[1].find("says that its pixels are 30 x 30"), std::string::npos) << reported->warnings[1];
    std::ofstream(folder / "e.raw", std::ios::binary) << std::string("\0\0\xff\xff\x99\x19\1\0", 8);
    const auto raw = read("e.raw");
    ASSERT_TRUE(raw) << raw.error();
    EXPECT_EQ(*raw, (std::vector<float>{0.0f, 1.0f, 6553.0f / 65535.0f, 1.0f / 65535.0f}));
    std::ofstream(folder / "f.r16", std::ios::binary) << "123456";
    EXPECT_NE(read("f.r16").error().find("has 6 bytes, which is no square"), std::string::npos) << read("f.r16").error();
    (void)read("a.png");
    const std::string scene = (folder / "scene.json").string(), out = (folder / "out").string();
    const CommandOutcome ran = run_windrow({"run", scene.c_str(), "--frames", "1", "--out", out.c_str(), "--csv"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_FALSE(heights("a.png")) << "without a library a scene has PGM alone";
}

} // namespace windrow::cli
