// core/io/clip_files.cpp: file after file, each transferred to the character as it came from its own.
#include "core/io/clip_files.h"

#include <algorithm>
#include <utility>

#include "core/clips/transfer_clips.h"
#include "sinew/io/gltf_import.h"
#include "sinew/io/rig_json.h"

namespace sinew {
namespace {

bool isAdded(const AnimationClip& clip) { return !clip.addedFrom.empty(); }

}  // namespace

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
    const std::filesystem::path path = folder / std::filesystem::path(file);
    const auto from = importClips(path);
    if (!from) {
      result.missing.push_back(from.error());
      continue;
    }
    const std::size_t room =
        static_cast<std::size_t>(kMaxClips) - std::min<std::size_t>(extended->clips.size(), kMaxClips);
    if (from.value()->clips.size() > room) {
      result.missing.push_back(Error{path.string(), "animations",
                                     "the character would have more than " + std::to_string(kMaxClips) + " clips",
                                     "cannot be added"});
      continue;
    }
    TransferredClips clips = transferClips(*from.value(), *extended, rig.slots, file);
    for (AnimationClip& clip : clips.clips) extended->clips.push_back(std::move(clip));
    for (const std::string& note : clips.notes) result.notes.push_back(path.filename().string() + ": " + note);
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
