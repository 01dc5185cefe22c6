// core/character/bones_between.cpp: up to the nearest common ancestor, and down again.
#include "core/character/bones_between.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {

std::vector<int> bonesBetween(const Skeleton& skeleton, int from, int to) {
  const auto upFrom = [&](int bone) {
    std::vector<int> chain;
    for (; bone >= 0; bone = at(skeleton.bones, bone).parent) chain.push_back(bone);
    return chain;
  };
  std::vector<int> a = upFrom(from);
  std::vector<int> b = upFrom(to);
  // Ancestors that both have lie between them no longer, but for the nearest.
  while (a.size() > 1 && b.size() > 1 && a[a.size() - 2] == b[b.size() - 2]) {
    a.pop_back();
    b.pop_back();
  }
  const bool sameTree = a.back() == b.back();
  std::vector<int> bones = sameTree ? a : std::vector{from};
  if (sameTree) {
    bones.insert(bones.end(), b.begin(), b.end());
  } else {
    bones.push_back(to);
  }
  std::ranges::sort(bones);
  bones.erase(std::unique(bones.begin(), bones.end()), bones.end());
  return bones;
}

}  // namespace sinew
