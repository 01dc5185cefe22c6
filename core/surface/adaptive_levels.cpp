// core/surface/adaptive_levels.cpp: picks poses, samples the surface finely in them and fits flat pieces.
#include "core/surface/adaptive_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/character/range_of_motion.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/rig/motion_clip.h"
#include "core/rig/posed_rig.h"
#include "core/surface/align_splits.h"
#include "core/surface/patches/levels.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"
#include "sinew/character/character.h"

namespace sinew {
namespace {

constexpr int kMostDetailPoses = 8;
constexpr int kMomentsOfClips = 96;  ///< In all, but at least kLeastOfClip of each.
constexpr int kLeastOfClip = 4;
constexpr int kMostMoments = 256;
constexpr double kStretchWeight = 2.0;    ///< Weight of a line stretched by 1, in radians of a joint.
constexpr double kLeastDifference = 0.1;  ///< Poses closer to another add nothing.
using Features = std::vector<float>;

void addMoments(const Skeleton& skeleton, const AnimationClip& clip, int count, std::vector<Pose>& out) {
  for (int i = 0; i < count && static_cast<int>(out.size()) < kMostMoments; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    out.push_back(samplePose(skeleton, clip, share * clip.duration));
  }
}

/// Rotation of a bone against its parent, compared with the bind pose.
glm::mat3 turnOf(const Skeleton& skeleton, const Pose& pose, int bone) {
  const auto axes = [](const glm::mat4& m) {
    glm::mat3 out(m);
    for (int i = 0; i < 3; ++i) {
      const float length = glm::length(out[i]);
      if (length > 0.0f) out[i] /= length;
    }
    return out;
  };
  const Bone& own = at(skeleton.bones, bone);
  const glm::mat3 now = axes(at(pose.boneInWorld, bone));
  const glm::mat3 then = axes(own.bindInWorld);
  if (own.parent < 0) return glm::mat3(1.0f);
  const glm::mat3 parentNow = axes(at(pose.boneInWorld, own.parent));
  const glm::mat3 parentThen = axes(at(skeleton.bones, own.parent).bindInWorld);
  return glm::transpose(parentNow) * now - glm::transpose(parentThen) * then;
}

class FeatureReader {
 public:
  FeatureReader(const Character& character, const Rig& rig, const RigPoser& poser)
      : character_(character), poser_(poser) {
    const Skeleton& skeleton = character.skeleton;
    std::vector<bool> counts(skeleton.bones.size(), false);
    for (const Primitive& primitive : rig.primitives) {
      const auto bone = skeleton.findBone(primitive.bone);
      if (!bone) continue;
      counts[toIndex(*bone)] = true;
      for (const int child : at(skeleton.bones, *bone).children) counts[toIndex(child)] = true;
    }
    for (std::size_t b = 0; b < counts.size(); ++b) {
      if (counts[b]) bones_.push_back(static_cast<int>(b));
    }
  }

  Features read(const Pose& pose) {
    Features out;
    for (const int bone : bones_) {
      const glm::mat3 turn = turnOf(character_.skeleton, pose, bone);
      for (int c = 0; c < 3; ++c) out.insert(out.end(), {turn[c].x, turn[c].y, turn[c].z});
    }
    poser_.pose(pose, posed_);
    for (const PosedLine& line : posed_.lines) {
      out.push_back(line.usable ? static_cast<float>(kStretchWeight) * line.bellyStretch : 0.0f);
      out.push_back(line.usable ? line.activation : 0.0f);
    }
    for (const MuscleNumbers& numbers : posed_.numbers.primitives) {
      out.push_back(numbers.amount);
      out.push_back(numbers.reach);
    }
    out.insert(out.end(), posed_.numbers.links.begin(), posed_.numbers.links.end());
    return out;
  }

