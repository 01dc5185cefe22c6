// app/document/visibility.cpp: marks of muscles and bones, and their effect.
#include "app/document/visibility.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "app/document/listed_muscles.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

template <class Key>
void mark(std::set<Key>& keys, const Key& key, bool on) {
  if (on) keys.insert(key);
  else keys.erase(key);
}

/// [bones] It or a bone above carries the mark.
std::vector<bool> inherited(const std::set<std::string>& marked, const Skeleton& skeleton) {
  std::vector<bool> result(skeleton.bones.size(), false);
  if (marked.empty()) return result;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const Bone& bone = skeleton.bones[b];
    const bool above = bone.parent >= 0 && at(result, bone.parent);
    result[b] = above || marked.contains(bone.path);
  }
  return result;
}

bool holds(const std::vector<bool>& ofBones, int bone) { return bone >= 0 && at(ofBones, bone); }

}  // namespace

Visibility::Marks& Visibility::marks(Mark mark) {
  return mark == Mark::kHidden ? hidden : (mark == Mark::kLocked ? locked : solo);
}

const Visibility::Marks& Visibility::marks(Mark mark) const {
  return mark == Mark::kHidden ? hidden : (mark == Mark::kLocked ? locked : solo);
}

void Visibility::setMuscle(Mark which, PrimitiveId muscle, bool on) { mark(marks(which).muscles, muscle, on); }

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
    const int bone = unique ? named->second : (placed != byPath.end() ? placed->second : -1);
    const MuscleLine* line = lineOf(rig, primitive);
    bones.push_back(!line || hasBones(*line, skeleton) ? bone : -1);
  }
  return bones;
}

EffectiveVisibility effectiveVisibility(const Visibility& visibility, const Rig& rig, const Skeleton& skeleton,
                                        const std::vector<int>& boneOf) {
  EffectiveVisibility effective;
  effective.boneHidden = inherited(visibility.hidden.bones, skeleton);
  effective.boneLocked = inherited(visibility.locked.bones, skeleton);
  const std::vector<bool> soloBones = inherited(visibility.solo.bones, skeleton);
  // Ignores marks of muscles that undo removed.
  const auto anyOf = [&rig](const std::set<PrimitiveId>& ids) {
    return std::ranges::any_of(rig.primitives, [&](const Primitive& p) { return ids.contains(p.id()); });
  };
  const bool soloing = !visibility.solo.bones.empty() || anyOf(visibility.solo.muscles);
  const bool isolating = visibility.isolated && anyOf(*visibility.isolated);
  const std::vector<int> listed = listedBones(rig, skeleton, boneOf);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const std::string& sheet = rig.primitives[i].sheet;
    if (i > 0 && !sheet.empty() && rig.primitives[i - 1].sheet == sheet) {
      effective.visible.push_back(effective.visible.back());
      effective.locked.push_back(effective.locked.back());
      continue;
    }
    const PrimitiveId id = rig.primitives[i].id();
    const bool put = visibility.hidden.muscles.contains(id) || holds(effective.boneHidden, listed[i]);
    const bool soloed = !soloing || visibility.solo.muscles.contains(id) || holds(soloBones, listed[i]);
    const bool among = !isolating || visibility.isolated->contains(id);
    effective.visible.push_back(!visibility.bare && !put && soloed && among);
    effective.locked.push_back(visibility.locked.muscles.contains(id) || holds(effective.boneLocked, listed[i]));
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

void welcomeNew(Visibility& visibility, const Rig& rig, const Skeleton& skeleton) {
  const PrimitiveId seen = visibility.newest;
  const std::vector<bool> soloBones = inherited(visibility.solo.bones, skeleton);
  for (const Primitive& primitive : rig.primitives) {
    visibility.newest = std::max(visibility.newest, primitive.id());
    if (primitive.id() <= seen) continue;
    const bool covered = holds(soloBones, skeleton.findBone(primitive.bone).value_or(-1));
    if (!visibility.solo.empty() && !covered) visibility.solo.muscles.insert(primitive.id());
    if (visibility.isolated) visibility.isolated->insert(primitive.id());
  }
}

}  // namespace sinew::app
