// app/viewport/gpu/stages.cpp: the files of the stages.
#include "app/viewport/gpu/stages.h"

#include <utility>

#include "app/viewport/gpu/surface_parts.h"

namespace sinew::app {
namespace {

/// In the order of Stage.
constexpr std::array<const char*, kStages> kFiles{
    "shaders/compute/skin.comp",         "shaders/compute/patch.comp",       "shaders/compute/patch.comp",
    "shaders/compute/replace.comp",      "shaders/compute/swell.comp",       "shaders/compute/swell_exact.comp",
    "shaders/compute/swell_shaped.comp", "shaders/compute/place.comp",       "shaders/compute/near.comp",
    "shaders/compute/crease_front.comp", "shaders/compute/crease.comp",      "shaders/compute/slope.comp",
    "shaders/compute/lower.comp",        "shaders/compute/bend.comp",        "shaders/compute/weigh.comp",
    "shaders/compute/filter.comp",       "shaders/compute/fold_start.comp",  "shaders/compute/spread_ask.comp",
    "shaders/compute/spread_move.comp",  "shaders/compute/fold_height.comp", "shaders/compute/rims.comp",
    "shaders/compute/soften.comp",       "shaders/compute/hold.comp",        "shaders/compute/teeth.comp",
    "shaders/compute/even.comp",         "shaders/compute/drawn.comp"};
static_assert(kFiles.back() != nullptr, "a file for each stage");

}  // namespace

Result<StagePrograms> StagePrograms::create() {
  if (epoxy_gl_version() < 45) return Error{"", "", "the graphics driver does not offer OpenGL 4.5: " + rendererName()};
  StagePrograms programs;
  for (std::size_t i = 0; i < kStages; ++i) {
    const bool flat = static_cast<Stage>(i) == Stage::kFlatPatch;
    Result<GlProgram> program = flat ? GlProgram::load({kFiles[i]}, {"REPLACE"}) : GlProgram::load({kFiles[i]});
    if (!program) return program.error();
    programs.programs_[i] = std::move(program).value();
  }
  return programs;
}

const char* nameOf(SurfacePart part) {
  constexpr std::array<const char*, kSurfaceParts> kNames{"skin",  "patch",   "project", "heights",
                                                          "folds", "normals", "drawn"};
  return kNames[static_cast<std::size_t>(part)];
}

}  // namespace sinew::app
