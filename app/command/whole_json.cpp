// app/command/whole_json.cpp: a run of `sinew bench` for programs. docs/formats.md.
#include "app/command/whole.h"

namespace sinew::app {
namespace {

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json jsonOf(const SetSpeedup& speedup) {
  Json json = Json::object();
  json.set("cold", speedup.cold).set("warm_60hz", speedup.warm60Hz).set("warm_20hz", speedup.warm20Hz);
  json.set("cut", speedup.cut);
  return json;
}

Json jsonOf(const std::vector<SpeedupRow>& rows, SetSpeedup SpeedupRow::*part) {
  Json json = Json::object();
  for (const SpeedupRow& row : rows) json.set(row.set, jsonOf(row.*part));
  return json;
}

Json jsonOf(const ModeFigures& figures) {
  const Speedups& speedups = figures.speedups;
  Json json = Json::object();
  json.set("scene", figures.scene).set("depth", kBenchDepth).set("frame_seconds", figures.cost.frameSeconds);
  json.set("reference_over_optimised", jsonOf(speedups.rows, &SpeedupRow::frame));
  json.set("reference_over_optimised_projection", jsonOf(speedups.rows, &SpeedupRow::projection));
  json.set("with_over_without", figures.cost.withOverWithout);
  json.set("ns_per_projected_vertex", figures.cost.nsPerProjectedVertex);
  json.set("ns_per_vertex_floor", figures.cost.nsPerVertexFloor);
  json.set("exponent_vertices", figures.exponentVertices).set("exponent_primitives", figures.exponentPrimitives);
  json.set("threads2_single", figures.threads.single).set("threads2_crowd", figures.threads.crowd);
  json.set("within_1e-4H", speedups.agreement.within).set("nan", speedups.agreement.notFinite);
  json.set("uncertified_share", speedups.agreement.uncertifiedShare);
  json.set("draw_seconds", figures.drawing ? Json(figures.drawing->drawSeconds) : Json());
  json.set("upload_seconds", figures.drawing ? Json(figures.drawing->uploadSeconds) : Json());
  return json;
}

Json jsonOf(const Table1Row& row) {
  Json json = Json::object();
  json.set("mode", nameOf(row.mode)).set("scene", row.scene).set("depth", row.depth);
  json.set("projection", nameOf(row.projection)).set("culling", row.culling);
  json.set("frame_seconds", row.frameSeconds).set("fps", row.fps).set("paper_fps", orNull(row.paperFps));
  return json;
}

Json jsonOf(const Table2Row& row) {
  Json json = Json::object();
  json.set("mode", nameOf(row.mode)).set("scene", row.scene).set("depth", row.depth);
  json.set("n", row.triangles).set("vertices", row.vertices);
  json.set("frame_seconds", row.frameSeconds).set("fps", row.fps);
  json.set("paper_n", orNull(row.paperTriangles)).set("paper_fps", orNull(row.paperFps));
  return json;
}

template <class Row>
Json listOf(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) list.push(jsonOf(row));
  return list;
}

}  // namespace

Json jsonOf(const Whole& whole) {
  Json json = Json::object();
  json.set("machine", jsonOf(whole.machine)).set("rounds", whole.rounds);
  for (const ModeFigures& figures : whole.modes) json.set(nameOf(figures.mode), jsonOf(figures));
  json.set("table1", listOf(whole.table1)).set("table2", listOf(whole.table2));
  return json;
}

}  // namespace sinew::app
