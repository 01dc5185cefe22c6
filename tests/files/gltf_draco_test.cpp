// tests/files/gltf_draco_test.cpp: Draco-compressed meshes: valid, damaged, and inconsistent with the file's
// declarations.

#include <functional>

#include <gtest/gtest.h>

#include "tests/files/no_harm.h"
#include "tests/files/same_triangles.h"
#include "tests/support/characters/compressed_post.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

Post compressedPost(DracoMethod method = DracoMethod::kEdgebreaker) {
  Post post = makePost();
  useDraco(post, dracoPost(post, method));
  return post;
}

ordered_json& dracoAccessor(Post& post, const std::string& attribute) {
  return post.file.json["accessors"][post.attributes()[attribute].get<std::size_t>()];
}

ordered_json& dracoIndices(Post& post) {
  return post.file.json["accessors"][post.primitive()["indices"].get<std::size_t>()];
}

class GltfDraco : public ::testing::TestWithParam<DracoMethod> {
 protected:
  void expectShown(const Post& post) const {
    expectShowsWhatThePlainFileShows(folder_.write("post.glb", post.file.glb()),
                                     folder_.write("plain.glb", makePost().file.glb()), 1e-6);
  }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(, GltfDraco, testing::Values(DracoMethod::kSequential, DracoMethod::kEdgebreaker));

TEST_P(GltfDraco, MatchesThePlainFile) { expectShown(compressedPost(GetParam())); }

TEST_P(GltfDraco, StripDecodesToItsCompressedTriangles) {
  Post post = compressedPost(GetParam());
  post.primitive()["mode"] = 5;
  dracoIndices(post)["count"] = 31;  // Some connectivity for twenty triangles.
  expectShown(post);
}

TEST_P(GltfDraco, UnreferencedAttributesAreIgnored) {
  Post post = compressedPost(GetParam());
  post.attributes().erase("WEIGHTS_0");
  dracoOf(post)["attributes"]["COLOR_0"] = 7;
  EXPECT_TRUE(importGltf(folder_.write("post.glb", post.file.glb())).ok());
}

TEST_P(GltfDraco, JointsMayBeShortsInTheFile) {
  Post post = compressedPost(GetParam());
  dracoAccessor(post, "JOINTS_0")["componentType"] = 5123;
  expectShown(post);
}

TEST_P(GltfDraco, PrimitivesMayShareBytes) {
  Post post = compressedPost(GetParam());
  post.file.json["meshes"].push_back(post.file.json["meshes"][0]);
  expectShown(post);
}

/// The triangles of the post below or above its middle. Unused vertices lie elsewhere, so that positions are rounded to
/// another grid.
Post halfPost(bool above) {
  Post post = makePost();
  std::vector<std::uint16_t> kept;
  std::vector<bool> isUsed(post.positions.size() / 3);
  for (std::size_t i = 0; i < post.indices.size(); i += 3) {
    float middle = 0.0f;
    for (std::size_t k = 0; k < 3; ++k) middle += post.positions[3u * post.indices[i + k] + 1] / 3.0f;
    if ((middle > 1.0f) != above) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      kept.push_back(post.indices[i + k]);
      isUsed[post.indices[i + k]] = true;
    }
  }
  post.indices = kept;
  for (std::size_t v = 0; v < isUsed.size(); ++v) {
    if (isUsed[v]) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) post.positions[3 * v + axis] *= above ? 1.3f : 0.6f;
  }
  return post;
}

