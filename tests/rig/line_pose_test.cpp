// tests/rig/line_pose_test.cpp: effect of a line on its belly: closed forms and invariants.

#include "core/rig/line_pose.h"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "core/rig/line_rest.h"

namespace sinew::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kUpper = 0;
constexpr int kFore = 1;

/// An upper arm of length 30 that hangs down, a forearm below it; +z is the front. No skin: a line needs it only if its
/// anchors lie on the bone's axis.
Character arm() {
  Character character;
  character.height = 100.0f;
  character.mesh.positions = {{0.0f, -15.0f, 4.0f}};
  character.skeleton.nodes.resize(2);
  character.skeleton.bones.resize(2);
  std::vector<Bone>& bones = character.skeleton.bones;
  bones[kUpper].name = "upper";
  bones[kFore].name = "fore";
  bones[kFore].node = 1;
  bones[kFore].parent = kUpper;
  bones[kFore].bindInWorld = glm::translate(glm::mat4(1.0f), {0.0f, -30.0f, 0.0f});
  finishBones(character.skeleton);
  return character;
}

/// The biceps of docs/muscles.md: 3 along the humerus, 4 along the forearm, both 1.5 in front.
MuscleLine biceps() {
  MuscleLine line;
  line.name = "biceps";
  line.origin = {"upper", {0.0f, -3.0f, 1.5f}, {}};
  line.insertion = {"fore", {0.0f, -4.0f, 1.5f}, {}};
  return line;
}

Pose elbowAt(const Character& character, double degrees) {
  Pose pose = bindPose(character.skeleton);
  pose.boneInWorld[kFore] =
      glm::mat4(glm::rotate(glm::dmat4(pose.boneInWorld[kFore]), -degrees * kPi / 180.0, glm::dvec3(1.0, 0.0, 0.0)));
  return pose;
}

PosedLine posed(const MuscleLine& line, const Character& character, const Pose& pose) {
  const Result<LineRest> rest = lineRest(line, character);
  EXPECT_TRUE(rest.ok()) << rest.error().text();
  return posedLine(rest.value(), character.skeleton, pose, pose.flex);
}

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  glm::dvec3 direction() {
    const glm::dvec3 v(in(-1, 1), in(-1, 1), in(-1, 1));
    return glm::dot(v, v) < 1e-3 ? glm::dvec3(0, 1, 0) : glm::normalize(v);
  }
  glm::dmat4 motion(double place, double leastScale, double mostScale) {
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), place * direction());
    m = glm::rotate(m, in(-kPi, kPi), direction());
    return glm::scale(m, glm::dvec3(in(leastScale, mostScale)));
  }
  /// A random line on the arm.
  MuscleLine line() {
    MuscleLine line = biceps();
    const auto point = [&] { return glm::vec3(in(-3, 3), in(-12, 0), in(0.5, 4)); };
    line.origin.point = point();
    line.insertion.point = point();
    if (in(0, 1) < 0.5) line.via = LineAnchor{"upper", point(), {}};
    LineSettings& s = line.settings;
    s.rest = static_cast<float>(in(0.5, 1.0));  // Longer lines are slack in the bind pose, hence active.
    s.tendons = {in(0, 0.3), in(0, 0.3)};
    s.volume = static_cast<float>(in(0, 2));
    s.pivot = static_cast<float>(in(0, 1));
    s.twist = static_cast<float>(in(0, 1));
    s.flex = {in(0, 1), in(-0.4, 0.5)};
    return line;
  }

 private:
  std::mt19937 engine_;
};

glm::dvec3 through(const PosedLine& line, const glm::dvec3& point) {
  return glm::dvec3(glm::dmat4(line.deformation) * glm::dvec4(point, 1.0));
}

double determinantOf(const PosedLine& line) { return glm::determinant(glm::dmat3(glm::dmat4(line.deformation))); }

