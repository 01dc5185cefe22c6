// tests/support/surface/coherence.cpp: measures steps relative to the patch, and classifies large ones by the oracle.
#include "tests/support/surface/coherence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/attachment.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/motion.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

constexpr float kFrame = 1.0f / 60.0f;

std::string boneOf(const Character& character, int controlVertex) {
  const auto influences = character.mesh.influencesOf(controlVertex);
  const Influence strongest = *std::ranges::max_element(influences, {}, &Influence::weight);
  return character.skeleton.fileName(character.skeleton.bindings[static_cast<std::size_t>(strongest.binding)].bone);
}

/// phi is not monotone between the two places on the ray: a primitive overhangs the skin, or lies behind another one,
/// with a gap in between, so that the first root lies on one or the other.
bool overhangs(const oracle::Oracle& oracle, const oracle::Answer& answer, double from, double to) {
  constexpr int kSamples = 400;
  bool rises = false;
  bool falls = false;
  double before = oracle.phiAt(answer, from);
  for (int i = 1; i <= kSamples; ++i) {
    const double now = oracle.phiAt(answer, from + (to - from) * i / kSamples);
    rises = rises || now > before + 1e-9;
    falls = falls || now < before - 1e-9;
    before = now;
  }
  return rises && falls;
}

/// Motion of the nearest parts of muscles in the frame that moves with the patch: the skin cannot be expected to move
/// less.
class MuscleMotion {
 public:
  MuscleMotion(const TrialScene& scene, const Rig& rig) : attachment_(attach(rig, *scene.character).value()) {}

  void pose(const Pose& pose) {
    before_ = now_;
    now_.clear();
    for (const FieldPrimitive& p : attachment_.primitives) {
      now_.push_back(shapeInWorld(p.placement, p.reach, pose.boneInWorld[static_cast<std::size_t>(p.bone)]));
    }
  }

  /// Largest motion of a pole of a muscle whose weight at the vertex is not 0, world units.
  [[nodiscard]] float of(const PatchFrame& was, const PatchFrame& is, const std::vector<double>& weights) const {
    float most = 0.0f;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      if (!(weights[i] > 0.0) || !near(now_[i], is) || !near(before_[i], was)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
          const glm::vec3 a = was.seen(glm::vec3(before_[i][3] + side * before_[i][axis]));
          const glm::vec3 b = is.seen(glm::vec3(now_[i][3] + side * now_[i][axis]));
          most = std::max(most, glm::distance(a, b));
        }
      }
    }
    return most;
  }

 private:
  static bool near(const glm::mat4& shape, const PatchFrame& frame) {
    const float radius =
        glm::length(glm::vec3(shape[0])) + glm::length(glm::vec3(shape[1])) + glm::length(glm::vec3(shape[2]));
    return glm::distance(glm::vec3(shape[3]), frame.origin) < radius;
  }

  Attachment attachment_;
  std::vector<glm::mat4> before_;
  std::vector<glm::mat4> now_;
};

