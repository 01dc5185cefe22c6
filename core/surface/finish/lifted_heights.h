// core/surface/finish/lifted_heights.h: heights over the patch, bound and filter. docs/design.md, Slopes and Sampling.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/at.h"
#include "core/geometry/formulas.h"
#include "core/geometry/instruction_set.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"

namespace sinew {

/// x, y, z of a vertex on the patch, and its height.
struct alignas(16) LiftPlace {
  std::array<float, 4> of{};
};

/// 1/length of the edges to six neighbors of a ring, or 0 for length 0: of neighbors 0, 2 and 4, 0, of 1, 3 and 5, 0.
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
  SixEdges* edges = nullptr;          ///< Out: in the rings of all lifted vertices, in order.
  LiftSums* sums = nullptr;           ///< Out: [lifted]
};

using LiftKernel = void (*)(const LiftInputs& inputs);

[[nodiscard]] LiftKernel liftKernel(InstructionSet set);

struct SteepInputs {
  const VertexRings* rings = nullptr;
  std::span<const int> lifted;
  float slope = 0.0f;
  const LiftPlace* places = nullptr;  ///< [V'] read at lifted vertices, their neighbors and those across.
  int* steep = nullptr;  ///< Out, room for [lifted]: vertices whose height differs from that of one of these by more
                         ///< than the slope times the distance, or nearly so.
};

using SteepKernel = std::size_t (*)(const SteepInputs& inputs);  ///< @return number of steep vertices

[[nodiscard]] SteepKernel steepKernel(InstructionSet set);

/// Heights over the patch. Reused from pose to pose for its memory.
class LiftedHeights {
 public:
  /// @param rings  must outlive the use.  @param moved  of these positions.  @param patch, positions [V'] world.
  /// @param heights [V'] signed, world units: the distance that each vertex has moved.
  void start(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
             std::span<const glm::vec3> positions, std::span<const float> heights);

  [[nodiscard]] std::span<const int> lifted() const { return lifted_; }  ///< Vertices with a height. Ascending.
  [[nodiscard]] const VertexRings& rings() const { return *rings_; }
  [[nodiscard]] const LiftPlace* places() const { return places_.data(); }  ///< [V'] valid where height() is.

  // For lifted vertices, their neighbors and those across.
  [[nodiscard]] float height(int vertex) const { return at(places_, vertex).of[3]; }
  void setHeight(int vertex, float height) { at(places_, vertex).of[3] = height; }
  [[nodiscard]] float distance(int a, int b) const;  ///< On the patch.

 private:
  const VertexRings* rings_ = nullptr;
  std::vector<int> lifted_;
  std::vector<LiftPlace> places_;
};

/// Lowers heights until none rises by more than kSlope times the length of any path over the patch. Paths go along
/// edges and across an edge, from corner to opposite corner of its two triangles: paths along edges alone are up to 15
/// % too long, in directions that depend on the mesh. |s(p)| becomes the least, over all vertices q and paths from q to
/// p, of max(0, s(q) with the sign of s(p)) + kSlope times the path. Heights keep their sign, unmoved vertices stay,
/// and differences between two poses do not grow. The result is unique to the bit: it depends neither on the order of
/// triangles nor on where the search begins.
class SlopeBound {
 public:
  static constexpr float kSlope = in_float::kMostSlope;

  /// @param heights  in and out.  @return lowered vertices, each once. Valid until the next call.
  std::span<const int> lower(LiftedHeights& heights);

 private:
  /// The height that a neighbor allows a vertex.
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

/// Low-pass filter for heights that bend more than the refined edges can follow.
///
/// A rim narrower than an edge is sampled high at one vertex and low at the next, as the triangulation has it: saw
/// teeth. With M the mean over a vertex's neighbors, weighted by 1/length so that (M - 1) s = 0 for heights that grow
/// evenly, c = |(M - 1) s| over the edges' length measures how badly the mesh follows s. The filter is
/// s += w (M - 1) s / 2, four times, with w from 0 at c = 0.15 to 1 at 0.5, and at least the w of each neighbor that
/// has risen. Adaptive detail has chosen edges that can follow, and needs no filter.
///
/// Heights keep their sign and never grow, so unmoved vertices stay and grooves between muscles stay deep. Continuous
/// in time and independent of the order of triangles.
class LiftFilter {
 public:
  static constexpr int kRounds = 4;

  /// @param lifted  of these heights.  @param patch [V'] world.  @param positions [V'] world, in and out.
  /// @param heights [V'] signed, world units, in and out: the distance that each vertex has moved.
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

  std::vector<SixEdges> edges_;  ///< In the rings of all lifted vertices, in order.
  std::vector<LiftSums> sums_;   ///< [lifted]
  std::vector<float> weights_;   ///< [V'] w
  std::vector<int> weighted_;    ///< Vertices with w > 0.
  std::vector<Active> active_;
  std::vector<float> filtered_;  ///< [V'] heights.
};

}  // namespace sinew
