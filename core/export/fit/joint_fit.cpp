// core/export/fit/joint_fit.cpp: the live surface pose by pose; weights, then what joints add, then how near it comes.
#include "core/export/fit/joint_fit.h"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/export/fit/candidates.h"
#include "core/export/fit/error_meter.h"
#include "core/export/fit/helper_fit.h"
#include "core/export/fit/weight_fit.h"

namespace sinew::exporting {
namespace {

/// What the range of motion counts beside all clips together: it holds poses that no clip may ever come near.
constexpr double kShareOfFurther = 0.25;
/// Share of the height: weights that bring a vertex as near as that are not fitted.
constexpr double kNearEnough = 1e-5;
/// Rounds of moving one helper after the other in a pose.
constexpr int kRoundsInPose = 6;
/// Points of live surfaces that are held at once: 240 MB.
constexpr std::size_t kMostFitPoints = 20'000'000;
/// Poses of the range of motion that helpers are fitted beside.
constexpr std::size_t kMostFurtherPoses = 100;

/// What share of the work each stage is, about.
struct StageShares {
  double gathering = 0.2;
  double solving = 0.5;
  double helping = 0.0;
  double measuring = 0.3;
};

StageShares sharesOf(ExportJoints joints) {
  return joints == ExportJoints::kOwn ? StageShares{} : StageShares{0.04, 0.1, 0.76, 0.1};
}

bool isFitted(PoseUse use) { return use == PoseUse::kFitted; }

}  // namespace

JointFit::JointFit(std::shared_ptr<const Character> character, const Character& moving, const Rig& rig,
                   const SkinnedExportSettings& settings, const ExportProgress& progress)
    : character_(std::move(character)),
      moving_(moving),
      rig_(rig),
      settings_(settings),
      progress_(progress),
      surfaces_(character_) {}

Result<void> JointFit::findWeights() {
  if (const auto prepared = surfaces_.prepare(rig_); !prepared) return prepared;
  surfaces_.smooth(bindPose(character_->skeleton), bind_);
  const Refinement& refinement = *bind_.refinement;
  const bool refined = settings_.mesh == ExportMesh::kRefined;
  count_ = toIndex(refined ? refinement.vertexCount : refinement.controlVertices);
  choosePoses();
  if (settings_.joints == ExportJoints::kHelpers) layLines();
  std::vector<std::vector<Share>> shares = interpolatedWeights(character_->mesh, refinement);
  for (std::size_t v = 0; v < count_; ++v) weights_.push_back(fourLargest(shares[v]));
  if (settings_.weights == ExportWeights::kTransferred && settings_.joints == ExportJoints::kOwn) return {};
  auto candidates = weightCandidates(*character_, rig_, refinement, shares);
  if (!candidates) return candidates.error();
  refit(std::move(candidates).value());
  if (settings_.joints == ExportJoints::kHelpers) addHelpers(fitPoses());
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

void JointFit::layLines() {
  std::vector<Pose> moments;
  for (const ExportPose& pose : poses_)
    moments.push_back(samplePose(character_->skeleton, at(moving_.clips, pose.clip), pose.time));
  lines_ = LineJoints(rig_, *character_, settings_.jointScale, moments);
}

/// Smooths the poses that are meant and calls use(pose, moment) after each, the live surface and the matrices of
/// bindings and lines' joints at hand.
template <class Means, class Use>
void JointFit::forEachPose(Means means, Use use) {
  std::vector<const ExportPose*> meant;
  for (const ExportPose& pose : poses_) {
    if (means(pose.use)) meant.push_back(&pose);
  }
  const auto momentOf = [&](std::size_t i) {
    return samplePose(character_->skeleton, at(moving_.clips, meant[i]->clip), meant[i]->time);
  };
  surfaces_.forEach(meant.size(), momentOf, [&](std::size_t i, const Pose& moment, const Surface& live) {
    progress_.tell(static_cast<double>(i) / static_cast<double>(meant.size()));
    live_ = &live;
    bindingMatrices(character_->skeleton, moment, matrices_);
    lines_.pose(moment, lineLocals_);
    for (std::size_t j = 0; j < lineLocals_.size(); ++j) {
      matrices_.push_back(helperMatrix(lines_.joints()[j], moment, lineLocals_[j]));
    }
    use(*meant[i], moment);
  });
}

void JointFit::refit(std::vector<std::vector<int>> candidates) {
  candidates.resize(count_);
  WeightFit fit(restOfFit(), std::move(candidates), weights_);
  progress_.begin(sharesOf(settings_.joints).gathering);
  forEachPose(isFitted,
              [&](const ExportPose& pose, const Pose&) { fit.add(matrices_, live_->positions, !isOwn(pose)); });
  progress_.begin(sharesOf(settings_.joints).solving);
  weights_ =
      fit.solve(trianglesOfFit(), furtherShare(), kNearEnough * static_cast<double>(character_->height), progress_);
}

/// Fitted poses, of too many as many as may be held.
std::vector<FitPose> JointFit::fitPoses() {
  std::size_t own = 0;
  std::size_t further = 0;
  for (const ExportPose& pose : poses_) {
    if (isFitted(pose.use)) ++(isOwn(pose) ? own : further);
  }
  const std::size_t mostOwn = std::max<std::size_t>(kMostFitPoints / count_, 1);
  const std::size_t mostFurther = std::min(kMostFurtherPoses, mostOwn);
  const std::size_t ownStep = (own + mostOwn - 1) / mostOwn;
  const std::size_t furtherStep = (further + mostFurther - 1) / mostFurther;
  std::size_t ownSeen = 0;
  std::size_t furtherSeen = 0;
  std::vector<FitPose> poses;
  forEachPose(isFitted, [&](const ExportPose& pose, const Pose& moment) {
    const bool taken = isOwn(pose) ? ownSeen++ % ownStep == 0 : furtherSeen++ % furtherStep == 0;
    if (!taken) return;
    const auto end = live_->positions.begin() + static_cast<std::ptrdiff_t>(count_);
    poses.push_back({moment, matrices_, {live_->positions.begin(), end}, !isOwn(pose)});
  });
  return poses;
}

void JointFit::addHelpers(const std::vector<FitPose>& poses) {
  const std::vector<glm::vec3> rest = restOfFit();
  const std::vector<std::array<int, 3>> triangles = trianglesOfFit();
  const HelperTask task{character_->skeleton,
                        rest,
                        triangles,
                        poses,
                        lines_.joints(),
                        furtherShare(),
                        static_cast<double>(character_->height)};
  progress_.begin(sharesOf(settings_.joints).helping);
  HelperResult result = fitHelpers(task, std::move(weights_), settings_.helpers, progress_);
  weights_ = std::move(result.weights);
  rigid_ = std::move(result.helpers);
  lines_.keep(result.keptLines);
}

/// Moves the rigid helpers as the live surface asks for, where the pose has keys, and leaves them at rest elsewhere.
void JointFit::moveHelpers(const Pose& moment, bool isKeyed, const HelperMotion& motion) {
  if (!isKeyed || rigidLocals_.size() != rigid_.size()) {
    rigidLocals_.clear();
    for (const HelperJoint& joint : rigid_) rigidLocals_.push_back(joint.rest);
  }
  if (isKeyed) motion.solve(moment, matrices_, live_->positions, kRoundsInPose, rigidLocals_);
  for (std::size_t j = 0; j < rigid_.size(); ++j) {
    matrices_.push_back(helperMatrix(rigid_[j], moment, rigidLocals_[j]));
  }
}

void JointFit::keep(const ExportPose& pose) {
  const std::string& name = at(moving_.clips, pose.clip).name;
  if (pose.time == 0.0f) {
    helperClips_.push_back({name, {}, {}});
    helperClips_.back().locals.resize(lines_.joints().size() + rigid_.size());
  }
  HelperClip& clip = helperClips_.back();
  clip.times.push_back(pose.time);
  std::size_t joint = 0;
  for (const Trs& local : lineLocals_) clip.locals[joint++].push_back(local);
  for (const Trs& local : rigidLocals_) clip.locals[joint++].push_back(local);
}

void JointFit::measure(SkinnedExportReport& report) {
  const auto height = static_cast<double>(character_->height);
  std::vector<ErrorMeter> meters(moving_.clips.size(), ErrorMeter(height));
  ErrorMeter fitted(height);
  ErrorMeter heldOut(height);
  ErrorMeter all(height);
  const std::vector<glm::vec3> rest = restOfFit();
  const HelperMotion motion(character_->skeleton, rest, weights_, rigid_, firstRigid());
  progress_.begin(sharesOf(settings_.joints).measuring);
  forEachPose([](PoseUse) { return true; },
              [&](const ExportPose& pose, const Pose& moment) {
                moveHelpers(moment, isOwn(pose), motion);
                if (isOwn(pose)) keep(pose);
                std::vector<ErrorMeter*> meant{&at(meters, pose.clip)};
                if (isOwn(pose)) meant.push_back(&all);
                if (pose.use == PoseUse::kFitted) meant.push_back(&fitted);
                if (pose.use == PoseUse::kHeldOut) meant.push_back(&heldOut);
                for (ErrorMeter* meter : meant) meter->addPose();
                for (std::size_t v = 0; v < count_; ++v) {
                  const glm::dvec3 exported = skinPoint(matrices_, weights_[v], glm::dvec3(bind_.positions[v]));
                  const double distance = glm::length(exported - glm::dvec3(live_->positions[v]));
                  for (ErrorMeter* meter : meant) meter->add(distance);
                }
              });
  for (const int clip : clips_) report.clips.push_back({at(moving_.clips, clip).name, at(meters, clip).figures()});
  for (std::size_t clip = character_->clips.size(); clip < moving_.clips.size(); ++clip) {
    report.further.push_back({moving_.clips[clip].name, meters[clip].figures()});
  }
  report.allClips = all.figures();
  report.fitted = fitted.figures();
  report.heldOut = heldOut.figures();
  report.lineJoints = static_cast<int>(lines_.joints().size());
  report.rigidHelpers = static_cast<int>(rigid_.size());
}

std::vector<HelperJoint> JointFit::helpers() const {
  std::vector<HelperJoint> all = lines_.joints();
  all.insert(all.end(), rigid_.begin(), rigid_.end());
  return all;
}

bool JointFit::isOwn(const ExportPose& pose) const { return toIndex(pose.clip) < character_->clips.size(); }

int JointFit::firstRigid() const {
  return static_cast<int>(character_->skeleton.bindings.size() + lines_.joints().size());
}

/// What a further pose counts, where a pose of a clip that is exported counts 1.
double JointFit::furtherShare() const {
  const auto fitted = [](const ExportPose& pose) { return isFitted(pose.use); };
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

std::vector<glm::vec3> JointFit::restOfFit() const {
  return {bind_.positions.begin(), bind_.positions.begin() + static_cast<std::ptrdiff_t>(count_)};
}

}  // namespace sinew::exporting
