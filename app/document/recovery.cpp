// app/document/recovery.cpp: unsaved work survives a crash.

#include "app/document/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "app/document/preferences.h"
#include "core/bodies/sheets/keep_sheets.h"
#include "core/files/clip_files.h"
#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "core/rig/rig_edit.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestRecovery = 128u << 20;
constexpr int kRecoveryTries = 1000;

fs::path lockOf(const fs::path& recovery) { return fs::path(recovery).replace_extension(".lock"); }

fs::path absolutePath(const fs::path& file) {
  std::error_code failed;
  return file.empty() ? file : fs::absolute(file, failed).lexically_normal();
}

/// The file was not removed between open and lock.
bool isStillThere(int descriptor, const fs::path& file) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(file.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
         opened.st_dev == named.st_dev;
}

/// Held if nobody else holds it. @param flags  O_CREAT makes the file
FileLock tryLock(const fs::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | flags, 0600);
  if (descriptor < 0) return {};
  FileLock lock(descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 || !isStillThere(descriptor, file)) return {};
  return lock;
}

std::string recoveryText(const Document& document) {
  Rig written = document.rig();
  const fs::path base = absolutePath(document.file());
  written.clipFiles = clipFilesFor(base, written.clipFiles, absolutePath(document.clipFiles.folder));
  const Result<Json> rig = Json::parse(rigToJson(written));
  return Json::object()
             .set("format", "sinew-recovery")
             .set("version", 1)
             .set("rig_file", absolutePath(document.rigFile).string())
             .set("rig_on_disk", textOfStamp(document.rigOnDisk))
             .set("character_file", absolutePath(document.characterFile).string())
             .set("rig", rig ? rig.value() : Json())
             .dump(true) +
         "\n";
}

Result<Json> readRecovery(const fs::path& file) {
  const Result<std::string> text = readWholeFile(file, kLargestRecovery);
  if (!text) return text.error();
  Result<Json> json = Json::parse(text.value());
  if (json && json->at("format").text("") != "sinew-recovery") return errorAt("format", "expected \"sinew-recovery\"");
  return json;
}

std::optional<LeftBehind> readLeftBehind(const fs::path& file) {
  const Result<Json> json = readRecovery(file);
  if (!json) return std::nullopt;
  LeftBehind left;
  left.file = file;
  left.rigFile = json->at("rig_file").text("");
  left.characterFile = json->at("character_file").text("");
  const Json& rig = json->at("rig");
  left.primitives = static_cast<int>(rig.at("primitives").items().size() + rig.at("sheets").items().size());
  std::error_code failed;
  left.when = fs::last_write_time(file, failed);
  if (failed || left.characterFile.empty()) return std::nullopt;
  return left;
}

/// The rig before the recovered edits: the one on disk, else an empty one.
Rig rigBefore(const LeftBehind& left, const Rig& recovered) {
  if (!left.rigFile.empty()) {
    if (Result<Rig> onDisk = loadRig(left.rigFile)) return std::move(onDisk).value();
  }
  Rig empty;
  empty.character = recovered.character;
  return empty;
}

}  // namespace

fs::path recoveryFolder() {
  if (const char* folder = std::getenv("XDG_STATE_HOME"); folder != nullptr && *folder == '/') {
    return fs::path(folder) / "sinew" / "recovery";
  }
  return configFolder() / "recovery";
}

Result<RecoveryFile> RecoveryFile::claim(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Error{folder.string(), "", "cannot be made: " + failed.message()};
  for (int i = 0; i < kRecoveryTries; ++i) {
    const fs::path file = folder / (std::to_string(::getpid()) + "-" + std::to_string(i) + ".json");
    if (fs::exists(file, failed)) continue;
    if (FileLock lock = tryLock(lockOf(file), O_CREAT); lock.held()) return RecoveryFile(file, std::move(lock));
    if (errno == EACCES || errno == EROFS || errno == ENOSPC) break;
  }
  return Error{folder.string(), "", "no recovery file can be made: " + std::generic_category().message(errno)};
}

Result<void> RecoveryFile::write(const Document& document) {
  Result<void> done = writeFileAtomically(file_, recoveryText(document), Previous::kReplaced);
  written_ = written_ || done.ok();
  return done;
}

void RecoveryFile::remove() {
  std::error_code ignored;
  fs::remove(file_, ignored);
  written_ = false;
}

