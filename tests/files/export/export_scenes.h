// tests/files/export/export_scenes.h: characters with muscles to export, and raw access to the result.
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tiny_gltf.h>
#include <glm/geometric.hpp>

#include "core/rig/motion_clip.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/files/skinned_export.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/characters/real_characters.h"

namespace sinew::test {

struct ExportScene {
  std::filesystem::path characterFile;
  std::shared_ptr<const Character> character;  ///< Null: the file is not available.
  Rig rig;

  /// Fits and measures like the command line.
  [[nodiscard]] Result<SkinnedExportReport> write(const std::filesystem::path& file,
                                                  const SkinnedExportSettings& settings = {}) const {
    return exportSkinned(characterFile, character, *withRangeOfMotion(character), rig, settings, file);
  }

  /// First clip only, without range of motion: for tests that need no good weights.
  [[nodiscard]] Result<SkinnedExportReport> writeQuickly(const std::filesystem::path& file,
                                                         SkinnedExportSettings settings = {}) const {
    if (settings.clips.empty()) settings.clips = {character->clips.front().name};
    return exportSkinned(characterFile, character, *character, rig, settings, file);
  }

  /// The live surface at a time of a clip, or in the bind pose.
  [[nodiscard]] Surface live(const AnimationClip* clip, float time) const {
    Smoother smoother(character);
    EXPECT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    smoother.smooth(clip ? samplePose(*character, *clip, time) : bindPose(character->skeleton), surface);
    return surface;
  }
};

/// Played by an independent reader, the exported file stays within the reported error of the live surface in five
/// measured poses of each of its clips; and the reported error has the same magnitude.
inline void expectPlaysAsPrinted(const ExportScene& scene, const std::filesystem::path& file,
                                 const SkinnedExportReport& report) {
  const GltfOracle oracle(file);
  const double height = static_cast<double>(scene.character->height);
  ASSERT_EQ(oracle.clips(), report.clips.size());
  for (std::size_t c = 0; c < oracle.clips(); ++c) {
    const ClipError& printed = report.clips[c];
    const auto found = std::ranges::find(scene.character->clips, printed.clip, &AnimationClip::name);
    ASSERT_NE(found, scene.character->clips.end());
    const AnimationClip& clip = *found;
    double worst = 0.0;
    for (int i = 0; i < 5; ++i) {
      const float time = static_cast<float>(i * static_cast<int>(clip.duration * 30.0f) / 4) / 30.0f;
      const Surface surface = scene.live(&clip, time);
      const auto& triangles = surface.refinement->triangles;
      const auto exported = oracle.triangles(c, static_cast<double>(time));
      ASSERT_EQ(exported.size(), triangles.size());
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::dvec3 point(surface.positions[static_cast<std::size_t>(triangles[t][k])]);
          worst = std::max(worst, 100.0 / height * glm::distance(point, exported[t][k]));
        }
      }
    }
    EXPECT_LE(worst, printed.error.largest + 1e-3) << clip.name;
    EXPECT_GT(worst, 0.02 * printed.error.largest) << clip.name << ": the printed error is of something else";
  }
}

inline ExportScene bundledScene(const std::string& rig) {
  const auto file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (rig + ".rig.json");
  ExportScene scene;
  scene.rig = loadRig(file).value();
  scene.characterFile = characterPath(scene.rig, file);
  scene.character = importGltf(scene.characterFile).value();
  return scene;
}

/// A third-party character with 13 to 16 muscles as laid by the add tool, tests/export/rigs; a fine mesh at depth 2.
inline ExportScene laidScene(const std::string& file) {
  ExportScene scene;
  scene.characterFile = std::filesystem::path(SINEW_CHARACTERS_DIR) / file;
  scene.character = realCharacter(file);
  if (!scene.character) return scene;
  const auto rigs = std::filesystem::path(SINEW_SOURCE_DIR) / "tests" / "export" / "rigs";
  scene.rig = loadRig(rigs / (scene.characterFile.stem().string() + ".rig.json")).value();
  constexpr std::size_t kMany = 2000;  // Triangles: such a mesh needs no refinement.
  if (scene.character->mesh.triangles.size() > kMany) scene.rig.smoothing.depth = 2;
  return scene;
}

/// Names without an extension are bundled rigs, with "-coarse" at depth 1.
inline ExportScene sceneNamed(const std::string& name) {
  if (const auto coarse = name.find("-coarse"); coarse != std::string::npos) {
    ExportScene scene = bundledScene(name.substr(0, coarse));
    scene.rig.smoothing.detail = DetailKind::kUniform;
    scene.rig.smoothing.depth = 1;
    return scene;
  }
  return name.find('.') == std::string::npos ? bundledScene(name) : laidScene(name);
}

/// Parsed by tinygltf alone; images stay encoded.
inline tinygltf::Model rawModel(const std::filesystem::path& file) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return true; },
                        nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const bool binary = file.extension() == ".glb";
  const bool read = binary ? reader.LoadBinaryFromFile(&model, &error, &warning, file.string())
                           : reader.LoadASCIIFromFile(&model, &error, &warning, file.string());
  EXPECT_TRUE(read) << error;
  return model;
}

/// An accessor's raw bytes, tightly packed.
inline std::string rawBytes(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(index));
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  const auto size =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) *
                               tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  const auto stride = static_cast<std::size_t>(accessor.ByteStride(view));
  const auto& data = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
  std::string bytes;
  for (std::size_t i = 0; i < accessor.count; ++i) {
    const auto* from = data.data() + view.byteOffset + accessor.byteOffset + i * stride;
    bytes.append(reinterpret_cast<const char*>(from), size);
  }
  return bytes;
}

template <class Number>
std::vector<Number> rawNumbers(const tinygltf::Model& model, int index) {
  const std::string bytes = rawBytes(model, index);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::copy_n(bytes.data(), bytes.size(), reinterpret_cast<char*>(numbers.data()));
  return numbers;
}

/// For INSTANTIATE_TEST_SUITE_P, where the parameter is what sceneNamed() takes.
inline std::string nameOfScene(const ::testing::TestParamInfo<const char*>& scene) {
  std::string name = scene.param;
  for (char& c : name) c = c == '.' || c == '-' ? '_' : c;
  return name;
}

}  // namespace sinew::test
