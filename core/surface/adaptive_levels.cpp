// core/surface/adaptive_levels.cpp: picks poses, samples the surface finely in them and fits flat pieces.
#include "core/surface/adaptive_levels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/character/range_of_motion.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_sides.h"
#include "core/rig/motion_clip.h"
#include "core/rig/posed_rig.h"
#include "core/surface/align_splits.h"
#include "core/surface/patches/levels.h"
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
      if (layers_.carriers[firstEdge + e] != SkinLayer::kCloth) continue;
      raise(mesh_.edges[e].vertices, lengthOf(mesh_, mesh_.edges[e]), levels_.edges[e]);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (layers_.carriers[firstTriangle + t] != SkinLayer::kCloth) continue;
      const ControlTriangle& triangle = mesh_.triangles[t];
      raise(triangle.vertices, longestSide(cornersOf(mesh_, triangle)), levels_.triangles[t]);
    }
  }

 private:
  [[nodiscard]] float pieceUnder(int triangle) const {
    if (triangle < 0) return kNoPiece;
    const int carrier = static_cast<int>(mesh_.positions.size() + mesh_.edges.size()) + triangle;
    if (next_.seen->of(carrier).empty()) return kNoPiece;
    const ControlTriangle& skin = at(mesh_.triangles, triangle);
    int level = at(levels_.triangles, triangle);
    for (const int e : skin.edges) level = std::max<int>(level, at(levels_.edges, e));
    return longestSide(cornersOf(mesh_, skin)) / static_cast<float>(level);
  }

  void raise(std::span<const int> corners, float length, std::uint8_t& level) const {
    float piece = kNoPiece;
    for (const int v : corners) piece = std::min(piece, at(pieces_, v));
    if (!(piece > 0.0f) || piece == kNoPiece) return;
    const float wanted = std::min(std::ceil(length / piece), static_cast<float>(kMaxDepth));
    level = std::max(level, static_cast<std::uint8_t>(wanted));
  }

  const Preparation& next_;
  const MeshLayers& layers_;
  const ControlMesh& mesh_;
  RefinementLevels& levels_;
  std::vector<float> pieces_;  ///< [V] for cloth: length of the skin's pieces under it.
};

/// Samples along a side: each number divides the next.
struct SampleCounts {
  std::uint8_t few;
  std::uint8_t more;
};

// Fractions of H: a few samples miss too much of longer edges.
constexpr float kShortEdge = 0.015f;
constexpr float kMediumEdge = 0.03f;
constexpr float kNormalCosine = 0.99027f;      ///< 8 degrees.
constexpr float kWorthALook = 0.5f;            ///< Misfit from which few samples call for more.
constexpr int kMostPosesOfDense = 4;           ///< In which a triangle of a dense mesh has more samples.
constexpr float kAdaptiveLevelsMargin = 0.7f;  ///< Of the tolerance, since inner points do not lie on samples,
constexpr float kMarginOfDense = 0.65f;        ///< nor all poses among those with more samples.
constexpr float kCheckMargin = 0.9f;           ///< Of the tolerance, for what lies between samples.
constexpr float kSeenPiece = 6.0f;             ///< Tolerances: the normals of shorter pieces count less.

/// Above the default tolerance normals may be off by more, as the chord of an arc that is as far off turns: by the root
/// of the tolerance.
float widened(float cosine, float tolerance) {
  const float times = tolerance / kDefaultTolerance;
  return times > 1.0f ? std::cos(std::sqrt(times) * std::acos(cosine)) : cosine;
}

/// How far one flat piece is off in each pose, in tolerances.
using Misfits = std::array<float, kMostDetailPoses>;

/// Those of the poses with the largest misfits that are worth more samples, or at least one.
PoseSet posesWorthALook(const Misfits& misfits, int most) {
  std::array<std::size_t, kMostDetailPoses> order{};
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t pose) { return misfits[pose]; });
  PoseSet out = static_cast<PoseSet>(1 << order.front());
  for (const std::size_t pose : std::span(order).first(toIndex(most))) {
    if (misfits[pose] > kWorthALook) out = static_cast<PoseSet>(out | 1 << pose);
  }
  return out;
}

/// Fits levels to samples of each triangle: few in all poses, more in those in which the few are off. The result for
/// each depends on itself alone.
class LevelSearch {
 public:
  LevelSearch(const Preparation& next, const LevelSources& from, SampledSurface& surface)
      : next_(next), from_(from), mesh_(next.mesh()), surface_(surface), isDense_(mesh_.triangles.size() > kDenseMesh) {
    const float height = next.character().height;
    const float margin = isDense_ ? kMarginOfDense : kAdaptiveLevelsMargin;
    tolerance_ = {margin * from.tolerance * height, widened(kNormalCosine, from.tolerance),
                  kSeenPiece * from.tolerance * height};
    for (const ControlTriangle& triangle : mesh_.triangles) {
      longest_.push_back(longestSide(cornersOf(mesh_, triangle)) / height);
    }
  }

  /// @param asked [T]  @param needed [T] set for these
  void run(const std::vector<std::uint8_t>& asked, std::vector<SplitLevels>& needed) {
    const std::vector<std::uint8_t> more = look(asked);
    surface_.sample(more);
    forEachIndex(asked.size(), kFewFitted, [&](std::size_t t) {
      if (asked[t] == 0) return;
      needed[t] = more[t] != 0 ? fitted(t) : SplitLevels{};
      if (needed[t] == SplitLevels{}) surface_.forget(t);
    });
  }

