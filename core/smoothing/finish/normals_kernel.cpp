// core/smoothing/finish/normals_kernel.cpp: normals held to the faces and without teeth, compiled once per instruction
// set.
#include "core/smoothing/finish/normals_kernel.h"

#include <algorithm>
#include <cmath>

#include "core/lanes/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/smoothing/finish/normals_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/lanes/lane_blocks.h"
#include "core/lanes/lane_points.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

constexpr float kFreedom = 0.145f;       ///< About 8 degrees.
constexpr float kRotationFrom = -0.95f;  ///< Cosine between face normals from which a rotation between them counts.
constexpr float kRotationWhole = -0.7f;
constexpr float kTeeth = 0.23f;  ///< Largest weight of the second step.
// Difference between neighbours' deltas from which the second step works, from which it works whole, and where it ends.
constexpr float kTeethFrom = 0.22f;
constexpr float kTeethWhole = 0.45f;
constexpr float kCliffFrom = 0.45f;
constexpr float kCliffWhole = 0.8f;
constexpr float kTurnedWhole = 0.1f;  ///< Turn of a vertex from which the second step works whole.

using Pair = Blocks<2>;

/// An angle to 7e-5 from twice its cosine (Abramowitz & Stegun 4.4.45): a weight needs no more.
template <std::size_t kCount>
HWY_INLINE Blocks<kCount> roughAngle(const Blocks<kCount>& x) {
  const auto all = [](float value) HWY_ATTR { return Blocks<kCount>::all(value); };
  const Blocks<kCount> positive = lesser(all(0.5f) * magnitude(x), all(1.0f));
  const Blocks<kCount> polynomial =
      all(1.5707288f) + positive * (all(-0.2121144f) + positive * (all(0.0742610f) - positive * all(0.0187293f)));
  const Blocks<kCount> angle = root(all(1.0f) - positive) * polynomial;
  return whereNegative(x, all(3.14159265f) - angle, angle);
}

/// Of one triangle or of two, block by block: their normals, times the angle at one corner.
template <std::size_t kCount>
struct CornerNormals {
  Blocks<kCount> a;
  Blocks<kCount> b;
  Blocks<kCount> c;
};

template <std::size_t kCount>
HWY_INLINE CornerNormals<kCount> cornerNormals(const Blocks<kCount>& a, const Blocks<kCount>& b,
                                               const Blocks<kCount>& c) {
  using Many = Blocks<kCount>;
  const Many ab = b - a;
  const Many bc = c - b;
  const Many ca = a - c;
  const Many face = yzxw(ab * yzxw(bc) - yzxw(ab) * bc);
  // Squared lengths of ab, bc, ca and the face; corner by corner those of one edge, the other and the opposite one.
  const Many one = sums(ab * ab, bc * bc, ca * ca, face * face);
  const Many other = xyzAndW(zxyw(one), Many::all(1.0f));
  const Many opposite = yzxw(one);
  const Many squares = one * other;
  // Twice the cosines, and in w one over the face's length.
  const Many cosines = wherePositive(squares, ((one - opposite) + other) / root(squares));
  const Many weights = roughAngle(cosines) * spread<3>(cosines);
  return {spread<0>(weights) * face, spread<1>(weights) * face, spread<2>(weights) * face};
}

HWY_INLINE void addTo(const NormalsFrame& frame, const std::array<int, 3>& t, const CornerNormals<2>& normals) {
  const auto add = [&](int v, const Pair& more) HWY_ATTR {
    float* sum = frame.work[v].faces.data();
    (Pair::load(sum) + more).store(sum);
  };
  add(t[0], normals.a);
  add(t[1], normals.b);
  add(t[2], normals.c);
}

HWY_INLINE const float* cornerOf(const NormalsFrame& frame, const std::array<int, 3>& t, std::size_t i) {
  return frame.pairs[t[i]].of.data();
}

HWY_INLINE void addFace(const NormalsFrame& frame, const std::array<int, 3>& t) {
  const auto corner = [&](std::size_t i) HWY_ATTR { return Pair::load(cornerOf(frame, t, i)); };
  addTo(frame, t, cornerNormals(corner(0), corner(1), corner(2)));
}

