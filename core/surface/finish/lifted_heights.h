// core/surface/finish/lifted_heights.h: the heights of moved vertices with the patch that carries them: what bounds
// and filters look at.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/at.h"
#include "core/geometry/instruction_set.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"

namespace sinew {

// How far edges are from following the heights, by instruction set.

/// A vertex's place on the patch, and its height.
struct alignas(16) LiftPlace {
  std::array<float, 4> of{};
};

/// 1/length of the edges to six neighbors of a ring: those of 0, 2 and 4, 0, those of 1, 3 and 5, 0. It is 0 where
/// the length is 0 too.
struct alignas(32) SixEdges {
  static constexpr std::array<std::size_t, VertexRings::kMultiple> kAt{0, 4, 1, 5, 2, 6};  ///< Place of neighbor i.
  std::array<float, 8> perLength{};
};

/// Sums over a vertex's neighbors.
struct LiftSums {
  float difference = 0.0f;  ///< Sum of height differences per length.
  float perLength = 0.0f;
};

struct LiftInputs {
  const VertexRings* rings = nullptr;
  std::span<const int> lifted;
  const LiftPlace* places = nullptr;  ///< [V'] read at lifted vertices and their neighbors.
  SixEdges* edges = nullptr;          ///< Out: of the rings of all lifted vertices, in order.
  LiftSums* sums = nullptr;           ///< Out: [lifted]
};

using LiftKernel = void (*)(const LiftInputs& inputs);

/// All give the same bits.
[[nodiscard]] LiftKernel liftKernel(InstructionSet set);

struct SteepInputs {
  const VertexRings* rings = nullptr;
  std::span<const int> lifted;
  float slope = 0.0f;
  const LiftPlace* places = nullptr;  ///< [V'] read at lifted vertices, their neighbors and those across.
  int* steep = nullptr;  ///< Out: room for [lifted]; those whose height differs from one of these by more than the
                         ///< slope times the way, or by nearly that.
};

/// @return how many are too steep
using SteepKernel = std::size_t (*)(const SteepInputs& inputs);

/// All give the same bits.
[[nodiscard]] SteepKernel steepKernel(InstructionSet set);

/// Heights over places of the patch. Kept from pose to pose for its memory.
class LiftedHeights {
 public:
  /// @param rings  must outlive the use.  @param moved  of these positions.  @param patch, positions [V'] world.
  /// @param heights [V'] signed, world units: how far each vertex has moved.
  void start(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
             std::span<const glm::vec3> positions, std::span<const float> heights);

  [[nodiscard]] std::span<const int> lifted() const { return lifted_; }  ///< Vertices with a height. Ascending.
  [[nodiscard]] const VertexRings& rings() const { return *rings_; }
  [[nodiscard]] const LiftPlace* places() const { return places_.data(); }  ///< [V'] as height() can be asked for.

  // Of lifted vertices, their neighbors and those across.
  [[nodiscard]] float height(int vertex) const { return at(places_, vertex).of[3]; }
  void setHeight(int vertex, float height) { at(places_, vertex).of[3] = height; }
  [[nodiscard]] float distance(int a, int b) const;  ///< On the patch.

 private:
  const VertexRings* rings_ = nullptr;
  std::vector<int> lifted_;
  std::vector<LiftPlace> places_;
};

// How steeply heights may rise over the skin. docs/design.md, Slopes.

/// Lowers heights until none rises by more than kSlope times the length of any path over the patch, along edges and
/// straight from one triangle's corner to the next one's, across the edge between them: paths along edges alone are up
/// to 15 % too long, in directions that depend on the mesh. |s(p)| becomes the least, over all vertices q and paths
/// from q to p, of max(0, s(q) with the sign of s(p)) + kSlope times the path. Heights keep their sign, what has not
/// moved stays, and no difference between two moments grows. The result is unique, to the bit: it depends neither on
/// the order of triangles nor on where the search begins.
class SlopeBound {
 public:
  /// Wherever a muscle's flank is no steeper than 56 degrees it stays as it is.
  static constexpr float kSlope = 1.5f;

  /// @param heights  in and out.  @return the vertices that were lowered, each once. Valid until
  /// the next call.
  std::span<const int> lower(LiftedHeights& heights);

 private:
  /// A height that a neighbor leaves a vertex.
  struct Offer {
    float height = 0.0f;
    int vertex = 0;
  };
  void offer(float height, int vertex);
  void findSteep(const LiftedHeights& heights);

  std::vector<int> steep_;
  std::vector<Offer> offers_;  ///< A heap, the lowest first.
  std::vector<int> lowered_;
};

// Heights that the refined mesh is too coarse for. docs/design.md, Sampling.

/// Low-pass filter for the heights of moved vertices, where they bend more than edges can follow.
///
/// A rim that is narrower than an edge is sampled high at one vertex and low at the next one, as the triangulation has
/// it: saw teeth. With M the mean over a vertex's neighbors, weighted by 1/length (0 for heights that grow evenly,
/// whatever the lengths), c = |(M - 1) s| over the edges' length says how far the mesh is from following s. The filter
/// is s += w (M - 1) s / 2, four times, w from 0 at c = 0.15 to 1 at 0.5, and at least that of each neighbor that has
/// itself risen. Adaptive detail has chosen edges that can follow, and needs no filter.
///
/// Heights keep their sign and never grow, so that a vertex that has not moved stays, and grooves between muscles stay
/// deep. Continuous in time and independent of the order of triangles.
class LiftFilter {
 public:
  static constexpr int kRounds = 4;

  /// @param lifted  these heights.  @param patch [V'] world.  @param positions [V'] world, in and out.
  /// @param heights [V'] signed, world units, in and out: how far each vertex has moved.
  /// @return [V'] w; empty if it is 0 everywhere. Valid until the next call.
  std::span<const float> apply(const LiftedHeights& lifted, std::span<const glm::vec3> patch,
                               std::span<glm::vec3> positions, std::span<float> heights);

 private:
  /// A vertex with a height and w > 0.
  struct Active {
    int vertex = 0;
    const SixEdges* edges = nullptr;
    LiftSums sums{};
  };
  void measure(const LiftedHeights& lifted);
  [[nodiscard]] bool weigh(const LiftedHeights& lifted, std::size_t vertices);
  void raise(int vertex, float weight);
  void findActive(const LiftedHeights& lifted);
  void evenOut(const VertexRings& rings, std::span<const float> heights);

  std::vector<SixEdges> edges_;  ///< Of the rings of all lifted vertices, in order.
  std::vector<LiftSums> sums_;   ///< [lifted]
  std::vector<float> weights_;   ///< [V'] w.
  std::vector<int> weighted_;    ///< Vertices with w > 0.
  std::vector<Active> active_;
  std::vector<float> filtered_;  ///< [V'] heights.
};

}  // namespace sinew
