// app/editor/export_commands.cpp: from the dialogs to a background export or a job's file.
#include "app/editor/export_commands.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "app/document/export_report.h"
#include "app/document/folder_listing.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/export_error.h"
#include "app/editor/session.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr int kMostTasksAtFirst = 16;  ///< As `sinew farm` without --tasks.

bool isFarm(const ExportDialogState& dialog) { return dialog.shown == ExportDialog::kFarmJob; }

std::string muscledName(const std::string& stem, const ExportKind& kind) {
  return stem + "_muscled" + usualEnding(kind);
}

/// Replaces the former kind's usual ending.
void giveEnding(ExportPlace& place, const ExportKind& former, const ExportKind& kind) {
  const fs::path name = place.name;
  if (name.empty()) return;
  if (withExportEnding(name, kind) != name || name.extension() == usualEnding(former)) {
    place.name = fs::path(name).replace_extension(usualEnding(kind)).string();
  }
}

fs::path absoluteRig(const Document& document) {
  std::error_code ignored;
  return fs::absolute(document.rigFile, ignored).lexically_normal();
}

const FarmTarget& targetOf(const ExportDialogState& dialog) { return *findFarmTarget(dialog.target); }

/// Resets places and clips for another document.
void startWith(EditorState& state) {
  ExportDialogState& dialog = state.dialogs.exporting;
  if (dialog.of == state.document.file()) return;
  dialog.of = state.document.file();
  const fs::path folder = workFolder(dialog.of);
  const ExportKind& kind = chosenKind(state.dialogs);
  const std::string stem = nameWithoutEnding(dialog.of);
  dialog.place = {folder, muscledName(stem, kind)};
  dialog.pattern = {folder, muscledName("{name}", kind)};
  dialog.job = {folder, stem + "_export" + targetOf(dialog).ending};
  dialog.settings.clips.clear();
  dialog.settings.detail = {};
  dialog.chosenClips = dialog.wholeFolder = false;
  dialog.tasks = 0;
}

void showDialog(EditorState& state, ExportDialog which) {
  startWith(state);
  ExportDialogState& dialog = state.dialogs.exporting;
  dialog.shown = which;
  dialog.overwriteAsked = false;
  dialog.error.clear();
}

fs::path resolved(const ExportPlace& place) { return resolveTyped(place.folder, place.name).lexically_normal(); }

/// Why a file cannot be written there, or "".
std::string placeError(const ExportPlace& place, const fs::path& file) {
  std::error_code ignored;
  if (place.name.empty() || !file.has_filename()) return "It needs a name";
  if (!fs::is_directory(file.parent_path(), ignored)) return "There is no folder " + file.parent_path().string();
  if (fs::is_directory(file, ignored)) return file.filename().string() + " is a folder";
  return "";
}

/// A job, its file, and the list of rigs beside it.
struct FarmFiles {
  FarmJob job;
  fs::path file;
  fs::path list;  ///< "" for a single rig.
  std::string listText;
  std::vector<fs::path> replaced;  ///< Existing exports.
};

/// Output for one rig of a folder.
fs::path outputOf(const fs::path& pattern, const fs::path& rig) {
  constexpr std::string_view kField = "{name}";
  std::string name = pattern.filename().string();
  if (const std::size_t at = name.find(kField); at != std::string::npos) {
    name.replace(at, kField.size(), nameWithoutEnding(rig));
  }
  return pattern.parent_path() / name;
}