#if HWY_TARGET == HWY_AVX3
/// The first one's are added first, as addFace() one after the other would.
HWY_INLINE void addTwoFaces(const NormalsFrame& frame, const std::array<int, 3>& t, const std::array<int, 3>& u) {
  const auto corner = [&](std::size_t i)
                          HWY_ATTR { return Blocks<4>::joined(cornerOf(frame, t, i), cornerOf(frame, u, i)); };
  const CornerNormals<4> both = cornerNormals(corner(0), corner(1), corner(2));
  addTo(frame, t, {lower(both.a), lower(both.b), lower(both.c)});
  addTo(frame, u, {upper(both.a), upper(both.b), upper(both.c)});
}
#endif

void sumFaces(const NormalsFrame& frame) {
  for (const int vertex : frame.moved->corners) frame.work[vertex].faces = {};
  const std::array<int, 3>* triangles = frame.refinement->triangles.data();
  const std::span<const int> refined = frame.moved->refined;
  std::size_t i = 0;
#if HWY_TARGET == HWY_AVX3
  for (; i + 1 < refined.size(); i += 2) addTwoFaces(frame, triangles[refined[i]], triangles[refined[i + 1]]);
#endif
  for (; i < refined.size(); ++i) addFace(frame, triangles[refined[i]]);
  for (const int vertex : frame.moved->corners) {
    // holdToFaces() writes the others' turns; these have none.
    if (!frame.moved->isNear[static_cast<std::size_t>(vertex)]) frame.work[vertex].faces[0] = 0.0f;
  }
}

/// Unit, where the length is that of a sum of a few weighted unit vectors; `fallback` where they cancel.
HWY_INLINE V3 unitOfSum(const V3& sum, const V3& fallback) {
  const V squared = dot(sum, sum);
  return choose(hn::Gt(squared, all(1e-12f)), (all(1.0f) / hn::Sqrt(squared)) * sum, fallback);
}

/// What the least rotation that takes `from` to `to`, both unit, adds to v. Opposite ones have no such rotation:
/// towards them it goes over into their plain difference.
HWY_INLINE V3 turnOf(const V3& v, const V3& from, const V3& to) {
  const V cosine = dot(from, to);
  const V t = hn::Min(hn::Max((cosine - all(kRotationFrom)) / all(kRotationWhole - kRotationFrom), zero()), all(1.0f));
  const V share = t * t * (all(3.0f) - all(2.0f) * t);
  const V3 axis = cross(from, to);
  const V3 across = cross(axis, v);
  const V3 rotated = across + (all(1.0f) / (all(1.0f) + cosine)) * cross(axis, across);
  const M whole = hn::Ge(t, all(1.0f));
  if (hn::AllTrue(kTag, whole)) return rotated;
  const V3 plain = to - from;
  const V3 between = share * rotated + (all(1.0f) - share) * plain;
  return choose(whole, rotated, choose(hn::Gt(t, zero()), between, plain));
}

/// Of up to width() vertices; the lanes beyond them repeat the last one.
struct HeldLanes {
  LanePoints own;
  LanePoints normals;
  LanePoints patchFaces;
  LanePoints faces;
  LaneFloats filtered;
  LaneFloats turns;

  void gather(const NormalsFrame& frame, std::span<const int> vertices) {
    for (std::size_t lane = 0; lane < width(); ++lane) {
      const int vertex = vertices[std::min(lane, vertices.size() - 1)];
      const auto v = static_cast<std::size_t>(vertex);
      const float* sums = frame.work[vertex].faces.data();
      put(own, lane, &frame.patchNormals[v].x);
      put(normals, lane, &frame.normals[v].x);
      put(patchFaces, lane, sums);
      put(faces, lane, sums + 4);
      if (!frame.filtered.empty()) filtered.lane[lane] = frame.filtered[v];
    }
  }

