// app/viewport/gpu/card_figures.cpp: measures and compares; medians over frames.
#include "app/viewport/gpu/card_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <vector>

#include "core/geometry/index_table.h"
#include "core/geometry/stopwatch.h"
#include "core/surface/smooth.h"
#include "core/surface/stages.h"

namespace sinew::app {
namespace {

constexpr double kFar = 1e-4;  ///< Fraction of the height.
constexpr double kFarDegrees = 1.0;
constexpr std::size_t kMostComparedFrames = 3;
constexpr std::size_t kMostBytesTogether = std::size_t{1} << 30;

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

template <class Seconds>
double medianOf(const std::vector<Seconds>& all, const auto& of) {
  std::vector<double> values;
  std::ranges::transform(all, std::back_inserter(values), of);
  return medianOf(std::move(values));
}

struct BothStages {
  std::vector<glm::vec3> projected;
  Surface finished;
};

BothStages stagesOf(const std::shared_ptr<const Preparation>& preparation, const Pose& pose) {
  PosedRig rig;
  preparation->poser->pose(pose, rig);
  SmoothingMemory memory;
  BothStages out;
  poseFieldAndSkin(preparation, rig, pose, memory.posed);
  layPatch(*preparation, memory.posed, memory.workspace, out.finished);
  project(*preparation, memory.posed, pose, std::nullopt, memory.workspace, out.finished);
  out.projected = out.finished.positions;
  smooth(preparation, rig, pose, std::nullopt, memory, out.finished);
  return out;
}

double degreesBetween(const glm::vec3& a, const glm::vec3& b) {
  // From the chord: the cosine of a small angle loses digits.
  const double half = std::min(1.0, 0.5 * static_cast<double>(glm::distance(a, b)));
  return 2.0 * std::asin(half) * 180.0 / std::numbers::pi;
}

/// Refined triangles against their corners' mean normal by more than rounding. @param position, normal  of a vertex
int turnedTriangles(const Refinement& refinement, const auto& position, const auto& normal) {
  int turned = 0;
  for (const auto& corners : refinement.triangles) {
    const auto at = [&](int corner) { return static_cast<std::size_t>(corners[static_cast<std::size_t>(corner)]); };
    const glm::vec3 facing = glm::cross(position(at(1)) - position(at(0)), position(at(2)) - position(at(0)));
    const glm::vec3 mean = normal(at(0)) + normal(at(1)) + normal(at(2));
    turned += glm::dot(facing, mean) < -1e-2f * glm::length(facing) * glm::length(mean) ? 1 : 0;
  }
  return turned;
}

bool isNumber(const glm::vec4& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Bodies that fit into one batch.
int bodiesTogether(const Preparation& preparation, int bodies) {
  constexpr std::size_t kBytesPerVertex = 320;  // With its two triangles and its drawn vertex.
  const auto one = kBytesPerVertex * static_cast<std::size_t>(preparation.refinement().vertexCount);
  const auto most = std::max(std::size_t{1}, kMostBytesTogether / one);
  return static_cast<int>(std::min(most, static_cast<std::size_t>(bodies)));
}

}  // namespace

void CardDifference::add(const CardDifference& other) {
  roots = std::max(roots, other.roots);
  surface = std::max(surface, other.surface);
  normals = std::max(normals, other.normals);
  farVertices += other.farVertices;
  farNormals += other.farNormals;
  notNumbers += other.notNumbers;
  vertices += other.vertices;
  unsure += other.unsure;
  turned += other.turned;
  turnedOnProcessor += other.turnedOnProcessor;
}

Result<CardDifference> compareWithProcessor(const std::shared_ptr<const Preparation>& preparation, const Pose& pose,
                                            CardSurface& card) {
  if (const auto reason = card.setPose(pose)) return Error{"", "", *reason};
  const BothStages expected = stagesOf(preparation, pose);
  const double height = static_cast<double>(preparation->character().height);
  const auto apart = [&](const glm::vec4& a, const glm::vec3& b) {
    return static_cast<double>(glm::distance(glm::vec3(a), b)) / height;
  };
  CardDifference found;
  found.vertices = preparation->refinement().vertexCount;
  card.make(SurfacePart::kProject);
  found.unsure = static_cast<int>(card.readUnsure());
  const std::vector<card::Vertex> projected = card.readSurface();
  card.make();
  const std::vector<card::Vertex> finished = card.readSurface();
  for (std::size_t v = 0; v < expected.projected.size(); ++v) {
    found.roots = std::max(found.roots, apart(projected[v].position, expected.projected[v]));
    const double away = apart(finished[v].position, expected.finished.positions[v]);
    const double turned = degreesBetween(glm::vec3(finished[v].normal), expected.finished.normals[v]);
    found.surface = std::max(found.surface, away);
    found.normals = std::max(found.normals, turned);
    found.farVertices += away > kFar ? 1 : 0;
    found.farNormals += turned > kFarDegrees ? 1 : 0;
    const bool numbers = isNumber(finished[v].position) && isNumber(finished[v].normal);
    found.notNumbers += numbers && isNumber(projected[v].position) ? 0 : 1;
  }
  const Refinement& refinement = preparation->refinement();
  const Surface& processors = expected.finished;
  found.turned = turnedTriangles(
      refinement, [&](std::size_t v) { return glm::vec3(finished[v].position); },
      [&](std::size_t v) { return glm::vec3(finished[v].normal); });
  found.turnedOnProcessor = turnedTriangles(
      refinement, [&](std::size_t v) { return processors.positions[v]; },
      [&](std::size_t v) { return processors.normals[v]; });
  return found;
}

Result<CardFigures> measureCard(const StagePrograms& programs, const std::shared_ptr<const Preparation>& preparation,
                                std::span<const Pose> frames, int bodies) {
  CardFigures figures;
  figures.vertices = preparation->refinement().vertexCount;
  figures.triangles = static_cast<int>(preparation->refinement().triangles.size());
  figures.together = bodiesTogether(*preparation, bodies);
  const int batches = (bodies + figures.together - 1) / figures.together;
  figures.together = (bodies + batches - 1) / batches;
  figures.bodies = batches * figures.together;
  auto card = CardSurface::create(programs, preparation, {figures.together, kMostGroupsAlong});
  if (!card) return card.error();
  for (std::size_t i = 0; i < std::min(frames.size(), kMostComparedFrames); ++i) {
    const auto difference = compareWithProcessor(preparation, frames[i], card.value());
    if (!difference) return difference.error();
    figures.difference.add(difference.value());
  }
  std::vector<PartSeconds> onCard;
  std::vector<double> whole;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    PartSeconds sum{};
    Stopwatch watch;
    for (int b = 0; b < figures.bodies; ++b) {
      const Pose& pose = frames[(i + static_cast<std::size_t>(b)) % frames.size()];
      if (const auto reason = card.value().setPose(pose, b % figures.together)) return Error{"", "", *reason};
      if ((b + 1) % figures.together != 0) continue;
      card.value().make();
      const PartSeconds seconds = card->seconds();
      for (std::size_t part = 0; part < kSurfaceParts; ++part) sum[part] += seconds[part];
    }
    whole.push_back(watch.lap());
    onCard.push_back(sum);
  }
  for (std::size_t part = 0; part < kSurfaceParts; ++part) {
    figures.card[part] = medianOf(onCard, [&](const PartSeconds& one) { return one[part]; });
  }
  figures.cardWhole = medianOf(whole);
  figures.tableBytes = card->tableBytes();
  figures.bodyBytes = card->bodyBytes() / static_cast<std::size_t>(figures.together);
  figures.poseBytes = card->poseBytes() / static_cast<std::size_t>(figures.together);

