// core/export/baked_export.cpp: the live surface at every frame of a clip; then targets, or a point cache.
#include "sinew/export/baked_export.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <sstream>
#include <utility>

#include "core/base/at.h"
#include "core/export/fit/joint_fit.h"
#include "core/export/fit/morph_fit.h"
#include "core/export/into_mesh.h"
#include "core/export/morph_targets.h"
#include "core/export/out_files.h"
#include "core/export/point_cache.h"
#include "core/export/skinned_file.h"
#include "core/io/files/atomic_file.h"
#include "core/io/surface_formats.h"
#include "sinew/smoothing/smoother.h"

namespace sinew {
namespace {

using namespace exporting;

/// Of a clip. The search for targets is cubic in it.
constexpr int kMostFrames = 4000;
constexpr int kMostCachedFrames = 1'000'000;
/// Vertices times frames that are held at once: 3 GB.
constexpr std::size_t kMostPoints = 100'000'000;
constexpr double kMostCacheBytes = 4e9;
/// Normals that turn less, about a quarter of a degree, have no entry in a target.
constexpr float kNormalStep = 1.0f / 256.0f;
// Shares of the work.
constexpr double kFitting = 0.3;
constexpr double kGathering = 0.2;
constexpr double kSearching = 0.3;
constexpr double kShading = 0.2;

/// What all kinds need of the clip.
struct Moments {
  Moments(const Character& character, const BakedExportSettings& settings)
      : clip(*std::ranges::find(character.clips, settings.clip, &AnimationClip::name)),
        times(clipTimes(clip, settings.framesPerSecond)) {}

  const AnimationClip& clip;
  std::vector<float> times;  ///< [frames] seconds.
};

std::string percentText(double percent) {
  std::ostringstream text;
  text << percent;
  return text.str();
}

[[noreturn]] void refuse(const BakedExportSettings& settings, const std::string& what) {
  throw gltf::Refusal{
      errorAt("clip \"" + settings.clip + '"', what + "; expected fewer frames a second, or a smaller depth")};
}

/// Before the times are made.
void checkFrames(const Character& character, const BakedExportSettings& settings, int most) {
  const auto clip = std::ranges::find(character.clips, settings.clip, &AnimationClip::name);
  if (static_cast<double>(clip->duration) * settings.framesPerSecond >= most) {
    refuse(settings, "has more than " + std::to_string(most) + " frames");
  }
}

/// Morph targets on the written primitives.
class TargetMaker {
 public:
  TargetMaker(std::shared_ptr<const Character> character, const Rig& rig, const JointFit& fit,
              const BakedExportSettings& settings, const ExportProgress& progress)
      : character_(std::move(character)),
        fit_(fit),
        settings_(settings),
        moments_(*character_, settings),
        progress_(progress),
        smoother_(character_),
        prepared_(smoother_.prepare(rig).ok()) {}  // As it was for the weights.

  /// FinishFile. Throws gltf::Refusal.
  void addTo(GltfRewrite& rewrite, const OutSkins& skins, std::span<const OutPrimitive> primitives,
             BakedExportReport& report) {
    if (primitives.empty() || !prepared_) return;
    MorphFit morphs = gathered(skins, primitives);
    report.frames = static_cast<int>(moments_.times.size());
    report.skinned = morphs.skinnedFigures();
    progress_.begin(kSearching);
    const double height = static_cast<double>(character_->height);
    const auto targets = morphs.solve(settings_.bound / 100.0 * height, progress_);
    if (!targets) {
      throw gltf::Refusal{errorAt("clip \"" + settings_.clip + '"',
                                  "cannot be baked to " + percentText(settings_.bound) +
                                      " % of the height: the joints flatten what is skinned to them, or floats are "
                                      "too coarse; expected a larger bound")};
    }
    report.targets = targets->count;
    report.baked = targets->figures;
    progress_.begin(kShading);
    const std::vector<PrimitiveDeltas> deltas = deltasOf(*targets, skins, primitives);
    addMorphTargets(primitives, deltas, settings_.clip, rewrite);
    addMorphWeights(primitives, moments_.times, targets->weights, settings_.clip, rewrite);
  }

 private:
  /// Calls use(frame) for each, the surface and the matrices at hand.
  template <class Use>
  void forEachFrame(Use use) {
    for (std::size_t frame = 0; frame < moments_.times.size(); ++frame) {
      progress_.tell(static_cast<double>(frame) / static_cast<double>(moments_.times.size()));
      const Pose pose = samplePose(character_->skeleton, moments_.clip, moments_.times[frame]);
      smoother_.smooth(pose, live_);
      bindingMatrices(character_->skeleton, pose, matrices_);
      use(frame);
    }
  }

