// tests/files/gltf_meshopt_test.cpp: views compressed by meshoptimizer: valid, damaged, and inconsistent with the file.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "core/files/gltf/unpack.h"
#include "tests/files/no_harm.h"
#include "tests/files/same_triangles.h"
#include "tests/support/characters/compressed_post.h"

namespace sinew::test {
namespace {

using gltf::MeshoptFilter;
using gltf::MeshoptMode;
using nlohmann::ordered_json;

class GltfMeshopt : public ::testing::Test {
 protected:
  void expectShown(const Post& post, double tolerance) const {
    expectShowsWhatThePlainFileShows(folder_.write("post.glb", post.file.glb()),
                                     folder_.write("plain.glb", makePost().file.glb()), tolerance);
  }

  TemporaryFolder folder_;
};

TEST_F(GltfMeshopt, MatchesThePlainFile) {
  expectShown(meshoptPost(false), 1e-6);
  expectShown(meshoptPost(true), 1e-6);
}

TEST_F(GltfMeshopt, GivesTheSameCharacterBitForBit) {
  const auto plain = importGltf(folder_.write("plain.glb", makePost().file.glb()));
  const auto packed = importGltf(folder_.write("packed.glb", meshoptPost(true).file.glb()));
  ASSERT_TRUE(plain.ok() && packed.ok());
  EXPECT_EQ(packed.value()->mesh.positions, plain.value()->mesh.positions);
  EXPECT_EQ(packed.value()->clips.at(0).channels.at(0).values, plain.value()->clips.at(0).channels.at(0).values);
}

TEST_F(GltfMeshopt, FallbackBufferIsNotOpened) {
  Post post = meshoptPost();
  post.file.json["buffers"][1]["uri"] = "for-others.bin";
  expectShown(post, 1e-6);
}

TEST_F(GltfMeshopt, ViewWithoutTheExtensionNeedsItsOwnBytes) {
  Post post = meshoptPost();
  post.file.json["bufferViews"][0].erase("extensions");
  const auto imported = importGltf(folder_.write("post.glb", post.file.glb()));
  ASSERT_FALSE(imported.ok());
  EXPECT_EQ(imported.error().place, "buffers[1]");
}

TEST_F(GltfMeshopt, PositionsMayUseTheExponentialFilter) {
  Post post = makePost();
  std::vector<float> packed(post.positions.size());
  meshopt_encodeFilterExp(packed.data(), 12, 12, 24, post.positions.data());
  useMeshopt(post, viewOfPart(post, "POSITION"), meshoptAttributes(packed.data(), 12, 12),
             {{"mode", "ATTRIBUTES"}, {"filter", "EXPONENTIAL"}, {"count", 12}, {"byteStride", 12}});
  expectShown(post, 1e-6);
}

TEST_F(GltfMeshopt, RotationsMayUseTheQuaternionFilter) {
  Post post = makePost();
  const float half = std::sqrt(0.5f);
  const std::vector<float> turns{0, 0, 0, 1, half, 0, 0, half};
  std::vector<std::int16_t> packed(8);
  meshopt_encodeFilterQuat(packed.data(), 2, 8, 16, turns.data());
  const int accessor = post.file.accessor(std::vector<std::int16_t>(8, 0), "VEC4", true);
  useMeshopt(post, post.file.json["accessors"].back()["bufferView"].get<int>(), meshoptAttributes(packed.data(), 2, 8),
             {{"mode", "ATTRIBUTES"}, {"filter", "QUATERNION"}, {"count", 2}, {"byteStride", 8}});
  post.file.json["animations"][0]["samplers"][0]["output"] = accessor;
  expectShown(post, 1e-3);
}

std::vector<float> randomUnits(std::mt19937& random, std::size_t count) {
  std::normal_distribution<float> normal;
  std::vector<float> result;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec4 unit = glm::normalize(glm::vec4(normal(random), normal(random), normal(random), normal(random)));
    for (int c = 0; c < 4; ++c) result.push_back(unit[c]);
  }
  return result;
}

template <class Number>
std::vector<float> undone(const std::vector<Number>& packed, std::size_t count, MeshoptFilter filter) {
  const std::size_t stride = packed.size() * sizeof(Number) / count;
  const std::string bytes = meshoptAttributes(packed.data(), count, stride);
  const auto decoded = gltf::decodeMeshopt({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                                           {count, stride, MeshoptMode::kAttributes, filter});
  EXPECT_TRUE(decoded.ok()) << decoded.error().text();
  std::vector<Number> numbers(packed.size());
  std::memcpy(numbers.data(), decoded->data(), decoded->size());
  std::vector<float> result;
  const float scale = std::is_same_v<Number, float> ? 1.0f : static_cast<float>(std::numeric_limits<Number>::max());
  for (const Number number : numbers) result.push_back(static_cast<float>(number) / scale);
  return result;
}

/// Any number of elements; the library handles four at once.
TEST(MeshoptView, FiltersRoundTripWithinTheirPrecision) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const std::size_t count = 1 + random() % 40;
    std::vector<float> units = randomUnits(random, count);
    std::vector<std::int16_t> shorts(4 * count);
    meshopt_encodeFilterQuat(shorts.data(), count, 8, 16, units.data());
    const std::vector<float> turns = undone(shorts, count, MeshoptFilter::kQuaternion);
    for (std::size_t i = 0; i < count; ++i) {
      float along = 0.0f;  // A quaternion and its negative are the same rotation.
      for (std::size_t c = 0; c < 4; ++c) along += turns[4 * i + c] * units[4 * i + c];
      EXPECT_NEAR(std::abs(along), 1.0f, 1e-3f);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const float length = std::hypot(units[4 * i], units[4 * i + 1], units[4 * i + 2]);
      for (std::size_t c = 0; c < 3; ++c) units[4 * i + c] /= length;
      units[4 * i + 3] = 1.0f;
    }
    std::vector<std::int8_t> small(4 * count);
    meshopt_encodeFilterOct(small.data(), count, 4, 8, units.data());
    meshopt_encodeFilterOct(shorts.data(), count, 8, 16, units.data());
    const std::vector<float> coarse = undone(small, count, MeshoptFilter::kOctahedral);
    const std::vector<float> fine = undone(shorts, count, MeshoptFilter::kOctahedral);
    std::vector<float> packed(4 * count);
    meshopt_encodeFilterExp(packed.data(), count, 16, 15, units.data());
    const std::vector<float> exponents = undone(packed, count, MeshoptFilter::kExponential);
    for (std::size_t i = 0; i < units.size(); ++i) {
      EXPECT_NEAR(coarse[i], units[i], 0.03f);
      EXPECT_NEAR(fine[i], units[i], 2e-4f);
      EXPECT_NEAR(exponents[i], units[i], 2e-4f);
    }
  }
}

