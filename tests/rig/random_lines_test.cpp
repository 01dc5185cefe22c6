// tests/rig/random_lines_test.cpp: random lines and poses match docs/muscles.md; single and batched lines are bitwise
// equal; degenerate cases.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "core/rig/line_pose.h"
#include "core/rig/line_rest.h"
#include "tests/support/allocations.h"
#include "tests/support/oracle/line.h"

namespace sinew::test {
namespace {

constexpr int kBones = 7;
constexpr double kPi = 3.14159265358979323846;
using Rests = std::vector<std::optional<LineRest>>;

/// A character with random bones, lines between them, and poses.
class Trial {
 public:
  explicit Trial(unsigned seed) : engine_(seed) {
    character.height = 10.0f;
    character.skeleton.nodes.resize(kBones);
    character.skeleton.bones.resize(kBones);
    for (int b = 0; b < kBones; ++b) {
      Bone& bone = character.skeleton.bones[static_cast<std::size_t>(b)];
      bone.name = std::string(1, static_cast<char>('a' + b));
      bone.node = b;
      bone.parent = b - 1;
      bone.bindInWorld = glm::mat4(placed(5.0, 1.0, 1.0));
    }
    finishBones(character.skeleton);
    for (int i = 0; i < 20; ++i) character.mesh.positions.emplace_back(5.0 * direction());
  }

  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int oneOf(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  glm::dvec3 direction() {
    const glm::dvec3 v(in(-1, 1), in(-1, 1), in(-1, 1));
    return glm::dot(v, v) < 1e-3 ? glm::dvec3(0, 1, 0) : glm::normalize(v);
  }
  glm::dmat4 placed(double place, double leastScale, double mostScale) {
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), place * direction());
    m = glm::rotate(m, in(-kPi, kPi), direction());
    return glm::scale(m, glm::dvec3(in(leastScale, mostScale), in(leastScale, mostScale), in(leastScale, mostScale)));
  }
  LineAnchor anchor() { return {std::string(1, static_cast<char>('a' + oneOf(kBones))), glm::vec3(direction()), {}}; }

  MuscleLine line(bool atRest) {
    MuscleLine line;
    line.name = "any";
    line.origin = anchor();
    line.insertion = anchor();
    if (oneOf(2) == 0) line.via = anchor();
    LineSettings& s = line.settings;
    s.rest = atRest ? 1.0f : static_cast<float>(in(0.3, 3.0));
    s.tendons = {in(0, 0.4), in(0, 0.4)};
    s.volume = static_cast<float>(in(0, 4));
    s.limits = {in(0.05, 0.95), in(1.05, 10.0)};
    s.pivot = static_cast<float>(in(0, 1));
    s.twist = static_cast<float>(oneOf(3) == 0 ? oneOf(2) : in(0, 1));
    s.flex = {in(-0.9, 4), in(-0.9, 4)};
    s.base = atRest ? 0.0f : static_cast<float>(in(0, 0.2));
    s.gain = static_cast<float>(in(0, 4));
    s.full = static_cast<float>(in(0.1, 0.99));
    return line;
  }
  /// Random lines, some missing.
  Rests lines(int count, bool atRest = false) {
    Rests rests;
    while (static_cast<int>(rests.size()) < count) {
      const Result<LineRest> rest = lineRest(line(atRest), character);
      rests.push_back(rest && oneOf(15) != 0 ? std::optional(rest.value()) : std::nullopt);
    }
    return rests;
  }

