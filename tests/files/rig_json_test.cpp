// tests/files/rig_json_test.cpp: rig files: exact round trips, and errors with a place.
#include "sinew/files/rig_json.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/files/disk/atomic_file.h"
#include "core/rig/validation.h"
#include "tests/files/rig_text.h"
#include "tests/support/rigs/random_documents.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

fs::path dataFile(const char* name) { return fs::path(SINEW_SOURCE_DIR) / "tests/data/rigs" / name; }

class RigFiles : public ::testing::Test {
 protected:
  const test::TemporaryFolder own_;
  const fs::path folder_ = own_.path();
};

TEST(RigJson, RandomRigsRoundTripByteForByte) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Rig rig = test::randomDocument(seed);
    ASSERT_TRUE(validate(rig).ok()) << seed << ": " << validate(rig).error().text();
    const std::string text = rigToJson(rig);
    const auto back = rigFromJson(text);
    ASSERT_TRUE(back.ok()) << seed << ": " << back.error().text() << '\n' << text;
    ASSERT_TRUE(back.value() == rig) << seed << '\n' << text;
    ASSERT_TRUE(test::sameFloatBits(back.value(), rig)) << seed << '\n' << text;
    ASSERT_EQ(rigToJson(back.value()), text) << seed;
  }
}

TEST(RigJson, WritesKeysInOrderAndFloatsShort) {
  Rig rig;
  rig.character = "fox.glb";
  rig.groups.push_back({"legs", {}});
  Primitive primitive;
  primitive.name = "thigh";
  primitive.bone = "leg";
  primitive.group = "legs";
  primitive.placement.center = {0.1f, -0.0f, 1e-45f};
  rig.primitives.push_back(primitive);
  EXPECT_EQ(rigToJson(rig), R"({
  "format": "sinew-rig",
  "version": 1,
  "character": "fox.glb",
  "surface": { "mode": "swell", "iso": 0.25, "skin_blend": 0.04 },
  "smoothing": { "depth": 3, "patch": "pn" },
  "groups": [
    { "name": "legs" }
  ],
  "links": [],
  "primitives": [
    {
      "name": "thigh",
      "bone": "leg",
      "group": "legs",
      "kind": "ellipsoid",
      "center": [0.1, -0.0, 1e-45],
      "rotation": [0, 0, 0, 1],
      "radii": [1, 1, 1],
      "reach": 1.4142135,
      "sign": 1
    }
  ]
}
)");
}

Rig rigOfOne(const Shape& shape) {
  Rig rig;
  rig.character = "fox.glb";
  rig.groups.push_back({"legs", {}});
  Primitive& primitive = rig.primitives.emplace_back();
  primitive.name = "thigh";
  primitive.bone = "leg";
  primitive.group = "legs";
  primitive.placement.shape = shape;
  return rig;
}

TEST(RigJson, ShapesAreWrittenAsVersion2WithoutZeros) {
  EXPECT_NE(rigToJson(rigOfOne({})).find("\"version\": 1,"), std::string::npos);
  EXPECT_EQ(rigToJson(rigOfOne({})).find("\"core\""), std::string::npos);
  const std::string straight = rigToJson(rigOfOne({0.5f, 0.0f, {}}));
  EXPECT_NE(straight.find("\"version\": 2,"), std::string::npos);
  EXPECT_NE(straight.find("\"radii\": [1, 1, 1],\n      \"core\": 0.5,\n      \"reach\""), std::string::npos)
      << straight;
  EXPECT_EQ(straight.find("\"belly\""), std::string::npos);
  const Rig all = rigOfOne({0.5f, -0.25f, {0.0f, 0.3f}});
  const std::string text = rigToJson(all);
  EXPECT_NE(text.find("\"belly\": -0.25,\n      \"bend\": [0, 0.3],"), std::string::npos) << text;
  const auto read = rigFromJson(text);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(read.value() == all);
}

TEST(RigJson, CorrectedBodyPartsKeepTheirOrder) {
  Rig rig;
  rig.character = "a.glb";
  rig.slots = {{"upperArm.L", "b_LeftUpperArm_09"}, {"tail", ""}};
  const std::string text = rigToJson(rig);
  EXPECT_NE(text.find("\"slots\": { \"upperArm.L\": \"b_LeftUpperArm_09\", \"tail\": null }"), std::string::npos)
      << text;
  const auto again = rigFromJson(text);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->slots, rig.slots);
}

