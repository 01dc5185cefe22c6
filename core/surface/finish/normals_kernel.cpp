// core/surface/finish/normals_kernel.cpp: normals softened at rims, held to faces, freed of teeth, per instruction set.
#include "core/surface/finish/shading_normals.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/formulas.h"
#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/finish/normals_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/geometry/lane_blocks.h"
#include "core/geometry/lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

#define formula HWY_INLINE
#define constant constexpr
#include "core/geometry/formulas/finish.h"
#undef constant
#undef formula

using Pair = Blocks<2>;

/// An angle, to 7e-5, from twice its cosine (Abramowitz & Stegun 4.4.45): enough for a weight.
template <std::size_t kCount>
HWY_INLINE Blocks<kCount> roughAngle(const Blocks<kCount>& x) {
  const auto all = [](float value) HWY_ATTR { return Blocks<kCount>::all(value); };
  const Blocks<kCount> positive = min(all(0.5f) * magnitude(x), all(1.0f));
  const Blocks<kCount> polynomial =
      all(1.5707288f) + positive * (all(-0.2121144f) + positive * (all(0.0742610f) - positive * all(0.0187293f)));
  const Blocks<kCount> angle = root(all(1.0f) - positive) * polynomial;
  return whereNegative(x, all(3.14159265f) - angle, angle);
}

/// Normals of one triangle or two, times the angle at each corner.
template <std::size_t kCount>
struct LaneCorners {
  Blocks<kCount> a;
  Blocks<kCount> b;
  Blocks<kCount> c;
};

template <std::size_t kCount>
HWY_INLINE LaneCorners<kCount> cornerNormals(const Blocks<kCount>& a, const Blocks<kCount>& b,
                                             const Blocks<kCount>& c) {
  using Many = Blocks<kCount>;
  const Many ab = b - a;
  const Many bc = c - b;
  const Many ca = a - c;
  const Many face = yzxw(ab * yzxw(bc) - yzxw(ab) * bc);
  // Squared lengths of ab, bc, ca and the face; for each corner, of one edge, the other and the opposite one.
  const Many one = sums(ab * ab, bc * bc, ca * ca, face * face);
  const Many other = xyzAndW(zxyw(one), Many::all(1.0f));
  const Many opposite = yzxw(one);
  const Many squares = one * other;
  // Twice the cosines; w: 1 / length of the face.
  const Many cosines = wherePositive(squares, ((one - opposite) + other) / root(squares));
  const Many weights = roughAngle(cosines) * spread<3>(cosines);
  return {spread<0>(weights) * face, spread<1>(weights) * face, spread<2>(weights) * face};
}

HWY_INLINE const float* cornerOf(const NormalsInputs& inputs, const std::array<int, 3>& t, std::size_t i) {
  return inputs.pairs[t[i]].of.data();
}

/// Stores each normal in the list of its vertex.
HWY_INLINE void store(const LaneCorners<2>& normals, const NormalsInputs& inputs, int triangle) {
  const int* places = inputs.rings->placeOf.data() + 3 * triangle;
  normals.a.store(inputs.corners[places[0]].of.data());
  normals.b.store(inputs.corners[places[1]].of.data());
  normals.c.store(inputs.corners[places[2]].of.data());
}

void findFaces(const NormalsInputs& inputs, std::size_t begin, std::size_t end) {
  const std::array<int, 3>* triangles = inputs.refinement->triangles.data();
  const std::vector<int>& refined = inputs.moved->refined;
  std::size_t i = begin;
#if HWY_TARGET == HWY_AVX3
  for (; i + 1 < end; i += 2) {
    const std::array<int, 3>& t = triangles[refined[i]];
    const std::array<int, 3>& u = triangles[refined[i + 1]];
    const auto corner = [&](std::size_t k)
                            HWY_ATTR { return Blocks<4>::join(cornerOf(inputs, t, k), cornerOf(inputs, u, k)); };
    const LaneCorners<4> both = cornerNormals(corner(0), corner(1), corner(2));
    store({lower(both.a), lower(both.b), lower(both.c)}, inputs, refined[i]);
    store({upper(both.a), upper(both.b), upper(both.c)}, inputs, refined[i + 1]);
  }
#endif
  for (; i < end; ++i) {
    const std::array<int, 3>& t = triangles[refined[i]];
    const auto corner = [&](std::size_t k) HWY_ATTR { return Pair::load(cornerOf(inputs, t, k)); };
    store(cornerNormals(corner(0), corner(1), corner(2)), inputs, refined[i]);
  }
}

/// Sum over the triangles at a vertex, in order.
HWY_INLINE Pair sumOfFaces(const NormalsInputs& inputs, int vertex) {
  const int begin = inputs.rings->cornersBegin[static_cast<std::size_t>(vertex)];
  const int end = inputs.rings->cornersBegin[static_cast<std::size_t>(vertex) + 1];
  Pair sum = Pair::all(0.0f);
  for (int i = begin; i < end; ++i) sum = sum + Pair::load(inputs.corners[i].of.data());
  return sum;
}