TEST(LinePose, BindPoseDeformsNothingBitForBit) {
  const Character character = arm();
  RandomNumbers random(1);
  for (int i = 0; i < 200; ++i) {
    const PosedLine line = posed(random.line(), character, bindPose(character.skeleton));
    ASSERT_TRUE(line.usable);
    EXPECT_EQ(line.deformation, glm::mat4(1.0f)) << i;
  }
}

TEST(LinePose, FormulaGivesIdentityInTheBindPose) {
  const Character character = arm();
  RandomNumbers random(2);
  Pose almost = bindPose(character.skeleton);
  almost.boneInWorld[kFore][3].x = 1e-6f;
  for (int i = 0; i < 200; ++i) {
    const PosedLine line = posed(random.line(), character, almost);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        EXPECT_NEAR(line.deformation[column][row], glm::mat4(1.0f)[column][row], 2e-5) << i;
      }
    }
  }
}

/// The documented table of a biceps over the elbow.
TEST(LinePose, BicepsMatchesTheDocumentedTable) {
  struct Row {
    double degrees, stretch, belly, girth, activation, height;
  };
  const std::array rows = {Row{0, 1.00, 1.00, 1.000, 0.00, 1.000},   Row{30, 0.96, 0.95, 1.029, 0.07, 1.050},
                           Row{60, 0.90, 0.86, 1.079, 0.36, 1.197},  Row{90, 0.83, 0.76, 1.143, 0.78, 1.409},
                           Row{120, 0.77, 0.67, 1.204, 0.99, 1.561}, Row{140, 0.74, 0.64, 1.230, 1.00, 1.599}};
  const Character character = arm();
  const MuscleLine line = biceps();
  for (const Row& row : rows) {
    const PosedLine at = posed(line, character, elbowAt(character, row.degrees));
    EXPECT_NEAR(at.stretch, row.stretch, 0.0051) << row.degrees;
    EXPECT_NEAR(at.bellyStretch, row.belly, 0.0055) << row.degrees;
    EXPECT_NEAR(girth(at.bellyStretch, girthRest(line.settings)), row.girth, 0.0011) << row.degrees;
    EXPECT_NEAR(at.activation, row.activation, 0.0051) << row.degrees;
    const double height = glm::length(glm::dvec3(glm::dmat4(at.deformation)[2]));
    EXPECT_NEAR(height, row.height, 0.0016) << row.degrees;
  }
}

TEST(LinePose, VolumeIsPreservedIfRequested) {
  const Character character = arm();
  RandomNumbers random(3);
  int kept = 0;
  for (int i = 0; i < 10000; ++i) {
    MuscleLine line = random.line();
    line.settings.volume = 1.0f;
    line.settings.gain = 0.0f;
    line.settings.limits = {1e-30f, 1e30f};
    Pose pose = bindPose(character.skeleton);
    std::array<double, 2> scale{};
    for (std::size_t b = 0; b < 2; ++b) {
      const glm::dmat4 motion = random.motion(5.0, 0.5, 2.0);
      scale[b] = std::cbrt(glm::determinant(glm::dmat3(motion)));
      pose.boneInWorld[b] = glm::mat4(motion * glm::dmat4(pose.boneInWorld[b]));
    }
    const PosedLine at = posed(line, character, pose);
    // Even wide limits change the girth slightly where the belly is compressed; at minimum length the volume is not
    // kept.
    if (at.bellyStretch < 0.5f || at.bellyStretch > 2.0f) continue;
    ++kept;
    const double sigma = std::sqrt(scale[0] * scale[1]);
    EXPECT_NEAR(determinantOf(at) / std::pow(sigma, 3.0), 1.0, 1e-4) << i;
  }
  EXPECT_GT(kept, 3000);
}

