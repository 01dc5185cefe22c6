// tests/bench/detail.cpp: how far flat triangles lie off the surface, and what they cost: uniform and adaptive detail.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <utility>

#include <glm/geometric.hpp>

#include "app/ui/data_files.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/stopwatch.h"
#include "sinew/geometry/threads.h"
#include "tests/bench/parts.h"
#include "tests/support/characters/stand_ins.h"
#include "tests/support/surface/fine_reference.h"
#include "tests/support/surface/projected.h"
#include "tests/viewport/tools/laid_muscles.h"

namespace sinew::app {
namespace {

/// Distances of control triangles, fraction of H, over poses.
struct Spread {
  double most = 0.0;
  double ofThousand = 0.0;  ///< All but one in a thousand are within.
  double within = 0.0;      ///< Share of the triangles that are within the rig's tolerance.
};

struct DetailRow {
  std::string scene;
  std::string detail;
  int vertices = 0;
  Spread bind;
  Spread clips;         ///< At moments of all clips.
  double rooted = 0.0;  ///< Share of moved vertices, at those moments, that stand where projection has put them.
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

/// Adds for each control triangle, fraction of H, how far the farthest of its fine vertices is from its own flat
/// triangles: at least the true distance.
void addDistances(const Surface& fine, const Surface& flat, float height, std::vector<double>& out) {
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
  for (const float squared : worst)
    out.push_back(std::sqrt(static_cast<double>(squared)) / static_cast<double>(height));
}

Spread spreadOf(std::vector<double> distances, float tolerance) {
  if (distances.empty()) return {};
  std::ranges::sort(distances);
  const auto fit = std::ranges::upper_bound(distances, static_cast<double>(tolerance)) - distances.begin();
  const auto count = static_cast<double>(distances.size());
  return {distances.back(), distances[distances.size() - 1 - distances.size() / 1000],
          static_cast<double>(fit) / count};
}

double meanSeconds(Smoother& smoother, const std::vector<Pose>& moments, int rounds) {
  const ThreadLimit one(1);
  Surface surface;
  std::vector<double> least(moments.size(), std::numeric_limits<double>::max());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < moments.size(); ++i) {
      smoother.smooth(moments[i], surface);
      least[i] = std::min(least[i], surface.report.seconds.total());
    }
  }
  double sum = 0.0;
  for (const double seconds : least) sum += seconds / static_cast<double>(least.size());
  return sum;
}

Result<std::vector<DetailRow>> measureDetail(const BenchScene& scene, const Effort& effort) {
  const Character& character = *scene.character;
  const Pose bind = bindPose(character.skeleton);
  std::vector<Pose> moments = momentsOf(character, effort.frames);
  if (moments.empty()) moments.push_back(bind);
  Rig rig = scene.rig;
  const float tolerance = rig.smoothing.tolerance;
  std::vector<DetailRow> rows;
  std::unique_ptr<test::FineReference> fine;
  for (const int depth : {3, 0}) {
    DetailRow row;
    row.scene = scene.name;
    row.detail = depth > 0 ? "depth " + std::to_string(depth) : "adaptive";
    progress(scene.name + ", " + row.detail);
    rig.smoothing.detail = depth > 0 ? DetailKind::kUniform : DetailKind::kAdaptive;
    rig.smoothing.depth = std::max(depth, 1);
    Smoother smoother(scene.character);
    Stopwatch watch;
    if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
    row.prepareSeconds = watch.lap();
    if (!fine) fine = std::make_unique<test::FineReference>(scene.character, rig, fineDepth(character.mesh));
    test::Projected projected(character, rig);
    Surface own;
    std::vector<double> distances;
    smoother.smooth(bind, own);
    row.vertices = own.report.refinedVertices;
    addDistances(fine->at(bind), own, character.height, distances);
    row.bind = spreadOf(std::move(distances), tolerance);
    distances.clear();
    long long moved = 0;
    long long rooted = 0;
    for (const Pose& pose : moments) {
      smoother.smooth(pose, own);
      addDistances(fine->at(pose), own, character.height, distances);
      const std::vector<float>& roots = projected.at(pose).displacement;
      for (std::size_t v = 0; v < roots.size(); ++v) {
        moved += roots[v] != 0.0f ? 1 : 0;
        rooted += roots[v] != 0.0f && roots[v] == own.displacement[v] ? 1 : 0;
      }
    }
    row.clips = spreadOf(std::move(distances), tolerance);
    row.rooted = static_cast<double>(rooted) / static_cast<double>(std::max(moved, 1LL));
    row.frameSeconds = meanSeconds(smoother, moments, effort.rounds);
    rows.push_back(row);
  }
  return rows;
}

/// Muscles laid by the tool with its defaults.
BenchScene laidOn(const std::shared_ptr<const Character>& character, int muscles) {
  return {character->name, character, test::layMuscles(character, muscles)};
}

/// The rigs that ship with the program, and characters such as games have.
Result<std::vector<BenchScene>> usualScenes() {
  std::vector<BenchScene> scenes;
  for (const char* name : {"humanoid", "humanoid-flex", "horse", "demo"}) {
    Result<BenchScene> scene = openScene(dataFile(std::string("assets/") + name + ".rig.json"));
    if (!scene) return scene.error();
    scenes.push_back(std::move(scene).value());
  }
  scenes.push_back(laidOn(test::irregularHorse(), 20));
  scenes.push_back(laidOn(test::humanoidInParts(), 20));
  scenes.push_back(laidOn(test::fineHumanoid(), 24));
  return scenes;
}

std::string tableOf(const std::vector<DetailRow>& rows) {
  std::string table =
      "How far the surface, sampled at depth 12 (6 above 20,000 triangles), lies off the flat triangles, per cent of\n"
      "the height: the farthest place, what 999 of 1,000 control triangles stay within, and the share of them within\n"
      "the tolerance, in the bind pose and at moments of all clips. Rooted: moved vertices that stand where "
      "projection\n"
      "has put them, not bounded, filtered or unfolded. Milliseconds of a frame on one core, least of all rounds, "
      "mean\n"
      "of the moments; of preparing, once.\n"
      "\n"
      "                                      bind pose               clips\n"
      "scene              detail    vertices   most  .999  within %   most  .999  within %  rooted %  frame ms  "
      "prepare "
      "ms\n";
  char line[200];
  for (const DetailRow& row : rows) {
    std::snprintf(
        line, sizeof line, "%-17.40s  %-8s  %8d  %5.2f  %4.2f  %8.1f  %5.2f  %4.2f  %8.1f  %8.1f  %8.2f  %10.1f\n",
        row.scene.c_str(), row.detail.c_str(), row.vertices, 100.0 * row.bind.most, 100.0 * row.bind.ofThousand,
        100.0 * row.bind.within, 100.0 * row.clips.most, 100.0 * row.clips.ofThousand, 100.0 * row.clips.within,
        100.0 * row.rooted, 1e3 * row.frameSeconds, 1e3 * row.prepareSeconds);
    table += line;
  }
  return table;
}

Json jsonOf(const Spread& spread) {
  Json item = Json::object();
  item.set("most", spread.most).set("of_thousand", spread.ofThousand).set("within", spread.within);
  return item;
}

Json jsonOf(const std::vector<DetailRow>& rows) {
  Json list = Json::array();
  for (const DetailRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("detail", row.detail).set("vertices", row.vertices);
    item.set("bind", jsonOf(row.bind)).set("clips", jsonOf(row.clips)).set("rooted", row.rooted);
    item.set("frame_seconds", row.frameSeconds).set("prepare_seconds", row.prepareSeconds);
    list.push(item);
  }
  return list;
}

}  // namespace

std::vector<Pose> momentsOf(const Character& character, int most) {
  constexpr float kRate = 30.0f;  // A second.
  std::vector<Pose> moments;
  for (const AnimationClip& clip : character.clips) {
    const int count = std::clamp(static_cast<int>(clip.duration * kRate), 1, most);
    for (int i = 0; i < count; ++i) {
      const float share = (static_cast<float>(i) + 0.37f) / static_cast<float>(count);
      moments.push_back(samplePose(character.skeleton, clip, share * clip.duration));
    }
  }
  return moments;
}

Result<Report> reportDetail(Files files, const Effort& effort) {
  std::vector<DetailRow> rows;
  if (files.empty()) {
    const auto scenes = usualScenes();
    if (!scenes) return scenes.error();
    for (const BenchScene& scene : scenes.value()) {
      const auto measured = measureDetail(scene, effort);
      if (!measured) return measured.error();
      rows.insert(rows.end(), measured->begin(), measured->end());
    }
  } else {
    auto measured = rowsOf<DetailRow>(files, [&](const auto& scene) { return measureDetail(scene, effort); });
    if (!measured) return measured.error();
    rows = std::move(measured).value();
  }
  return Report{tableOf(rows), jsonOf(rows)};
}

}  // namespace sinew::app
