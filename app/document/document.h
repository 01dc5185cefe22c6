// app/document/document.h: one open character with its rig.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document/command_stack.h"
#include "app/document/file_stamp.h"
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

/// Primitives in order of picking (the last one is active) and one bone. What undo removed stays selected for redo.
struct Selection {
  std::vector<PrimitiveId> primitives;
  int bone = -1;  ///< Index into Skeleton::bones, or -1.

  [[nodiscard]] bool contains(PrimitiveId primitive) const;
  [[nodiscard]] PrimitiveId active() const;  ///< 0 if none.
  void set(PrimitiveId primitive);           ///< Only this one.
  void toggle(PrimitiveId primitive);
  /// Selects several; the last becomes active. They replace the selection, or (`add`) extend it.
  void setAll(std::span<const PrimitiveId> several, bool add = false);
  void remove(std::span<const PrimitiveId> several);
  void invert(std::span<const PrimitiveId> all);  ///< Selects what was not selected of `all`, and nothing else.
  void clear();
};

/// Poses the rig once for all who need it: remembers the last rig and pose.
class PosedRigMemo {
 public:
  /// @param revision  CommandStack::revision()
  [[nodiscard]] const std::shared_ptr<const RigPoser>& poser(const Rig& rig, std::size_t revision,
                                                             const std::shared_ptr<const Character>& character);
  /// Valid until the next call.
  [[nodiscard]] const PosedRig& posed(const Rig& rig, std::size_t revision,
                                      const std::shared_ptr<const Character>& character, const Pose& pose);

 private:
  std::shared_ptr<const Character> character_;  ///< Outlives the poser.
  std::size_t revision_ = 0;
  std::shared_ptr<const RigPoser> poser_;
  std::optional<Pose> pose_;  ///< Of posed_.
  PosedRig posed_;
};

/// Read-only character, rig (edited through the command stack alone) and files; view state: selection and visibility.
struct Document {
  std::shared_ptr<const Character> character;
  std::filesystem::path characterFile;
  std::optional<FileStamp> characterOnDisk;  ///< When it was read; nullopt: not known.
  std::filesystem::path rigFile;             ///< Empty until saved or opened from one.
  std::optional<FileStamp> rigOnDisk;        ///< When this document read or wrote it last.
  CommandStack commands{Rig{}};
  Selection selection;
  std::shared_ptr<const MirrorPlan> mirror;  ///< From prepareMirror(). Null or unusable: nothing can be mirrored.
  bool symmetry = false;  ///< View state: adding, deleting, duplicating and pasting act on both sides.
  Visibility visibility;
  /// Rig::clipFiles as they were read.
  struct ClipFiles {
    std::filesystem::path folder;                    ///< Relative paths begin here.
    std::vector<ClipFileReport> files;               ///< [Rig::clipFiles]
    std::vector<std::optional<FileStamp>> onDisk{};  ///< [files] nullopt: it was missing.
    std::vector<SlotCorrection> readFor{};           ///< Rig::slots then.
  };
  ClipFiles clipFiles;
  mutable PosedRigMemo poses;  ///< For posedRig().

  [[nodiscard]] const Rig& rig() const { return commands.rig(); }
  [[nodiscard]] int activePrimitive() const;  ///< Rig index of the last picked primitive that is in the rig; or -1.
  [[nodiscard]] const std::string& activeName() const;  ///< muscleName() of it; "" if there is none.
  /// The rig in a pose. Valid until the next call.
  [[nodiscard]] const PosedRig& posedRig(const Pose& pose) const {
    return poses.posed(rig(), commands.revision(), character, pose);
  }
  [[nodiscard]] const std::shared_ptr<const RigPoser>& poser() const {
    return poses.poser(rig(), commands.revision(), character);
  }
  /// The identity of the primitive at a rig index.
  [[nodiscard]] PrimitiveId idAt(int index) const { return at(rig().primitives, index).id(); }
  /// The rig's file, or the character's for a rig without one.
  [[nodiscard]] const std::filesystem::path& file() const { return rigFile.empty() ? characterFile : rigFile; }
  [[nodiscard]] std::string name() const;  ///< Name of file(), or "untitled".
};

/// Opens a .glb, .gltf or .vrm (with an empty rig) or a .rig.json (with the character it names). Document::clipFiles
/// reports clip files of the rig that cannot be read.
/// @param clips  further clip files, added to the rig. Error: one cannot be read
[[nodiscard]] Result<Document> openDocument(const std::filesystem::path& file,
                                            const std::vector<std::filesystem::path>& clips = {});

void loadClipFiles(Document& document);  ///< Reads the rig's clip files and adds their clips to the character.
/// loadClipFiles() would read the same files, for the same parts of the body.
[[nodiscard]] bool clipFilesAreCurrent(const Document& document);
/// Path of a clip file as the rig stores it.
[[nodiscard]] std::string clipFileName(const Document& document, const std::filesystem::path& file);

/// Where a rig expects its character, if no file can be read there; nullopt otherwise.
[[nodiscard]] std::optional<std::filesystem::path> missingCharacter(const std::filesystem::path& rigFile);

/// Opens a rig with a character from another path. The new path is an unsaved step of the history.
[[nodiscard]] Result<Document> openRigWith(const std::filesystem::path& rigFile,
                                           const std::filesystem::path& characterFile);

/// Finds the character's mirror plane, keeps linked twins mirrored in every edit from now on, and switches symmetry on
/// where bones come in pairs. openDocument() calls it.
void prepareMirror(Document& document);

/// The rig as saved to a file: with paths relative to it.
[[nodiscard]] Rig rigAsIn(const Document& document, const std::filesystem::path& rigFile);

/// On success rigFile is set and the document counts as saved.
[[nodiscard]] Result<void> saveDocument(Document& document, const std::filesystem::path& rigFile);

}  // namespace sinew::app
