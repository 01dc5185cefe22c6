// tests/bodies/sheets/lay_sheet_test.cpp: where bellies of a sheet lie, and how evenly they sum.
#include "core/bodies/sheets/lay_sheet.h"

#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "sinew/surface/smoother.h"
#include "tests/bodies/sheets/sheet_fixture.h"

namespace sinew {
namespace {

class LaidSheets : public testing::Test {
 protected:
  [[nodiscard]] LaidSheet laid(const MuscleSheet& sheet) const {
    Result<LaidSheet> made = laySheet(sheet, skin_);
    EXPECT_TRUE(made.ok()) << made.error().text();
    return made.ok() ? std::move(made).value() : LaidSheet{};
  }

  [[nodiscard]] glm::vec3 centerOf(const Primitive& belly) const {
    return body_.inBind(belly.bone, belly.placement.center);
  }

  /// The highest point of a belly: its shortest axis, out of the skin.
  [[nodiscard]] glm::vec3 topOf(const Primitive& belly) const {
    const glm::mat4& bone = at(body_.skeleton().bones, *body_.skeleton().findBone(belly.bone)).bindInWorld;
    const glm::mat3 axes = glm::mat3(bone) * glm::mat3_cast(belly.placement.rotation);
    return centerOf(belly) + axes[2] * belly.placement.radii.z;
  }

