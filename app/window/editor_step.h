// app/window/editor_step.h: one frame of the editor without a window: keys and panels, tools, pose, surface.
#pragma once

#include <cstddef>
#include <utility>

#include "app/editor/editor_state.h"
#include "app/ui/input_queue.h"
#include "app/ui/style.h"
#include "app/ui/widget_log.h"

namespace sinew::app {

/// Everything from input to picture, without window or OpenGL, for tests. Call between ImGui's NewFrame and Render.
class EditorStep {
 public:
  /// @param seconds  since the last frame
  void run(EditorState& state, const RawInput& input, const Fonts& fonts, double seconds);

  /// Controls of the last frame.
  [[nodiscard]] const WidgetLog& widgets() const { return widgets_; }
  /// Seconds until the interface wants another frame without input; 0: never.
  [[nodiscard]] double wakeAfter() const { return wakeAfter_; }
  /// The camera moved in the last frame.
  [[nodiscard]] bool cameraMoves() const { return cameraMoves_; }

 private:
  bool runInterface(EditorState& state, const RawInput& input, const Fonts& fonts);
  void runTools(EditorState& state, const RawInput& input, bool viewportFree, double seconds);
  void updateSurface(EditorState& state);

  WidgetLog widgets_;
  double wakeAfter_ = 0.0;
  bool cameraMoves_ = false;
  bool viewportFree_ = true;                      ///< runInterface() of the last frame.
  std::pair<std::size_t, std::size_t> prepared_;  ///< Document and revision of the last frame.
};

}  // namespace sinew::app
