// PNG files of the portable command, read by OpenImageIO.
#include "cli/device_report/png.h"
#include "pictures/picture_files.h"
#include "tests/own_folder.h"

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
} // namespace windrow::cli
