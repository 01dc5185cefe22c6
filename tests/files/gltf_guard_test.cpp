// tests/files/gltf_guard_test.cpp: the part of a file that tinygltf gets to see, and what it would do without the
// guard.

#include "core/files/gltf/guard.h"

#include <functional>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using gltf::guard;
using gltf::Guarded;
using gltf::Refusal;
using nlohmann::ordered_json;
using test::makePost;
using test::Post;

Json parsed(const std::string& text) { return Json::parse(text).value(); }

/// "place: reason" of the error; "" if there is none.
template <class Act>
std::string refusalOf(Act act) {
  try {
    act();
  } catch (const Refusal& refusal) {
    return refusal.error.text();
  }
  return "";
}

TEST(GltfGuard, RemovesUnusedMembers) {
  const Guarded guarded = guard(parsed(R"({"asset": {"version": "2.0", "generator": "x"}, "extras": [1], "a": {},
      "nodes": [{"name": "n", "extras": {"b": 1}, "camera": 7, "extensions": {"EXT_x": {}}}],
      "materials": [{"extensions": {"KHR_materials_unlit": {"deep": [[]]}, "EXT_y": 1}}]})"));
  EXPECT_EQ(guarded.text, R"({"asset":{"version":"2.0"},"nodes":[{"name":"n"}],"scene":-1,)"
                          R"("materials":[{"extensions":{"KHR_materials_unlit":{"index":0}},)"
                          R"("pbrMetallicRoughness":{}}]})");
  EXPECT_TRUE(guarded.faults.empty());
}

/// tinygltf ignores 1.0 where it wants an index, and cuts 5000000000 to an int in extensions.
TEST(GltfGuard, WritesNumbersAsTinygltfReadsThem) {
  const Guarded guarded = guard(parsed(R"({"asset": {"version": "2.0"}, "meshes": [{}, {}],
      "nodes": [{"mesh": 1.0, "scale": [1, 2.50, 5000000000]}], "samplers": [{"wrapS": 1e15}]})"));
  EXPECT_EQ(guarded.text,
            R"({"asset":{"version":"2.0"},"nodes":[{"mesh":1,"scale":[1.0,2.50,5000000000.0]}],"scene":-1,)"
            R"("meshes":[{},{}],"samplers":[{"wrapS":2147483647}]})");
}

TEST(GltfGuard, InvalidElementsAreRefusedWhenUsed) {
  const Guarded guarded = guard(parsed(R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 3}, {"name": 4}, {}]})"));
  EXPECT_EQ(guarded.text, R"({"asset":{"version":"2.0"},"nodes":[{},{},{}],"scene":-1})");
  EXPECT_EQ(refusalOf([&] { guarded.expectSound("nodes[0]"); }), "nodes[0].mesh: there is no mesh 3; the file has 0");
  EXPECT_EQ(refusalOf([&] { guarded.expectSound("nodes[1]"); }), "nodes[1].name: expected a string");
  EXPECT_EQ(refusalOf([&] { guarded.expectSound("nodes[2]"); }), "");
}

TEST(GltfGuard, TooManyElementsOrFaultsAreRefusedImmediately) {
  const auto file = [](const std::string& list, const std::string& element, int count) {
    std::string text = R"({"asset":{"version":"2.0"},")" + list + "\":[" + element;
    for (int i = 1; i < count; ++i) text += ',' + element;
    return parsed(text + "]}");
  };
  EXPECT_EQ(refusalOf([&] { (void)guard(file("textures", "{}", 500'001)); }),
            "textures: more than 500,000 elements in one file");
  EXPECT_EQ(refusalOf([&] { (void)guard(file("nodes", "{}", 200'001)); }), "nodes: more than 200,000 nodes");
  EXPECT_EQ(refusalOf([&] { (void)guard(file("textures", "5", 1001)); }), "textures[1000]: expected an object");
}

TEST(GltfGuard, DuplicateKeysAreRefused) {
  const test::TemporaryFolder folder;
  const auto imported = importGltf(folder.write("a.gltf", R"({"asset": {"version": "2.0", "version": "2.1"}})"));
  ASSERT_FALSE(imported.ok());
  EXPECT_EQ(imported.error().place, "asset.version");
}

/// Files that are valid, or invalid only in unused places, and that tinygltf refuses or misreads: why it sees neither
/// uris nor all members.
struct Refused {
  const char* name;
  std::function<void(Post&)> bend;
};
void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class TinygltfWithoutGuard : public testing::TestWithParam<Refused> {};

TEST_P(TinygltfWithoutGuard, RefusesFilesThatSinewReads) {
  Post post = makePost();
  post.file.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + test::base64(post.file.binary());
  GetParam().bend(post);
  const test::TemporaryFolder folder;
  folder.write("a+b.bin", post.file.binary());
  folder.write("longer.bin", post.file.binary() + "more");
  const auto file = folder.write("post.gltf", post.file.json.dump());
  const auto imported = importGltf(file);
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  EXPECT_EQ(imported.value()->mesh.triangles.size(), 20u);
  tinygltf::Model model;
  std::string errors;
  std::string warnings;
  EXPECT_FALSE(tinygltf::TinyGLTF().LoadASCIIFromFile(&model, &errors, &warnings, file.string()));
}

void withBufferAt(Post& post, const std::string& uri) { post.file.json["buffers"][0]["uri"] = uri; }

INSTANTIATE_TEST_SUITE_P(
    GltfGuard, TinygltfWithoutGuard,
    testing::Values(
        Refused{"plus sign in a name", [](Post& p) { withBufferAt(p, "a+b.bin"); }},
        Refused{"file longer than its buffer", [](Post& p) { withBufferAt(p, "longer.bin"); }},
        Refused{"data uri without a type",
                [](Post& p) { withBufferAt(p, "data:;base64," + test::base64(p.file.binary())); }},
        Refused{"unused buffer without bytes",
                [](Post& p) {
                  p.file.json["buffers"].push_back({{"byteLength", 4}});
                }},
        Refused{"wide stride",
                [](Post& p) {
                  const int view = p.file.view("unused");
                  p.file.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 256;
                  withBufferAt(p, "data:application/octet-stream;base64," + test::base64(p.file.binary()));
                }},
        Refused{"indices without a bufferView",
                [](Post& p) {
                  ordered_json primitive = p.primitive();
                  primitive["indices"] = p.file.json["accessors"].size();
                  p.file.json["accessors"].push_back({{"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}});
                  primitive["mode"] = 1;
                  p.file.json["meshes"][0]["primitives"].push_back(primitive);
                }},
        Refused{"image without a source",
                [](Post& p) {
                  p.file.json["images"].push_back({{"name", "empty"}});
                }},
        Refused{"unused accessor of no known type",
                [](Post& p) {
                  p.file.json["accessors"].push_back({{"componentType", 5126}, {"count", 1}, {"type", "VEC9"}});
                }},
        Refused{"camera of no known type", [](Post& p) {
                  p.file.json["cameras"].push_back({{"type", "wide"}});
                }}));

}  // namespace
}  // namespace sinew
