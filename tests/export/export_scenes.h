// tests/export/export_scenes.h: characters with muscles to export, and a raw look at what came out.
#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "app/document/motion_clip.h"
#include "sinew/export/skinned_export.h"
#include "sinew/io/gltf_import.h"
#include "sinew/io/rig_json.h"
#include "tests/support/characters/real_characters.h"
#include "tests/tools/laid_muscles.h"

namespace sinew::test {

struct ExportScene {
  std::filesystem::path characterFile;
  std::shared_ptr<const Character> character;  ///< Null: the file is not at hand.
  Rig rig;

  /// Fitted and measured as the command line does it.
  [[nodiscard]] Result<SkinnedExportReport> write(const std::filesystem::path& file,
                                                  const SkinnedExportSettings& settings = {}) const {
    return exportSkinned(characterFile, character, *app::withRangeOfMotion(character), rig, settings, file);
  }

  /// The first clip alone, without the range of motion: where the weights need not be the best.
  [[nodiscard]] Result<SkinnedExportReport> writeQuickly(const std::filesystem::path& file,
                                                         SkinnedExportSettings settings = {}) const {
    if (settings.clips.empty()) settings.clips = {character->clips.front().name};
    return exportSkinned(characterFile, character, *character, rig, settings, file);
  }
};

inline ExportScene bundledScene(const std::string& rig) {
  const auto file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (rig + ".rig.json");
  ExportScene scene;
  scene.rig = loadRig(file).value();
  scene.characterFile = characterPath(scene.rig, file);
  scene.character = importGltf(scene.characterFile).value();
  return scene;
}

/// Muscles laid by the add tool on a character of others; of a fine mesh at depth 2.
inline ExportScene laidScene(const std::string& file) {
  ExportScene scene;
  scene.characterFile = std::filesystem::path(SINEW_CHARACTERS_DIR) / file;
  scene.character = realCharacter(file);
  if (!scene.character) return scene;
  scene.rig = layMuscles(scene.character);
  constexpr std::size_t kMany = 2000;  // Triangles: such a mesh is fine enough as it is.
  if (scene.character->mesh.triangles.size() > kMany) scene.rig.smoothing.depth = 2;
  return scene;
}

/// Names without an ending are bundled rigs.
inline ExportScene sceneNamed(const std::string& name) {
  return name.find('.') == std::string::npos ? bundledScene(name) : laidScene(name);
}

/// By tinygltf alone; images stay encoded.
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

/// An accessor's elements, bytes as they are, tightly packed.
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

}  // namespace sinew::test