TEST(RigJson, LayersKeepTheirOrderAndAreOptional) {
  Rig rig;
  rig.character = "a.glb";
  EXPECT_EQ(rigToJson(rig).find("layers"), std::string::npos);
  rig.layers = {{"Shirt", SkinLayer::kCloth}, {"Eye \"L\"", SkinLayer::kRigid}, {"Body", SkinLayer::kSkin}};
  const std::string text = rigToJson(rig);
  EXPECT_NE(text.find(R"("layers": { "Shirt": "cloth", "Eye \"L\"": "rigid", "Body": "skin" })"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\"version\": 2"), std::string::npos) << "older programs know no layers";
  const auto again = rigFromJson(text);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->layers, rig.layers);
}

TEST(RigJson, OpensTheMinimalFileOfVersion1WithDefaults) {
  const auto rig = loadRig(dataFile("v1-minimal.rig.json"));
  ASSERT_TRUE(rig.ok()) << rig.error().text();
  Rig expected;
  expected.character = "fox.glb";
  EXPECT_TRUE(rig.value() == expected);
}

TEST(RigJson, OpensTheFullFileOfVersion1) {
  const auto loaded = loadRig(dataFile("v1-full.rig.json"));
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const Rig& rig = loaded.value();
  EXPECT_EQ(rig.character, "models/fox.glb");
  EXPECT_EQ(rig.surface.mode, SurfaceMode::kReplace);
  EXPECT_EQ(rig.surface.iso, 0.3f);
  EXPECT_EQ(rig.surface.unknownKeys, R"({"x-shade":"matte"})");
  EXPECT_EQ(rig.smoothing.depth, 5);
  EXPECT_EQ(rig.smoothing.patch, PatchKind::kPhong);
  ASSERT_EQ(rig.primitives.size(), 3u);
  EXPECT_EQ(rig.primitives[0].mirror, "thigh R");
  EXPECT_EQ(rig.primitives[1].placement.radii, glm::vec3(6, 12, 7));
  EXPECT_EQ(rig.primitives[2].placement.center, glm::vec3(0.1f, -2e-3f, 10.0f));
  EXPECT_EQ(rig.primitives[2].reach, kDefaultReach);
  EXPECT_EQ(rig.primitives[2].sign, -1);
  EXPECT_EQ(rig.primitives[2].territory, (std::vector<std::string>{"b_Spine01_02", "b_Hip_01"}));
}

TEST(RigJson, CreaseAngleIsWrittenOnlyIfSet) {
  const auto loaded = loadRig(dataFile("v1-creased.rig.json"));
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  Rig rig = loaded.value();
  EXPECT_EQ(rig.smoothing.creaseAngle, 32.5f);
  EXPECT_EQ(rig.smoothing.unknownKeys, R"({"x-note":"hard edges"})");
  const std::string text = rigToJson(rig);
  EXPECT_EQ(text, readWholeFile(dataFile("v1-creased.rig.json"), 1 << 20).value());
  rig.smoothing.creaseAngle = kDefaultCreaseAngle;
  EXPECT_EQ(rigToJson(rig).find("crease_angle"), std::string::npos);
  EXPECT_FALSE(rig == loaded.value());
}

TEST(RigJson, GroovesAreWrittenOnlyIfSoft) {
  const std::string crisp = readWholeFile(dataFile("v1-creased.rig.json"), 1 << 20).value();
  Rig rig = rigFromJson(crisp).value();
  EXPECT_EQ(rig.surface.grooves, 0.0f);
  rig.surface.grooves = kNewGrooves;
  const std::string text = rigToJson(rig);
  EXPECT_NE(text.find("\"skin_blend\": 0.04, \"grooves\": 0.015 }"), std::string::npos) << text;
  EXPECT_NE(text.find("\"version\": 1,"), std::string::npos) << "older programs keep the key";
  const auto read = rigFromJson(text);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_TRUE(read.value() == rig);
  rig.surface.grooves = 0.0f;
  EXPECT_EQ(rigToJson(rig), crisp);
}