  /// Each refined vertex once for every node that shows it.
  MorphFit gathered(const OutSkins& skins, std::span<const OutPrimitive> primitives) {
    std::vector<MorphVertex> vertices;
    std::vector<glm::dmat3> spaces;
    std::map<int, int> spaceOf;                   // by node
    std::map<std::pair<int, int>, int> vertexOf;  // by space and refined vertex
    for (const OutPrimitive& primitive : primitives) {
      const glm::dmat4& meshToBind = skins.meshToBind(primitive.node);
      const IntoMesh into(meshToBind);
      const auto [space, isNew] = spaceOf.emplace(primitive.node, static_cast<int>(spaces.size()));
      if (isNew) spaces.emplace_back(meshToBind);
      std::vector<int>& numbers = numbers_.emplace_back();
      for (const int refined : primitive.refined) {
        const auto [place, isFirst] =
            vertexOf.emplace(std::pair(space->second, refined), static_cast<int>(vertices.size()));
        numbers.push_back(place->second);
        if (!isFirst) continue;
        const glm::dvec3 written(into.point(at(fit_.bind().positions, refined)));
        vertices.push_back(
            {refined, space->second, glm::dvec3(meshToBind * glm::dvec4(written, 1.0)), at(fit_.weights(), refined)});
      }
    }
    if (vertices.size() * moments_.times.size() > kMostPoints) {
      refuse(settings_, "needs more than " + std::to_string(kMostPoints) + " vertices in all frames");
    }
    MorphFit morphs(std::move(vertices), std::move(spaces), static_cast<double>(character_->height));
    progress_.begin(kGathering);
    forEachFrame([&](std::size_t) { morphs.add(matrices_, live_.positions); });
    return morphs;
  }

  /// Normals by least squares over the same weights: what, skinned as normals are, comes nearest to the live ones.
  std::vector<PrimitiveDeltas> deltasOf(const MorphTargets& targets, const OutSkins& skins,
                                        std::span<const OutPrimitive> primitives) {
    std::vector<PrimitiveDeltas> result;
    std::vector<IntoMesh> into;
    std::vector<std::vector<glm::vec3>> rest;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      into.emplace_back(skins.meshToBind(primitives[p].node));
      PrimitiveDeltas& own = result.emplace_back();
      own.normals.assign(toIndex(targets.count), std::vector<glm::vec3>(numbers_[p].size(), glm::vec3(0.0f)));
      for (const std::vector<glm::vec3>& all : targets.deltas) {
        std::vector<glm::vec3>& deltas = own.positions.emplace_back();
        for (const int number : numbers_[p]) deltas.push_back(at(all, number));
      }
      std::vector<glm::vec3>& normals = rest.emplace_back();
      for (const int drawn : primitives[p].drawn) {
        normals.push_back(into[p].normal(shadingNormal(fit_.bind(), toIndex(drawn))));
      }
    }
    if (targets.count == 0) return result;
    forEachFrame([&](std::size_t frame) {
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        for (std::size_t v = 0; v < numbers_[p].size(); ++v) {
          const glm::dmat3 blend = blendedMatrix(matrices_, at(fit_.weights(), primitives[p].refined[v]));
          const glm::vec3 live = shadingNormal(live_, toIndex(primitives[p].drawn[v]));
          const glm::vec3 inBind = normalizeOr(glm::vec3(glm::transpose(blend) * glm::dvec3(live)), live);
          const glm::vec3 change = into[p].normal(inBind) - rest[p][v];
          if (glm::length(change) < kNormalStep) continue;
          for (std::size_t k = 0; k < result[p].normals.size(); ++k) {
            result[p].normals[k][v] += static_cast<float>(targets.shares[k * moments_.times.size() + frame]) * change;
          }
        }
      }
    });
    for (PrimitiveDeltas& own : result) {
      for (std::vector<glm::vec3>& normals : own.normals) {
        for (glm::vec3& normal : normals) {
          if (glm::length(normal) < kNormalStep) normal = glm::vec3(0.0f);
        }
      }
    }
    return result;
  }

  std::shared_ptr<const Character> character_;
  const JointFit& fit_;
  const BakedExportSettings& settings_;
  Moments moments_;
  StageProgress progress_;
  Smoother smoother_;
  bool prepared_;
  std::vector<std::vector<int>> numbers_;  ///< [primitives][vertices] of MorphFit's.
  // Of the frame at hand.
  Surface live_;
  std::vector<glm::dmat4> matrices_;
};

