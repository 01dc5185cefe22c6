// app/ui/widget_log.h: where every control is on the screen, by a stable name, for --log-state.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace sinew::app {

/// A control as it was laid out, for tests of the layout: what is cut off is here as well.
struct LaidOut {
  std::string id;
  std::string window;       ///< ImGui's name of the window it is in.
  glm::vec4 whole{0.0f};    ///< x, y, width, height in window coordinates, as if nothing cut it off.
  glm::vec4 visible{0.0f};  ///< The visible part of that; width or height 0: nothing.
  bool scrollsX = false;    ///< What is cut off can be scrolled to, in its window or one around it.
  bool scrollsY = false;
  unsigned item = 0;   ///< ImGui's id; 0: a text.
  bool usable = true;  ///< Neither grayed nor for the mouse alone.
};

/// Rectangles x, y, width, height in window coordinates of the controls drawn in this frame, visible part only.
class WidgetLog {
 public:
  void beginFrame();
  /// Right after an ImGui item. Items clipped away are left out. Names say place and control: "timeline/play".
  void note(const std::string& id);
  /// The same for something drawn by hand.
  void note(const std::string& id, const glm::vec4& rectangle);

  [[nodiscard]] const std::map<std::string, glm::vec4>& rectangles() const { return rectangles_; }
  /// Every ImGui item that was noted, cut off or not.
  [[nodiscard]] const std::vector<LaidOut>& laidOut() const { return laidOut_; }
  /// The control of this name is scrolled into sight when it is noted next in this frame, and gets the keyboard if that
  /// is wanted. Right after beginFrame().
  void seek(const std::string& id, bool focus);
  /// Whether that has happened and it can be seen.
  [[nodiscard]] bool sought() const { return !sought_.empty() && rectangles_.contains(sought_); }
  /// The item gets the keyboard when it is noted next.
  void focusOn(unsigned item) { focusWanted_ = item; }

 private:
  std::map<std::string, glm::vec4> rectangles_;
  std::vector<LaidOut> laidOut_;
  std::string sought_;
  bool focusSought_ = false;
  unsigned focusWanted_ = 0;
};

}  // namespace sinew::app