TEST(LinePose, BellyLiesAlongTheLine) {
  const Character character = arm();
  RandomNumbers random(4);
  for (int i = 0; i < 2000; ++i) {
    const MuscleLine line = random.line();
    const LineRest rest = lineRest(line, character).value();
    Pose pose = bindPose(character.skeleton);
    for (glm::mat4& bone : pose.boneInWorld) bone = glm::mat4(random.motion(5.0, 0.7, 1.4) * glm::dmat4(bone));
    const PosedLine at = posed(line, character, pose);
    const glm::dvec3 along = through(at, rest.direction) - through(at, glm::dvec3(0.0));
    const glm::dvec3 straight = glm::normalize(glm::dvec3(at.insertion) - glm::dvec3(at.origin));
    EXPECT_LT(glm::distance(glm::normalize(along), straight), 2e-5) << i;
    EXPECT_NEAR(glm::dot(glm::dvec3(at.height), straight), 0.0, 1e-5) << i;
  }
}

TEST(LinePose, FlexingKeepsThePivot) {
  const Character character = arm();
  RandomNumbers random(5);
  for (int i = 0; i < 500; ++i) {
    MuscleLine line = random.line();
    line.settings.gain = 0.0f;
    const LineRest rest = lineRest(line, character).value();
    Pose pose = elbowAt(character, random.in(0.0, 140.0));
    const PosedLine loose = posed(line, character, pose);
    pose.flex = 1.0f;
    const PosedLine tense = posed(line, character, pose);
    EXPECT_EQ(tense.activation, 1.0f);
    EXPECT_LT(glm::distance(through(loose, rest.start), through(tense, rest.start)), 1e-6 * 100.0) << i;
    const double grown = determinantOf(tense) / determinantOf(loose);
    const glm::dvec2 flex(line.settings.flex);
    EXPECT_NEAR(grown, (1.0 + flex.x) * (1.0 + flex.y), 1e-4) << i;
  }
}

TEST(LinePose, TendonsKeepTheirLength) {
  const Character character = arm();
  RandomNumbers random(6);
  for (int i = 0; i < 500; ++i) {
    MuscleLine line = random.line();
    line.via.reset();
    line.settings.pivot = 0.0f;
    const LineRest rest = lineRest(line, character).value();
    const PosedLine at = posed(line, character, elbowAt(character, random.in(0.0, 140.0)));
    const double restLength = static_cast<double>(line.settings.rest) * rest.length;
    const glm::dvec2 tendons = glm::dvec2(line.settings.tendons) * restLength;
    if (at.bellyStretch < 0.2f) continue;
    const glm::dvec3 first = rest.origin.inBind + tendons.x * rest.direction;
    const glm::dvec3 last = rest.insertion.inBind - tendons.y * rest.direction;
    EXPECT_NEAR(glm::distance(through(at, first), glm::dvec3(at.origin)), tendons.x, 1e-4) << i;
    EXPECT_NEAR(glm::distance(through(at, last), glm::dvec3(at.insertion)), tendons.y, 1e-4) << i;
  }
}

TEST(LinePose, GirthMatchesScheepersClosedForm) {
  LineSettings settings;
  settings.limits = {1e-30f, 1e30f};
  for (double stretch = 0.3; stretch < 3.0; stretch += 0.1) {
    EXPECT_NEAR(girth(stretch, girthRest(settings)), 1.0 / std::sqrt(stretch), 2e-4) << stretch;
  }
}

TEST(LinePose, GirthDecreasesWithStretchAndLevelsOff) {
  LineSettings settings;
  double before = 1e9;
  for (double stretch = 0.05; stretch < 20.0; stretch *= 1.01) {
    const double now = girth(stretch, girthRest(settings));
    EXPECT_LT(now, before);
    EXPECT_GT(now, 1.0 / std::sqrt(2.0) - 1e-6);
    EXPECT_LT(now, 1.0 / std::sqrt(0.4) + 1e-6);
    before = now;
  }
}

