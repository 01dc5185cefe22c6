// app/editor/edit.cpp: edits into the history, refusals to the user.

#include "app/editor/edit.h"

#include <utility>

namespace sinew::app {

bool edit(EditorState& state, const std::string& label, Result<Rig> rig) {
  if (!rig) {
    refuse(state, rig.error());
    return false;
  }
  state.open.refusal.clear();
  CommandStack& commands = state.document.commands;
  if (commands.inGesture() && state.open.gestureItem != 0) {
    commands.updateGesture(std::move(rig).value());
  } else {
    commands.apply(label, std::move(rig).value());
  }
  return true;
}

void refuse(EditorState& state, const Error& error) {
  state.open.refusal = error.text();
  // The status line has it: the list need not open.
  const bool shown = state.session.messagesShown;
  addMessage(state.session, MessageKind::kError, error.text());
  state.session.messagesShown = shown;
}

void keepPose(EditorState& state, const std::string& label) {
  state.document.commands.applyPose(label, state.open.transport.overrides);
  state.open.refusal.clear();
}

void addMessage(SessionState& session, MessageKind kind, const std::string& text) {
  session.messagesShown = true;
  for (Message& message : session.messages) {
    if (message.kind == kind && message.text == text) {
      ++message.count;
      return;
    }
  }
  session.messages.push_back({kind, text, 1});
}

}  // namespace sinew::app