TEST(RigJson, AmountsOfLinksAreWrittenOnlyIfInPart) {
  Rig rig;
  rig.character = "fox.glb";
  rig.groups = {{"legs", {}}, {"torso", {}}, {"arms", {}}};
  rig.links = {{{"legs", "torso"}, 1.0f}};
  const std::string whole = rigToJson(rig);
  EXPECT_NE(whole.find("[\"legs\", \"torso\"]"), std::string::npos) << whole;
  EXPECT_NE(whole.find("\"version\": 1,"), std::string::npos) << "as programs without amounts write and read it";
  rig.links.push_back({{"torso", "arms"}, 0.4f});
  const std::string part = rigToJson(rig);
  EXPECT_NE(part.find("[\"torso\", \"arms\", 0.4]"), std::string::npos) << part;
  EXPECT_NE(part.find("\"version\": 2,"), std::string::npos);
  EXPECT_EQ(rigFromJson(part).value(), rig);
}

TEST(RigJson, LinksWithMoreThanAnAmountAreObjects) {
  Rig rig;
  rig.character = "fox.glb";
  rig.groups = {{"legs", {}}, {"torso", {}}, {"arms", {}}};
  rig.links = {{{"legs", "torso"}, 0.5f}, {{"torso", "arms"}}};
  const std::string constant = rigToJson(rig);
  rig.links[0].animated = {{Parameter::kLinkAmount, {{"Walk", {{{0.0f, 0.2f}}, CurveKind::kSmooth}, {}}}, {}, {}}};
  rig.links[1].unknownKeys = R"({"later":[1]})";
  const std::string text = squeezed(rigToJson(rig));
  EXPECT_TRUE(has(text, R"("version":3)")) << text;
  EXPECT_TRUE(has(text, R"({"groups":["legs","torso"],"amount":0.5,"animated":[{"parameter":"link_amount",)"
                        R"("keys":[{"clip":"Walk","times":[0],"values":[0.2]}]}]})"))
      << text;
  EXPECT_TRUE(has(text, R"({"groups":["torso","arms"],"later":[1]})")) << text;
  const Result<Rig> read = rigFromJson(rigToJson(rig));
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read.value(), rig);
  for (Link& link : rig.links) link = {link.groups, link.amount};
  EXPECT_EQ(rigToJson(rig), constant);
}

TEST(RigJson, AutoDepthIsWrittenOnlyIfOn) {
  const auto loaded = loadRig(dataFile("v1-auto.rig.json"));
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  Rig rig = loaded.value();
  EXPECT_TRUE(rig.smoothing.autoDepth);
  EXPECT_EQ(rig.smoothing.depth, 5);
  EXPECT_EQ(rig.smoothing.unknownKeys, R"({"x-why":"near and far"})");
  EXPECT_EQ(rigToJson(rig), readWholeFile(dataFile("v1-auto.rig.json"), 1 << 20).value());
  rig.smoothing.autoDepth = false;
  EXPECT_EQ(rigToJson(rig).find("auto_depth"), std::string::npos);
  EXPECT_FALSE(rig == loaded.value());
}

TEST(RigJson, UnknownKeysRoundTripDigitForDigit) {
  const auto rig = loadRig(dataFile("v1-full.rig.json"));
  ASSERT_TRUE(rig.ok());
  const std::string text = rigToJson(rig.value());
  for (const char* kept :
       {R"("x-shade": "matte")", R"("on": true)", R"("levels": [1, 2.50, 3])", R"("x-color": "#ff8800")",
        R"("x-locked": true)", R"("big": 123456789012345678901234567890)", "Käthe"}) {
    EXPECT_NE(text.find(kept), std::string::npos) << kept << '\n' << text;
  }
  EXPECT_EQ(rigToJson(rigFromJson(text).value()), text);
}