FarmFiles farmFiles(const EditorState& state) {
  const ExportDialogState& dialog = state.dialogs.exporting;
  const ExportKind& kind = chosenKind(state.dialogs);
  FarmFiles farm;
  farm.file = resolved(dialog.job);
  farm.job.program = thisProgram();
  farm.job.folder = absoluteRig(state.document).parent_path();
  farm.job.arguments = {"export"};
  const std::vector<fs::path> rigs = farmRigs(state);
  if (dialog.wholeFolder) {
    farm.list = fs::path(farm.file).replace_extension(".list.txt");
    farm.listText = listText(farm.job.folder, rigs);
    farm.job.arguments.insert(farm.job.arguments.end(), {"--list", pathWord(farm.job.folder, farm.list)});
  } else {
    farm.job.arguments.push_back(pathWord(farm.job.folder, rigs.front()));
  }
  for (std::string& word : exportArguments(kind, chosenSettings(state))) farm.job.arguments.push_back(std::move(word));
  const fs::path out = withExportEnding(resolved(dialog.wholeFolder ? dialog.pattern : dialog.place), kind);
  farm.job.arguments.insert(farm.job.arguments.end(), {"-o", pathWord(farm.job.folder, out)});
  farm.job.tasks = farmTasks(state);
  for (const fs::path& rig : rigs) {
    for (fs::path& there : replacedByExport(outputOf(out, rig))) farm.replaced.push_back(std::move(there));
  }
  farm.job.resume = farm.replaced.empty();  // Resuming would keep existing exports.
  return farm;
}

/// The largest needs of all rigs of the job. Error: one of them cannot be exported.
Result<TaskNeeds> needsOf(const EditorState& state) {
  const ExportKind& kind = chosenKind(state.dialogs);
  const ExportSettings settings = chosenSettings(state);
  TaskNeeds needs;
  for (const fs::path& rig : farmRigs(state)) {
    const auto document = openDocument(rig);
    if (!document) return document.error();
    ExportSource source{document->characterFile, document->character, document->rig(), rig};
    if (const auto able = checkExportSource(kind, source, settings); !able) return able.error();
    settings.detail.apply(source.rig.smoothing);
    const auto own = taskNeeds("export", source.character, source.rig, 0, heldFrames(kind, source.character, settings));
    if (!own) return own.error();
    needs = larger(needs, own.value());
  }
  return needs;
}

std::string writeFarmJob(EditorState& state) {
  FarmFiles farm = farmFiles(state);
  const FarmTarget& target = targetOf(state.dialogs.exporting);
  const Result<TaskNeeds> needs = needsOf(state);
  if (!needs) return needs.error().plainText();
  farm.job.needs = needs.value();
  const Result<std::string> text = target.write(farm.job);
  if (!text) return text.error().plainText();
  std::vector<NamedBytes> files{{farm.file, text.value()}};
  if (!farm.list.empty()) files.push_back({farm.list, farm.listText});
  if (const auto written = writeFilesAtomically(files); !written) return written.error().plainText();
  const char* replaces = farm.replaced.empty() ? "" : "; it replaces the files that are there";
  say(state, "Farm job written: " + farm.file.string() + replaces + "; run it with " + target.runWith);
  return "";
}

void startExport(EditorState& state, const fs::path& file) {
  const Document& document = state.document;
  state.session.exports.add({&chosenKind(state.dialogs),
                             {document.characterFile, document.character, document.rig()},
                             chosenSettings(state),
                             file});
  const std::size_t before = state.session.exports.stands().size() - 1;
  const std::string name = file.filename().string();
  say(state, before == 0 ? "Exporting " + name + " in the background" : name + " is exported next");
}

/// The exported file; "" without a name.
fs::path outOf(Dialogs& dialogs) {
  const ExportPlace& place = placeOf(dialogs, DialogKind::kExportPlace);
  return place.name.empty() ? fs::path() : withExportEnding(resolved(place), chosenKind(dialogs));
}

/// Why the dialog's choices cannot be exported, or "".
std::string refusalOf(EditorState& state, const ExportPlace& place, const fs::path& out) {
  const ExportDialogState& dialog = state.dialogs.exporting;
  if (std::string error = placeError(place, out); !error.empty()) return error;
  const bool whole = isFarm(dialog) && dialog.wholeFolder;
  if (whole && out.filename().string().find("{name}") == std::string::npos) {
    return "The name needs {name}, which stands for the name of each rig";
  }
  if (chosenKind(state.dialogs).fields.oneClip) {
    if (whole) return "Other rigs have other clips: this kind is for the open rig alone";
    if (chosenSettings(state).clips.empty()) return "The character has no clips";
  }
  if (!whole && dialog.chosenClips && chosenSettings(state).clips.empty()) return "Choose a clip, or all clips";
  return isFarm(dialog) ? placeError(dialog.job, resolved(dialog.job)) : "";
}

