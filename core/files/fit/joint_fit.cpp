// core/files/fit/joint_fit.cpp: candidates, the sample, then weights and added joints.
#include "core/files/fit/joint_fit.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/geometry/parallel.h"
#include "core/rig/attachment.h"

namespace sinew::exporting {

// Candidates.

namespace {

/// The control mesh with other influences. @param shares  [V]
ControlMesh following(const ControlMesh& mesh, const std::vector<std::vector<Share>>& shares) {
  ControlMesh result;
  result.positions = mesh.positions;
  result.edges = mesh.edges;
  result.triangles = mesh.triangles;
  result.influenceBegin.push_back(0);
  for (const std::vector<Share>& list : shares) {
    for (const Share& share : list) result.influences.push_back({share.binding, static_cast<float>(share.weight)});
    result.influenceBegin.push_back(static_cast<int>(result.influences.size()));
  }
  return result;
}

/// [V] summed weights of the neighbors of each control vertex.
std::vector<std::vector<Share>> ringShares(const ControlMesh& mesh) {
  std::vector<std::vector<Share>> result(mesh.positions.size());
  for (const Edge& edge : mesh.edges) {
    for (const int end : {0, 1}) {
      for (const Influence& influence : mesh.influencesOf(edge.vertices[toIndex(1 - end)])) {
        addShare(at(result, at(edge.vertices, end)), influence.binding, static_cast<double>(influence.weight));
      }
    }
  }
  return result;
}

/// [V] bones of the muscles that reach each control vertex, weighted by nearness.
std::vector<std::vector<Share>> muscleShares(const Character& character, const Rig& rig, const Attachment& attachment) {
  const Skeleton& skeleton = character.skeleton;
  std::vector<std::vector<Share>> result(character.mesh.positions.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    for (const Candidate& candidate : attachment.candidatesOfVertex[v]) {
      const Primitive& primitive = at(rig.primitives, at(attachment.rigIndex, candidate.primitive));
      const int bone = at(attachment.primitives, candidate.primitive).bone;
      const glm::vec3 center(at(skeleton.bones, bone).bindInWorld * glm::vec4(primitive.placement.center, 1.0f));
      const glm::vec3& radii = primitive.placement.radii;
      const float reach = primitive.reach * std::max({radii.x, radii.y, radii.z});
      const float distance = glm::length(character.mesh.positions[v] - center);
      if (!(distance < reach)) continue;
      const double nearness = 1.0 - static_cast<double>(distance / reach);
      addShare(result[v], bone, nearness);
      const MuscleLine* line = lineOf(rig, primitive);
      if (!line) continue;
      for (const LineAnchor* anchor : {&line->origin, &line->insertion}) {
        if (const auto end = skeleton.findBone(anchor->bone)) addShare(result[v], *end, nearness);
      }
    }
  }
  return result;
}

std::vector<Share> largestFirst(std::vector<Share> shares) {
  std::ranges::stable_sort(shares, std::ranges::greater{}, &Share::weight);
  return shares;
}

/// Builds the list of a vertex.
class Candidates {
 public:
  void add(int binding) {
    if (list_.size() < kMostCandidates && std::ranges::find(list_, binding) == list_.end()) list_.push_back(binding);
  }
  void addAll(const std::vector<Share>& shares, std::size_t most) {
    for (std::size_t i = 0; i < std::min(most, shares.size()); ++i) add(shares[i].binding);
  }
  /// Bones by distance in the skeleton, until the list is full.
  void addNearest(const Skeleton& skeleton, int from, const std::vector<bool>& wanted) {
    std::vector<int> reached{from};
    std::vector<bool> seen(skeleton.bones.size(), false);
    at(seen, from) = true;
    for (std::size_t i = 0; i < reached.size() && list_.size() < kMostCandidates; ++i) {
      const Bone& bone = at(skeleton.bones, reached[i]);
      if (at(wanted, reached[i])) add(reached[i]);
      const auto reach = [&](int next) {
        if (next < 0 || at(seen, next)) return;
        at(seen, next) = true;
        reached.push_back(next);
      };
      reach(bone.parent);
      for (const int child : bone.children) reach(child);
    }
  }
  std::vector<int> take() && { return std::move(list_); }