void RecoveryFile::finish() {
  remove();
  std::error_code ignored;
  fs::remove(lockOf(file_), ignored);
  lock_ = {};
}

std::string LeftBehind::name() const { return (rigFile.empty() ? characterFile : rigFile).filename().string(); }

std::vector<LeftBehind> findLeftBehind(const fs::path& folder) {
  std::vector<LeftBehind> found;
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed); !failed && it != fs::directory_iterator(); it.increment(failed)) {
    files.push_back(it->path());
  }
  for (const fs::path& file : files) {
    std::error_code ignored;
    if (file.extension() == ".lock" && !fs::exists(fs::path(file).replace_extension(".json"), ignored)) {
      if (tryLock(file, 0).held()) fs::remove(file, ignored);
    }
    if (file.extension() != ".json") continue;
    if (fs::exists(lockOf(file), ignored) && !tryLock(lockOf(file), 0).held()) continue;
    if (std::optional<LeftBehind> left = readLeftBehind(file)) found.push_back(std::move(*left));
  }
  std::ranges::sort(found, [](const LeftBehind& a, const LeftBehind& b) {
    return a.when != b.when ? a.when > b.when : a.file < b.file;
  });
  return found;
}

Result<Document> recoverDocument(const LeftBehind& left) {
  const FileLock lock = tryLock(lockOf(left.file), O_CREAT);
  if (!lock.held()) return Error{left.name(), "", "another editor is recovering it"};
  const Result<Json> json = readRecovery(left.file);
  if (!json) return json.error();
  Result<Rig> rig = rigFromJson(json->at("rig").dump());
  if (!rig) return Error{left.file.string(), "rig." + rig.error().place, rig.error().reason, rig.error().subject};
  Document document;
  document.characterOnDisk = stampOfFile(left.characterFile);
  auto character = importGltf(left.characterFile);
  if (!character) return character.error();
  document.character = std::move(character).value();
  document.characterFile = left.characterFile;
  document.rigFile = left.rigFile;
  document.rigOnDisk = stampFromText(json->at("rig_on_disk").text(""));
  document.commands =
      CommandStack(withSheets(withMorphsOf(rigBefore(left, rig.value()), *document.character), document.character));
  document.commands.apply("Recover",
                          withSheets(withMorphsOf(std::move(rig).value(), *document.character), document.character));
  document.clipFiles.folder = document.file().parent_path();
  loadClipFiles(document);
  prepareMirror(document);  // Last, so that the recovered rig stays as it is.
  return document;
}

void discardLeftBehind(const LeftBehind& left) {
  std::error_code ignored;
  fs::remove(left.file, ignored);
  fs::remove(lockOf(left.file), ignored);
}

std::string ageText(fs::file_time_type when, fs::file_time_type now) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - when).count();
  const auto ago = [](long long count, const char* unit) {
    return std::to_string(count) + " " + unit + (count == 1 ? " ago" : "s ago");
  };
  if (seconds < 60) return "just now";
  if (seconds < 3600) return ago(seconds / 60, "minute");
  if (seconds < 86400) return ago(seconds / 3600, "hour");
  return ago(seconds / 86400, "day");
}

AutosaveClock::Deed AutosaveClock::look(double now, double interval, const CommandStack& commands, std::size_t document,
                                        int clip) {
  if (std::exchange(document_, document) != document) {
    written_.reset();
    since_.reset();
    clip_ = clip;
  }
  const bool clipChanged = std::exchange(clip_, clip) != clip;
  const bool atOnce = std::exchange(hurried_, false) || clipChanged;
  if (!commands.modified()) {
    since_.reset();
    written_.reset();
    return std::exchange(hasFile_, false) ? Deed::kRemove : Deed::kNothing;
  }
  if (written_ == commands.revision()) return Deed::kNothing;
  if (!since_) since_ = now;
  if (now - *since_ < interval && !atOnce) return Deed::kNothing;
  since_.reset();
  return Deed::kWrite;
}

void AutosaveClock::wrote(std::size_t revision) {
  written_ = revision;
  since_.reset();
  hasFile_ = true;
}

std::optional<double> AutosaveClock::secondsLeft(double now, double interval) const {
  if (!since_) return std::nullopt;
  return std::max(interval - (now - *since_), 0.0);
}

}  // namespace sinew::app
