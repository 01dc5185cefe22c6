// app/viewport/gpu/stages.h: the stages of a surface as compute shaders, in the order in which they run.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>

#include "app/viewport/render/gl_objects.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

enum class Stage {
  kSkin,
  kPatch,
  kFlatPatch,  ///< The same with the lines of `replace`.
  kReplace,
  kSwell,
  kSwellExact,
  kSwellShaped,
  kPlace,
  kNear,
  kCreaseFront,
  kCrease,
  kSlope,
  kLower,
  kBend,
  kWeigh,
  kFilter,
  kFoldStart,
  kSpreadAsk,
  kSpreadMove,
  kFoldHeight,
  kRims,
  kSoften,
  kHold,
  kTeeth,
  kEven,
  kDrawn
};
inline constexpr std::size_t kStages = static_cast<std::size_t>(Stage::kDrawn) + 1;

/// The shaders, compiled. Serve any number of surfaces of one context.
class StagePrograms {
 public:
  /// Error: the driver lacks OpenGL 4.5, or refuses a shader.
  [[nodiscard]] static Result<StagePrograms> create();
  [[nodiscard]] const GlProgram& of(Stage stage) const { return programs_[static_cast<std::size_t>(stage)]; }

 private:
  std::array<GlProgram, kStages> programs_;
};

}  // namespace sinew::app
