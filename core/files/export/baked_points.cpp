// core/files/export/baked_points.cpp: the live surface at every frame, in a cache beside an .obj, or in a USD stage.
#include "core/files/export/baked_clip.h"
#include "core/files/export/formats.h"
#include "core/files/export/out_files.h"
#include "core/files/export/point_cache.h"
#include "core/files/export/skinned_file.h"
#include "core/files/export/usd_files.h"
#include "core/files/fit/joint_fit.h"
#include "core/files/fit/live_surfaces.h"
#include "core/files/surface_formats.h"
#include "core/geometry/at.h"
#include "core/geometry/lower_case.h"
#include "sinew/character/character_pose.h"
#include "sinew/surface/smoother.h"

namespace sinew::exporting {
namespace {

constexpr int kMostFrames = 1'000'000;
constexpr double kMostCacheBytes = 4e9;
constexpr double kMostStageBytes = 2e9;
/// Bytes of a point and a normal as text, about.
constexpr double kTextOfVertex = 96.0;

using SharedCharacter = std::shared_ptr<const Character>;

}  // namespace

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

/// Meshes, materials and names are those of a skinned file, which has the vertices in its order.
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
