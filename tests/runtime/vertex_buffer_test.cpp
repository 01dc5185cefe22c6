// tests/runtime/vertex_buffer_test.cpp: a surface in a game's buffers, byte for byte.

#include "sinew/runtime/vertex_buffer.h"

#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>
#include <glm/gtc/packing.hpp>

#include "core/geometry/at.h"
#include "sinew/surface/smoother.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

struct Scene {
  std::shared_ptr<const Character> character;
  Surface surface;
};

/// Surface in the middle of its first clip. @param crease  degrees
Scene smoothed(const std::string& name, float crease = 180.0f) {
  const TrialScene scene = bundledTrialScene(name);
  Rig rig = scene.rig;
  rig.smoothing.creaseAngle = crease;
  Smoother smoother(scene.character);
  EXPECT_TRUE(smoother.prepare(rig).ok());
  Scene made{scene.character, {}};
  EXPECT_TRUE(smoother.smooth(spreadPoses(*scene.character, 2).back(), made.surface));
  return made;
}

template <class T>
T read(const std::vector<std::byte>& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

TEST(VertexBuffer, HoldsTheSurfaceBitForBitAndKeepsOtherBytes) {
  for (const float crease : {180.0f, 30.0f}) {
    const Scene scene = smoothed("humanoid", crease);
    ASSERT_EQ(scene.surface.shadingNormals.empty(), crease == 180.0f);
    for (const BufferVertices vertices : {BufferVertices::kDrawn, BufferVertices::kRefined}) {
      VertexLayout layout;
      layout.stride = 41;  // Odd: nothing is aligned.
      layout.position = 3;
      layout.normal = 20;
      layout.vertices = vertices;
      const std::size_t count = vertexCount(*scene.surface.refinement, vertices);
      std::vector<std::byte> bytes(count * layout.stride + 5, std::byte{0xa5});
      ASSERT_TRUE(writeVertices(scene.surface, layout, bytes).ok());
      for (std::size_t i = 0; i < count; ++i) {
        const bool drawn = vertices == BufferVertices::kDrawn;
        const std::size_t refined = drawn ? toIndex(scene.surface.refinement->drawVertex[i]) : i;
        const std::size_t at = i * layout.stride;
        ASSERT_EQ(read<glm::vec3>(bytes, at + 3), scene.surface.positions[refined]);
        ASSERT_EQ(read<glm::vec3>(bytes, at + 20),
                  drawn ? shadingNormal(scene.surface, i) : scene.surface.normals[refined]);
        for (std::size_t k = 0; k < layout.stride; ++k) {
          const bool member = (k >= 3 && k < 15) || (k >= 20 && k < 32);
          ASSERT_TRUE(member || bytes[at + k] == std::byte{0xa5}) << k;
        }
      }
      EXPECT_EQ(bytes.back(), std::byte{0xa5});
    }
  }
}

TEST(VertexBuffer, HalvesAndTenBitsRoundCorrectly) {
  const Scene scene = smoothed("horse");
  VertexLayout layout{.stride = 12,
                      .position = 0,
                      .normal = 8,
                      .positions = PositionFormat::kHalf,
                      .normals = NormalFormat::kSnorm10,
                      .origin = scene.surface.positions.front()};
  const std::size_t count = vertexCount(*scene.surface.refinement, layout.vertices);
  std::vector<std::byte> bytes(count * layout.stride);
  ASSERT_TRUE(writeVertices(scene.surface, layout, bytes).ok());
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 wanted = scene.surface.positions[toIndex(scene.surface.refinement->drawVertex[i])] - layout.origin;
    const glm::vec4 half = glm::unpackHalf4x16(read<std::uint64_t>(bytes, 12 * i));
    EXPECT_EQ(half.w, 1.0f);
    ASSERT_LE(glm::distance(glm::vec3(half), wanted), 1e-3f * glm::length(wanted) + 1e-4f);
    const glm::vec4 normal = glm::unpackSnorm3x10_1x2(read<std::uint32_t>(bytes, 12 * i + 8));
    ASSERT_LE(glm::distance(glm::vec3(normal), shadingNormal(scene.surface, i)), 0.002f);
  }
}

TEST(VertexBuffer, HasTextureCoordinatesOfDrawnVertices) {
  const Scene scene = smoothed("demo");
  const Refinement& refinement = *scene.surface.refinement;
  std::vector<std::byte> bytes(refinement.drawVertex.size() * 32, std::byte{1});
  ASSERT_TRUE(writeUvs(refinement, 32, 24, bytes).ok());
  for (std::size_t i = 0; i < refinement.drawUv.size(); ++i) {
    ASSERT_EQ(read<glm::vec2>(bytes, 32 * i + 24), refinement.drawUv[i]);
    ASSERT_EQ(bytes[32 * i + 23], std::byte{1});
  }
}