std::pair<std::size_t, std::size_t> editedSoFar(const EditorState& state) {
  return {state.session.documentsOpened, state.document.commands.revision()};
}

void tell(EditorState& state, const ExportOutcome& outcome) {
  const std::string name = outcome.file.filename().string();
  if (outcome.result.ok() && outcome.order.pictures) {
    say(state, "Saved " + outcome.file.string());
    addQuietly(state.session, MessageKind::kNote, "Saved " + outcome.file.string(), MessageAbout::kProgram);
  } else if (outcome.result.ok()) {
    keepExport(state, outcome);
    const std::string figures = exportFigures(outcome.result.value());
    say(state, "Exported " + name + ": " + figures);
    std::string text = "Exported " + outcome.file.string() + ": " + figures;
    for (const std::string& left : leftOut(outcome.result.value())) text += "\nleft out: " + left;
    addQuietly(state.session, MessageKind::kNote, text, MessageAbout::kProgram);
  } else if (outcome.canceled) {
    say(state, "Cancelled: " + name + " was not written");
  } else {
    const char* what = outcome.order.pictures ? "Not drawn: " : "Not exported: ";
    addMessage(state.session, MessageKind::kError, what + outcome.result.error().plainText(), MessageAbout::kProgram);
    state.session.quitAfterExports.reset();  // Stay open for the message.
  }
}

}  // namespace

bool rigIsSaved(const EditorState& state) {
  return !state.document.rigFile.empty() && !state.document.commands.modified();
}

void showExportDialog(EditorState& state) { showDialog(state, ExportDialog::kCharacter); }
void showFarmDialog(EditorState& state) {
  showDialog(state, ExportDialog::kFarmJob);
  ExportDialogState& dialog = state.dialogs.exporting;
  dialog.rigs = rigsIn(absoluteRig(state.document).parent_path());
  if (dialog.rigs.size() < 2) dialog.wholeFolder = false;
}

void closeExportDialog(Dialogs& dialogs) {
  dialogs.exporting.shown = ExportDialog::kNone;
  dialogs.exporting.overwriteAsked = false;
  dialogs.exporting.error.clear();
}

const ExportKind& chosenKind(const Dialogs& dialogs) { return exportKinds()[dialogs.exporting.kind]; }

void chooseKind(Dialogs& dialogs, std::size_t kind) {
  const ExportKind& former = chosenKind(dialogs);
  dialogs.exporting.kind = kind;
  giveEnding(dialogs.exporting.place, former, chosenKind(dialogs));
  giveEnding(dialogs.exporting.pattern, former, chosenKind(dialogs));
}

void chooseTarget(Dialogs& dialogs, const FarmTarget& target) {
  ExportDialogState& dialog = dialogs.exporting;
  fs::path name = dialog.job.name;
  if (name.extension() == targetOf(dialog).ending) dialog.job.name = name.replace_extension(target.ending).string();
  dialog.target = target.word;
}

std::string chosenOneClip(const EditorState& state) {
  const std::vector<std::string> names = exportableClips(chosenKind(state.dialogs), state.character());
  if (names.empty()) return {};
  const auto isOffered = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
  const std::string& chosen = state.dialogs.exporting.oneClip;
  if (isOffered(chosen)) return chosen;
  const int playing = state.open.transport.clip;
  if (playing < 0 || !isOffered(at(state.character().clips, playing).name)) return names.front();
  return at(state.character().clips, playing).name;
}

