// tests/files/gltf_bad_input_test.cpp: damaged, wrong or hostile files give an actionable one-line error, never a
// crash.

#include <array>
#include <functional>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/files/no_harm.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;
using test::makePost;
using test::Post;

struct BadPost {
  const char* name;
  std::function<void(Post&)> bend;
  const char* place;   ///< Part of the error's place.
  const char* reason;  ///< Part of its reason.
};

void PrintTo(const BadPost& bad, std::ostream* out) { *out << bad.name; }

ordered_json& positionAccessor(Post& post) {
  return post.file.json["accessors"][post.attributes()["POSITION"].get<std::size_t>()];
}

class BadGltf : public testing::TestWithParam<BadPost> {};

TEST_P(BadGltf, IsRefusedWithPlaceAndReason) {
  Post post = makePost();
  GetParam().bend(post);
  const test::TemporaryFolder folder;
  const auto file = folder.write("bad.glb", post.file.glb());
  const auto imported = importGltf(file);
  ASSERT_FALSE(imported.ok());
  test::expectOneLine(imported.error(), file);
  EXPECT_NE(imported.error().place.find(GetParam().place), std::string::npos) << imported.error().text();
  EXPECT_NE(imported.error().reason.find(GetParam().reason), std::string::npos) << imported.error().text();
  const std::string plain = imported.error().plainText();
  EXPECT_TRUE(plain.starts_with("bad.glb: ")) << "the interface shows no whole path: " << plain;
  EXPECT_FALSE(imported.error().subject.empty());
  EXPECT_EQ(plain.find(": " + imported.error().place + ": "), std::string::npos) << plain;
}

/// All vertices have different weights, so that none are welded.
void withoutExtent(Post& post, float size) {
  std::vector<float> positions(36, 0.0f);
  std::vector<float> weights;
  for (int i = 0; i < 12; ++i) {
    const auto share = static_cast<float>(i) / 12.0f;
    positions[static_cast<std::size_t>(3 * i + i % 3)] = share * size;
    weights.insert(weights.end(), {1.0f - share, share, 0.0f, 0.0f});
  }
  post.attributes()["POSITION"] = post.file.accessor(positions, "VEC3");
  post.attributes()["WEIGHTS_0"] = post.file.accessor(weights, "VEC4");
}

void withPositions(Post& post, float first) {
  post.positions[0] = first;
  post.attributes()["POSITION"] = post.file.accessor(post.positions, "VEC3");
}

