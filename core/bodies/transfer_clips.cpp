// core/bodies/transfer_clips.cpp: copies channels between equal skeletons and retargets them between others.
#include "core/bodies/transfer_clips.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <glm/geometric.hpp>

#include "core/bodies/body_map.h"
#include "core/bodies/retargeter.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"

namespace sinew {

namespace {

constexpr std::string_view kOuterSeparators = "|:";
constexpr std::string_view kAnySeparator = "|:_-. ";
constexpr std::size_t kFewestWithPrefix = 5;
constexpr float kBoundAlike = 1e-3f;  // Fraction of the size: programs write different last digits.

using Keys = std::vector<std::string>;

Keys wholeNames(const Skeleton& skeleton) {
  Keys keys;
  for (const Bone& bone : skeleton.bones) keys.push_back(bone.name);
  return keys;
}

Keys paths(const Skeleton& skeleton) {
  Keys keys;
  for (const Bone& bone : skeleton.bones) keys.push_back(bone.path);
  return keys;
}

std::string withoutPrefix(std::string name) {
  const std::size_t outer = name.find_last_of(kOuterSeparators);
  if (outer != std::string::npos && outer + 1 < name.size()) name.erase(0, outer + 1);
  std::size_t end = 3;  // 3ds Max: "Bip01 L Thigh", "Bip001_Pelvis".
  if (!lowerCase(name).starts_with("bip")) return name;
  while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) != 0) ++end;
  const bool isBiped = end > 3 && end + 1 < name.size() && (name[end] == ' ' || name[end] == '_');
  return isBiped ? name.substr(end + 1) : name;
}

Keys bareNames(const Skeleton& skeleton) {
  Keys keys;
  for (const Bone& bone : skeleton.bones) keys.push_back(withoutPrefix(bone.name));
  return keys;
}

/// The longest beginning, up to a separator, that four out of five names share.
std::string sharedFront(const Keys& names) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& name : names) {
    for (std::size_t at = name.find_first_of(kAnySeparator); at != std::string::npos && at + 1 < name.size();
         at = name.find_first_of(kAnySeparator, at + 1)) {
      ++counts[name.substr(0, at + 1)];
    }
  }
  std::string longest;
  for (const auto& [front, count] : counts) {
    if (count >= kFewestWithPrefix && 5 * count >= 4 * names.size() && front.size() > longest.size()) longest = front;
  }
  return longest;
}

/// Letters and digits in lower case; characters beyond ASCII count as letters.
Keys shortNames(const Skeleton& skeleton) {
  Keys keys = bareNames(skeleton);
  const std::string front = sharedFront(keys);
  for (std::string& key : keys) {
    if (key.size() > front.size() && key.starts_with(front)) key.erase(0, front.size());
    std::erase_if(key, [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte < 0x80 && std::isalnum(byte) == 0;
    });
    key = lowerCase(key);
  }
  return keys;
}

class BoneMatcher {
 public:
  BoneMatcher(std::size_t from, std::size_t to) : partner_(to, -1), taken_(from, false) {}

  void match(const Keys& from, const Keys& to) {
    const auto ours = uniqueKeys(to, [&](std::size_t bone) { return partner_[bone] >= 0; });
    const auto theirs = uniqueKeys(from, [&](std::size_t bone) { return taken_[bone]; });
    for (const auto& [key, bone] : ours) {
      const auto other = theirs.find(key);
      if (bone >= 0 && other != theirs.end() && other->second >= 0) pair(bone, other->second);
    }
  }

  void match(const BodySlots& from, const BodySlots& to) {
    for (const BodySlot slot : allBodySlots()) {
      const int ours = to[slot].bone;
      const int theirs = from[slot].bone;
      if (ours >= 0 && theirs >= 0 && at(partner_, ours) < 0 && !at(taken_, theirs)) pair(ours, theirs);
    }
  }

  [[nodiscard]] std::vector<int> take() && { return std::move(partner_); }

 private:
  /// -1 where several bones share a key.
  template <class Skip>
  static std::map<std::string_view, int> uniqueKeys(const Keys& keys, Skip skip) {
    std::map<std::string_view, int> unique;
    for (std::size_t bone = 0; bone < keys.size(); ++bone) {
      if (keys[bone].empty() || skip(bone)) continue;
      const auto [known, isNew] = unique.emplace(keys[bone], static_cast<int>(bone));
      if (!isNew) known->second = -1;
    }
    return unique;
  }

