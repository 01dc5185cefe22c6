// core/files/fit/morph_fit.h: the residual of skinning in all frames as few morph targets times weights.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/files/fit/poses.h"
#include "core/files/fit/weight_fit.h"
#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

/// A vertex with the numbers in the file.
struct MorphVertex {
  int refined = 0;       ///< Vertex of the live surface.
  int space = 0;         ///< Mesh space of its targets.
  glm::dvec3 rest{0.0};  ///< Bind pose.
  FourWeights weights;
  double reach = 0.0;  ///< Distance from the origin of the mesh space, in units of the bind pose.
};

struct MorphTargets {
  int count = 0;
  std::vector<float> weights;  ///< [frames * count] 0..1.
  std::vector<double> shares;  ///< [count * frames] contribution of each frame to a target by least squares.
  std::vector<std::vector<glm::vec3>> deltas;  ///< [count][vertices] in their mesh spaces, sparse.
  ErrorFigures figures;                        ///< Over all vertices and frames; a time is a frame.
};

/// Blended 3 x 3 matrix of a vertex: bind pose -> pose.
[[nodiscard]] glm::dmat3 blendedMatrix(std::span<const glm::dmat4> matrices, const FourWeights& weights);

class MorphFit {
 public:
  /// @param meshToBind  of each mesh space: invertible
  MorphFit(std::vector<MorphVertex> vertices, std::vector<glm::dmat3> meshToBind, double height);

  /// Adds a frame. @param matrices  of all bindings  @param live  refined vertices of the live surface
  void add(std::vector<glm::dmat4> matrices, std::span<const glm::vec3> live);
  /// A distance that other readers, which compute in floats, may differ by: no smaller bound can hold.
  [[nodiscard]] double coarseness() const;
  [[nodiscard]] ErrorFigures skinnedFigures() const;  ///< Error of skinning alone.
  /// The fewest targets found within `bound`, a distance. nullopt: one target per frame is not enough. Throws Canceled.
  [[nodiscard]] std::optional<MorphTargets> solve(double bound, const StageProgress& progress) const;

 private:
  friend class MorphSearch;
  struct Frame {
    std::vector<glm::dmat4> matrices;
    std::vector<glm::vec3> live;  ///< [vertices] world.
    std::vector<float> wanted;    ///< [3 vertices] displacement in the bind pose.
  };

  std::vector<MorphVertex> vertices_;
  std::vector<glm::dmat3> meshToBind_;
  std::vector<glm::dmat3> bindToMesh_;
  double height_ = 1.0;
  std::vector<Frame> frames_;
  double reach_ = 0.0;  ///< Largest distance from an origin in a reader's arithmetic.
};

}  // namespace sinew::exporting
