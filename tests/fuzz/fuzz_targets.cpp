// tests/fuzz/fuzz_targets.cpp: import, rigs, sets of muscles, smoothing and export of untrusted bytes.

#include "tests/fuzz/fuzz_targets.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "core/files/clip_files.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/files/skinned_export.h"
#include "sinew/files/surface_export.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/gltf_builder.h"

namespace sinew::fuzz {
namespace {

namespace fs = std::filesystem;

// What a run may cost: larger characters are read and left at that.
constexpr std::size_t kMostTriangles = 400;
constexpr std::size_t kMostBones = 24;
constexpr std::size_t kMostClips = 3;
constexpr float kLongestClip = 2.0f;  ///< Seconds.
constexpr std::size_t kMostMuscles = 6;
constexpr int kDeepest = 3;

void promise(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", what.c_str());
  std::abort();
}

/// A folder in memory where there is one, for as long as the process lives.
const fs::path& folder() {
  static const struct Folder {
    fs::path path = (fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) /
                    ("sinew-fuzz-" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  } own;
  return own.path;
}

fs::path written(std::string_view bytes) {
  fs::path file = folder() / (bytes.starts_with("glTF") ? "input.glb" : "input.gltf");
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

void expectOneLine(const Error& error) {
  const std::string line = error.text();
  promise(!error.reason.empty(), "an error says why");
  promise(line.find('\n') == std::string::npos, "an error is one line: " + line);
  promise(line.size() < 600, "an error is short: " + line);
}

void expectFinite(const Surface& surface) {
  for (const glm::vec3& p : surface.positions) promise(isFinite(p), "positions of a surface are finite");
  for (const glm::vec3& n : surface.normals) promise(isFinite(n), "normals of a surface are finite");
}

/// Null: refused.
std::shared_ptr<const Character> imported(const fs::path& file) {
  Result<std::shared_ptr<const Character>> character = importGltf(file);
  if (!character) {
    expectOneLine(character.error());
    return nullptr;
  }
  for (const glm::vec3& p : character.value()->mesh.positions) promise(isFinite(p), "positions are finite");
  for (const Bone& bone : character.value()->skeleton.bones) {
    promise(isFinite(bone.bindInWorld) && isFinite(bone.inverseBindInWorld), "bones are finite");
  }
  promise(character.value()->height > 0.0f, "the height is positive");
  return std::move(character).value();
}

bool isSmall(const Character& character) {
  bool isShort = character.clips.size() <= kMostClips;
  for (const AnimationClip& clip : character.clips) isShort = isShort && clip.duration <= kLongestClip;
  return isShort && character.mesh.triangles.size() <= kMostTriangles && character.skeleton.bones.size() <= kMostBones;
}

/// Muscles on the first bones, of sizes and places that follow the bytes.
Rig muscled(const Character& character, std::string_view bytes) {
  Rig rig;
  rig.character = "input.glb";
  rig.smoothing.depth = 2;
  rig.groups.push_back({.name = "all", .unknownKeys = {}});
  const std::size_t seed = std::hash<std::string_view>()(bytes);
  rig.surface.mode = seed % 2 ? SurfaceMode::kReplace : SurfaceMode::kSwell;
  rig.smoothing.detail = seed % 4 < 2 ? DetailKind::kUniform : DetailKind::kAdaptive;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, character.skeleton.bones.size()); ++i) {
    const auto share = [&](std::size_t digit) { return static_cast<float>((seed >> (4 * digit + i)) & 15u) / 15.0f; };
    Primitive muscle;
    muscle.name = "muscle " + std::to_string(i);
    muscle.bone = character.skeleton.fileName(static_cast<int>(i));
    muscle.group = "all";
    muscle.placement.center = character.height * glm::vec3(share(1) - 0.5f, share(2), share(3) - 0.5f);
    muscle.placement.radii = character.height * (0.01f + 0.3f * glm::vec3(share(4), share(5), share(6)));
    muscle.sign = share(7) > 0.8f ? -1 : 1;
    rig.primitives.push_back(std::move(muscle));
  }
  return rig;
}

void expectFiniteSurfaces(const std::shared_ptr<const Character>& character, const Rig& rig) {
  Smoother smoother(character);
  if (const Result<void> prepared = smoother.prepare(rig); !prepared) {
    expectOneLine(prepared.error());
    return;
  }
  Surface surface;
  smoother.smooth(bindPose(character->skeleton), surface);
  expectFinite(surface);
  for (const AnimationClip& clip : character->clips) {
    for (const float share : {0.0f, 0.37f, 1.0f}) {
      smoother.smooth(samplePose(*character, clip, share * clip.duration), surface);
      expectFinite(surface);
    }
  }
}

/// The patch of the bind pose, as a file of any kind.
void expectSurfaceFile(const std::shared_ptr<const Character>& character, std::size_t seed) {
  static constexpr std::array kNames{"surface.glb", "surface.obj", "surface.ply"};
  Smoother smoother(character);
  if (!smoother.prepare({})) return;
  Surface surface;
  smoother.smooth(bindPose(character->skeleton), surface);
  const fs::path out = folder() / kNames[(seed >> 8) % kNames.size()];
  if (const Result<void> written = exportSurface(surface, *character, out); !written) expectOneLine(written.error());
}

const std::shared_ptr<const Character>& post() {
  static const std::shared_ptr<const Character> character = [] {
    Result<std::shared_ptr<const Character>> read = importGltf(written(test::makePost().file.glb()));
    promise(read.ok(), "the post is a character");
    return std::move(read).value();
  }();
  return character;
}

}  // namespace

void importAny(std::string_view bytes) {
  const fs::path file = written(bytes);
  const std::shared_ptr<const Character> character = imported(file);
  if (!character || !isSmall(*character)) return;
  Rig rig;
  rig.clipFiles.push_back(file.filename().string());
  const WithClipFiles with = withClipFiles(post(), rig, folder());
  for (const AnimationClip& clip : with.character->clips) {
    for (const glm::mat4& bone : samplePose(*with.character, clip, 0.5f * clip.duration).boneInWorld) {
      promise(isFinite(bone), "added clips are finite");
    }
  }
}

void rigAny(std::string_view bytes) {
  const Result<Rig> rig = rigFromJson(std::string(bytes));
  if (!rig) {
    expectOneLine(rig.error());
    return;
  }
  const std::string text = rigToJson(rig.value());
  const Result<Rig> again = rigFromJson(text);
  promise(again.ok(), "what is written is read: " + text);
  promise(again.value() == rig.value(), "what is read is what was written: " + text);
  if (rig->primitives.size() > kMostMuscles || rig->smoothing.depth > kDeepest) return;
  expectFiniteSurfaces(post(), rig.value());
}

void setAny(std::string_view bytes) {
  const Result<Preset> preset = presetFromJson(std::string(bytes));
  if (!preset) {
    expectOneLine(preset.error());
    return;
  }
  const std::string text = presetToJson(preset.value());
  const Result<Preset> again = presetFromJson(text);
  promise(again.ok(), "what is written is read: " + text);
  promise(presetToJson(again.value()) == text, "what is read is what was written: " + text);
}

void smoothAny(std::string_view bytes) {
  const std::shared_ptr<const Character> character = imported(written(bytes));
  if (character && isSmall(*character)) expectFiniteSurfaces(character, muscled(*character, bytes));
}

void exportAny(std::string_view bytes) {
  const fs::path file = written(bytes);
  const std::shared_ptr<const Character> character = imported(file);
  if (!character || !isSmall(*character)) return;
  const std::size_t seed = std::hash<std::string_view>()(bytes);
  if ((seed >> 16) % 4 == 0) {
    expectSurfaceFile(character, seed);
    return;
  }
  SkinnedExportSettings settings;
  settings.mesh = seed % 3 == 0 ? ExportMesh::kOriginal : ExportMesh::kRefined;
  // Fits take seconds under sanitizers.
  settings.weights = seed % 8 == 0 ? ExportWeights::kRefitted : ExportWeights::kTransferred;
  settings.joints = seed % 32 == 0 ? ExportJoints::kHelpers : ExportJoints::kOwn;
  settings.helpers = 2;
  const fs::path out = folder() / (seed % 7 < 3 ? "output.gltf" : "output.glb");
  const Result<SkinnedExportReport> exported =
      exportSkinned(file, character, *character, muscled(*character, bytes), settings, out);
  if (!exported) {
    expectOneLine(exported.error());
    return;
  }
  const Result<std::shared_ptr<const Character>> again = importGltf(out);
  promise(again.ok(), "an export opens: " + (again.ok() ? "" : again.error().text()));
}

std::span<const Target> allTargets() {
  static constexpr std::array<Target, 5> targets{
      {{"import", importAny}, {"rig", rigAny}, {"set", setAny}, {"smooth", smoothAny}, {"export", exportAny}}};
  return targets;
}

}  // namespace sinew::fuzz
