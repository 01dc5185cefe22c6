// core/files/export/baked_points.cpp: the live surface at every frame, in a cache with an .obj or in a USD stage.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/files/export/formats.h"
#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/morph_targets.h"
#include "core/files/export/skinned_file.h"
#include "core/files/export/source.h"
#include "core/files/fit/joint_fit.h"
#include "core/files/fit/poses.h"
#include "core/files/surface_formats.h"
#include "core/files/usd/stage.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "sinew/character/character_pose.h"
#include "sinew/surface/smoother.h"

namespace sinew::exporting {
namespace {

// USD: the finished glTF, read again from memory.

Result<usd::Stage> stageOf(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                           const usd::PointMoments* moments) {
  const Result<std::string> bytes = glbOf(packed);
  if (!bytes) return Error{file.string(), {}, bytes.error().reason};
  // Uris of unread images are relative to the source's folder.
  gltf::File again({bytes->begin(), bytes->end()}, gltf::folderOf(source.path));
  const std::string stem = file.stem().string();
  return moments ? usd::pointStage(again, packed.root, stem, *moments) : usd::skinnedStage(again, packed.root, stem);
}

/// Writes the .usda and its textures, all or none. Returns their bytes. Throws gltf::Refusal.
/// @param left  receives what .usda cannot hold  @param moments  points over time instead of a skeleton; null: skinned
Result<std::uint64_t> writeStage(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                                 std::vector<std::string>& left, const usd::PointMoments* moments) {
  auto stage = stageOf(source, packed, file, moments);
  if (!stage) return stage.error();
  left.insert(left.end(), stage->left.begin(), stage->left.end());
  std::vector<NamedBytes> files;
  for (const SideFile& texture : stage->textures) {
    files.push_back({file.parent_path() / texture.name, texture.bytes});
  }
  files.push_back({file, stage->text});
  return writeFiles(source, files);
}

// Point caches: PC2 is little endian, MDD big endian.

constexpr std::string_view kMagic("POINTCACHE2\0", 12);
constexpr std::int32_t kCacheVersion = 1;
constexpr double kPc2Header = 32;
constexpr double kMddHeader = 8;

/// Builds a cache frame by frame. Every frame has the same number of points.
class PointCache {
 public:
  enum class Format { kPc2, kMdd };

  /// @param times  [frames] seconds  @param points  in each frame
  PointCache(Format format, std::span<const float> times, std::size_t points) : format_(format) {
    const auto frames = static_cast<double>(times.size());
    bytes_.reserve(static_cast<std::size_t>(sizeOf(format, frames, static_cast<double>(points))));
    const auto count = static_cast<std::int32_t>(points);
    const auto samples = static_cast<std::int32_t>(times.size());
    if (format == Format::kPc2) {
      bytes_ = kMagic;
      append(kCacheVersion);
      append(count);
      append(0.0f);  // first frame
      append(1.0f);  // frames per sample
      append(samples);
    } else {
      append(samples);
      append(count);
      for (const float time : times) append(time);
    }
  }

  /// Bytes of a whole file.
  [[nodiscard]] static double sizeOf(Format format, double frames, double points) {
    const double header = format == Format::kPc2 ? kPc2Header : kMddHeader + 4 * frames;
    return header + frames * points * static_cast<double>(sizeof(glm::vec3));
  }

