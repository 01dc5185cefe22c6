// tests/support/surface/pops.cpp: surfaces at ever closer moments around what steps far.
#include "tests/support/surface/pops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/motion.h"
#include "tests/support/surface/projected.h"
#include "tests/support/surface/visible_backs.h"

namespace sinew::test {
namespace {

constexpr int kTenths = 10;
constexpr int kFrameTicks = 640;  ///< Ticks of 26 microseconds.
constexpr int kLookedAt = 15;
constexpr int kPixels = 700;
constexpr double kTick = 1.0 / (60.0 * kFrameTicks);

using Offsets = std::vector<glm::vec3>;

/// A moment and where it finds the skin.
struct Moment {
  int tick = 0;
  Offsets offsets;  ///< From the patch, in the patch's own frame.
  Offsets inWorld;  ///< The same in the world's.
};

Offsets between(const std::vector<glm::vec3>& from, const std::vector<glm::vec3>& to) {
  Offsets out(to.size());
  std::ranges::transform(to, from, out.begin(), [](const glm::vec3& a, const glm::vec3& b) { return a - b; });
  return out;
}

/// A vertex on the move.
struct Stepping {
  int vertex = 0;
  float size = 0.0f;  ///< Of its step, fraction of H.
};

class PopSearch {
 public:
  PopSearch(const std::shared_ptr<const Character>& character, const Rig& rig)
      : character_(*character), smoother_(character), bare_(*character, rig) {
    EXPECT_TRUE(smoother_.prepare(rig).ok());
  }

  void walk(const AnimationClip& clip, int mostFrames, Pops& out) {
    clip_ = &clip;
    const int frames = std::min(mostFrames, static_cast<int>(static_cast<double>(clip.duration) * 60.0));
    Moment before = at(0);
    for (int i = 1; i <= frames; ++i) {
      Moment now = at(i * kFrameTicks);
      look(i, out);
      compare(before, now, out);
      before = std::move(now);
    }
    out.frames += frames;
  }

 private:
  [[nodiscard]] Pose poseAt(int tick) const {
    return samplePose(character_.skeleton, *clip_, static_cast<float>(tick * kTick));
  }

  Moment at(int tick) {
    const Pose pose = poseAt(tick);
    smoother_.smooth(pose, surface_);
    patch_ = &bare_.patchAt(pose);
    return {tick, CarriedOffsets(*surface_.refinement).of(surface_, *patch_),
            between(patch_->positions, surface_.positions)};
  }

  /// At the surface that was made last.
  void look(int frame, Pops& out) {
    for (std::size_t v = 0; v < surface_.normals.size(); ++v) {
      if (surface_.displacement[v] == 0.0f) continue;
      const float cosine = std::clamp(glm::dot(surface_.normals[v], patch_->normals[v]), -1.0f, 1.0f);
      out.turned += static_cast<double>(glm::degrees(std::acos(cosine)));
      ++out.moved;
    }
    if (frame % kLookedAt != 0) return;
    const Bounds box = boundsOf(patch_->positions);
    const float extent = 1.05f * glm::length(box.high - box.low);
    const auto backs = [&](const Surface& surface) {
      return visibleBacks(*surface.refinement, surface.positions, box.center(), extent, kPixels);
    };
    const long long own = backs(surface_);
    const long long bare = backs(*patch_);
    out.backs += own;
    out.bareBacks += bare;
    out.moreBacks += std::max(0LL, own - bare);
  }

  /// Against the patch's frame, or the world's where that is less: a frame may turn over in a crease in which nothing
  /// moves.
  [[nodiscard]] float way(const Moment& a, const Moment& b, int vertex) const {
    const float carried = glm::distance(sinew::at(a.offsets, vertex), sinew::at(b.offsets, vertex));
    const float inWorld = glm::distance(sinew::at(a.inWorld, vertex), sinew::at(b.inWorld, vertex));
    const float way = std::min(carried, inWorld) / character_.height;
    return std::isfinite(way) ? way : std::numeric_limits<float>::infinity();
  }