  void pair(int ours, int theirs) {
    at(partner_, ours) = theirs;
    at(taken_, theirs) = true;
  }

  std::vector<int> partner_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<int> matchBones(const Skeleton& from, const BodySlots& fromSlots, const Skeleton& to,
                            const BodySlots& toSlots) {
  BoneMatcher matcher(from.bones.size(), to.bones.size());
  for (const auto keysOf : std::array<Keys (*)(const Skeleton&), 4>{wholeNames, paths, bareNames, shortNames}) {
    matcher.match(keysOf(from), keysOf(to));
  }
  matcher.match(fromSlots, toSlots);
  return std::move(matcher).take();
}

bool haveSameBones(const Skeleton& a, const Skeleton& b, float size) {
  if (a.bones.size() != b.bones.size()) return false;
  std::map<std::string_view, const Bone*> places;
  for (const Bone& bone : b.bones) places.emplace(bone.path, &bone);
  return std::ranges::all_of(a.bones, [&](const Bone& bone) {
    const auto found = places.find(bone.path);
    if (found == places.end()) return false;
    const glm::mat4& other = found->second->bindInWorld;
    for (int column = 0; column < 4; ++column) {
      const float scale = column < 3 ? glm::length(other[column]) : size;
      if (!(glm::length(bone.bindInWorld[column] - other[column]) <= kBoundAlike * scale)) return false;
    }
    return true;
  });
}

namespace {

constexpr float kSamePose = 1e-5f;          ///< Relative difference of nodes and bind poses.
constexpr double kMostSamplesOfFile = 5e7;  ///< Nodes times samples, over all clips of a file.
constexpr std::size_t kMostNamed = 12;      ///< Bones listed in a note.

// The same skeleton ---------------------------------------------------------------------------------------------------

bool isNear(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(a - b) <= kSamePose * std::max({glm::length(a), glm::length(b), 1e-20f});
}

bool isNear(const glm::mat4& a, const glm::mat4& b, float size) {
  for (int column = 0; column < 4; ++column) {
    const float allowed = kSamePose * (column < 3 ? std::max(glm::length(a[column]), glm::length(b[column])) : size);
    if (!(glm::length(a[column] - b[column]) <= allowed)) return false;
  }
  return true;
}

bool isSameRest(const LocalTransform& a, const LocalTransform& b) {
  if (a.matrix.has_value() != b.matrix.has_value()) return false;
  if (a.matrix) return isNear(*a.matrix, *b.matrix, glm::length((*a.matrix)[3]));
  const bool sameTurn =
      std::min(glm::length(a.rotation - b.rotation), glm::length(a.rotation + b.rotation)) <= kSamePose;
  const bool bothHere = glm::length(a.translation) + glm::length(b.translation) == 0.0f;
  return sameTurn && (bothHere || isNear(a.translation, b.translation)) && isNear(a.scale, b.scale);
}

/// [nodes] Paths of names from the root; siblings of the same name are numbered.
std::vector<std::string> nodePaths(const Skeleton& skeleton) {
  std::vector<std::string> paths;
  std::map<std::string, int> seen;
  for (const Node& node : skeleton.nodes) {
    std::string path = (node.parent < 0 ? std::string() : at(paths, node.parent)) + '/' + node.name;
    if (const int number = seen[path]++; number > 0) path += '#' + std::to_string(number);
    paths.push_back(std::move(path));
  }
  return paths;
}

/// [nodes of from] Node of `to` with the same path and rest transform, also of all nodes above; or -1.
std::vector<int> sameNodes(const Skeleton& from, const Skeleton& to) {
  std::map<std::string, int> places;
  const std::vector<std::string> ours = nodePaths(to);
  for (std::size_t i = 0; i < ours.size(); ++i) places.emplace(ours[i], static_cast<int>(i));
  const std::vector<std::string> theirs = nodePaths(from);
  std::vector<int> same(theirs.size(), -1);
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    const Node& node = from.nodes[i];
    const auto found = places.find(theirs[i]);
    if (found == places.end() || (node.parent >= 0 && at(same, node.parent) < 0)) continue;
    if (isSameRest(node.rest, at(to.nodes, found->second).rest)) same[i] = found->second;
  }
  return same;
}

/// True for a file without a mesh: its bind pose is only how its nodes rest.
bool isBoundAlike(const Character& from, const Character& to, const std::vector<int>& same) {
  if (from.mesh.triangles.empty()) return true;
  std::map<int, int> boneOfNode;
  for (std::size_t i = 0; i < to.skeleton.bones.size(); ++i) {
    boneOfNode[to.skeleton.bones[i].node] = static_cast<int>(i);
  }
  return std::ranges::all_of(from.skeleton.bones, [&](const Bone& bone) {
    const auto ours = boneOfNode.find(at(same, bone.node));
    if (ours == boneOfNode.end()) return true;
    return isNear(bone.bindInWorld, at(to.skeleton.bones, ours->second).bindInWorld, to.height);
  });
}

std::optional<std::vector<Channel>> copied(const AnimationClip& clip, const std::vector<int>& same) {
  std::vector<Channel> channels = clip.channels;
  for (Channel& channel : channels) {
    channel.node = at(same, channel.node);
    if (channel.node < 0) return std::nullopt;
  }
  return channels;
}

// Morph targets -------------------------------------------------------------------------------------------------------

/// Consecutive targets of one node.
struct TargetRun {
  int first = 0;
  int count = 0;
};

std::vector<TargetRun> runsOf(const std::vector<MorphTarget>& targets) {
  std::vector<TargetRun> runs;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i == 0 || targets[i].node != targets[i - 1].node) runs.push_back({static_cast<int>(i), 0});
    ++runs.back().count;
  }
  return runs;
}

