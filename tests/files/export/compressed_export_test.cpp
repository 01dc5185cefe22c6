// tests/files/export/compressed_export_test.cpp: exports of compressed characters are uncompressed, without traces of
// the compression.
#include <webp/encode.h>

#include "core/files/disk/atomic_file.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/compressed_post.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

class CompressedExport : public ::testing::Test {
 protected:
  /// Without muscles, so that the export moves like its source.
  void exportPost(const Post& post, ExportMesh mesh) {
    EXPECT_TRUE(writeFileAtomically(source_, post.file.glb()).ok());
    const auto character = importGltf(source_);
    ASSERT_TRUE(character.ok()) << character.error().text();
    Rig rig;
    rig.smoothing.depth = 1;
    rig.smoothing.patch = PatchKind::kFlat;
    const auto report = exportSkinned(source_, character.value(), *character.value(), rig, {.mesh = mesh}, out_);
    ASSERT_TRUE(report.ok()) << report.error().text();
    bytes_ = readWholeFile(out_, 1 << 26).value();
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes_[i])); };
    json_ = ordered_json::parse(bytes_.substr(20, byte(12) + (byte(13) << 8U) + (byte(14) << 16U)));
  }

  /// The file contains nothing of the extensions and their bytes.
  void expectPlain(const std::string& compressed) const {
    EXPECT_EQ(bytes_.find("KHR_draco"), std::string::npos);
    EXPECT_EQ(bytes_.find("EXT_meshopt"), std::string::npos);
    EXPECT_EQ(bytes_.find(compressed), std::string::npos) << "the compressed bytes are still there";
    for (const ordered_json& view : json_["bufferViews"]) EXPECT_EQ(view["buffer"], 0);
    EXPECT_EQ(json_["buffers"].size(), 1u);
  }

  void expectPlaysAsPlainPost() const {
    TemporaryFolder folder;
    const GltfOracle before(folder.write("plain.glb", makePost().file.glb()));
    const GltfOracle after(out_);
    ASSERT_EQ(after.clips(), before.clips());
    for (const double time : {0.0, 0.3, 1.0}) {
      const auto now = after.triangles(0, time);
      EXPECT_EQ(now.size(), 20u);
      for (const RawTriangle& old : before.triangles(0, time)) {  // Corners of the source stay where they were.
        for (const glm::dvec3& corner : old) {
          double nearest = 1.0;
          for (const RawTriangle& triangle : now) {
            for (const glm::dvec3& other : triangle) nearest = std::min(nearest, glm::distance(corner, other));
          }
          EXPECT_LT(nearest, 1e-5);
        }
      }
    }
  }

  TemporaryFolder folder_;
  std::filesystem::path source_ = folder_.path() / "post.glb";
  std::filesystem::path out_ = folder_.path() / "out.glb";
  std::string bytes_;
  ordered_json json_;
};

TEST_F(CompressedExport, DracoIsDecompressed) {
  for (const DracoMethod method : {DracoMethod::kSequential, DracoMethod::kEdgebreaker}) {
    for (const ExportMesh mesh : {ExportMesh::kOriginal, ExportMesh::kRefined}) {
      Post post = makePost();
      const DracoPost packed = dracoPost(post, method);
      useDraco(post, packed);
      exportPost(post, mesh);
      expectPlain(packed.bytes);
      EXPECT_FALSE(json_.contains("extensionsUsed"));
      EXPECT_FALSE(json_.contains("extensionsRequired"));
      expectPlaysAsPlainPost();
    }
  }
}

TEST_F(CompressedExport, MeshoptimizerIsDecompressed) {
  for (const bool asIndices : {false, true}) {
    for (const ExportMesh mesh : {ExportMesh::kOriginal, ExportMesh::kRefined}) {
      exportPost(meshoptPost(asIndices), mesh);
      expectPlain(meshoptAttributes(makePost().positions.data(), 36, 4));
      EXPECT_FALSE(json_.contains("extensionsRequired"));
      expectPlaysAsPlainPost();
    }
  }
}

/// Views that an extension may reference cannot be renumbered; those of Draco are emptied.
TEST_F(CompressedExport, UnknownExtensionKeepsViewsWithoutTheirCompressedBytes) {
  Post post = makePost();
  const DracoPost packed = dracoPost(post, DracoMethod::kEdgebreaker);
  useDraco(post, packed);
  post.file.json["extensionsUsed"].push_back("EXT_of_somebody");
  exportPost(post, ExportMesh::kRefined);
  expectPlain(packed.bytes);
  EXPECT_EQ(json_["extensionsUsed"], ordered_json::array({"EXT_of_somebody"}));
  expectPlaysAsPlainPost();
}

/// A mesh outside the scene is kept, so it must be uncompressed, with the bounds of its present contents.
TEST_F(CompressedExport, HiddenMeshesAreDecompressed) {
  Post post = makePost();
  useDraco(post, dracoPost(post, DracoMethod::kEdgebreaker));
  const auto position = post.attributes()["POSITION"].get<std::size_t>();
  post.file.json["accessors"][position]["min"] = {-9, -9, -9};
  post.file.json["accessors"][position]["max"] = {9, 9, 9};
  post.file.json["meshes"].push_back(post.file.json["meshes"][0]);
  post.file.json["nodes"].push_back({{"name", "spare"}, {"mesh", 1}});
  exportPost(post, ExportMesh::kRefined);
  const ordered_json& spare = json_["meshes"][1]["primitives"][0];
  EXPECT_FALSE(spare.contains("extensions"));
  const tinygltf::Model model = rawModel(out_);
  const auto kept = spare["attributes"]["POSITION"].get<int>();
  EXPECT_EQ(rawBytes(model, kept).size(), 12u * 12u);
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(kept));
  EXPECT_EQ(accessor.minValues, (std::vector<double>{-0.5, 0.0, -0.5}));
  EXPECT_EQ(accessor.maxValues, (std::vector<double>{0.5, 2.0, 0.5}));
}

TEST_F(CompressedExport, WebpIsUnchanged) {
  const std::vector<std::uint8_t> pixels(64, 200);
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), 4, 4, 16, &encoded);
  const std::string image(reinterpret_cast<const char*>(encoded), size);
  WebPFree(encoded);
  Post post = makePost();
  post.file.json["images"].push_back({{"bufferView", post.file.view(image)}, {"mimeType", "image/webp"}});
  post.file.json["textures"].push_back({{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
  post.file.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  post.primitive()["material"] = 0;
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) post.file.json[list] = {"EXT_texture_webp"};
  exportPost(post, ExportMesh::kRefined);
  EXPECT_NE(bytes_.find(image), std::string::npos);
  EXPECT_EQ(json_["extensionsRequired"], ordered_json::array({"EXT_texture_webp"}));
  EXPECT_EQ(json_["textures"][0]["extensions"]["EXT_texture_webp"]["source"], 0);
}

}  // namespace
}  // namespace sinew::test