TEST_P(GltfDraco, PrimitivesSeparatedByRoundingStayOneSkin) {
  constexpr int kBits = 12;
  Post post = makePost();
  useDraco(post, dracoPost(halfPost(false), GetParam(), kBits));
  const DracoPost above = dracoPost(halfPost(true), GetParam(), kBits);
  ordered_json primitive = post.primitive();
  const auto another = [&](ordered_json& index, int count) {
    ordered_json accessor = post.file.json["accessors"][index.get<std::size_t>()];
    accessor["count"] = count;
    index = post.file.json["accessors"].size();
    post.file.json["accessors"].push_back(accessor);
  };
  for (auto& attribute : primitive["attributes"]) another(attribute, above.vertices);
  another(primitive["indices"], 3 * above.triangles);
  primitive["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = post.file.view(above.bytes);
  post.file.json["meshes"][0]["primitives"].push_back(primitive);
  const auto imported = importGltf(folder_.write("post.glb", post.file.glb()));
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const ControlMesh& mesh = imported.value()->mesh;
  EXPECT_EQ(mesh.positions.size(), 12u);
  EXPECT_EQ(mesh.triangles.size(), 20u);
  for (const Edge& edge : mesh.edges) EXPECT_EQ(edge.triangleCount, 2);
}

TEST_P(GltfDraco, SharedAccessorsMustDecodeToEqualValues) {
  Post post = compressedPost(GetParam());
  Post moved = makePost();
  moved.positions[0] -= 0.25f;
  post.file.json["meshes"].push_back(post.file.json["meshes"][0]);
  post.file.json["meshes"][1]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["bufferView"] =
      post.file.view(dracoPost(moved, GetParam()).bytes);
  const auto imported = importGltf(folder_.write("post.glb", post.file.glb()));
  ASSERT_FALSE(imported.ok());
  EXPECT_NE(imported.error().reason.find("different values"), std::string::npos) << imported.error().text();
}

TEST_P(GltfDraco, PlainCopyIsUsedIfTheExtensionIsOptional) {
  Post post = makePost();
  ordered_json& draco = post.primitive()["extensions"]["KHR_draco_mesh_compression"];
  draco["bufferView"] = post.file.view("no Draco at all");
  draco["attributes"] = {{"POSITION", 0}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}};
  post.file.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  expectShown(post);
}

TEST_P(GltfDraco, RefusesTruncatedBytes) {
  const Post plain = makePost();
  const DracoPost whole = dracoPost(plain, GetParam());
  for (std::size_t length = 0; length < whole.bytes.size(); ++length) {
    Post post = makePost();
    DracoPost cut = whole;
    cut.bytes.resize(length);
    useDraco(post, cut);
    const auto file = folder_.write("cut.glb", post.file.glb());
    expectNoHarm(file);
    // Maybe only padding at the end is missing.
    const bool opens = importGltf(file).ok();
    EXPECT_FALSE(opens && length + 8 < whole.bytes.size()) << length;
  }
}

TEST_P(GltfDraco, FlippedBytesAreSafe) {
  const DracoPost whole = dracoPost(makePost(), GetParam());
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    DracoPost damaged = whole;
    const std::size_t most = seed % 2 == 0 ? damaged.bytes.size() : std::min<std::size_t>(damaged.bytes.size(), 40);
    for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
      damaged.bytes[random() % most] = static_cast<char>(random());
    }
    Post post = makePost();
    useDraco(post, damaged);
    expectNoHarm(folder_.write("flipped.glb", post.file.glb()));
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

/// Draco's variable-length integer, seven bits a byte.
std::string dracoVarint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7U) bytes += static_cast<char>(0x80U | (value & 0x7fU));
  return bytes + static_cast<char>(value);
}

Post postOfBytes(const std::string& bytes) {
  Post post = makePost();
  useDraco(post, {bytes, 12, 20});
  return post;
}

const std::string kEdgebreakerHead("DRACO\x02\x02\x01\x01\x00\x00\x00", 12);  // The last byte: traversal method.
const std::string kSequentialHead("DRACO\x02\x02\x01\x00\x00\x00", 11);

struct DracoTrap {
  const char* name;
  std::function<Post()> make;
  const char* place;   ///< Part of the error's place.
  const char* reason;  ///< Part of its reason.
};

void PrintTo(const DracoTrap& trap, std::ostream* out) { *out << trap.name; }