ExportSettings chosenSettings(const EditorState& state) {
  const ExportDialogState& dialog = state.dialogs.exporting;
  ExportSettings settings = dialog.settings;
  settings.clips.clear();
  const bool whole = isFarm(dialog) && dialog.wholeFolder;
  if (chosenKind(state.dialogs).fields.oneClip) {
    if (const std::string clip = chosenOneClip(state); !clip.empty() && !whole) settings.clips.push_back(clip);
    return settings;
  }
  if (!dialog.chosenClips || whole) return settings;
  for (const std::string& name : exportableClips(chosenKind(state.dialogs), state.character())) {
    if (std::ranges::count(dialog.settings.clips, name) > 0) settings.clips.push_back(name);
  }
  return settings;
}

ExportPlace& placeOf(Dialogs& dialogs, DialogKind kind) {
  ExportDialogState& dialog = dialogs.exporting;
  if (kind == DialogKind::kJobPlace) return dialog.job;
  return isFarm(dialog) && dialog.wholeFolder ? dialog.pattern : dialog.place;
}

void browseForPlace(EditorState& state, DialogKind kind) {
  const fs::path file = resolved(placeOf(state.dialogs, kind));
  state.dialogs.exporting.overwriteAsked = false;
  showPathDialog(state, kind, file.parent_path(), file.filename().string());
}

void takePlace(Dialogs& dialogs, DialogKind kind, const fs::path& file) {
  ExportPlace& place = placeOf(dialogs, kind);
  place = {file.parent_path(), file.filename().string()};
  if (kind == DialogKind::kExportPlace) {
    place.name = withExportEnding(place.name, chosenKind(dialogs)).string();
  } else if (!file.has_extension()) {
    place.name += targetOf(dialogs.exporting).ending;
  }
  dialogs.exporting.error.clear();
}

std::vector<fs::path> farmRigs(const EditorState& state) {
  if (state.dialogs.exporting.wholeFolder) return state.dialogs.exporting.rigs;
  return {absoluteRig(state.document)};
}

int farmTasks(const EditorState& state) {
  const int wanted = state.dialogs.exporting.tasks;
  const int most = std::clamp(static_cast<int>(farmRigs(state).size()), 1, kMostTasks);
  return wanted == 0 ? std::min(most, kMostTasksAtFirst) : std::clamp(wanted, 1, most);
}

std::vector<fs::path> replacedFiles(EditorState& state) {
  if (!isFarm(state.dialogs.exporting)) return replacedByExport(outOf(state.dialogs));
  const FarmFiles farm = farmFiles(state);
  std::vector<fs::path> files{farm.file};
  if (!farm.list.empty()) files.push_back(farm.list);
  std::error_code failed;
  std::erase_if(files, [&](const fs::path& file) { return !fs::exists(file, failed); });
  files.insert(files.end(), farm.replaced.begin(), farm.replaced.end());
  return files;
}

bool confirmExport(EditorState& state) {
  ExportDialogState& dialog = state.dialogs.exporting;
  const fs::path out = outOf(state.dialogs);
  dialog.error = refusalOf(state, placeOf(state.dialogs, DialogKind::kExportPlace), out);
  if (!dialog.error.empty()) return false;
  if (!dialog.overwriteAsked && !replacedFiles(state).empty()) {
    dialog.overwriteAsked = true;
    return false;
  }
  if (isFarm(dialog)) dialog.error = writeFarmJob(state);
  else startExport(state, out);
  dialog.overwriteAsked = false;
  if (!dialog.error.empty()) return false;
  closeExportDialog(state.dialogs);
  return true;
}

void followExports(EditorState& state) {
  for (const ExportOutcome& outcome : state.session.exports.takeDone()) tell(state, outcome);
  if (!state.session.quitAfterExports || !state.session.exports.empty()) return;
  const Intent quit{IntentKind::kQuit, {}};
  if (std::exchange(state.session.quitAfterExports, std::nullopt) == editedSoFar(state)) perform(state, quit);
  else request(state, quit);
}

void quitAfterExports(EditorState& state) { state.session.quitAfterExports = editedSoFar(state); }

}  // namespace sinew::app
