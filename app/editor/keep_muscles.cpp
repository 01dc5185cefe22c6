// app/editor/keep_muscles.cpp: the muscles of the open rig on another character.
#include "app/editor/keep_muscles.h"

#include <string>
#include <utility>

#include "app/document/character_files.h"
#include "app/document/damaged_file.h"
#include "app/document/document.h"
#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/open_file.h"
#include "core/bodies/retarget.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

bool isCharacter(const std::filesystem::path& file) { return isCharacterName(lowerCase(file.filename().string())); }

std::string counted(std::size_t count, const char* one) {
  return std::to_string(count) + ' ' + one + (count == 1 ? "" : "s");
}

/// What was done, in one line; the list of messages has each muscle.
void tell(EditorState& state, const Retargeted& done) {
  for (const auto& [name, why] : done.leftOut)
    addQuietly(state.session, MessageKind::kWarning, name + " is left out: " + why);
  for (const std::string& line : done.mended) addQuietly(state.session, MessageKind::kNote, "Mended " + line);
  std::string text = counted(done.rig.primitives.size(), "muscle") + " kept";
  if (!done.leftOut.empty()) text += ", " + std::to_string(done.leftOut.size()) + " left out";
  if (!done.mended.empty()) text += ", " + std::to_string(done.mended.size()) + " mended";
  say(state, text + (done.leftOut.empty() && done.mended.empty() ? "" : ": see the messages"));
}

}  // namespace

void dropFile(EditorState& state, const std::filesystem::path& file) {
  if (!isCharacter(file) || !state.hasCharacter()) return request(state, {IntentKind::kOpenFile, file});
  const DroppedClips clips = lookForClips(state.document, file);
  if (clips.nothingElse) {
    addClips(state, file);
  } else if (!state.document.rig().primitives.empty()) {
    state.dialogs.keepMuscles = file;
    state.dialogs.droppedHasClips = clips.any;
  } else {
    request(state, {IntentKind::kOpenFile, file});
  }
}

void showRetargetDialog(EditorState& state) {
  showOpenDialog(state);
  state.dialogs.file.then = {IntentKind::kOpenWithMuscles, {}};
  state.dialogs.file.filter = FileFilter::kCharacters;
}

void openWithMuscles(EditorState& state, const std::filesystem::path& file) {
  Result<Document> opened = openDocument(file);
  if (!opened) return addMessage(state.session, MessageKind::kError, openErrorText(opened.error()));
  const Document& from = state.document;
  Result<Retargeted> done =
      retarget(from.rig(), *from.character, *from.mirror, Motions(opened->character), *opened->mirror);
  if (!done) {
    const Error error{file.string(), "", done.error().reason, "cannot take the muscles"};
    return addMessage(state.session, MessageKind::kError, error.plainText());
  }
  Rig rig = done->rig;
  rig.character = opened->rig().character;
  Document document = std::move(opened).value();
  document.commands.apply("Muscles of " + from.name(), std::move(rig));
  if (showDocument(state, std::move(document))) tell(state, done.value());
}

}  // namespace sinew::app