TEST_F(GltfMeshopt, RefusesTruncatedBytes) {
  for (const char* part : {"POSITION", "indices"}) {
    Post whole = meshoptPost();
    const int view = viewOfPart(whole, part);
    const auto size = meshoptOf(whole, view)["byteLength"].get<std::size_t>();
    for (std::size_t length = 0; length < size; ++length) {
      Post cut = whole;
      meshoptOf(cut, view)["byteLength"] = length;
      const auto imported = importGltf(folder_.write("cut.glb", cut.file.glb()));
      ASSERT_FALSE(imported.ok()) << part << ' ' << length;
      EXPECT_NE(imported.error().place.find("EXT_meshopt_compression"), std::string::npos) << imported.error().text();
    }
  }
}

TEST_F(GltfMeshopt, FlippedBytesAreSafe) {
  flipBytes(meshoptPost(false).file.glb(), "flipped.glb", 400);
  flipBytes(meshoptPost(true).file.glb(), "flipped.glb", 400);
}

struct MeshoptTrap {
  const char* name;
  std::function<void(ordered_json& view, ordered_json& compressed)> bend;  ///< Of positions: 36 elements of 4 bytes.
  const char* place;
  const char* reason;
};

void PrintTo(const MeshoptTrap& trap, std::ostream* out) { *out << trap.name; }

