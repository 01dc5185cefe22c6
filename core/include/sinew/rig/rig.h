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
#include "sinew/rig/not_compared.h"

namespace sinew {

enum class SurfaceMode { kSwell, kReplace };
enum class PatchKind { kPn, kPhong, kSpherigon, kFlat };
enum class DetailKind { kUniform, kAdaptive };

inline constexpr float kDefaultIso = 0.25f;
inline constexpr float kDefaultReach = 1.4142135f;  ///< Where the file says nothing.
inline constexpr float kNewReach = 2.0f;  ///< Reach of new muscles: the shell is as wide as the muscle itself.
inline constexpr float kMostAmount = 2.0f;
inline constexpr float kDefaultSkinBlend = 0.04f;
inline constexpr float kDefaultCreaseAngle = 180.0f;  ///< Smooth everywhere.
inline constexpr int kMaxDepth = 16;
inline constexpr float kDefaultTolerance = 0.001f;  ///< Of adaptive detail, fraction of H.
inline constexpr float kLeastTolerance = 0.0001f;
inline constexpr float kMostTolerance = 0.01f;
inline constexpr float kLeastMorphWeight = -10.0f;
inline constexpr float kMostMorphWeight = 10.0f;

// Beyond these the skin's own field W = h / (1 - sqrt(1 - sqrt T)) leaves what numbers can hold.
inline constexpr float kLeastIso = 0.001f;
inline constexpr float kMostIso = 0.999f;
inline constexpr float kMostSkinBlend = 10.0f;

/// Which primitive or group: the same through renames, undo and redo for as long as a document is open. Not in the
/// file. 0: not given yet (core/rig/references.h).
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
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;  ///< JSON object text of keys this version does not know; kept and written back.

  friend bool operator==(const SurfaceSettings&, const SurfaceSettings&) = default;
};

/// "smoothing" in the file.
struct SmoothingSettings {
  int depth = 3;  ///< n, 1..kMaxDepth: with uniform detail every control triangle becomes n^2.
  PatchKind patch = PatchKind::kPn;
  /// SurfaceMode::kReplace: lines run along the normals, not to the anchors. In files "projection": "analytic", once
  /// one of three searches; it took these lines.
  bool alongNormals = false;
  float creaseAngle =
      kDefaultCreaseAngle;  ///< Degrees, 0..180: faces that meet at more are shaded apart (mesh/creases.h).
  DetailKind detail = DetailKind::kUniform;
  float tolerance = kDefaultTolerance;  ///< Of adaptive detail: how far flat triangles may lie off, fraction of H.
  bool autoDepth =
      false;  ///< In a picture, `depth` or `tolerance` follows the character's size on screen (smoothing/auto_depth.h).
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

/// One ellipsoid on one bone.
struct Primitive {
  std::string name;     ///< Unique, not empty.
  std::string bone;     ///< Name or path (Skeleton::findBone). May be absent from the character at hand: unattached.
  std::string group;    ///< Name of a group of the rig.
  std::string line;     ///< Name of the muscle line that carries it, or empty: it rides its bone.
  Placement placement;  ///< In the bind pose, on a line too.
  float reach = kDefaultReach;                        ///< k > 1.
  float amount = 1.0f;                                ///< Factor on the strength, 0..kMostAmount.
  int sign = 1;                                       ///< +1 adds, -1 carves.
  std::string mirror;                                 ///< Name of the linked twin, or empty.
  std::optional<std::vector<std::string>> territory;  ///< Bones; nullopt: the default (attachment.h).
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;
  NotCompared<PrimitiveId> identity{};

  [[nodiscard]] PrimitiveId id() const { return identity.value; }
  friend bool operator==(const Primitive&, const Primitive&) = default;
};

/// What is added to the weight of each morph target of a name, on top of what the file and the clip give it. "shapes"
/// in the file.
struct MorphWeight {
  std::string name;     ///< Unique, not empty. The character may have no such target.
  float weight = 0.0f;  ///< kLeastMorphWeight..kMostMorphWeight; 0 adds nothing.
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;

  friend bool operator==(const MorphWeight&, const MorphWeight&) = default;
};

/// What the designer says of a part of the body, where its bone was not found or is another (docs/muscles.md).
struct SlotCorrection {
  std::string slot;  ///< Name of a body slot: "upperArm.L"; each at most once.
  std::string bone;  ///< Name or path (Skeleton::findBone). Empty: the character has no such part.

  friend bool operator==(const SlotCorrection&, const SlotCorrection&) = default;
};

/// What a part of the mesh is to the muscles. docs/characters.md.
enum class SkinLayer {
  kSkin,   ///< Muscles push it.
  kCloth,  ///< It lies over the skin and moves with it.
  kRigid,  ///< Muscles leave it as it is.
};

/// What the designer says of a part of the mesh, in place of what is guessed. "layers" in the file.
struct LayerChoice {
  std::string part;  ///< Name of a MeshPart (character/mesh_part.h); each at most once. The character may have none.
  SkinLayer layer = SkinLayer::kSkin;

  friend bool operator==(const LayerChoice&, const LayerChoice&) = default;
};

/// Primitives + lines + groups + links + settings. Two rigs with equal members are the same document.
struct Rig {
  std::string character;  ///< Path relative to the rig file, "/" between; or absolute as the designer typed it.
  SurfaceSettings surface;
  SmoothingSettings smoothing;
  std::vector<Group> groups;
  std::vector<std::array<std::string, 2>> links;
  std::vector<RigChannel> channels;
  std::vector<MuscleLine> lines;
  std::vector<Primitive> primitives;
  std::vector<SlotCorrection> slots;
  std::vector<MorphWeight> morphs;
  std::vector<std::string> clipFiles;  ///< Whose clips the character plays besides its own; paths as `character`.
  std::vector<LayerChoice> layers;
  std::string unknownKeys;

  friend bool operator==(const Rig&, const Rig&) = default;
};

/// Index by name, or -1.
[[nodiscard]] int findPrimitive(const Rig& rig, const std::string& name);
[[nodiscard]] int findGroup(const Rig& rig, const std::string& name);
[[nodiscard]] int findLine(const Rig& rig, const std::string& name);
[[nodiscard]] int findMorph(const Rig& rig, const std::string& name);
/// The line that carries a primitive, or null.
[[nodiscard]] const MuscleLine* lineOf(const Rig& rig, const Primitive& primitive);
/// Index by identity, or -1.
[[nodiscard]] int findPrimitive(const Rig& rig, PrimitiveId id);
[[nodiscard]] int findGroup(const Rig& rig, GroupId id);
[[nodiscard]] int findLine(const Rig& rig, LineId id);

/// `wanted`, or `wanted 2`, `wanted 3` ...: the first that no other of its kind has. A number at the end of `wanted`
/// counts on: a taken "thigh 2" gives "thigh 3".
[[nodiscard]] std::string freePrimitiveName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeGroupName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeLineName(const Rig& rig, const std::string& wanted);
[[nodiscard]] std::string freeChannelName(const Rig& rig, const std::string& wanted);

/// Names as they stand in files, menus and on the command line.
[[nodiscard]] const char* nameOf(SurfaceMode mode);
[[nodiscard]] const char* nameOf(PatchKind patch);
[[nodiscard]] const char* nameOf(DetailKind detail);
[[nodiscard]] std::optional<SurfaceMode> surfaceModeNamed(const std::string& name);
[[nodiscard]] std::optional<PatchKind> patchKindNamed(const std::string& name);
[[nodiscard]] std::optional<DetailKind> detailKindNamed(const std::string& name);

}  // namespace sinew
