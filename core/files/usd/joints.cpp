// core/files/usd/joints.cpp: nodes folded into joints, clips sampled, constant scales taken out.
#include "core/files/usd/joints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/matrix.hpp>

#include "core/files/usd/text.h"
#include "core/geometry/at.h"
#include "sinew/character/node_locals.h"

namespace sinew::usd {
namespace {

using exporting::Trs;
using exporting::trsOf;

/// Relative; what keys of a scale that stands still differ by.
constexpr double kSameScale = 1e-6;

bool isEven(const glm::dvec3& scale) {
  const double slack = kSameScale * std::abs(scale.x);
  return std::abs(scale.y - scale.x) <= slack && std::abs(scale.z - scale.x) <= slack;
}

Trs trsOf(const LocalTransform& local) {
  if (!local.matrix) {
    return {glm::dvec3(local.translation), glm::normalize(glm::dquat(local.rotation)), glm::dvec3(local.scale)};
  }
  glm::dmat4 matrix(*local.matrix);
  const bool mirrors = glm::determinant(glm::dmat3(matrix)) < 0.0;
  if (mirrors) matrix[0] = -matrix[0];
  Trs result = trsOf(matrix);
  if (mirrors) result.scale.x = -result.scale.x;
  return result;
}

/// What stands in a space that scales evenly, in the space above.
Trs fold(const Trs& above, const Trs& below) {
  const double size = above.scale.x;
  return {above.translation + above.rotation * (size * below.translation), above.rotation * below.rotation,
          size * below.scale};
}

class JointMaker {
 public:
  JointMaker(const gltf::BoundSkeleton& bound, std::span<const AnimationClip> clips)
      : skeleton_(bound.skeleton), clips_(clips), jointOfNode_(skeleton_.nodes.size(), -1) {}

  Joints run() && {
    chooseNodes();
    addNodes();
    addBindings();
    checkLength();
    for (const AnimationClip& clip : clips_) sample(clip);
    takeOutScales();
    nameJoints();
    return std::move(result_);
  }

 private:
  void chooseNodes() {
    std::vector<bool> wanted(skeleton_.nodes.size(), false);
    for (std::size_t node = 0; node < wanted.size(); ++node) {
      wanted[node] = !isEven(trsOf(skeleton_.nodes[node].rest).scale);
    }
    for (const AnimationClip& clip : clips_) {
      for (const Channel& channel : clip.channels) {
        if (channel.path != ChannelPath::kScale) continue;
        const auto scales = [](const glm::vec4& value) { return !isEven(glm::dvec3(value)); };
        if (std::ranges::any_of(channel.values, scales)) wanted[toIndex(channel.node)] = true;
      }
    }
    for (const Bone& bone : skeleton_.bones) wanted[toIndex(bone.node)] = true;
    std::vector<bool> below(wanted.size(), false);  // Whether a node above is a joint.
    int roots = 0;
    for (std::size_t node = 0; node < wanted.size(); ++node) {
      const int parent = skeleton_.nodes[node].parent;
      below[node] = parent >= 0 && (below[toIndex(parent)] || wanted[toIndex(parent)]);
      roots += wanted[node] && !below[node] ? 1 : 0;
      if (wanted[node]) nodes_.push_back(static_cast<int>(node));
    }
    // Readers want one root.
    if (roots != 1) result_.joints.push_back({.name = "root"});
  }

  void addNodes() {
    hasRoot_ = !result_.joints.empty();
    for (const int node : nodes_) {
      at(jointOfNode_, node) = static_cast<int>(result_.joints.size());
      int above = at(skeleton_.nodes, node).parent;
      while (above >= 0 && at(jointOfNode_, above) < 0) above = at(skeleton_.nodes, above).parent;
      const int parent = above >= 0 ? at(jointOfNode_, above) : hasRoot_ ? 0 : -1;
      result_.joints.push_back({.name = at(skeleton_.nodes, node).name, .parent = parent});
    }
    for (const Bone& bone : skeleton_.bones) at(result_.joints, at(jointOfNode_, bone.node)).name = bone.name;
    const std::vector<Trs> rest = localsFrom(restLocals(skeleton_));
    for (std::size_t j = 0; j < result_.joints.size(); ++j) {
      Joint& joint = result_.joints[j];
      joint.rest = rest[j];
      joint.bind = joint.rest.toMatrix();
      if (joint.parent >= 0) joint.bind = at(result_.joints, joint.parent).bind * joint.bind;
    }
  }

  void addBindings() {
    std::vector<bool> isBound(skeleton_.bones.size(), false);
    for (const Binding& binding : skeleton_.bindings) {
      const int joint = at(jointOfNode_, at(skeleton_.bones, binding.bone).node);
      int own = joint;
      if (isBound[toIndex(binding.bone)]) {
        own = static_cast<int>(result_.joints.size());
        result_.joints.push_back({.name = at(result_.joints, joint).name, .parent = joint});
      }
      isBound[toIndex(binding.bone)] = true;
      at(result_.joints, own).bind = glm::inverse(glm::dmat4(binding.inverseBind));
      result_.ofBinding.push_back(own);
    }
  }

