// core/files/export/baked_targets.cpp: weights for the clip, then morph targets for the residual.
#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "core/files/export/formats.h"
#include "core/files/export/morph_targets.h"
#include "core/files/export/out_primitive.h"
#include "core/files/export/skinned_file.h"
#include "core/files/export/source.h"
#include "core/files/fit/joint_fit.h"
#include "core/files/fit/morph_fit.h"
#include "core/files/fit/played_surface.h"
#include "core/files/fit/poses.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "sinew/character/character_pose.h"

namespace sinew::exporting {
namespace {

constexpr int kMostTargetFrames = 4000;           ///< Frames of a clip. The search for targets is cubic in them.
constexpr std::size_t kMostPoints = 100'000'000;  ///< Vertices times frames in memory: 3 GB.
/// Smaller changes of normals, about a quarter of a degree, have no entry in a target.
constexpr float kNormalStep = 1.0f / 256.0f;
constexpr std::size_t kLeastTargetRange = 1024;  ///< Vertices per thread, at least.
// Fractions of the work.
constexpr double kFitting = 0.3;
constexpr double kGathering = 0.2;
constexpr double kSearching = 0.3;
constexpr double kShading = 0.1;
constexpr double kMeasuring = 0.1;

std::string percentText(double percent) {
  std::ostringstream text;
  text << percent;
  return text.str();
}

struct PrimitiveDeltas {
  std::vector<std::vector<glm::vec3>> positions;  ///< [targets][vertices]
  std::vector<std::vector<glm::vec3>> normals;    ///< [targets][vertices]
};

class TargetMaker {
 public:
  TargetMaker(std::shared_ptr<const Character> character, const Rig& rig, const JointFit& fit,
              const BakedExportSettings& settings, const ExportProgress& progress)
      : character_(std::move(character)),
        fit_(fit),
        settings_(settings),
        moments_(*character_, settings),
        progress_(progress),
        surfaces_(character_),
        prepared_(surfaces_.prepare(rig).ok()) {}

  /// A FinishFile. Throws gltf::Refusal.
  void addTo(GltfRewrite& rewrite, const OutSkins& skins, std::span<const OutPrimitive> primitives,
             BakedExportReport& report) {
    if (primitives.empty() || !prepared_) return;
    MorphFit morphs = gatherVertices(skins, primitives);
    report.frames = static_cast<int>(moments_.times.size());
    report.skinned = placed(morphs.skinnedFigures());
    progress_.begin(kSearching);
    const double height = static_cast<double>(character_->height);
    if (morphs.coarseness() >= settings_.bound / 100.0 * height) {
      throw gltf::Refusal{errorAt("clip \"" + settings_.clip + '"',
                                  "cannot be baked to " + percentText(settings_.bound) +
                                      " % of the height: the character goes so far from the origin that floats hold "
                                      "its places to " +
                                      percentText(100.0 * morphs.coarseness() / height) +
                                      " % only; expected a larger bound, or a character nearer to the origin")};
    }
    const auto targets = morphs.solve(settings_.bound / 100.0 * height, progress_);
    if (!targets) {
      throw gltf::Refusal{errorAt("clip \"" + settings_.clip + '"',
                                  "cannot be baked to " + percentText(settings_.bound) +
                                      " % of the height: the joints flatten what is skinned to them, or floats are "
                                      "too coarse; expected a larger bound")};
    }
    report.targets = targets->count;
    report.baked = placed(targets->figures);
    progress_.begin(kMeasuring);
    measureBetween(playedTargets(*targets), report);
    progress_.begin(kShading);
    const std::vector<PrimitiveDeltas> deltas = deltasOf(*targets, skins, primitives);
    MeshTargets mesh;
    for (int k = 1; k <= targets->count; ++k) mesh.names.push_back(settings_.clip + ' ' + std::to_string(k));
    mesh.weights.assign(mesh.names.size(), 0.0f);
    mesh.deltas = [&](std::size_t p, std::size_t k) {
      return TargetDeltas{deltas[p].positions[k], deltas[p].normals[k]};
    };
    for (const int node : nodesOf(primitives)) addMorphTargets(node, primitives, mesh, rewrite);
    addMorphWeights(nodesOf(primitives), moments_.times, targets->weights, settings_.clip, rewrite);
  }

 private:
  /// Calls use(frame, live surface) for each, with matrices_ set.
  template <class Use>
  void forEachFrame(Use use) {
    const std::size_t count = moments_.times.size();
    const auto poseOf = [&](std::size_t frame) {
      return samplePose(*character_, moments_.clip, moments_.times[frame]);
    };
    surfaces_.forEach(count, poseOf, [&](std::size_t frame, const Pose& pose, const Surface& live) {
      progress_.tell(static_cast<double>(frame) / static_cast<double>(count));
      bindingMatrices(character_->skeleton, pose, matrices_);
      use(frame, live);
    });
  }

  /// Figures with times instead of frames, and with names.
  [[nodiscard]] ErrorFigures placed(ErrorFigures figures) const {
    if (figures.farthest.vertex < 0) return figures;
    figures.farthest.clip = settings_.clip;
    figures.farthest.time = moments_.times[static_cast<std::size_t>(figures.farthest.time)];
    figures.farthest.bone = fit_.played()->boneOf(figures.farthest.vertex);
    return figures;
  }

  /// Targets of the refined vertices; the file has them by node and split.
  [[nodiscard]] PlayedTargets playedTargets(const MorphTargets& targets) const {
    PlayedTargets played{settings_.clip, moments_.times, targets.weights, {}};
    for (const std::vector<glm::vec3>& all : targets.deltas) {
      std::vector<glm::vec3>& own =
          played.deltas.emplace_back(std::vector<glm::vec3>(fit_.weights().size(), glm::vec3(0.0f)));
      for (std::size_t v = 0; v < all.size(); ++v) {
        own[toIndex(refined_[v])] = glm::vec3(spaces_[toIndex(spaceOf_[v])] * glm::dvec3(all[v]));
      }
    }
    return played;
  }

