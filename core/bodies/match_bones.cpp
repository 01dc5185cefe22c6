// core/bodies/match_bones.cpp: by names as they stand, by shorter and shorter ones, by parts of the body.
#include "core/bodies/match_bones.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <string_view>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/lower_case.h"

namespace sinew {
namespace {

constexpr std::string_view kOuterSeparators = "|:";
constexpr std::string_view kAnySeparator = "|:_-. ";
constexpr std::size_t kFewestWithPrefix = 5;
constexpr float kBoundAlike = 1e-3f;  // Of the size: files of several programs differ in the last digits.

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
  // 3ds Max: "Bip01 L Thigh", "Bip001_Pelvis".
  std::size_t end = 3;
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

/// The longest part in front, up to a separator, that four of five names share.
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

/// Letters and digits in lower case; what is no ASCII counts as letters.
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
  /// -1 where several bones have it.
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

}  // namespace sinew
