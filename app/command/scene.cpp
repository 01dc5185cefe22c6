// app/command/scene.cpp: a character with muscles in one surface mode: what `sinew bench` measures.
#include "app/command/scene.h"

#include <utility>

#include "app/document/document.h"
#include "core/rig/trial_rig.h"

namespace sinew::app {
namespace {

constexpr int kTrialMuscles = 12;
constexpr std::uint64_t kTrialSeed = 1;

}  // namespace

Result<BenchScene> openScene(const std::filesystem::path& file) {
  const Result<Document> document = openDocument(file);
  if (!document) return document.error();
  const std::string name = file.filename().string();
  const bool bare = document->rig().primitives.empty();
  return BenchScene{name.substr(0, name.find('.', 1)), document->character,
                    bare ? trialRig(*document->character, kTrialMuscles, kTrialSeed) : document->rig()};
}

Rig rigAt(const BenchScene& scene, int depth) {
  Rig rig = scene.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = depth;
  rig.smoothing.autoDepth = false;
  return rig;
}

Result<Smoother> preparedSmoother(const BenchScene& scene, const Rig& rig, ProjectionKind projection) {
  Smoother smoother(scene.character, projection);
  if (const Result<void> prepared = smoother.prepare(rig); !prepared) return prepared.error();
  return smoother;
}

}  // namespace sinew::app