void withKeys(Post& post, float time, float value) {
  post.file.json["animations"][0]["samplers"][0] = {
      {"input", post.file.accessor(std::vector<float>{0.0f, time}, "SCALAR")},
      {"output", post.file.accessor(std::vector<float>{0, 0, 0, 1, value, 0, 0, 1}, "VEC4")}};
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

INSTANTIATE_TEST_SUITE_P(
    Numbers, BadGltf,
    testing::Values(BadPost{"not a number", [](Post& p) { withPositions(p, kNan); }, "accessors",
                            "position 0 is not finite"},
                    BadPost{"infinite", [](Post& p) { withPositions(p, -kInfinity); }, "accessors", "not finite"},
                    BadPost{"too far", [](Post& p) { withPositions(p, 3e38f); }, "accessors", "too large"},
                    BadPost{"nan weight",
                            [](Post& p) {
                              p.weights[0] = kNan;
                              p.attributes()["WEIGHTS_0"] = p.file.accessor(p.weights, "VEC4");
                            },
                            "accessors", "weight"},
                    BadPost{"nan bind",
                            [](Post& p) {
                              p.file.json["skins"][0]["inverseBindMatrices"] =
                                  p.file.accessor(std::vector<float>(32, kNan), "MAT4");
                            },
                            "accessors", "not finite"},
                    BadPost{"nan key time", [](Post& p) { withKeys(p, kNan, 0.0f); }, "accessors", "key time 1"},
                    BadPost{"nan key value", [](Post& p) { withKeys(p, 1.0f, kNan); }, "accessors", "value 1"},
                    BadPost{"far node",
                            [](Post& p) {
                              p.file.json["nodes"][1]["translation"] = {1e200, 0, 0};
                            },
                            "nodes[1]", "too large"},
                    BadPost{"text for a number",
                            [](Post& p) {
                              p.file.json["nodes"][1]["translation"] = {"1", 0, 0};
                            },
                            "nodes[1].translation[0]", "expected a number"},
                    BadPost{"two numbers",
                            [](Post& p) {
                              p.file.json["nodes"][1]["translation"] = {1, 0};
                            },
                            "nodes[1].translation", "expected 3 numbers"}));

INSTANTIATE_TEST_SUITE_P(
    Indices, BadGltf,
    testing::Values(
        BadPost{"vertex",
                [](Post& p) {
                  p.indices[7] = 12;
                  p.primitive()["indices"] = p.file.accessor(p.indices, "SCALAR");
                },
                "accessors", "index 12; the primitive has 12 vertices"},
        BadPost{"joint",
                [](Post& p) {
                  p.joints[0] = 2;
                  p.attributes()["JOINTS_0"] = p.file.accessor(p.joints, "VEC4");
                },
                "accessors", "names joint 2; the skin has 2"},
        BadPost{"accessor", [](Post& p) { p.attributes()["POSITION"] = 99; },
                "meshes[0].primitives[0].attributes.POSITION", "there is no accessor 99"},
        BadPost{"negative accessor", [](Post& p) { p.attributes()["POSITION"] = -1; }, "attributes.POSITION", ">= 0"},
        BadPost{"buffer view", [](Post& p) { positionAccessor(p)["bufferView"] = 1000; }, "accessors[0].bufferView",
                "there is no bufferView 1000"},
        BadPost{"mesh", [](Post& p) { p.file.json["nodes"][0]["mesh"] = 1; }, "nodes[0].mesh", "there is no mesh 1"},
        BadPost{"skin", [](Post& p) { p.file.json["nodes"][0]["skin"] = 1.5; }, "nodes[0].skin", "whole number"},
        BadPost{"joint node", [](Post& p) { p.file.json["skins"][0]["joints"][1] = 3; }, "skins[0].joints[1]",
                "there is no node 3"},
        BadPost{"few binds",
                [](Post& p) {
                  p.file.json["skins"][0]["joints"] = {1, 2, 1};
                },
                "accessors", "2 inverse bind matrices for 3"},
        BadPost{"shape", [](Post& p) { p.attributes()["POSITION"] = p.attributes()["WEIGHTS_0"]; },
                "attributes.POSITION", "VEC3 expected"},
        BadPost{"few weights",
                [](Post& p) {
                  p.weights.resize(40);
                  p.attributes()["WEIGHTS_0"] = p.file.accessor(p.weights, "VEC4");
                },
                "accessors", "10 values of WEIGHTS_0 for 12 positions"},
        BadPost{"own child", [](Post& p) { p.file.json["nodes"][2]["children"] = {2}; }, "nodes[2].children[0]",
                "own child"},
        BadPost{"cycle",
                [](Post& p) {
                  p.file.json["nodes"][1].erase("children");
                  p.file.json["nodes"][2]["children"] = {1};
                  p.file.json["nodes"][1]["children"] = {2};
                },
                "nodes", "own ancestors"},
        BadPost{"two parents", [](Post& p) { p.file.json["nodes"][0]["children"] = {2}; }, "nodes[1].children[0]",
                "already has a parent"}));

INSTANTIATE_TEST_SUITE_P(
    Sizes, BadGltf,
    testing::Values(
        BadPost{"count beyond the view", [](Post& p) { positionAccessor(p)["count"] = 13; }, "accessors[0]",
                "needs 156 bytes"},
        BadPost{"huge count", [](Post& p) { positionAccessor(p)["count"] = 4'000'000'000U; }, "accessors[0].count",
                "too many"},
        BadPost{"count over 64 bits", [](Post& p) { positionAccessor(p)["count"] = 1e300; }, "accessors[0].count",
                "whole number"},
        BadPost{"huge count of nothing",
                [](Post& p) {
                  positionAccessor(p)["count"] = 2'000'000'000;
                  positionAccessor(p).erase("bufferView");
                },
                "accessors", "2000000000 positions"},
        BadPost{"huge offset", [](Post& p) { positionAccessor(p)["byteOffset"] = 9007199254740992ULL; }, "accessors[0]",
                "needs"},
        BadPost{"view beyond the buffer", [](Post& p) { p.file.json["bufferViews"][0]["byteOffset"] = 1'000'000; },
                "bufferViews[0]", "beyond"},
        BadPost{"view that wraps", [](Post& p) { p.file.json["bufferViews"][0]["byteLength"] = 9007199254740992ULL; },
                "bufferViews[0]", "beyond"},
        BadPost{"buffer cut short", [](Post& p) { p.file.json["buffers"][0]["byteLength"] = 1'000'000; }, "buffers[0]",
                "promises 1000000"},
        BadPost{"stride", [](Post& p) { p.file.json["bufferViews"][0]["byteStride"] = 4; }, "accessors[0]", "stride 4"},
        BadPost{"sparse out of order",
                [](Post& p) {
                  const int indices = p.file.viewOf(std::vector<std::uint8_t>{3, 3});
                  positionAccessor(p)["sparse"] = {{"count", 2},
                                                   {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                                   {"values", {{"bufferView", 0}}}};
                },
                "accessors[0].sparse.indices", "increasing"},
        BadPost{"sparse beyond",
                [](Post& p) {
                  positionAccessor(p)["sparse"] = {
                      {"count", 12},
                      {"indices", {{"bufferView", 0}, {"componentType", 5121}, {"byteOffset", 140}}},
                      {"values", {{"bufferView", 0}}}};
                },
                "accessors[0].sparse.indices", "needs 152 bytes"},
        BadPost{"too many triangles",
                [](Post& p) {
                  p.primitive().erase("indices");
                  p.attributes() = {{"POSITION", p.file.json["accessors"].size()}};
                  p.file.json["accessors"].push_back({{"componentType", 5126}, {"count", 6'000'003}, {"type", "VEC3"}});
                },
                "meshes[0].primitives[0]", "more than 2 million"},
        BadPost{"too many joints", [](Post& p) { p.file.json["skins"][0]["joints"] = std::vector<int>(4097, 1); },
                "skins", "4096 joints"},
        BadPost{
            "too many clips",
            [](Post& p) { p.file.json["animations"] = std::vector<ordered_json>(1001, p.file.json["animations"][0]); },
            "animations", "1000 clips"}));

INSTANTIATE_TEST_SUITE_P(
    Contents, BadGltf,
    testing::Values(
        BadPost{"old version", [](Post& p) { p.file.json["asset"]["version"] = "1.0"; }, "asset.version",
                "2.0 expected"},
        BadPost{"no asset", [](Post& p) { p.file.json.erase("asset"); }, "asset.version", "no glTF"},
        BadPost{"no mesh", [](Post& p) { p.file.json["nodes"][0].erase("mesh"); }, "meshes", "no triangles"},
        BadPost{"only lines", [](Post& p) { p.primitive()["mode"] = 1; }, "meshes", "no triangles"},
        BadPost{"mode", [](Post& p) { p.primitive()["mode"] = 7; }, "meshes[0].primitives[0].mode", "unknown mode 7"},
        BadPost{"one point",
                [](Post& p) { p.attributes()["POSITION"] = p.file.accessor(std::vector<float>(36, 0.5f), "VEC3"); },
                "meshes", "collapsed"},
        BadPost{"a version without end", [](Post& p) { p.file.json["asset"]["version"] = std::string(5000, '9'); },
                "asset.version", "expected"},
        BadPost{"an extension without end",
                [](Post& p) { p.file.json["extensionsRequired"] = {std::string(5000, 'x')}; }, "extensionsRequired[0]",
                "xxx"},
        BadPost{"one point that follows many bones", [](Post& p) { withoutExtent(p, 0.0f); }, "meshes", "no extent"},
        BadPost{"smaller than numbers can tell", [](Post& p) { withoutExtent(p, 1e-30f); }, "meshes", "no extent"},
        BadPost{"required Basis", [](Post& p) { p.file.json["extensionsRequired"] = {"KHR_texture_basisu"}; },
                "extensionsRequired[0]", "KHR_texture_basisu"},
        BadPost{"interpolation",
                [](Post& p) { p.file.json["animations"][0]["samplers"][0]["interpolation"] = "BEZIER"; },
                "animations[0].samplers[0].interpolation", "LINEAR"},
        BadPost{"object for a list",
                [](Post& p) {
                  p.file.json["nodes"] = {{"a", 1}};
                },
                "nodes", "expected an array"}));

BadPost uri(const char* text, const char* reason) {
  return {text, [text](Post& p) { p.file.json["images"].push_back({{"uri", text}}); }, "images[0].uri", reason};
}

INSTANTIATE_TEST_SUITE_P(Uris, BadGltf,
                         testing::Values(uri("../secret.png", "\"..\""), uri("a/../../secret.png", "\"..\""),
                                         uri("%2e%2e/secret.png", "\"..\""), uri("a/%2E%2e/x.png", "\"..\""),
                                         uri("/etc/passwd", "absolute"), uri("%2fetc/passwd", "absolute"),
                                         uri("..\\secret.png", "backslash"), uri("..%5csecret.png", "backslash"),
                                         uri("file:///etc/passwd", "scheme"), uri("http://example.org/x.png", "scheme"),
                                         uri("HTTPS:x", "scheme"), uri("C:/x.png", "scheme"), uri("%66ile:x", "scheme"),
                                         uri("a%00.png", "control"), uri("a%0a.png", "control"), uri("%", "%"),
                                         uri("", "empty")));

TEST(BadGltfFile, BuffersObeyTheFolderRule) {
  const test::TemporaryFolder folder;
  const Post post = makePost();
  folder.write("outside.bin", post.file.binary());
  for (const char* uri : {"../outside.bin", "%2e%2e/outside.bin", "sub/../../outside.bin"}) {
    const auto file = folder.write("inner/bad.gltf", post.file.gltfWithBufferAt(uri));
    const auto imported = importGltf(file);
    ASSERT_FALSE(imported.ok()) << uri;
    EXPECT_EQ(imported.error().place, "buffers[0].uri");
  }
}

TEST(BadGltfFile, SymbolicLinksMayNotLeaveTheFolder) {
  const test::TemporaryFolder folder;
  const Post post = makePost();
  const auto outside = folder.write("outside.bin", post.file.binary());
  const auto file = folder.write("inner/linked.gltf", post.file.gltfWithBufferAt("link.bin"));
  std::filesystem::create_symlink(outside, folder.path() / "inner/link.bin");
  const auto imported = importGltf(file);
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().reason.find("own folder"), std::string::npos) << imported.error().text();

  folder.write("inner/real.bin", post.file.binary());
  std::filesystem::remove(folder.path() / "inner/link.bin");
  std::filesystem::create_symlink("real.bin", folder.path() / "inner/link.bin");
  EXPECT_TRUE(importGltf(file).ok()) << "a link within the folder is fine";
}

TEST(BadGltfFile, MissingAndEmptyFilesAreRefused) {
  const test::TemporaryFolder folder;
  for (const auto& file : {folder.path() / "absent.glb", folder.path(), folder.write("empty.glb", ""),
                           folder.write("text.gltf", "not JSON"), folder.write("list.gltf", "[]"),
                           folder.write("short.glb", "glTF"), folder.write("zero.glb", std::string(64, '\0')),
                           folder.write("lost.gltf", makePost().file.gltfWithBufferAt("absent.bin")),
                           folder.write("base64.gltf", makePost().file.gltfWithBufferAt("data:x;base64,A*=="))}) {
    const auto imported = importGltf(file);
    ASSERT_FALSE(imported.ok()) << file;
    test::expectOneLine(imported.error(), file);
  }
}

TEST(BadGltfFile, DeepNestingAndManyValuesAreRefusedBeforeParsing) {
  const test::TemporaryFolder folder;
  const std::string deep = R"({"asset":{"version":"2.0"},"extras":)" + std::string(1'000'000, '[');
  std::string many = R"({"asset":{"version":"2.0"},"extras":[0)";
  for (int i = 0; i < 5'000'000; ++i) many += ",0";
  for (const auto& [text, reason] : {std::pair{deep, "nested"}, {many + "]}", "4 million"}}) {
    const auto file = folder.write("big.gltf", text);
    const auto imported = importGltf(file);
    ASSERT_FALSE(imported.ok());
    test::expectOneLine(imported.error(), file);
    EXPECT_NE(imported.error().reason.find(reason), std::string::npos) << imported.error().text();
  }
}

TEST(BadGltfFile, TruncatedFilesAreRefused) {
  const test::TemporaryFolder folder;
  const std::string whole = makePost().file.glb();
  for (std::size_t length = 0; length < whole.size(); length += 13) {
    const auto file = folder.write("cut.glb", whole.substr(0, length));
    const auto imported = importGltf(file);
    ASSERT_FALSE(imported.ok()) << length;
    test::expectOneLine(imported.error(), file);
  }
}

/// Random bytes changed, with fixed seeds.
TEST(BadGltfFile, FlippedBytesOfAGlbAreSafe) { test::flipBytes(makePost().file.glb(), "flipped.glb", 500); }
TEST(BadGltfFile, FlippedBytesOfATextFileAreSafe) { test::flipBytes(makePost().file.gltf(), "flipped.gltf", 500); }

/// Changes only numbers in the JSON: damage that passes the parser.
TEST(BadGltfFile, ChangedNumbersAreSafe) {
  const test::TemporaryFolder folder;
  const std::string whole = makePost().file.gltf();
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    std::string damaged = whole;
    const std::size_t data = damaged.find("base64");
    for (int changed = 0; changed < 3;) {
      std::size_t at = random() % damaged.size();
      while (at < damaged.size() && (damaged[at] < '0' || damaged[at] > '9')) ++at;
      if (at >= damaged.size() || (at > data && at < data + whole.find('"', data) - data)) continue;
      const std::array<const char*, 6> others{"0", "1", "-1", "7", "4294967296", "1e17"};
      damaged.replace(at, 1, others[random() % others.size()]);
      ++changed;
    }
    test::expectNoHarm(folder.write("changed.gltf", damaged));
  }
}

TEST(BadGltfFile, FlippedBytesOfRealCharactersAreSafe) {
  const auto file = test::characterFile("greenman.glb");
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const test::TemporaryFolder folder;
  const auto copy = folder.path() / "whole.glb";
  std::filesystem::copy_file(*file, copy);
  std::string whole(std::filesystem::file_size(copy), '\0');
  std::FILE* in = std::fopen(copy.c_str(), "rb");
  ASSERT_NE(in, nullptr);
  ASSERT_EQ(std::fread(whole.data(), 1, whole.size(), in), whole.size());
  std::fclose(in);
  test::flipBytes(whole, "flipped.glb", 60);
}

}  // namespace
}  // namespace sinew