  /// Random bones, scaled and sheared; some unmoved, some lines flexed. @param far  from the world's origin
  Pose pose(double far) {
    Pose pose = bindPose(character.skeleton);
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), far * direction());
    for (glm::mat4& bone : pose.boneInWorld) {
      if (far == 0.0 && oneOf(3) == 0) continue;
      bone = glm::mat4(away * placed(3.0, 0.5, 2.0) * glm::dmat4(bone));
    }
    pose.flex = static_cast<float>(oneOf(2) == 0 ? in(0, 1) : 0.0);
    if (oneOf(2) == 0) pose.flexedLines = {1, 4, 5, 11};
    return pose;
  }

  /// Bones within rounding of the bind pose: deformations that should be 0 consist of rounding errors, so that the
  /// floats show the last bits of the doubles.
  Pose almostBind() {
    Pose pose = bindPose(character.skeleton);
    for (glm::mat4& bone : pose.boneInWorld) bone[3].x = std::nextafter(bone[3].x, 10.0f);
    return pose;
  }

  Character character;

 private:
  std::mt19937 engine_;
};

std::vector<PosedLine> poseAll(const Rests& rests, const Skeleton& skeleton, const Pose& pose) {
  LineScratch scratch;
  std::vector<PosedLine> lines;
  poseLines(rests, skeleton, pose, scratch, lines);
  return lines;
}

/// Compares the members that are meant to be read.
bool sameBits(const PosedLine& a, const PosedLine& b) {
  return std::memcmp(&a, &b, offsetof(PosedLine, usable)) == 0 && a.usable == b.usable;
}

double apart(const glm::vec3& a, const glm::dvec3& b) { return glm::distance(glm::dvec3(a), b); }

/// Within the precision of floats of that size; translations of the size of their operands.
void expectAgreement(const PosedLine& line, const oracle::Line& wanted, const LineRest& rest) {
  constexpr double kFloat = 2e-7;
  ASSERT_TRUE(line.usable);
  const glm::dmat3 linear(wanted.deformation);
  double size = 0.0;
  for (int column = 0; column < 3; ++column) size = std::max(size, glm::length(linear[column]));
  const double slack = 1e-14 / (wanted.agreement * wanted.agreement);  // Frames rotated by half a turn have no mean.
  for (int column = 0; column < 3; ++column) {
    EXPECT_LT(apart(glm::vec3(line.deformation[column]), linear[column]), (kFloat + slack) * size);
    EXPECT_EQ(line.deformation[column][3], 0.0f);
  }
  const glm::dvec3 moved(wanted.deformation[3]);
  const double parts = glm::length(wanted.origin) + size * glm::length(rest.start) + glm::length(moved);
  EXPECT_LT(apart(glm::vec3(line.deformation[3]), moved), (kFloat + slack) * parts);
  EXPECT_EQ(line.deformation[3][3], 1.0f);
  EXPECT_LT(apart(line.origin, wanted.origin), kFloat * (1.0 + glm::length(wanted.origin)));
  EXPECT_LT(apart(line.insertion, wanted.insertion), kFloat * (1.0 + glm::length(wanted.insertion)));
  EXPECT_LT(apart(line.via, wanted.via), kFloat * (1.0 + glm::length(wanted.via)));
  EXPECT_LT(apart(line.height, wanted.height), kFloat + slack);
  EXPECT_NEAR(line.stretch, wanted.stretch, kFloat * wanted.stretch);
  EXPECT_NEAR(line.bellyStretch, wanted.bellyStretch, kFloat * wanted.bellyStretch);
  EXPECT_NEAR(line.activation, wanted.activation, kFloat);
}

TEST(RandomLines, MatchesTheDefinition) {
  int compared = 0;
  double leastAgreement = 1.0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Trial trial(seed);
    const Rests rests = trial.lines(61);
    for (const double far : {0.0, 4.0, 1e5}) {
      const Pose pose = trial.pose(far);
      const auto lines = poseAll(rests, trial.character.skeleton, pose);
      ASSERT_EQ(lines.size(), rests.size());
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!rests[i]) {
          EXPECT_TRUE(sameBits(lines[i], PosedLine{}));
          continue;
        }
        const double flex = static_cast<double>(pose.flexOf(static_cast<int>(i)));
        const oracle::Line wanted = oracle::posedLine(*rests[i], trial.character.skeleton, pose, flex);
        expectAgreement(lines[i], wanted, *rests[i]);
        if (HasFailure()) FAIL() << "seed " << seed << ", " << far << " away, line " << i;
        leastAgreement = std::min(leastAgreement, wanted.agreement);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 6000);
  EXPECT_LT(leastAgreement, 0.01) << "frames almost a half turn apart were not among them";
}

