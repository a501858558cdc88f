// Pictures as files: what was written is what is read, and a file that cannot be written is told.
#include "pictures/picture_files.h"
#include "tests/figure.h"

#include <OpenImageIO/imageio.h>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace windrow::pictures {
namespace {

class Picture : public testing::Test {
  protected:
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() /
                 ("windrow_picture_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::filesystem::path folder;
};

TEST_F(Picture, PngKeepsEachByte) {
    Picture8 picture(7, 5);
    for (std::size_t n = 0; n < picture.values.size(); ++n)
        picture.values[n] = static_cast<std::uint8_t>(37 * n);
    const auto file = folder / "a.png";
    const auto written = write_png(picture, file);
    ASSERT_TRUE(written) << written.error();
    const auto input = OIIO::ImageInput::open(file.string());
    ASSERT_TRUE(input);
    std::vector<std::uint8_t> read(picture.values.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, read.data()));
    EXPECT_EQ(read, picture.values);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1); // nothing is left beside it
}

TEST_F(Picture, ExrHasLightAndMotionInPixels) {
    PictureF light(4, 3, 3), motion(4, 3, 2);
    for (std::size_t n = 0; n < light.values.size(); ++n)
        light.values[n] = 0.01f + 900.0f * static_cast<float>(n);
    for (std::size_t n = 0; n < motion.values.size(); ++n)
        motion.values[n] = -0.25f + 0.125f * static_cast<float>(n);
    const auto file = folder / "a.exr";
    const auto written = write_exr(light, motion, file);
    ASSERT_TRUE(written) << written.error();
    const auto input = OIIO::ImageInput::open(file.string());
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().channelnames, (std::vector<std::string>{"R", "G", "B", "motion.x", "motion.y"}));
    std::vector<float> read(12 * 5);
    ASSERT_TRUE(input->read_image(0, 0, 0, 5, OIIO::TypeDesc::FLOAT, read.data()));
    double worst = 0.0;
    for (std::size_t pixel = 0; pixel < 12; ++pixel) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double value = static_cast<double>(light.values[3 * pixel + channel]);
            worst = std::max(worst, std::abs(static_cast<double>(read[5 * pixel + channel]) / value - 1.0));
        }
        EXPECT_EQ(read[5 * pixel + 3], 4.0f * motion.values[2 * pixel]);
        EXPECT_EQ(read[5 * pixel + 4], 3.0f * motion.values[2 * pixel + 1]);
    }
    WINDROW_EXPECT_FIGURE("render/picture/exr", worst, 1.0 / 2048.0); // half floats
    EXPECT_TRUE(write_exr(light, {}, folder / "b.exr"));
}

TEST_F(Picture, WhatCannotBeWrittenIsTold) {
    const auto lost = write_png(Picture8(2, 2), folder / "no" / "such" / "a.png");
    ASSERT_FALSE(lost);
    EXPECT_NE(lost.error().find("a.png"), std::string::npos);
    EXPECT_FALSE(write_png(Picture8(), folder / "a.png"));
    Picture8 short_of(3, 3);
    short_of.values.pop_back();
    EXPECT_FALSE(write_png(short_of, folder / "a.png"));
    EXPECT_FALSE(write_exr(PictureF(2, 2, 3), PictureF(3, 2, 2), folder / "a.exr"));
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

} // namespace
} // namespace windrow::pictures
