// app/document/document.cpp: opening and saving.
#include "app/document/document.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

#include "app/document/folder_listing.h"
#include "app/document/listed_muscles.h"
#include "core/bodies/sheets/keep_sheets.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/rig_edit.h"
#include "core/rig/twins.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew::app {

bool Selection::contains(PrimitiveId primitive) const {
  return std::ranges::find(primitives, primitive) != primitives.end();
}

PrimitiveId Selection::active() const { return primitives.empty() ? PrimitiveId{} : primitives.back(); }

void Selection::set(PrimitiveId primitive) {
  primitives.assign(1, primitive);
  bone = -1;
}

void Selection::toggle(PrimitiveId primitive) {
  const auto found = std::ranges::find(primitives, primitive);
  if (found != primitives.end()) {
    primitives.erase(found);
  } else {
    primitives.push_back(primitive);
  }
}

void Selection::setAll(std::span<const PrimitiveId> several, bool add) {
  if (add) remove(several);
  else clear();
  for (const PrimitiveId primitive : several) {
    if (!contains(primitive)) primitives.push_back(primitive);
  }
}

void Selection::remove(std::span<const PrimitiveId> several) {
  std::erase_if(primitives, [&](const PrimitiveId id) { return std::ranges::find(several, id) != several.end(); });
}

void Selection::invert(std::span<const PrimitiveId> all) {
  std::vector<PrimitiveId> others;
  for (const PrimitiveId id : all) {
    if (!contains(id)) others.push_back(id);
  }
  primitives = std::move(others);
}

void Selection::clear() {
  primitives.clear();
  bone = -1;
}

const std::shared_ptr<const RigPoser>& PosedRigMemo::poser(const Rig& rig, std::size_t revision,
                                                           const std::shared_ptr<const Character>& character) {
  if (poser_ && revision_ == revision && character_ == character) return poser_;
  character_ = character;
  revision_ = revision;
  poser_ = std::make_shared<const RigPoser>(rig, *character);
  pose_.reset();
  return poser_;
}

const PosedRig& PosedRigMemo::posed(const Rig& rig, std::size_t revision,
                                    const std::shared_ptr<const Character>& character, const Pose& pose) {
  const RigPoser& asked = *poser(rig, revision, character);
  if (pose_ != pose) {
    pose_ = pose;
    asked.pose(pose, posed_);
  }
  return posed_;
}

namespace {

Result<Document> openCharacter(const std::filesystem::path& file) {
  Document document;
  document.characterOnDisk = stampOfFile(file);  // Before reading, as in openRig().
  auto character = importGltf(file);
  if (!character) return character.error();
  document.character = std::move(character).value();
  document.characterFile = file;
  Rig rig;
  rig.character = file.filename().generic_string();
  rig.surface.grooves = kNewGrooves;
  rig.smoothing.detail = DetailKind::kAdaptive;
  document.clipFiles.folder = file.parent_path();
  document.commands = CommandStack(withMorphsOf(std::move(rig), *document.character));
  prepareMirror(document);
  return document;
}

/// Error of a rig whose character cannot be read.
Error ofCharacter(const std::filesystem::path& rigFile, const Error& error) {
  const std::string place = error.place.empty() ? error.file : error.file + ": " + error.place;
  const std::string name = error.subject.empty() ? error.file : std::filesystem::path(error.file).filename().string();
  return about("its character " + name, {rigFile.string(), "character: " + place, error.reason, error.subject});
}

/// @param onDisk  the rig's file before it was read
Result<Document> openParts(Rig rig, const std::optional<FileStamp>& onDisk, const std::filesystem::path& file,
                           const std::filesystem::path& characterFile) {
  Document document;
  document.characterOnDisk = stampOfFile(characterFile);
  auto character = importGltf(characterFile);
  if (!character) return ofCharacter(file, character.error());
  document.character = std::move(character).value();
  document.characterFile = characterFile;
  document.rigFile = file;
  document.rigOnDisk = onDisk;
  document.clipFiles.folder = file.parent_path();
  document.commands = CommandStack(withSheets(withMorphsOf(std::move(rig), *document.character), document.character));
  loadClipFiles(document);
  prepareMirror(document);
  return document;
}

Result<Document> openRig(const std::filesystem::path& file) {
  // Before reading: if the file changes in between, saving asks once too often rather than once too little.
  const std::optional<FileStamp> onDisk = stampOfFile(file);
  auto rig = loadRig(file);
  if (!rig) return rig.error();
  const std::filesystem::path characterFile = characterPath(rig.value(), file);
  return openParts(std::move(rig).value(), onDisk, file, characterFile);
}

Result<Document> openEither(const std::filesystem::path& file) {
  const std::string name = lowerCase(file.filename().string());
  if (name.ends_with(".json")) return openRig(file);
  if (isCharacterName(name)) return openCharacter(file);
  return Error{file.string(), "", "expected a character (.glb, .gltf, .vrm) or a rig (.rig.json)", "cannot be opened"};
}

}  // namespace