 private:
  std::vector<int> list_;
};

constexpr std::size_t kMostMuscleBones = 4;

}  // namespace

Result<std::vector<std::vector<int>>> weightCandidates(const Character& character, const Rig& rig,
                                                       const Refinement& refinement,
                                                       const std::vector<std::vector<Share>>& own) {
  const Result<Attachment> attachment = attach(rig, character);
  if (!attachment) return attachment.error();
  const ControlMesh& mesh = character.mesh;
  const auto ring = interpolatedWeights(following(mesh, ringShares(mesh)), refinement);
  const auto muscles =
      interpolatedWeights(following(mesh, muscleShares(character, rig, attachment.value())), refinement);
  const std::vector<bool> carriesSkin = bonesWithSkin(character);
  std::vector<std::vector<int>> result;
  result.reserve(own.size());
  for (std::size_t v = 0; v < own.size(); ++v) {
    Candidates candidates;
    const std::vector<Share> mine = largestFirst(own[v]);
    candidates.addAll(mine, kMostCandidates);
    candidates.addAll(largestFirst(muscles[v]), kMostMuscleBones);
    candidates.addAll(largestFirst(ring[v]), kMostCandidates);
    candidates.addNearest(character.skeleton, at(character.skeleton.bindings, mine.front().binding).bone, carriesSkin);
    result.push_back(std::move(candidates).take());
  }
  return result;
}

// The sample.

namespace {

constexpr int kMortonBits = 20;   ///< Along each axis.
constexpr double kOwnVote = 2.0;  ///< Weight of a cell's own weights; those of neighbors count 1.

/// Neighbors along edges.
struct Neighbors {
  std::vector<std::size_t> begin;  ///< [count+1]
  std::vector<int> others;         ///< Some twice.

  Neighbors(std::size_t count, std::span<const std::array<int, 3>> triangles) : begin(count + 1, 0) {
    const auto forEachEnd = [&](const auto& use) {
      for (const std::array<int, 3>& triangle : triangles) {
        if (std::ranges::any_of(triangle, [&](int corner) { return toIndex(corner) >= count; })) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          use(triangle[i], triangle[(i + 1) % 3]);
          use(triangle[(i + 1) % 3], triangle[i]);
        }
      }
    };
    forEachEnd([&](int from, int) { ++begin[toIndex(from) + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    others.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    forEachEnd([&](int from, int to) { others[next[toIndex(from)]++] = to; });
  }

  [[nodiscard]] std::span<const int> of(int vertex) const {
    return std::span(others).subspan(at(begin, vertex), at(begin, vertex + 1) - at(begin, vertex));
  }
};

/// Interleaves the bits of three numbers.
std::uint64_t interleaved(const std::array<std::uint64_t, 3>& numbers) {
  std::uint64_t code = 0;
  for (int bit = kMortonBits - 1; bit >= 0; --bit) {
    for (const std::uint64_t number : numbers) code = (code << 1U) | ((number >> static_cast<unsigned>(bit)) & 1U);
  }
  return code;
}

/// Vertices along a Morton curve: neighbors in the order are near in space.
std::vector<int> mortonOrder(std::span<const glm::vec3> points) {
  glm::dvec3 low(points.front());
  glm::dvec3 high(low);
  for (const glm::vec3& point : points) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double steps = side > 0.0 ? static_cast<double>((1U << kMortonBits) - 1U) / side : 0.0;
  std::vector<std::pair<std::uint64_t, int>> order;
  order.reserve(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const glm::dvec3 place = (glm::dvec3(points[v]) - low) * steps;
    const std::array<std::uint64_t, 3> numbers{static_cast<std::uint64_t>(place.x), static_cast<std::uint64_t>(place.y),
                                               static_cast<std::uint64_t>(place.z)};
    order.emplace_back(interleaved(numbers), static_cast<int>(v));
  }
  std::ranges::sort(order);
  std::vector<int> result;
  result.reserve(order.size());
  for (const auto& [code, vertex] : order) result.push_back(vertex);
  return result;
}

/// Assigns every vertex reachable from `queue` the cell of the nearest one in it.
void flood(const Neighbors& neighbors, std::vector<int> queue, std::vector<int>& cell) {
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const int other : neighbors.of(queue[i])) {
      if (at(cell, other) >= 0) continue;
      at(cell, other) = at(cell, queue[i]);
      queue.push_back(other);
    }
  }
}

std::vector<int> chosen(std::span<const glm::vec3> rest, const Neighbors& neighbors, std::size_t most) {
  const std::vector<int> order = mortonOrder(rest);
  std::vector<int> cell(rest.size(), -1);
  std::vector<int> vertices;
  for (std::size_t i = 0; i < most; ++i) {
    const std::size_t begin = i * order.size() / most;
    const std::size_t end = (i + 1) * order.size() / most;
    vertices.push_back(order[(begin + end) / 2]);
    at(cell, vertices.back()) = 0;
  }
  flood(neighbors, vertices, cell);
  for (int v = 0; v < static_cast<int>(cell.size()); ++v) {
    if (at(cell, v) >= 0) continue;
    at(cell, v) = 0;
    vertices.push_back(v);
    flood(neighbors, {v}, cell);
  }
  std::ranges::sort(vertices);
  return vertices;
}

void vote(const FourWeights& weights, double by, std::vector<Share>& votes) {
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    addShare(votes, weights.binding[i], by * static_cast<double>(weights.weight[i]));
  }
}

}  // namespace

