// tests/document/file_stamp_test.cpp: content stamps of files, and free file names.

#include "app/document/file_stamp.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

TEST(FileStamp, MatchesThePublishedHash) {
  // Test vectors of draft-eastlake-fnv, FNV-1a with 64 bits.
  EXPECT_EQ(stampOf("").hash, 0xcbf29ce484222325u);
  EXPECT_EQ(stampOf("a").hash, 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(stampOf("foobar").hash, 0x85944171f73967e8u);
  EXPECT_EQ(stampOf("foobar").bytes, 6u);
}

TEST(FileStamp, ChangesWithAnyByte) {
  std::mt19937 random(3);
  std::string text(200, ' ');
  for (char& c : text) c = static_cast<char>(random());
  const FileStamp before = stampOf(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = static_cast<char>(other[i] ^ (1 << (random() % 8)));
    EXPECT_NE(stampOf(other), before) << i;
  }
}

TEST(FileStamp, TextRoundTripsAndOtherTextIsRefused) {
  for (const char* content : {"", "a", "foobar"}) {
    const FileStamp stamp = stampOf(content);
    EXPECT_EQ(stampFromText(textOfStamp(stamp)), stamp);
  }
  EXPECT_EQ(textOfStamp(std::nullopt), "");
  for (const char* bad : {"", "x", "12", ":ab"}) EXPECT_FALSE(stampFromText(bad).has_value()) << bad;
}

TEST(FileStamp, ComparesWithTheFileOnDisk) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("a.rig.json", "one");
  EXPECT_EQ(compareWithDisk(file, stampOf("one")), OnDisk::kSame);
  EXPECT_EQ(compareWithDisk(file, stampOf("two")), OnDisk::kChanged);
  EXPECT_EQ(compareWithDisk(file, std::nullopt), OnDisk::kChanged) << "one that was not there has appeared";
  EXPECT_EQ(compareWithDisk(folder.path() / "none", stampOf("one")), OnDisk::kGone);
  EXPECT_EQ(compareWithDisk(folder.path() / "none", std::nullopt), OnDisk::kSame);
}

TEST(FileStamp, IncludesOnlyBuffersInTheSameFolder) {
  const test::TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& text) { return folder.write(name, text); };
  const auto uses = [&](const std::string& uri) {
    return write("inside/a.gltf",
                 R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 1, "uri": ")" + uri + R"("}]})");
  };
  std::filesystem::create_directories(folder.path() / "inside");
  write("secret.bin", "1");
  std::filesystem::create_symlink(folder.path() / "secret.bin", folder.path() / "inside/link.bin");
  // Of the files that change here, only the first lies in the folder.
  for (const std::string uri : {"own.bin", "link.bin", "../secret.bin"}) {
    const auto file = uses(uri);
    write("inside/own.bin", "1");
    write("secret.bin", "1");
    const auto before = stampOfFile(file);
    write("inside/own.bin", "2");
    write("secret.bin", "2");
    EXPECT_EQ(stampOfFile(file) == before, uri != "own.bin") << uri;
  }
  EXPECT_TRUE(stampOfFile(uses("a.gltf")).has_value()) << "a file that is its own buffer";
}

TEST(FileStamp, FreeNameBesideContinuesTheNumbering) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("arm.rig.json", "");
  EXPECT_EQ(freeNameBeside(file).filename(), "arm 2.rig.json");
  const auto second = folder.write("arm 2.rig.json", "");
  EXPECT_EQ(freeNameBeside(file).filename(), "arm 3.rig.json");
  EXPECT_EQ(freeNameBeside(second).filename(), "arm 3.rig.json");
  EXPECT_EQ(freeNameBeside(folder.path() / "2.rig.json").filename(), "2 2.rig.json");
  EXPECT_EQ(freeNameBeside(folder.path() / "leg.json").filename(), "leg 2.json");
}

}  // namespace
}  // namespace sinew::app
