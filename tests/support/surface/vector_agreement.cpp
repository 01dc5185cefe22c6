// tests/support/surface/vector_agreement.cpp: vertex by vertex, pose by pose.

#include "tests/support/surface/vector_agreement.h"

#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

void compare(const Surface& scalar, const Surface& vector, double height, Agreement& out) {
  for (std::size_t v = 0; v < scalar.positions.size(); ++v) {
    const double apart = static_cast<double>(glm::distance(scalar.positions[v], vector.positions[v])) / height;
    out.worst = std::max(out.worst, apart);
    out.far += apart > kAgreement ? 1 : 0;
    out.beyondAim += apart > kAim ? 1 : 0;
    const double turned = static_cast<double>(glm::distance(scalar.normals[v], vector.normals[v]));
    out.worstNormal = std::max(out.worstNormal, turned);
  }
}

}  // namespace

Surface surfaceBy(InstructionSet set, Projected& projected, const Pose& pose) {
  const InstructionSetScope scope(set);
  return projected.at(pose);
}

void addAgreement(const Character& character, const Rig& rig, const std::vector<Pose>& poses, Agreement& out) {
  Projected projected(character, rig);
  for (const Pose& pose : poses) {
    const Surface scalar = surfaceBy(InstructionSet::kScalar, projected, pose);
    const Surface& surface = projected.at(pose);
    EXPECT_TRUE(allFinite(surface.positions));
    EXPECT_TRUE(allUnit(surface.normals));
    out.projected += surface.report.projected;
    out.uncertified += static_cast<int>(projected.uncertified());
    compare(scalar, surface, static_cast<double>(character.height), out);
  }
}

void print(const std::string& what, const Agreement& seen) {
  std::printf("  %-26s %7d projected, %5.2f %% uncertified, worst %.2g H, %d beyond 1e-6 H, normals %.2g\n",
              what.c_str(), seen.projected, 100.0 * seen.uncertifiedShare(), seen.worst, seen.beyondAim,
              seen.worstNormal);
}

}  // namespace sinew::test
