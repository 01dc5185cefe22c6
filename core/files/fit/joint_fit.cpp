// core/files/fit/joint_fit.cpp: the live surface pose by pose; weights, then what joints add, then how near it comes.
#include "core/files/fit/joint_fit.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

#include "core/files/fit/candidates.h"
#include "core/files/fit/weight_fit.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "sinew/character/character_pose.h"

namespace sinew::exporting {
namespace {

/// What the range of motion counts beside all clips together: it holds poses that no clip may ever come near.
constexpr double kShareOfFurther = 0.25;
/// Share of the height: weights that bring a vertex as near as that are not fitted.
constexpr double kNearEnough = 1e-5;
/// Rounds of moving one helper after the other in a pose.
constexpr int kRoundsInPose = 6;
/// Vertices that joints are fitted to; of more, so many stand for all.
constexpr std::size_t kMostFitted = 8'000;
/// Points of live surfaces that are held at once: 240 MB.
constexpr std::size_t kMostFitPoints = 20'000'000;
/// Poses of the range of motion that helpers are fitted beside.
constexpr std::size_t kMostFurtherPoses = 100;
/// Poses of clips that all vertices are weighed in where joints were fitted to some.
constexpr std::size_t kMostWeighed = 150;

/// What share of the work each stage is, about.
struct StageShares {
  double gathering = 0.2;
  double solving = 0.5;
  double helping = 0.0;
  double weighing = 0.0;  ///< Poses, and once more so much: weights.
  double measuring = 0.3;
};

StageShares sharesOf(ExportJoints joints, bool isWhole) {
  if (joints == ExportJoints::kOwn) return isWhole ? StageShares{} : StageShares{0.2, 0.05, 0.0, 0.2, 0.35};
  return isWhole ? StageShares{0.08, 0.1, 0.72, 0.0, 0.1} : StageShares{0.15, 0.02, 0.28, 0.15, 0.25};
}

bool isFitted(const ExportPose& pose) { return pose.use == PoseUse::kFitted; }

}  // namespace

JointFit::JointFit(std::shared_ptr<const Character> character, const Character& moving, const Rig& rig,
                   const SkinnedExportSettings& settings, const ExportProgress& progress)
    : character_(std::move(character)),
      moving_(moving),
      rig_(rig),
      settings_(settings),
      still_(rig),
      progress_(progress),
      surfaces_(character_) {
  still_.morphs.clear();
}

Result<void> JointFit::findWeights() {
  if (const auto prepared = surfaces_.prepare(still_); !prepared) return prepared;
  surfaces_.smooth(withoutMorphs(*character_, bindPose(character_->skeleton)), bind_);
  const Refinement& refinement = *bind_.refinement;
  const bool refined = settings_.mesh == ExportMesh::kRefined;
  count_ = toIndex(refined ? refinement.vertexCount : refinement.controlVertices);
  choosePoses();
  if (settings_.morphs && !character_->morphTargets.empty()) findMorphs();
  if (settings_.joints == ExportJoints::kHelpers) layLines();
  std::vector<std::vector<Share>> shares = interpolatedWeights(character_->mesh, refinement);
  for (std::size_t v = 0; v < count_; ++v) weights_.push_back(fourLargest(shares[v]));
  if (settings_.weights == ExportWeights::kTransferred && settings_.joints == ExportJoints::kOwn) return {};
  auto candidates = weightCandidates(*character_, rig_, refinement, shares);
  if (!candidates) return candidates.error();
  fitSample(candidates.value());
  if (sample_.isWhole()) weights_ = sampleWeights_;
  // Helpers are found on the sample alone; without them all that a vertex may follow is known.
  else if (settings_.joints == ExportJoints::kOwn) weighAll(std::move(candidates).value());
  else weighAll(candidatesNear(sample_, sampleWeights_, weights_));
  return {};
}

void JointFit::choosePoses() {
  const int own = static_cast<int>(character_->clips.size());
  std::vector<int> further;
  for (int clip = 0; clip < static_cast<int>(moving_.clips.size()); ++clip) {
    const bool asked = settings_.clips.empty() || std::ranges::count(settings_.clips, at(moving_.clips, clip).name);
    if (clip >= own) further.push_back(clip);
    else if (asked) clips_.push_back(clip);
  }
  poses_ = exportPoses(moving_, clips_, further);
}

void JointFit::findMorphs() {
  morphs_.targets = settings_.mesh == ExportMesh::kRefined ? refinedTargets(*character_, surfaces_, bind_)
                                                           : originalTargets(*character_);
  std::vector<ExportPose> own;
  std::ranges::copy_if(poses_, std::back_inserter(own), [this](const ExportPose& pose) { return isOwn(pose); });
  setMorphKeys(*character_, rig_, own, morphs_);
}

void JointFit::layLines() {
  std::vector<Pose> moments;
  for (const ExportPose& pose : poses_)
    moments.push_back(samplePose(*character_, at(moving_.clips, pose.clip), pose.time));
  lines_ = LineJoints(rig_, *character_, settings_.jointScale, moments);
}

/// Whether a pose is among those that are fitted, of too many every second, third ...: asked of each in order.
/// @param mostOwn  of clips; of the range of motion no more than kMostFurtherPoses
std::function<bool(const ExportPose&)> JointFit::someFitted(std::size_t mostOwn) const {
  std::array<std::size_t, 2> count{};
  for (const ExportPose& pose : poses_) {
    if (isFitted(pose)) ++count[isOwn(pose) ? 0 : 1];
  }
  const std::array most{mostOwn, std::min(kMostFurtherPoses, mostOwn)};
  std::array<std::size_t, 2> step{};
  for (const std::size_t kind : {0U, 1U}) step[kind] = (count[kind] + most[kind] - 1) / most[kind];
  return [this, step, seen = std::array<std::size_t, 2>{}](const ExportPose& pose) mutable {
    const std::size_t kind = isOwn(pose) ? 0 : 1;
    return isFitted(pose) && seen[kind]++ % step[kind] == 0;
  };
}

/// Joints, and weights of the sample.
void JointFit::fitSample(const std::vector<std::vector<int>>& candidates) {
  sample_ = sampleVertices(restOfAll(), trianglesOfFit(), kMostFitted);
  std::vector<std::vector<int>> own;
  for (const int v : sample_.vertices) {
    own.push_back(at(candidates, v));
    sampleRest_.push_back(at(bind_.positions, v));
    sampleWeights_.push_back(at(weights_, v));
  }
  const bool helps = settings_.joints == ExportJoints::kHelpers;
  const StageShares shares = sharesOf(settings_.joints, sample_.isWhole());
  const std::size_t most = std::max<std::size_t>(kMostFitPoints / std::max<std::size_t>(count_, 1), 1);
  auto isHeld = someFitted(sample_.isWhole() ? most : kMostFitPoints / sample_.vertices.size());
  std::vector<FitPose> poses;
  WeightFit fit(sampleRest_, std::move(own), sampleWeights_);
  progress_.begin(shares.gathering);
  const auto add = [&](const ExportPose& pose, const Pose& moment) {
    fit.add(matrices_, sampleLive_, !isOwn(pose));
    if (helps && (!sample_.isWhole() || isHeld(pose))) poses.push_back({moment, matrices_, sampleLive_, !isOwn(pose)});
  };
  if (sample_.isWhole()) forEachPose(isFitted, add);
  else forEachPose(isHeld, add);
  progress_.begin(shares.solving);
  const double near = kNearEnough * static_cast<double>(character_->height);
  sampleWeights_ = fit.solve(sample_.triangles, furtherShare(), near, progress_);
  if (helps) addHelpers(poses);
}

void JointFit::addHelpers(const std::vector<FitPose>& poses) {
  const HelperTask task{character_->skeleton,
                        sampleRest_,
                        sample_.triangles,
                        poses,
                        lines_.joints(),
                        furtherShare(),
                        static_cast<double>(character_->height)};
  progress_.begin(sharesOf(settings_.joints, sample_.isWhole()).helping);
  HelperResult result = fitHelpers(task, std::move(sampleWeights_), settings_.helpers, progress_);
  sampleWeights_ = std::move(result.weights);
  rigid_ = std::move(result.helpers);
  lines_.keep(result.keptLines);
}

/// Every vertex follows the best of its candidates, in the poses that the keys will have.
void JointFit::weighAll(std::vector<std::vector<int>> candidates) {
  const StageShares shares = sharesOf(settings_.joints, false);
  WeightFit fit(restOfAll(), std::move(candidates), weights_);
  const HelperMotion motion(character_->skeleton, sampleRest_, sampleWeights_, rigid_, firstRigid());
  progress_.begin(shares.weighing);
  // Without helpers weights must not be worse than those of the file, in any of the poses.
  const auto isMeant = settings_.joints == ExportJoints::kOwn ? std::function<bool(const ExportPose&)>(isFitted)
                                                              : someFitted(kMostWeighed);
  forEachPose(isMeant, [&](const ExportPose& pose, const Pose& moment) {
    moveHelpers(moment, isOwn(pose), motion);
    fit.add(matrices_, live_->positions, !isOwn(pose));
  });
  progress_.begin(shares.weighing);
  const double near = kNearEnough * static_cast<double>(character_->height);
  weights_ = fit.solve(trianglesOfFit(), furtherShare(), near, progress_);
  for (std::size_t i = 0; i < sample_.vertices.size(); ++i) sampleWeights_[i] = at(weights_, sample_.vertices[i]);
  rigidLocals_.clear();
}

/// Moves the rigid helpers as the live surface asks for, where the pose has keys, and leaves them at rest elsewhere.
void JointFit::moveHelpers(const Pose& moment, bool isKeyed, const HelperMotion& motion) {
  if (!isKeyed || rigidLocals_.size() != rigid_.size()) {
    rigidLocals_.clear();
    for (const HelperJoint& joint : rigid_) rigidLocals_.push_back(joint.rest);
  }
  if (isKeyed) motion.solve(moment, matrices_, sampleLive_, kRoundsInPose, rigidLocals_);
  for (std::size_t j = 0; j < rigid_.size(); ++j) {
    matrices_.push_back(helperMatrix(rigid_[j], moment, rigidLocals_[j]));
  }
}

std::vector<HelperJoint> JointFit::helpers() const {
  std::vector<HelperJoint> all = lines_.joints();
  all.insert(all.end(), rigid_.begin(), rigid_.end());
  return all;
}

bool JointFit::isOwn(const ExportPose& pose) const { return toIndex(pose.clip) < character_->clips.size(); }

double JointFit::measuringShare() const { return sharesOf(settings_.joints, sample_.isWhole()).measuring; }

int JointFit::firstRigid() const {
  return static_cast<int>(character_->skeleton.bindings.size() + lines_.joints().size());
}

/// What a further pose counts, where a pose of a clip that is exported counts 1.
double JointFit::furtherShare() const {
  const auto fitted = [](const ExportPose& pose) { return isFitted(pose); };
  const auto all = std::ranges::count_if(poses_, fitted);
  const auto own = std::ranges::count_if(poses_, [&](const ExportPose& pose) { return fitted(pose) && isOwn(pose); });
  if (own == 0 || own == all) return 1.0;
  return std::min(1.0, kShareOfFurther * static_cast<double>(own) / static_cast<double>(all - own));
}

std::vector<std::array<int, 3>> JointFit::trianglesOfFit() const {
  if (settings_.mesh == ExportMesh::kRefined) return bind_.refinement->triangles;
  std::vector<std::array<int, 3>> triangles;
  for (const ControlTriangle& triangle : character_->mesh.triangles) triangles.push_back(triangle.vertices);
  return triangles;
}

std::vector<glm::vec3> JointFit::restOfAll() const {
  return {bind_.positions.begin(), bind_.positions.begin() + static_cast<std::ptrdiff_t>(count_)};
}

}  // namespace sinew::exporting