TEST(RandomLines, SingleLineMatchesTheBatchBitForBit) {
  for (unsigned seed = 100; seed < 120; ++seed) {
    Trial trial(seed);
    const Skeleton& skeleton = trial.character.skeleton;
    const Rests rests = trial.lines(37);
    for (Pose pose : {trial.pose(0.0), trial.pose(4.0), trial.almostBind()}) {
      if (seed % 4 == 0) pose.boneInWorld[2][3].y = std::numeric_limits<float>::infinity();
      if (seed % 4 == 1) pose.boneInWorld[2] = glm::scale(pose.boneInWorld[2], {1.0f, 1.0f, 0.0f});
      const auto wanted = poseAll(rests, skeleton, pose);
      for (std::size_t i = 0; i < rests.size(); ++i) {
        if (!rests[i]) continue;
        const PosedLine alone = posedLine(*rests[i], skeleton, pose, pose.flexOf(static_cast<int>(i)));
        EXPECT_TRUE(sameBits(alone, wanted[i])) << "seed " << seed << ", line " << i;
      }
    }
  }
}

TEST(RandomLines, BindPoseDeformsNothingBitForBit) {
  for (unsigned seed = 200; seed < 220; ++seed) {
    Trial trial(seed);
    const Rests rests = trial.lines(33, true);
    const auto lines = poseAll(rests, trial.character.skeleton, bindPose(trial.character.skeleton));
    for (std::size_t i = 0; i < rests.size(); ++i) {
      if (!rests[i]) continue;
      EXPECT_EQ(lines[i].deformation, glm::mat4(1.0f)) << "seed " << seed << ", line " << i;
      EXPECT_EQ(lines[i].stretch, 1.0f);
      EXPECT_EQ(lines[i].activation, 0.0f);
    }
  }
}

/// Two bones whose spaces are the world's in the bind pose, a line along y between them around a third one.
class DegenerateLine : public testing::Test {
 protected:
  DegenerateLine() {
    character.height = 10.0f;
    character.skeleton.nodes.resize(3);
    character.skeleton.bones.resize(3);
    for (int b = 0; b < 3; ++b) {
      character.skeleton.bones[static_cast<std::size_t>(b)].name = std::string(1, static_cast<char>('a' + b));
      character.skeleton.bones[static_cast<std::size_t>(b)].node = b;
    }
    finishBones(character.skeleton);
    character.mesh.positions = {{0.0f, 0.0f, 1.0f}};
    line.name = "l";
    line.origin = {"a", {0.0f, 1.0f, 1.0f}, {}};
    line.insertion = {"b", {0.0f, 3.0f, 1.0f}, {}};
    pose = bindPose(character.skeleton);
  }

  [[nodiscard]] PosedLine posed() const {
    return posedLine(lineRest(line, character).value(), character.skeleton, pose);
  }

  Character character;
  MuscleLine line;
  Pose pose;
};

TEST_F(DegenerateLine, CoincidentAnchorsKeepTheOriginsDirection) {
  pose.boneInWorld[1] = glm::translate(glm::mat4(1.0f), {0.0f, -2.0f, 0.0f});
  const PosedLine met = posed();
  ASSERT_TRUE(met.usable);
  EXPECT_EQ(met.stretch, 0.0f);
  EXPECT_EQ(met.activation, 1.0f);
  EXPECT_LT(glm::distance(met.height, glm::vec3(0, 0, 1)), 1e-6f);
  EXPECT_GT(met.deformation[1].y, 0.05f);
  EXPECT_LT(met.deformation[1].y, 0.15f);
}