/// The full sample with one replacement.
std::string fullWith(const std::string& from, const std::string& to) {
  std::string text = readWholeFile(dataFile("v1-full.rig.json"), 1 << 20).value();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(RigJson, OldProjectionSettingsOnlySelectTheDirection) {
  Rig rig = loadRig(dataFile("v1-full.rig.json")).value();
  EXPECT_EQ(rigToJson(rig).find("projection"), std::string::npos);
  EXPECT_TRUE(rigFromJson(fullWith("\"bisection\"", "\"newton\"")).value() == rig);
  rig.smoothing.alongNormals = true;
  EXPECT_TRUE(rigFromJson(fullWith("\"bisection\"", "\"analytic\"")).value() == rig);
  EXPECT_TRUE(rigFromJson(rigToJson(rig)).value() == rig);
}

struct BadRig {
  const char* from;
  const char* to;
  const char* place;
  const char* reason;  // Part of it.
};

class BadRigs : public ::testing::TestWithParam<BadRig> {};

TEST_P(BadRigs, IsRefusedWithPlaceAndReason) {
  const auto& [from, to, place, reason] = GetParam();
  const auto rig = rigFromJson(fullWith(from, to));
  ASSERT_FALSE(rig.ok());
  EXPECT_EQ(rig.error().place, place);
  EXPECT_NE(rig.error().reason.find(reason), std::string::npos) << rig.error().text();
  EXPECT_EQ(rig.error().text().find('\n'), std::string::npos);
  // The interface shows the subject without a path into the file. Only a duplicate name has a path in its reason.
  EXPECT_FALSE(rig.error().subject.empty()) << rig.error().text();
  if (rig.error().place.find('[') != std::string::npos) {
    EXPECT_EQ(rig.error().plainText().find(rig.error().place), std::string::npos) << rig.error().plainText();
  }
}

INSTANTIATE_TEST_SUITE_P(
    RigJson, BadRigs,
    ::testing::Values(
        BadRig{"\"sinew-rig\"", "\"other\"", "format", "expected \"sinew-rig\", got \"other\""},
        BadRig{"\"format\": \"sinew-rig\",", "", "format", "the key is missing"},
        BadRig{"\"version\": 1,", "", "version", "the key is missing"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"slots\": {\"wing.L\": \"a\"},", "slots.wing.L",
               "part of the body"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"slots\": {\"tail\": 3},", "slots.tail", "expected"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"slots\": {\"tail\": \"\"},", "slots.tail", "or null"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"slots\": [],", "slots", "an object"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"layers\": [],", "layers", "an object"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"layers\": {\"Shirt\": \"silk\"},", "layers.Shirt", "\"rigid\""},
        BadRig{"\"version\": 1,", "\"version\": 1, \"layers\": {\"Shirt\": 1},", "layers.Shirt", "expected"},
        BadRig{"\"version\": 1,", "\"version\": 1, \"layers\": {\"\": \"skin\"},", "layers.", "expected"},
        BadRig{"\"version\": 1", "\"version\": 5", "version", "newer"},
        BadRig{"\"version\": 1", "\"version\": 0", "version", "expected 1, 2, 3 or 4, got 0"},
        BadRig{"\"version\": 1", "\"version\": \"1\"", "version", "expected 1, 2, 3 or 4, got \"1\""},
        BadRig{"\"character\": \"models/fox.glb\"", "\"character\": 7", "character", "expected a text, got 7"},
        BadRig{"\"models/fox.glb\"", "\"\"", "character", "expected the path of a character"},
        BadRig{"\"character\": \"models/fox.glb\",", "", "character", "the key is missing"},
        BadRig{"{ \"mode\": \"replace\", \"iso\": 0.3, \"skin_blend\": 0.05, \"x-shade\": \"matte\" }", "[]", "surface",
               "expected an object, got an array of 0"},
        BadRig{"\"replace\"", "\"melt\"", "surface.mode", "expected \"swell\" or \"replace\", got \"melt\""},
        BadRig{"\"iso\": 0.3", "\"iso\": 1", "surface.iso", "from 0.001 to 0.999"},
        BadRig{"\"iso\": 0.3", "\"iso\": null", "surface.iso", "expected a number, got null"},
        BadRig{"\"skin_blend\": 0.05", "\"skin_blend\": 0", "surface.skin_blend",
               "expected a number > 0 and at most 10, got 0"},
        BadRig{"\"skin_blend\": 0.05", "\"grooves\": 1.5", "surface.grooves", "expected a number from 0 to 1, got 1.5"},
        BadRig{"\"skin_blend\": 0.05", "\"grooves\": -0.01", "surface.grooves", "from 0 to 1, got -0.01"},
        BadRig{"\"skin_blend\": 0.05", "\"grooves\": \"soft\"", "surface.grooves", "a number, got \"soft\""},
        BadRig{"\"depth\": 5", "\"depth\": 17", "smoothing.depth", "from 1 to 16, got 17"},
        BadRig{"\"depth\": 5", "\"depth\": 2.5", "smoothing.depth", "from 1 to 16, got 2.5"},
        BadRig{"\"depth\": 5", "\"depth\": 99999999999", "smoothing.depth", "got 99999999999"},
        BadRig{"\"phong\"", "3", "smoothing.patch", "got 3"},
        BadRig{"\"bisection\"", "\"magic\"", "smoothing.projection", "got \"magic\""},
        BadRig{"\"bisection\"", "\"newton\", \"crease_angle\": 181", "smoothing.crease_angle",
               "from 0 to 180, got 181"},
        BadRig{"\"bisection\"", "\"newton\", \"crease_angle\": -1", "smoothing.crease_angle", "from 0 to 180, got -1"},
        BadRig{"\"bisection\"", "\"newton\", \"crease_angle\": \"30\"", "smoothing.crease_angle",
               "a number, got \"30\""},
        BadRig{"\"bisection\"", "\"newton\", \"auto_depth\": 1", "smoothing.auto_depth",
               "expected true or false, got 1"},
        BadRig{"\"bisection\"", "\"newton\", \"auto_depth\": \"true\"", "smoothing.auto_depth", "got \"true\""},
        BadRig{"{ \"name\": \"torso\" }", "\"torso\"", "groups[1]", "expected an object, got \"torso\""},
        BadRig{"{ \"name\": \"torso\" }", "{}", "groups[1].name", "the key is missing"},
        BadRig{"{ \"name\": \"torso\" }", "{ \"name\": \"hind legs\" }", "groups[1].name", "groups[0]"},
        BadRig{"{ \"name\": \"torso\" }", "{ \"name\": \"\" }", "groups[1].name", "expected a name"},
        BadRig{"[ [\"hind legs\", \"torso\"] ]", "{}", "links", "expected an array, got an object"},
        BadRig{"[\"hind legs\", \"torso\"] ]", "[\"hind legs\"] ]", "links[0]", "two groups' names"},
        BadRig{"[\"hind legs\", \"torso\"] ]", "[\"hind legs\", \"tail\"] ]", "links[0][1]", "there is no \"tail\""},
        BadRig{"[\"hind legs\", \"torso\"] ]", "[\"torso\", \"torso\"] ]", "links[0]", "two different groups"},
        BadRig{"\"torso\"] ]", "\"torso\", 0] ]", "links[0][2]", "an amount above 0, at most 1, got 0"},
        BadRig{"\"torso\"] ]", "\"torso\", 1.5] ]", "links[0][2]", "at most 1, got 1.5"},
        BadRig{"\"torso\"] ]", "\"torso\", \"half\"] ]", "links[0][2]", "expected a number, got \"half\""},
        BadRig{"\"torso\"] ]", "\"torso\", 0.5, 1] ]", "links[0]", "and an amount if it is not 1"},
        BadRig{"[\"hind legs\", \"torso\"] ]", "{\"amount\": 1} ]", "links[0].groups", "got 0"},
        BadRig{"[\"hind legs\", \"torso\"] ]", "{\"groups\": [\"torso\"]} ]", "links[0].groups",
               "expected two groups' names, got 1"},
        BadRig{"[\"hind legs\", \"torso\"] ]", "{\"groups\": [\"torso\", 3]} ]", "links[0].groups[1]", "got 3"},
        BadRig{"[\"hind legs\", \"torso\"] ]", "{\"groups\": [\"torso\", \"tail\"], \"x\": 1} ]", "links[0].groups[1]",
               "there is no \"tail\""},
        BadRig{"[\"hind legs\", \"torso\"] ]", "{\"groups\": [\"hind legs\", \"torso\"], \"amount\": 0, \"x\": 1} ]",
               "links[0].amount", "an amount above 0, at most 1, got 0"},
        BadRig{"\"name\": \"navel\"", "\"name\": \"thigh L\"", "primitives[2].name", "primitives[0]"},
        BadRig{"\"name\": \"navel\", ", "", "primitives[2].name", "the key is missing"},
        BadRig{"\"bone\": \"b_Spine01_02\", ", "", "primitives[2].bone", "the key is missing"},
        BadRig{"\"bone\": \"b_Spine01_02\"", "\"bone\": \"\"", "primitives[2].bone", "expected a name"},
        BadRig{"\"group\": \"torso\"", "\"group\": \"tail\"", "primitives[2].group", "there is no \"tail\""},
        BadRig{"\"kind\": \"ellipsoid\"", "\"kind\": \"capsule\"", "primitives[0].kind", "expected \"ellipsoid\""},
        BadRig{"\"center\": [0,4.5,-1], ", "", "primitives[0].center", "the key is missing"},
        BadRig{"[0,4.5,-1]", "[0,4.5]", "primitives[0].center", "array of 3 numbers, got an array of 2"},
        BadRig{"[0,4.5,-1]", "[0,\"4.5\",-1]", "primitives[0].center[1]", "expected a number, got \"4.5\""},
        BadRig{"[0,4.5,-1]", "[0,null,-1]", "primitives[0].center[1]", "expected a number, got null"},
        BadRig{"[0,4.5,-1]", "[0,4.5,1e999]", "primitives[0].center[2]", "expected a finite number, got 1e999"},
        BadRig{"[0,4.5,-1]", "[0,4.5,-1e39]", "primitives[0].center[2]", "at most 3.4028235e+38, got -1e39"},
        BadRig{"[0,0,0,1]", "[0,0,0,0]", "primitives[0].rotation", "length 1, got 0"},
        BadRig{"[0,0,0,1]", "[0,0,0,1.002]", "primitives[0].rotation", "length 1, got 1.002"},
        BadRig{"[0,0,0,1]", "[0,0,1]", "primitives[0].rotation", "array of 4 numbers"},
        BadRig{"[1,2,3], \"sign\"", "[1,0,3], \"sign\"", "primitives[2].radii[1]", "expected a number > 0, got 0"},
        BadRig{"[1,2,3], \"sign\"", "[1,2,-3], \"sign\"", "primitives[2].radii[2]", "expected a number > 0, got -3"},
        BadRig{"[1,2,3], \"sign\"", "[1,1e-60,3], \"sign\"", "primitives[2].radii[1]", "expected a number > 0, got 0"},
        BadRig{"\"reach\": 1.4142135", "\"reach\": 1", "primitives[0].reach", "expected a number > 1, got 1"},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"core\": 0.96", "primitives[2].core", "from 0 to 0.95, got 0.96"},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"core\": -0.1", "primitives[2].core", "from 0 to 0.95, got -0.1"},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"core\": \"0\"", "primitives[2].core", "a number, got \"0\""},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"belly\": 0.9", "primitives[2].belly",
               "the most at this reach, got 0.9"},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"bend\": [0, 1.5]", "primitives[2].bend[1]", "from -1 to 1, got 1.5"},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"bend\": 0.5", "primitives[2].bend", "array of 2 numbers, got 0.5"},
        BadRig{"\"sign\": -1", "\"sign\": 0", "primitives[2].sign", "expected 1 or -1, got 0"},
        BadRig{"\"mirror\": \"thigh R\"", "\"mirror\": \"thigh X\"", "primitives[0].mirror", "there is no \"thigh X\""},
        BadRig{"\"mirror\": \"thigh R\"", "\"mirror\": \"thigh L\"", "primitives[0].mirror", "got its own"},
        BadRig{"\"mirror\": \"thigh R\"", "\"mirror\": \"navel\"", "primitives[0].mirror", "whose mirror is this one"},
        BadRig{"\"mirror\": \"thigh R\"", "\"mirror\": \"\"", "primitives[0].mirror", "another primitive"},
        BadRig{"\"mirror\": \"thigh R\"", "\"mirror\": null", "primitives[0].mirror", "expected a text, got null"},
        BadRig{"[\"b_Spine01_02\", \"b_Hip_01\"]", "\"b_Hip_01\"", "primitives[2].territory", "expected an array"},
        BadRig{"[\"b_Spine01_02\", \"b_Hip_01\"]", "[\"b_Hip_01\", 4]", "primitives[2].territory[1]", "got 4"},
        BadRig{"\"sign\": -1", "\"sign\": -1, \"sign\": 1", "primitives[2].sign", "appears twice"}));

