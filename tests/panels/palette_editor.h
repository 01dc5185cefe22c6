// tests/panels/palette_editor.h: editor on the flexing humanoid, driven through the palette.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/editor/headless_editor.h"

namespace sinew::app {

class PaletteEditor : public HeadlessEditor {
 protected:
  void openFlexing() {
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid-flex.rig.json"));
    state.open.transport.playing = false;
    settle();
  }
  void ask(const std::string& words) {
    run(action("help/palette"), state);
    settle();
    type(words);
  }
  /// Height on the screen; a row that is not shown ranks below all others.
  [[nodiscard]] float rank(const std::string& id) const { return shown(id) ? center(id).y : 1e6f; }
};

}  // namespace sinew::app
