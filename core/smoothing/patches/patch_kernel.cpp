// core/smoothing/patches/patch_kernel.cpp: patches, directions and the normals of creases, compiled once per
// instruction set.
#include "core/smoothing/patches/patch_kernel.h"

#include <algorithm>
#include <tuple>

#include "core/base/at.h"
#include "core/base/parallel.h"
#include "core/lanes/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/smoothing/patches/patch_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/smoothing/patches/patch_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// width() edges or triangles from one on; lanes beyond the last one repeat it.
template <class Piece>
class PieceLanes {
 public:
  static constexpr std::size_t kCorners = std::tuple_size_v<decltype(Piece::vertices)>;

  PieceLanes(std::span<const Piece> pieces, std::size_t first)
      : pieces_(pieces.subspan(first, std::min(width(), pieces.size() - first))) {}

  [[nodiscard]] std::size_t used() const { return pieces_.size(); }

  HWY_INLINE Corners<kCorners> corners(const Rows& from) const {
    Corners<kCorners> out;
    for (std::size_t c = 0; c < kCorners; ++c) {
      out.of[c] =
          gatherBy([&](std::size_t lane) HWY_ATTR { return from.at(pieces_[std::min(lane, used() - 1)].vertices[c]); });
    }
    return out;
  }

 private:
  std::span<const Piece> pieces_;
};

/// Calls visit(lanes, place), on any thread, place being the first refined vertex of the first lane. @param first  of
/// all refined vertices.  @param each  refined vertices of a piece.
template <class Piece, class Visit>
HWY_INLINE void forEachLanes(std::span<const Piece> pieces, int first, std::size_t each, Visit visit) {
  if (each == 0) return;
  constexpr std::size_t kMinVertices = 4096;  // For one thread.
  const std::size_t groups = (pieces.size() + width() - 1) / width();
  forRanges(groups, kMinVertices / (each * width()) + 1, [&](std::size_t begin, std::size_t end) HWY_ATTR {
    for (std::size_t group = begin; group < end; ++group) {
      const std::size_t i = group * width();
      visit(PieceLanes<Piece>(pieces, i), toIndex(first) + i * each);
    }
  });
}

template <class Patch, class Piece>
HWY_NOINLINE void evaluateAll(const PatchInputs& inputs, std::span<const Piece> pieces, int first) {
  constexpr std::size_t kCorners = PieceLanes<Piece>::kCorners;
  const Rows positions(inputs.positions);
  const Rows normals(inputs.normals);
  const Lattice<kCorners> lattice(*inputs.refinement);
  forEachLanes(pieces, first, lattice.count, [&](const PieceLanes<Piece>& lanes, std::size_t place) HWY_ATTR {
    const Ends<kCorners> ends{lanes.corners(positions), lanes.corners(normals)};
    const Patch patch(ends);
    for (std::size_t i = 0; i < lattice.count; ++i) {
      const Point point = patch.at(lattice.at[i]);
      scatter(point.position, &inputs.outPositions[place + i], lattice.count, lanes.used());
      scatter(point.normal, &inputs.outNormals[place + i], lattice.count, lanes.used());
    }
  });
}

template <class Piece>
HWY_NOINLINE void interpolate(const DirectionInputs& inputs, std::span<const Piece> pieces, int first) {
  const Rows control(inputs.control);
  const Lattice<PieceLanes<Piece>::kCorners> lattice(*inputs.refinement);
  forEachLanes(pieces, first, lattice.count, [&](const PieceLanes<Piece>& lanes, std::size_t place) HWY_ATTR {
    const auto corners = lanes.corners(control);
    for (std::size_t i = 0; i < lattice.count; ++i) {
      scatter(phongNormal(corners, lattice.at[i]), &inputs.out[place + i], lattice.count, lanes.used());
    }
  });
}

/// Collects edges or triangles as drawn, those with a creased wedge, until they fill the lanes.
template <class Patch, std::size_t kCorners>
class Shader {
 public:
  explicit Shader(const ShadingInputs& inputs)
      : inputs_(inputs), positions_(inputs.positions), normals_(inputs.wedgeNormals), lattice_(*inputs.refinement) {}

