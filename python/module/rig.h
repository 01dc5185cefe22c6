// python/module/rig.h: a rig as Python holds it: the document's value, its character, and edits that are refused whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "core/bodies/sheets/keep_sheets.h"
#include "core/rig/references.h"
#include "python/module/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::python {

/// Changed under the interpreter's lock alone; what takes time works on a copy.
class RigHandle {
 public:
  /// An empty rig, as the editor begins one.
  explicit RigHandle(std::shared_ptr<CharacterHandle> character);
  /// @param file  empty: it has none yet
  RigHandle(std::shared_ptr<CharacterHandle> character, Rig rig, std::filesystem::path file);

  [[nodiscard]] const Rig& rig() const { return rig_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] CharacterHandle& character() const { return *character_; }

  /// Whether an edit can name bones that the rig did not name before.
  enum class Bones { kAsBefore, kMayBeNew };
  /// The edited rig takes the place of this one; linked twins follow. Refuses bones that the character lacks.
  void replace(Rig edited, Bones bones = Bones::kAsBefore);
  /// The same, or sinew.Error with the reason why not.
  void replace(Result<Rig> edited, Bones bones = Bones::kAsBefore);
  void save(const std::filesystem::path& file);

  /// The rig names the file, and its character plays its clips (CharacterHandle::addClips).
  std::vector<std::string> addClips(const std::filesystem::path& file);
  /// Those of the files that the rig names.
  void openClips();
  /// Why clips of such files are left out, a line each.
  [[nodiscard]] const std::vector<std::string>& missingClips() const { return missingClips_; }

  /// Index, or sinew.Error with the name that was probably meant.
  [[nodiscard]] int muscleNamed(const std::string& name) const;
  [[nodiscard]] int groupNamed(const std::string& name) const;
  [[nodiscard]] int lineNamed(const std::string& name) const;
  /// Index; refused if it is gone.
  [[nodiscard]] int muscleOf(std::uint32_t id) const;
  [[nodiscard]] int lineOf(std::uint32_t id) const;

 private:
  std::shared_ptr<CharacterHandle> character_;
  Rig rig_;
  std::filesystem::path file_;
  std::filesystem::path clipsFolder_;  ///< Where relative paths of Rig::clipFiles begin.
  std::vector<std::string> missingClips_;
  IdentitySource identities_;
  std::shared_ptr<SheetKeeper> sheets_;  ///< Made when first needed.
};

/// `rig` with a group of that name, made where there is none.
[[nodiscard]] Rig withGroup(Rig rig, const std::string& name);

void defineRig(pybind11::module_& module);

}  // namespace sinew::python