TEST_F(DegenerateLine, OppositeDirectionsRotateAboutTheHeight) {
  pose.boneInWorld[1] = glm::translate(glm::mat4(1.0f), {0.0f, -4.0f, 0.0f});
  const PosedLine opposite = posed();
  ASSERT_TRUE(opposite.usable);
  EXPECT_LT(glm::distance(opposite.height, glm::vec3(0, 0, 1)), 1e-6f);
  EXPECT_LT(glm::distance(glm::normalize(glm::vec3(opposite.deformation[1])), glm::vec3(0, -1, 0)), 1e-6f);
}

TEST_F(DegenerateLine, UnusableBonesHideTheLine) {
  for (const std::size_t bone : {0u, 1u}) {
    const glm::mat4 whole = pose.boneInWorld[bone];
    pose.boneInWorld[bone] = glm::scale(whole, {1.0f, 0.0f, 1.0f});
    EXPECT_TRUE(sameBits(posed(), PosedLine{}));
    pose.boneInWorld[bone][3].z = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(sameBits(posed(), PosedLine{}));
    pose.boneInWorld[bone] = whole;
  }
  EXPECT_TRUE(posed().usable);
}

TEST_F(DegenerateLine, ViaPointNeedsOnlyAPosition) {
  line.via = LineAnchor{"c", {0.0f, 2.0f, 1.5f}, {}};
  pose.boneInWorld[2] = glm::scale(pose.boneInWorld[2], {1.0f, 1.0f, 0.0f});
  EXPECT_TRUE(posed().usable);
  EXPECT_FLOAT_EQ(posed().via.z, 0.0f);
  pose.boneInWorld[2][0][0] = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(sameBits(posed(), PosedLine{}));
}

/// Equivalent to lineRest() of the same line with those settings.
TEST(RandomLines, SettingsCanBeReplaced) {
  Trial trial(300);
  for (int i = 0; i < 29; ++i) {
    MuscleLine line = trial.line(false);
    Result<LineRest> settled = lineRest(line, trial.character);
    if (!settled) continue;
    line.settings = trial.line(false).settings;
    settle(settled.value(), line.settings);
    const LineRest made = lineRest(line, trial.character).value();
    const Pose pose = trial.pose(1.0);
    EXPECT_TRUE(sameBits(posedLine(settled.value(), trial.character.skeleton, pose),
                         posedLine(made, trial.character.skeleton, pose)))
        << i;
  }
}

TEST(RandomLines, RepeatedPosingAllocatesNothing) {
  Trial trial(400);
  Rests rests = trial.lines(100);
  LineScratch scratch;
  std::vector<PosedLine> lines;
  const std::vector<Pose> poses{trial.pose(0.0), trial.pose(1.0), trial.pose(2.0)};
  poseLines(rests, trial.character.skeleton, poses[0], scratch, lines);
  const std::int64_t before = allocations();
  for (const Pose& pose : poses) poseLines(rests, trial.character.skeleton, pose, scratch, lines);
  for (std::optional<LineRest>& rest : rests) {
    if (rest) settle(*rest, rest->settings);
  }
  EXPECT_EQ(allocations(), before);
}

/// Logarithm and exponential function are series.
TEST(RandomLines, GirthMatchesTheStandardLibrary) {
  for (const glm::vec2& limits : {glm::vec2(0.4f, 2.0f), glm::vec2(0.999f, 1.001f), glm::vec2(1e-30f, 1e30f)}) {
    for (const float volume : {0.0f, 1.0f, 4.0f}) {
      LineSettings settings;
      settings.limits = limits;
      settings.volume = volume;
      settings.rest = 1.25f;
      const GirthRest rest = girthRest(settings);
      for (double stretch = 1e-3; stretch < 1e3; stretch *= 1.003) {
        const double wanted = oracle::girth(stretch, settings);
        EXPECT_NEAR(girth(stretch, rest), wanted, 2e-12 * wanted) << stretch;
      }
      EXPECT_NEAR(girth(1.0, rest), oracle::girth(1.0, settings), 2e-12);
    }
  }
}

}  // namespace
}  // namespace sinew::test