FitSample sampleVertices(std::span<const glm::vec3> rest, std::span<const std::array<int, 3>> triangles,
                         std::size_t most) {
  FitSample sample;
  if (rest.size() <= most) {
    sample.vertices.resize(rest.size());
    std::iota(sample.vertices.begin(), sample.vertices.end(), 0);
    sample.cell = sample.vertices;
    sample.triangles.assign(triangles.begin(), triangles.end());
    return sample;
  }
  const Neighbors neighbors(rest.size(), triangles);
  sample.vertices = chosen(rest, neighbors, most);
  sample.cell.assign(rest.size(), -1);
  for (std::size_t i = 0; i < sample.vertices.size(); ++i) at(sample.cell, sample.vertices[i]) = static_cast<int>(i);
  flood(neighbors, sample.vertices, sample.cell);
  for (const std::array<int, 3>& triangle : triangles) {
    if (std::ranges::any_of(triangle, [&](int corner) { return toIndex(corner) >= rest.size(); })) continue;
    const int a = at(sample.cell, triangle[0]);
    const int b = at(sample.cell, triangle[1]);
    const int c = at(sample.cell, triangle[2]);
    if (a != b && b != c && c != a) sample.triangles.push_back({a, b, c});
  }
  return sample;
}

std::vector<std::vector<int>> candidatesNear(const FitSample& sample, std::span<const FourWeights> weights,
                                             std::span<const FourWeights> own) {
  const Neighbors neighbors(weights.size(), sample.triangles);
  std::vector<std::vector<int>> followed;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    std::vector<Share> votes;
    vote(weights[i], kOwnVote, votes);
    for (const int other : neighbors.of(static_cast<int>(i))) vote(weights[toIndex(other)], 1.0, votes);
    std::ranges::stable_sort(votes, std::ranges::greater{}, &Share::weight);
    std::vector<int>& list = followed.emplace_back();
    for (const Share& share : votes) list.push_back(share.binding);
  }
  std::vector<std::vector<int>> result;
  result.reserve(own.size());
  for (std::size_t v = 0; v < own.size(); ++v) {
    std::vector<int>& list = result.emplace_back();
    for (std::size_t i = 0; i < kMostWeights && own[v].binding[i] >= 0; ++i) list.push_back(own[v].binding[i]);
    for (const int binding : at(followed, sample.cell[v])) {
      if (list.size() >= kMostNear) break;
      if (std::ranges::find(list, binding) == list.end()) list.push_back(binding);
    }
  }
  return result;
}