TEST(LinePose, MovesAndScalesWithTheWholeBody) {
  const Character character = arm();
  RandomNumbers random(7);
  for (int i = 0; i < 500; ++i) {
    const MuscleLine line = random.line();
    const Pose pose = elbowAt(character, random.in(1.0, 140.0));
    const double scale = random.in(0.5, 2.0);
    const glm::dmat4 motion = glm::scale(random.motion(50.0, 1.0, 1.0), glm::dvec3(scale));
    Pose carried = pose;
    for (glm::mat4& bone : carried.boneInWorld) bone = glm::mat4(motion * glm::dmat4(bone));
    const PosedLine here = posed(line, character, pose);
    const PosedLine there = posed(line, character, carried);
    EXPECT_NEAR(here.stretch, there.stretch, 1e-5) << i;
    EXPECT_NEAR(here.activation, there.activation, 1e-4) << i;
    for (const glm::dvec3& point : {glm::dvec3(0, -15, 3), glm::dvec3(5, -30, 0), glm::dvec3(-3, 0, 10)}) {
      const glm::dvec3 wanted(motion * glm::dvec4(through(here, point), 1.0));
      EXPECT_LT(glm::distance(through(there, point), wanted), 1e-3 * scale) << i;
    }
  }
}

TEST(LinePose, MirroredPoseGivesAMirroredBelly) {
  const Character character = arm();
  RandomNumbers random(8);
  const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));
  for (int i = 0; i < 500; ++i) {
    const MuscleLine line = random.line();
    MuscleLine image = line;
    for (LineAnchor* anchor : {&image.origin, &image.insertion}) anchor->point.x = -anchor->point.x;
    if (image.via) image.via->point.x = -image.via->point.x;
    Pose pose = bindPose(character.skeleton);
    Pose reflected = pose;
    for (std::size_t b = 0; b < 2; ++b) {
      const glm::dmat4 motion = random.motion(5.0, 0.8, 1.25);
      pose.boneInWorld[b] = glm::mat4(motion * glm::dmat4(pose.boneInWorld[b]));
      reflected.boneInWorld[b] = glm::mat4(mirror * motion * mirror * glm::dmat4(reflected.boneInWorld[b]));
    }
    const PosedLine a = posed(line, character, pose);
    const PosedLine b = posed(image, character, reflected);
    EXPECT_NEAR(a.stretch, b.stretch, 1e-5);
    const glm::dvec3 point(2.0, -15.0, 3.0);
    const glm::dvec3 wanted(mirror * glm::dvec4(through(a, point), 1.0));
    EXPECT_LT(glm::distance(through(b, glm::dvec3(-2.0, -15.0, 3.0)), wanted), 1e-3) << i;
  }
}

TEST(LinePose, TwistFollowsTheChosenBone) {
  const Character character = arm();
  MuscleLine line = biceps();
  line.origin.point = {0.0f, -3.0f, 1.5f};
  Pose pose = bindPose(character.skeleton);
  const LineRest rest = lineRest(line, character).value();
  // The forearm rotates about the line itself: only its roll changes.
  const glm::dmat4 about = glm::translate(glm::dmat4(1.0), rest.insertion.inBind);
  const glm::dmat4 roll = about * glm::rotate(glm::dmat4(1.0), 0.5 * kPi, rest.direction) * glm::inverse(about);
  pose.boneInWorld[kFore] = glm::mat4(roll * glm::dmat4(pose.boneInWorld[kFore]));
  const auto turnAt = [&](float twist) {
    line.settings.twist = twist;
    const glm::dvec3 height(posed(line, character, pose).height);
    return std::atan2(glm::dot(glm::cross(glm::dvec3(0, 0, 1), height), rest.direction), height.z) * 180.0 / kPi;
  };
  EXPECT_NEAR(turnAt(0.0f), 0.0, 1e-3);
  EXPECT_NEAR(turnAt(0.5f), 45.0, 1e-3);
  EXPECT_NEAR(turnAt(1.0f), 90.0, 1e-3);
}

