// app/editor/dialog_state.h: which dialogs are open, and what has been typed into them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/file_stamp.h"
#include "app/document/folder_listing.h"
#include "app/editor/export_state.h"

namespace sinew::app {

/// What waits for "save your changes?" or for a path.
enum class IntentKind { kNone, kOpenFile, kOpenWithMuscles, kAddClips, kReopen, kRecover, kQuit };
struct Intent {
  IntentKind kind = IntentKind::kNone;
  std::filesystem::path file;  ///< To open; kRecover: of LeftBehind.
};

/// The dialogs of exports only choose a place, kReference a picture to work after.
enum class DialogKind { kNone, kOpen, kSaveAs, kSavePicture, kExportPlace, kJobPlace, kPicturesPlace, kReference };

/// The path dialog.
struct FileDialogState {
  DialogKind kind = DialogKind::kNone;
  std::filesystem::path folder;
  std::string text;                 ///< The path field.
  std::string error;                ///< Why the last try failed.
  bool appearing = false;           ///< The path field takes the keyboard with the next frame.
  Intent then;                      ///< After a successful Save As; Open: what is done with the file, if not opened.
  std::filesystem::path locateFor;  ///< Open: not any file but the character of this rig.
  std::string clipsFor;             ///< kAddClips: the entry of Rig::clipFiles that is gone; "": one more.
  FileFilter filter = FileFilter::kAll;
  std::vector<std::filesystem::path> back;     ///< Folders before this one, oldest first.
  std::vector<std::filesystem::path> forward;  ///< Folders that were left by going back, nearest last.
  bool overwriteAsked = false;                 ///< "Replace it?" is on the screen.
  bool naming = false;                         ///< A new folder's name is being typed.
  std::string newFolder;
  FolderListing listing;  ///< The folder's, as last read.
  bool reveal = false;    ///< The list scrolls to the file that the field names.
};

/// A rig whose character is not where the rig says: asking what to do.
struct LocateState {
  std::filesystem::path rigFile;  ///< "": not asking.
  std::filesystem::path characterFile;
};

/// A muscle of a set that fits this kind of body; without a muscle the whole set.
struct SetEntry {
  std::string set;
  std::string muscle;
};

/// The command palette.
struct PaletteState {
  bool shown = false;
  bool appearing = false;  ///< The search field takes the keyboard with the next frame.
  std::string query;
  int chosen = -1;             ///< Row that was chosen with the arrows; -1: none, Enter takes the best one.
  std::vector<SetEntry> sets;  ///< Read when the palette opens.
};

/// A control that is brought into sight, gets the keyboard and is marked for a moment.
struct RevealState {
  std::string id;       ///< As WidgetLog knows it; "": none.
  int tries = 0;        ///< Frames in which it was not there yet.
  double until = -1.0;  ///< The mark goes then, on FrameState::now; less than 0: it has not been seen yet.
};

/// "Your file has changed on disk": waits for which version is to stay.
struct ConflictQuestion {
  OnDisk found = OnDisk::kSame;  ///< kSame: not asking.
  Intent then;                   ///< After the answer.
};

/// Which part of the preferences is shown.
enum class PreferencesPage { kGeneral, kKeys };

/// Another key for an action: waiting for it, or asking what to do as it is taken.
struct KeyCapture {
  enum class Step { kNone, kWaiting, kAsking };
  Step step = Step::kNone;
  std::string action;  ///< Id.
  int slot = 0;        ///< Its first or second key.
  std::string key;     ///< Asked about, as "Ctrl+D"; "": about a reset.
  std::string notice;  ///< The question, or why the last key was refused.
};

struct Dialogs {
  FileDialogState file;
  LocateState locate;
  ConflictQuestion conflict;
  Intent question;                    ///< Asking about unsaved changes before this; kNone: not asking.
  std::filesystem::path keepMuscles;  ///< A character that was dropped: asking whether it gets the muscles. "": not.
  bool droppedHasClips = false;       ///< ... or whether its clips are added here.
  ExportDialogState exporting;
  PicturesDialogState pictures;
  bool exportQuestion = false;  ///< Asking whether to quit though exports are not done.
  PaletteState palette;
  RevealState reveal;
  bool keySheet = false;
  bool preferences = false;
  PreferencesPage preferencesPage = PreferencesPage::kGeneral;
  std::string keySearch;  ///< Typed above the list of keys.
  KeyCapture keyCapture;
  bool recovery = false;  ///< What a crash left behind is being offered.
};

}  // namespace sinew::app
