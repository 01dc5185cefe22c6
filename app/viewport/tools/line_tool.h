// app/viewport/tools/line_tool.h: press on one bone's skin, release on another's: a muscle line grows between them.
#pragma once

#include <memory>
#include <optional>

#include "app/viewport/tools/input.h"
#include "app/viewport/tools/lay_line.h"
#include "app/viewport/tools/select.h"

namespace sinew::app {

/// A gesture in progress. The pose is held meanwhile, and the skin that was pressed is what the pointer meets.
struct LineDrag {
  Surface skin;  ///< As it was at the press.
  Surface bindSkin;
  SkinAnchor start;
  int startBone = -1;
  int endBone = -1;  ///< Under the pointer; -1: none.
  glm::vec2 pressPixel{0.0f};
  std::optional<LaidLine> laid;  ///< What is shown.
  Selection selectionBefore;
  std::shared_ptr<const Rig> rigBefore;
};

struct LineToolState {
  std::optional<LineDrag> drag;
};

/// Error: no skin under the pointer; then nothing has begun.
[[nodiscard]] Result<void> beginLine(LineToolState& state, const ViewportContext& context, const ViewportHover& hover,
                                     const glm::vec2& pixel);
/// Follows the pointer; ends on release (one undo step, none if no muscle was laid), cancels on Esc and the right
/// button. What is kept stays in the flesh in all clips.
/// @return  what was mended for that; empty: nothing
std::string updateLine(LineToolState& state, const ViewportInput& input, const ViewportContext& context,
                       const View& view);
/// Ends a gesture without a trace.
void cancelLine(LineToolState& state, Document& document);

}  // namespace sinew::app