 private:
  const Character& character_;
  const RigPoser& poser_;
  std::vector<int> bones_;
  PosedRig posed_;
};

double squaredDifference(const Features& a, const Features& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return sum;
}

/// Poses at even times of a character's clips and range of motion, once per character; without clips made in memory.
std::vector<Pose> detailMoments(const Character& character) {
  std::vector<Pose> moments;
  std::vector<const AnimationClip*> clips;
  for (const AnimationClip& clip : character.clips) {
    if (!clip.turnsBindPose && clip.duration > 0.0f) clips.push_back(&clip);
  }
  const int each = clips.empty() ? 0 : std::max(kLeastOfClip, kMomentsOfClips / static_cast<int>(clips.size()));
  for (const AnimationClip* clip : clips) addMoments(character.skeleton, *clip, each, moments);
  const AnimationClip motion = rangeOfMotion(character.skeleton, motionHints(character));
  const int steps = static_cast<int>(motion.duration * 2.0f);
  if (!motion.channels.empty()) addMoments(character.skeleton, motion, std::clamp(steps, 1, kMostMoments), moments);
  return moments;
}

/// The bind pose, relaxed and flexed, and the sample times that differ most from it and from each other in bent joints
/// under muscles, stretched lines and driven numbers: farthest-point sampling, at most kMostDetailPoses in all.
std::vector<Pose> detailPoses(const Character& character, const Rig& rig, const RigPoser& poser,
                              const std::vector<Pose>& moments) {
  std::vector<Pose> out{bindPose(character.skeleton)};
  if (rig.primitives.empty()) return out;
  if (!rig.lines.empty()) {
    out.push_back(out.front());
    out.back().flex = 1.0f;
  }
  FeatureReader reader(character, rig, poser);
  std::vector<Features> features;
  for (const Pose& moment : moments) features.push_back(reader.read(moment));
  std::vector<double> apart(moments.size(), 1e30);
  const auto keepAway = [&](const Features& from) {
    for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = std::min(apart[i], squaredDifference(features[i], from));
  };
  for (const Pose& pose : out) keepAway(reader.read(pose));
  while (!apart.empty() && static_cast<int>(out.size()) < kMostDetailPoses) {
    const auto next = static_cast<std::size_t>(std::ranges::max_element(apart) - apart.begin());
    if (!(apart[next] > kLeastDifference * kLeastDifference)) break;
    out.push_back(moments[next]);
    keepAway(features[next]);
  }
  return out;
}

constexpr float kNoPiece = std::numeric_limits<float>::max();

/// Splits cloth as finely as the skin under it.

class ClothSplitter {
 public:
  ClothSplitter(const Preparation& next, RefinementLevels& levels)
      : next_(next), layers_(*next.layers()), mesh_(next.mesh()), levels_(levels) {
    pieces_.assign(mesh_.positions.size(), kNoPiece);
    for (std::size_t v = 0; v < pieces_.size(); ++v) {
      if (layers_.carriers[v] == SkinLayer::kCloth) pieces_[v] = pieceUnder(layers_.skinUnder[v]);
    }
  }

  void run() {
    const std::size_t firstEdge = mesh_.positions.size();
    const std::size_t firstTriangle = firstEdge + mesh_.edges.size();
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      if (layers_.carriers[firstEdge + e] == SkinLayer::kCloth) raise(mesh_.edges[e].vertices, levels_.edges[e]);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (layers_.carriers[firstTriangle + t] != SkinLayer::kCloth) continue;
      raise(mesh_.triangles[t].vertices, levels_.triangles[t]);
    }
  }

 private:
  [[nodiscard]] float lengthOf(int a, int b) const {
    return glm::distance(at(mesh_.positions, a), at(mesh_.positions, b));
  }

  [[nodiscard]] float longest(std::span<const int> corners) const {
    float length = 0.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      length = std::max(length, lengthOf(corners[i], corners[(i + 1) % corners.size()]));
    }
    return length;
  }

