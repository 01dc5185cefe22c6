// tests/support/characters/gltf_oracle.h: geometry of a raw glTF file at a time, in double precision.
//
// Reads with tinygltf alone, without the import's guard, and shares no code with core: own node tree, own
// sampling (glTF 2.0, appendix C), own skinning, own morph targets and their weights. Knows what the test files hold:
// triangle lists and triangles' skins.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::test {

using RawTriangle = std::array<glm::dvec3, 3>;

class GltfOracle {
 public:
  explicit GltfOracle(const std::filesystem::path& file);
  ~GltfOracle();

  [[nodiscard]] std::size_t clips() const;
  [[nodiscard]] double duration(std::size_t clip) const;
  /// Triangles in file order at a time of a clip; without a clip the nodes rest.
  [[nodiscard]] std::vector<RawTriangle> triangles(std::optional<std::size_t> clip, double time) const;

  /// POSITION of a primitive with its targets, in mesh space. @param weights  [targets]
  [[nodiscard]] std::vector<glm::dvec3> morphedPositions(int mesh, int primitive,
                                                         const std::vector<double>& weights) const;
  /// Unit normals of their corners, skinned by the inverse transpose. @param morphed  false: without morph targets
  [[nodiscard]] std::vector<RawTriangle> normals(std::optional<std::size_t> clip, double time, bool morphed) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Compares an import of `file` with the oracle at several times of every clip: each raw corner must lie at its welded
/// vertex's skinned position, to `tolerance` times the height. Reports failures to GoogleTest.
void expectSkinsLikeTheFile(const std::filesystem::path& file, double tolerance = 1e-5);

}  // namespace sinew::test