 private:
  static constexpr std::size_t kFewFitted = 256;  ///< Triangles for one thread.

  /// Takes a few samples of each triangle.  @return [T] how many more to take; 0: none
  std::vector<std::uint8_t> look(const std::vector<std::uint8_t>& asked) {
    std::vector<std::uint8_t> few(asked.size(), 0);
    std::vector<std::uint8_t> more(asked.size(), 0);
    for (std::size_t t = 0; t < asked.size(); ++t) {
      if (asked[t] == 0) continue;
      const SampleCounts counts = countsOf(t);
      few[t] = counts.few;
      more[t] = counts.more;
    }
    std::vector<Misfits> misfits(asked.size(), Misfits{});
    const std::vector<PoseSet> all(asked.size(), static_cast<PoseSet>(~0U));
    sampleTriangles(next_, from_.poses, {few, all}, [&](int t, std::size_t pose, const FineSamples& own) {
      at(misfits, t)[pose] = misfitOf(own, at(few, t));
    });
    for (std::size_t t = 0; t < asked.size(); ++t) {
      if (asked[t] == 0) continue;
      surface_.setPoses(t, posesWorthALook(misfits[t], isDense_ ? kMostPosesOfDense : kMostDetailPoses));
      if (!(std::ranges::max(misfits[t]) > kWorthALook)) more[t] = 0;
    }
    return more;
  }

  [[nodiscard]] SampleCounts countsOf(std::size_t triangle) const {
    if (longest_[triangle] <= kShortEdge) return {2, 6};
    return isDense_ && longest_[triangle] <= kMediumEdge ? SampleCounts{3, 6} : SampleCounts{6, 12};
  }

  [[nodiscard]] float misfitOf(const FineSamples& samples, int fine) const {
    float most = triangleMisfit(samples, fine, tolerance_);
    for (std::size_t side = 0; side < 3; ++side) {
      most = std::max(most, edgeMisfit(SideSamples(samples, fine, side).samples(), tolerance_));
    }
    return most;
  }

  /// The least levels at which its samples fit.
  [[nodiscard]] SplitLevels fitted(std::size_t t) const {
    const TriangleSamples& all = surface_.of(static_cast<int>(t));
    SplitLevels needed;
    for (int nth = 0; nth < std::popcount(surface_.posesOf()[t]); ++nth) {
      const FineSamples own = all.of(toIndex(nth));
      if (needed.inside < all.fine) {
        needed.inside = triangleLevel(own, all.fine, divisorFrom(all.fine, needed.inside), tolerance_);
      }
      for (std::size_t side = 0; side < 3; ++side) {
        int& level = needed.sides[side];
        if (level >= all.fine) continue;
        level = edgeLevel(SideSamples(own, all.fine, side).samples(), divisorFrom(all.fine, level), tolerance_);
      }
    }
    return needed;
  }

  /// The least divisor >= `level` of `fine`.
  static int divisorFrom(int fine, int level) {
    while (fine % level != 0) ++level;
    return level;
  }

  const Preparation& next_;
  const LevelSources& from_;
  const ControlMesh& mesh_;
  SampledSurface& surface_;
  bool isDense_;
  LevelTolerance tolerance_;
  std::vector<float> longest_;  ///< [T] edge, fraction of H.
};

RefinementLevels levelsFor(const ControlMesh& mesh, const std::vector<SplitLevels>& needed) {
  RefinementLevels out{std::vector<std::uint8_t>(mesh.edges.size(), 1), {}};
  for (std::size_t t = 0; t < needed.size(); ++t) {
    out.triangles.push_back(static_cast<std::uint8_t>(needed[t].inside));
    for (std::size_t side = 0; side < 3; ++side) {
      std::uint8_t& level = at(out.edges, mesh.triangles[t].edges[side]);
      level = std::max(level, static_cast<std::uint8_t>(needed[t].sides[side]));
    }
  }
  return out;
}

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
  const std::vector<bool> carriers = carriersToLookAt(next, out->from, former ? &former->from : nullptr);
  const auto firstTriangle = carriers.end() - static_cast<std::ptrdiff_t>(mesh.triangles.size());
  const std::vector<std::uint8_t> asked(firstTriangle, carriers.end());
  AlignedSplits splits;
  std::vector<PoseSet> posesOf;
  if (former) {
    out->needed = former->needed;
    out->checked = former->checked;
    posesOf = former->posesOf;
    splits = former->splits;
  }
  posesOf.resize(asked.size());
  out->needed.resize(asked.size());
  out->checked.resize(asked.size());
  splits.triangles.resize(asked.size());
  for (std::size_t t = 0; t < asked.size(); ++t) {
    if (asked[t] == 0) continue;
    out->checked[t].clear();
    splits.triangles[t] = {};
  }
  SampledSurface surface(next, out->from.poses, std::move(posesOf));
  LevelSearch(next, out->from, surface).run(asked, out->needed);
  const float within = kCheckMargin * tolerance * next.character().height;
  RefinementLevels levels = withSides(mesh, levelsFor(mesh, out->needed));
  if (next.layers() && next.layers()->hasCloth()) ClothSplitter(next, levels).run();
  out->levels = levelsThatFit(next, surface, within, std::move(levels), out->checked);
  out->splits = alignSplits(mesh, surface, within, out->levels, std::move(splits));
  out->posesOf = surface.posesOf();
  return out;
}

}  // namespace sinew
