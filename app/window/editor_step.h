// app/window/editor_step.h: one frame of the editor without a window: input -> keys and panels -> tools -> pose ->
// surface.
#pragma once

#include <cstddef>
#include <utility>

#include "app/editor/editor_state.h"
#include "app/ui/input_queue.h"
#include "app/ui/style.h"
#include "app/ui/widget_log.h"

namespace sinew::app {

/// Everything between the input and the picture. Touches no window and no OpenGL: the window and the tests of the
/// panels run the same frame. Needs ImGui's context, between NewFrame and Render.
class EditorStep {
 public:
  /// @param seconds  since the frame before
  void run(EditorState& state, const RawInput& input, const Fonts& fonts, double seconds);

  /// Where the controls of the last frame are.
  [[nodiscard]] const WidgetLog& widgets() const { return widgets_; }
  /// Seconds until the interface wants another frame though nothing happens; 0: it does not.
  [[nodiscard]] double wakeAfter() const { return wakeAfter_; }
  /// The camera was on its way in the last frame.
  [[nodiscard]] bool cameraMoves() const { return cameraMoves_; }

 private:
  bool runInterface(EditorState& state, const RawInput& input, const Fonts& fonts);
  void runTools(EditorState& state, const RawInput& input, bool viewportFree, double seconds);
  void updateSurface(EditorState& state);

  WidgetLog widgets_;
  double wakeAfter_ = 0.0;
  bool cameraMoves_ = false;
  bool viewportFree_ = true;                      ///< The pointer was over the picture in the last frame.
  std::pair<std::size_t, std::size_t> prepared_;  ///< Document and revision of the last frame.
};

}  // namespace sinew::app
