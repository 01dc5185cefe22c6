// tests/files/gltf_colors_test.cpp: COLOR_0 in all its types, in some primitives only, and malformed.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;
using test::makePost;
using test::Post;

Result<std::shared_ptr<const Character>> importPost(const Post& post) {
  const test::TemporaryFolder folder;
  return importGltf(folder.write("post.glb", post.file.glb()));
}

std::shared_ptr<const Character> imported(const Post& post) {
  const auto character = importPost(post);
  if (!character) {
    ADD_FAILURE() << character.error().text();
    return std::make_shared<Character>();
  }
  return character.value();
}

/// Red by height, green by side, blue and alpha by number: all vertices differ.
glm::vec4 colorOf(std::size_t vertex, bool withAlpha) {
  const auto v = static_cast<float>(vertex);
  return {std::floor(v / 4.0f) / 2.0f, vertex % 2 == 0 ? 0.0f : 1.0f, v / 255.0f,
          withAlpha ? (255.0f - v) / 255.0f : 1.0f};
}

template <class Component>
std::vector<Component> components(bool withAlpha, float one) {
  std::vector<Component> result;
  for (std::size_t v = 0; v < 12; ++v) {
    for (int channel = 0; channel < (withAlpha ? 4 : 3); ++channel) {
      const float value = one * colorOf(v, withAlpha)[channel];
      result.push_back(static_cast<Component>(std::is_integral_v<Component> ? std::round(value) : value));
    }
  }
  return result;
}

/// Vertex of the post at a position of the welded mesh.
std::size_t postVertex(const Post& post, const glm::vec3& p) {
  for (std::size_t v = 0; v < 12; ++v) {
    if (p == glm::vec3(post.positions[3 * v], post.positions[3 * v + 1], post.positions[3 * v + 2])) return v;
  }
  ADD_FAILURE() << "no vertex of the post";
  return 0;
}

void expectColors(const Post& post, const Character& character, bool withAlpha, float tolerance) {
  ASSERT_EQ(character.mesh.wedges.size(), 12u);
  for (const Wedge& wedge : character.mesh.wedges) {
    const std::size_t v = postVertex(post, character.mesh.positions[static_cast<std::size_t>(wedge.vertex)]);
    for (int channel = 0; channel < 4; ++channel) {
      EXPECT_NEAR(wedge.color[channel], colorOf(v, withAlpha)[channel], tolerance) << v << ", " << channel;
    }
  }
  EXPECT_TRUE(character.ignored.empty()) << character.ignored.front();
}

TEST(GltfColors, AcceptEveryTypeGltfAllows) {
  for (const bool withAlpha : {false, true}) {
    const std::string type = withAlpha ? "VEC4" : "VEC3";
    Post floats = makePost();
    floats.attributes()["COLOR_0"] = floats.file.accessor(components<float>(withAlpha, 1.0f), type);
    expectColors(floats, *imported(floats), withAlpha, 0.0f);
    Post bytes = makePost();
    bytes.attributes()["COLOR_0"] = bytes.file.accessor(components<std::uint8_t>(withAlpha, 255.0f), type, true);
    expectColors(bytes, *imported(bytes), withAlpha, 0.0021f);
    Post shorts = makePost();
    shorts.attributes()["COLOR_0"] = shorts.file.accessor(components<std::uint16_t>(withAlpha, 65535.0f), type, true);
    expectColors(shorts, *imported(shorts), withAlpha, 1e-5f);
  }
}

TEST(GltfColors, FloatsBeyondTheRangeAreClamped) {
  Post post = makePost();
  std::vector<float> colors;
  for (int v = 0; v < 12; ++v) colors.insert(colors.end(), {2.0f, -1.0f, 0.5f, 1e30f});
  post.attributes()["COLOR_0"] = post.file.accessor(colors, "VEC4");
  const auto character = imported(post);
  for (const Wedge& wedge : character->mesh.wedges) EXPECT_EQ(wedge.color, glm::vec4(1.0f, 0.0f, 0.5f, 1.0f));
}

TEST(GltfColors, NonFiniteColorsAreWhiteWithANote) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Post post = makePost();
    std::vector<float> colors(48, 0.25f);
    colors[5] = bad;
    post.attributes()["COLOR_0"] = post.file.accessor(colors, "VEC4");
    const auto character = imported(post);
    ASSERT_EQ(character->ignored.size(), 1u);
    EXPECT_EQ(character->ignored[0], "vertex colours that are not finite are ignored: white is used");
    EXPECT_EQ(std::ranges::count(character->mesh.wedges, glm::vec4(1.0f), &Wedge::color), 1);
    EXPECT_EQ(std::ranges::count(character->mesh.wedges, glm::vec4(0.25f), &Wedge::color), 11);
  }
}

