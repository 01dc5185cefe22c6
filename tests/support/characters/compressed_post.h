// tests/support/characters/compressed_post.h: the post of gltf_builder.h, compressed by Draco's and meshoptimizer's
// encoders.
#pragma once

#include <string>
#include <vector>

#include "tests/support/characters/gltf_builder.h"

namespace sinew::test {

enum class DracoMethod { kSequential, kEdgebreaker };

/// A mesh compressed by Draco.
struct DracoPost {
  std::string bytes;
  int vertices = 0;
  int triangles = 0;
};
/// @param bits  that positions and weights are rounded to; 0: without loss
[[nodiscard]] DracoPost dracoPost(const Post& post, DracoMethod method, int bits = 0);

/// Replaces the post's mesh by this one, without an uncompressed copy. Draco's ids: POSITION 0, JOINTS_0 1, WEIGHTS_0
/// 2.
void useDraco(Post& post, const DracoPost& mesh);
/// JSON of the compressed mesh.
[[nodiscard]] nlohmann::ordered_json& dracoOf(Post& post);

/// Bytes of the three modes of EXT_meshopt_compression.
[[nodiscard]] std::string meshoptAttributes(const void* values, std::size_t count, std::size_t stride);
[[nodiscard]] std::string meshoptTriangles(const std::vector<std::uint32_t>& indices);
[[nodiscard]] std::string meshoptIndices(const std::vector<std::uint32_t>& indices);

/// Makes a view hold exactly these bytes, compressed. @param settings  mode, count, byteStride, filter
void useMeshopt(Post& post, int view, const std::string& bytes, const nlohmann::ordered_json& settings);
/// JSON of a compressed view.
[[nodiscard]] nlohmann::ordered_json& meshoptOf(Post& post, int view);
/// The post with all views compressed losslessly.
[[nodiscard]] Post meshoptPost(bool trianglesAsIndices = false);

/// View of the accessor of an attribute, or of "indices".
[[nodiscard]] int viewOfPart(Post& post, const std::string& part);

}  // namespace sinew::test
