// app/window/state_log.h: --log-state: a JSON line for every frame that changed (docs/formats.md).
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "app/editor/editor_state.h"
#include "app/ui/widget_log.h"
#include "app/viewport/render/view.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

class StateLog {
 public:
  /// Appends to the file. Error: it cannot be opened.
  [[nodiscard]] static Result<StateLog> open(const std::filesystem::path& file);

  /// Writes and flushes a line if the state differs from the last line's.
  void write(const EditorState& state, const WidgetLog& widgets, const View& view, long long frame, double seconds);

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
  std::string last_;
};

}  // namespace sinew::app
