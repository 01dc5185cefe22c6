// core/files/clip_files.cpp: imports each file and transfers its clips to the character.
#include "core/files/clip_files.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <system_error>
#include <utility>

#include "core/bodies/transfer_clips.h"
#include "core/files/gltf/file.h"
#include "core/geometry/nearest_name.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew {

std::vector<std::filesystem::path> bufferFilesOf(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  if (lowerCase(file.extension().string()) != ".gltf") return files;
  try {
    const std::vector<std::uint8_t> contents = gltf::contentsOf(file);
    const Json root = gltf::parseJson(gltf::openContainer(contents).json, "extras");
    for (const Json& buffer : root.at("buffers").items()) {
      const std::string uri = buffer.at("uri").text("");
      if (uri.empty() || gltf::isDataUri(uri) || gltf::isFallback(buffer)) continue;
      const Result<std::filesystem::path> relative = gltf::relativePathOf(uri);
      if (!relative) continue;
      const std::filesystem::path folder = gltf::folderOf(file);
      const std::filesystem::path named = folder / relative.value();
      std::error_code failed;
      if (gltf::placeInside(folder, relative.value()) || !std::filesystem::exists(named, failed))
        files.push_back(named);
    }
  } catch (...) {
    files.clear();
  }
  return files;
}

namespace {

bool isAdded(const AnimationClip& clip) { return !clip.addedFrom.empty(); }

ClipFileReport addFile(const std::string& file, const std::filesystem::path& path,
                       std::span<const SlotCorrection> corrections, Character& character) {
  ClipFileReport report{file, path};
  const auto from = importClips(path);
  if (!from) {
    report.missing = from.error();
    return report;
  }
  if (character.clips.size() + from.value()->clips.size() > static_cast<std::size_t>(kMaxClips)) {
    report.missing =
        Error{path.string(), "animations", "the character would have more than " + std::to_string(kMaxClips) + " clips",
              "cannot be added"};
    return report;
  }
  TransferredClips clips = transferClips(*from.value(), character, corrections, file);
  for (AnimationClip& clip : clips.clips) character.clips.push_back(std::move(clip));
  report.notes = std::move(clips.notes);
  report.unmatched = std::move(clips.unmatched);
  report.unmoved = std::move(clips.unmoved);
  return report;
}

}  // namespace

std::vector<Error> missingOf(const std::vector<ClipFileReport>& files) {
  std::vector<Error> missing;
  for (const ClipFileReport& file : files) {
    if (file.missing) missing.push_back(*file.missing);
  }
  return missing;
}

std::vector<std::string> notesOf(const std::vector<ClipFileReport>& files) {
  std::vector<std::string> notes;
  for (const ClipFileReport& file : files) {
    for (const std::string& note : file.notes) notes.push_back(file.path.filename().string() + ": " + note);
  }
  return notes;
}

WithClipFiles withClipFiles(std::shared_ptr<const Character> character, const Rig& rig,
                            const std::filesystem::path& folder) {
  WithClipFiles result;
  if (rig.clipFiles.empty() && std::ranges::none_of(character->clips, isAdded)) {
    result.character = std::move(character);
    return result;
  }
  auto extended = std::make_shared<Character>(*character);
  std::erase_if(extended->clips, isAdded);
  for (const std::string& file : rig.clipFiles) {
    result.files.push_back(addFile(file, folder / std::filesystem::path(file), rig.slots, *extended));
  }
  result.character = std::move(extended);
  return result;
}

std::vector<std::string> clipFilesFor(const std::filesystem::path& rigFile, const std::vector<std::string>& files,
                                      const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const std::filesystem::path path(file);
    names.push_back(path.is_absolute() ? file : relativeCharacterPath(folder / path, rigFile));
  }
  return names;
}

}  // namespace sinew