Post bentDraco(const std::function<void(Post&)>& bend) {
  Post post = compressedPost();
  bend(post);
  return post;
}

class GltfDracoTrap : public ::testing::TestWithParam<DracoTrap> {};

TEST_P(GltfDracoTrap, IsRefusedWithPlaceAndReason) {
  const TemporaryFolder folder;
  const auto file = folder.write("trap.glb", GetParam().make().file.glb());
  const auto imported = importGltf(file);
  ASSERT_FALSE(imported.ok());
  expectOneLine(imported.error(), file);
  EXPECT_NE(imported.error().place.find(GetParam().place), std::string::npos) << imported.error().text();
  EXPECT_NE(imported.error().reason.find(GetParam().reason), std::string::npos) << imported.error().text();
}

void setDracoCounts(Post& post, std::uint64_t count) {
  for (const char* attribute : {"POSITION", "JOINTS_0", "WEIGHTS_0"}) dracoAccessor(post, attribute)["count"] = count;
}

constexpr const char* kDracoPlace = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression";

INSTANTIATE_TEST_SUITE_P(
    Counts, GltfDracoTrap,
    testing::Values(
        DracoTrap{"one vertex more", [] { return bentDraco([](Post& p) { setDracoCounts(p, 13); }); }, kDracoPlace,
                  "vertices; the file declares 13"},
        DracoTrap{"one vertex less", [] { return bentDraco([](Post& p) { setDracoCounts(p, 11); }); }, kDracoPlace,
                  "vertices; the file declares 11"},
        DracoTrap{"very many vertices", [] { return bentDraco([](Post& p) { setDracoCounts(p, 1ULL << 40U); }); },
                  "meshes[0].primitives[0]", "more than 12 million"},
        DracoTrap{"counts that differ",
                  [] { return bentDraco([](Post& p) { dracoAccessor(p, "JOINTS_0")["count"] = 4; }); },
                  "meshes[0].primitives[0].attributes.JOINTS_0", "another count"},
        DracoTrap{"more indices", [] { return bentDraco([](Post& p) { dracoIndices(p)["count"] = 63; }); }, kDracoPlace,
                  "20 triangles; the file declares 63 indices"},
        DracoTrap{"fewer indices", [] { return bentDraco([](Post& p) { dracoIndices(p)["count"] = 57; }); },
                  kDracoPlace, "20 triangles; the file declares 19"},
        DracoTrap{"very many indices",
                  [] { return bentDraco([](Post& p) { dracoIndices(p)["count"] = 1ULL << 40U; }); },
                  "meshes[0].primitives[0]", "more than 2 million"},
        DracoTrap{"a head of very many vertices",
                  [] { return postOfBytes(kEdgebreakerHead + dracoVarint(0xffffffff) + dracoVarint(20) + "\x01\x14"); },
                  kDracoPlace, "4294967295 vertices; the file declares 12"},
        DracoTrap{"a head of very many triangles",
                  [] { return postOfBytes(kEdgebreakerHead + dracoVarint(12) + dracoVarint(0x50000000) + "\x01\x14"); },
                  kDracoPlace, "1342177280 triangles; the file declares 20"},
        DracoTrap{"a sequential head of very many vertices",
                  [] { return postOfBytes(kSequentialHead + dracoVarint(20) + dracoVarint(0xffffffff) + "\x01"); },
                  kDracoPlace, "4294967295 vertices; the file declares 12"},
        DracoTrap{"a sequential head of very many triangles",
                  [] { return postOfBytes(kSequentialHead + dracoVarint(0x50000000) + dracoVarint(12) + "\x01"); },
                  kDracoPlace, "1342177280 triangles; the file declares 20"}));

