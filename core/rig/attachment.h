// core/rig/attachment.h: a rig meets a character: bones found, groups numbered, territories laid out.
#pragma once

#include <span>
#include <vector>

#include "core/rig/blending_graph.h"
#include "core/rig/field.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// A rig resolved against a character. Primitives whose bone is missing are left out here, never in the rig.
struct Attachment {
  std::vector<FieldPrimitive> primitives;  ///< [A] attached ones, in rig order.
  std::vector<int> rigIndex;               ///< [A] index into Rig::primitives.
  std::vector<int> unattached;             ///< Indices into Rig::primitives.
  BlendingGraph graph;
  std::vector<std::vector<Candidate>> candidatesOfVertex;  ///< [V] primitives with m_i(v) > 0, ascending.
};

/// A bone that the rig names and the character lacks.
struct MissingBone : Error {
  std::string bone;
};

/// Every bone the rig names and the character lacks, with its JSON path: "primitives[2].bone",
/// "primitives[2].territory[0]", "lines[0].origin.bone", "lines[0].animated[1].drivers[0].input.bone". An editor keeps
/// such primitives, unattached, and such drivers, which drive nothing; what makes a result from the rig refuses, rather
/// than leave something out.
[[nodiscard]] std::vector<MissingBone> missingBones(const Rig& rig, const Skeleton& skeleton);

/// The refusal of what cannot be made without the bone: with the bone that was probably meant.
[[nodiscard]] Error refusalOf(const MissingBone& missing, const Skeleton& skeleton);

/// The character has every bone that the line names.
[[nodiscard]] bool hasBones(const MuscleLine& line, const Skeleton& skeleton);

/// Bones of a primitive's territory: those the rig names (unknown names are skipped), or by default the primitive's
/// bone, its nearest joint ancestor and its nearest joint children; on a line those of both ends, and the bones between
/// them. Sorted. docs/design.md.
/// @param line  that carries it, or null
[[nodiscard]] std::vector<int> territoryBones(const Primitive& primitive, int bone, const MuscleLine* line,
                                              const Skeleton& skeleton);

/// m_i(v) = smoothstep(0, 0.5, sum of v's weights on the territory).
[[nodiscard]] float territoryWeight(const Character& character, int vertex, const std::vector<bool>& isTerritoryBone);

/// Both rigs give one character the same candidates and graph: they differ in shapes, signs, names and settings at
/// most. Such is every drag.
[[nodiscard]] bool sameCandidates(const Rig& a, const Rig& b);

/// The attached primitives with shapes, strengths and signs of a rig whose candidates are the attached one's
/// (sameCandidates). Costs nothing per vertex.  @return [A]
[[nodiscard]] std::vector<FieldPrimitive> fieldPrimitives(const Rig& rig, const Attachment& attachment);
/// The same primitives with the numbers that the rig has in a pose.  @param primitives [A]
void setNumbers(const RigNumbers& numbers, float iso, const Attachment& attachment,
                std::span<FieldPrimitive> primitives);

/// `rig` has passed validate(). Error: the blending graph is too large.
[[nodiscard]] Result<Attachment> attach(const Rig& rig, const Character& character);
/// The same with the graph that validate() has made.
[[nodiscard]] Result<Attachment> attach(const Rig& rig, const Character& character, BlendingGraphMemo& graphs);

}  // namespace sinew
