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

// The files that a .gltf has its numbers in.

/// The buffers that a .gltf names in its own folder, in its order, there or not; no link that leads out
/// of it. None of other files, nor where it cannot be read. Never throws.
[[nodiscard]] std::vector<std::filesystem::path> bufferFilesOf(const std::filesystem::path& file);

/// What became of one of Rig::clipFiles.
struct ClipFileReport {
  std::string file;                      ///< As the rig names it; AnimationClip::addedFrom of its clips.
  std::filesystem::path path{};          ///< Where it was looked for.
  std::optional<Error> missing{};        ///< Its clips are left out: the reason.
  std::vector<std::string> notes{};      ///< What did not match, one line each, in plain words.
  std::vector<std::string> unmatched{};  ///< As TransferredClips, and so is the next.
  std::vector<std::string> unmoved{};
};

struct WithClipFiles {
  std::shared_ptr<const Character> character;
  std::vector<ClipFileReport> files;  ///< [Rig::clipFiles]
};

/// Why clips are left out, file by file.
[[nodiscard]] std::vector<Error> missingOf(const std::vector<ClipFileReport>& files);
/// What did not match, each line with its file's name.
[[nodiscard]] std::vector<std::string> notesOf(const std::vector<ClipFileReport>& files);

/// The character with the clips of Rig::clipFiles after its own (core/bodies/transfer_clips.h). Those that it had from
/// such files before are left out first. A file that cannot be read is told, and the others are added.
/// @param folder  that relative paths begin in
[[nodiscard]] WithClipFiles withClipFiles(std::shared_ptr<const Character> character, const Rig& rig,
                                          const std::filesystem::path& folder);

/// Rig::clipFiles as a rig file elsewhere names them; absolute ones stay.
/// @param folder  that they begin in now
[[nodiscard]] std::vector<std::string> clipFilesFor(const std::filesystem::path& rigFile,
                                                    const std::vector<std::string>& files,
                                                    const std::filesystem::path& folder);

}  // namespace sinew