  SmoothingMemory memory;
  Surface surface;
  PosedRig rig;
  std::vector<StageSeconds> onProcessor;
  for (const Pose& pose : frames) {
    Stopwatch watch;
    preparation->poser->pose(pose, rig);
    smooth(preparation, rig, pose, std::nullopt, memory, surface, watch.lap());
    onProcessor.push_back(surface.report.seconds);
  }
  for (const auto of : {&StageSeconds::skin, &StageSeconds::patch, &StageSeconds::project, &StageSeconds::folds,
                        &StageSeconds::normals}) {
    figures.processor.*of = medianOf(onProcessor, [&](const StageSeconds& one) { return one.*of; });
  }
  return figures;
}

std::string textOf(const std::string& name, const CardFigures& figures) {
  std::string text;
  char line[240];
  const auto add = [&](auto... values) {
    std::snprintf(line, sizeof line, values...);
    text += line;
  };
  const auto part = [&](SurfacePart of) { return 1e3 * figures.card[static_cast<std::size_t>(of)]; };
  const StageSeconds& p = figures.processor;
  const double bodies = figures.bodies;
  const auto row = [&](const char* what, double card, double processor) {
    add("  %-10s %12.3f %12.3f\n", what, card, 1e3 * bodies * processor);
  };
  add("%s: %s vertices, %s triangles", name.c_str(), grouped(figures.vertices).c_str(),
      grouped(figures.triangles).c_str());
  if (figures.bodies > 1) add(", %d bodies, %d at once", figures.bodies, figures.together);
  add("\n  %-10s %12s %12s\n", "ms", "card", "processor");
  row("skin", part(SurfacePart::kSkin), p.skin);
  row("patch", part(SurfacePart::kPatch), p.patch);
  row("project", part(SurfacePart::kProject), p.project);
  row("folds", part(SurfacePart::kHeights) + part(SurfacePart::kFolds), p.folds);
  row("normals", part(SurfacePart::kNormals), p.normals);
  add("  %-10s %12.3f\n", "drawn", part(SurfacePart::kDrawn));
  row("total", 1e3 * total(figures.card), p.total());
  add("  with posing, upload and waiting: %.3f ms\n", 1e3 * figures.cardWhole);
  const CardDifference& d = figures.difference;
  add("  largest difference: roots %.1e H, surface %.1e H, normals %.3f degrees\n", d.roots, d.surface, d.normals);
  add("  of %s vertices %d differ by more than 1e-4 H, %d by more than 1 degree, %d are not finite; %d roots in "
      "double precision\n",
      grouped(d.vertices).c_str(), d.farVertices, d.farNormals, d.notNumbers, d.unsure);
  add("  flipped triangles: %d on the card, %d on the processor\n", d.turned, d.turnedOnProcessor);
  add("  on the card: %.1f MiB once, %.1f MiB per body (%.0f bytes per vertex); %.1f KiB uploaded per frame\n",
      static_cast<double>(figures.tableBytes) / 1048576.0, static_cast<double>(figures.bodyBytes) / 1048576.0,
      static_cast<double>(figures.bodyBytes) / figures.vertices, static_cast<double>(figures.poseBytes) / 1024.0);
  return text;
}

Json jsonOf(const std::string& name, const CardFigures& figures) {
  Json card = Json::object();
  for (std::size_t i = 0; i < kSurfaceParts; ++i) card.set(nameOf(static_cast<SurfacePart>(i)), figures.card[i]);
  const StageSeconds& p = figures.processor;
  const CardDifference& d = figures.difference;
  return Json::object()
      .set("scene", name)
      .set("vertices", figures.vertices)
      .set("triangles", figures.triangles)
      .set("bodies", figures.bodies)
      .set("at_once", figures.together)
      .set("card_seconds", card.set("total", total(figures.card)).set("whole", figures.cardWhole))
      .set("processor_seconds_a_body", Json::object()
                                           .set("skin", p.skin)
                                           .set("patch", p.patch)
                                           .set("project", p.project)
                                           .set("folds", p.folds)
                                           .set("normals", p.normals)
                                           .set("total", p.total()))
      .set("difference", Json::object()
                             .set("vertices", d.vertices)
                             .set("roots_of_height", d.roots)
                             .set("surface_of_height", d.surface)
                             .set("normals_degrees", d.normals)
                             .set("beyond_1e-4_of_height", d.farVertices)
                             .set("beyond_1_degree", d.farNormals)
                             .set("not_numbers", d.notNumbers)
                             .set("turned_triangles", d.turned)
                             .set("turned_on_processor", d.turnedOnProcessor)
                             .set("roots_in_double_precision", d.unsure))
      .set("table_bytes", static_cast<double>(figures.tableBytes))
      .set("body_bytes", static_cast<double>(figures.bodyBytes))
      .set("upload_bytes", static_cast<double>(figures.poseBytes));
}

}  // namespace sinew::app
