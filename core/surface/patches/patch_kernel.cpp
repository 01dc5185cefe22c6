// core/surface/patches/patch_kernel.cpp: patches, directions and normals at creases, once per instruction set.
#include "core/surface/patches/patch.h"

#include <algorithm>
#include <tuple>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/patches/patch_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/surface/patches/patch_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// The refined vertices of a mesh's edges, or inside its triangles.
template <class Piece>
class PieceVertices;

template <>
class PieceVertices<Edge> {
 public:
  explicit PieceVertices(const Refinement& refinement) : refinement_(refinement) {}

  [[nodiscard]] std::span<const int> order() const { return refinement_.edgeOrder; }
  [[nodiscard]] int first(int edge) const { return refinement_.edgeVertex(edge, 1); }
  [[nodiscard]] int count(int edge) const { return refinement_.edgeVertices(edge); }
  [[nodiscard]] bool sameWeights(int a, int b) const { return refinement_.onEdges.empty() && count(a) == count(b); }
  [[nodiscard]] std::array<float, 3> weights(int edge, int index) const {
    const auto w = static_cast<float>(refinement_.shareAt(edge, index + 1));
    return {1.0f - w, w, 0.0f};
  }

 private:
  const Refinement& refinement_;
};

template <>
class PieceVertices<ControlTriangle> {
 public:
  explicit PieceVertices(const Refinement& refinement) : refinement_(refinement) {}

  [[nodiscard]] std::span<const int> order() const { return refinement_.insideOrder; }
  [[nodiscard]] int first(int triangle) const { return at(refinement_.insideBegin, triangle); }
  [[nodiscard]] int count(int triangle) const { return refinement_.insideVertices(triangle); }
  [[nodiscard]] bool sameWeights(int, int) const { return refinement_.isUniform; }
  [[nodiscard]] std::array<float, 3> weights(int triangle, int index) const {
    const glm::dvec2& place = refinement_.insideAt(first(triangle) + index);
    return {static_cast<float>(1.0 - place.x - place.y), static_cast<float>(place.x), static_cast<float>(place.y)};
  }

 private:
  const Refinement& refinement_;
};

/// Up to width() edges or triangles, the ones with the most vertices first; lanes beyond the last repeat it.
template <class Piece>
class PieceLanes {
 public:
  static constexpr std::size_t kCorners = std::tuple_size_v<decltype(Piece::vertices)>;

  PieceLanes(const PieceVertices<Piece>& vertices, std::span<const int> pieces)
      : vertices_(vertices),
        pieces_(pieces),
        used_(pieces.size()),
        sameWeights_(vertices.sameWeights(pieces.front(), pieces.back())) {}

  [[nodiscard]] int piece(std::size_t lane) const { return pieces_[std::min(lane, pieces_.size() - 1)]; }

  template <class Corner>
  HWY_INLINE Corners<kCorners> corners(Corner corner) const {
    Corners<kCorners> out;
    for (std::size_t c = 0; c < kCorners; ++c) {
      out.of[c] = gatherBy([&](std::size_t lane) HWY_ATTR { return corner(lane, c); });
    }
    return out;
  }

  /// Calls visit(weights, used, index) for the index-th vertex of the first `used` lanes, the pieces that have one.
  template <class Visit>
  HWY_INLINE void forEachVertex(Visit visit) {
    const int most = vertices_.count(pieces_.front());
    for (int index = 0; index < most; ++index) {
      while (vertices_.count(pieces_[used_ - 1]) <= index) --used_;
      visit(weightsAt(index), used_, static_cast<std::size_t>(index));
    }
  }

 private:
  HWY_INLINE Weights weightsAt(int index) const {
    if (sameWeights_) {
      const auto [u, v, s] = vertices_.weights(pieces_.front(), index);
      return {all(u), all(v), all(s)};
    }
    LaneFloats lanes[3]{};
    for (std::size_t lane = 0; lane < width(); ++lane) {
      const auto weights = vertices_.weights(pieces_[std::min(lane, used_ - 1)], index);
      for (std::size_t i = 0; i < 3; ++i) lanes[i].lane[lane] = weights[i];
    }
    return {hn::Load(kTag, lanes[0].at(0)), hn::Load(kTag, lanes[1].at(0)), hn::Load(kTag, lanes[2].at(0))};
  }

