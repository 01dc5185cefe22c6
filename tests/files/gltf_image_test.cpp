// tests/files/gltf_image_test.cpp: textures: valid, damaged and meant to exhaust memory.

#include <algorithm>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/characters/material_post.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;

const std::string kTwoPixels("\x00\xff\x00\x00\x00\x00\xff", 7);  // red, blue

/// A post whose material uses the image. @param webp  additional image for readers that support it
std::shared_ptr<const Character> importWith(const std::string& image, const std::string& webp = {}) {
  test::Post post = test::makePost();
  post.file.json["images"].push_back({{"bufferView", post.file.view(image)}, {"mimeType", "image/png"}});
  ordered_json extensions = ordered_json::object();
  if (!webp.empty()) {
    post.file.json["images"].push_back({{"bufferView", post.file.view(webp)}, {"mimeType", "image/webp"}});
    extensions["EXT_texture_webp"]["source"] = 1;
    post.file.json["extensionsUsed"].push_back("EXT_texture_webp");
  }
  post.file.json["samplers"].push_back({{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  post.file.json["textures"].push_back({{"source", 0}, {"sampler", 0}, {"extensions", extensions}});
  ordered_json color{{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0.5}};
  post.file.json["materials"].push_back({{"pbrMetallicRoughness", color}});
  post.primitive()["material"] = 0;
  const test::TemporaryFolder folder;
  const auto imported = importGltf(folder.write("post.glb", post.file.glb()));
  EXPECT_TRUE(imported.ok()) << (imported.ok() ? "" : imported.error().text());
  return imported.ok() ? imported.value() : std::make_shared<const Character>();
}

void expectLeftOut(const std::string& image, const std::string& why) {
  const auto character = importWith(image);
  ASSERT_EQ(character->materials.size(), 1u);
  EXPECT_EQ(character->materials[0].baseColorTexture, -1);
  EXPECT_TRUE(character->textures.empty());
  ASSERT_EQ(character->ignored.size(), 1u);
  EXPECT_NE(character->ignored[0].find("images[0]: "), std::string::npos) << character->ignored[0];
  EXPECT_NE(character->ignored[0].find(why), std::string::npos) << character->ignored[0];
}

TEST(GltfImage, PixelsSamplerAndFileAreImported) {
  const std::string image = test::storedPng(2, 1, kTwoPixels);
  const auto character = importWith(image);
  ASSERT_EQ(character->textures.size(), 1u);
  const Texture& texture = character->textures[0];
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 1);
  EXPECT_EQ(texture.rgba, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 0, 255, 255}));
  EXPECT_EQ(std::string(texture.encoded.begin(), texture.encoded.end()), image);
  EXPECT_EQ(texture.mimeType, "image/png");
  EXPECT_EQ(texture.wrapU, TextureWrap::kClampToEdge);
  EXPECT_EQ(texture.wrapV, TextureWrap::kMirroredRepeat);
  EXPECT_TRUE(texture.nearest);
  EXPECT_EQ(character->materials[0].baseColorTexture, 0);
  EXPECT_EQ(character->materials[0].metallic, 0.5f);
}

TEST(GltfImage, UnreadableImagesAreSkipped) {
  expectLeftOut("GIF89a", "not a PNG, JPEG or WebP");
  expectLeftOut("\xff\xd8\xff\xe0 broken", "damaged");
  expectLeftOut(test::storedPng(2, 1, "\x07"), "damaged");
}

TEST(GltfImage, HugeDimensionsAreRefusedBeforeDecoding) {
  expectLeftOut(test::storedPng(8193, 1, kTwoPixels), "8193 x 1");
  expectLeftOut(test::storedPng(12000, 9000, kTwoPixels), "12000 x 9000");
}

TEST(GltfImage, OversizedPngDataIsRefused) {
  expectLeftOut(test::storedPng(2, 1, std::string(400'000, '\0')), "unpacks to more");
}

const std::vector<std::uint8_t> kFourPixels{255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 7, 9, 8, 7, 255};

TEST(GltfImage, WebpIsPreferredOverThePngFallback) {
  const std::string image = test::losslessWebp(2, 2, kFourPixels);
  const auto character = importWith(test::storedPng(2, 1, kTwoPixels), image);
  ASSERT_EQ(character->textures.size(), 1u);
  const Texture& texture = character->textures[0];
  EXPECT_EQ(texture.width, 2);
  EXPECT_EQ(texture.height, 2);
  EXPECT_EQ(texture.mimeType, "image/webp");
  EXPECT_EQ(texture.rgba, kFourPixels);
  EXPECT_EQ(std::string(texture.encoded.begin(), texture.encoded.end()), image);
  EXPECT_TRUE(character->ignored.empty());
}

TEST(GltfImage, TruncatedWebpIsSkipped) {
  const std::string whole = test::losslessWebp(2, 2, kFourPixels);
  for (std::size_t length = 13; length + 2 < whole.size(); length += 3) {
    expectLeftOut(whole.substr(0, length), "damaged image");
  }
}

TEST(GltfImage, WebpOfTooManyPixelsIsSkippedBeforeDecoding) {
  std::string image = test::losslessWebp(2, 2, kFourPixels);
  const std::size_t sizes = image.find("VP8L") + 9;  // After length and signature: 14 bits each, minus one.
  image[sizes] = static_cast<char>(0xff);
  image[sizes + 1] = static_cast<char>(0x3f | (image[sizes + 1] & 0xc0));
  expectLeftOut(image, "16384 x 2");
}

}  // namespace
}  // namespace sinew