/// For up to width() vertices; lanes beyond them repeat the last one.
void holdToFaces(const NormalsInputs& inputs, const Rows& patchNormals, std::span<const int> vertices) {
  const auto vertexOf = [&](std::size_t lane) { return vertices[std::min(lane, vertices.size() - 1)]; };
  alignas(32) std::array<std::array<float, 8>, kLanes> sums{};
  LanePoints normals;
  LaneFloats filtered{};
  for (std::size_t lane = 0; lane < width(); ++lane) {
    const auto v = static_cast<std::size_t>(vertexOf(lane));
    sumOfFaces(inputs, vertexOf(lane)).store(sums[lane].data());
    normals.set(lane, inputs.normals[v]);
    if (!inputs.filtered.empty()) filtered.lane[lane] = inputs.filtered[v];
  }
  const V3 own = gatherBy([&](std::size_t lane) HWY_ATTR { return patchNormals.at(vertexOf(lane)); });
  const V3 patchFaces = gatherBy([&](std::size_t lane) HWY_ATTR { return sums[lane].data(); });
  const V3 faces = gatherBy([&](std::size_t lane) HWY_ATTR { return sums[lane].data() + 4; });
  const V3 normal = normals.load(0);
  const V3 fieldDelta = normal - own;
  const V3 shown = turnOf(own, unitOfSum(patchFaces, own), unitOfSum(faces, own));
  const V turn = hn::Max(dot(fieldDelta, fieldDelta), dot(shown, shown));
  const Held held = heldDelta(fieldDelta, shown, hn::Load(kTag, filtered.at(0)));
  normals.store(select(held.isHeld, unitOfSum(own + held.delta, normal), normal), 0);
  scatterTo(
      held.delta, [&](std::size_t lane) { return inputs.vertices[vertices[lane]].delta.data(); }, vertices.size());
  LaneFloats turns{};
  hn::Store(turn, kTag, turns.at(0));
  for (std::size_t lane = 0; lane < vertices.size(); ++lane) inputs.turns[vertices[lane]] = turns.lane[lane];
  forEach(held.isHeld, 0, [&](std::size_t lane) {
    if (lane < vertices.size()) inputs.normals[static_cast<std::size_t>(vertices[lane])] = normals.at(lane);
  });
}

void hold(const NormalsInputs& inputs, std::size_t begin, std::size_t end) {
  const std::span<const int> near = inputs.moved->near;
  const Rows patchNormals(inputs.patchNormals);
  for (std::size_t i = begin; i < end; i += width()) {
    holdToFaces(inputs, patchNormals, near.subspan(i, std::min(width(), end - i)));
  }
}

using Vector = Blocks<1>;

/// Differences of six neighbors, two in each member.
struct SixNeighbors {
  Pair a;
  Pair b;
  Pair c;
};

using OfVertex = std::array<float, 4> NormalsVertex::*;

template <OfVertex kWhat>
HWY_INLINE const float* placeOf(const NormalsInputs& inputs, int vertex) {
  return (inputs.vertices[vertex].*kWhat).data();
}

template <OfVertex kWhat>
HWY_INLINE SixNeighbors differences(const NormalsInputs& inputs, const int* ring, const Pair& own) {
  const auto two = [&](std::size_t i) HWY_ATTR {
    return Pair::join(placeOf<kWhat>(inputs, ring[i]), placeOf<kWhat>(inputs, ring[i + 1])) - own;
  };
  return {two(0), two(2), two(4)};
}

struct RingDifference {
  Vector mean;     ///< (M - 1) of the numbers.
  float furthest;  ///< Squared, from a neighbor's.
};

template <OfVertex kWhat>
HWY_INLINE RingDifference ringDifference(const NormalsInputs& inputs, int vertex) {
  const float* place = placeOf<kWhat>(inputs, vertex);
  const Pair own = Pair::join(place, place);
  Pair sum = Pair::all(0.0f);
  Pair most = sum;
  const std::span<const int> ring = inputs.rings->at(vertex);
  for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
    const SixNeighbors by = differences<kWhat>(inputs, ring.data() + i, own);
    sum = sum + ((by.a + by.b) + by.c);
    most = max(most, sums(by.a * by.a, by.b * by.b, by.c * by.c, by.c * by.c));
  }
  const Vector share = Vector::all(inputs.rings->share[static_cast<std::size_t>(vertex)]);
  const Vector furthest = max(lower(most), upper(most));
  return {share * (lower(sum) + upper(sum)), first(max(max(furthest, spread<1>(furthest)), spread<2>(furthest)))};
}

/// Sets `first` to (M - 1) delta. Returns the square of the largest difference between delta and a neighbor's.
HWY_INLINE float setFirst(const NormalsInputs& inputs, int vertex) {
  const RingDifference of = ringDifference<&NormalsVertex::delta>(inputs, vertex);
  of.mean.store(inputs.vertices[vertex].first.data());
  return of.furthest;
}