  /// @param first  drawn vertex.
  void add(const std::array<int, kCorners>& wedges, int first) {
    if (std::ranges::none_of(wedges, [&](int wedge) { return at(inputs_.mesh->wedges, wedge).creased; })) return;
    wedges_[used_] = wedges;
    first_[used_] = toIndex(first);
    if (++used_ == width()) shade();
  }

  void finish() {
    if (used_ == 0) return;
    std::fill(wedges_.begin() + static_cast<std::ptrdiff_t>(used_), wedges_.end(), wedges_[0]);
    shade();
  }

 private:
  void shade() {
    Ends<kCorners> ends;
    for (std::size_t c = 0; c < kCorners; ++c) {
      ends.positions.of[c] =
          gatherBy([&](std::size_t lane) { return positions_.at(at(inputs_.mesh->wedges, wedges_[lane][c]).vertex); });
      ends.normals.of[c] = gatherBy([&](std::size_t lane) { return normals_.at(wedges_[lane][c]); });
    }
    const Patch patch(ends);
    for (std::size_t i = 0; i < lattice_.count; ++i) {
      scatterTo(
          patch.at(lattice_.at[i]).normal, [&](std::size_t lane) { return &inputs_.outNormals[first_[lane] + i]; },
          used_);
    }
    used_ = 0;
  }

  const ShadingInputs& inputs_;
  Rows positions_;
  Rows normals_;
  Lattice<kCorners> lattice_;
  std::size_t used_ = 0;
  std::array<std::array<int, kCorners>, kLanes> wedges_{};
  std::array<std::size_t, kLanes> first_{};
};

/// One kind, by its formulas for edges and for triangles.
template <class EdgePatch, class TrianglePatch>
struct Kind {
  static void evaluate(const PatchInputs& inputs) {
    const Refinement& refinement = *inputs.refinement;
    evaluateAll<EdgePatch, Edge>(inputs, inputs.mesh->edges, refinement.controlVertices);
    evaluateAll<TrianglePatch, ControlTriangle>(inputs, inputs.mesh->triangles, refinement.interiorVertex(0, 0));
  }
  static void shade(const ShadingInputs& inputs) {
    const Refinement& refinement = *inputs.refinement;
    Shader<EdgePatch, 2> edges(inputs);
    for (const DrawnRun& run : refinement.drawRuns) edges.add(run.wedges, run.first);
    edges.finish();
    Shader<TrianglePatch, 3> triangles(inputs);
    for (std::size_t t = 0; t < refinement.drawInterior.size(); ++t) {
      triangles.add(inputs.mesh->triangles[t].wedges, refinement.drawInterior[t]);
    }
    triangles.finish();
  }
};

void evaluateKind(const PatchInputs& inputs) {
  switch (inputs.kind) {
    case PatchKind::kPn:
      return Kind<PnEdge, PnTriangle>::evaluate(inputs);
    case PatchKind::kPhong:
      return Kind<PhongPatch<2>, PhongPatch<3>>::evaluate(inputs);
    case PatchKind::kSpherigon:
      return Kind<SpherigonPatch<2>, SpherigonPatch<3>>::evaluate(inputs);
    case PatchKind::kFlat:
      return Kind<FlatPatch<2>, FlatPatch<3>>::evaluate(inputs);
  }
}

void interpolateAll(const DirectionInputs& inputs) {
  const Refinement& refinement = *inputs.refinement;
  interpolate<Edge>(inputs, inputs.mesh->edges, refinement.controlVertices);
  interpolate<ControlTriangle>(inputs, inputs.mesh->triangles, refinement.interiorVertex(0, 0));
}

/// All but pn have the same normals.
void shadeKind(const ShadingInputs& inputs) {
  if (inputs.kind == PatchKind::kPn) {
    Kind<PnEdge, PnTriangle>::shade(inputs);
  } else {
    Kind<FlatPatch<2>, FlatPatch<3>>::shade(inputs);
  }
}

constexpr PatchKernels kKernels{&evaluateKind, &interpolateAll, &shadeKind};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/lanes/dispatch.h"

namespace sinew {

PatchKernels patchKernels(InstructionSet set) { SINEW_RETURN_BY_SET(set, kKernels) }

}  // namespace sinew
#endif
