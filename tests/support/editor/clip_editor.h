// tests/support/editor/clip_editor.h: a rig with a clip, to be keyed.
#pragma once

#include "app/document/playback.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {

/// Bundled rig, paused at the beginning of its first clip.
class ClipEditor : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    chooseClip(state.open.transport, 0, state.character());
    state.open.transport.playing = false;
    settle();
    opened = state.document.rig();
  }
  void goTo(double time) {
    state.open.transport.time = time;
    settle();
  }
  void undoAll() {
    while (state.document.commands.canUndo()) undo(state);
    settle();
  }

  static constexpr int kKeyK = 75;

  Rig opened;
};

}  // namespace sinew::app