  void checkLength() const {
    double samples = 0.0;
    for (const AnimationClip& clip : clips_) {
      samples +=
          static_cast<double>(result_.joints.size()) * (static_cast<double>(clip.duration) * kFramesPerSecond + 2);
    }
    if (samples > kMostSamples) {
      gltf::refuse("animations", "too long for .usda: " + std::to_string(static_cast<long long>(samples)) +
                                     " joints in frames, at most " +
                                     std::to_string(static_cast<long long>(kMostSamples)));
    }
  }

  /// [joints] of [nodes].
  [[nodiscard]] std::vector<Trs> localsFrom(const std::vector<LocalTransform>& nodes) const {
    std::vector<Trs> locals;
    locals.reserve(result_.joints.size());
    if (hasRoot_) locals.emplace_back();
    for (const int node : nodes_) {
      Trs local = trsOf(at(nodes, node));
      int above = at(skeleton_.nodes, node).parent;
      for (; above >= 0 && at(jointOfNode_, above) < 0; above = at(skeleton_.nodes, above).parent) {
        local = fold(trsOf(at(nodes, above)), local);
      }
      locals.push_back(local);
    }
    locals.resize(result_.joints.size());  // Those of further bindings stand in their bones.
    return locals;
  }

  void sample(const AnimationClip& clip) {
    SampledClip& made = result_.clips.emplace_back();
    made.name = clip.name;
    made.frames = framesOf(clip);
    for (const double frame : made.frames) {
      const auto time = std::min(static_cast<float>(frame / kFramesPerSecond), clip.duration);
      made.locals.push_back(localsFrom(sampleLocals(skeleton_, clip, time)));
      turnShortWays(made.locals);
    }
  }

  static void turnShortWays(std::vector<std::vector<Trs>>& frames) {
    if (frames.size() < 2) return;
    const std::vector<Trs>& before = frames[frames.size() - 2];
    for (std::size_t j = 0; j < before.size(); ++j) {
      glm::dquat& now = frames.back()[j].rotation;
      if (glm::dot(before[j].rotation, now) < 0.0) now = -now;
    }
  }

  /// Calls visit(Trs&) for the rest pose and all moments.
  template <class Visit>
  void eachLocal(std::size_t joint, const Visit& visit) {
    visit(result_.joints[joint].rest);
    for (SampledClip& clip : result_.clips) {
      for (std::vector<Trs>& locals : clip.locals) visit(locals[joint]);
    }
  }

  /// The joint's space becomes `size` times as large; what hangs on it counts in the new lengths.
  void takeOutScales() {
    std::vector<double> sizes(result_.joints.size(), 1.0);
    for (std::size_t j = 0; j < sizes.size(); ++j) {
      Joint& joint = result_.joints[j];
      const double above = joint.parent < 0 ? 1.0 : at(sizes, joint.parent);
      const double scale = joint.rest.scale.x;
      bool stays = scale > 0.0;
      eachLocal(j, [&](const Trs& local) {
        stays = stays && isEven(local.scale) && std::abs(local.scale.x - scale) <= kSameScale * scale;
      });
      sizes[j] = stays ? above * scale : above;
      eachLocal(j, [&](Trs& local) {
        local.translation *= above;
        if (stays) local.scale = glm::dvec3(1.0);
      });
      for (int axis = 0; axis < 3; ++axis) joint.bind[axis] /= sizes[j];
    }
  }

  void nameJoints() {
    Siblings names;
    std::map<int, Siblings> siblings;  // by parent
    for (Joint& joint : result_.joints) {
      const std::string own = siblings[joint.parent].fresh(identifierOf(joint.name, "joint"));
      joint.path = joint.parent < 0 ? own : at(result_.joints, joint.parent).path + '/' + own;
      joint.name = names.fresh(joint.name.empty() ? "joint" : joint.name, " ");
    }
  }

  const Skeleton& skeleton_;
  std::span<const AnimationClip> clips_;
  std::vector<int> jointOfNode_;
  std::vector<int> nodes_;  // those that are joints
  bool hasRoot_ = false;    // besides them
  Joints result_;
};

}  // namespace

std::vector<double> framesOf(const AnimationClip& clip) {
  constexpr double kSameFrame = 1e-3;
  const double end = static_cast<double>(clip.duration) * kFramesPerSecond;
  std::vector<double> frames;
  for (double frame = 0.0; frame <= end; frame += 1.0) frames.push_back(frame);
  if (frames.empty()) return {0.0};
  if (end - frames.back() > kSameFrame) frames.push_back(end);
  return frames;
}

Joints jointsOf(const gltf::BoundSkeleton& bound, std::span<const AnimationClip> clips) {
  return JointMaker(bound, clips).run();
}

}  // namespace sinew::usd
