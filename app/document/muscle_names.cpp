// app/document/muscle_names.cpp: whether a name is the default one is read from the name.

#include "app/document/muscle_names.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string_view>

#include "app/document/shown_names.h"
#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

/// "", " 2", " L", " R 3": what makes a default name free, and what tells twins apart.
bool isAppended(std::string_view rest) {
  if (rest.starts_with(" L") || rest.starts_with(" R")) rest.remove_prefix(2);
  if (rest.empty()) return true;
  if (rest.size() < 2 || rest.front() != ' ') return false;
  rest.remove_prefix(1);
  return std::ranges::all_of(rest, [](char c) { return c >= '0' && c <= '9'; });
}

bool hasDefaultName(const Primitive& primitive, const Skeleton& skeleton) {
  const std::optional<int> bone = skeleton.findBone(primitive.bone);
  if (!bone) return false;
  const std::string name = defaultMuscleName(skeleton, *bone);
  return primitive.name.starts_with(name) && isAppended(std::string_view(primitive.name).substr(name.size()));
}

/// Where the bone's name has no side, twins tell theirs.
std::string wantedName(const Primitive& primitive, const Skeleton& skeleton) {
  std::string name = defaultMuscleName(skeleton, *skeleton.findBone(primitive.bone));
  const std::optional<Side> side = sideNamed(primitive.name);
  if (primitive.mirror.empty() || !side || sideNamed(name)) return name;
  return name + (*side == Side::kLeft ? " L" : " R");
}

Rig renamed(Rig rig, int index, const std::string& name) {
  Result<Rig> done = renamePrimitive(rig, index, name);
  return done ? std::move(done).value() : std::move(rig);
}

}  // namespace

std::string namedMuscles(const Rig& rig, std::span<const int> indices) {
  if (indices.size() == 1) return at(rig.primitives, indices.front()).name;
  return std::to_string(indices.size()) + " muscles";
}

std::string defaultMuscleName(const Skeleton& skeleton, int bone) {
  return shortBoneNames(skeleton)[static_cast<std::size_t>(bone)] + " muscle";
}

Rig withDefaultNames(const Rig& before, Rig after, const Skeleton& skeleton) {
  assert(before.primitives.size() == after.primitives.size());
  for (int i = 0; i < static_cast<int>(after.primitives.size()); ++i) {
    const Primitive& was = at(before.primitives, i);
    const Primitive& is = at(after.primitives, i);
    if (was.bone == is.bone || was.name != is.name || !skeleton.findBone(is.bone)) continue;
    if (!hasDefaultName(was, skeleton)) continue;
    const int twin = twinOf(after, i);
    const bool twinFollows = twin >= 0 && mirroredName(is.name) == at(after.primitives, twin).name;
    const std::string name = freePrimitiveName(after, wantedName(is, skeleton));
    after = renamed(std::move(after), i, name);
    if (twinFollows) after = renamed(std::move(after), twin, twinName(after, name));
  }
  return after;
}

}  // namespace sinew::app
