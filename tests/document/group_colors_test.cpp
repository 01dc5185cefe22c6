// tests/document/group_colors_test.cpp: group colors are distinguishable, also with color blindness, and stay with
// their groups.
#include "app/viewport/render/color_scales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "app/document/command_stack.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

/// Oklab (Ottosson 2020) of a linear color.
glm::vec3 oklab(const glm::vec3& c) {
  const auto root = [](float x) { return std::cbrt(std::max(x, 0.0f)); };
  const float l = root(0.4122215f * c.r + 0.5363325f * c.g + 0.0514460f * c.b);
  const float m = root(0.2119035f * c.r + 0.6806995f * c.g + 0.1073970f * c.b);
  const float s = root(0.0883025f * c.r + 0.2817188f * c.g + 0.6299787f * c.b);
  return {0.2104543f * l + 0.7936178f * m - 0.0040720f * s, 1.9779985f * l - 2.4285922f * m + 0.4505937f * s,
          0.0259040f * l + 0.7827718f * m - 0.8086758f * s};
}

/// Rows that map a linear color to its appearance with one kind of cone missing (Machado, Oliveira & Fernandes 2009).
using Eye = std::array<glm::vec3, 3>;
constexpr Eye kNormal{glm::vec3{1, 0, 0}, glm::vec3{0, 1, 0}, glm::vec3{0, 0, 1}};
constexpr Eye kProtan{glm::vec3{0.152286f, 1.052583f, -0.204868f}, glm::vec3{0.114503f, 0.786281f, 0.099216f},
                      glm::vec3{-0.003882f, -0.048116f, 1.051998f}};
constexpr Eye kDeutan{glm::vec3{0.367322f, 0.860646f, -0.227968f}, glm::vec3{0.280085f, 0.672501f, 0.047413f},
                      glm::vec3{-0.011820f, 0.042940f, 0.968881f}};

glm::vec3 seen(const glm::vec3& srgb, const Eye& eye) {
  const glm::vec3 c = toLinear(srgb);
  return oklab(glm::clamp(glm::vec3(glm::dot(eye[0], c), glm::dot(eye[1], c), glm::dot(eye[2], c)), 0.0f, 1.0f));
}

TEST(GroupColors, AreDistinguishableWithColorBlindness) {
  for (const Eye& eye : {kNormal, kProtan, kDeutan}) {
    for (int i = 0; i < kGroupColors; ++i) {
      for (int j = 0; j < i; ++j) {
        EXPECT_GT(glm::distance(seen(groupColor(i), eye), seen(groupColor(j), eye)), 0.095f) << i << ' ' << j;
      }
    }
  }
  for (int i = 0; i < kGroupColors; ++i) {
    EXPECT_GT(glm::distance(seen(groupColor(i), kNormal), seen(kTerritoryColor, kNormal)), 0.12f) << i;
    EXPECT_GT(seen(groupColor(i), kNormal).x, 0.55f) << "too dark for the panels";
  }
}

Rig withGroups(std::initializer_list<const char*> names) {
  Rig rig;
  for (const char* name : names) {
    rig.groups.push_back({name, {}, {}});
    Primitive muscle;
    muscle.name = std::string("on ") + name;
    muscle.bone = "bone";
    muscle.group = name;
    rig.primitives.push_back(muscle);
  }
  return rig;
}

TEST(GroupColors, GroupKeepsItsColorWhenOthersChange) {
  CommandStack commands(withGroups({"a", "b", "c"}));
  const glm::vec3 a = groupColor(commands.rig(), "a"), b = groupColor(commands.rig(), "b");
  const glm::vec3 c = groupColor(commands.rig(), "c");
  EXPECT_EQ(a, groupColor(0)) << "in the file's order, however many muscles there are";
  EXPECT_EQ(c, groupColor(2));
  Rig rig = commands.rig();
  rig.groups.erase(rig.groups.begin());
  rig.primitives.erase(rig.primitives.begin());
  commands.apply("Delete", rig);
  EXPECT_EQ(groupColor(commands.rig(), "b"), b);
  EXPECT_EQ(groupColor(commands.rig(), "c"), c);
  rig = commands.rig();
  rig.groups[0].name = "renamed";
  rig.primitives[0].group = "renamed";
  rig.groups.push_back({"new", {}, {}});
  commands.apply("Rename", rig);
  EXPECT_EQ(groupColor(commands.rig(), "renamed"), b);
  for (const char* other : {"renamed", "c"}) {
    EXPECT_NE(groupColor(commands.rig(), "new"), groupColor(commands.rig(), other));
  }
  commands.undo();
  commands.undo();
  EXPECT_EQ(groupColor(commands.rig(), "a"), a);
}

TEST(GroupColors, RigOutsideADocumentHasTheSameColors) {
  const Rig rig = withGroups({"a", "b", "c"});
  const CommandStack commands(rig);
  for (const char* name : {"a", "b", "c"}) EXPECT_EQ(groupColor(rig, name), groupColor(commands.rig(), name));
}

}  // namespace
}  // namespace sinew::app
