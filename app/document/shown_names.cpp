// app/document/shown_names.cpp: default names, and names without what all of them share.
#include "app/document/shown_names.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/ui/code_points.h"
#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

namespace {

/// "", " 2", " L", " R 3": endings that make default names unique.
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

/// Twins get a side if the bone's name has none.
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

std::string withCount(std::size_t count, const char* one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

std::string namedMuscles(const Rig& rig, std::span<const int> indices) {
  const std::vector<int> leads = leadsOf(rig, indices);
  return leads.size() == 1 ? muscleName(rig, leads.front()) : withCount(leads.size(), "muscle");
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

namespace {

constexpr std::string_view kOuter = "|:/";             ///< Between the parts of a path; inside no name.
constexpr std::string_view kInner = "_-. ";            ///< Also between the words of one name.
constexpr std::string_view kBaseLayer = "|baselayer";  ///< Appended by exporters to clips of layered animations.

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c & 0x80) != 0; }

std::size_t sharedLength(std::string_view name, std::string_view other) {
  return static_cast<std::size_t>(std::ranges::mismatch(name, other).in1 - name.begin());
}

/// The prefix without its separator: a root that gave all others its name.
bool isBarePrefix(std::string_view name, std::string_view prefix) {
  return !prefix.empty() && name == prefix.substr(0, prefix.size() - 1);
}

/// Length of `longest` that all names begin with, or are as a whole.
std::size_t commonPrefix(const std::vector<std::string>& names, const std::string& longest) {
  std::size_t length = longest.size();
  for (const std::string& name : names) {
    const std::size_t shared = sharedLength(std::string_view(longest).substr(0, length), name);
    const bool bare = shared == name.size() && shared < length &&
                      (kOuter.find(longest[shared]) != kOuter.npos || kInner.find(longest[shared]) != kInner.npos);
    length = bare ? shared + 1 : shared;
  }
  return length;
}

/// Each name continues after the prefix, or is only the prefix.
bool goesOn(const std::vector<std::string>& names, std::string_view prefix, bool withLetter) {
  return std::ranges::all_of(names, [&](const std::string& name) {
    if (isBarePrefix(name, prefix)) return true;
    return name.starts_with(prefix) && name.size() > prefix.size() && (!withLetter || isLetter(name[prefix.size()]));
  });
}

/// Each name without prefix and the last `behind` characters ends in a letter or digit, and has a letter.
bool endsInWord(const std::vector<std::string>& names, std::string_view prefix, std::size_t behind) {
  return std::ranges::all_of(names, [&](const std::string& name) {
    const std::size_t front = isBarePrefix(name, prefix) ? 0 : prefix.size();
    if (name.size() <= front + behind) return false;
    const std::string_view left = std::string_view(name).substr(front, name.size() - front - behind);
    return (isLetter(left.back()) || (left.back() >= '0' && left.back() <= '9')) && std::ranges::any_of(left, isLetter);
  });
}

/// The common prefix, with its separator.
std::string prefixOf(const std::vector<std::string>& names) {
  const std::string& longest = *std::ranges::max_element(names, {}, &std::string::size);
  for (std::size_t end = commonPrefix(names, longest); end > 0; --end) {
    const std::string_view prefix = std::string_view(longest).substr(0, end);
    if (kOuter.find(prefix.back()) != kOuter.npos && goesOn(names, prefix, false)) return std::string(prefix);
    const bool inner = kInner.find(prefix.back()) != kInner.npos && names.size() >= kManyNames;
    if (inner && goesOn(names, prefix, true)) return std::string(prefix);
  }
  return {};
}

/// The common suffix from a "|" on; if many share it, from the first separator that leaves words.
std::string suffixOf(const std::vector<std::string>& names, std::string_view prefix) {
  std::string suffix = names.front();
  for (const std::string& name : names) {
    const auto [own, other] = std::mismatch(suffix.rbegin(), suffix.rend(), name.rbegin(), name.rend());
    suffix.erase(suffix.begin(), own.base());
  }
  const std::size_t outer = suffix.find('|');
  if (outer != suffix.npos || names.size() < kManyNames) return outer == suffix.npos ? "" : suffix.substr(outer);
  for (std::size_t from = suffix.find_first_of(kInner); from != suffix.npos;
       from = suffix.find_first_of(kInner, from + 1)) {
    const std::string behind = suffix.substr(from);
    if (behind.size() > 1 && endsInWord(names, prefix, behind.size())) return behind;
  }
  return "";
}

std::string afterLastSeparator(std::string name) {
  std::string small = lowerCase(name);
  std::erase(small, ' ');
  if (small.ends_with(kBaseLayer)) name.resize(name.rfind('|'));
  const std::size_t last = name.find_last_of(kOuter);
  return last == name.npos || last + 1 == name.size() ? name : name.substr(last + 1);
}

std::vector<std::string> eachReadable(std::vector<std::string> names, const char* word) {
  int number = 0;
  for (std::string& name : names) name = readableName(name, word, ++number);
  return names;
}

std::size_t distinct(const std::vector<std::string>& names) {
  return std::set<std::string_view>(names.begin(), names.end()).size();
}

}  // namespace

std::vector<std::string> withoutSharedParts(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  if (distinct(names) == 1) return std::vector(names.size(), afterLastSeparator(names.front()));
  const std::string prefix = prefixOf(names);
  const std::string suffix = suffixOf(names, prefix);
  std::vector<std::string> shown;
  for (const std::string& name : names) {
    const bool whole = isBarePrefix(name, prefix) || name.size() <= prefix.size() + suffix.size();
    shown.push_back(whole ? name : name.substr(prefix.size(), name.size() - prefix.size() - suffix.size()));
  }
  return distinct(shown) == distinct(names) ? shown : names;
}

std::vector<std::string> shortBoneNames(const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const Bone& bone : skeleton.bones) names.push_back(bone.name);
  return withoutSharedParts(names);
}

