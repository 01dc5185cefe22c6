// tests/bench/shading.cpp: how much of the surface is shaded otherwise than a much finer one.
#include <algorithm>
#include <cstdio>

#include "tests/bench/parts.h"
#include "tests/support/surface/fine_reference.h"
#include "tests/support/surface/shading_error.h"

namespace sinew::app {
namespace {

struct ShadingRow {
  std::string scene;
  std::string detail;
  int vertices = 0;
  test::ShadingError bind;
  test::ShadingError clips;  ///< At moments of all clips.
};

/// As fine as memory allows.
int fineDepth(const ControlMesh& mesh) { return mesh.triangles.size() > 8'000 ? 8 : 16; }

double percent(double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; }

Result<std::vector<ShadingRow>> measureShading(const BenchScene& scene, const Effort& effort) {
  const Character& character = *scene.character;
  test::FineReference fine(scene.character, scene.rig, fineDepth(character.mesh));
  const Pose bind = bindPose(character.skeleton);
  const std::vector<Pose> moments = momentsOf(character, effort.frames);
  std::vector<ShadingRow> rows;
  for (const int depth : {3, 0}) {
    Rig rig = scene.rig;
    rig.smoothing.detail = depth > 0 ? DetailKind::kUniform : DetailKind::kAdaptive;
    rig.smoothing.depth = std::max(depth, 1);
    Smoother smoother(scene.character);
    if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
    ShadingRow row{scene.name, depth > 0 ? "depth " + std::to_string(depth) : "adaptive", 0, {}, {}};
    progress(scene.name + ", " + row.detail);
    Surface flat;
    smoother.smooth(bind, flat);
    row.vertices = flat.report.refinedVertices;
    row.bind = test::shadingError(character.mesh, fine.at(bind), flat);
    for (const Pose& pose : moments) {
      smoother.smooth(pose, flat);
      row.clips.add(test::shadingError(character.mesh, fine.at(pose), flat));
    }
    rows.push_back(row);
  }
  return rows;
}

std::string tableOf(const std::vector<ShadingRow>& rows) {
  std::string table =
      "Area, per cent, whose shading normal is more than 5 degrees off the surface at depth 16 (8 above 8,000\n"
      "triangles): of the whole skin and of what muscles have moved, in the bind pose and at moments of all clips.\n"
      "\n"
      "scene              detail    vertices  bind pose  moved     clips  moved\n";
  char line[160];
  for (const ShadingRow& row : rows) {
    std::snprintf(line, sizeof line, "%-17.40s  %-8s  %8d  %9.2f  %5.2f  %8.2f  %5.2f\n", row.scene.c_str(),
                  row.detail.c_str(), row.vertices, percent(row.bind.off, row.bind.area),
                  percent(row.bind.movedOff, row.bind.movedArea), percent(row.clips.off, row.clips.area),
                  percent(row.clips.movedOff, row.clips.movedArea));
    table += line;
  }
  return table;
}

Json jsonOf(const test::ShadingError& error) {
  Json item = Json::object();
  item.set("off", percent(error.off, error.area)).set("moved_off", percent(error.movedOff, error.movedArea));
  return item;
}

Json jsonOf(const std::vector<ShadingRow>& rows) {
  Json list = Json::array();
  for (const ShadingRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("detail", row.detail).set("vertices", row.vertices);
    item.set("bind", jsonOf(row.bind)).set("clips", jsonOf(row.clips));
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportShading(Files files, const Effort& effort) {
  const auto rows = rowsOf<ShadingRow>(files, [&](const auto& scene) { return measureShading(scene, effort); });
  if (!rows) return rows.error();
  return Report{tableOf(rows.value()), jsonOf(rows.value())};
}

}  // namespace sinew::app
