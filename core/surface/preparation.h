// core/surface/preparation.h: everything that follows from a character and a rig before any pose. Immutable.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/rig/attachment.h"
#include "core/rig/mesh_layers.h"
#include "core/rig/posed_rig.h"
#include "core/surface/finish/cloth_binding.h"
#include "core/surface/finish/vertex_rings.h"
#include "core/surface/projection/candidates.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projection/vertex_tiles.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/refinement.h"
#include "sinew/surface/region.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Data that follow from the character alone.
struct CharacterTables {
  std::shared_ptr<const Character> character;
  Pose bind;
  std::vector<glm::vec3> riseInBind;       ///< [V] riseDirections()
  std::vector<float> inverseLimitsInBind;  ///< [V] inverseRiseLimits()
  std::vector<float> perBindFront;         ///< [T] bindFrontInverses()
  std::vector<SkinLayer> guessedLayers;    ///< [parts]
};
[[nodiscard]] std::shared_ptr<const CharacterTables> characterTables(std::shared_ptr<const Character> character);

/// Muscles on the skin: territories, groups and cliques. The same for all rigs that differ only in shapes, signs and
/// settings (sameCandidates), so that a drag attaches nothing.
struct AttachedRig {
  Rig rig;  ///< The one that was attached.
  Attachment attachment;
  CandidateLists candidates;  ///< Among all attached primitives, hidden or not.
};

struct AdaptiveLevels;  // adaptive_levels.h

/// A mesh with layers besides skin.
struct LayeredSkin {
  MeshLayers layers;
  std::vector<float> inverseLimitsInBind;  ///< [V] of skin against skin: cloth over it does not limit it.
};

/// The refined mesh and tables that follow from its connectivity.
struct RefinedMesh {
  std::shared_ptr<const ControlMesh> creased;  ///< The character's mesh with creased wedges; null if none are.
  std::shared_ptr<const Refinement> refinement;
  std::vector<float> inverseLimits;    ///< [V'] of the rise.
  std::vector<std::uint8_t> isBorder;  ///< [V']
  VertexRings rings;
};

/// The implicit control triangles, found in the bind pose with the numbers of a rig (paper 3.1).
struct BindReading {
  ImplicitWeights weights;  ///< In `swell` only omega, for the classes.
  std::vector<TriangleClass> classes;
};

/// Parts that do not change from one preparation to the next are shared.
struct Preparation {
  std::shared_ptr<const CharacterTables> tables;
  SurfaceMode mode = SurfaceMode::kSwell;
  float iso = kDefaultIso;
  SmoothingSettings smoothing;
  ProjectionKind projection = ProjectionKind::kNewton;
  std::shared_ptr<const RigPoser> poser;
  std::shared_ptr<const LayeredSkin> layered;  ///< Null: all is skin.
  std::shared_ptr<const AttachedRig> attached;
  std::vector<FieldPrimitive> primitives;        ///< [A] without keys and drivers.
  std::vector<int> hidden;                       ///< Indices into the rig's primitives, ascending.
  int shownPrimitives = 0;                       ///< Number attached and not hidden.
  std::shared_ptr<const CandidateLists> seen;    ///< Without hidden candidates.
  std::shared_ptr<const AdaptiveLevels> detail;  ///< Null: the same depth everywhere.
  Region region;                                 ///< Refined part. Empty: the whole body.
  std::shared_ptr<const RefinedMesh> refined;
  std::shared_ptr<const VertexTiles> tiles;              ///< Made from `seen`.
  std::shared_ptr<const std::vector<float>> bindFronts;  ///< [T n^2] of the patch.
  std::shared_ptr<const ClothBinding> cloth;             ///< Null: there is none.
  std::shared_ptr<const std::vector<Anchor>> anchors;    ///< [V'] in `replace`, else null.
  BindReading bind;

  [[nodiscard]] const Character& character() const { return *tables->character; }
  [[nodiscard]] const ControlMesh& mesh() const { return tables->character->mesh; }
  [[nodiscard]] const Refinement& refinement() const { return *refined->refinement; }
  [[nodiscard]] bool swells() const { return mode == SurfaceMode::kSwell; }
  /// Not in `replace`, which lies on the muscle itself, nor with adaptive detail, whose edges follow the heights.
  [[nodiscard]] bool filtersHeights() const { return swells() && !detail; }
  /// On an adaptive mesh rims follow the triangles (shading_normals.h).
  [[nodiscard]] bool softensRims() const { return detail != nullptr; }
  [[nodiscard]] const MeshLayers* layers() const { return layered ? &layered->layers : nullptr; }
  [[nodiscard]] const std::vector<float>& inverseLimitsInBind() const {
    return layered ? layered->inverseLimitsInBind : tables->inverseLimitsInBind;
  }
};

struct PreparationOptions {
  std::span<const int> hidden{};            ///< Indices into the rig's primitives, ascending, that contribute nothing.
  std::optional<int> depth{};               ///< 1..kMaxDepth, in place of the rig's.
  std::optional<float> tolerance{};         ///< For adaptive detail, in place of the rig's.
  bool keepLevels = false;                  ///< Keeps the former levels of adaptive detail during an edit.
  std::shared_ptr<const Rig> shared{};      ///< The rig itself, if shared: kept in place of a copy.
  std::shared_ptr<const RigPoser> poser{};  ///< A poser of this rig and character, if there is one.
  std::span<const std::uint8_t> region{};   ///< [T] a Region. Empty: the whole body.
  ProjectionKind projection = ProjectionKind::kNewton;  ///< Same as the former one.
};

/// Error: the rig is invalid, the blending graph too large, or the refined mesh would not fit memory.
/// @param former  of the same character, or null: its unchanged parts are reused
/// @param graphs  cache of blending graphs, from one preparation to the next
[[nodiscard]] Result<std::shared_ptr<const Preparation>> prepare(const std::shared_ptr<const CharacterTables>& tables,
                                                                 const Rig& rig, const PreparationOptions& options,
                                                                 const Preparation* former, BlendingGraphMemo& graphs);

/// For sampling at given points; makes nothing that needs triangles.  @param next  attached; its refinement is not read
[[nodiscard]] std::shared_ptr<const Preparation> prepareSamples(const Preparation& next, Refinement points);

/// Memory for repeated readBindPose().
struct BindScratch {
  std::vector<PosedPrimitive> primitives;
  std::vector<glm::vec3> positions;  ///< [V'] flat.
  std::vector<glm::vec3> normals;    ///< [V']
  std::vector<glm::vec3> anchors;    ///< [V']
  ProjectionScratch projection;
};
/// @param primitives [A] possibly of other shapes than the preparation's
/// @param cliqueSets  for other amounts of links than those drawn, or null
void readBindPose(const Preparation& preparation, std::span<const FieldPrimitive> primitives,
                  const PosedCliqueSets* cliqueSets, BindScratch& scratch, BindReading& out);

/// Constants of the modes. @param skinBlend  in the pose
[[nodiscard]] SwellSettings swellSettings(const Preparation& preparation, float skinBlend);
[[nodiscard]] ReplaceSettings replaceSettings(const Preparation& preparation);

/// The patches of a posed control mesh. @param positions, normals [V']
void evaluatePatch(const Preparation& preparation, PatchKind kind, std::span<const glm::vec3> controlPositions,
                   std::span<const glm::vec3> controlNormals, std::vector<glm::vec3>& positions,
                   std::vector<glm::vec3>& normals);

}  // namespace sinew
