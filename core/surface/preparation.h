// core/surface/preparation.h: all that follows from a character and a rig before any pose. Immutable.
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
#include "core/surface/projection/anchors.h"
#include "core/surface/projection/candidates.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/swell.h"
#include "core/surface/projection/vertex_tiles.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/region.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// What follows from a character alone.
struct CharacterTables {
  std::shared_ptr<const Character> character;
  std::vector<glm::vec3> riseInBind;       ///< [V] rise_directions.h
  std::vector<float> inverseLimitsInBind;  ///< [V] rise_limits.h
  std::vector<float> perBindFront;         ///< [T] crease_lift.h
  std::vector<SkinLayer> guessedLayers;    ///< [parts]
};
[[nodiscard]] std::shared_ptr<const CharacterTables> characterTables(std::shared_ptr<const Character> character);

/// Muscles on the skin: territories, groups and cliques. The same for all rigs that differ in shapes, signs and
/// settings at most (sameCandidates), so that a drag attaches nothing.
struct AttachedRig {
  Rig rig;  ///< The one that was attached.
  Attachment attachment;
  CandidateLists candidates;  ///< Candidates among all attached primitives, hidden or not.
};

struct AdaptiveLevels;  // adaptive_levels.h

/// A mesh of which not all is skin.
struct LayeredSkin {
  MeshLayers layers;
  std::vector<float> inverseLimitsInBind;  ///< [V] of skin against skin alone: cloth over it is no limit.
};

/// The refined mesh and what follows from its connectivity.
struct RefinedMesh {
  std::shared_ptr<const ControlMesh> creased;  ///< The character's mesh with creased wedges; null if none are.
  std::shared_ptr<const Refinement> refinement;
  std::vector<float> inverseLimits;    ///< [V'] of the rise.
  std::vector<std::uint8_t> isBorder;  ///< [V']
  VertexRings rings;
};

/// Which control triangles are implicit, read off the bind pose with the numbers of a rig as they are (paper 3.1).
struct BindReading {
  ImplicitWeights weights;  ///< In `swell` omega alone, for the classes.
  std::vector<TriangleClass> classes;
};

/// Parts that did not change from one preparation to the next are shared, not copied.
struct Preparation {
  std::shared_ptr<const CharacterTables> tables;
  SurfaceMode mode = SurfaceMode::kSwell;
  float iso = kDefaultIso;
  SmoothingSettings smoothing;
  ProjectionKind projection = ProjectionKind::kNewton;
  std::shared_ptr<const RigPoser> poser;
  std::shared_ptr<const LayeredSkin> layered;  ///< Null: all is skin.
  std::shared_ptr<const AttachedRig> attached;
  std::vector<FieldPrimitive> primitives;        ///< [A] as drawn.
  std::vector<int> hidden;                       ///< Indices into the rig's primitives, ascending.
  int shownPrimitives = 0;                       ///< Attached and not hidden.
  std::shared_ptr<const CandidateLists> seen;    ///< Candidates that are not hidden.
  std::shared_ptr<const AdaptiveLevels> detail;  ///< Null: the same depth everywhere.
  Region region;                                 ///< Outside it nothing is refined. Empty: the whole body.
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
  /// `replace` lies on the muscle itself; the edges of adaptive detail follow the heights.
  [[nodiscard]] bool filtersHeights() const { return swells() && !detail; }
  /// Over an adaptive mesh a rim goes as the triangles lie (shading_normals.h).
  [[nodiscard]] bool softensRims() const { return detail != nullptr; }
  [[nodiscard]] const MeshLayers* layers() const { return layered ? &layered->layers : nullptr; }
  [[nodiscard]] const std::vector<float>& inverseLimitsInBind() const {
    return layered ? layered->inverseLimitsInBind : tables->inverseLimitsInBind;
  }
};

/// What a preparation may be asked beyond its rig.
struct PreparationOptions {
  std::span<const int> hidden{};     ///< Indices into the rig's primitives, ascending, that contribute nothing.
  std::optional<int> depth{};        ///< 1..kMaxDepth, in place of the rig's.
  std::optional<float> tolerance{};  ///< Of adaptive detail, in place of the rig's.
  bool keepLevels = false;           ///< Adaptive detail keeps the former preparation's levels, while an edit goes on.
  std::shared_ptr<const Rig> shared{};                  ///< The rig itself, if it is shared: kept in place of a copy.
  std::shared_ptr<const RigPoser> poser{};              ///< A poser of this rig and character, if there is one.
  std::span<const std::uint8_t> region{};               ///< [T] a Region. Empty: the whole body.
  ProjectionKind projection = ProjectionKind::kNewton;  ///< The same as `former`'s.
};

/// Error: the rig is invalid, the blending graph too large, or the refined mesh would not fit memory.
/// @param former  of the same character, or null: what still serves is taken from it
/// @param graphs  what is known of blending graphs, from one preparation to the next
[[nodiscard]] Result<std::shared_ptr<const Preparation>> prepare(const std::shared_ptr<const CharacterTables>& tables,
                                                                 const Rig& rig, const PreparationOptions& options,
                                                                 const Preparation* former, BlendingGraphMemo& graphs);

/// For sampling the surface of a preparation at other points than its refinement's: nothing that needs triangles is
/// made. @param next  attached; its refinement is not read
[[nodiscard]] std::shared_ptr<const Preparation> prepareSamples(const Preparation& next, Refinement points);

/// Memory for reading the bind pose again and again.
struct BindScratch {
  std::vector<PosedPrimitive> primitives;
  std::vector<glm::vec3> positions;  ///< [V'] flat.
  std::vector<glm::vec3> normals;    ///< [V']
  std::vector<glm::vec3> anchors;    ///< [V']
  ProjectionScratch projection;
};
/// Reads the bind pose with primitives in other shapes than those drawn.
/// @param primitives [A]
void readBindPose(const Preparation& preparation, std::span<const FieldPrimitive> primitives, BindScratch& scratch,
                  BindReading& out);

/// Constants of the modes. @param skinBlend  as it is in a pose
[[nodiscard]] SwellSettings swellSettings(const Preparation& preparation, float skinBlend);
[[nodiscard]] ReplaceSettings replaceSettings(const Preparation& preparation);

/// The curved patches, or flat ones, of a posed control mesh. @param positions, normals [V']
void evaluatePatch(const Preparation& preparation, PatchKind kind, std::span<const glm::vec3> controlPositions,
                   std::span<const glm::vec3> controlNormals, std::vector<glm::vec3>& positions,
                   std::vector<glm::vec3>& normals);

}  // namespace sinew