/// delta - weight (M - 1)^2 delta
HWY_INLINE Vector withoutSecond(const NormalsInputs& inputs, int vertex, float weight) {
  const float* place = placeOf<&NormalsVertex::first>(inputs, vertex);
  const Pair own = Pair::join(place, place);
  Pair sum = Pair::all(0.0f);
  const std::span<const int> ring = inputs.rings->at(vertex);
  for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
    const SixNeighbors six = differences<&NormalsVertex::first>(inputs, ring.data() + i, own);
    sum = sum + ((six.a + six.b) + six.c);
  }
  const float share = weight * inputs.rings->share[static_cast<std::size_t>(vertex)];
  const Vector second = Vector::all(share) * (lower(sum) + upper(sum));
  return Vector::load(placeOf<&NormalsVertex::delta>(inputs, vertex)) - second;
}

/// @param added  to `normal`, then normalized.
void setNormal(const NormalsInputs& inputs, int vertex, const glm::vec3& normal, const Vector& added) {
  alignas(16) std::array<float, 4> of;
  added.store(of.data());
  const glm::vec3 direction = normal + glm::vec3(of[0], of[1], of[2]);
  const float squared = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
  if (squared > 1e-12f) inputs.normals[static_cast<std::size_t>(vertex)] = (1.0f / std::sqrt(squared)) * direction;
}

void takeDeltas(const NormalsInputs& inputs, std::size_t begin, std::size_t end) {
  for (const int vertex : std::span(inputs.moved->corners).subspan(begin, end - begin)) {
    const auto v = static_cast<std::size_t>(vertex);
    const glm::vec3 delta = inputs.normals[v] - inputs.patchNormals[v];
    inputs.vertices[vertex].delta = {delta.x, delta.y, delta.z, 0.0f};
  }
}

/// Vertices with a delta that differs enough from a neighbor's.
std::size_t findRims(const NormalsInputs& inputs, std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t at = begin; at < end; ++at) {
    const int vertex = inputs.moved->near[at];
    const RingDifference of = ringDifference<&NormalsVertex::delta>(inputs, vertex);
    if (!(of.furthest > kRimFrom * kRimFrom)) continue;
    (Vector::all(in_float::rimWeight(std::sqrt(of.furthest))) * of.mean).store(inputs.vertices[vertex].first.data());
    inputs.teeth[begin + count++] = vertex;
  }
  return count;
}

void softenRims(const NormalsInputs& inputs, std::size_t begin, std::size_t count) {
  for (const int vertex : inputs.teeth.subspan(begin, count)) {
    const Vector added = Vector::load(placeOf<&NormalsVertex::first>(inputs, vertex));
    setNormal(inputs, vertex, inputs.normals[static_cast<std::size_t>(vertex)], added);
  }
}

/// Replaces squared differences by weights.
void weighTeeth(const NormalsInputs& inputs, std::span<const int> teeth, float* weights) {
  for (std::size_t begin = 0; begin < teeth.size(); begin += width()) {
    LaneFloats squared;
    LaneFloats turns;
    LaneFloats filtered;
    for (std::size_t lane = 0; lane < width(); ++lane) {
      const std::size_t tooth = std::min(begin + lane, teeth.size() - 1);
      const int vertex = teeth[tooth];
      squared.lane[lane] = weights[tooth];
      turns.lane[lane] = inputs.turns[vertex];
      filtered.lane[lane] = inputs.filtered.empty() ? 0.0f : inputs.filtered[static_cast<std::size_t>(vertex)];
    }
    const V apart = hn::Sqrt(hn::Load(kTag, squared.at(0)));
    const V turn = hn::Sqrt(hn::Load(kTag, turns.at(0)));
    const V weight = teethWeight(apart, hn::Load(kTag, filtered.at(0)), turn);
    hn::Store(weight, kTag, squared.at(0));
    for (std::size_t lane = 0; lane < width() && begin + lane < teeth.size(); ++lane) {
      weights[begin + lane] = squared.lane[lane];
    }
  }
}

/// Vertices whose delta differs from a neighbor's by more than kTeethFrom, and their weights.
std::size_t findTeeth(const NormalsInputs& inputs, std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t at = begin; at < end; ++at) {
    inputs.teeth[begin + count] = inputs.moved->corners[at];
    inputs.weights[begin + count] = setFirst(inputs, inputs.moved->corners[at]);
    count += inputs.weights[begin + count] > kTeethFrom * kTeethFrom ? 1 : 0;
  }
  weighTeeth(inputs, std::span<const int>(inputs.teeth).subspan(begin, count), inputs.weights.data() + begin);
  return count;
}

void removeTeeth(const NormalsInputs& inputs, std::size_t begin, std::size_t count) {
  for (std::size_t tooth = begin; tooth < begin + count; ++tooth) {
    const int vertex = inputs.teeth[tooth];
    const float weight = inputs.weights[tooth];
    if (weight == 0.0f) continue;
    const glm::vec3& patchNormal = inputs.patchNormals[static_cast<std::size_t>(vertex)];
    setNormal(inputs, vertex, patchNormal, withoutSecond(inputs, vertex, weight));
  }
}

NormalsKernel kernelHere() { return {takeDeltas, findRims, softenRims, findFaces, hold, findTeeth, removeTeeth}; }

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

NormalsKernel normalsKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, kernelHere()) }

}  // namespace sinew
#endif
