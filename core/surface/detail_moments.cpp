// core/surface/detail_moments.cpp: farthest-point sampling over what a pose does to muscles.
#include "core/surface/detail_moments.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/character/range_of_motion.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew {
namespace {

constexpr int kMomentsOfClips = 96;  ///< In all, but at least kLeastOfClip of each.
constexpr int kLeastOfClip = 4;
constexpr int kMostMoments = 256;
constexpr double kStretchWeight = 2.0;    ///< A line's stretch by 1 counts as much as a joint bent by two radians.
constexpr double kLeastDifference = 0.1;  ///< Poses that are nearer show nothing new.

using Features = std::vector<float>;

void addMoments(const Skeleton& skeleton, const AnimationClip& clip, int count, std::vector<Pose>& out) {
  for (int i = 0; i < count && static_cast<int>(out.size()) < kMostMoments; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    out.push_back(samplePose(skeleton, clip, share * clip.duration));
  }
}

/// How a bone is turned against its parent, compared with the bind pose.
glm::mat3 turnOf(const Skeleton& skeleton, const Pose& pose, int bone) {
  const auto axes = [](const glm::mat4& m) {
    glm::mat3 out(m);
    for (int i = 0; i < 3; ++i) {
      const float length = glm::length(out[i]);
      if (length > 0.0f) out[i] /= length;
    }
    return out;
  };
  const Bone& own = at(skeleton.bones, bone);
  const glm::mat3 now = axes(at(pose.boneInWorld, bone));
  const glm::mat3 then = axes(own.bindInWorld);
  if (own.parent < 0) return glm::mat3(1.0f);
  const glm::mat3 parentNow = axes(at(pose.boneInWorld, own.parent));
  const glm::mat3 parentThen = axes(at(skeleton.bones, own.parent).bindInWorld);
  return glm::transpose(parentNow) * now - glm::transpose(parentThen) * then;
}

class FeatureReader {
 public:
  FeatureReader(const Character& character, const Rig& rig, const RigPoser& poser)
      : character_(character), poser_(poser) {
    const Skeleton& skeleton = character.skeleton;
    std::vector<bool> counts(skeleton.bones.size(), false);
    for (const Primitive& primitive : rig.primitives) {
      const auto bone = skeleton.findBone(primitive.bone);
      if (!bone) continue;
      counts[toIndex(*bone)] = true;
      for (const int child : at(skeleton.bones, *bone).children) counts[toIndex(child)] = true;
    }
    for (std::size_t b = 0; b < counts.size(); ++b) {
      if (counts[b]) bones_.push_back(static_cast<int>(b));
    }
  }

  Features read(const Pose& pose) {
    Features out;
    for (const int bone : bones_) {
      const glm::mat3 turn = turnOf(character_.skeleton, pose, bone);
      for (int c = 0; c < 3; ++c) out.insert(out.end(), {turn[c].x, turn[c].y, turn[c].z});
    }
    poser_.pose(pose, posed_);
    for (const PosedLine& line : posed_.lines) {
      out.push_back(line.usable ? static_cast<float>(kStretchWeight) * line.bellyStretch : 0.0f);
      out.push_back(line.usable ? line.activation : 0.0f);
    }
    for (const MuscleNumbers& numbers : posed_.numbers.primitives) {
      out.push_back(numbers.amount);
      out.push_back(numbers.reach);
    }
    return out;
  }

 private:
  const Character& character_;
  const RigPoser& poser_;
  std::vector<int> bones_;
  PosedRig posed_;
};

double squaredDifference(const Features& a, const Features& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return sum;
}

}  // namespace

std::vector<Pose> detailMoments(const Character& character) {
  std::vector<Pose> moments;
  std::vector<const AnimationClip*> clips;
  for (const AnimationClip& clip : character.clips) {
    if (!clip.turnsBindPose && clip.duration > 0.0f) clips.push_back(&clip);
  }
  const int each = clips.empty() ? 0 : std::max(kLeastOfClip, kMomentsOfClips / static_cast<int>(clips.size()));
  for (const AnimationClip* clip : clips) addMoments(character.skeleton, *clip, each, moments);
  const AnimationClip motion = rangeOfMotion(character.skeleton, motionHints(character));
  const int steps = static_cast<int>(motion.duration * 2.0f);
  if (!motion.channels.empty()) addMoments(character.skeleton, motion, std::clamp(steps, 1, kMostMoments), moments);
  return moments;
}

std::vector<Pose> detailPoses(const Character& character, const Rig& rig, const RigPoser& poser,
                              const std::vector<Pose>& moments) {
  std::vector<Pose> out{bindPose(character.skeleton)};
  if (rig.primitives.empty()) return out;
  if (!rig.lines.empty()) {
    out.push_back(out.front());
    out.back().flex = 1.0f;
  }
  FeatureReader reader(character, rig, poser);
  std::vector<Features> features;
  for (const Pose& moment : moments) features.push_back(reader.read(moment));
  std::vector<double> apart(moments.size(), 1e30);
  const auto keepAway = [&](const Features& from) {
    for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = std::min(apart[i], squaredDifference(features[i], from));
  };
  for (const Pose& pose : out) keepAway(reader.read(pose));
  while (!apart.empty() && static_cast<int>(out.size()) < kMostDetailPoses) {
    const auto next = static_cast<std::size_t>(std::ranges::max_element(apart) - apart.begin());
    if (!(apart[next] > kLeastDifference * kLeastDifference)) break;
    out.push_back(moments[next]);
    keepAway(features[next]);
  }
  return out;
}

}  // namespace sinew
