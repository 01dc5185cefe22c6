// core/rig/attachment.h: resolves a rig against a character: bones, groups, territories.
#pragma once

#include <span>
#include <vector>

#include "core/rig/field.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// A rig resolved against a character, without primitives whose bone is missing.
struct Attachment {
  std::vector<FieldPrimitive> primitives;  ///< [A] attached primitives, in rig order.
  std::vector<int> rigIndex;               ///< [A] index into Rig::primitives.
  std::vector<int> unattached;             ///< Indices into Rig::primitives.
  BlendingGraph graph;
  std::vector<std::vector<Candidate>> candidatesOfVertex;  ///< [V] primitives with m_i(v) > 0, ascending.
};

struct MissingBone : Error {
  std::string bone;
};

/// Every bone that the rig names and the character lacks, with its JSON path: "primitives[2].bone",
/// "primitives[2].territory[0]", "lines[0].origin.bone", "lines[0].animated[1].drivers[0].input.bone". The editor keeps
/// such primitives unattached and ignores such drivers; exports refuse the rig.
[[nodiscard]] std::vector<MissingBone> missingBones(const Rig& rig, const Skeleton& skeleton);

/// The error of an export, with the bone that was probably meant.
[[nodiscard]] Error refusalOf(const MissingBone& missing, const Skeleton& skeleton);

/// The character has every bone that the line names.
[[nodiscard]] bool hasBones(const MuscleLine& line, const Skeleton& skeleton);

/// Bones of a primitive's territory, sorted: those named in the rig (unknown names are skipped), or by default the
/// primitive's bone, its parent and its children; on a line also those of both ends, and the bones between them.
/// docs/design.md.
/// @param line  the primitive's, or null
[[nodiscard]] std::vector<int> territoryBones(const Primitive& primitive, int bone, const MuscleLine* line,
                                              const Skeleton& skeleton);

/// m_i(v) = smoothstep(0, 0.5, sum of v's weights on the territory).
[[nodiscard]] float territoryWeight(const Character& character, int vertex, const std::vector<bool>& isTerritoryBone);

/// Both rigs have the same candidates on any character: at most shapes, signs, names, settings and links differ.
[[nodiscard]] bool samePlaces(const Rig& a, const Rig& b);
/// Also the same graph: of links at most keys and drivers differ.
[[nodiscard]] bool sameCandidates(const Rig& a, const Rig& b);

/// The attached primitives with the shapes, strengths and signs of another rig with the same candidates. No cost per
/// vertex.  @return [A]
[[nodiscard]] std::vector<FieldPrimitive> fieldPrimitives(const Rig& rig, const Attachment& attachment);
/// Sets the numbers of the rig in a pose.  @param primitives [A]
void setNumbers(const RigNumbers& numbers, float iso, const Attachment& attachment,
                std::span<FieldPrimitive> primitives);

/// `rig` has passed validate(). Error: the blending graph is too large.
[[nodiscard]] Result<Attachment> attach(const Rig& rig, const Character& character);
/// With the graph that validate() has made.
[[nodiscard]] Result<Attachment> attach(const Rig& rig, const Character& character, BlendingGraphMemo& graphs);
/// With the links of another rig with the same places. No cost per vertex but for the copy.
[[nodiscard]] Result<Attachment> relinked(Attachment attachment, const Rig& rig, BlendingGraphMemo& graphs);

}  // namespace sinew
