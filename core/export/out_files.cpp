// core/export/out_files.cpp: which files an export writes, what stands in the way, and writing them.
#include "core/export/out_files.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "core/io/files/atomic_file.h"

namespace sinew::exporting {

std::string lowerEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                        const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    if (std::ranges::find(character.clips, name, &AnimationClip::name) != character.clips.end()) continue;
    std::string known;
    for (const AnimationClip& clip : character.clips) known += (known.empty() ? "\"" : ", \"") + clip.name + '"';
    return Error{
        file.string(), "clip \"" + name + '"',
        known.empty() ? "it has no clips" : "expected " + (character.clips.size() > 1 ? "one of " + known : known)};
  }
  return {};
}

std::vector<std::filesystem::path> filesOf(const std::filesystem::path& file) {
  if (lowerEnding(file) != ".gltf") return {file};
  std::filesystem::path binary = file;
  return {binary.replace_extension(".bin"), file};
}

Result<void> checkPlaces(const Source& source, const std::vector<std::filesystem::path>& files) {
  const std::filesystem::path& file = files.back();
  std::error_code unknown;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), unknown)) {
    return Error{file.string(), {}, "cannot be written: there is no such folder"};
  }
  for (const std::filesystem::path& place : files) {
    if (std::filesystem::is_directory(place, unknown)) {
      return Error{place.string(), {}, "cannot be written: it is a folder"};
    }
    if (source.reads(place)) {
      return Error{place.string(), {}, "cannot be written: the character is read from it"};
    }
  }
  return {};
}

Result<std::uint64_t> writeGltf(const PackedGltf& packed, const std::filesystem::path& file) {
  const std::vector<std::filesystem::path> files = filesOf(file);
  if (files.size() == 1) {
    const Result<std::string> bytes = glbOf(packed);
    if (!bytes) return Error{file.string(), {}, bytes.error().reason};
    if (auto written = writeFileAtomically(file, bytes.value()); !written) return written.error();
    return std::uint64_t{bytes->size()};
  }
  const std::string text = gltfOf(packed, files.front().filename().string());
  if (auto written = writeFilesAtomically({{files.front(), packed.binary}, {file, text}}); !written) {
    return written.error();
  }
  return std::uint64_t{text.size() + packed.binary.size()};
}

}  // namespace sinew::exporting
