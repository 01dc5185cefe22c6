// tests/files/export/usd_stage_test.cpp: time samples of points, faces of mirrored meshes, colors, names, and invalid
// stages.

#include "core/files/usd/stage.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "core/files/disk/atomic_file.h"
#include "core/files/export/out_primitive.h"
#include "core/files/usd/text.h"
#include "sinew/surface/smoother.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

/// The numbers in a line, whatever separates them.
std::vector<float> numbersIn(std::string_view line) {
  std::vector<float> numbers;
  for (std::size_t i = 0; i < line.size();) {
    float number = 0.0f;
    const auto [end, error] = std::from_chars(line.data() + i, line.data() + line.size(), number);
    if (error == std::errc()) numbers.push_back(number);
    i = error == std::errc() ? static_cast<std::size_t>(end - line.data()) : i + 1;
  }
  return numbers;
}

/// [samples] of the n-th attribute of that name: the time code, then the values.
std::vector<std::vector<float>> samplesOf(const std::string& text, const std::string& name, std::size_t mesh) {
  std::size_t at = 0;
  for (std::size_t m = 0; m <= mesh; ++m) {
    at = text.find(name + ".timeSamples = {\n", at);
    if (at == std::string::npos) return {};
    at = text.find('\n', at) + 1;
  }
  std::vector<std::vector<float>> samples;
  for (;; at = text.find('\n', at) + 1) {
    const std::string line = text.substr(at, text.find('\n', at) - at);
    if (line.find('}') != std::string::npos) return samples;
    samples.push_back(numbersIn(line));
  }
}

std::vector<float> flat(float code, const std::vector<glm::vec3>& vectors) {
  std::vector<float> numbers{code};
  for (const glm::vec3& v : vectors) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  return numbers;
}

class UsdStage : public ::testing::Test {
 protected:
  /// The skinned export of a character, whose vertices are those that the smoother's surface gives to.
  void SetUp() override {
    scene_ = bundledScene("demo");
    const auto path = folder_.path() / "out.glb";
    ASSERT_TRUE(scene_.writeQuickly(path, {.weights = ExportWeights::kTransferred}).ok());
    bytes_ = readWholeBytes(path, 1 << 28).value();
    root_ = Json::parse(gltf::openContainer(bytes_).json).value();
    exporting::Source source(scene_.characterFile);
    ASSERT_TRUE(smoother_.emplace(scene_.character).prepare(scene_.rig).ok());
    smoother_->smooth(bindPose(scene_.character->skeleton), surface_);
    for (const gltf::SoupPart& part : source.origin.parts) {
      primitives_.push_back(exporting::refinedPrimitive(source, part, scene_.character->mesh, surface_));
    }
  }

  std::vector<usd::MeshPoints> live(float time) {
    smoother_->smooth(samplePose(scene_.character->skeleton, scene_.character->clips.front(), time), surface_);
    std::vector<usd::MeshPoints> meshes;
    for (const exporting::RefinedPrimitive& primitive : primitives_) {
      usd::MeshPoints& mesh = meshes.emplace_back();
      for (std::size_t v = 0; v < primitive.refined.size(); ++v) {
        mesh.points.push_back(surface_.positions[static_cast<std::size_t>(primitive.refined[v])]);
        mesh.normals.push_back(shadingNormal(surface_, static_cast<std::size_t>(primitive.drawn[v])));
      }
    }
    return meshes;
  }

  usd::Stage stage(const usd::PointMoments& moments) const {
    gltf::File file(bytes_, ".");
    return usd::pointStage(file, root_, "demo points", moments);
  }

  TemporaryFolder folder_;
  ExportScene scene_;
  std::vector<std::uint8_t> bytes_;
  Json root_;
  std::optional<Smoother> smoother_;
  Surface surface_;
  std::vector<exporting::RefinedPrimitive> primitives_;
};

