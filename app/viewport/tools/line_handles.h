// app/viewport/tools/line_handles.h: the ends of the active muscle's line, to be pulled about.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/viewport/tools/input.h"
#include "app/viewport/tools/viewport_context.h"

namespace sinew::app {

enum class LineEnd { kNone, kOrigin, kInsertion, kVia };

/// A pull of one end. It keeps its distance from the eye, and rides its bone while a clip plays.
struct LineEndDrag {
  LineEnd end = LineEnd::kNone;
  LineId line;
  glm::vec2 grip{0.0f};  ///< From the handle to the pointer, pixels.
};

struct LineHandles {
  LineEnd hovered = LineEnd::kNone;
  std::optional<LineEndDrag> drag;
};

/// The line of the active muscle in a pose, for drawing and for hits. World.
struct ShownLine {
  int index = -1;  ///< Into Rig::lines.
  glm::vec3 origin{0.0f};
  glm::vec3 insertion{0.0f};
  std::optional<glm::vec3> via;
  float stretch = 1.0f;
  float activation = 0.0f;
};

/// Nothing: the active muscle rides no line, or its line has no bones here.
[[nodiscard]] std::optional<ShownLine> activeLine(const Document& document, const Pose& pose);
[[nodiscard]] std::optional<glm::vec3> endPoint(const ShownLine& line, LineEnd end);

/// The end within a few pixels; of several the nearest.
[[nodiscard]] LineEnd lineEndUnder(const ViewportContext& context, const View& view, const glm::vec2& pixel);

/// Pulls the hovered end from now on.
void beginLineEnd(LineHandles& handles, const ViewportContext& context, const View& view, const glm::vec2& pixel);
/// @return false: the pull has ended: by a release (one undo step), or by Esc or the right button without a trace.
[[nodiscard]] bool continueLineEnd(LineHandles& handles, const ViewportInput& input, const ViewportContext& context,
                                   const View& view);

/// For the status line; empty where no end is hovered or pulled.
[[nodiscard]] std::string describe(const LineHandles& handles);
[[nodiscard]] const char* nameOf(LineEnd end);  ///< "origin"

}  // namespace sinew::app
