// tests/files/gltf_quantized_test.cpp: a body in two meshes, each rounded to integers on its own grid, is joined to one
// skin.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/characters/compressed_post.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

enum class Packed { kNo, kMeshopt };

/// Conversion of numbers to integers.
struct Rounding {
  int bits = 14;  ///< Of 16 with the sign; lower bits repeat the higher ones; 0: not normalized.
  Packed packed = Packed::kNo;
};

std::int16_t roundedTo(double value, int bits) {
  if (bits == 0) return static_cast<std::int16_t>(std::lround(4000.0 * value));
  const auto magnitude = static_cast<int>(std::lround(std::abs(value) * (std::exp2(bits - 1) - 1.0)));
  const int whole = magnitude << (16 - bits) | magnitude >> (2 * (bits - 1) - 15);
  return static_cast<std::int16_t>(value < 0.0 ? -whole : whole);
}

/// Adds the triangles of a post below or above its middle, on the grid that fits their vertices, as a mesh with its own
/// skin. Positions are rounded on the grid; the skin's matrices undo its scale.
void addHalf(Post& post, bool above, const Rounding& rounding, double shift) {
  GltfBuilder& file = post.file;
  std::vector<std::uint16_t> kept;
  for (std::size_t i = 0; i < post.indices.size(); i += 3) {
    float middle = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) middle += post.positions[3u * post.indices[i + k] + 1] / 3.0f;
    if ((middle > 1.0f) != above) continue;
    for (std::size_t k = 0; k < 3; ++k) kept.push_back(post.indices[i + k]);
  }
  const double scale = above ? 1.37 : 1.13;
  const std::array<double, 3> origin{0.11, above ? 1.0 + shift : 0.9, -0.07};
  std::vector<std::int16_t> places;
  for (std::size_t i = 0; i < post.positions.size(); ++i) {
    const double onGrid = (static_cast<double>(post.positions[i]) - origin[i % 3]) / scale;
    places.push_back(roundedTo(std::clamp(onGrid, -1.0, 1.0), rounding.bits));
  }
  std::vector<std::uint8_t> weights;
  for (const float weight : post.weights) weights.push_back(static_cast<std::uint8_t>(std::lround(255.0f * weight)));
  const double unit = rounding.bits == 0 ? scale / 4000.0 : scale;
  // The post's matrices (gltf_builder.h), after the grid's.
  std::vector<float> binds;
  for (const double knee : {0.0, 1.0}) {
    for (int column = 0; column < 4; ++column) {
      for (std::size_t row = 0; row < 4; ++row) {
        const double last = row == 3 ? 1.0 : origin[row] - (row == 1 ? knee : 0.0);
        const bool onDiagonal = static_cast<std::size_t>(column) == row && row < 3;
        binds.push_back(static_cast<float>(column == 3 ? last : onDiagonal ? unit : 0.0));
      }
    }
  }
  ordered_json primitive;
  primitive["attributes"]["POSITION"] = file.accessor(places, "VEC3", rounding.bits > 0);
  primitive["attributes"]["JOINTS_0"] = file.accessor(post.joints, "VEC4");
  primitive["attributes"]["WEIGHTS_0"] = file.accessor(weights, "VEC4", true);
  primitive["indices"] = file.accessor(kept, "SCALAR");
  file.json["meshes"].push_back({{"primitives", ordered_json::array({primitive})}});
  file.json["skins"].push_back({{"joints", {1, 2}}, {"inverseBindMatrices", file.accessor(binds, "MAT4")}});
  if (rounding.packed == Packed::kMeshopt) {
    const auto padded = [&] {  // Strides are multiples of 4.
      std::vector<std::int16_t> out;
      for (std::size_t i = 0; i < places.size(); i += 3) {
        out.insert(out.end(), {places[i], places[i + 1], places[i + 2], 0});
      }
      return out;
    }();
    const auto accessor = primitive["attributes"]["POSITION"].get<std::size_t>();
    const int view = file.viewOf(padded);
    file.json["accessors"][accessor]["bufferView"] = view;
    file.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 8;
    useMeshopt(post, view, meshoptAttributes(padded.data(), padded.size() / 4, 8),
               {{"mode", "ATTRIBUTES"}, {"count", padded.size() / 4}, {"byteStride", 8}});
  }
}

