// tests/bench/detail.cpp: how far flat triangles lie off the surface, and what they cost: uniform and adaptive detail.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include <glm/geometric.hpp>

#include "app/bench/measuring.h"
#include "core/base/at.h"
#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "sinew/base/threads.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

struct DetailRow {
  std::string scene;
  std::string detail;
  int vertices = 0;
  int triangles = 0;
  double bindError = 0.0;  ///< Fraction of H: the farthest of the fine surface's vertices from the flat triangles.
  double within = 0.0;     ///< Share of the control triangles that are within the rig's tolerance in the bind pose.
  double clipError = 0.0;  ///< The same over moments of all clips.
  double prepareSeconds = 0.0;
  double frameSeconds = 0.0;
};

/// Large meshes are compared with as fine a mesh as memory holds.
int fineDepth(const ControlMesh& mesh) { return mesh.triangles.size() > 20'000 ? 6 : 12; }

float squaredDistance(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::vec3 face = glm::cross(b - a, c - a);
  const std::array corners{a, b, c};
  bool isInside = true;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3& from = corners[i];
    const glm::vec3 side = corners[(i + 1) % 3] - from;
    isInside = isInside && glm::dot(glm::cross(side, p - from), face) >= 0.0f;
    const float squared = glm::dot(side, side);
    const float t = squared > 0.0f ? std::clamp(glm::dot(p - from, side) / squared, 0.0f, 1.0f) : 0.0f;
    const glm::vec3 off = p - from - t * side;
    least = std::min(least, glm::dot(off, off));
  }
  const float area = glm::dot(face, face);
  if (!isInside || !(area > 0.0f)) return least;
  const float along = glm::dot(p - a, face);
  return std::min(least, along * along / area);
}

/// [T] fraction of H: the farthest of each control triangle's fine vertices from its own flat triangles, at least the
/// true distance.
std::vector<double> distances(const Surface& fine, const Surface& flat, float height) {
  const Refinement& f = *fine.refinement;
  const Refinement& r = *flat.refinement;
  const std::size_t count = r.triangleBegin.size() - 1;
  std::vector<float> worst(count, 0.0f);
  forEachIndex(count, 16, [&](std::size_t t) {
    for (int i = f.triangleBegin[t]; i < f.triangleBegin[t + 1]; ++i) {
      for (const int vertex : at(f.triangles, i)) {
        const glm::vec3& p = at(fine.positions, vertex);
        float least = std::numeric_limits<float>::max();
        for (int k = r.triangleBegin[t]; k < r.triangleBegin[t + 1]; ++k) {
          const auto& corners = at(r.triangles, k);
          least = std::min(least, squaredDistance(p, at(flat.positions, corners[0]), at(flat.positions, corners[1]),
                                                  at(flat.positions, corners[2])));
        }
        worst[t] = std::max(worst[t], least);
      }
    }
  });
  std::vector<double> out;
  for (const float squared : worst)
    out.push_back(std::sqrt(static_cast<double>(squared)) / static_cast<double>(height));
  return out;
}

Result<std::vector<DetailRow>> measureDetail(const BenchScene& scene, const Effort& effort) {
  const Character& character = *scene.character;
  std::vector<Pose> moments;
  for (const AnimationClip& clip : character.clips) {
    for (int i = 0; i < effort.frames; ++i) {
      const float share = (static_cast<float>(i) + 0.37f) / static_cast<float>(effort.frames);
      moments.push_back(samplePose(character.skeleton, clip, share * clip.duration));
    }
  }
  const Pose bind = bindPose(character.skeleton);
  Rig rig = scene.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = fineDepth(character.mesh);
  Smoother fine(scene.character);
  if (const auto prepared = fine.prepare(rig); !prepared) return prepared.error();
  std::vector<DetailRow> rows;
  for (const int depth : {3, 0}) {
    DetailRow row{scene.name, depth > 0 ? "depth " + std::to_string(depth) : "adaptive"};
    rig.smoothing.detail = depth > 0 ? DetailKind::kUniform : DetailKind::kAdaptive;
    rig.smoothing.depth = std::max(depth, 1);
    Smoother smoother(scene.character);
    Stopwatch watch;
    if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
    row.prepareSeconds = watch.lap();
    Surface own;
    Surface reference;
    fine.smooth(bind, reference);
    smoother.smooth(bind, own);
    row.vertices = own.report.refinedVertices;
    row.triangles = own.report.refinedTriangles;
    const std::vector<double> bindErrors = distances(reference, own, character.height);
    const double tolerance = static_cast<double>(rig.smoothing.tolerance);
    const auto fit = std::ranges::count_if(bindErrors, [&](double error) { return error <= tolerance; });
    row.bindError = std::ranges::max(bindErrors);
    row.within = static_cast<double>(fit) / static_cast<double>(bindErrors.size());
    for (const Pose& pose : moments) {
      fine.smooth(pose, reference);
      smoother.smooth(pose, own);
      row.clipError = std::max(row.clipError, std::ranges::max(distances(reference, own, character.height)));
    }
    const ThreadLimit one(1);
    std::vector<double> least(std::max<std::size_t>(moments.size(), 1), std::numeric_limits<double>::max());
    for (int round = 0; round < effort.rounds; ++round) {
      for (std::size_t i = 0; i < least.size(); ++i) {
        smoother.smooth(moments.empty() ? bind : moments[i], own);
        least[i] = std::min(least[i], own.report.seconds.total());
      }
    }
    for (const double seconds : least) row.frameSeconds += seconds / static_cast<double>(least.size());
    rows.push_back(row);
  }
  return rows;
}

std::string tableOf(const std::vector<DetailRow>& rows) {
  std::string table =
      "How far the surface, sampled at depth 12 (6 above 20,000 triangles), lies off the flat triangles, per cent of\n"
      "the height: in the bind pose (and the share of control triangles within the tolerance) and at moments of all\n"
      "clips. Milliseconds of a frame on one core, least of all rounds, mean of the moments; of preparing, once.\n"
      "\n"
      "scene             detail    vertices  triangles  bind %  within %  clips %  frame ms  prepare ms\n";
  char line[160];
  for (const DetailRow& row : rows) {
    std::snprintf(line, sizeof line, "%-16.40s  %-8s  %8d  %9d  %6.3f  %8.1f  %7.3f  %8.3f  %10.1f\n",
                  row.scene.c_str(), row.detail.c_str(), row.vertices, row.triangles, 100.0 * row.bindError,
                  100.0 * row.within, 100.0 * row.clipError, 1e3 * row.frameSeconds, 1e3 * row.prepareSeconds);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<DetailRow>& rows) {
  Json list = Json::array();
  for (const DetailRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("detail", row.detail).set("vertices", row.vertices);
    item.set("triangles", row.triangles)
        .set("bind_error", row.bindError)
        .set("within", row.within)
        .set("clip_error", row.clipError);
    item.set("frame_seconds", row.frameSeconds).set("prepare_seconds", row.prepareSeconds);
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportDetail(Files files, const Effort& effort) {
  const auto rows = rowsOf<DetailRow>(files, [&](const auto& scene) { return measureDetail(scene, effort); });
  if (!rows) return rows.error();
  return Report{tableOf(rows.value()), jsonOf(rows.value())};
}

}  // namespace sinew::app
