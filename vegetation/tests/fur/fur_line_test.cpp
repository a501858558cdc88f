// The fur line of an mtl file: its values are read, and a malformed line is an error with its number.
#include "vegetation/fur/fur_line.h"

#include <gtest/gtest.h>

namespace windrow::vegetation::fur {
namespace {

TEST(FurLines, CuroesPolarBearIsRead) {
    const auto coats =
        read_fur_lines("# bear\r\nnewmtl coat\r\nKd 1 1 1\r\nfur 48 0.419 2.753 11\r\n\r\nnewmtl nose\nKd 0 0 0\n", "bear.mtl");
    ASSERT_TRUE(coats) << coats.error();
    ASSERT_EQ(coats->size(), 1u);
    EXPECT_EQ(coats->at("coat"), (FurLine{48, 0.419f, 2.753f, 11.0f}));
    EXPECT_EQ(FurLine{}, coats->at("coat")) << "the defaults are the bear's";
}

TEST(FurLines, ASecondMaterialHasItsOwn) {
    const auto coats = read_fur_lines("newmtl a b\n\tfur   2 1e-6 0 1\t\nnewmtl c\nfur 4096 100 10 4096", "two.mtl");
    ASSERT_TRUE(coats) << coats.error();
    EXPECT_EQ(coats->at("a b"), (FurLine{2, 1e-6f, 0.0f, 1.0f}));
    EXPECT_EQ(coats->at("c"), (FurLine{4096, 100.0f, 10.0f, 4096.0f}));
}

TEST(FurLines, WhatIsWrongIsRejectedWithFileAndLine) {
    const std::pair<const char*, const char*> wrong[] = {{"fur 48 0.419 2.753", "four numbers"},
                                                         {"fur 48 0.419 2.753 11 1", "four numbers"},
                                                         {"fur", "four numbers"},
                                                         {"fur 48.5 0.419 2.753 11", "shell count"},
                                                         {"fur 1 0.419 2.753 11", "fur.shells is 1: give 2 to 4096."},
                                                         {"fur 4097 0.4 2 11", "fur.shells is 4097"},
                                                         {"fur 99999999999 0.4 2 11", "shell count"},
                                                         {"fur 48 0 2.753 11", "height"},
                                                         {"fur 48 nan 2.753 11", "height"},
                                                         {"fur 48 -1 2.753 11", "height"},
                                                         {"fur 48 0,4 2.753 11", "height"},
                                                         {"fur 48 0.4 inf 11", "thickness"},
                                                         {"fur 48 0.4 10.1 11", "thickness"},
                                                         {"fur 48 0.4 2 0.5", "resolution"},
                                                         {"fur 48 0.4 2 4097", "resolution"},
                                                         {"fur 48 0.4 2 11 # eleven", "four numbers"},
                                                         {"fur 48 0.4 2 1e99", "resolution"}};
    for (const auto& [line, field] : wrong) {
        const auto coats = read_fur_lines(std::string("newmtl coat\n\n") + line + "\n", "wrong.mtl");
        ASSERT_FALSE(coats) << line;
        EXPECT_EQ(coats.error().find("wrong.mtl:3: fur"), 0u) << coats.error();
        EXPECT_NE(coats.error().find(field), std::string::npos) << coats.error();
    }
    EXPECT_NE(read_fur_lines("fur 48 0.419 2.753 11", "a.mtl").error().find("a.mtl:1: fur line before any newmtl"),
              std::string::npos);
    EXPECT_NE(read_fur_lines("newmtl a\nfur 9 1 1 1\nfur 9 1 1 1", "a.mtl").error().find("a.mtl:3: duplicate fur line"),
              std::string::npos);
}

} // namespace
} // namespace windrow::vegetation::fur