class GltfMeshoptTrap : public ::testing::TestWithParam<MeshoptTrap> {};

TEST_P(GltfMeshoptTrap, IsRefusedWithPlaceAndReason) {
  const TemporaryFolder folder;
  Post post = meshoptPost();
  const int view = viewOfPart(post, "POSITION");
  GetParam().bend(post.file.json["bufferViews"][static_cast<std::size_t>(view)], meshoptOf(post, view));
  const auto file = folder.write("trap.glb", post.file.glb());
  const auto imported = importGltf(file);
  ASSERT_FALSE(imported.ok());
  expectOneLine(imported.error(), file);
  EXPECT_NE(imported.error().place.find(GetParam().place), std::string::npos) << imported.error().text();
  EXPECT_NE(imported.error().reason.find(GetParam().reason), std::string::npos) << imported.error().text();
}

constexpr const char* kMeshoptPlace = "bufferViews[0].extensions.EXT_meshopt_compression";

/// Declares the whole view as elements of another kind.
void setMeshopt(ordered_json& view, ordered_json& compressed, std::uint64_t count, std::uint64_t stride,
                const char* mode = "ATTRIBUTES", const char* filter = "NONE") {
  view["byteLength"] = count * stride;
  compressed["count"] = count;
  compressed["byteStride"] = stride;
  compressed["mode"] = mode;
  compressed["filter"] = filter;
}

INSTANTIATE_TEST_SUITE_P(
    Counts, GltfMeshoptTrap,
    testing::Values(
        MeshoptTrap{"one element more", [](auto&, auto& c) { c["count"] = 37; }, kMeshoptPlace,
                    "37 elements of 4 bytes; the view has 144"},
        MeshoptTrap{"a longer view", [](auto& v, auto&) { v["byteLength"] = 148; }, kMeshoptPlace,
                    "36 elements of 4 bytes; the view has 148"},
        MeshoptTrap{"no stride", [](auto&, auto& c) { c["byteStride"] = 0; }, kMeshoptPlace, "of 0 bytes"},
        MeshoptTrap{"an odd stride", [](auto& v, auto& c) { setMeshopt(v, c, 48, 3); }, kMeshoptPlace, "multiple of 4"},
        MeshoptTrap{"a wide stride", [](auto& v, auto& c) { setMeshopt(v, c, 1, 260); }, kMeshoptPlace,
                    "multiple of 4"},
        MeshoptTrap{"other elements", [](auto& v, auto& c) { setMeshopt(v, c, 72, 4); }, kMeshoptPlace, "damaged"},
        MeshoptTrap{"nothing", [](auto& v, auto& c) { setMeshopt(v, c, 0, 4); }, kMeshoptPlace, "no elements"},
        MeshoptTrap{"half a gigabyte", [](auto& v, auto& c) { setMeshopt(v, c, 1ULL << 27U, 4); }, kMeshoptPlace,
                    "cannot hold 134217728 elements"},
        MeshoptTrap{"terabytes", [](auto& v, auto& c) { setMeshopt(v, c, 1ULL << 40U, 4); }, kMeshoptPlace,
                    "more than 1 GiB"},
        MeshoptTrap{"more than numbers hold", [](auto&, auto& c) { c["count"] = 1e18; }, kMeshoptPlace, "whole number"},
        MeshoptTrap{"triangles and a corner", [](auto& v, auto& c) { setMeshopt(v, c, 37, 4, "TRIANGLES"); },
                    kMeshoptPlace, "multiple of 3"},
        MeshoptTrap{"indices of 8 bytes", [](auto& v, auto& c) { setMeshopt(v, c, 36, 8, "INDICES"); }, kMeshoptPlace,
                    "2 or 4 bytes"}));