TEST(RigJson, BareNanIsLocatedByByteLineAndPath) {
  const auto rig = rigFromJson(fullWith("[1,2,3], \"sign\"", "[1,NaN,3], \"sign\""));
  ASSERT_FALSE(rig.ok());
  EXPECT_TRUE(rig.error().place.starts_with("byte ")) << rig.error().text();
  EXPECT_NE(rig.error().place.find("line 14"), std::string::npos) << rig.error().text();
  EXPECT_NE(rig.error().reason.find("primitives[2].radii[1]"), std::string::npos) << rig.error().text();
}

TEST(RigJson, WrongRootIsRefused) {
  for (const char* text : {"[]", "null", "3", "\"sinew-rig\"", "{}", ""}) EXPECT_FALSE(rigFromJson(text).ok()) << text;
}

TEST(RigJson, PrefixesAndChangedBytesAreSafe) {
  const std::string text = readWholeFile(dataFile("v1-full.rig.json"), 1 << 20).value();
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    ASSERT_FALSE(rigFromJson(text.substr(0, length)).ok()) << length;
  }
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char byte : {'\0', '"', '9', '-', '\xff'}) {
      std::string changed = text;
      changed[i] = byte;
      const auto rig = rigFromJson(changed);
      ASSERT_TRUE(!rig.ok() || validate(rig.value()).ok()) << i;
    }
  }
}

