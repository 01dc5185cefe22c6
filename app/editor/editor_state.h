// app/editor/editor_state.h: all that the editor remembers between frames, as plain data, by how long it lives.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/document/document.h"
#include "app/document/playback.h"
#include "app/editor/dialog_state.h"
#include "app/editor/document_view.h"
#include "app/editor/session_state.h"
#include "app/editor/view_state.h"

namespace sinew::app {

/// Made anew in each frame.
struct FrameState {
  RouteResult route;             ///< What the viewport's tools did.
  std::vector<int> highlighted;  ///< Rig indices of muscles that a panel's hover lights up.
  int hoveredPart = -1;          ///< Index into Character::parts, of the part that a panel's hover lights up.
  glm::vec4 viewport{0.0f};      ///< x, y, width, height in window coordinates; of the last layout.
  glm::ivec2 viewportPixels{1, 1};
  std::vector<glm::vec4> covered;  ///< Parts of the picture under panels: low x and y, high x and y, 0..1 of it.
  double now = 0.0;                ///< Seconds on a clock that only grows.
  int pictureSamples = 0;          ///< That the shown picture is the mean of; 1 while something moves.
  float pictureScale = 1.0f;       ///< Pixels of the shown picture per pixel of the viewport, along an edge.
  float uiScale = 1.0f;            ///< Window coordinates per design pixel.
  bool arrowsTaken = false;        ///< A list with the focus uses Up and Down; of the last frame.
  float systemScale = 1.0f;        ///< What it would be if the system alone were asked.
};

/// Panels read it and change it through the commands of this directory; the rig only through the command stack.
struct EditorState {
  Document document;
  std::optional<LiveSurface> live;  ///< The document's surface; none without a character.
  DocumentView open;                ///< Begins anew with each document.
  ViewState view;                   ///< Stays when another document is opened.
  Dialogs dialogs;
  SessionState session;
  FrameState frame;

  [[nodiscard]] bool hasCharacter() const { return document.character != nullptr && live.has_value(); }
  [[nodiscard]] const Character& character() const { return *document.character; }
};

}  // namespace sinew::app
