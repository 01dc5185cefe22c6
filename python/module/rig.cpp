// python/module/rig.cpp: a rig as Python holds it.
#include "python/module/rig.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/files/clip_files.h"
#include "core/geometry/at.h"
#include "core/geometry/nearest_name.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"
#include "core/rig/twins.h"
#include "python/module/errors.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::python {
namespace {

template <class Item>
std::vector<std::string> namesOf(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

/// @param what  "muscle"
template <class Item>
int found(int index, const std::string& name, const std::vector<Item>& items, const std::string& what) {
  if (index < 0) {
    refuse(what + " \"" + name + '"', "the rig has no " + what + " of this name" + didYouMean(name, namesOf(items)));
  }
  return index;
}

/// There is no file in which a JSON path would be: the muscle or line says where.
Error inWords(Error error) {
  if (!error.subject.empty()) error.place = error.subject;
  return error;
}

/// A rig that was opened may name bones that the character lacks; an edit adds none.
void refuseNewlyMissing(const Rig& before, const Rig& edited, const Skeleton& skeleton) {
  const std::vector<MissingBone> known = missingBones(before, skeleton);
  for (const MissingBone& missing : missingBones(edited, skeleton)) {
    if (std::ranges::find(known, missing.bone, &MissingBone::bone) != known.end()) continue;
    refuse(inWords(refusalOf(missing, skeleton)));
  }
}

}  // namespace

RigHandle::RigHandle(std::shared_ptr<CharacterHandle> character)
    : character_(std::move(character)), clipsFolder_(character_->file().parent_path()) {
  Rig rig;
  rig.character = character_->file().filename().generic_string();
  rig.surface.grooves = kNewGrooves;
  rig.smoothing.detail = DetailKind::kAdaptive;
  rig_ = withMorphsOf(std::move(rig), *character_->character());
}

RigHandle::RigHandle(std::shared_ptr<CharacterHandle> character, Rig rig, std::filesystem::path file)
    : character_(std::move(character)),
      file_(std::move(file)),
      clipsFolder_((file_.empty() ? character_->file() : file_).parent_path()) {
  rig_ = withSheets(withMorphsOf(std::move(rig), *character_->character()), character_->character());
  identities_.identify(rig_, {});
}

void RigHandle::replace(Rig edited, Bones bones) {
  const Character& character = *character_->character();
  if (bones == Bones::kMayBeNew) refuseNewlyMissing(rig_, edited, character.skeleton);
  edited = withMorphsOf(std::move(edited), character, KeepIdle::kYes);
  if (!std::ranges::all_of(rig_.primitives, [](const Primitive& muscle) { return muscle.mirror.empty(); })) {
    edited = keepTwins(rig_, rig_, std::move(edited), *character_->plan());
  }
  if (!edited.sheets.empty() || !rig_.sheets.empty()) {
    if (!sheets_) sheets_ = std::make_shared<SheetKeeper>(character_->character());
    edited = sheets_->keep(rig_, std::move(edited), *character_->plan());
  }
  identities_.identify(edited, rig_);
  rig_ = std::move(edited);
}

void RigHandle::replace(Result<Rig> edited, Bones bones) {
  if (!edited) refuse(inWords(edited.error()));
  replace(std::move(edited).value(), bones);
}

void RigHandle::save(const std::filesystem::path& file) {
  Rig written = rig_;
  // A path that was typed as absolute stays; any other follows the rig file to its new folder.
  if (!std::filesystem::path(written.character).is_absolute()) {
    written.character = relativeCharacterPath(character_->file(), file);
  }
  written.clipFiles = clipFilesFor(file, written.clipFiles, clipsFolder_);
  valueOrRefuse(saveRig(written, file));
  rig_.character = written.character;
  rig_.clipFiles = std::move(written.clipFiles);
  file_ = file;
  clipsFolder_ = file.parent_path();
}

std::vector<std::string> RigHandle::addClips(const std::filesystem::path& file) {
  std::vector<std::string> notes = character_->addClips(file, rig_.slots);
  const std::string name = relativeCharacterPath(file, clipsFolder_ / "rig");
  if (std::ranges::find(rig_.clipFiles, name) == rig_.clipFiles.end()) {
    Rig edited = rig_;
    edited.clipFiles.push_back(name);
    replace(std::move(edited));
  }
  return notes;
}

void RigHandle::openClips() {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : rig_.clipFiles) files.push_back(clipsFolder_ / std::filesystem::path(name));
  missingClips_ = character_->openClips(files, rig_.slots);
}

int RigHandle::muscleNamed(const std::string& name) const {
  return found(findPrimitive(rig_, name), name, rig_.primitives, "muscle");
}

int RigHandle::groupNamed(const std::string& name) const {
  return found(findGroup(rig_, name), name, rig_.groups, "group");
}

int RigHandle::lineNamed(const std::string& name) const {
  return found(findLine(rig_, name), name, rig_.lines, "line");
}

int RigHandle::muscleOf(std::uint32_t id) const {
  const int index = findPrimitive(rig_, PrimitiveId{id});
  if (index < 0) refuse("muscle", "it was removed from its rig");
  return index;
}

int RigHandle::lineOf(std::uint32_t id) const {
  const int index = findLine(rig_, LineId{id});
  if (index < 0) refuse("line", "it was removed from its rig");
  return index;
}

Rig withGroup(Rig rig, const std::string& name) {
  if (findGroup(rig, name) >= 0) return rig;
  auto with = addGroup(std::move(rig), name);
  if (!with) refuse(inWords(with.error()));
  return std::move(with).value();
}

}  // namespace sinew::python
