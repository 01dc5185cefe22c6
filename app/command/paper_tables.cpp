// app/command/paper_tables.cpp: projections with and without culling in turn, on moments spread over the clip.
#include "app/command/paper_tables.h"

#include <array>
#include <numbers>
#include <utility>

#include "app/command/measuring.h"
#include "app/viewport/render/view.h"
#include "core/character/skinning.h"
#include "core/geometry/instruction_set.h"

namespace sinew::app {
namespace {

constexpr int kTableFrames = 2;
constexpr std::array kProjections{ProjectionKind::kAnalytic, ProjectionKind::kBisection, ProjectionKind::kNewton};

/// A moment, and the eye that culls: a picture's that shows the character from the front and a little to the side.
struct Moment {
  Pose pose;
  glm::vec3 eye;
};

std::vector<Moment> momentsOf(const Character& character) {
  std::vector<Moment> moments;
  for (Pose& pose : spreadFrames(character, kTableFrames)) {
    SkinnedMesh skinned;
    skin(character, pose, skinned);
    const View view = framedView(skinned.positions, std::numbers::pi_v<float> / 6.0f, 0.2f, {1280, 800}, false);
    moments.push_back({std::move(pose), view.facingPoint()});
  }
  return moments;
}

/// One row at work.
struct TableContender {
  Smoother* smoother = nullptr;
  bool culling = false;
  Surface surface;
  std::vector<double> seconds;
};

void run(std::vector<TableContender>& contenders, const std::vector<Moment>& moments, int rounds) {
  inTurn(contenders.size(), rounds, [&](std::size_t variant, int round) {
    TableContender& contender = contenders[variant];
    for (const Moment& moment : moments) {
      const auto eye = contender.culling ? std::optional(moment.eye) : std::nullopt;
      contender.smoother->smooth(moment.pose, contender.surface, eye);
      if (round > 0) contender.seconds.push_back(contender.surface.report.seconds.total());
    }
  });
}

double rateOf(double seconds) { return seconds > 0.0 ? 1.0 / seconds : 0.0; }

bool isPaperHumanoid(const Character& character) {
  return 4.0 * static_cast<double>(character.mesh.triangles.size()) == kPaperTable2.front().humanoidTriangles;
}

bool isPaperHorse(const Character& character) {
  return 4.0 * static_cast<double>(character.mesh.triangles.size()) == kPaperTable2.front().horseTriangles;
}

std::optional<double> paperRate(const PaperRates& rates, ProjectionKind projection, bool culling) {
  if (projection == ProjectionKind::kAnalytic) return culling ? rates.analyticCulled : rates.analytic;
  if (projection == ProjectionKind::kBisection) return culling ? rates.bisectionCulled : rates.bisection;
  return std::nullopt;
}

}  // namespace

Result<std::vector<Table1Row>> measureTable1(const BenchScene& scene, int rounds) {
  const bool humanoid = isPaperHumanoid(*scene.character);
  const std::vector<Moment> moments = momentsOf(*scene.character);
  std::vector<Table1Row> rows;
  const InstructionSetScope vertexByVertex(InstructionSet::kScalar);  // Like with like: vectors know newton alone.
  for (const PaperRates& paper : kPaperTable1) {  // One depth after the other: all at once fill the memory.
    std::vector<Smoother> smoothers;
    for (const ProjectionKind projection : kProjections) {
      Result<Smoother> smoother = preparedSmoother(scene, rigAt(scene, paper.depth), projection);
      if (!smoother) return smoother.error();
      smoothers.push_back(std::move(smoother.value()));
    }
    std::vector<TableContender> contenders;
    for (Smoother& smoother : smoothers) {
      for (const bool culling : {false, true}) contenders.push_back({&smoother, culling, {}, {}});
    }
    run(contenders, moments, rounds);
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const double seconds = median(contenders[i].seconds);
      const ProjectionKind projection = kProjections[i / 2];
      const bool culling = contenders[i].culling;
      rows.push_back({scene.name, scene.rig.surface.mode, paper.depth, projection, culling, seconds, rateOf(seconds),
                      humanoid ? paperRate(paper, projection, culling) : std::nullopt});
    }
  }
  return rows;
}

Result<std::vector<Table2Row>> measureTable2(const BenchScene& scene, int rounds) {
  std::vector<Table2Row> rows;
  std::vector<Smoother> smoothers;
  const bool humanoid = isPaperHumanoid(*scene.character), horse = isPaperHorse(*scene.character);
  for (const PaperSizes& paper : kPaperTable2) {
    Result<Smoother> smoother = preparedSmoother(scene, rigAt(scene, paper.depth));
    if (!smoother) return smoother.error();
    smoothers.push_back(std::move(smoother.value()));
    Table2Row row{scene.name, scene.rig.surface.mode, paper.depth, 0, 0, 0.0, 0.0, {}, {}};
    if (humanoid || horse) {
      row.paperTriangles = humanoid ? paper.humanoidTriangles : paper.horseTriangles;
      row.paperFps = humanoid ? paper.humanoidFps : paper.horseFps;
    }
    rows.push_back(std::move(row));
  }
  std::vector<TableContender> contenders;
  for (Smoother& smoother : smoothers) contenders.push_back({&smoother, true, {}, {}});
  run(contenders, momentsOf(*scene.character), rounds);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SmoothingReport& report = contenders[i].surface.report;
    rows[i].triangles = report.refinedTriangles;
    rows[i].vertices = report.refinedVertices;
    rows[i].frameSeconds = median(contenders[i].seconds);
    rows[i].fps = rateOf(rows[i].frameSeconds);
  }
  return rows;
}

}  // namespace sinew::app