 private:
  static HWY_INLINE void put(LanePoints& points, std::size_t lane, const float* from) {
    points.x.lane[lane] = from[0];
    points.y.lane[lane] = from[1];
    points.z.lane[lane] = from[2];
  }
};

void holdToFaces(const NormalsFrame& frame, std::span<const int> vertices) {
  HeldLanes lanes;
  lanes.gather(frame, vertices);
  const V3 own = lanes.own.load(0);
  const V3 normal = lanes.normals.load(0);
  const V3 fieldDelta = normal - own;
  const V3 shown = turnOf(own, unitOfSum(lanes.patchFaces.load(0), own), unitOfSum(lanes.faces.load(0), own));
  const V turn = hn::Max(dot(fieldDelta, fieldDelta), dot(shown, shown));
  const V3 beyond = fieldDelta - shown;
  const V squared = dot(beyond, beyond);
  const V whole = all(kFreedom);
  const V freedom = frame.filtered.empty() ? whole : whole * (all(1.0f) - hn::Load(kTag, lanes.filtered.at(0)));
  const M held = hn::Gt(squared, freedom * freedom);
  const V3 delta = choose(held, shown + (freedom / hn::Sqrt(squared)) * beyond, fieldDelta);
  const V3 turned = choose(held, unitOfSum(own + delta, normal), normal);
  lanes.own.store(delta, 0);
  lanes.normals.store(turned, 0);
  hn::Store(turn, kTag, lanes.turns.at(0));
  for (std::size_t lane = 0; lane < vertices.size(); ++lane) {
    float* pair = frame.work[vertices[lane]].pair.data();
    pair[0] = lanes.own.x.lane[lane];
    pair[1] = lanes.own.y.lane[lane];
    pair[2] = lanes.own.z.lane[lane];
    frame.work[vertices[lane]].faces[0] = lanes.turns.lane[lane];
  }
  forEach(held, 0, [&](std::size_t lane) {
    if (lane < vertices.size()) frame.normals[static_cast<std::size_t>(vertices[lane])] = lanes.normals.at(lane);
  });
}

using Vector = Blocks<1>;

constexpr std::size_t kDelta = 0;  ///< Where in a vertex's pair delta is ...
constexpr std::size_t kFirst = 4;  ///< ... and (M - 1) delta.

template <std::size_t kWhat>
HWY_INLINE const float* placeOf(const NormalsFrame& frame, int vertex) {
  return frame.work[vertex].pair.data() + kWhat;
}

/// What six neighbours differ by, two in each.
struct SixNeighbours {
  Pair a;
  Pair b;
  Pair c;
};

template <std::size_t kWhat>
HWY_INLINE SixNeighbours differences(const NormalsFrame& frame, const int* ring, const Pair& own) {
  const auto two = [&](std::size_t i) HWY_ATTR {
    return Pair::joined(placeOf<kWhat>(frame, ring[i]), placeOf<kWhat>(frame, ring[i + 1])) - own;
  };
  return {two(0), two(2), two(4)};
}

/// (M - 1) delta at all corners, and the vertices that differ from a neighbour by more than kTeethFrom, with the square
/// of the largest difference. Returns how many.
std::size_t findTeeth(const NormalsFrame& frame) {
  std::size_t count = 0;
  for (const int vertex : frame.moved->corners) {
    const float* place = placeOf<kDelta>(frame, vertex);
    const Pair own = Pair::joined(place, place);
    Pair sum = Pair::all(0.0f);
    Pair most = sum;
    const std::span<const int> ring = frame.rings->at(vertex);
    for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
      const SixNeighbours six = differences<kDelta>(frame, ring.data() + i, own);
      sum = sum + ((six.a + six.b) + six.c);
      most = greater(most, sums(six.a * six.a, six.b * six.b, six.c * six.c, six.c * six.c));
    }
    const Vector share = Vector::all(frame.rings->share[static_cast<std::size_t>(vertex)]);
    (share * (lower(sum) + upper(sum))).store(frame.work[vertex].pair.data() + kFirst);
    const Vector apart = greater(lower(most), upper(most));
    frame.teeth[count] = vertex;
    frame.weights[count] = first(greater(greater(apart, spread<1>(apart)), spread<2>(apart)));
    count += frame.weights[count] > kTeethFrom * kTeethFrom ? 1 : 0;
  }
  return count;
}