  /// Measures the clip between its samples, as a program blends the targets.
  void measureBetween(PlayedTargets targets, BakedExportReport& report) {
    const auto played = std::make_shared<PlayedSurface>(*fit_.played());
    played->targets = std::move(targets);
    const std::vector<float> times = timesBetween(moments_.clip, momentsPerSecond(settings_));
    // Compare only vertices that a primitive shows.
    std::vector<bool> isShown(fit_.weights().size(), false);
    for (const int refined : refined_) isShown[toIndex(refined)] = true;
    const auto height = static_cast<double>(character_->height);
    ErrorMeter meter(height);
    std::vector<float> largest(isShown.size(), 0.0f);
    std::vector<glm::vec3> positions;
    const auto poseOf = [&](std::size_t i) { return samplePose(*character_, moments_.clip, times[i]); };
    surfaces_.forEach(times.size(), poseOf, [&](std::size_t i, const Pose& pose, const Surface& live) {
      progress_.tell(static_cast<double>(i) / static_cast<double>(times.size()));
      played->place(pose, settings_.clip, times[i], positions);
      meter.addPose(0, times[i]);
      for (std::size_t v = 0; v < positions.size(); ++v) {
        if (!isShown[v]) continue;
        const double distance = glm::distance(glm::dvec3(positions[v]), glm::dvec3(live.positions[v]));
        meter.add(distance, static_cast<int>(v));
        largest[v] = std::max(largest[v], static_cast<float>(100.0 / height * distance));
      }
    });
    report.between = meter.figures();
    if (report.between.farthest.vertex >= 0) {
      report.between.farthest.clip = settings_.clip;
      report.between.farthest.bone = played->boneOf(report.between.farthest.vertex);
    }
    played->largest = std::move(largest);
    report.played = played;
  }

  /// Gathers each refined vertex once for every node that shows it.
  MorphFit gatherVertices(const OutSkins& skins, std::span<const OutPrimitive> primitives) {
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
        refined_.push_back(refined);
        spaceOf_.push_back(space->second);
        const glm::dvec3 written(into.point(at(fit_.bind().positions, refined)));
        vertices.push_back({refined, space->second, glm::dvec3(meshToBind * glm::dvec4(written, 1.0)),
                            at(fit_.weights(), refined), glm::length(glm::dmat3(meshToBind) * written)});
      }
    }
    if (vertices.size() * moments_.times.size() > kMostPoints) {
      refuseClip(settings_, "needs more than " + std::to_string(kMostPoints) + " vertices in all frames");
    }
    spaces_ = spaces;
    MorphFit morphs(std::move(vertices), std::move(spaces), static_cast<double>(character_->height));
    progress_.begin(kGathering);
    forEachFrame([&](std::size_t, const Surface& live) { morphs.add(matrices_, live.positions); });
    return morphs;
  }

  /// Normals by least squares over the same weights, nearest to the live ones after skinning.
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
    forEachFrame([&](std::size_t frame, const Surface& surface) {
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        forEachIndex(numbers_[p].size(), kLeastTargetRange, [&](std::size_t v) {
          const glm::dmat3 blend = blendedMatrix(matrices_, at(fit_.weights(), primitives[p].refined[v]));
          const glm::vec3 live = shadingNormal(surface, toIndex(primitives[p].drawn[v]));
          const glm::vec3 inBind = normalizeOr(glm::vec3(glm::transpose(blend) * glm::dvec3(live)), live);
          const glm::vec3 change = into[p].normal(inBind) - rest[p][v];
          if (glm::length(change) < kNormalStep) return;
          for (std::size_t k = 0; k < result[p].normals.size(); ++k) {
            result[p].normals[k][v] += static_cast<float>(targets.shares[k * moments_.times.size() + frame]) * change;
          }
        });
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
  BakedClip moments_;
  StageProgress progress_;
  LiveSurfaces surfaces_;
  bool prepared_;
  std::vector<std::vector<int>> numbers_;  ///< [primitives][vertices] of MorphFit's.
  std::vector<int> refined_;               ///< [MorphFit's vertices]
  std::vector<int> spaceOf_;               ///< [MorphFit's vertices] index in spaces_.
  std::vector<glm::dmat3> spaces_;
  std::vector<glm::dmat4> matrices_;  ///< Of the current frame.
};

}  // namespace

Result<BakedExportReport> bakeTargets(Source& source, const std::shared_ptr<const Character>& character, const Rig& rig,
                                      const BakedExportSettings& settings, const std::filesystem::path& file,
                                      const ExportProgress& progress) {
  requireFrames(*character, settings, kMostTargetFrames);
  SkinnedExportSettings skinning;
  skinning.weights = settings.weights;
  skinning.clips = {settings.clip};
  skinning.morphs = false;  // The live surface, and so the new targets, include them.
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
      skinnedFile(source, *character, fit, skinning,
                  [&](GltfRewrite& rewrite, const OutSkins& skins, std::span<const OutPrimitive> primitives) {
                    targets.addTo(rewrite, skins, primitives, report);
                  });
  report.joints = made.joints;
  report.vertices = made.vertices;
  report.triangles = made.triangles;
  report.left = std::move(made.left);
  WriteSkin* const write = findFormat(file, {ExportForm::kSkin})->writeSkin;
  const Result<std::uint64_t> bytes = write(source, made.packed, file, report.left);
  if (!bytes) return bytes.error();
  report.bytes = bytes.value();
  return report;
}

}  // namespace sinew::exporting
