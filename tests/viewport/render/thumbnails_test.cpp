// tests/viewport/render/thumbnails_test.cpp: thumbnails belong to a document as stored on disk; a damaged one is
// ignored.

#include "app/viewport/render/thumbnails.h"

#include <chrono>
#include <cstdlib>

#include "app/document/view_files.h"
#include "app/viewport/render/picture_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using app::Image;

/// A light square in the middle of a dark picture.
Image pictureOf(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool light = std::abs(2 * x - width) < height / 2 && std::abs(2 * y - height) < height / 2;
      for (int c = 0; c < 3; ++c) image.rgba.push_back(light ? 200 : 40);
      image.rgba.push_back(255);
    }
  }
  return image;
}

TEST(Thumbnails, AreScaledFromTheMiddleOfThePicture) {
  for (const auto& [width, height] : {std::pair(800, 600), {1920, 700}, {300, 900}, {144, 108}}) {
    const Image small = app::thumbnailOf(pictureOf(width, height));
    EXPECT_EQ(glm::ivec2(small.width, small.height), app::kThumbnailSize);
    ASSERT_EQ(small.rgba.size(), 4u * 144u * 108u);
    EXPECT_EQ(pixelAt(small, 72, 54), (Pixel{200, 200, 200, 255}));
    if (width >= height) {
      EXPECT_EQ(pixelAt(small, 1, 1), (Pixel{40, 40, 40, 255}));
    }
  }
}

TEST(Thumbnails, RoundTripAndRefuseInvalidBytes) {
  const Image small = app::thumbnailOf(pictureOf(800, 600));
  const auto png = app::pngBytes(small);
  ASSERT_TRUE(png.ok());
  const auto read = app::readThumbnail(png.value());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->rgba, small.rgba);
  EXPECT_FALSE(app::readThumbnail("").has_value());
  EXPECT_FALSE(app::readThumbnail("garbage").has_value());
  EXPECT_FALSE(app::readThumbnail(std::string_view(png.value()).substr(0, 60)).has_value());
  EXPECT_FALSE(app::readThumbnail(app::pngBytes(pictureOf(64, 64)).value()).has_value()) << "another size";
}

TEST(Thumbnails, BelongToTheCurrentVersionOfTheDocument) {
  const TemporaryFolder own;
  const fs::path cache = own.path() / "cache";
  const fs::path document = own.write("a.rig.json", "one");
  const fs::path file = app::thumbnailFile(cache, document);
  EXPECT_EQ(file.parent_path(), cache);
  EXPECT_EQ(app::thumbnailFile(cache, own.path() / "." / "a.rig.json"), file);
  fs::create_symlink(document, own.path() / "link.rig.json");
  EXPECT_EQ(app::thumbnailFile(cache, own.path() / "link.rig.json"), file);
  EXPECT_NE(app::thumbnailFile(cache, own.write("b.rig.json", "one")), file);
  EXPECT_EQ(app::thumbnailFile(cache, own.path() / "absent.glb"), fs::path());
  fs::last_write_time(document, fs::last_write_time(document) + std::chrono::seconds(5));
  EXPECT_NE(app::thumbnailFile(cache, document), file) << "changed elsewhere";
}

TEST(Thumbnails, CacheIsBounded) {
  const TemporaryFolder own;
  const fs::path cache = own.path() / "cache";
  fs::create_directories(cache);
  const auto past = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (std::size_t i = 0; i < app::kMostThumbnails + 20; ++i) {
    const fs::path file = own.write("cache/" + std::to_string(i) + ".png", "old");
    fs::last_write_time(file, past + std::chrono::seconds(i));
  }
  const fs::path document = own.write("a.glb", "one");
  ASSERT_TRUE(app::keepThumbnail(cache, document, "new").ok());
  EXPECT_TRUE(fs::exists(app::thumbnailFile(cache, document)));
  EXPECT_FALSE(fs::exists(cache / "0.png")) << "the oldest goes";
  EXPECT_TRUE(fs::exists(cache / "300.png"));
  EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(cache), fs::directory_iterator())),
            app::kMostThumbnails);
  EXPECT_FALSE(app::keepThumbnail(own.write("file", "") / "below", document, "new").ok());
}

TEST_F(Drawing, ThumbnailTexturesComeFromTheCache) {
  const TemporaryFolder own;
  const fs::path document = own.write("a.glb", "one");
  app::Thumbnails thumbnails(own.path() / "cache");
  const auto changed = fs::last_write_time(document);
  EXPECT_EQ(thumbnails.texture(document, changed), 0u);
  thumbnails.keep(document, pictureOf(640, 480));
  const unsigned texture = thumbnails.texture(document, changed);
  ASSERT_NE(texture, 0u);
  EXPECT_EQ(thumbnails.texture(document, changed), texture) << "read once";
  app::Thumbnails later(own.path() / "cache");
  EXPECT_NE(later.texture(document, changed), 0u) << "it lasts";
  own.write("cache/" + app::thumbnailFile(own.path() / "cache", document).filename().string(), "garbage");
  app::Thumbnails damaged(own.path() / "cache");
  EXPECT_EQ(damaged.texture(document, changed), 0u);
}

}  // namespace
}  // namespace sinew::test