Result<BakedExportReport> bakeTargets(Source& source, const std::shared_ptr<const Character>& character, const Rig& rig,
                                      const BakedExportSettings& settings, const std::filesystem::path& file,
                                      const ExportProgress& progress) {
  if (auto free = checkPlaces(source, filesOf(file)); !free) return free.error();
  SkinnedExportSettings skinning;
  skinning.weights = settings.weights;
  skinning.clips = {settings.clip};
  ExportProgress ofFit;
  ExportProgress ofTargets;
  if (progress) {
    ofFit = [&](double share) { return progress(kFitting * share); };
    ofTargets = [&](double share) { return progress(kFitting + share); };
  }
  JointFit fit(character, *character, rig, skinning, ofFit);
  if (auto found = fit.findWeights(); !found) return found.error();
  SkinnedExportReport asSkinned;
  fit.measure(asSkinned);
  BakedExportReport report;
  TargetMaker targets(character, rig, fit, settings, ofTargets);
  SkinnedFile made =
      skinnedFile(source, character->mesh, fit, skinning,
                  [&](GltfRewrite& rewrite, const OutSkins& skins, std::span<const OutPrimitive> primitives) {
                    targets.addTo(rewrite, skins, primitives, report);
                  });
  report.joints = made.joints;
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  report.left = std::move(made.left);
  const Result<std::uint64_t> bytes = writeGltf(made.packed, file);
  if (!bytes) return bytes.error();
  report.bytes = bytes.value();
  return report;
}

Result<BakedExportReport> bakeCache(const Source& source, const std::shared_ptr<const Character>& character,
                                    const Rig& rig, const BakedExportSettings& settings,
                                    const std::filesystem::path& file, const ExportProgress& progress) {
  std::filesystem::path object = file;
  object.replace_extension(".obj");
  if (auto free = checkPlaces(source, {object, file}); !free) return free.error();
  Smoother smoother(character);
  if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
  const Moments moments(*character, settings);
  Surface surface;
  smoother.smooth(samplePose(character->skeleton, moments.clip, moments.times.front()), surface);
  const auto format = lowerEnding(file) == ".pc2" ? PointCache::Format::kPc2 : PointCache::Format::kMdd;
  const auto frames = static_cast<double>(moments.times.size());
  if (surface.refinement->triangles.empty()) {
    return Error{file.string(), {}, "cannot be written: the surface has no triangles"};
  }
  if (PointCache::sizeOf(format, frames, static_cast<double>(surface.positions.size())) > kMostCacheBytes) {
    refuse(settings, "needs a cache larger than 4 GB");
  }
  const ObjFiles first = objFiles(surface, *character, file.stem().string());
  PointCache cache(format, moments.times, surface.positions.size());
  StageProgress stage(progress);
  stage.begin(1.0);
  for (const float time : moments.times) {
    stage.tell(static_cast<double>(&time - moments.times.data()) / frames);
    smoother.smooth(samplePose(character->skeleton, moments.clip, time), surface);
    cache.add(surface.positions);
  }
  std::vector<std::filesystem::path> places;
  std::vector<NamedBytes> files;
  for (const SideFile& side : first.sides) files.push_back({file.parent_path() / side.name, side.bytes});
  files.push_back({object, first.obj});
  files.push_back({file, cache.bytes()});
  BakedExportReport report;
  for (const NamedBytes& each : files) {
    places.push_back(each.file);
    report.bytes += each.bytes.size();
  }
  if (auto free = checkPlaces(source, places); !free) return free.error();
  if (auto written = writeFilesAtomically(files); !written) return written.error();
  report.frames = static_cast<int>(moments.times.size());
  report.vertices = static_cast<std::int64_t>(surface.positions.size());
  report.triangles = static_cast<std::int64_t>(surface.refinement->triangles.size());
  return report;
}

}  // namespace

bool isPointCacheName(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".pc2" || ending == ".mdd";
}

bool isBakedExportName(const std::filesystem::path& file) {
  return isSkinnedExportName(file) || isPointCacheName(file);
}

Result<BakedExportReport> exportBaked(const std::filesystem::path& characterFile,
                                      const std::shared_ptr<const Character>& character, const Rig& rig,
                                      const BakedExportSettings& settings, const std::filesystem::path& file,
                                      const ExportProgress& progress) {
  if (!isBakedExportName(file)) {
    return Error{file.string(), {}, "expected a name that ends in .glb, .gltf, .pc2 or .mdd"};
  }
  if (!(settings.framesPerSecond > 0.0) || !std::isfinite(settings.framesPerSecond)) {
    return errorAt("frames per second", "expected a number above 0");
  }
  if (!(settings.bound >= kLeastBound && settings.bound <= kMostBound)) {
    return errorAt("bound", "expected percent of the height from 0.001 to 100");
  }
  if (auto known = checkClips(characterFile, *character, {settings.clip}); !known) return known.error();
  try {
    checkFrames(*character, settings, isPointCacheName(file) ? kMostCachedFrames : kMostFrames);
    Source source(characterFile);
    return isPointCacheName(file) ? bakeCache(source, character, rig, settings, file, progress)
                                  : bakeTargets(source, character, rig, settings, file, progress);
  } catch (const gltf::Refusal& refusal) {
    return Error{characterFile.string(), refusal.error.place, refusal.error.reason};
  } catch (const Cancelled&) {
    return Error{file.string(), {}, std::string(kCancelled)};
  } catch (const std::bad_alloc&) {
    return Error{characterFile.string(), {}, "there is not enough memory to export it"};
  } catch (const std::exception& error) {
    return Error{characterFile.string(), {}, shortened(error.what())};
  }
}

}  // namespace sinew