  [[nodiscard]] float pieceUnder(int triangle) const {
    if (triangle < 0) return kNoPiece;
    const int carrier = static_cast<int>(mesh_.positions.size() + mesh_.edges.size()) + triangle;
    if (next_.seen->of(carrier).empty()) return kNoPiece;
    const ControlTriangle& skin = at(mesh_.triangles, triangle);
    int level = at(levels_.triangles, triangle);
    for (const int e : skin.edges) level = std::max<int>(level, at(levels_.edges, e));
    return longest(skin.vertices) / static_cast<float>(level);
  }

  void raise(std::span<const int> corners, std::uint8_t& level) const {
    float piece = kNoPiece;
    for (const int v : corners) piece = std::min(piece, at(pieces_, v));
    if (!(piece > 0.0f) || piece == kNoPiece) return;
    const float wanted = std::min(std::ceil(longest(corners) / piece), static_cast<float>(kMaxDepth));
    level = std::max(level, static_cast<std::uint8_t>(wanted));
  }

  const Preparation& next_;
  const MeshLayers& layers_;
  const ControlMesh& mesh_;
  RefinementLevels& levels_;
  std::vector<float> pieces_;  ///< [V] for cloth: length of the skin's pieces under it.
};

// Samples along an edge: each number divides the next, so that a triangle's samples are among those of its edges.
constexpr int kFewSamples = 2;
constexpr int kAdaptiveLevelsSamples = 6;
constexpr int kManySamples = 12;
constexpr float kLongEdge = 0.015f;            ///< Fraction of H: a few samples miss too much of longer edges.
constexpr std::size_t kSmallMesh = 8'000;      ///< Triangles up to which long edges are sampled finely at once.
constexpr float kNormalCosine = 0.99027f;      ///< 8 degrees.
constexpr float kWorthALook = 0.3f;            ///< Fraction of the tolerance from which few samples call for many.
constexpr float kWorthCosine = 0.99863f;       ///< 3 degrees.
constexpr float kAdaptiveLevelsMargin = 0.7f;  ///< Of the tolerance, since inner points do not lie on samples.
constexpr float kCheckMargin = 0.9f;           ///< Of the tolerance, for what lies between samples.
constexpr float kSeenPiece = 6.0f;             ///< Tolerances: the normals of shorter pieces count less.

/// Above the default tolerance normals may be off by more, as the chord of an arc that is as far off turns: by the root
/// of the tolerance.
float widened(float cosine, float tolerance) {
  const float times = tolerance / kDefaultTolerance;
  return times > 1.0f ? std::cos(std::sqrt(times) * std::acos(cosine)) : cosine;
}

/// Edges and triangles to sample, and how finely. The result for each depends on itself alone.
struct Look {
  bool first = true;                    ///< With few samples, to find where many are worth it.
  std::vector<std::uint8_t> edges;      ///< [E]
  std::vector<std::uint8_t> triangles;  ///< [T]
};

class LevelSearch {
 public:
  LevelSearch(const Preparation& next, const AdaptiveLevels& asked, RefinementLevels& needed)
      : next_(next), asked_(asked), mesh_(next.mesh()), needed_(needed) {
    const float height = next.character().height;
    const float tolerance = asked.from.tolerance;
    const float seen = kSeenPiece * tolerance * height;
    tolerance_ = {kAdaptiveLevelsMargin * tolerance * height, widened(kNormalCosine, tolerance), seen};
    look_ = {kWorthALook * tolerance_.distance, widened(kWorthCosine, tolerance), seen};
    isLongEdge_.resize(mesh_.edges.size(), false);
    for (const ControlTriangle& triangle : mesh_.triangles) {
      const bool isLong = std::ranges::any_of(triangle.edges, [&](int e) {
        const auto& ends = at(mesh_.edges, e).vertices;
        return glm::distance(at(mesh_.positions, ends[0]), at(mesh_.positions, ends[1])) > kLongEdge * height;
      });
      isLongTriangle_.push_back(isLong);
      for (const int e : triangle.edges) isLongEdge_[toIndex(e)] = isLongEdge_[toIndex(e)] || isLong;
    }
  }