TEST_F(RigFiles, SavedRigLoadsEqual) {
  const Rig rig = test::randomDocument(3);
  const fs::path file = folder_ / "a rig.rig.json";
  ASSERT_TRUE(saveRig(rig, file).ok());
  const auto back = loadRig(file);
  ASSERT_TRUE(back.ok()) << back.error().text();
  EXPECT_TRUE(back.value() == rig);
}

TEST_F(RigFiles, InvalidRigsDoNotOverwriteValidOnes) {
  const fs::path file = folder_ / "good.rig.json";
  Rig rig = test::randomDocument(3);
  ASSERT_TRUE(saveRig(rig, file).ok());
  const std::string before = readWholeFile(file, 1 << 20).value();
  rig.surface.iso = 2.0f;
  const auto saved = saveRig(rig, file);
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().place, "surface.iso");
  EXPECT_EQ(saved.error().file, file.string());
  EXPECT_EQ(readWholeFile(file, 1 << 20).value(), before);
  EXPECT_FALSE(saveRig(Rig{}, file).ok()) << "a rig without a character is no file";
}

TEST_F(RigFiles, CharacterPathsResolveToTheSameFile) {
  fs::create_directories(folder_ / "rigs/deep");
  fs::create_directories(folder_ / "models");
  std::ofstream(folder_ / "models/fox.glb") << "fox";
  fs::create_directory_symlink(folder_ / "rigs/deep", folder_ / "short");
  for (const char* place :
       {"a.rig.json", "models/a.rig.json", "rigs/a.rig.json", "rigs/deep/a.rig.json", "short/a.rig.json"}) {
    const fs::path rigFile = folder_ / place;
    Rig rig;
    rig.character = relativeCharacterPath(folder_ / "models/fox.glb", rigFile);
    EXPECT_FALSE(fs::path(rig.character).is_absolute()) << rig.character;
    std::error_code failed;
    EXPECT_TRUE(fs::equivalent(characterPath(rig, rigFile), folder_ / "models/fox.glb", failed))
        << place << ' ' << rig.character;
  }
  EXPECT_EQ(relativeCharacterPath(folder_ / "models/fox.glb", folder_ / "models/a.rig.json"), "fox.glb");
  Rig absolute;
  absolute.character = "/far/fox.glb";
  EXPECT_EQ(characterPath(absolute, folder_ / "a.rig.json"), fs::path("/far/fox.glb"));
}

TEST_F(RigFiles, LoadErrorsNameTheFile) {
  const auto absent = loadRig(folder_ / "none.rig.json");
  ASSERT_FALSE(absent.ok());
  EXPECT_EQ(absent.error().file, (folder_ / "none.rig.json").string());
  const fs::path file = folder_ / "bad.rig.json";
  std::ofstream(file) << "{}";
  const auto bad = loadRig(file);
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().text(), file.string() + ": format: expected \"sinew-rig\", but the key is missing");
}

}  // namespace
}  // namespace sinew