TEST(VertexBuffer, IndicesAreGroupedByMaterial) {
  Scene scene = smoothed("demo");
  Character several = *scene.character;  // Three materials, alternating.
  for (std::size_t t = 0; t < several.mesh.triangles.size(); ++t) {
    several.mesh.triangles[t].material = static_cast<int>(t % 3) * 2;
  }
  const Refinement& refinement = *scene.surface.refinement;
  for (const BufferVertices vertices : {BufferVertices::kDrawn, BufferVertices::kRefined}) {
    std::vector<std::uint32_t> indices(indexCount(refinement));
    ASSERT_TRUE(writeIndices(refinement, several.mesh, vertices, indices).ok());
    std::vector<std::uint16_t> shorts(indices.size());
    ASSERT_TRUE(writeIndices(refinement, several.mesh, vertices, shorts).ok());
    EXPECT_TRUE(std::ranges::equal(indices, shorts));
    const auto ranges = indexRanges(refinement, several.mesh);
    ASSERT_EQ(ranges.size(), 3U);
    std::size_t next = 0;
    for (const IndexRange& range : ranges) {
      EXPECT_EQ(range.first, next);
      std::size_t place = range.first;
      for (std::size_t t = 0; t < refinement.controlOf.size(); ++t) {
        if (at(several.mesh.triangles, refinement.controlOf[t]).material != range.material) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          ASSERT_EQ(indices[place++], vertices == BufferVertices::kDrawn
                                          ? refinement.drawTriangles[t][i]
                                          : static_cast<std::uint32_t>(refinement.triangles[t][i]));
        }
      }
      next += range.count;
      EXPECT_EQ(place, next);
    }
    EXPECT_EQ(next, indices.size());
  }
}

TEST(VertexBuffer, RefusesBuffersThatDoNotFit) {
  const Scene scene = smoothed("demo");
  const Refinement& refinement = *scene.surface.refinement;
  const std::size_t count = vertexCount(refinement, BufferVertices::kDrawn);
  std::vector<std::byte> bytes(24 * count, std::byte{3});
  const auto refused = [&](VertexLayout layout, std::size_t size, const char* words) {
    const auto written = writeVertices(scene.surface, layout, std::span(bytes).first(size));
    ASSERT_FALSE(written.ok()) << words;
    EXPECT_NE(written.error().text().find(words), std::string::npos) << written.error().text();
    EXPECT_TRUE(std::ranges::all_of(bytes, [](std::byte b) { return b == std::byte{3}; }));
  };
  refused({}, bytes.size() - 1, "expected");
  refused({.stride = 0}, bytes.size(), "vertices of 0 bytes");
  refused({.normal = 13}, bytes.size(), "normal: byte 13");
  refused({.position = -2}, bytes.size(), "position: byte -2");
  EXPECT_TRUE(writeVertices(scene.surface, {.normal = -1}, bytes).ok());
  EXPECT_FALSE(writeVertices(Surface(), {}, bytes).ok());
  std::vector<std::uint32_t> few(indexCount(refinement) - 1);
  EXPECT_FALSE(writeIndices(refinement, scene.character->mesh, BufferVertices::kDrawn, few).ok());
  EXPECT_FALSE(writeUvs(refinement, 8, 1, bytes).ok());
}

TEST(VertexBuffer, SixteenBitIndicesAreRefusedForLargeMeshes) {
  const TrialScene scene = bundledTrialScene("humanoid");
  const Refinement refinement = refine(scene.character->mesh, 15);
  ASSERT_GT(refinement.drawVertex.size(), 65535U);
  std::vector<std::uint16_t> shorts(indexCount(refinement));
  const auto written = writeIndices(refinement, scene.character->mesh, BufferVertices::kDrawn, shorts);
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().text().find("16 bits"), std::string::npos) << written.error().text();
}

TEST(VertexBuffer, SixteenBitsEndBelowTheRestartIndex) {
  Refinement refinement;
  std::vector<std::uint16_t> none;
  for (const std::size_t count : {65534U, 65535U, 65536U}) {
    refinement.drawVertex.assign(count, 0);
    EXPECT_EQ(writeIndices(refinement, ControlMesh(), BufferVertices::kDrawn, std::span(none)).ok(), count <= 65535U)
        << count;
  }
}

}  // namespace
}  // namespace sinew::test
