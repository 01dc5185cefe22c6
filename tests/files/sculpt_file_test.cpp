// tests/files/sculpt_file_test.cpp: one cube in every form of .obj, .ply and .glb; damaged files.
#include "core/files/sculpt_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <string>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/weld.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

struct SculptFile : testing::Test {
  test::TemporaryFolder folder;

  [[nodiscard]] Result<ControlMesh> load(const std::string& name, const std::string& bytes) const {
    const auto file = folder.path() / name;
    std::ofstream(file, std::ios::binary) << bytes;
    return loadSculpt(file);
  }
  /// A closed unit cube that faces outwards.
  static void expectCube(const Result<ControlMesh>& mesh) {
    ASSERT_TRUE(mesh.ok()) << mesh.error().text();
    EXPECT_EQ(mesh->positions.size(), 8U);
    EXPECT_EQ(mesh->triangles.size(), 12U);
    EXPECT_TRUE(topologyOf(mesh.value()).closed());
    float volume = 0.0f;
    for (const ControlTriangle& triangle : mesh->triangles) {
      const auto& [a, b, c] = triangle.vertices;
      volume += glm::dot(at(mesh->positions, a), glm::cross(at(mesh->positions, b), at(mesh->positions, c))) / 6.0f;
    }
    EXPECT_NEAR(volume, 1.0f, 1e-5f);
  }
};

constexpr int kCubeFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

std::string cubeObj(bool fromTheEnd, bool withTextures) {
  std::string text = "# a cube\r\no cube\n";
  for (int i = 0; i < 8; ++i) {
    text +=
        "v " + std::to_string(i & 1) + ".0 " + std::to_string(i >> 1 & 1) + " " + std::to_string(i >> 2) + "e0 0.5\n";
  }
  text += "vn 0 0 1\nvt 0 0\n";
  for (const auto& face : kCubeFaces) {
    text += "f";
    for (const int corner : face) {
      text += " " + std::to_string(fromTheEnd ? corner - 8 : corner + 1) + (withTextures ? "/1/1" : "");
    }
    text += "\n";
  }
  return text;
}

/// @param form  of the header
std::string cubePly(const std::string& form) {
  std::string text = "ply\nformat " + form + " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\n" +
                     "property double y\nproperty float z\nproperty uchar red\nelement face 6\n" +
                     "property list uchar int vertex_indices\nproperty short flag\nend_header\n";
  const bool big = form == "binary_big_endian";
  const auto put = [&](std::uint64_t bits, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(bits >> 8 * (big ? size - 1 - i : i) & 0xFFU);
  };
  for (unsigned i = 0; i < 8; ++i) {
    const float x = static_cast<float>(i & 1U);
    const double y = static_cast<double>(i >> 1U & 1U);
    const float z = static_cast<float>(i >> 2U);
    if (form == "ascii") {
      text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + " 255\n";
      continue;
    }
    put(std::bit_cast<std::uint32_t>(x), 4);
    put(std::bit_cast<std::uint64_t>(y), 8);
    put(std::bit_cast<std::uint32_t>(z), 4);
    put(255, 1);
  }
  for (const auto& face : kCubeFaces) {
    if (form == "ascii") text += "4";
    else put(4, 1);
    for (const int corner : face) {
      if (form == "ascii") text += " " + std::to_string(corner);
      else put(static_cast<std::uint32_t>(corner), 4);
    }
    if (form == "ascii") text += " -1\n";
    else put(0xFFFF, 2);
  }
  return text;
}

TEST_F(SculptFile, ReadsACubeInEveryForm) {
  expectCube(load("a.obj", cubeObj(false, false)));
  expectCube(load("b.OBJ", cubeObj(true, true)));
  for (const char* form : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    SCOPED_TRACE(form);
    expectCube(load("a.ply", cubePly(form)));
  }
}

TEST_F(SculptFile, ReadsTheSkinOfACharacter) {
  const auto mesh = loadSculpt(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb");
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_GT(mesh->triangles.size(), 100U);
}

TEST_F(SculptFile, RefusesOnOneLine) {
  const auto refused = [&](const std::string& name, const std::string& bytes) {
    const auto mesh = load(name, bytes);
    EXPECT_FALSE(mesh.ok()) << name;
    if (mesh) return std::string();
    const std::string text = mesh.error().text();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    EXPECT_NE(text.find(name), std::string::npos) << text;
    return text;
  };
  EXPECT_NE(refused("a.txt", "v 0 0 0").find(".ply"), std::string::npos);
  EXPECT_NE(refused("a.obj", "").find("no faces"), std::string::npos);
  EXPECT_NE(refused("b.obj", "v 0 0\n").find("line 1"), std::string::npos);
  EXPECT_NE(refused("c.obj", "v 0 0 nan\n").find("line 1"), std::string::npos);
  EXPECT_NE(refused("d.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n").find("line 3"), std::string::npos);
  EXPECT_NE(refused("e.obj", "v 0 0 0\nf 1 1 -9\n").find("line 2"), std::string::npos);
  EXPECT_NE(refused("f.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\n").find("collapsed"), std::string::npos);
  refused("a.ply", "plo\n");
  refused("b.ply", "ply\nformat wavelet 1.0\nend_header\n");
  refused("c.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n");
  refused("d.ply", "ply\nelement vertex 1\n");
  refused("e.glb", "glTF");
}

TEST_F(SculptFile, NoCutOrChangedByteIsFatal) {
  for (const std::string& whole : {cubePly("binary_little_endian"), cubePly("ascii"), cubeObj(false, true)}) {
    const std::string name = whole.starts_with("ply") ? "a.ply" : "a.obj";
    for (std::size_t at = 0; at < whole.size(); at += 7) {
      (void)load(name, whole.substr(0, at));
      std::string changed = whole;
      changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? 0x80 : 0x15));
      (void)load(name, changed);
    }
  }
}

}  // namespace
}  // namespace sinew