  const PieceVertices<Piece>& vertices_;
  std::span<const int> pieces_;
  std::size_t used_;
  bool sameWeights_;
};

/// Calls visit(lanes, place) on any thread; place(lane) is the lane's first refined vertex.
template <class Piece, class Visit>
HWY_INLINE void forEachLanes(const Refinement& refinement, Visit visit) {
  const PieceVertices<Piece> vertices(refinement);
  const std::span<const int> order = vertices.order();
  if (order.empty()) return;
  constexpr std::size_t kMinGroups = 64;  // For one thread.
  const std::size_t groups = (order.size() + width() - 1) / width();
  forRanges(groups, kMinGroups, [&](std::size_t begin, std::size_t end) HWY_ATTR {
    for (std::size_t group = begin; group < end; ++group) {
      const std::size_t i = group * width();
      PieceLanes<Piece> lanes(vertices, order.subspan(i, std::min(width(), order.size() - i)));
      visit(lanes, [&](std::size_t lane) { return toIndex(vertices.first(lanes.piece(lane))); });
    }
  });
}

template <class Patch, class Piece>
HWY_NOINLINE void evaluateAll(const PatchInputs& inputs, std::span<const Piece> pieces) {
  const Rows positions(inputs.positions);
  const Rows normals(inputs.normals);
  forEachLanes<Piece>(*inputs.refinement, [&](PieceLanes<Piece>& lanes, const auto& place) HWY_ATTR {
    const auto vertex = [&](std::size_t lane, std::size_t c) { return at(pieces, lanes.piece(lane)).vertices[c]; };
    const Ends<PieceLanes<Piece>::kCorners> ends{
        lanes.corners([&](std::size_t lane, std::size_t c) { return positions.at(vertex(lane, c)); }),
        lanes.corners([&](std::size_t lane, std::size_t c) { return normals.at(vertex(lane, c)); })};
    const Patch patch(ends);
    lanes.forEachVertex([&](const Weights& weights, std::size_t used, std::size_t i) HWY_ATTR {
      const Point point = patch.at(weights);
      scatterTo(
          point.position, [&](std::size_t lane) { return &inputs.outPositions[place(lane) + i]; }, used);
      scatterTo(
          point.normal, [&](std::size_t lane) { return &inputs.outNormals[place(lane) + i]; }, used);
    });
  });
}

template <class Piece>
HWY_NOINLINE void interpolate(const DirectionInputs& inputs, std::span<const Piece> pieces) {
  const Rows control(inputs.control);
  forEachLanes<Piece>(*inputs.refinement, [&](PieceLanes<Piece>& lanes, const auto& place) HWY_ATTR {
    const auto corners = lanes.corners(
        [&](std::size_t lane, std::size_t c) { return control.at(at(pieces, lanes.piece(lane)).vertices[c]); });
    lanes.forEachVertex([&](const Weights& weights, std::size_t used, std::size_t i) HWY_ATTR {
      scatterTo(
          phongNormal(corners, weights), [&](std::size_t lane) { return &inputs.out[place(lane) + i]; }, used);
    });
  });
}

/// Collects drawn edges or triangles with a creased wedge until they fill the lanes.
template <class Patch, class Piece>
class Shader {
 public:
  static constexpr std::size_t kCorners = PieceLanes<Piece>::kCorners;

  explicit Shader(const ShadingInputs& inputs)
      : inputs_(inputs), positions_(inputs.positions), normals_(inputs.wedgeNormals), vertices_(*inputs.refinement) {}

  /// @param first  drawn vertex.
  void add(int piece, const std::array<int, kCorners>& wedges, int first) {
    if (vertices_.count(piece) == 0) return;
    if (std::ranges::none_of(wedges, [&](int wedge) { return at(inputs_.mesh->wedges, wedge).creased; })) return;
    if (used_ > 0 && vertices_.count(piece) != vertices_.count(pieces_[0])) shade();
    pieces_[used_] = piece;
    wedges_[used_] = wedges;
    first_[used_] = toIndex(first);
    if (++used_ == width()) shade();
  }

