// app/ui/widget_log.h: where every control is on the screen, by id.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace sinew::app {

/// A control as laid out, even if it is cut off.
struct LaidOut {
  std::string id;
  std::string window;       ///< ImGui's name.
  glm::vec4 whole{0.0f};    ///< x, y, width, height in window coordinates.
  glm::vec4 visible{0.0f};  ///< The visible part; width or height 0: none.
  bool scrollsX = false;    ///< Its window, or one around it, can scroll.
  bool scrollsY = false;
  unsigned item = 0;   ///< ImGui's id; 0: a text.
  bool usable = true;  ///< Neither disabled nor for the mouse alone.
};

/// Controls of this frame: x, y, width, height of the visible part in window coordinates.
class WidgetLog {
 public:
  void beginFrame();
  void note(const std::string& id);  ///< Call right after an ImGui item. @param id  place and control: "timeline/play"
  void note(const std::string& id, const glm::vec4& rectangle);  ///< For what is drawn by hand.

  [[nodiscard]] const std::map<std::string, glm::vec4>& rectangles() const { return rectangles_; }
  /// Every noted ImGui item, cut off or not.
  [[nodiscard]] const std::vector<LaidOut>& laidOut() const { return laidOut_; }
  /// Scrolls the control into sight when it is noted in this frame, and focuses it. Call right after beginFrame().
  void seek(const std::string& id, bool focus);
  /// The sought control was noted and is visible.
  [[nodiscard]] bool sought() const { return !sought_.empty() && rectangles_.contains(sought_); }
  /// Focuses the item when it is noted next.
  void focusOn(unsigned item) { focusWanted_ = item; }

 private:
  std::map<std::string, glm::vec4> rectangles_;
  std::vector<LaidOut> laidOut_;
  std::string sought_;
  bool focusSought_ = false;
  unsigned focusWanted_ = 0;
};

}  // namespace sinew::app
