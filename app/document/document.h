// app/document/document.h: one open character with its rig.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/command_stack.h"
#include "app/document/file_stamp.h"
#include "app/document/selection.h"
#include "app/document/visibility.h"
#include "core/files/clip_files.h"
#include "core/geometry/at.h"
#include "core/rig/mirror.h"
#include "core/rig/posed_rig.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// The document's rig in the pose that is shown, made once however many ask for it.

/// Remembers the last rig and the last pose that were asked for.
class PosedRigMemo {
 public:
  /// @param revision  CommandStack::revision(): equal numbers, equal rigs
  [[nodiscard]] const std::shared_ptr<const RigPoser>& poser(const Rig& rig, std::size_t revision,
                                                             const std::shared_ptr<const Character>& character);
  /// Valid until the next call.
  [[nodiscard]] const PosedRig& posed(const Rig& rig, std::size_t revision,
                                      const std::shared_ptr<const Character>& character, const Pose& pose);

 private:
  std::shared_ptr<const Character> character_;  ///< Outlives the poser.
  std::size_t revision_ = 0;
  std::shared_ptr<const RigPoser> poser_;
  std::optional<Pose> pose_;  ///< What posed_ shows.
  PosedRig posed_;
};

/// The document: a read-only character, the rig (through its command stack alone), the paths; and as view state
/// the selection and what is hidden or locked.
struct Document {
  std::shared_ptr<const Character> character;
  std::filesystem::path characterFile;
  std::optional<FileStamp> characterOnDisk;  ///< What it held when it was read; nullopt: not known.
  std::filesystem::path rigFile;             ///< Empty until saved or opened from one.
  std::optional<FileStamp> rigOnDisk;        ///< What rigFile held when this document read or wrote it last.
  CommandStack commands{Rig{}};
  Selection selection;
  std::shared_ptr<const MirrorPlan> mirror;  ///< Null or unusable: nothing can be mirrored. See prepareMirror.
  bool symmetry = false;  ///< View state: what is added, deleted, duplicated or pasted is so on both sides.
  Visibility visibility;
  /// Rig::clipFiles while the document is open: where relative paths begin, what became of each file.
  struct ClipFiles {
    std::filesystem::path folder;
    std::vector<ClipFileReport> files;               ///< [Rig::clipFiles] as they were read last.
    std::vector<std::optional<FileStamp>> onDisk{};  ///< [files] what each held then; nullopt: it was not there.
    std::vector<SlotCorrection> readFor{};           ///< Rig::slots then.
  };
  ClipFiles clipFiles;
  mutable PosedRigMemo poses;  ///< For posedRig().

  [[nodiscard]] const Rig& rig() const { return commands.rig(); }
  /// Rig index of the active primitive: the last picked that is in the rig; or -1.
  [[nodiscard]] int activePrimitive() const;
  /// Its name; "" if there is none.
  [[nodiscard]] const std::string& activeName() const;
  /// The rig as it is in a pose: what everything that shows or measures it reads. Valid until the next call.
  [[nodiscard]] const PosedRig& posedRig(const Pose& pose) const {
    return poses.posed(rig(), commands.revision(), character, pose);
  }
  [[nodiscard]] const std::shared_ptr<const RigPoser>& poser() const {
    return poses.poser(rig(), commands.revision(), character);
  }
  /// The identity of the primitive at a rig index.
  [[nodiscard]] PrimitiveId idAt(int index) const { return at(rig().primitives, index).id(); }
  /// For the title: file name, "*" added by the caller when modified.
  [[nodiscard]] std::string name() const;
};

/// Opens a .glb / .gltf (with an empty rig) or a .rig.json (with the character it names). Error: the open document is
/// untouched. Clip files of the rig that cannot be read are told in Document::clipFiles.
/// @param clips  further files, whose clips are added; the rig names them too. Error: one that cannot be read
[[nodiscard]] Result<Document> openDocument(const std::filesystem::path& file,
                                            const std::vector<std::filesystem::path>& clips = {});

/// The character with the clips that the rig's files have now.
void loadClipFiles(Document& document);
/// Whether that would read other files than it did last, or for other parts of the body.
[[nodiscard]] bool clipFilesAreCurrent(const Document& document);
/// What the rig would call a file: relative to where its paths begin.
[[nodiscard]] std::string clipFileName(const Document& document, const std::filesystem::path& file);

/// Where a rig expects its character, if no file can be read there. nullopt: one can, or this is no rig.
[[nodiscard]] std::optional<std::filesystem::path> missingCharacter(const std::filesystem::path& rigFile);

/// Opens a rig with a character that lies elsewhere than it says. The new path is a step of the history: unsaved.
[[nodiscard]] Result<Document> openRigWith(const std::filesystem::path& rigFile,
                                           const std::filesystem::path& characterFile);

/// Finds the character's mirror plane and has the command stack keep linked twins each other's image, from now on;
/// symmetry is switched on where bones come in pairs. openDocument does this; documents made by hand may.
void prepareMirror(Document& document);

/// The rig as a file of that name holds it: with the way from there to the character and to the files of clips.
[[nodiscard]] Rig rigAsIn(const Document& document, const std::filesystem::path& rigFile);

/// Writes the rig; on success rigFile is set and the document counts as saved.
[[nodiscard]] Result<void> saveDocument(Document& document, const std::filesystem::path& rigFile);

}  // namespace sinew::app
