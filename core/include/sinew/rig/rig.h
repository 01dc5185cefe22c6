// core/include/sinew/rig/rig.h: the designer's document as a plain value. File form: docs/formats.md.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/geometry/ellipsoid.h"
#include "sinew/rig/animated_number.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/rig/muscle_sheet.h"
#include "sinew/rig/not_compared.h"

namespace sinew {

enum class SurfaceMode { kSwell, kReplace };
enum class PatchKind { kPn, kPhong, kSpherigon, kFlat };
enum class DetailKind { kUniform, kAdaptive };

inline constexpr float kDefaultIso = 0.25f;
inline constexpr float kDefaultReach = 1.4142135f;  ///< In files without a reach.
inline constexpr float kNewReach = 2.0f;            ///< New muscles: the shell is as wide as the muscle itself.
inline constexpr float kNewGrooves = 0.015f;        ///< New documents and sets of muscles; files without have 0.
inline constexpr float kMostAmount = 2.0f;
inline constexpr float kDefaultSkinBlend = 0.04f;
inline constexpr float kDefaultCreaseAngle = 180.0f;  ///< Smooth everywhere.
inline constexpr int kMaxDepth = 16;
inline constexpr float kDefaultTolerance = 0.001f;  ///< For adaptive detail, fraction of H.
inline constexpr float kLeastTolerance = 0.0001f;
inline constexpr float kMostTolerance = 0.01f;
inline constexpr float kLeastMorphWeight = -10.0f;
inline constexpr float kMostMorphWeight = 10.0f;

// Limits for the skin's own field W = h / (1 - sqrt(1 - sqrt T)) to be in the range of floats.
inline constexpr float kLeastIso = 0.001f;
inline constexpr float kMostIso = 0.999f;
inline constexpr float kMostSkinBlend = 10.0f;
inline constexpr float kMostGrooves = 1.0f;

/// Identity of a primitive: stays the same through renaming, undo and redo while a document is open. Not in the file.
/// 0: not assigned yet (core/rig/references.h).
struct PrimitiveId {
  std::uint32_t value = 0;

  [[nodiscard]] explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const PrimitiveId&, const PrimitiveId&) = default;
};
struct GroupId {
  std::uint32_t value = 0;

  [[nodiscard]] explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const GroupId&, const GroupId&) = default;
};

/// "surface" in the file.
struct SurfaceSettings {
  SurfaceMode mode = SurfaceMode::kSwell;
  float iso = kDefaultIso;              ///< T, kLeastIso..kMostIso.
  float skinBlend = kDefaultSkinBlend;  ///< h as a fraction of H, > 0, at most kMostSkinBlend.
  float grooves = 0.0f;                 ///< Width of grooves between unlinked muscles, fraction of H, 0..kMostGrooves.
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;  ///< JSON object text of keys unknown to this version; kept and written back.

  friend bool operator==(const SurfaceSettings&, const SurfaceSettings&) = default;
};

/// "smoothing" in the file.
struct SmoothingSettings {
  int depth = 3;  ///< n, 1..kMaxDepth: with uniform detail every control triangle becomes n^2.
  PatchKind patch = PatchKind::kPn;
  /// SurfaceMode::kReplace: search lines run along the normals, not to the anchors. In files "projection": "analytic",
  /// formerly one of three search methods.
  bool alongNormals = false;
  float creaseAngle = kDefaultCreaseAngle;  ///< Degrees, 0..180: edges with larger angles are shaded sharp.
  DetailKind detail = DetailKind::kUniform;
  float tolerance = kDefaultTolerance;  ///< Adaptive detail: largest distance of flat triangles, fraction of H.
  bool autoDepth = false;               ///< In pictures `depth` or `tolerance` follows the character's size.
  std::string unknownKeys;

  friend bool operator==(const SmoothingSettings&, const SmoothingSettings&) = default;
};

/// A node of the blending graph.
struct Group {
  std::string name;  ///< Unique, not empty.
  std::string unknownKeys;
  NotCompared<GroupId> identity{};

  [[nodiscard]] GroupId id() const { return identity.value; }
  friend bool operator==(const Group&, const Group&) = default;
};

/// An edge of the blending graph: two groups that blend.
struct Link {
  std::array<std::string, 2> groups;  ///< Names of two groups of the rig.
  float amount = 1.0f;                ///< Above 0, at most 1: the groups add up. In between: from groove to sum.
  std::vector<AnimatedNumber> animated{};
  std::string unknownKeys{};

  [[nodiscard]] bool joins(const std::string& a, const std::string& b) const {
    return (groups[0] == a && groups[1] == b) || (groups[0] == b && groups[1] == a);
  }
  friend bool operator==(const Link&, const Link&) = default;
};