/// Behind the elbow a straight line passes through the joint as the arm bends; one around a via point does not.
TEST(LinePose, ViaPointKeepsTheBellyOutOfTheJoint) {
  const Character character = arm();
  MuscleLine line;
  line.name = "triceps";
  line.origin = {"upper", {0.0f, -3.0f, -2.0f}, {}};
  line.insertion = {"fore", {0.0f, -4.0f, -2.0f}, {}};
  MuscleLine bent = line;
  bent.via = LineAnchor{"upper", {0.0f, -29.0f, -2.5f}, {}};
  const glm::dvec3 belly(0.0, -20.0, -2.0);
  const auto away = [&](const MuscleLine& of, double degrees) {
    // Behind the humerus, whose axis is the y axis.
    return -through(posed(of, character, elbowAt(character, degrees)), belly).z;
  };
  EXPECT_NEAR(away(line, 0.0), 2.0, 1e-5);
  EXPECT_NEAR(away(bent, 0.0), 2.0, 1e-5);
  EXPECT_LT(away(line, 130.0), 0.5);
  EXPECT_GT(away(bent, 130.0), 1.5);
  const PosedLine straight = posed(line, character, elbowAt(character, 130.0));
  const PosedLine round = posed(bent, character, elbowAt(character, 130.0));
  EXPECT_GT(round.stretch, straight.stretch) << "an extensor is longer round the joint than through it";
  EXPECT_GT(round.stretch, 1.05f);
}

TEST(LinePose, MovesContinuously) {
  const Character character = arm();
  RandomNumbers random(9);
  for (int i = 0; i < 20; ++i) {
    const MuscleLine line = random.line();
    glm::dvec3 before(0.0);
    double step = 0.0;
    for (int tenth = 0; tenth <= 1400; ++tenth) {
      const PosedLine at = posed(line, character, elbowAt(character, 0.1 * tenth));
      const glm::dvec3 now = through(at, glm::dvec3(2.0, -15.0, 4.0));
      const double length = glm::distance(now, before);
      if (tenth > 1) {
        EXPECT_LT(length, 2.0 * step + 1e-4 * 100.0) << i << ' ' << tenth;
      }
      step = length;
      before = now;
    }
  }
}

TEST(LinePose, UnusableLinesAreHidden) {
  const Character character = arm();
  Pose flat = bindPose(character.skeleton);
  flat.boneInWorld[kFore] = glm::scale(flat.boneInWorld[kFore], {1.0f, 0.0f, 1.0f});
  EXPECT_EQ(posed(biceps(), character, flat).deformation, glm::mat4(0.0f));
  Pose broken = bindPose(character.skeleton);
  broken.boneInWorld[kUpper][3].x = std::nanf("");
  EXPECT_EQ(posed(biceps(), character, broken).deformation, glm::mat4(0.0f));
  MuscleLine point = biceps();
  point.insertion = {"upper", point.origin.point, {}};
  EXPECT_FALSE(lineRest(point, character).ok());
  MuscleLine foreign = biceps();
  foreign.origin.bone = "tail";
  ASSERT_FALSE(lineRest(foreign, character).ok());
  EXPECT_EQ(lineRest(foreign, character).error().plainText(),
            "Muscle line \"biceps\", origin: this character has no bone \"tail\"");
}

TEST(NearestRotation, RecoversTheRotationOfScaledAndShearedMatrices) {
  RandomNumbers random(10);
  for (int i = 0; i < 1000; ++i) {
    const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), random.in(-kPi, kPi), random.direction()));
    const glm::dmat3 axes(glm::rotate(glm::dmat4(1.0), random.in(-kPi, kPi), random.direction()));
    // Polar decomposition of a rotation after a symmetric positive stretch gives the rotation.
    const glm::dmat3 grow(random.in(0.2, 5.0), 0, 0, 0, random.in(0.2, 5.0), 0, 0, 0, random.in(0.2, 5.0));
    const glm::dmat3 found = nearestRotation(turn * axes * grow * glm::transpose(axes));
    for (int column = 0; column < 3; ++column) EXPECT_LT(glm::distance(found[column], turn[column]), 1e-9) << i;
  }
}

}  // namespace
}  // namespace sinew::test
