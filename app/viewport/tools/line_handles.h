// app/viewport/tools/line_handles.h: handles on the ends of the active muscle's line.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/viewport/tools/viewport_context.h"
#include "app/viewport/tools/viewport_input.h"

namespace sinew::app {

enum class LineEnd { kNone, kOrigin, kInsertion, kVia };

/// A drag of one end. It keeps its depth, and follows its bone while a clip plays.
struct LineEndDrag {
  LineEnd end = LineEnd::kNone;
  LineId line;
  glm::vec2 grip{0.0f};  ///< From the handle to the pointer, pixels.
};

struct LineHandles {
  LineEnd hovered = LineEnd::kNone;
  std::optional<LineEndDrag> drag;
};

/// World.
struct ShownLine {
  int index = -1;  ///< Into Rig::lines.
  glm::vec3 origin{0.0f};
  glm::vec3 insertion{0.0f};
  std::optional<glm::vec3> via;
  float stretch = 1.0f;
  float activation = 0.0f;
};

/// The line of the active muscle in a pose; nullopt: none, a sheet, or this character lacks its bones.
[[nodiscard]] std::optional<ShownLine> activeLine(const Document& document, const Pose& pose);
[[nodiscard]] std::optional<glm::vec3> endPoint(const ShownLine& line, LineEnd end);

/// The nearest end within a few pixels.
[[nodiscard]] LineEnd lineEndUnder(const ViewportContext& context, const View& view, const glm::vec2& pixel);

/// Starts a drag of the hovered end.
void beginLineEnd(LineHandles& handles, const ViewportContext& context, const View& view, const glm::vec2& pixel);
/// @return false: the drag has ended, by a release (one undo step) or canceled by Esc or the right button
[[nodiscard]] bool continueLineEnd(LineHandles& handles, const ViewportInput& input, const ViewportContext& context,
                                   const View& view);

/// For the status line; "" if no end is hovered or dragged.
[[nodiscard]] std::string describe(const LineHandles& handles);
[[nodiscard]] const char* nameOf(LineEnd end);  ///< "origin"

}  // namespace sinew::app