TEST_F(UsdStage, PointsMatchTheLiveSurfaceAtEverySample) {
  std::vector<std::vector<usd::MeshPoints>> shown;
  const usd::PointMoments moments{24.0, {0.0, 1.0, 7.5}, [&](std::size_t m, std::vector<usd::MeshPoints>& meshes) {
                                    ASSERT_EQ(m, shown.size());
                                    meshes = live(static_cast<float>(m) * 0.125f);
                                    shown.push_back(meshes);
                                  }};
  const usd::Stage made = stage(moments);
  ASSERT_EQ(shown.size(), 3U);
  ASSERT_NE(shown[0][0].points, shown[1][0].points);
  const float codes[] = {0.0f, 1.0f, 7.5f};
  for (std::size_t mesh = 0; mesh < primitives_.size(); ++mesh) {
    const auto points = samplesOf(made.text, "point3f[] points", mesh);
    const auto normals = samplesOf(made.text, "normal3f[] normals", mesh);
    const auto extents = samplesOf(made.text, "float3[] extent", mesh);
    ASSERT_EQ(points.size(), 3U);
    ASSERT_EQ(normals.size(), 3U);
    ASSERT_EQ(extents.size(), 3U);
    for (std::size_t m = 0; m < 3; ++m) {
      EXPECT_EQ(points[m], flat(codes[m], shown[m][mesh].points));
      EXPECT_EQ(normals[m], flat(codes[m], shown[m][mesh].normals));
      const Bounds bounds = boundsOf(shown[m][mesh].points);
      EXPECT_EQ(extents[m], flat(codes[m], {bounds.low, bounds.high}));
    }
  }
  for (const char* words :
       {"def Xform \"demo_points\"", "endTimeCode = 7.5\n", "timeCodesPerSecond = 24\n", "metersPerUnit = 1\n",
        "upAxis = \"Y\"\n", "displayName = \"demo points\"", "@demo points_0.png@"}) {
    EXPECT_NE(made.text.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(made.text.find("Skel"), std::string::npos);
  ASSERT_EQ(made.textures.size(), 1U);
  shown.clear();
  EXPECT_EQ(stage(moments).text, made.text);
}

TEST_F(UsdStage, SamplesWithMissingPointsAreRefused) {
  const auto refuses = [&](const std::function<void(std::vector<usd::MeshPoints>&)>& spoil) {
    const usd::PointMoments moments{30.0, {0.0}, [&](std::size_t, std::vector<usd::MeshPoints>& meshes) {
                                      meshes = live(0.0f);
                                      spoil(meshes);
                                    }};
    EXPECT_THROW((void)stage(moments), gltf::Refusal);
  };
  refuses([](auto& meshes) { meshes.pop_back(); });
  refuses([](auto& meshes) { meshes.front().points.pop_back(); });
  refuses([](auto& meshes) { meshes.front().normals.pop_back(); });
}

/// The numbers of the first attribute of that name.
std::vector<float> valuesOf(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name + " = ");
  EXPECT_NE(at, std::string::npos) << name;
  if (at == std::string::npos) return {};
  const std::size_t begin = at + name.size();
  return numbersIn(std::string_view(text).substr(begin, text.find('\n', begin) - begin));
}

std::string skinnedText(const Post& post) {
  const std::string glb = post.file.glb();
  const std::vector<std::uint8_t> bytes(glb.begin(), glb.end());
  gltf::File file(bytes, ".");
  return usd::skinnedStage(file, Json::parse(gltf::openContainer(bytes).json).value(), "post").text;
}

/// Negative if the faces look inwards.
float volumeInBindPose(const std::string& text) {
  const std::vector<float> points = valuesOf(text, "point3f[] points");
  const std::vector<float> corners = valuesOf(text, "int[] faceVertexIndices");
  const std::vector<float> rows = valuesOf(text, "matrix4d primvars:skel:geomBindTransform");
  EXPECT_EQ(rows.size(), 16U);
  glm::mat4 meshToBind(0.0f);  // USD's rows are glm's columns.
  for (std::size_t i = 0; i < rows.size(); ++i) meshToBind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = rows[i];
  const auto place = [&](std::size_t corner) {
    const std::size_t v = 3 * static_cast<std::size_t>(corners.at(corner));
    return glm::vec3(meshToBind * glm::vec4(points.at(v), points.at(v + 1), points.at(v + 2), 1.0f));
  };
  float volume = 0.0f;
  for (std::size_t c = 0; c + 2 < corners.size(); c += 3) {
    volume += glm::dot(place(c), glm::cross(place(c + 1), place(c + 2))) / 6.0f;
  }
  return volume;
}

TEST(UsdMesh, MirroredFacesLookOutwards) {
  for (const float side : {1.0f, -1.0f}) {
    Post post = makePost();
    std::vector<float> inverseBinds;
    for (const float below : {0.0f, -1.0f}) {  // The joints are at y = 0 and 1.
      const std::vector<float> one{side, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, below, 0, 1};
      inverseBinds.insert(inverseBinds.end(), one.begin(), one.end());
    }
    post.file.json["skins"][0]["inverseBindMatrices"] = post.file.accessor(inverseBinds, "MAT4");
    EXPECT_FLOAT_EQ(volumeInBindPose(skinnedText(post)), 2.0f) << side;  // 1 x 2 x 1
  }
}

TEST(UsdMesh, VertexColorsAndOpacityIncludeTheMaterials) {
  Post post = makePost();
  std::vector<float> colors;
  std::vector<float> shown;
  std::vector<float> opacities;
  for (int v = 0; v < 12; ++v) {
    const float alpha = static_cast<float>(v + 4) / 16.0f;
    colors.insert(colors.end(), {0.5f, 0.25f, 1.0f, alpha});
    shown.insert(shown.end(), {0.25f, 0.25f, 0.125f});
    opacities.push_back(0.5f * alpha);
  }
  post.attributes()["COLOR_0"] = post.file.accessor(colors, "VEC4");
  post.primitive()["material"] = 0;
  post.file.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1.0, 0.125, 0.5}}}}});
  const std::string text = skinnedText(post);
  EXPECT_EQ(valuesOf(text, "color3f[] primvars:displayColor"), shown);
  EXPECT_EQ(valuesOf(text, "float[] primvars:displayOpacity"), opacities);
}