// The fit.

namespace {

/// Weight of the range of motion relative to all clips: its poses may never occur in clips.
constexpr double kShareOfFurther = 0.25;
constexpr double kNearEnough = 1e-5;                ///< Fraction of the height: vertices this near are not fitted.
constexpr int kRoundsInPose = 6;                    ///< Rounds of moving one helper after the other in a pose.
constexpr std::size_t kMostFitted = 8'000;          ///< Vertices for fitting joints; of more, a sample of this size.
constexpr std::size_t kMostFitPoints = 20'000'000;  ///< Points of live surfaces in memory: 240 MB.
constexpr std::size_t kMostFurtherPoses = 100;      ///< Poses of the range of motion for fitting helpers.
constexpr std::size_t kMostWeighed = 150;           ///< Poses of clips for fitting all vertices after a sample.

/// Approximate fraction of the work for each stage.
struct StageShares {
  double gathering = 0.2;
  double solving = 0.5;
  double helping = 0.0;
  double weighing = 0.0;  ///< Twice: poses, then weights.
  double measuring = 0.3;
};

StageShares sharesOf(ExportJoints joints, bool isWhole) {
  if (joints == ExportJoints::kOwn) return isWhole ? StageShares{} : StageShares{0.2, 0.05, 0.0, 0.2, 0.35};
  return isWhole ? StageShares{0.08, 0.1, 0.72, 0.0, 0.1} : StageShares{0.15, 0.02, 0.28, 0.15, 0.25};
}

bool isFitted(const ExportPose& pose) { return pose.use == PoseUse::kFitted; }

}  // namespace

JointFit::JointFit(std::shared_ptr<const Character> character, const Character& moving, const Rig& rig,
                   const SkinnedExportSettings& settings, const ExportProgress& progress)
    : character_(std::move(character)),
      moving_(moving),
      rig_(rig),
      settings_(settings),
      still_(rig),
      progress_(progress),
      surfaces_(character_) {
  still_.morphs.clear();
}

Result<void> JointFit::findWeights() {
  if (const auto prepared = surfaces_.prepare(still_); !prepared) return prepared;
  surfaces_.smooth(withoutMorphs(*character_, bindPose(character_->skeleton)), bind_);
  const Refinement& refinement = *bind_.refinement;
  const bool refined = settings_.mesh == ExportMesh::kRefined;
  count_ = toIndex(refined ? refinement.vertexCount : refinement.controlVertices);
  choosePoses();
  if (settings_.morphs && !character_->morphTargets.empty()) findMorphs();
  if (settings_.joints == ExportJoints::kHelpers) layLines();
  std::vector<std::vector<Share>> shares = interpolatedWeights(character_->mesh, refinement);
  for (std::size_t v = 0; v < count_; ++v) weights_.push_back(fourLargest(shares[v]));
  if (settings_.weights == ExportWeights::kTransferred && settings_.joints == ExportJoints::kOwn) return {};
  auto candidates = weightCandidates(*character_, rig_, refinement, shares);
  if (!candidates) return candidates.error();
  fitSample(candidates.value());
  if (sample_.isWhole()) weights_ = sampleWeights_;
  // Helpers are known on the sample only; without helpers the candidates are complete.
  else if (settings_.joints == ExportJoints::kOwn) weighAll(std::move(candidates).value());
  else weighAll(candidatesNear(sample_, sampleWeights_, weights_));
  return {};
}

void JointFit::choosePoses() {
  const int own = static_cast<int>(character_->clips.size());
  std::vector<int> further;
  for (int clip = 0; clip < static_cast<int>(moving_.clips.size()); ++clip) {
    const bool asked = settings_.clips.empty() || std::ranges::count(settings_.clips, at(moving_.clips, clip).name);
    if (clip >= own) further.push_back(clip);
    else if (asked) clips_.push_back(clip);
  }
  poses_ = exportPoses(moving_, clips_, further);
}