INSTANTIATE_TEST_SUITE_P(
    Bytes, GltfDracoTrap,
    testing::Values(
        DracoTrap{"no Draco", [] { return postOfBytes("GIF89a, and more than that"); }, kDracoPlace,
                  "not a Draco mesh"},
        DracoTrap{"nothing", [] { return postOfBytes("D"); }, kDracoPlace, "not a Draco mesh"},
        DracoTrap{"an old version", [] { return postOfBytes(std::string("DRACO\x01\x01\x01\x01\x00\x00", 11)); },
                  kDracoPlace, "Draco version 1.1; 2.2 expected"},
        DracoTrap{"a point cloud", [] { return postOfBytes(std::string("DRACO\x02\x02\x00\x01\x00\x00", 11)); },
                  kDracoPlace, "point cloud"},
        DracoTrap{"an unknown method", [] { return postOfBytes(std::string("DRACO\x02\x02\x01\x09\x00\x00", 11)); },
                  kDracoPlace, "unknown kind"},
        DracoTrap{"sequential indices out of range",
                  [] {
                    std::string indices;
                    for (int i = 0; i < 60; ++i) indices += static_cast<char>(i);
                    return postOfBytes(kSequentialHead + dracoVarint(20) + dracoVarint(12) + "\x01" + indices);
                  },
                  kDracoPlace, "damaged"}));

INSTANTIATE_TEST_SUITE_P(
    Json, GltfDracoTrap,
    testing::Values(
        DracoTrap{"no view", [] { return bentDraco([](Post& p) { dracoOf(p).erase("bufferView"); }); }, kDracoPlace,
                  "missing"},
        DracoTrap{"no such view", [] { return bentDraco([](Post& p) { dracoOf(p)["bufferView"] = 99; }); }, kDracoPlace,
                  "there is no element 99"},
        DracoTrap{"a view of text", [] { return bentDraco([](Post& p) { dracoOf(p)["bufferView"] = "7"; }); },
                  kDracoPlace, "whole number"},
        DracoTrap{"no object", [] { return bentDraco([](Post& p) { dracoOf(p) = 3; }); }, kDracoPlace, "missing"},
        DracoTrap{"no attributes", [] { return bentDraco([](Post& p) { dracoOf(p).erase("attributes"); }); },
                  kDracoPlace, "expected an object"},
        DracoTrap{"none of the primitive's",
                  [] { return bentDraco([](Post& p) {
                         dracoOf(p)["attributes"] = {{"NORMAL", 0}};
                       }); }, kDracoPlace,
                  "none of the primitive's"},
        DracoTrap{"a number that Draco does not have",
                  [] { return bentDraco([](Post& p) { dracoOf(p)["attributes"]["POSITION"] = 9; }); }, kDracoPlace,
                  "there is no attribute 9"},
        DracoTrap{"a negative number",
                  [] { return bentDraco([](Post& p) { dracoOf(p)["attributes"]["POSITION"] = -1; }); }, kDracoPlace,
                  "whole number"},
        DracoTrap{"other components",
                  [] { return bentDraco([](Post& p) { dracoAccessor(p, "WEIGHTS_0")["type"] = "VEC3"; }); },
                  kDracoPlace, "has 4 components; its accessor declares 3"},
        DracoTrap{"points", [] { return bentDraco([](Post& p) { p.primitive()["mode"] = 0; }); },
                  "meshes[0].primitives[0].mode", "not mode 0"},
        DracoTrap{"a fan", [] { return bentDraco([](Post& p) { p.primitive()["mode"] = 6; }); },
                  "meshes[0].primitives[0].mode", "not mode 6"},
        DracoTrap{"no indices", [] { return bentDraco([](Post& p) { p.primitive().erase("indices"); }); },
                  "meshes[0].primitives[0].indices", "missing"},
        DracoTrap{"indices of floats",
                  [] { return bentDraco([](Post& p) { dracoIndices(p)["componentType"] = 5126; }); },
                  "meshes[0].primitives[0].indices", "unsigned integers"}));

}  // namespace
}  // namespace sinew::test
