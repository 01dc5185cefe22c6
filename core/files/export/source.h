// core/files/export/source.h: the file of a character, opened again for an export; checks and writing.
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "core/files/disk/atomic_file.h"
#include "core/files/fit/poses.h"
#include "core/files/gltf/accessor.h"
#include "core/files/gltf/file.h"
#include "core/files/gltf/mesh.h"
#include "core/files/gltf/skin.h"
#include "core/files/json/json.h"
#include "core/geometry/weld.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"

namespace sinew::exporting {

/// make(), with what it throws as the Error. @param file  to be written  @param make  () -> Result<Report>
template <class Make>
[[nodiscard]] auto catchErrors(const std::filesystem::path& characterFile, const std::filesystem::path& file,
                               const Make& make) -> decltype(make()) {
  try {
    return make();
  } catch (const gltf::Refusal& refusal) {
    return Error{characterFile.string(), refusal.error.place, refusal.error.reason};
  } catch (const Canceled&) {
    return Error{file.string(), {}, std::string(kCanceled)};
  } catch (const std::bad_alloc&) {
    return Error{characterFile.string(), {}, "there is not enough memory to export it"};
  } catch (const std::exception& error) {
    return Error{characterFile.string(), {}, shortened(error.what())};
  }
}

struct Source {
  /// Reads the file once, so that requireSame() compares what is exported. Throws gltf::Refusal.
  explicit Source(const std::filesystem::path& from);

  std::filesystem::path path;
  Json root;  ///< All of the file's JSON, with extras, uncompressed.
  gltf::File file;
  gltf::Accessors accessors;
  gltf::BoundSkeleton bound;
  TriangleSoup soup;
  gltf::SoupOrigin origin;
  ControlMesh mesh;                       ///< The soup, welded.
  std::vector<MorphTarget> morphTargets;  ///< Of that mesh.
  std::vector<int> controlTriangle;       ///< [soup triangles] with the same corners; -1: dropped.
  std::vector<int> fileNode;              ///< [skeleton nodes] node of the file.

  /// Whether a path is the file itself or one of its buffers or images.
  [[nodiscard]] bool reads(const std::filesystem::path& other) const;
  [[nodiscard]] int nodeOfBone(int bone) const;  ///< Node of a bone in the file.
  [[nodiscard]] int nodeOf(int binding) const;   ///< Node of a binding's bone.

 private:
  Source(const std::filesystem::path& from, std::vector<std::uint8_t> contents);
};

/// Throws gltf::Refusal unless mesh, morph targets, joints and clips of the character are those of the file now: it may
/// have changed since the import. Ignores clips made in memory or added from other files.
void requireSame(const Source& source, const Character& character);

// Checks and writing.

/// Error: no such clip; lists those that exist.
[[nodiscard]] Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                                      const std::vector<std::string>& asked);

/// Error: clips of more than an hour together, as each second needs 30 poses. @param asked  names; empty: all
[[nodiscard]] Result<void> checkSeconds(const std::filesystem::path& file, const Character& character,
                                        const std::vector<std::string>& asked);

/// Error: no such folder, a target is a folder, or the character is read from it. @param files  the main one last
[[nodiscard]] Result<void> checkPlaces(const Source& source, const std::vector<std::filesystem::path>& files);

/// checkPlaces(), then writes all files or none. Returns their bytes.
[[nodiscard]] Result<std::uint64_t> writeFiles(const Source& source, const std::vector<NamedBytes>& files);

}  // namespace sinew::exporting
