// core/files/export/out_files.cpp: which files an export writes, what stands in the way, and writing them.
#include "core/files/export/out_files.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/character/clip_names.h"
#include "core/files/export/formats.h"

namespace sinew::exporting {
namespace {

constexpr double kMostSeconds = 3600.0;

}  // namespace

Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                        const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    if (std::ranges::find(character.clips, name, &AnimationClip::name) != character.clips.end()) continue;
    return Error{file.string(), "clip \"" + name + '"', noSuchClip(name, character.clips)};
  }
  return {};
}

Result<void> checkSeconds(const std::filesystem::path& file, const Character& character,
                          const std::vector<std::string>& asked) {
  double seconds = 0.0;
  for (const AnimationClip& clip : character.clips) {
    if (asked.empty() || std::ranges::count(asked, clip.name) > 0) seconds += static_cast<double>(clip.duration);
  }
  if (seconds <= kMostSeconds) return {};
  return Error{file.string(), "clips",
               "last " + std::to_string(std::llround(seconds)) + " seconds together; expected at most " +
                   std::to_string(std::llround(kMostSeconds)) + ": choose fewer of them"};
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

Result<std::uint64_t> writeFiles(const Source& source, const std::vector<NamedBytes>& files) {
  std::vector<std::filesystem::path> places;
  std::uint64_t bytes = 0;
  for (const NamedBytes& each : files) {
    places.push_back(each.file);
    bytes += each.bytes.size();
  }
  if (auto free = checkPlaces(source, places); !free) return free.error();
  const auto written =
      files.size() == 1 ? writeFileAtomically(files.front().file, files.front().bytes) : writeFilesAtomically(files);
  if (!written) return written.error();
  return bytes;
}

Result<std::uint64_t> writeGlb(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                               std::vector<std::string>& /*left*/) {
  const Result<std::string> bytes = glbOf(packed);
  if (!bytes) return Error{file.string(), {}, bytes.error().reason};
  return writeFiles(source, {{file, bytes.value()}});
}

Result<std::uint64_t> writeGltf(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                                std::vector<std::string>& /*left*/) {
  std::filesystem::path binary = file;
  binary.replace_extension(".bin");
  const std::string text = gltfOf(packed, binary.filename().string());
  return writeFiles(source, {{binary, packed.binary}, {file, text}});
}

}  // namespace sinew::exporting