MorphChannel weightsOf(const MorphChannel& from, const std::vector<int>& source, const TargetRun& run,
                       const std::vector<MorphTarget>& targets) {
  MorphChannel made{run.first, run.count, from.interpolation, from.times, {}};
  const std::size_t parts = from.interpolation == Interpolation::kCubicSpline ? 3 : 1;
  const std::size_t width = toIndex(from.targets);
  for (std::size_t row = 0; row < parts * from.times.size(); ++row) {
    const bool isValue = parts == 1 || row % 3 == 1;
    for (int i = 0; i < run.count; ++i) {
      const int other = at(source, i);
      if (other >= 0) made.values.push_back(from.values[row * width + toIndex(other)]);
      else made.values.push_back(isValue ? at(targets, run.first + i).weight : 0.0f);
    }
  }
  return made;
}

/// For each node's targets, the weights of the channel that shares most names with them.
std::vector<MorphChannel> morphsOf(const AnimationClip& clip, const Character& from, const Character& to) {
  std::vector<MorphChannel> made;
  for (const TargetRun& run : runsOf(to.morphTargets)) {
    int most = 0;
    std::optional<MorphChannel> best;
    for (const MorphChannel& channel : clip.morphChannels) {
      std::map<std::string, int> places;
      for (int i = 0; i < channel.targets; ++i) {
        places.emplace(at(from.morphTargets, channel.firstTarget + i).name, i);
      }
      std::vector<int> source(toIndex(run.count), -1);
      int shared = 0;
      for (int i = 0; i < run.count; ++i) {
        const auto found = places.find(at(to.morphTargets, run.first + i).name);
        if (found == places.end()) continue;
        at(source, i) = found->second;
        ++shared;
      }
      if (shared > most) best = weightsOf(channel, source, run, to.morphTargets);
      most = std::max(most, shared);
    }
    if (best) made.push_back(std::move(*best));
  }
  return made;
}

// Unmatched bones -----------------------------------------------------------------------------------------------------

std::string counted(std::size_t count, const std::string& one, const std::string& more) {
  return std::to_string(count) + ' ' + (count == 1 ? one : more);
}

std::string named(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > kMostNamed) text += " and " + std::to_string(names.size() - kMostNamed) + " more";
  return text;
}

/// Notes bones that a clip moves and no bone of the character follows, nor any bone below them.
void noteLost(const Character& from, const std::vector<int>& partner, TransferredClips& result) {
  const std::vector<Bone>& bones = from.skeleton.bones;
  std::vector<bool> carries(bones.size(), false);
  for (const int bone : partner) {
    for (int above = bone; above >= 0 && !at(carries, above); above = at(bones, above).parent)
      at(carries, above) = true;
  }
  std::set<int> moved;
  for (const AnimationClip& clip : from.clips) {
    for (const Channel& channel : clip.channels) moved.insert(channel.node);
  }
  std::vector<std::string>& lost = result.unmatched;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    if (!carries[i] && moved.contains(bones[i].node)) lost.push_back(bones[i].name);
  }
  if (lost.empty()) return;
  result.notes.push_back(counted(lost.size(), "bone of the clips has", "bones of the clips have") +
                         " no partner in the character and " + (lost.size() == 1 ? "is" : "are") +
                         " left out: " + named(lost));
}

