// core/files/fit/joint_measure.cpp: error of joints and weights at their keys and between them.
#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "core/files/fit/joint_fit.h"
#include "core/files/fit/played_surface.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "sinew/character/character_pose.h"

namespace sinew::exporting {
namespace {

constexpr std::size_t kLeastMeasuredRange = 1024;  ///< Vertices per thread, at least.
constexpr double kShareOfKeys = 0.4;               ///< Fraction of the measuring.

}  // namespace

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

/// The meter's figures with names of clip and bone.
ErrorFigures JointFit::figuresOf(const ErrorMeter& meter) const {
  ErrorFigures figures = meter.figures();
  if (figures.farthest.vertex < 0) return figures;
  figures.farthest.clip = at(moving_.clips, meter.farthestClip()).name;
  figures.farthest.bone = played_->boneOf(figures.farthest.vertex);
  return figures;
}

template <class Use>
void JointFit::forEachPlayed(std::span<const ExportPose> poses, Use use) {
  std::vector<glm::vec3> placed;
  std::vector<double> distances(count_);
  const auto momentOf = [&](std::size_t i) {
    return samplePose(*character_, at(moving_.clips, poses[i].clip), poses[i].time);
  };
  surfaces_.forEach(poses.size(), momentOf, [&](std::size_t i, const Pose& moment, const Surface& live) {
    progress_.tell(static_cast<double>(i) / static_cast<double>(poses.size()));
    played_->place(moment, at(moving_.clips, poses[i].clip).name, poses[i].time, placed);
    for (std::size_t v = 0; v < count_; ++v) {
      distances[v] = glm::distance(glm::dvec3(placed[v]), glm::dvec3(live.positions[v]));
    }
    use(poses[i], distances);
  });
}

void JointFit::measure(SkinnedExportReport& report) {
  const auto height = static_cast<double>(character_->height);
  std::vector<ErrorMeter> meters(moving_.clips.size(), ErrorMeter(height));
  ErrorMeter fitted(height);
  ErrorMeter heldOut(height);
  ErrorMeter all(height);
  const auto count = [&](const ExportPose& pose, std::span<const double> distances) {
    std::vector<ErrorMeter*> meant{&at(meters, pose.clip)};
    if (isOwn(pose)) meant.push_back(&all);
    if (pose.use == PoseUse::kFitted) meant.push_back(&fitted);
    if (pose.use == PoseUse::kHeldOut) meant.push_back(&heldOut);
    if (isOwn(pose)) noteLargest(distances);
    for (ErrorMeter* meter : meant) meter->addPose(pose.clip, pose.time, distances);
  };
  const bool morphs = !morphs_.targets.empty();
  const double share = kShareOfKeys * measuringShare();
  const HelperMotion motion(character_->skeleton, sampleRest_, sampleWeights_, rigid_, firstRigid());
  std::vector<double> distances(count_);
  largest_.assign(count_, 0.0f);
  progress_.begin(morphs ? 0.5 * share : share);
  forEachPose([](const ExportPose&) { return true; },
              [&](const ExportPose& pose, const Pose& moment) {
                moveHelpers(moment, isOwn(pose), motion);
                if (isOwn(pose)) keep(pose);
                if (morphs) return;
                forEachIndex(count_, kLeastMeasuredRange, [&](std::size_t v) {
                  const glm::dvec3 exported = skinPoint(matrices_, weights_[v], glm::dvec3(bind_.positions[v]));
                  distances[v] = glm::length(exported - glm::dvec3(live_->positions[v]));
                });
                count(pose, distances);
              });
  played_ = std::make_shared<PlayedSurface>(character_, restOfAll(), weights_, helpers(), helperClips_);
  played_->triangles = trianglesOfFit();
  if (morphs && surfaces_.prepare(rig_).ok()) {
    played_->morphs = morphs_;
    progress_.begin(0.5 * share);
    forEachPlayed(poses_, count);
  }
  for (const int clip : clips_) report.clips.push_back({at(moving_.clips, clip).name, figuresOf(at(meters, clip))});
  for (std::size_t clip = character_->clips.size(); clip < moving_.clips.size(); ++clip) {
    report.further.push_back({moving_.clips[clip].name, figuresOf(meters[clip])});
  }
  report.allClips = figuresOf(all);
  report.fitted = figuresOf(fitted);
  report.heldOut = figuresOf(heldOut);
  report.lineJoints = static_cast<int>(lines_.joints().size());
  report.rigidHelpers = static_cast<int>(rigid_.size());
}

void JointFit::measureBetween(SkinnedExportReport& report) {
  std::vector<ExportPose> poses;
  for (const int clip : clips_) {
    for (const float time : timesBetween(at(moving_.clips, clip), kMeasuredPerSecond)) poses.push_back({clip, time});
  }
  const auto height = static_cast<double>(character_->height);
  std::vector<ErrorMeter> meters(moving_.clips.size(), ErrorMeter(height));
  ErrorMeter all(height);
  progress_.begin((1.0 - kShareOfKeys) * measuringShare());
  forEachPlayed(poses, [&](const ExportPose& pose, std::span<const double> distances) {
    noteLargest(distances);
    at(meters, pose.clip).addPose(pose.clip, pose.time, distances);
    all.addPose(pose.clip, pose.time, distances);
  });
  for (std::size_t c = 0; c < clips_.size(); ++c) report.clips[c].between = figuresOf(at(meters, clips_[c]));
  report.allBetween = figuresOf(all);
  played_->largest = std::move(largest_);
  report.played = played_;
}

void JointFit::noteLargest(std::span<const double> distances) {
  const double percent = 100.0 / static_cast<double>(character_->height);
  for (std::size_t v = 0; v < count_; ++v) {
    largest_[v] = std::max(largest_[v], static_cast<float>(percent * distances[v]));
  }
}

}  // namespace sinew::exporting