/// Motion of the root's place on the ray in the frame that moves with the patch, had it stayed at its distance.
double rayMotion(const oracle::Answer& was, const PatchFrame& frameWas, const oracle::Answer& is,
                 const PatchFrame& frameIs) {
  const auto placed = [](const oracle::Answer& a, const PatchFrame& frame, double t) {
    const oracle::Vec at = a.rayOrigin + t * a.rayDirection;
    return frame.seen({static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
  };
  double most = 0.0;
  for (const double t : {0.0, was.offset, is.offset}) {
    most = std::max(most, static_cast<double>(glm::distance(placed(was, frameWas, t), placed(is, frameIs, t))));
  }
  return most;
}

/// Causes specific to `replace`. @param size of the step, world units.
std::optional<StepCause> causeInReplace(const oracle::Answer& was, const oracle::Answer& is, double iso, double size) {
  if ((was.field > iso) != (is.field > iso)) return StepCause::kCrossing;
  if (was.fellBack != is.fellBack) return StepCause::kAnchor;
  if (was.shares.size() != is.shares.size() || was.resolved != is.resolved) return StepCause::kRoots;
  double change = 0.0;
  for (std::size_t i = 0; i < was.shares.size(); ++i) change += std::abs(was.shares[i] - is.shares[i]);
  const double lever = std::max(std::abs(was.offset), std::abs(is.offset));
  if (change * lever > 0.5 * size) return StepCause::kShares;
  return std::nullopt;
}

class Walker {
 public:
  Walker(const TrialScene& scene, const Rig& rig)
      : scene_(scene),
        mode_(rig.surface.mode),
        smoother_(scene.character),
        bare_(scene.character),
        before_(*scene.character, rig),
        after_(*scene.character, rig),
        projected_(*scene.character, rig),
        motion_(scene, rig) {
    Rig empty = rig;
    empty.primitives.clear();
    EXPECT_TRUE(smoother_.prepare(rig).ok() && bare_.prepare(empty).ok());
  }

  void walk(const AnimationClip& clip, Coherence& out) {
    std::vector<glm::vec3> before;
    const int frames = static_cast<int>(clip.duration / kFrame);
    for (int i = 0; i <= frames; ++i) {
      const float time = static_cast<float>(i) * kFrame;
      const Pose pose = samplePose(scene_.character->skeleton, clip, time);
      std::vector<glm::vec3> now = offsetsAt(pose);
      motion_.pose(pose);
      if (i > 0) compare(before, now, clip, time, out);
      before = std::move(now);
    }
  }

 private:
  std::vector<glm::vec3> offsetsAt(const Pose& pose) {
    std::swap(patch_, patchBefore_);
    smoother_.smooth(pose, surface_);
    bare_.smooth(pose, patch_);
    if (!offsets_) offsets_.emplace(*surface_.refinement);
    return offsets_->of(surface_, patch_);
  }

  void compare(const std::vector<glm::vec3>& before, const std::vector<glm::vec3>& now, const AnimationClip& clip,
               float time, Coherence& out) {
    bool posed = false;
    for (std::size_t v = 0; v < now.size(); ++v) {
      const float way = glm::distance(before[v], now[v]) / scene_.character->height;
      const float size = std::isfinite(way) ? way : std::numeric_limits<float>::infinity();
      const bool isFar = size > kFarStep;
      if (!isFar && size <= out.largest.size) continue;
      Step step{size, static_cast<int>(v), clip.name, time, {}};
      if (isFar) {
        if (!posed) poseOracles(clip, time);
        posed = true;
        FarSteps& far = out.far[causeOf(step, now[v] - before[v])];
        ++far.count;
        if (step.size > far.largest.size) far.largest = step;
      }
      if (step.size > out.largest.size) out.largest = step;
    }
    ++out.frames;
    out.vertexSteps += static_cast<long long>(now.size());
  }

  void poseOracles(const AnimationClip& clip, float time) {
    const Pose was = samplePose(scene_.character->skeleton, clip, time - kFrame);
    const Pose is = samplePose(scene_.character->skeleton, clip, time);
    before_.pose(was);
    after_.pose(is);
    projectedBefore_ = offsets_->of(projected_.at(was), patchBefore_);
    projectedNow_ = offsets_->of(projected_.at(is), patch_);
  }

  StepCause causeOf(Step& step, const glm::vec3& way) const {
    const float height = scene_.character->height;
    const auto v = static_cast<std::size_t>(step.vertex);
    const glm::vec3 byProjection = projectedNow_[v] - projectedBefore_[v];
    const oracle::Site site = oracle::siteOf(scene_.character->mesh, *surface_.refinement, step.vertex);
    const oracle::Answer was = before_.evaluate(site);
    const oracle::Answer is = after_.evaluate(site);
    const PatchFrame frameWas = offsets_->frame(patchBefore_, step.vertex);
    const PatchFrame frameIs = offsets_->frame(patch_, step.vertex);
    const auto muscle = static_cast<double>(motion_.of(frameWas, frameIs, after_.weightsAt(site)));
    const double ray = rayMotion(was, frameWas, is, frameIs);
    const double size = static_cast<double>(step.size * height);
    step.details = "bone " + boneOf(*scene_.character, site.vertices[0]) +
                   numbers(was, is, muscle, ray, static_cast<double>(glm::length(byProjection)));

    if (glm::length(way - byProjection) > glm::length(byProjection)) return StepCause::kFolds;
    if (mode_ == SurfaceMode::kReplace) {
      if (const auto cause = causeInReplace(was, is, after_.field().iso(), size)) return *cause;
    }
    const double low = std::min(was.offset, is.offset);
    const double high = std::max(was.offset, is.offset);
    if (overhangs(before_, was, low, high) || overhangs(after_, is, low, high)) return StepCause::kOverhang;
    if (size > std::max(muscle, ray)) return StepCause::kSteepFlank;
    return muscle >= ray ? StepCause::kMuscle : StepCause::kSwingingRay;
  }

  /// Lengths in H.
  [[nodiscard]] std::string numbers(const oracle::Answer& was, const oracle::Answer& is, double muscle, double ray,
                                    double byProjection) const {
    const auto height = static_cast<double>(scene_.character->height);
    char text[280];
    std::snprintf(text, sizeof text,
                  ", muscles moved %.4f H, ray %.4f H, projection alone %.4f H, F on the skin %.3f -> %.3f, offset "
                  "%.4f -> %.4f H, weight %.2f -> %.2f",
                  muscle / height, ray / height, byProjection / height, was.field, is.field, was.offset / height,
                  is.offset / height, was.weight, is.weight);
    return text;
  }

  const TrialScene& scene_;
  SurfaceMode mode_;
  Smoother smoother_;
  Smoother bare_;
  oracle::Oracle before_;
  oracle::Oracle after_;
  Projected projected_;
  MuscleMotion motion_;
  std::optional<CarriedOffsets> offsets_;
  Surface surface_;
  Surface patch_;
  Surface patchBefore_;
  std::vector<glm::vec3> projectedBefore_;  ///< Offsets before folds are taken out.
  std::vector<glm::vec3> projectedNow_;
};

}  // namespace

const char* nameOf(StepCause cause) {
  constexpr std::array kNames{"kFolds",    "kCrossing", "kAnchor",      "kRoots",     "kShares",
                              "kOverhang", "kMuscle",   "kSwingingRay", "kSteepFlank"};
  return kNames[static_cast<std::size_t>(cause)];
}

long long Coherence::farSteps() const {
  long long sum = 0;
  for (const auto& [cause, steps] : far) sum += steps.count;
  return sum;
}

Coherence walkClips(const TrialScene& scene, const Rig& rig) {
  Coherence out;
  Walker walker(scene, rig);
  for (const AnimationClip& clip : scene.character->clips) walker.walk(clip, out);
  return out;
}

}  // namespace sinew::test