  test::SheetBody body_ = test::humanoidBody();
  SheetSkin skin_{body_.character, Rig{}};
};

/// Distance from the nearest of all triangles of the bare surface, by another path: finer, one by one. Below the skin
/// negative.
float heightOver(const Surface& surface, const glm::vec3& point) {
  float least = std::numeric_limits<float>::max();
  float side = 1.0f;
  for (const auto& [a, b, c] : surface.refinement->triangles) {
    const TriangleCorners corners{at(surface.positions, a), at(surface.positions, b), at(surface.positions, c)};
    const glm::vec3 nearest = mixed(corners, nearestOnTriangle(point, corners));
    const float distance = glm::distance(point, nearest);
    if (distance >= least) continue;
    least = distance;
    side =
        glm::dot(point - nearest, glm::cross(corners[1] - corners[0], corners[2] - corners[0])) < 0.0f ? -1.0f : 1.0f;
  }
  return side * least;
}

TEST_F(LaidSheets, TopsStandAtTheHeightsOfTheProfiles) {
  MuscleSheet sheet = test::chestSheet(body_);
  sheet.crest = 0.02f;
  sheet.across = {{0.0f, 0.5f}, {1.0f, 1.0f}};
  sheet.along = {{0.0f, 0.2f}, {0.5f, 1.0f}, {1.0f, 0.0f}};
  const LaidSheet made = laid(sheet);
  ASSERT_EQ(made.bellies.size(), 12u);
  Rig bare;
  bare.smoothing.depth = 8;
  Smoother smoother(body_.character);
  ASSERT_TRUE(smoother.prepare(bare).ok());
  Surface surface;
  smoother.smooth(bindPose(body_.skeleton()), surface);
  const float height = body_.character->height;
  for (std::size_t i = 0; i < made.bellies.size(); ++i) {
    const float u = (static_cast<float>(i / 3) + 0.5f) / 4.0f;
    const float v = (static_cast<float>(i % 3) + 0.5f) / 3.0f;
    const float rise = sheet.sunk + (sheet.crest - sheet.sunk) * profileAt(sheet.across, u) * profileAt(sheet.along, v);
    EXPECT_NEAR(heightOver(surface, topOf(made.bellies[i])) / height, rise, 0.003f) << made.bellies[i].name;
  }
}

TEST_F(LaidSheets, BelliesAreNamedByStripAndInOneGroup) {
  MuscleSheet sheet = test::chestSheet(body_);
  sheet.sign = -1;
  const LaidSheet made = laid(sheet);
  std::set<std::string> names;
  for (const Primitive& belly : made.bellies) {
    names.insert(belly.name);
    EXPECT_EQ(belly.group, "chest L");
    EXPECT_EQ(belly.sheet, "pectoral L");
    EXPECT_EQ(belly.sign, -1);
    EXPECT_TRUE(belly.line.empty());
    ASSERT_TRUE(belly.territory.has_value());
    EXPECT_NE(std::ranges::find(*belly.territory, belly.bone), belly.territory->end());
  }
  EXPECT_EQ(names.size(), 12u);
  EXPECT_TRUE(names.contains("pectoral L 1.1"));
  EXPECT_TRUE(names.contains("pectoral L 4.3"));
}

TEST_F(LaidSheets, EachStripHasALineOfItsOwn) {
  MuscleSheet sheet = test::chestSheet(body_);
  sheet.line = LineSettings{};
  sheet.line->volume = 0.5f;
  const LaidSheet made = laid(sheet);
  ASSERT_EQ(made.lines.size(), 4u);
  for (std::size_t strip = 0; strip < 4; ++strip) {
    const MuscleLine& line = made.lines[strip];
    EXPECT_EQ(line.settings, *sheet.line);
    EXPECT_EQ(line.sheet, "pectoral L");
    ASSERT_TRUE(line.via.has_value());
    EXPECT_TRUE(lineRest(line, *body_.character).ok());
    for (std::size_t belly = 0; belly < 3; ++belly) EXPECT_EQ(made.bellies[3 * strip + belly].line, line.name);
  }
  EXPECT_NE(made.lines[0].origin.bone, made.lines[0].insertion.bone);
}

TEST_F(LaidSheets, TheSameSheetGivesTheSameBits) {
  const MuscleSheet sheet = test::chestSheet(body_);
  const SheetSkin other(body_.character, Rig{});
  const LaidSheet again = laySheet(sheet, other).value();
  EXPECT_EQ(laid(sheet).bellies, again.bellies);
}

TEST_F(LaidSheets, TheImageOfASheetIsLaidAsTheImage) {
  const MuscleSheet sheet = test::chestSheet(body_);
  const Result<MuscleSheet> image = mirroredSheet(body_.plan, sheet);
  ASSERT_TRUE(image.ok()) << image.error().text();
  EXPECT_EQ(image->name, "pectoral R");
  EXPECT_EQ(image->group, "chest R");
  const LaidSheet left = laid(sheet);
  const LaidSheet right = laid(image.value());
  ASSERT_EQ(left.bellies.size(), right.bellies.size());
  for (std::size_t i = 0; i < left.bellies.size(); ++i) {
    const glm::vec3 there(reflected(body_.plan.plane, glm::dvec3(centerOf(left.bellies[i]))));
    EXPECT_LT(glm::distance(there, centerOf(right.bellies[i])), 0.0005f * body_.character->height);
    EXPECT_NEAR(left.bellies[i].amount, right.bellies[i].amount, 1e-3f);
  }
}

TEST_F(LaidSheets, AMissingBoneAndEdgesAtOnePlaceAreRefused) {
  MuscleSheet sheet = test::chestSheet(body_);
  sheet.edges[0].points[0].bone = "tail";
  EXPECT_NE(laySheet(sheet, skin_).error().reason.find("no bone \"tail\""), std::string::npos);
  sheet = test::chestSheet(body_);
  for (SheetEdge& edge : sheet.edges) edge = sheet.edges[0];
  EXPECT_NE(laySheet(sheet, skin_).error().reason.find("same place"), std::string::npos);
}

TEST(EdgesOfSheets, AreSpreadByLength) {
  const std::vector<glm::vec3> edge{{0, 0, 0}, {1, 0, 0}, {1, 3, 0}};
  const std::vector<glm::vec3> places = spreadAlong(edge, 2);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR(glm::distance(places[0], glm::vec3(1, 0, 0)), 0.0f, 1e-6f);
  EXPECT_NEAR(glm::distance(places[1], glm::vec3(1, 2, 0)), 0.0f, 1e-6f);
  EXPECT_EQ(spreadAlong({{2, 2, 2}}, 3), std::vector<glm::vec3>(3, {2, 2, 2}));
}

/// The ripple of a flat grid between its tops, from the definition of the field.
TEST(EvenAmounts, AGridAtTheSecondZeroIsFlat) {
  constexpr float kReach = 1.5f;
  constexpr int kSide = 9;
  constexpr float kThick = 0.25f;
  const float step = kEvenSpacing * std::sqrt(kReach * kReach - 1.0f);
  std::vector<glm::vec3> centers;
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      centers.emplace_back(step * static_cast<float>(x), step * static_cast<float>(y), 0.0f);
    }
  }
  const std::vector<glm::mat3> axes(centers.size(), glm::mat3({1, 0, 0}, {0, 1, 0}, {0, 0, kThick}));
  const std::vector<float> amounts = evenAmounts(centers, axes, kReach);
  const auto g = [](float squared) { return std::pow(std::max(1.0f - squared / (kReach * kReach), 0.0f), 2.0f); };
  const auto sumAt = [&](const glm::vec3& point) {
    float sum = 0.0f;
    for (std::size_t i = 0; i < centers.size(); ++i) {
      const glm::vec3 off = (point - centers[i]) / glm::vec3(1.0f, 1.0f, kThick);
      sum += amounts[i] * g(glm::dot(off, off)) / g(1.0f);
    }
    return sum;
  };
  const glm::vec3 middle = centers[centers.size() / 2] + glm::vec3(0, 0, kThick);
  EXPECT_NEAR(amounts[centers.size() / 2], 0.40f, 0.03f);
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const glm::vec3 off(step * static_cast<float>(i) / 10.0f, step * static_cast<float>(j) / 10.0f, 0.0f);
      EXPECT_NEAR(sumAt(middle + off) / sumAt(middle), 1.0f, 0.03f);
    }
  }
  EXPECT_NEAR(sumAt(middle), 1.0f, 0.05f);
}

TEST(Profiles, StepSmoothlyBetweenTheirPoints) {
  const Profile profile{{0.2f, 1.0f}, {0.6f, -1.0f}};
  EXPECT_EQ(profileAt(profile, 0.0f), 1.0f);
  EXPECT_EQ(profileAt(profile, 1.0f), -1.0f);
  EXPECT_NEAR(profileAt(profile, 0.4f), 0.0f, 1e-6f);
  EXPECT_GT(profileAt(profile, 0.3f), 0.5f);
  EXPECT_EQ(profileAt({}, 0.5f), 1.0f);
}

}  // namespace
}  // namespace sinew
