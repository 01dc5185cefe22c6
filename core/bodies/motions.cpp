// core/bodies/motions.cpp: samples clips and skins single vertices.
#include "core/bodies/motions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_tree.h"
#include "core/rig/line_edit.h"
#include "core/rig/motion_clip.h"

namespace sinew {

namespace {

constexpr float kFaces = 0.2f;  ///< Cosine from which a triangle faces outwards.
constexpr float kLeastWeight = 0.1f;
constexpr std::size_t kMostBones = 4;
constexpr int kRun = 32;  ///< Triangles.

using Corners = TriangleCorners;

/// Lower bound of the squared distance to anything in the box, with a margin for rounding.
float leastFrom(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 off = glm::max(glm::max(low - p, p - high), glm::vec3(0.0f));
  return 0.999f * glm::dot(off, off);
}

glm::vec3 lowOf(const Corners& c) { return glm::min(c[0], glm::min(c[1], c[2])); }
glm::vec3 highOf(const Corners& c) { return glm::max(c[0], glm::max(c[1], c[2])); }

/// The nearest place so far, on any skin and on skin that faces outwards.
struct Nearest {
  std::optional<SkinSpot> any;
  std::optional<SkinSpot> facing;
  float least = std::numeric_limits<float>::max();
  float leastFacing = std::numeric_limits<float>::max();

  void look(const Corners& corners, int triangle, const glm::vec3& point, const glm::vec3& outwards) {
    const glm::vec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float area = glm::length(face);
    if (!(area > 0.0f)) return;
    const glm::vec3 shares = nearestOnTriangle(point, corners);
    const glm::vec3 off = point - mixed(corners, shares);
    const float squared = glm::dot(off, off);
    if (squared < least) {
      least = squared;
      any = SkinSpot{triangle, shares};
    }
    if (squared < leastFacing && glm::dot(face, outwards) > kFaces * area) {
      leastFacing = squared;
      facing = SkinSpot{triangle, shares};
    }
  }
};

}  // namespace

SkinRuns::SkinRuns(const ControlMesh& mesh) : mesh_(&mesh) {
  const int count = static_cast<int>(mesh.triangles.size());
  for (int begin = 0; begin < count; begin += kRun) {
    const Corners first = controlCorners(mesh, begin);
    Run run{begin, std::min(begin + kRun, count), lowOf(first), highOf(first)};
    for (int t = begin + 1; t < run.end; ++t) {
      const Corners corners = controlCorners(mesh, t);
      run.low = glm::min(run.low, lowOf(corners));
      run.high = glm::max(run.high, highOf(corners));
    }
    runs_.push_back(run);
  }
}

std::optional<SkinSpot> spotOver(const SkinRuns& skin, const glm::vec3& point, const glm::vec3& outwards) {
  Nearest nearest;
  for (const SkinRuns::Run& run : skin.runs()) {
    if (leastFrom(point, run.low, run.high) > nearest.leastFacing) continue;
    for (int t = run.begin; t < run.end; ++t) {
      const Corners corners = controlCorners(skin.mesh(), t);
      if (leastFrom(point, lowOf(corners), highOf(corners)) > nearest.leastFacing) continue;
      nearest.look(corners, t, point, outwards);
    }
  }
  return nearest.facing ? nearest.facing : nearest.any;
}

glm::vec3 skinnedVertex(const Character& character, int vertex, const Pose& pose) {
  return glm::vec3(skinMatrix(character, pose, vertex) * glm::vec4(at(character.mesh.positions, vertex), 1.0f));
}

std::optional<SkinFrame> frameAt(const Character& character, const SkinSpot& spot, const Pose& pose) {
  Corners corners;
  for (std::size_t c = 0; c < 3; ++c) {
    corners[c] = skinnedVertex(character, at(character.mesh.triangles, spot.triangle).vertices[c], pose);
  }
  const glm::vec3 along = corners[1] - corners[0];
  const glm::vec3 face = glm::cross(along, corners[2] - corners[0]);
  const float length = glm::length(along);
  const float area = glm::length(face);
  if (!(length > 0.0f) || !(area > 0.0f)) return std::nullopt;
  const glm::vec3 x = along / length;
  const glm::vec3 normal = face / area;
  return SkinFrame{mixed(corners, spot.shares), glm::mat3(x, glm::cross(normal, x), normal)};
}

std::vector<int> bonesAt(const Character& character, const SkinSpot& spot) {
  std::map<int, float> weights;
  const auto& vertices = at(character.mesh.triangles, spot.triangle).vertices;
  for (int c = 0; c < 3; ++c) {
    for (const WeightedBinding& follows : bindingsOf(character, at(vertices, c))) {
      weights[follows.bone()] += spot.shares[c] * follows.weight;
    }
  }
  std::vector<std::pair<int, float>> sorted(weights.begin(), weights.end());
  std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<int, float>::second);
  std::vector<int> bones;
  for (const auto& [bone, weight] : sorted) {
    if (weight >= kLeastWeight && bones.size() < kMostBones) bones.push_back(bone);
  }
  return bones;
}

Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character) {
  std::vector<LineRest> rests;
  std::vector<int> lines;
  for (std::size_t i = first; i < rig.lines.size(); ++i) {
    auto rest = lineRest(rig.lines[i], character);
    if (!rest) continue;
    rests.push_back(std::move(rest).value());
    lines.push_back(static_cast<int>(i));
  }
  std::vector<LineLengths> lengths = lengthsOver(rests, character, character.clips);
  const std::vector<LineLengths> own = lengths;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int twin = findLine(rig, at(rig.lines, lines[i]).mirror);
    const auto other = std::ranges::find(lines, twin);
    if (twin < 0 || other == lines.end()) continue;
    const LineLengths& theirs = own[static_cast<std::size_t>(other - lines.begin())];
    lengths[i].least = std::min(lengths[i].least, theirs.least);
    lengths[i].secondPercentile = std::min(lengths[i].secondPercentile, theirs.secondPercentile);
    lengths[i].most = std::max(lengths[i].most, theirs.most);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // Fails if the line never shortens.
    if (auto learned = withLearned(rig, lines[i], lengths[i])) rig = std::move(learned).value().rig;
  }
  return rig;
}