/// @param shift  of the upper part's grid
Post twoMeshes(const Rounding& rounding, double shift = 0.0) {
  Post post = makePost();
  for (const char* list : {"meshes", "skins"}) post.file.json[list].clear();
  addHalf(post, false, rounding, shift);
  addHalf(post, true, rounding, shift);
  post.file.json["nodes"].push_back({{"name", "upper"}, {"mesh", 1}, {"skin", 1}});
  post.file.json["scenes"][0]["nodes"].push_back(3);
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    post.file.json[list].push_back("KHR_mesh_quantization");
  return post;
}

struct Borders {
  std::size_t vertices = 0;
  std::ptrdiff_t edges = 0;
};

Borders bordersOf(const std::filesystem::path& file) {
  const auto imported = importGltf(file);
  EXPECT_TRUE(imported.ok()) << (imported.ok() ? "" : imported.error().text());
  if (!imported.ok()) return {};
  const ControlMesh& mesh = imported.value()->mesh;
  return {mesh.positions.size(), std::ranges::count(mesh.edges, 1, &Edge::triangleCount)};
}

class GltfQuantized : public ::testing::TestWithParam<Rounding> {
 protected:
  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(, GltfQuantized,
                         testing::Values(Rounding{14}, Rounding{13}, Rounding{16}, Rounding{0},
                                         Rounding{14, Packed::kMeshopt}, Rounding{0, Packed::kMeshopt}));

TEST_P(GltfQuantized, MeshesOnDifferentGridsStayOneSkin) {
  const Borders whole = bordersOf(folder_.write("whole.glb", makePost().file.glb()));
  ASSERT_EQ(whole.edges, 0);
  for (const double shift : {0.0, 0.0123, 0.04567, 0.0891}) {
    const Borders borders = bordersOf(folder_.write("two.glb", twoMeshes(GetParam(), shift).file.glb()));
    EXPECT_EQ(borders.vertices, whole.vertices) << shift;
    EXPECT_EQ(borders.edges, 0) << shift;
  }
}

TEST_P(GltfQuantized, MeshesBeyondRoundingStaySeparate) {
  // The upper half is shifted up by 0.15 % of the height.
  Post moved = twoMeshes(GetParam());
  for (std::size_t i = 1; i < moved.positions.size(); i += 3) moved.positions[i] += 0.003f;
  moved.file.json["meshes"].erase(1);
  moved.file.json["skins"].erase(1);
  addHalf(moved, true, GetParam(), 0.0);
  EXPECT_EQ(bordersOf(folder_.write("apart.glb", moved.file.glb())).edges, 8);
}

/// On one grid, vertices that coincided still do, and others do not.
TEST(GltfQuantizedOnOneGrid, VerticesOneStepApartAreNotJoined) {
  TemporaryFolder folder;
  Post post = twoMeshes({0});
  ordered_json& file = post.file.json;
  // Both halves on the first one's grid, the second one a step up.
  std::vector<std::int16_t> places;
  const std::array<double, 3> origin{0.11, 0.9, -0.07};
  for (std::size_t i = 0; i < post.positions.size(); ++i) {
    const double onGrid = (static_cast<double>(post.positions[i]) - origin[i % 3]) / 1.13;
    places.push_back(static_cast<std::int16_t>(roundedTo(std::clamp(onGrid, -1.0, 1.0), 0) + (i % 3 == 1 ? 1 : 0)));
  }
  file["meshes"][1]["primitives"][0]["attributes"]["POSITION"] = post.file.accessor(places, "VEC3");
  file["nodes"][3]["skin"] = 0;
  EXPECT_EQ(bordersOf(folder.write("step.glb", post.file.glb())).edges, 8);
}

/// glTF 2.0, 3.11: the least integer stands for -1, as the one above it does.
TEST(GltfQuantizedRange, LeastIntegerIsMinusOne) {
  TemporaryFolder folder;
  const auto lowest = [&](std::int16_t least) {
    Post post = twoMeshes({14});
    std::vector<std::int16_t> places;
    for (const float place : post.positions) places.push_back(place < 0.0f ? least : std::int16_t{16384});
    for (std::size_t mesh : {0U, 1U})
      post.file.json["meshes"][mesh]["primitives"][0]["attributes"]["POSITION"] =
          post.file.accessor(places, "VEC3", true);
    const auto imported = importGltf(folder.write("least.glb", post.file.glb()));
    return imported.ok() ? boundsOf(imported.value()->mesh.positions).low : glm::vec3(0.0f);
  };
  EXPECT_LT(lowest(-32767).x, -0.5f);
  EXPECT_EQ(lowest(-32768), lowest(-32767));
}

}  // namespace
}  // namespace sinew::test
