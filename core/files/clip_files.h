// core/files/clip_files.h: a character with the clips of the files that its rig names.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Buffer files that a .gltf names inside its own folder, in its order, whether they exist or not. Empty for other
/// files and for one that cannot be read. Never throws.
[[nodiscard]] std::vector<std::filesystem::path> bufferFilesOf(const std::filesystem::path& file);

/// Outcome for one of Rig::clipFiles.
struct ClipFileReport {
  std::string file;                      ///< As in the rig; AnimationClip::addedFrom of its clips.
  std::filesystem::path path{};          ///< Full path.
  std::optional<Error> missing{};        ///< Why its clips are left out.
  std::vector<std::string> notes{};      ///< Mismatches, one line each, for people.
  std::vector<std::string> unmatched{};  ///< As in TransferredClips, and so is the next.
  std::vector<std::string> unmoved{};
};

struct WithClipFiles {
  std::shared_ptr<const Character> character;
  std::vector<ClipFileReport> files;  ///< [Rig::clipFiles]
};

/// Why clips are left out, file by file.
[[nodiscard]] std::vector<Error> missingOf(const std::vector<ClipFileReport>& files);
/// Mismatches, each line with its file's name.
[[nodiscard]] std::vector<std::string> notesOf(const std::vector<ClipFileReport>& files);

/// The character with the clips of Rig::clipFiles after its own (core/bodies/transfer_clips.h), replacing those added
/// before. A file that cannot be read is reported, and the others are added. @param folder  base of relative paths
[[nodiscard]] WithClipFiles withClipFiles(std::shared_ptr<const Character> character, const Rig& rig,
                                          const std::filesystem::path& folder);

/// Rig::clipFiles relative to another rig file; absolute paths stay. @param folder  their base now
[[nodiscard]] std::vector<std::string> clipFilesFor(const std::filesystem::path& rigFile,
                                                    const std::vector<std::string>& files,
                                                    const std::filesystem::path& folder);

}  // namespace sinew
