// Files on every system: names with blanks and letters of all scripts, bytes that stay as they are, names that cannot be.
#include "fluid/files/input_file.h"
#include "fluid/files/streamed_file.h"
#include "fluid/files/text_lines.h"
#include "tests/own_folder.h"

#include <cerrno>
#include <ostream>

namespace windrow {
namespace {

namespace fs = std::filesystem;
using detail::NewFile;

using FileNames = test::FolderTest;
using test::text_of;

Result<std::string> read_back(const fs::path& file) {
    detail::InputBudget budget;
    return detail::read_input(file, {.folder = file.parent_path(), .max_bytes = 1 << 20}, budget);
}

// UTF-8 in the source: blanks, Latin, Cyrillic, Greek, Chinese, a letter beyond 16 bits.
const std::u8string k_names[] = {u8"two words.wind", u8"Größe_è.wind", u8"ветер.wind", u8"άνεμος.wind", u8"风.wind", u8"𝒲.wind"};

TEST_F(FileNames, MayHaveBlanksAndLettersOfEveryScript) {
    for (const std::u8string& letters : k_names) {
        const fs::path inner = folder / fs::path(letters), file = inner / fs::path(letters);
        ASSERT_TRUE(fs::create_directory(inner));
        for (const char* const bytes : {"old", "newer"}) // the second replaces the first
            ASSERT_TRUE(detail::write_file("file", file, bytes));
        const auto back = read_back(file);
        ASSERT_TRUE(back) << back.error();
        EXPECT_EQ(*back, "newer");
        EXPECT_EQ(std::distance(fs::directory_iterator(inner), fs::directory_iterator()), 1) << file;
        // A message has the name in UTF-8, whatever the system calls it.
        const auto missing = read_back(inner / u8"no such ветер");
        ASSERT_FALSE(missing);
        EXPECT_NE(missing.error().find(reinterpret_cast<const char*>(u8"no such ветер: no such file")), std::string::npos)
            << missing.error();
    }
}

// A part's name is cut to fit; a letter of several bytes is not.
TEST_F(FileNames, MayBeLong) {
    std::u8string letters(40, u8'n');
    for (int n = 0; n < 60; ++n)
        letters += u8"风";
    const fs::path file = folder / fs::path(letters);
    const auto written = detail::write_file("file", file, "x");
    ASSERT_TRUE(written) << written.error();
    EXPECT_EQ(text_of(file), "x");
}

// No line end is changed, no byte ends a file: 26 is the end of a text on DOS.
TEST_F(FileNames, BytesStayAsTheyAre) {
    std::string bytes;
    for (int n = 0; n < 3 * 256; ++n)
        bytes += static_cast<char>(n);
    bytes += "a\nb\r\nc\rd\n\r\x1a after";
    {
        detail::StreamedFile file(folder / "bytes");
        std::ostream stream(&file);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.seekp(2);
        stream << "\n\r";
        ASSERT_TRUE(file.publish()) << detail::reason_of(file.error());
    }
    bytes.replace(2, 2, "\n\r");
    EXPECT_EQ(text_of(folder / "bytes"), bytes);
    const auto back = read_back(folder / "bytes");
    ASSERT_TRUE(back) << back.error();
    EXPECT_EQ(*back, bytes);
}

TEST_F(FileNames, LinesEndInEitherWay) {
    for (const char* const text :
         {"v 1 2\nf 3\n\nend", "v 1 2\r\nf 3\r\n\r\nend", "v 1 2\r\nf 3\n\r\nend\r\n", "\xef\xbb\xbfv 1 2\nf 3\n\nend"}) {
        detail::TextLines lines(text);
        std::string all;
        for (std::string_view line; lines.next(line);)
            all += std::string(line) + '|';
        EXPECT_EQ(all, "v 1 2|f 3||end|") << text;
    }
}

// All readers of text call it: heights, meshes, voxels, scenes, tables, flags.
TEST(Words, SpellNumbersInOneWay) {
    using detail::number_of;
    EXPECT_EQ(number_of<double>("+1.5e3"), 1500.0);
    EXPECT_EQ(number_of<float>("-.25"), -0.25f);
    EXPECT_EQ(number_of<int>("+7"), 7);
    EXPECT_EQ(number_of<std::uint32_t>("65535"), 65535u);
    for (const char* tiny : {"1e-400", "-2.5E-999", "0.1e-46"}) // an exporter's rounding
        EXPECT_EQ(number_of<float>(tiny), 0.0f) << tiny;
    for (const char* none : {"", "+", "+-1", "++1", "1,5", "1.5m", " 1", "1 ", "nan", "inf", "-inf", "1e400", "0x10", "e-1"})
        EXPECT_FALSE(number_of<double>(none)) << none;
    for (const char* none : {"1.0", "1e2", "99999999999999999999", "-"})
        EXPECT_FALSE(number_of<long long>(none)) << none;
    EXPECT_FALSE(number_of<std::uint32_t>("-1"));
    EXPECT_FALSE(number_of<int>("2147483648"));
}

TEST_F(FileNames, OfFoldersAndInMissingFoldersAreRejected) {
    EXPECT_EQ(NewFile(folder).error(), EISDIR);
    EXPECT_EQ(NewFile(folder / "missing" / "name").error(), ENOENT);
    EXPECT_EQ(entries(), 0);
    const auto read = read_back(folder);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().find(": is a folder: name a file in it."), std::string::npos) << read.error();
}

TEST_F(FileNames, OfDevicesAreRejected) {
#if defined(_WIN32)
    const fs::path device = "NUL";
#else
    const fs::path device = "/dev/null";
#endif
    EXPECT_EQ(NewFile(device).error(), ENXIO);
    detail::InputBudget budget;
    const auto read = detail::read_input(device, {.max_bytes = 100}, budget);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().find(": is a pipe or a device: name a regular file."), std::string::npos) << read.error();
}

// One that lives is locked; one whose writer ended without removing it is not.
TEST_F(FileNames, PartsThatNobodyWritesAreCleared) {
    NewFile living(folder / "living");
    ASSERT_EQ(living.error(), 0);
    std::ofstream(folder / "left.1.2.windrow-part") << "half";
    std::ofstream(folder / "a user's.part") << "mine";
    EXPECT_EQ(entries(), 3);
    detail::clear_dead_parts(folder);
    EXPECT_EQ(entries(), 2);
    EXPECT_TRUE(living.write("whole"));
    EXPECT_TRUE(living.publish());
    EXPECT_EQ(text_of(folder / "living"), "whole");
}

} // namespace
} // namespace windrow