TEST(UsdText, NumbersRoundTrip) {
  for (const float number : {0.1f, -0.0f, 1e-30f, 3.4028235e38f, 16777217.0f, 1.0f / 3.0f}) {
    std::string text;
    usd::appendNumber(text, number);
    EXPECT_EQ(numbersIn(text), std::vector<float>{number}) << text;
  }
  EXPECT_EQ(usd::numberText(std::numeric_limits<double>::quiet_NaN()), "0");
  EXPECT_EQ(usd::tupleText(glm::quat(0.5f, 1.0f, 2.0f, 3.0f)), "(0.5, 1, 2, 3)");
}

TEST(UsdText, NamesAreUniqueIdentifiers) {
  EXPECT_EQ(usd::identifierOf("mixamorig:Hips", "Joint"), "mixamorig_Hips");
  EXPECT_EQ(usd::identifierOf("9 toe", "Joint"), "_9_toe");
  EXPECT_EQ(usd::identifierOf("h\xc3\xbc"
                              "fte",
                              "Joint"),
            "h_fte");
  EXPECT_EQ(usd::identifierOf("\xe9\xaa\xa8", "Joint"), "Joint");
  EXPECT_EQ(usd::identifierOf("", "Joint"), "Joint");
  usd::Siblings siblings;
  EXPECT_EQ(siblings.fresh("a"), "a");
  EXPECT_EQ(siblings.fresh("a_2"), "a_2");
  EXPECT_EQ(siblings.fresh("a"), "a_3");
  EXPECT_EQ(usd::quoted("a \"b\""), "'a \"b\"'");
  EXPECT_EQ(usd::quoted("it's \"b\" \\\n\x01"), "\"it's \\\"b\\\" \\\\\\n\\x01\"");
}

TEST(UsdJoints, FramesAreWholeFramesAndTheEnd) {
  const auto frames = [](float duration) { return usd::framesOf({.name = {}, .duration = duration, .channels = {}}); };
  EXPECT_EQ(frames(0.0f), (std::vector<double>{0.0}));
  EXPECT_EQ(frames(0.1f).size(), 4U);  // 0.1 as a float is slightly more than three frames.
  EXPECT_EQ(frames(0.125f), (std::vector<double>{0.0, 1.0, 2.0, 3.0, 3.75}));
}

TEST(UsdJoints, HugeClipsAreRefused) {
  gltf::BoundSkeleton bound;
  bound.skeleton.nodes.resize(1);
  bound.skeleton.bones.resize(1);
  bound.skeleton.bindings.resize(1);
  AnimationClip clip{.name = "long", .duration = 1e9f, .channels = {}};
  EXPECT_THROW((void)usd::jointsOf(bound, std::span(&clip, 1)), gltf::Refusal);
  clip.duration = 1.0f;
  EXPECT_EQ(usd::jointsOf(bound, std::span(&clip, 1)).clips.front().frames.size(), 31U);
}

}  // namespace
}  // namespace sinew::test