  void compare(const Moment& before, const Moment& now, Pops& out) {
    std::vector<Stepping> stepping;
    for (int v = 0; v < static_cast<int>(now.offsets.size()); ++v) {
      const float size = way(before, now, v);
      out.largestStep = std::max(out.largestStep, size);
      if (size > kStep) stepping.push_back({v, size});
    }
    out.steps += static_cast<long long>(stepping.size());
    if (!stepping.empty()) follow(before, now, kTenths, std::move(stepping), out);
  }

  /// Into that part of the time in which each moves furthest.
  void follow(const Moment& from, const Moment& to, int parts, std::vector<Stepping> stepping, Pops& out) {
    std::erase_if(stepping, [&](const Stepping& one) { return !(way(from, to, one.vertex) > kKept) && parts == 2; });
    if (stepping.empty()) return;
    const int ticks = (to.tick - from.tick) / parts;
    if (to.tick - from.tick == 1) {
      out.pops += static_cast<long long>(stepping.size());
      for (const Stepping& one : stepping) out.largestPop = std::max(out.largestPop, one.size);
      list(from, to, stepping, out);
      return;
    }
    std::vector<Moment> moments{from};
    for (int i = 1; i < parts; ++i) moments.push_back(at(from.tick + i * ticks));
    moments.push_back(to);
    std::vector<std::vector<Stepping>> of(static_cast<std::size_t>(parts));
    for (const Stepping& one : stepping) {
      std::size_t fastest = 0;
      float most = -1.0f;
      for (std::size_t i = 0; i < of.size(); ++i) {
        const float moved = way(moments[i], moments[i + 1], one.vertex);
        if (moved > most) fastest = i;
        most = std::max(most, moved);
      }
      of[fastest].push_back(one);
    }
    for (std::size_t i = 0; i < of.size(); ++i) follow(moments[i], moments[i + 1], 2, std::move(of[i]), out);
  }

  void list(const Moment& from, const Moment& to, const std::vector<Stepping>& stepping, Pops& out) {
    const auto rootsAt = [&](int tick) {
      const Surface& projected = bare_.at(poseAt(tick));
      return between(bare_.patch().positions, projected.positions);
    };
    const Offsets before = rootsAt(from.tick);
    const Offsets after = rootsAt(to.tick);
    for (const Stepping& one : stepping) {
      const auto v = static_cast<std::size_t>(one.vertex);
      out.places.push_back({clip_->name, from.tick * kTick, one.vertex, controlTriangleAt(one.vertex), one.size,
                            way(from, to, one.vertex), glm::distance(before[v], after[v]) / character_.height});
    }
  }

  [[nodiscard]] int controlTriangleAt(int vertex) const {
    const Refinement& refinement = *surface_.refinement;
    const auto triangle = std::ranges::find_if(
        refinement.triangles, [&](const auto& corners) { return std::ranges::find(corners, vertex) != corners.end(); });
    return refinement.controlOf[static_cast<std::size_t>(triangle - refinement.triangles.begin())];
  }

  const Character& character_;
  const AnimationClip* clip_ = nullptr;
  Smoother smoother_;
  Projected bare_;  ///< The skin without muscles, on the same mesh.
  Surface surface_;
  const Surface* patch_ = nullptr;
};

}  // namespace

void Pops::add(const Pops& other) {
  frames += other.frames;
  steps += other.steps;
  pops += other.pops;
  largestStep = std::max(largestStep, other.largestStep);
  largestPop = std::max(largestPop, other.largestPop);
  turned += other.turned;
  moved += other.moved;
  backs += other.backs;
  bareBacks += other.bareBacks;
  moreBacks += other.moreBacks;
  places.insert(places.end(), other.places.begin(), other.places.end());
}

Pops countPops(const std::shared_ptr<const Character>& character, const Rig& rig, int mostFrames) {
  Pops out;
  PopSearch search(character, rig);
  for (const AnimationClip& clip : character->clips) search.walk(clip, mostFrames, out);
  return out;
}

}  // namespace sinew::test