INSTANTIATE_TEST_SUITE_P(
    Json, GltfMeshoptTrap,
    testing::Values(
        MeshoptTrap{"no object", [](auto&, auto& c) { c = "yes"; }, kMeshoptPlace, "missing"},
        MeshoptTrap{"no such buffer", [](auto&, auto& c) { c["buffer"] = 7; }, kMeshoptPlace, "no element 7"},
        MeshoptTrap{"a buffer without bytes", [](auto&, auto& c) { c["buffer"] = 1; }, "buffers[1]", "no bytes"},
        MeshoptTrap{"beyond the buffer", [](auto&, auto& c) { c["byteOffset"] = 1 << 20; }, kMeshoptPlace,
                    "reach beyond"},
        MeshoptTrap{"longer than the buffer", [](auto&, auto& c) { c["byteLength"] = 1 << 20; }, kMeshoptPlace,
                    "reach beyond"},
        MeshoptTrap{"an unknown mode", [](auto&, auto& c) { c["mode"] = "POINTS"; }, kMeshoptPlace, "unknown"},
        MeshoptTrap{"no mode", [](auto&, auto& c) { c.erase("mode"); }, kMeshoptPlace, "unknown"},
        MeshoptTrap{"an unknown filter", [](auto&, auto& c) { c["filter"] = "COLOR"; }, kMeshoptPlace, "unknown"},
        MeshoptTrap{"another mode", [](auto& v, auto& c) { setMeshopt(v, c, 36, 4, "INDICES"); }, kMeshoptPlace,
                    "damaged"},
        MeshoptTrap{"filtered indices", [](auto& v, auto& c) { setMeshopt(v, c, 36, 4, "INDICES", "EXPONENTIAL"); },
                    kMeshoptPlace, "no filter"},
        MeshoptTrap{"normals of 12 bytes",
                    [](auto& v, auto& c) { setMeshopt(v, c, 12, 12, "ATTRIBUTES", "OCTAHEDRAL"); }, kMeshoptPlace,
                    "4 or 8 bytes"},
        MeshoptTrap{"turns of 4 bytes", [](auto& v, auto& c) { setMeshopt(v, c, 36, 4, "ATTRIBUTES", "QUATERNION"); },
                    kMeshoptPlace, "for 8 bytes"}));

TEST_F(GltfMeshopt, IndicesBeyondTheVerticesAreRefused) {
  Post post = makePost();
  std::vector<std::uint32_t> corners(post.indices.begin(), post.indices.end());
  corners[7] = 12;
  for (const char* mode : {"TRIANGLES", "INDICES"}) {
    Post bent = post;
    useMeshopt(bent, viewOfPart(bent, "indices"),
               std::string(mode) == "INDICES" ? meshoptIndices(corners) : meshoptTriangles(corners),
               {{"mode", mode}, {"count", corners.size()}, {"byteStride", 2}});
    const auto imported = importGltf(folder_.write("bent.glb", bent.file.glb()));
    ASSERT_FALSE(imported.ok());
    EXPECT_NE(imported.error().reason.find("index 12; the primitive has 12 vertices"), std::string::npos)
        << imported.error().text();
  }
}

/// Views that share the same bytes must not multiply them without limit.
TEST_F(GltfMeshopt, ManyViewsOfTheSameBytesAreCountedTogether) {
  Post post = meshoptPost();
  const std::vector<float> zeros(1 << 20, 0.0f);
  const std::string bytes = meshoptAttributes(zeros.data(), zeros.size() / 4, 16);
  const int first = post.file.view("room");
  useMeshopt(post, first, bytes, {{"mode", "ATTRIBUTES"}, {"count", zeros.size() / 4}, {"byteStride", 16}});
  const ordered_json view = post.file.json["bufferViews"][static_cast<std::size_t>(first)];
  for (int i = 0; i < 260; ++i) post.file.json["bufferViews"].push_back(view);  // 4 MiB each.
  const auto imported = importGltf(folder_.write("bomb.glb", post.file.glb()));
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().reason.find("more than 1 GiB together"), std::string::npos) << imported.error().text();
}

}  // namespace
}  // namespace sinew::test