std::vector<std::string> shownBoneNames(const Skeleton& skeleton) {
  return eachReadable(shortBoneNames(skeleton), "bone");
}

std::vector<std::string> shownFileNames(const Skeleton& skeleton) {
  std::vector<std::string> names = shownBoneNames(skeleton);
  const std::multiset<std::string> all(names.begin(), names.end());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (all.count(names[i]) > 1) names[i] = skeleton.bones[i].path;
  }
  return eachReadable(std::move(names), "bone");
}

std::vector<std::string> shownClipNames(const Character& character) {
  std::vector<std::string> fromFile;
  for (const AnimationClip& clip : character.clips) {
    if (!clip.turnsBindPose && !clip.name.empty()) fromFile.push_back(clip.name);
  }
  const std::vector<std::string> without = withoutSharedParts(fromFile);
  std::vector<std::string> shown;
  std::size_t next = 0;
  for (const AnimationClip& clip : character.clips) {
    if (clip.turnsBindPose) shown.push_back(clip.name);
    else shown.push_back(clip.name.empty() ? "clip " + std::to_string(shown.size() + 1) : without[next++]);
  }
  return eachReadable(std::move(shown), "clip");
}

std::vector<std::string> shownPartNames(const Character& character) {
  std::vector<std::string> names;
  for (const MeshPart& part : character.parts) names.push_back(part.name);
  return eachReadable(withoutSharedParts(names), "part");
}

std::string shownBoneName(const Skeleton& skeleton, int bone) {
  return bone < 0 ? "" : shownBoneNames(skeleton)[static_cast<std::size_t>(bone)];
}

std::string shownBoneName(const Skeleton& skeleton, const std::string& fileName) {
  const std::optional<int> bone = skeleton.findBone(fileName);
  return bone ? shownBoneName(skeleton, *bone) : fileName;
}

}  // namespace sinew::app