int Document::activePrimitive() const {
  for (auto id = selection.primitives.rbegin(); id != selection.primitives.rend(); ++id) {
    if (const int index = findPrimitive(rig(), *id); index >= 0) return index;
  }
  return -1;
}

const std::string& Document::activeName() const {
  static const std::string kNone;
  const int active = activePrimitive();
  return active < 0 ? kNone : muscleName(rig(), active);
}

std::string Document::name() const { return file().empty() ? "untitled" : file().filename().string(); }

void loadClipFiles(Document& document) {
  document.clipFiles.onDisk.clear();
  for (const std::string& file : document.rig().clipFiles) {
    document.clipFiles.onDisk.push_back(stampOfFile(document.clipFiles.folder / std::filesystem::path(file)));
  }
  WithClipFiles with = withClipFiles(document.character, document.rig(), document.clipFiles.folder);
  document.character = std::move(with.character);
  document.clipFiles.files = std::move(with.files);
  document.clipFiles.readFor = document.rig().slots;
}

bool clipFilesAreCurrent(const Document& document) {
  const std::vector<ClipFileReport>& files = document.clipFiles.files;
  if (!std::ranges::equal(files, document.rig().clipFiles, {}, &ClipFileReport::file)) return false;
  return files.empty() || document.clipFiles.readFor == document.rig().slots;
}

std::string clipFileName(const Document& document, const std::filesystem::path& file) {
  return relativeCharacterPath(file, document.clipFiles.folder / "rig");
}

Result<Document> openDocument(const std::filesystem::path& file, const std::vector<std::filesystem::path>& clips) {
  Result<Document> opened = openEither(file);
  if (!opened || clips.empty()) return opened;
  Document& document = opened.value();
  Rig rig = document.rig();
  const std::size_t missing = missingOf(document.clipFiles.files).size();
  for (const std::filesystem::path& path : clips) {
    const std::string name = path.is_absolute() ? path.generic_string() : clipFileName(document, path);
    if (std::ranges::find(rig.clipFiles, name) == rig.clipFiles.end()) rig.clipFiles.push_back(name);
  }
  document.commands.apply("Add clips", std::move(rig));
  loadClipFiles(document);
  if (const auto gone = missingOf(document.clipFiles.files); gone.size() > missing) return gone.back();
  return opened;
}

std::optional<std::filesystem::path> missingCharacter(const std::filesystem::path& rigFile) {
  if (!lowerCase(rigFile.filename().string()).ends_with(".json")) return std::nullopt;
  const Result<Rig> rig = loadRig(rigFile);
  if (!rig) return std::nullopt;
  std::filesystem::path file = characterPath(rig.value(), rigFile);
  std::error_code failed;
  const bool there = std::filesystem::is_regular_file(file, failed) && std::ifstream(file).good();
  return there ? std::nullopt : std::optional(std::move(file));
}

Result<Document> openRigWith(const std::filesystem::path& rigFile, const std::filesystem::path& characterFile) {
  const std::optional<FileStamp> onDisk = stampOfFile(rigFile);
  Result<Rig> rig = loadRig(rigFile);
  if (!rig) return rig.error();
  Rig located = rig.value();
  located.character = relativeCharacterPath(characterFile, rigFile);
  Result<Document> opened = openParts(std::move(rig).value(), onDisk, rigFile, characterFile);
  if (!opened) return opened;
  Document document = std::move(opened).value();
  document.commands.apply("Locate character", std::move(located));
  return document;
}

void prepareMirror(Document& document) {
  document.mirror = std::make_shared<const MirrorPlan>(makeMirrorPlan(*document.character));
  document.symmetry = document.mirror->pairCount() > 0;
  document.commands.setKeeper(
      [plan = document.mirror, character = document.character,
       sheets = std::make_shared<SheetKeeper>(document.character)](const Rig& atStart, const Rig& shown, Rig wanted) {
        wanted = keepTwins(atStart, shown, withMorphsOf(std::move(wanted), *character, KeepIdle::kYes), *plan);
        return sheets->keep(shown, std::move(wanted), *plan);
      });
}

Rig rigAsIn(const Document& document, const std::filesystem::path& rigFile) {
  Rig written = document.rig();
  // Absolute paths stay; others become relative to the new folder.
  if (!std::filesystem::path(written.character).is_absolute()) {
    written.character = relativeCharacterPath(document.characterFile, rigFile);
  }
  written.clipFiles = clipFilesFor(rigFile, written.clipFiles, document.clipFiles.folder);
  return written;
}

Result<void> saveDocument(Document& document, const std::filesystem::path& rigFile) {
  const Rig written = rigAsIn(document, rigFile);
  if (Result<void> saved = saveRig(written, rigFile); !saved) return saved;
  document.rigFile = rigFile;
  document.rigOnDisk = stampOf(rigToJson(written));
  document.commands.markSaved();
  return {};
}

}  // namespace sinew::app
