// python/module/character.h: a character as Python holds it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "core/files/clip_files.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew::python {

/// Read only, but for the clips that are added. What is found only when it is asked for is found under the
/// interpreter's lock.
class CharacterHandle {
 public:
  explicit CharacterHandle(const std::filesystem::path& file);

  [[nodiscard]] const std::shared_ptr<const Character>& character() const { return character_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const std::shared_ptr<const MirrorPlan>& plan();
  /// With the range of motion as its last clip.
  [[nodiscard]] const std::shared_ptr<const Character>& moving();

  /// Plays the clips of the file too, after those that it has; a file that it has is read again. Refuses one that adds
  /// none. @return what did not match, a line each
  std::vector<std::string> addClips(const std::filesystem::path& file, const std::vector<SlotCorrection>& corrections);
  /// The same of a rig's files. @return why clips are left out, a line each
  std::vector<std::string> openClips(const std::vector<std::filesystem::path>& files,
                                     const std::vector<SlotCorrection>& corrections);

  /// A moment of a clip, the range of motion too; without a name the bind pose. Refuses a name that it lacks.
  [[nodiscard]] Pose poseAt(pybind11::handle clip, double seconds);
  /// Refuses a name that it lacks. Valid as long as the character.
  [[nodiscard]] const AnimationClip& clipNamed(const std::string& name);

 private:
  std::filesystem::path file_;
  std::shared_ptr<const Character> character_;
  std::shared_ptr<const MirrorPlan> plan_;
  std::shared_ptr<const Character> moving_;
  std::vector<std::string> clipFiles_;  ///< Whose clips it has; absolute.

  [[nodiscard]] WithClipFiles readClips(const std::vector<std::filesystem::path>& files,
                                        const std::vector<SlotCorrection>& corrections) const;
  void take(WithClipFiles with);
};

void defineCharacter(pybind11::module_& module);

}  // namespace sinew::python
