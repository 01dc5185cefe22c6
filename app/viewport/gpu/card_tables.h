// app/viewport/gpu/card_tables.h: the shaders' buffers, and a preparation and its poses in their layout.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "core/surface/posed_field.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"

/// Contents of the buffers on the graphics card (std430), as shaders/compute reads them.
namespace sinew::app::card {

// Limits of the shaders at one place of the skin; surfaces that exceed them are computed by the processor.
inline constexpr std::size_t kMostCandidates = 96;  ///< Muscles (exact.glsl, swell_shaped.comp).
inline constexpr std::size_t kMostCliques = 64;     ///< Cliques of groups (field.glsl).
inline constexpr int kMostSlots = 64;               ///< Groups, one bit each.

struct Influence {
  std::int32_t binding = 0;
  float weight = 0.0f;
};
static_assert(sizeof(Influence) == 8);

struct Control {
  glm::vec4 position{0.0f};  ///< w: in a pose, rho of creases (core/surface/finish/crease_lift.h).
  glm::vec4 normal{0.0f};
  glm::vec4 rise{0.0f};
};
static_assert(sizeof(Control) == 48);

struct Refined {
  std::array<std::int32_t, 4> place{};  ///< Carrier, then the control vertices at its corners.
  glm::vec4 weights{0.0f};              ///< Barycentric, then 1/L of the rise.
};
static_assert(sizeof(Refined) == 32);

struct Candidate {
  std::int32_t primitive = 0;
  std::uint32_t slot = 0;  ///< Slot of its group.
  std::array<float, 3> weights{};
};
static_assert(sizeof(Candidate) == 20);

struct Primitive {
  std::array<glm::vec4, 3> toUnit{};  ///< Columns; w: strength, blend width, 1 / radius of a sphere or 0.
  glm::vec4 center{0.0f};             ///< World; w: radius of a ball that holds the influence.
  // UnitShape of a shape that is not an ellipsoid.
  glm::vec4 bendCurve{0.0f};
  glm::vec4 section{0.0f};  ///< lateral, taper, core, inverseEnd
  glm::vec4 low{0.0f};      ///< w: 1 for such a shape.
  glm::vec4 high{0.0f};     ///< w: mean radius, also of ellipsoids.
  glm::vec4 groove{0.0f};   ///< kappa; 1 if some muscle of the body has one.
};
static_assert(sizeof(Primitive) == 144);

struct Ring {
  std::int32_t begin = 0, end = 0;                ///< Neighbors.
  std::int32_t cornersBegin = 0, cornersEnd = 0;  ///< Corners of its triangles.
  std::int32_t acrossBegin = 0, acrossEnd = 0;    ///< Opposite vertices, stored after all neighbors.
  float share = 0.0f;
  std::int32_t isBorder = 0;
};
static_assert(sizeof(Ring) == 32);

struct Triangle {
  std::array<std::int32_t, 3> corners{};
  float bindFront = 0.0f;  ///< Its inverse or 0 for control triangles (core/surface/finish/crease_lift.h).
};
static_assert(sizeof(Triangle) == 16);

struct Vertex {
  glm::vec4 position{0.0f};  ///< World; w: the height.
  glm::vec4 normal{0.0f};
};
static_assert(sizeof(Vertex) == 32);

struct Line {
  glm::vec4 from{0.0f};
  glm::vec4 along{0.0f};
};
static_assert(sizeof(Line) == 32);

/// Point that moves with a bone, for `replace`.
struct Anchor {
  std::array<float, 3> inBone{};
  std::int32_t bone = 0;
};
static_assert(sizeof(Anchor) == 16);

enum class RootState : std::int32_t { kUntouched, kFound, kUnsure, kUnsureShaped };

struct Root {
  float way = 0.0f;  ///< Signed, before any limit.
  float onSkin = 0.0f;
  float blendWidth = 0.0f;
  RootState state = RootState::kUntouched;
  float height = 0.0f;  ///< `way`, or less below overhangs; for kUnsure the muscles' mean radius.
};
static_assert(sizeof(Root) == 20);

struct Mark {
  std::uint32_t moved = 0;
  float filtered = 0.0f;
};
static_assert(sizeof(Mark) == 8);

/// Head of a work list: its dispatch groups and the number of items.
struct ListHead {
  std::uint32_t x = 0, y = 1, z = 1, count = 0;
};
static_assert(sizeof(ListHead) == 16);

/// Groups that a round requests of the next one: shaders/compute/rounds.glsl.
struct Round {
  std::array<std::uint32_t, 4> vertexGroups{};
  std::array<std::uint32_t, 4> triangleGroups{};
};
static_assert(sizeof(Round) == 32);

/// Input of shaders/surface.vert.
struct Drawn {
  std::array<float, 3> position{};
  std::array<float, 3> normal{};
  float displacement = 0.0f;
};
static_assert(sizeof(Drawn) == 28);

/// Uniforms of all stages (std140): shaders/compute/items.glsl.
struct Making {
  std::int32_t controlVertices = 0, controlEdges = 0, refinedVertices = 0, refinedTriangles = 0;
  std::int32_t drawnVertices = 0, primitives = 0, bindings = 0, patchKind = 0;
  std::int32_t carriers = 0, cliqueSets = 0, wraps = 0, bones = 0;
  float iso = 0.0f, isoRoot = 0.0f, isoRadius = 0.0f, tolerance = 0.0f;
  float searchLength = 0.0f;
  std::int32_t toAnchors = 0;
  std::array<std::int32_t, 2> unused{};
  std::array<std::uint32_t, 4> vertexGroups{}, triangleGroups{};  ///< x, y, z of dispatches over all bodies.
};
static_assert(sizeof(Making) == 112 && sizeof(Making) % 16 == 0);

}  // namespace sinew::app::card

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
  std::vector<std::int32_t> seen;                ///< seenOf()
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

/// Per carrier the start of its candidates [C + 1] and its set of cliques [C]; starts of the sets' levels [sets + 1];
/// of each level the start of its cliques and its weight, at the end the number of cliques and 0; cliques, one bit per
/// slot, two words each.  @param posed  for the amounts of links in a pose; null: as drawn.  @param out  keeps its
/// memory
void seenOf(const CandidateLists& lists, const PosedCliqueSets* posed, std::vector<std::int32_t>& out);

inline constexpr const char* kSoftInReplace = "in replace, grooves between muscles are soft";
/// More ways in which groups blend at one place than the shaders have room for; nullopt: they have.
[[nodiscard]] std::optional<std::string> tooManyWays(const CandidateLists& lists, const PosedCliqueSets* posed);

}  // namespace sinew::app