  void run(std::vector<std::uint8_t> edges, std::vector<std::uint8_t> triangles) {
    flaggedEdges_.assign(edges.size(), 0);
    flaggedTriangles_.assign(triangles.size(), 0);
    take({true, std::move(edges), std::move(triangles)});
    take({false, flaggedEdges_, flaggedTriangles_});
  }

 private:
  [[nodiscard]] int samples(bool isLong, bool first) const {
    if (!first) return isLong ? kManySamples : kAdaptiveLevelsSamples;
    if (!isLong) return kFewSamples;
    return mesh_.triangles.size() <= kSmallMesh ? kManySamples : kAdaptiveLevelsSamples;
  }

  void take(const Look& look) {
    const std::vector<SampledPiece> pieces = sampledPieces(next_, look.edges, look.triangles);
    forEachIndex(pieces.size(), 1, [&](std::size_t i) { takePiece(pieces[i], look.first); });
  }

  void takePiece(const SampledPiece& piece, bool first) {
    const SampledPart part = sampledPart(next_, piece);
    const std::vector<int> edges = placesIn(part.edges, piece.edges);
    const std::vector<int> triangles = placesIn(part.triangles, piece.triangles);
    SurfaceSampler sampler(part, samplePoints(part.mesh(), samplingOf(part, edges, triangles, first)));
    Gathered samples;
    for (const Pose& pose : asked_.from.poses) {
      const View view{part, sampler.sample(pose), first};
      for (const int e : edges) fitEdge(e, view, samples);
      for (const int t : triangles) fitTriangle(t, view, samples);
    }
  }

  [[nodiscard]] RefinementLevels samplingOf(const SampledPart& part, const std::vector<int>& edges,
                                            const std::vector<int>& triangles, bool first) const {
    RefinementLevels out{std::vector<std::uint8_t>(part.edges.size()),
                         std::vector<std::uint8_t>(part.triangles.size())};
    const auto sampleEdge = [&](int e) {
      at(out.edges, e) = static_cast<std::uint8_t>(samples(isLongEdge_[toIndex(at(part.edges, e))], first));
    };
    for (const int e : edges) sampleEdge(e);
    for (const int t : triangles) {
      at(out.triangles, t) = static_cast<std::uint8_t>(samples(isLongTriangle_[toIndex(at(part.triangles, t))], first));
      for (const int e : at(part.mesh().triangles, t).edges) sampleEdge(e);
    }
    return out;
  }

  /// Samples of one pose.
  struct View {
    const SampledPart& part;
    const Surface& surface;
    bool first = true;
  };

  struct Gathered {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    void add(const Surface& surface, int vertex) {
      positions.push_back(at(surface.positions, vertex));
      normals.push_back(at(surface.normals, vertex));
    }
    void clear() {
      positions.clear();
      normals.clear();
    }
  };

  /// @param edge  of the part
  void fitEdge(int edge, const View& view, Gathered& own) {
    const int e = at(view.part.edges, edge);
    const bool isLong = isLongEdge_[toIndex(e)];
    const int fine = samples(isLong, view.first);
    const auto& ends = at(view.part.mesh().edges, edge).vertices;
    own.clear();
    own.add(view.surface, ends[0]);
    for (int step = 1; step < fine; ++step) own.add(view.surface, view.surface.refinement->edgeVertex(edge, step));
    own.add(view.surface, ends[1]);
    const FineSamples fineSamples{own.positions, own.normals};
    if (fine != samples(isLong, false)) {
      if (edgeLevel(fineSamples, 1, look_) > 1) at(flaggedEdges_, e) = 1;
      return;
    }
    std::uint8_t& needed = at(needed_.edges, e);
    if (needed < fine)
      needed = static_cast<std::uint8_t>(edgeLevel(fineSamples, divisorFrom(fine, needed), tolerance_));
  }

  /// The least divisor >= `level` of `fine`.
  static int divisorFrom(int fine, int level) {
    while (fine % level != 0) ++level;
    return level;
  }