/// Notes body parts that no bone of the clips moves.
void noteStill(const Character& to, const BodySlots& slots, const std::vector<int>& partner, TransferredClips& result) {
  std::vector<std::string>& still = result.unmoved;
  std::set<int> told;
  for (const SlotBone& slot : slots.bones) {
    if (slot.bone < 0 || at(partner, slot.bone) >= 0 || !told.insert(slot.bone).second) continue;
    still.push_back(at(to.skeleton.bones, slot.bone).name);
  }
  if (still.empty()) return;
  result.notes.push_back(counted(still.size(), "bone of the character has", "bones of the character have") +
                         " no partner in the clips and " + (still.size() == 1 ? "stays" : "stay") +
                         " with the bone above: " + named(still));
}

// All together --------------------------------------------------------------------------------------------------------

/// In a skeleton without skin all bones count.
BodySlots slotsOf(const Character& character, std::span<const SlotCorrection> corrections) {
  const MirrorPlan plan = makeMirrorPlan(character);
  if (!character.mesh.triangles.empty()) return bodySlots(character, plan, corrections);
  SlotHints hints;
  hints.twinOf = plan.twinOf;
  hints.planeNormal = glm::vec3(plan.plane.normal);
  return findBodySlots(character.skeleton, hints);
}

std::string freeName(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int number = 2; !taken.insert(name).second; ++number) name = wanted + ' ' + std::to_string(number);
  return name;
}

/// Made on first use: a file with the same skeleton needs none.
class Transfer {
 public:
  Transfer(const Character& from, const Character& to, std::span<const SlotCorrection> corrections)
      : fromSlots_(slotsOf(from, {})),
        toSlots_(slotsOf(to, corrections)),
        partner_(matchBones(from.skeleton, fromSlots_, to.skeleton, toSlots_)),
        bodies_{from.skeleton, to.skeleton, fromSlots_, toSlots_, partner_},
        stance_(findCommonStance(bodies_)) {}
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;

  [[nodiscard]] bool matchesNothing() const {
    return std::ranges::all_of(partner_, [](int bone) { return bone < 0; });
  }

  const BodySlots fromSlots_;
  const BodySlots toSlots_;
  const std::vector<int> partner_;
  const ClipBodies bodies_;
  const CommonStance stance_;
};

}  // namespace

TransferredClips transferClips(const Character& from, const Character& to, std::span<const SlotCorrection> corrections,
                               const std::string& file) {
  TransferredClips result;
  std::set<std::string> taken;
  for (const AnimationClip& clip : to.clips) taken.insert(clip.name);
  const std::vector<int> same = sameNodes(from.skeleton, to.skeleton);
  const bool alike = isBoundAlike(from, to, same);
  std::optional<Transfer> transfer;
  double budget = kMostSamplesOfFile;
  for (const AnimationClip& clip : from.clips) {
    AnimationClip made;
    made.addedFrom = file;
    std::optional<std::vector<Channel>> channels = alike ? copied(clip, same) : std::nullopt;
    if (!channels) {
      if (!transfer) transfer.emplace(from, to, corrections);
      if (budget >= 0.0) channels = retargetedChannels(transfer->bodies_, transfer->stance_, clip, budget);
      if (budget < 0.0) {
        result.notes.push_back("clip \"" + clip.name + "\" is left out: it has too many keys to be transferred");
        continue;
      }
    }
    made.channels = std::move(*channels);
    made.morphChannels = morphsOf(clip, from, to);
    if (made.channels.empty() && made.morphChannels.empty()) {
      result.notes.push_back("clip \"" + clip.name + "\" is left out: it moves nothing of the character");
      continue;
    }
    made.duration = clip.duration;
    made.name = freeName(clip.name, taken);
    if (made.name != clip.name) {
      result.notes.push_back("clip \"" + clip.name + "\" is called \"" + made.name + "\": there is one of that name");
    }
    result.clips.push_back(std::move(made));
  }
  if (!transfer) return result;
  if (transfer->matchesNothing()) {
    result.notes.emplace_back("no bone of the clips is a bone of the character, by name or by its part of the body");
    return result;
  }
  noteLost(from, transfer->partner_, result);
  noteStill(to, transfer->toSlots_, transfer->partner_, result);
  return result;
}

}  // namespace sinew