/// The lower half of the post in one primitive, the rest in another; colors in either one, in either order.
TEST(GltfColors, PrimitivesWithoutColorsAreWhite) {
  for (const bool coloredFirst : {true, false}) {
    Post post = makePost();
    const std::vector<std::uint16_t> lower(post.indices.begin(), post.indices.begin() + 24);
    const std::vector<std::uint16_t> upper(post.indices.begin() + 24, post.indices.end());
    ordered_json colored = post.primitive();
    colored["indices"] = post.file.accessor(lower, "SCALAR");
    colored["attributes"]["COLOR_0"] = post.file.accessor(std::vector<float>(36, 0.5f), "VEC3");
    ordered_json white = post.primitive();
    white["indices"] = post.file.accessor(upper, "SCALAR");
    ordered_json& primitives = post.file.json["meshes"][0]["primitives"];
    primitives = coloredFirst ? ordered_json::array({colored, white}) : ordered_json::array({white, colored});
    const auto character = imported(post);
    ASSERT_EQ(character->mesh.triangles.size(), 20u);
    EXPECT_EQ(character->mesh.positions.size(), 12u) << "colors never split vertices";
    // Eight lower corners in gray; twelve of the rest in white, of which the lower two rings are duplicated.
    EXPECT_EQ(character->mesh.wedges.size(), 20u);
    for (std::size_t t = 0; t < 20; ++t) {
      const bool gray = coloredFirst ? t < 8 : t >= 12;
      for (const int wedge : character->mesh.triangles[t].wedges) {
        const glm::vec4 expected = gray ? glm::vec4(0.5f, 0.5f, 0.5f, 1.0f) : glm::vec4(1.0f);
        EXPECT_EQ(character->mesh.wedges[static_cast<std::size_t>(wedge)].color, expected) << t;
      }
    }
  }
}

struct BadColors {
  const char* name;
  std::function<void(Post&)> bend;
  const char* place;   ///< "#": the number of the newest accessor.
  const char* reason;  ///< Part of the reason.
};

void PrintTo(const BadColors& bad, std::ostream* out) { *out << bad.name; }

class BadGltfColors : public testing::TestWithParam<BadColors> {};

TEST_P(BadGltfColors, AreRefusedWithPlaceAndReason) {
  Post post = makePost();
  GetParam().bend(post);
  std::string place = GetParam().place;
  if (const auto hash = place.find('#'); hash != std::string::npos) {
    place.replace(hash, 1, std::to_string(post.file.json["accessors"].size() - 1));
  }
  const auto character = importPost(post);
  ASSERT_FALSE(character.ok());
  EXPECT_EQ(character.error().place, place);
  EXPECT_NE(character.error().reason.find(GetParam().reason), std::string::npos) << character.error().text();
}

constexpr const char* kAttribute = "meshes[0].primitives[0].attributes.COLOR_0";
constexpr const char* kTypes = "colours must be floats, or normalized unsigned bytes or shorts";

template <class Component>
std::function<void(Post&)> with(const std::string& type, std::size_t count, bool normalized) {
  return [=](Post& post) {
    post.attributes()["COLOR_0"] = post.file.accessor(std::vector<Component>(count, Component{1}), type, normalized);
  };
}

const BadColors kBadColors[] = {
    {"scalar", with<float>("SCALAR", 12, false), kAttribute, "is SCALAR; VEC3 or VEC4 expected"},
    {"two channels", with<float>("VEC2", 24, false), kAttribute, "is VEC2; VEC3 or VEC4 expected"},
    {"too few", with<float>("VEC4", 44, false), "accessors[#]", "11 values of COLOR_0 for 12 positions"},
    {"bytes that are not normalized", with<std::uint8_t>("VEC4", 48, false), "accessors[#]", kTypes},
    {"shorts that are not normalized", with<std::uint16_t>("VEC3", 36, false), "accessors[#]", kTypes},
    {"signed bytes", with<std::int8_t>("VEC4", 48, true), "accessors[#]", kTypes},
    {"signed shorts", with<std::int16_t>("VEC4", 48, true), "accessors[#]", kTypes},
    {"whole numbers", with<std::uint32_t>("VEC4", 48, true), "accessors[#]", kTypes},
    {"no such accessor", [](Post& post) { post.attributes()["COLOR_0"] = 99; }, kAttribute, "there is no accessor 99"},
    {"no index", [](Post& post) { post.attributes()["COLOR_0"] = "red"; }, kAttribute, "expected a number"},
    {"beyond the buffer",
     [](Post& post) {
       with<float>("VEC4", 48, false)(post);
       post.file.json["accessors"].back()["byteOffset"] = 16;
     },
     "accessors[#]", "bytes"},
};

INSTANTIATE_TEST_SUITE_P(All, BadGltfColors, testing::ValuesIn(kBadColors));

}  // namespace
}  // namespace sinew