  /// @param triangle  of the part
  void fitTriangle(int triangle, const View& view, Gathered& own) {
    const int t = at(view.part.triangles, triangle);
    const bool isLong = isLongTriangle_[toIndex(t)];
    const int fine = samples(isLong, view.first);
    own.clear();
    forEachSample(view.part.mesh(), *view.surface.refinement, triangle, fine,
                  [&](int, int, int vertex) { own.add(view.surface, vertex); });
    const FineSamples fineSamples{own.positions, own.normals};
    if (fine != samples(isLong, false)) {
      if (triangleLevel(fineSamples, fine, 1, look_) > 1) at(flaggedTriangles_, t) = 1;
      return;
    }
    std::uint8_t& needed = at(needed_.triangles, t);
    if (needed < fine) {
      needed = static_cast<std::uint8_t>(triangleLevel(fineSamples, fine, divisorFrom(fine, needed), tolerance_));
    }
  }

  const Preparation& next_;
  const AdaptiveLevels& asked_;
  const ControlMesh& mesh_;
  RefinementLevels& needed_;
  LevelTolerance tolerance_;
  LevelTolerance look_;
  std::vector<bool> isLongTriangle_;  ///< [T]
  std::vector<bool> isLongEdge_;      ///< [E] at such a triangle.
  std::vector<std::uint8_t> flaggedEdges_;
  std::vector<std::uint8_t> flaggedTriangles_;
};

/// Splits sides at least half as finely as the inside, whose triangles end there.
RefinementLevels withSides(const ControlMesh& mesh, RefinementLevels levels) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto half = static_cast<std::uint8_t>(levels.triangles[t] / 2);
    for (const int e : mesh.triangles[t].edges) at(levels.edges, e) = std::max(at(levels.edges, e), half);
  }
  return levels;
}

}  // namespace

std::shared_ptr<const AdaptiveLevels> findLevels(const Preparation& next, std::shared_ptr<const Rig> rig,
                                                 float tolerance, const AdaptiveLevels* former) {
  const ControlMesh& mesh = next.mesh();
  auto out = std::make_shared<AdaptiveLevels>();
  out->moments = former ? former->moments : std::make_shared<const std::vector<Pose>>(detailMoments(next.character()));
  std::vector<Pose> poses = detailPoses(next.character(), *rig, *next.poser, *out->moments);
  out->from = levelSources(next, std::move(rig), tolerance, std::move(poses));
  const std::vector<bool> asked = carriersToLookAt(next, out->from, former ? &former->from : nullptr);
  const auto firstEdge = asked.begin() + static_cast<std::ptrdiff_t>(mesh.positions.size());
  const auto firstTriangle = firstEdge + static_cast<std::ptrdiff_t>(mesh.edges.size());
  std::vector<std::uint8_t> edges(firstEdge, firstTriangle);
  std::vector<std::uint8_t> triangles(firstTriangle, asked.end());
  if (former) out->needed = former->needed;
  out->needed.edges.resize(edges.size());
  out->needed.triangles.resize(triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) out->needed.edges[e] = edges[e] != 0 ? 1 : out->needed.edges[e];
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    out->needed.triangles[t] = triangles[t] != 0 ? 1 : out->needed.triangles[t];
  }
  LevelSearch(next, *out, out->needed).run(std::move(edges), std::move(triangles));
  AlignedSplits splits;
  if (former) {
    out->checked = former->checked;
    splits = former->splits;
  }
  out->checked.resize(mesh.triangles.size());
  splits.triangles.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!*(firstTriangle + static_cast<std::ptrdiff_t>(t))) continue;
    out->checked[t].clear();
    splits.triangles[t] = {};
  }
  const float within = kCheckMargin * tolerance * next.character().height;
  RefinementLevels levels = withSides(mesh, out->needed);
  if (next.layers() && next.layers()->hasCloth()) ClothSplitter(next, levels).run();
  out->levels = levelsThatFit(next, out->from.poses, within, std::move(levels), out->checked);
  out->splits = alignSplits(next, out->from.poses, within, out->levels, std::move(splits));
  return out;
}

}  // namespace sinew
