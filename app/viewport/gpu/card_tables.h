// app/viewport/gpu/card_tables.h: a preparation and its poses in the layout of the shaders.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewport/gpu/card_layout.h"
#include "core/surface/posed_field.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"

namespace sinew::app {

/// Memory reused from pose to pose.
struct PosedMuscles {
  PosedRig rig;
  PosedField field;  ///< Without the skinned mesh.
};

/// Poses the rig and adds up morph targets. @return why this pose needs the processor, or nullopt
[[nodiscard]] std::optional<std::string> poseMuscles(const std::shared_ptr<const Preparation>& preparation,
                                                     const Pose& pose, PosedMuscles& out);

/// @param out [bindings] from the bind pose to the pose
void fillMatrices(const Preparation& preparation, const Pose& pose, std::span<glm::mat4> out);
/// @param out [primitives]
void fillPrimitives(const Preparation& preparation, const PosedField& field, std::span<card::Primitive> out);

/// Uploaded once.
struct CardTables {
  std::vector<std::int32_t> influenceBegin;  ///< [V + 1]
  std::vector<card::Influence> influences;
  std::vector<card::Control> controls;  ///< [V] bind pose.
  std::vector<std::int32_t> fans;       ///< Starts of the triangles at each control vertex [V + 1], then these.
  std::vector<card::Triangle> controlTriangles;  ///< [T]
  std::vector<card::Refined> refined;            ///< [V']
  /// Per carrier the start of its candidates [C + 1] and its set of cliques [C]; starts of the sets' cliques [sets +
  /// 1]; cliques, one bit per slot, two words each.
  std::vector<std::int32_t> seen;
  std::vector<card::Candidate> candidates;
  std::vector<card::Ring> rings;        ///< [V']
  std::vector<std::int32_t> neighbors;  ///< Then the opposite vertices.
  std::vector<std::int32_t> corners;
  std::vector<card::Triangle> triangles;   ///< [T']
  std::vector<std::int32_t> drawVertices;  ///< [D]
  std::vector<card::Anchor> anchors;       ///< [V'] in `replace`, else empty.
  std::vector<float> omegas;               ///< [V'] likewise: distance that each moves to the muscles' surface.
  card::Making making;
};

/// @param preparation  not leftToProcessor (card_surface.h)
[[nodiscard]] CardTables cardTables(const Preparation& preparation);

}  // namespace sinew::app
