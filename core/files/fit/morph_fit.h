// core/files/fit/morph_fit.h: what skinning leaves over, frame by frame, as few morph targets times weights.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "core/files/fit/four_weights.h"
#include "core/files/fit/poses.h"
#include "sinew/files/skinned_export.h"

namespace sinew::exporting {

/// A vertex of the file, with the numbers that the file has.
struct MorphVertex {
  int refined = 0;       ///< Vertex of the live surface.
  int space = 0;         ///< Mesh space that its targets are written in.
  glm::dvec3 rest{0.0};  ///< Bind pose.
  FourWeights weights;
  double reach = 0.0;  ///< How far it lies from the origin of the mesh space, in lengths of the bind pose.
};

struct MorphTargets {
  int count = 0;
  std::vector<float> weights;                  ///< [frames * count] 0..1.
  std::vector<double> shares;                  ///< [count * frames] what each frame adds to a target: least squares.
  std::vector<std::vector<glm::vec3>> deltas;  ///< [count][vertices] in their mesh spaces; many are 0.
  ErrorFigures figures;                        ///< All vertices in all frames, by these numbers; a time is a frame.
};

/// Blended 3 x 3 matrix of a vertex: bind pose -> pose.
[[nodiscard]] glm::dmat3 blendedMatrix(std::span<const glm::dmat4> matrices, const FourWeights& weights);

class MorphFit {
 public:
  /// @param meshToBind  of each mesh space: invertible
  MorphFit(std::vector<MorphVertex> vertices, std::vector<glm::dmat3> meshToBind, double height);

  /// Adds a frame: where the live surface has the refined vertices. @param matrices  of all bindings
  void add(std::vector<glm::dmat4> matrices, std::span<const glm::vec3> live);
  /// What other readers may differ by, a distance: they compute in floats. No bound below it can hold.
  [[nodiscard]] double coarseness() const;
  /// How near skinning alone comes.
  [[nodiscard]] ErrorFigures skinnedFigures() const;
  /// As few targets as found with which no vertex in any frame is farther off than `bound`, a distance. Nothing: not
  /// even one target a frame is enough. Throws Canceled.
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
  double reach_ = 0.0;  ///< Largest distance from an origin that a reader computes with.
};

}  // namespace sinew::exporting