  void add(std::span<const glm::vec3> points) {
    for (const glm::vec3& point : points) {
      for (int axis = 0; axis < 3; ++axis) append(point[axis]);
    }
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  void append(Number number) {
    static_assert(std::endian::native == std::endian::little);
    auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (format_ == Format::kMdd) std::ranges::reverse(bytes);
    bytes_.append(bytes.data(), bytes.size());
  }

  Format format_;
  std::string bytes_;
};

constexpr int kMostFrames = 1'000'000;
constexpr double kMostCacheBytes = 4e9;
constexpr double kMostStageBytes = 2e9;
constexpr double kTextOfVertex = 96.0;  ///< Approximate bytes of a point and a normal as text.

using SharedCharacter = std::shared_ptr<const Character>;

}  // namespace

Result<std::uint64_t> writeUsd(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                               std::vector<std::string>& left) {
  return writeStage(source, packed, file, left, nullptr);
}

Result<BakedExportReport> bakeCache(Source& source, const SharedCharacter& character, const Rig& rig,
                                    const BakedExportSettings& settings, const std::filesystem::path& file,
                                    const ExportProgress& progress) {
  requireFrames(*character, settings, kMostFrames);
  LiveSurfaces surfaces(character);
  if (const auto prepared = surfaces.prepare(rig); !prepared) return prepared.error();
  const BakedClip moments(*character, settings);
  const auto poseOf = [&](std::size_t frame) { return samplePose(*character, moments.clip, moments.times[frame]); };
  Surface surface;
  surfaces.smooth(poseOf(0), surface);
  const auto format = lowerEnding(file) == ".pc2" ? PointCache::Format::kPc2 : PointCache::Format::kMdd;
  const auto frames = static_cast<double>(moments.times.size());
  if (surface.refinement->triangles.empty()) {
    return Error{file.string(), {}, "cannot be written: the surface has no triangles"};
  }
  if (PointCache::sizeOf(format, frames, static_cast<double>(surface.positions.size())) > kMostCacheBytes) {
    refuseClip(settings, "needs a cache larger than 4 GB");
  }
  const ObjFiles first = objFiles(surface, *character, file.stem().string());
  PointCache cache(format, moments.times, surface.positions.size());
  StageProgress stage(progress);
  stage.begin(1.0);
  surfaces.forEach(moments.times.size(), poseOf, [&](std::size_t frame, const Pose&, const Surface& live) {
    stage.tell(static_cast<double>(frame) / frames);
    cache.add(live.positions);
  });
  std::vector<NamedBytes> files;
  for (const SideFile& side : first.sides) files.push_back({file.parent_path() / side.name, side.bytes});
  std::filesystem::path object = file;
  files.push_back({object.replace_extension(".obj"), first.obj});
  files.push_back({file, cache.bytes()});
  const Result<std::uint64_t> bytes = writeFiles(source, files);
  if (!bytes) return bytes.error();
  BakedExportReport report;
  report.bytes = bytes.value();
  report.frames = static_cast<int>(moments.times.size());
  report.vertices = static_cast<std::int64_t>(surface.positions.size());
  report.triangles = static_cast<std::int64_t>(surface.refinement->triangles.size());
  return report;
}

/// Takes meshes, materials and names from a skinned file with the same vertices.
Result<BakedExportReport> bakeStage(Source& source, const SharedCharacter& character, const Rig& rig,
                                    const BakedExportSettings& settings, const std::filesystem::path& file,
                                    const ExportProgress& progress) {
  requireFrames(*character, settings, kMostFrames);
  const SkinnedExportSettings skinning{
      .weights = ExportWeights::kTransferred, .clips = {settings.clip}, .morphs = false};
  JointFit fit(character, *character, rig, skinning, {});
  if (auto found = fit.findWeights(); !found) return found.error();
  std::vector<OutPrimitive> primitives;
  SkinnedFile made = skinnedFile(source, *character, fit, skinning,
                                 [&](GltfRewrite&, const OutSkins&, std::span<const OutPrimitive> written) {
                                   primitives.assign(written.begin(), written.end());
                                 });
  const BakedClip moments(*character, settings);
  const auto frames = static_cast<double>(moments.times.size());
  if (kTextOfVertex * frames * static_cast<double>(made.vertices) > kMostStageBytes) {
    refuseClip(settings, "needs a .usda larger than 2 GB");
  }
  Smoother smoother(character);
  if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
  StageProgress stage(progress);
  stage.begin(1.0);
  Surface surface;
  usd::PointMoments points;
  points.framesPerSecond = settings.framesPerSecond;
  points.frames = moments.frames;
  points.at = [&](std::size_t frame, std::vector<usd::MeshPoints>& meshes) {
    stage.tell(static_cast<double>(frame) / frames);
    const Pose pose = samplePose(*character, moments.clip, moments.times[frame]);
    smoother.smooth(pose, surface);
    requireFinite(*character, pose, surface);
    meshes.resize(primitives.size());
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      meshes[p] = {};
      for (const int refined : primitives[p].refined) meshes[p].points.push_back(at(surface.positions, refined));
      for (const int drawn : primitives[p].drawn) meshes[p].normals.push_back(shadingNormal(surface, toIndex(drawn)));
    }
  };
  BakedExportReport report;
  report.left = std::move(made.left);
  const Result<std::uint64_t> bytes = writeStage(source, made.packed, file, report.left, &points);
  if (!bytes) return bytes.error();
  report.bytes = bytes.value();
  report.frames = static_cast<int>(moments.times.size());
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  return report;
}

}  // namespace sinew::exporting