void JointFit::findMorphs() {
  morphs_.targets = settings_.mesh == ExportMesh::kRefined ? refinedTargets(*character_, surfaces_, bind_)
                                                           : originalTargets(*character_);
  std::vector<ExportPose> own;
  std::ranges::copy_if(poses_, std::back_inserter(own), [this](const ExportPose& pose) { return isOwn(pose); });
  setMorphKeys(*character_, rig_, own, morphs_);
}

void JointFit::layLines() {
  std::vector<Pose> moments;
  for (const ExportPose& pose : poses_)
    moments.push_back(samplePose(*character_, at(moving_.clips, pose.clip), pose.time));
  lines_ = LineJoints(rig_, *character_, settings_.jointScale, moments);
}

/// A predicate for all poses in order: fitted poses, thinned to every second, third ... if there are too many.
/// @param mostOwn  of clips; for the range of motion at most kMostFurtherPoses
std::function<bool(const ExportPose&)> JointFit::someFitted(std::size_t mostOwn) const {
  std::array<std::size_t, 2> count{};
  for (const ExportPose& pose : poses_) {
    if (isFitted(pose)) ++count[isOwn(pose) ? 0 : 1];
  }
  const std::array most{mostOwn, std::min(kMostFurtherPoses, mostOwn)};
  std::array<std::size_t, 2> step{};
  for (const std::size_t kind : {0U, 1U}) step[kind] = (count[kind] + most[kind] - 1) / most[kind];
  return [this, step, seen = std::array<std::size_t, 2>{}](const ExportPose& pose) mutable {
    const std::size_t kind = isOwn(pose) ? 0 : 1;
    return isFitted(pose) && seen[kind]++ % step[kind] == 0;
  };
}

/// Finds joints, and weights of the sample.
void JointFit::fitSample(const std::vector<std::vector<int>>& candidates) {
  sample_ = sampleVertices(restOfAll(), trianglesOfFit(), kMostFitted);
  std::vector<std::vector<int>> own;
  for (const int v : sample_.vertices) {
    own.push_back(at(candidates, v));
    sampleRest_.push_back(at(bind_.positions, v));
    sampleWeights_.push_back(at(weights_, v));
  }
  const bool helps = settings_.joints == ExportJoints::kHelpers;
  const StageShares shares = sharesOf(settings_.joints, sample_.isWhole());
  const std::size_t most = std::max<std::size_t>(kMostFitPoints / std::max<std::size_t>(count_, 1), 1);
  auto isHeld = someFitted(sample_.isWhole() ? most : kMostFitPoints / sample_.vertices.size());
  std::vector<FitPose> poses;
  WeightFit fit(sampleRest_, std::move(own), sampleWeights_);
  progress_.begin(shares.gathering);
  const auto add = [&](const ExportPose& pose, const Pose& moment) {
    fit.add(matrices_, sampleLive_, !isOwn(pose));
    if (helps && (!sample_.isWhole() || isHeld(pose))) poses.push_back({moment, matrices_, sampleLive_, !isOwn(pose)});
  };
  if (sample_.isWhole()) forEachPose(isFitted, add);
  else forEachPose(isHeld, add);
  progress_.begin(shares.solving);
  const double near = kNearEnough * static_cast<double>(character_->height);
  sampleWeights_ = fit.solve(sample_.triangles, furtherShare(), near, progress_);
  if (helps) addHelpers(poses);
}

void JointFit::addHelpers(const std::vector<FitPose>& poses) {
  const HelperTask task{character_->skeleton,
                        sampleRest_,
                        sample_.triangles,
                        poses,
                        lines_.joints(),
                        furtherShare(),
                        static_cast<double>(character_->height)};
  progress_.begin(sharesOf(settings_.joints, sample_.isWhole()).helping);
  HelperResult result = fitHelpers(task, std::move(sampleWeights_), settings_.helpers, progress_);
  sampleWeights_ = std::move(result.weights);
  rigid_ = std::move(result.helpers);
  lines_.keep(result.keptLines);
}