Motions::Motions(std::shared_ptr<const Character> given)
    : character_(withRangeOfMotion(std::move(given))), skin_(character_->mesh) {
  constexpr double kMostPoses = 6'000.0;
  const std::vector<ClipTime> times = sampleTimes(character_->clips, kMostPoses);
  poses_.resize(times.size());
  forEachIndex(times.size(), 16,
               [&](std::size_t i) { poses_[i] = samplePose(character_->skeleton, *times[i].clip, times[i].time); });
}

std::vector<std::optional<SkinFrame>> Motions::framesOf(std::span<const SkinSpot> spots) const {
  std::vector<std::optional<SkinFrame>> out(poses_.size() * spots.size());
  forEachIndex(poses_.size(), 32, [&](std::size_t i) {
    for (std::size_t s = 0; s < spots.size(); ++s) {
      out[i * spots.size() + s] = frameAt(*character_, spots[s], poses_[i]);
    }
  });
  return out;
}

std::vector<glm::vec3> Motions::placesOf(int vertex) const {
  std::vector<glm::vec3> out;
  for (const Pose& pose : poses_) out.push_back(skinnedVertex(*character_, vertex, pose));
  return out;
}

void learnFull(MuscleLine& line, const Motions& motions) {
  const auto rest = lineRest(line, motions.character());
  if (!rest) return;
  const LineLengths lengths = lengthsOver(rest.value(), motions.character().skeleton, motions.poses());
  if (lengths.poses > 0 && lengths.secondPercentile < kMostFull) {
    line.settings.full = std::max(lengths.secondPercentile, kLeastFull);
  }
}

}  // namespace sinew
