// app/editor/action_table_window.cpp: the Window menu: panels, and what is remembered.

#include "app/editor/action_table.h"

namespace sinew::app::table {
namespace {

template <bool LayoutState::*kFlag>
bool isPanelShown(const State& s) {
  return s.view.layout.*kFlag;
}
template <bool LayoutState::*kFlag>
void togglePanelShown(State& s) {
  s.view.layout.*kFlag = !(s.view.layout.*kFlag);
}

bool pictureAlone(const State& s) {
  return !s.view.layout.leftShown && !s.view.layout.rightShown && !s.view.layout.bottomShown;
}
void togglePictureAlone(State& s) {
  const bool all = pictureAlone(s);
  s.view.layout.leftShown = s.view.layout.rightShown = s.view.layout.bottomShown = all;
}
Possible hasMessages(const State& s) { return {!s.session.messages.empty(), "There are no messages"}; }
bool messagesShown(const State& s) { return s.session.messagesShown; }
void toggleMessages(State& s) { s.session.messagesShown = !s.session.messagesShown; }
void resetLayout(State& s) { s.view.layout = {}; }

using L = LayoutState;

const Action kWindowActions[] = {
    {"window/left", "Left panels", "Bones, muscles and history", key(GLFW_KEY_T), kNone, always,
     isPanelShown<&L::leftShown>, togglePanelShown<&L::leftShown>},
    {"window/right", "Right panels", "The selected muscle, surface and smoothing", key(GLFW_KEY_N), kNone, always,
     isPanelShown<&L::rightShown>, togglePanelShown<&L::rightShown>},
    {"window/bottom", "Timeline", "The clip and its time", ctrl(GLFW_KEY_T), kNone, always,
     isPanelShown<&L::bottomShown>, togglePanelShown<&L::bottomShown>},
    {"window/picture", "Only the picture", "Hide all panels, or show them again", ctrl(GLFW_KEY_SPACE), kNone, always,
     pictureAlone, togglePictureAlone},
    {"window/messages", "Messages", "What an import left out, and what failed", kNone, kNone, hasMessages,
     messagesShown, toggleMessages, true},
    {"window/reset-layout", "Reset layout", "Return the panels to their default places and sizes", kNone, kNone, always,
     nullptr, resetLayout, true},
};

}  // namespace

std::span<const Action> windowActions() { return kWindowActions; }

}  // namespace sinew::app::table