/// Fits the weights of every vertex in the poses of the keys.
void JointFit::weighAll(std::vector<std::vector<int>> candidates) {
  const StageShares shares = sharesOf(settings_.joints, false);
  WeightFit fit(restOfAll(), std::move(candidates), weights_);
  const HelperMotion motion(character_->skeleton, sampleRest_, sampleWeights_, rigid_, firstRigid());
  progress_.begin(shares.weighing);
  // Without helpers weights must not be worse than the file's over all poses.
  const auto isMeant = settings_.joints == ExportJoints::kOwn ? std::function<bool(const ExportPose&)>(isFitted)
                                                              : someFitted(kMostWeighed);
  forEachPose(isMeant, [&](const ExportPose& pose, const Pose& moment) {
    moveHelpers(moment, isOwn(pose), motion);
    fit.add(matrices_, live_->positions, !isOwn(pose));
  });
  progress_.begin(shares.weighing);
  const double near = kNearEnough * static_cast<double>(character_->height);
  weights_ = fit.solve(trianglesOfFit(), furtherShare(), near, progress_);
  for (std::size_t i = 0; i < sample_.vertices.size(); ++i) sampleWeights_[i] = at(weights_, sample_.vertices[i]);
  rigidLocals_.clear();
}

/// Fits the rigid helpers to the live surface where the pose has keys; else they rest.
void JointFit::moveHelpers(const Pose& moment, bool isKeyed, const HelperMotion& motion) {
  if (!isKeyed || rigidLocals_.size() != rigid_.size()) {
    rigidLocals_.clear();
    for (const HelperJoint& joint : rigid_) rigidLocals_.push_back(joint.rest);
  }
  if (isKeyed) motion.solve(moment, matrices_, sampleLive_, kRoundsInPose, rigidLocals_);
  for (std::size_t j = 0; j < rigid_.size(); ++j) {
    matrices_.push_back(helperMatrix(rigid_[j], moment, rigidLocals_[j]));
  }
}

std::vector<HelperJoint> JointFit::helpers() const {
  std::vector<HelperJoint> all = lines_.joints();
  all.insert(all.end(), rigid_.begin(), rigid_.end());
  return all;
}

bool JointFit::isOwn(const ExportPose& pose) const { return toIndex(pose.clip) < character_->clips.size(); }

double JointFit::measuringShare() const { return sharesOf(settings_.joints, sample_.isWhole()).measuring; }

int JointFit::firstRigid() const {
  return static_cast<int>(character_->skeleton.bindings.size() + lines_.joints().size());
}

/// Weight of a further pose; a pose of an exported clip counts 1.
double JointFit::furtherShare() const {
  const auto fitted = [](const ExportPose& pose) { return isFitted(pose); };
  const auto all = std::ranges::count_if(poses_, fitted);
  const auto own = std::ranges::count_if(poses_, [&](const ExportPose& pose) { return fitted(pose) && isOwn(pose); });
  if (own == 0 || own == all) return 1.0;
  return std::min(1.0, kShareOfFurther * static_cast<double>(own) / static_cast<double>(all - own));
}

std::vector<std::array<int, 3>> JointFit::trianglesOfFit() const {
  if (settings_.mesh == ExportMesh::kRefined) return bind_.refinement->triangles;
  std::vector<std::array<int, 3>> triangles;
  for (const ControlTriangle& triangle : character_->mesh.triangles) triangles.push_back(triangle.vertices);
  return triangles;
}

std::vector<glm::vec3> JointFit::restOfAll() const {
  return {bind_.positions.begin(), bind_.positions.begin() + static_cast<std::ptrdiff_t>(count_)};
}

}  // namespace sinew::exporting