/// One ellipsoid on one bone.
struct Primitive {
  std::string name;     ///< Unique, not empty.
  std::string bone;     ///< Name or path (Skeleton::findBone). If the character lacks it, the primitive is unattached.
  std::string group;    ///< Name of a group of the rig.
  std::string line;     ///< Name of the muscle line that carries it; empty: it only follows its bone.
  std::string sheet;    ///< Name of the sheet that it is a belly of, from which it follows; empty: none.
  Placement placement;  ///< In the bind pose, also on a line.
  float reach = kDefaultReach;                        ///< k > 1.
  float amount = 1.0f;                                ///< Factor on the strength, 0..kMostAmount.
  int sign = 1;                                       ///< +1 adds, -1 carves.
  std::string mirror;                                 ///< Name of the linked twin, or empty.
  std::optional<std::vector<std::string>> territory;  ///< Bones; nullopt: the default (core/rig/attachment.h).
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;
  NotCompared<PrimitiveId> identity{};

  [[nodiscard]] PrimitiveId id() const { return identity.value; }
  friend bool operator==(const Primitive&, const Primitive&) = default;
};

/// Added to the weight that file and clip give each morph target with this name. "shapes" in the file.
struct MorphWeight {
  std::string name;     ///< Unique, not empty. The character may lack such a target.
  float weight = 0.0f;  ///< kLeastMorphWeight..kMostMorphWeight; 0 adds nothing.
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;

  friend bool operator==(const MorphWeight&, const MorphWeight&) = default;
};

/// A designer's choice for a body part whose bone was not found or is another (docs/muscles.md).
struct SlotCorrection {
  std::string slot;  ///< Name of a body slot: "upperArm.L"; each at most once.
  std::string bone;  ///< Name or path (Skeleton::findBone). Empty: the character has no such part.

  friend bool operator==(const SlotCorrection&, const SlotCorrection&) = default;
};

/// How muscles affect a part of the mesh. docs/characters.md.
enum class SkinLayer {
  kSkin,   ///< Muscles push it.
  kCloth,  ///< It lies over the skin and moves with it.
  kRigid,  ///< Muscles do not change it.
};

/// A designer's choice for a part of the mesh, instead of the guessed layer. "layers" in the file.
struct LayerChoice {
  std::string part;  ///< Name of a MeshPart (mesh_part.h); each at most once. The character may lack it.
  SkinLayer layer = SkinLayer::kSkin;

  friend bool operator==(const LayerChoice&, const LayerChoice&) = default;
};

/// Primitives + lines + sheets + groups + links + settings. Two rigs with equal members are the same document.
struct Rig {
  std::string character;  ///< Path relative to the rig file, with "/"; or absolute as the designer typed it.
  SurfaceSettings surface;
  SmoothingSettings smoothing;
  std::vector<Group> groups;
  std::vector<Link> links;
  std::vector<RigChannel> channels;
  std::vector<MuscleLine> lines;
  std::vector<MuscleSheet> sheets;
  std::vector<Primitive> primitives;  ///< Those of sheets last, in the order of the sheets.
  std::vector<SlotCorrection> slots;
  std::vector<MorphWeight> morphs;
  std::vector<std::string> clipFiles;  ///< Files with additional clips for the character; paths as `character`.
  std::vector<LayerChoice> layers;
  std::string unknownKeys;

  friend bool operator==(const Rig&, const Rig&) = default;
};

[[nodiscard]] int findPrimitive(const Rig& rig, const std::string& name);  ///< Index by name, or -1.
[[nodiscard]] int findGroup(const Rig& rig, const std::string& name);
[[nodiscard]] int findLine(const Rig& rig, const std::string& name);
[[nodiscard]] int findSheet(const Rig& rig, const std::string& name);
[[nodiscard]] int findMorph(const Rig& rig, const std::string& name);
/// How much two groups blend, 0..1; 0: they are not linked.
[[nodiscard]] float linkAmount(const Rig& rig, const std::string& a, const std::string& b);
[[nodiscard]] int findLink(const Rig& rig, const std::string& a, const std::string& b);  ///< The first, or -1.
/// The line that carries a primitive, or null.
[[nodiscard]] const MuscleLine* lineOf(const Rig& rig, const Primitive& primitive);
[[nodiscard]] int findPrimitive(const Rig& rig, PrimitiveId id);  ///< Index by identity, or -1.
[[nodiscard]] int findGroup(const Rig& rig, GroupId id);
[[nodiscard]] int findLine(const Rig& rig, LineId id);

/// The first free of `wanted`, `wanted 2`, `wanted 3` ... A number at the end is counted up: "thigh 2" -> "thigh 3".
[[nodiscard]] std::string freePrimitiveName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeGroupName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeLineName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeSheetName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeChannelName(const Rig& rig, const std::string& wanted);

[[nodiscard]] const char* nameOf(SurfaceMode mode);  ///< Names in files, menus and on the command line.
[[nodiscard]] const char* nameOf(PatchKind patch);
[[nodiscard]] const char* nameOf(DetailKind detail);
[[nodiscard]] std::optional<SurfaceMode> surfaceModeNamed(const std::string& name);
[[nodiscard]] std::optional<PatchKind> patchKindNamed(const std::string& name);
[[nodiscard]] std::optional<DetailKind> detailKindNamed(const std::string& name);

}  // namespace sinew
