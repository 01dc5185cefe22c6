// app/editor/edit.cpp: edits into the history, refusals to the user.
#include "app/editor/edit.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/document/command_stack.h"

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
  const std::string text = error.plainText();
  // While a value is typed, sayRefusedField() reports it later.
  if (state.open.gestureItem != 0) {
    state.open.refusal = text;
    return;
  }
  sayRefusal(state, text);
  if (text == state.open.refusal) return;
  state.open.refusal = text;
  addQuietly(state.session, MessageKind::kError, text);
}

void sayRefusedField(EditorState& state) {
  if (state.open.refusal.empty()) return;
  sayRefusal(state, state.open.refusal);
  addQuietly(state.session, MessageKind::kError, state.open.refusal);
}

void say(EditorState& state, const std::string& text) { state.session.toast = Toast{text, false, state.frame.now}; }

void sayRefusal(EditorState& state, const std::string& text) {
  state.session.toast = Toast{text, true, state.frame.now};
}

void keepPose(EditorState& state, const std::string& label) {
  state.document.commands.applyPose(label, state.open.transport.overrides);
  state.open.refusal.clear();
}

void keepPlayRange(EditorState& state) {
  const Transport& transport = state.open.transport;
  std::string label = "Play the whole clip";
  if (hasPlayRange(transport)) {
    const PlayRange range = playRange(transport, state.character());
    const auto frame = [](double time) { return std::to_string(std::lround(time / kFrameSeconds)); };
    label = "Play frames " + frame(range.from) + " to " + frame(range.to);
  }
  state.document.commands.applyRanges(label, keptRanges(transport.ranges, state.character()));
  state.open.refusal.clear();
}

void addMessage(SessionState& session, MessageKind kind, const std::string& text, MessageAbout about) {
  session.messagesShown = true;
  ++session.messagesSaid;
  std::vector<Message>& messages = session.messages;
  const auto same = std::ranges::find_if(
      messages, [&](const Message& message) { return message.kind == kind && message.text == text; });
  if (same == messages.end()) {
    messages.push_back({kind, text, 1, about});
    return;
  }
  ++same->count;
  std::rotate(same, same + 1, messages.end());
}

void addQuietly(SessionState& session, MessageKind kind, const std::string& text, MessageAbout about) {
  const bool shown = session.messagesShown;
  addMessage(session, kind, text, about);
  session.messagesShown = shown;
}

void forgetDocumentMessages(SessionState& session) {
  std::erase_if(session.messages, [](const Message& message) { return message.about == MessageAbout::kDocument; });
}

}  // namespace sinew::app
