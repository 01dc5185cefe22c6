// app/ui/widget_log.h: where every control is on the screen, by a stable name, for --log-state.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace sinew::app {

/// Rectangles x, y, width, height in window coordinates of the controls drawn in this frame, visible part only.
class WidgetLog {
 public:
  void beginFrame();
  /// Right after an ImGui item. Items clipped away are left out. Names say place and control: "timeline/play".
  void note(const std::string& id);
  /// The same for something drawn by hand.
  void note(const std::string& id, const glm::vec4& rectangle);

  [[nodiscard]] const std::map<std::string, glm::vec4>& rectangles() const { return rectangles_; }
  /// Names used twice in this frame: a mistake that tests look for.
  [[nodiscard]] const std::vector<std::string>& repeated() const { return repeated_; }

 private:
  std::map<std::string, glm::vec4> rectangles_;
  std::vector<std::string> repeated_;
};

}  // namespace sinew::app
