// app/editor/locate_character.cpp: a character in another place than the rig says.

#include "app/editor/locate_character.h"

#include <system_error>
#include <utility>

#include "app/editor/commands.h"
#include "app/editor/open_file.h"

namespace sinew::app {

void showLocateDialog(EditorState& state) {
  const LocateState asked = std::exchange(state.dialogs.locate, {});
  FileDialogState dialog;
  std::error_code ignored;
  dialog.kind = DialogKind::kOpen;
  dialog.locateFor = std::filesystem::absolute(asked.rigFile, ignored);
  dialog.folder = dialog.locateFor.parent_path();
  dialog.filter = FileFilter::kCharacters;
  dialog.appearing = true;
  const std::filesystem::path name = asked.characterFile.filename();
  if (std::filesystem::is_regular_file(dialog.folder / name, ignored)) dialog.text = name.string();
  state.dialogs.file = std::move(dialog);
}

std::string openWithCharacter(EditorState& state, const std::filesystem::path& rigFile,
                              const std::filesystem::path& characterFile) {
  Result<Document> opened = openRigWith(rigFile, characterFile);
  if (!opened) return opened.error().text();
  return showDocument(state, std::move(opened).value()) ? "" : state.session.messages.back().text;
}

}  // namespace sinew::app
