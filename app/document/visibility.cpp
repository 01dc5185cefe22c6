// app/document/visibility.cpp: which muscles the editor shows, moves and lets be picked.

#include "app/document/visibility.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace sinew::app {
namespace {

void mark(std::set<std::string>& names, const std::string& name, bool on) {
  if (on) {
    names.insert(name);
  } else {
    names.erase(name);
  }
}

/// The muscle takes its mark along, and leaves none behind for another of the old name.
void rename(std::set<std::string>& names, const std::string& from, const std::string& to) {
  if (names.erase(from) > 0) names.insert(to);
}

/// For every bone: it or one above it carries the mark.
std::vector<bool> inherited(const std::set<std::string>& marked, const Skeleton& skeleton) {
  std::vector<bool> result(skeleton.bones.size(), false);
  if (marked.empty()) return result;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const Bone& bone = skeleton.bones[b];
    const bool above = bone.parent >= 0 && result[static_cast<std::size_t>(bone.parent)];
    result[b] = above || marked.contains(bone.path);
  }
  return result;
}

bool holds(const std::vector<bool>& ofBones, int bone) { return bone >= 0 && ofBones[static_cast<std::size_t>(bone)]; }

/// Muscles may be renamed by hand in one step only where nothing else came or went.
void followRenames(Visibility& visibility, const Rig& before, const Rig& after) {
  for (std::size_t i = 0; i < after.primitives.size(); ++i) {
    const std::string& from = before.primitives[i].name;
    const std::string& to = after.primitives[i].name;
    if (from == to || findPrimitive(before, to) >= 0 || findPrimitive(after, from) >= 0) continue;
    for (const Mark which : {Mark::kHidden, Mark::kLocked, Mark::kSolo}) {
      rename(visibility.marks(which).muscles, from, to);
    }
    if (visibility.isolated) rename(*visibility.isolated, from, to);
  }
}

void welcomeNew(Visibility& visibility, const Rig& before, const Rig& after) {
  std::unordered_set<std::string_view> known;
  for (const Primitive& primitive : before.primitives) known.insert(primitive.name);
  for (const Primitive& primitive : after.primitives) {
    if (known.contains(primitive.name)) continue;
    visibility.hidden.muscles.erase(primitive.name);
    visibility.locked.muscles.erase(primitive.name);
    // What is made while others are put away is what one works on.
    mark(visibility.solo.muscles, primitive.name, !visibility.solo.empty());
    if (visibility.isolated) visibility.isolated->insert(primitive.name);
  }
}

}  // namespace

Visibility::Marks& Visibility::marks(Mark mark) {
  return mark == Mark::kHidden ? hidden : (mark == Mark::kLocked ? locked : solo);
}

const Visibility::Marks& Visibility::marks(Mark mark) const {
  return mark == Mark::kHidden ? hidden : (mark == Mark::kLocked ? locked : solo);
}

void Visibility::setMuscle(Mark which, const std::string& muscle, bool on) { mark(marks(which).muscles, muscle, on); }

void Visibility::setBone(Mark which, const std::string& bonePath, bool on) { mark(marks(which).bones, bonePath, on); }

bool Visibility::plain() const { return hidden.empty() && locked.empty() && solo.empty() && !isolated && !bare; }

std::vector<int> boneOfEach(const Rig& rig, const Skeleton& skeleton) {
  constexpr int kAmbiguous = -2;
  std::unordered_map<std::string_view, int> byName;
  std::unordered_map<std::string_view, int> byPath;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const auto [known, isNew] = byName.emplace(skeleton.bones[b].name, static_cast<int>(b));
    if (!isNew) known->second = kAmbiguous;
    byPath.emplace(skeleton.bones[b].path, static_cast<int>(b));
  }
  std::vector<int> bones;
  bones.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    const auto named = byName.find(primitive.bone);
    const auto placed = byPath.find(primitive.bone);
    const bool unique = named != byName.end() && named->second != kAmbiguous;
    bones.push_back(unique ? named->second : (placed != byPath.end() ? placed->second : -1));
  }
  return bones;
}

EffectiveVisibility effectiveVisibility(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton,
                                        const std::vector<int>& boneOf) {
  EffectiveVisibility effective;
  effective.boneHidden = inherited(visibility.hidden.bones, skeleton);
  effective.boneLocked = inherited(visibility.locked.bones, skeleton);
  const std::vector<bool> soloBones = inherited(visibility.solo.bones, skeleton);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const std::string& name = rig.primitives[i].name;
    const bool put = visibility.hidden.muscles.contains(name) || holds(effective.boneHidden, boneOf[i]);
    const bool soloed =
        visibility.solo.empty() || visibility.solo.muscles.contains(name) || holds(soloBones, boneOf[i]);
    const bool among = !visibility.isolated || visibility.isolated->contains(name);
    effective.visible.push_back(!visibility.bare && !put && soloed && among);
    effective.locked.push_back(visibility.locked.muscles.contains(name) || holds(effective.boneLocked, boneOf[i]));
  }
  return effective;
}

std::vector<int> hiddenPrimitives(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton) {
  std::vector<int> hidden;
  if (visibility.plain()) return hidden;
  const EffectiveVisibility effective = effectiveVisibility(visibility, rig, skeleton, boneOfEach(rig, skeleton));
  for (std::size_t i = 0; i < effective.visible.size(); ++i) {
    if (!effective.visible[i]) hidden.push_back(static_cast<int>(i));
  }
  return hidden;
}

bool isPickable(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton, int primitive) {
  if (visibility.plain()) return true;
  const EffectiveVisibility effective = effectiveVisibility(visibility, rig, skeleton, boneOfEach(rig, skeleton));
  const auto index = static_cast<std::size_t>(primitive);
  return effective.visible[index] && !effective.locked[index];
}

void followRig(Visibility& visibility, const Rig& before, const Rig& after, bool travelled) {
  if (visibility.plain()) return;
  if (before.primitives.size() == after.primitives.size()) {
    followRenames(visibility, before, after);
  } else if (!travelled) {
    welcomeNew(visibility, before, after);
  }
}

}  // namespace sinew::app