  void finish() {
    if (used_ > 0) shade();
  }

 private:
  void shade() {
    std::fill(wedges_.begin() + static_cast<std::ptrdiff_t>(used_), wedges_.end(), wedges_[0]);
    PieceLanes<Piece> lanes(vertices_, std::span(pieces_).first(used_));
    const Ends<kCorners> ends{
        lanes.corners([&](std::size_t lane, std::size_t c) {
          return positions_.at(at(inputs_.mesh->wedges, wedges_[lane][c]).vertex);
        }),
        lanes.corners([&](std::size_t lane, std::size_t c) { return normals_.at(wedges_[lane][c]); })};
    const Patch patch(ends);
    lanes.forEachVertex([&](const Weights& weights, std::size_t used, std::size_t i) HWY_ATTR {
      scatterTo(
          patch.at(weights).normal, [&](std::size_t lane) { return &inputs_.outNormals[first_[lane] + i]; }, used);
    });
    used_ = 0;
  }

  const ShadingInputs& inputs_;
  Rows positions_;
  Rows normals_;
  PieceVertices<Piece> vertices_;
  std::size_t used_ = 0;
  std::array<int, kLanes> pieces_{};
  std::array<std::array<int, kCorners>, kLanes> wedges_{};
  std::array<std::size_t, kLanes> first_{};
};

/// One kind of patch, by its formulas for edges and for triangles.
template <class EdgePatch, class TrianglePatch>
struct Kind {
  static void evaluate(const PatchInputs& inputs) {
    evaluateAll<EdgePatch, Edge>(inputs, inputs.mesh->edges);
    evaluateAll<TrianglePatch, ControlTriangle>(inputs, inputs.mesh->triangles);
  }
  static void shade(const ShadingInputs& inputs) {
    const Refinement& refinement = *inputs.refinement;
    Shader<EdgePatch, Edge> edges(inputs);
    for (const DrawnRun& run : refinement.drawRuns) edges.add(run.edge, run.wedges, run.first);
    edges.finish();
    Shader<TrianglePatch, ControlTriangle> triangles(inputs);
    for (std::size_t t = 0; t < refinement.drawInside.size(); ++t) {
      triangles.add(static_cast<int>(t), inputs.mesh->triangles[t].wedges, refinement.drawInside[t]);
    }
    triangles.finish();
  }
};

void evaluateKind(const PatchInputs& inputs) {
  switch (inputs.kind) {
    case PatchKind::kPn:
      return Kind<PnEdgePatch, PnTrianglePatch>::evaluate(inputs);
    case PatchKind::kPhong:
      return Kind<PhongPatch<2>, PhongPatch<3>>::evaluate(inputs);
    case PatchKind::kSpherigon:
      return Kind<SpherigonPatch<2>, SpherigonPatch<3>>::evaluate(inputs);
    case PatchKind::kFlat:
      return Kind<FlatPatch<2>, FlatPatch<3>>::evaluate(inputs);
  }
}

void interpolateAll(const DirectionInputs& inputs) {
  interpolate<Edge>(inputs, inputs.mesh->edges);
  interpolate<ControlTriangle>(inputs, inputs.mesh->triangles);
}

/// All kinds but pn have the same normals.
void shadeKind(const ShadingInputs& inputs) {
  if (inputs.kind == PatchKind::kPn) {
    Kind<PnEdgePatch, PnTrianglePatch>::shade(inputs);
  } else {
    Kind<FlatPatch<2>, FlatPatch<3>>::shade(inputs);
  }
}

constexpr PatchKernels kKernels{&evaluateKind, &interpolateAll, &shadeKind};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

PatchKernels patchKernels(InstructionSet set) { SINEW_RETURN_BY_SET(set, kKernels) }

}  // namespace sinew
#endif