HWY_INLINE V smoothstepOf(float from, float to, V x) {
  const V t = hn::Min(hn::Max((x - all(from)) / all(to - from), zero()), all(1.0f));
  return t * t * (all(3.0f) - all(2.0f) * t);
}

/// In place of the squared differences.
void weighTeeth(const NormalsFrame& frame, std::size_t count) {
  for (std::size_t begin = 0; begin < count; begin += width()) {
    LaneFloats squared;
    LaneFloats turns;
    LaneFloats cliffs;
    for (std::size_t lane = 0; lane < width(); ++lane) {
      const std::size_t tooth = std::min(begin + lane, count - 1);
      const int vertex = frame.teeth[tooth];
      squared.lane[lane] = frame.weights[tooth];
      turns.lane[lane] = frame.work[vertex].faces[0];
      cliffs.lane[lane] = frame.filtered.empty() ? 1.0f : 1.0f - frame.filtered[static_cast<std::size_t>(vertex)];
    }
    const V apart = hn::Sqrt(hn::Load(kTag, squared.at(0)));
    const V turn = hn::Sqrt(hn::Load(kTag, turns.at(0)));
    const V cliff = hn::Load(kTag, cliffs.at(0)) * smoothstepOf(kCliffFrom, kCliffWhole, apart);
    // Only where something has turned; from there on continuously.
    const V weight = all(kTeeth) * smoothstepOf(kTeethFrom, kTeethWhole, apart) * (all(1.0f) - cliff) *
                     smoothstepOf(0.0f, kTurnedWhole, turn);
    hn::Store(weight, kTag, squared.at(0));
    for (std::size_t lane = 0; lane < width() && begin + lane < count; ++lane) {
      frame.weights[begin + lane] = squared.lane[lane];
    }
  }
}

/// delta less its share of (M - 1)^2 delta.
void removeTeeth(const NormalsFrame& frame, std::size_t count) {
  for (std::size_t tooth = 0; tooth < count; ++tooth) {
    if (frame.weights[tooth] == 0.0f) continue;
    const int vertex = frame.teeth[tooth];
    const auto v = static_cast<std::size_t>(vertex);
    const float* place = placeOf<kFirst>(frame, vertex);
    const Pair own = Pair::joined(place, place);
    Pair sum = Pair::all(0.0f);
    const std::span<const int> ring = frame.rings->at(vertex);
    for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple) {
      const SixNeighbours six = differences<kFirst>(frame, ring.data() + i, own);
      sum = sum + ((six.a + six.b) + six.c);
    }
    const Vector second = Vector::all(frame.weights[tooth] * frame.rings->share[v]) * (lower(sum) + upper(sum));
    alignas(16) std::array<float, 4> delta;
    (Vector::load(placeOf<kDelta>(frame, vertex)) - second).store(delta.data());
    const glm::vec3 normal = frame.patchNormals[v] + glm::vec3(delta[0], delta[1], delta[2]);
    const float squared = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
    if (squared > 1e-12f) frame.normals[v] = (1.0f / std::sqrt(squared)) * normal;
  }
}

void makeNormals(NormalsFrame& frame) {
  sumFaces(frame);
  const std::span<const int> near = frame.moved->near;
  for (std::size_t i = 0; i < near.size(); i += width()) {
    holdToFaces(frame, near.subspan(i, std::min(width(), near.size() - i)));
  }
  const std::size_t teeth = findTeeth(frame);
  weighTeeth(frame, teeth);
  removeTeeth(frame, teeth);
  for (const int vertex : frame.moved->corners) frame.work[vertex].pair = {};
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/lanes/dispatch.h"

namespace sinew {

NormalsKernel normalsKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, makeNormals) }

}  // namespace sinew
#endif
