// core/files/export/source.h: the file a character came from, open again, with the way from its triangles to the mesh.
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

// What an export throws inside, as the error that it returns.

/// @param file  that is written  @param make  () -> Result<Report>
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
  /// Reads the file once: what requireSame() compares and what is written again are one version. Throws gltf::Refusal.
  explicit Source(const std::filesystem::path& from);

  std::filesystem::path path;
  Json root;  ///< All of the file's JSON, extras too, plain where it was compressed.
  gltf::File file;
  gltf::Accessors accessors;
  gltf::BoundSkeleton bound;
  TriangleSoup soup;
  gltf::SoupOrigin origin;
  ControlMesh mesh;                       ///< The soup, welded.
  std::vector<MorphTarget> morphTargets;  ///< Of that mesh.
  std::vector<int> controlTriangle;       ///< [soup triangles] of the character's mesh, corner for corner; -1: dropped.
  std::vector<int> fileNode;              ///< [skeleton nodes] node of the file.

  /// Whether a path is the file itself or one that it reads its buffers or images from.
  [[nodiscard]] bool reads(const std::filesystem::path& other) const;
  /// Node of the file that a bone is.
  [[nodiscard]] int nodeOfBone(int bone) const;
  /// That a binding's bone is.
  [[nodiscard]] int nodeOf(int binding) const;

 private:
  Source(const std::filesystem::path& from, std::vector<std::uint8_t> contents);
};

/// Throws gltf::Refusal unless mesh, morph targets, joints and clips of the character are those that the file gives
/// now: it may have been replaced since it was imported. Clips that were made in memory, or added from other
/// files, do not count.
void requireSame(const Source& source, const Character& character);

// What an export may write, and writing it.

/// Error: a clip that the character does not have, and those that it has.
[[nodiscard]] Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                                      const std::vector<std::string>& asked);

/// Error: clips of more than an hour together. Each second is 30 poses that are smoothed, fitted and measured.
/// @param asked  names; empty: all
[[nodiscard]] Result<void> checkSeconds(const std::filesystem::path& file, const Character& character,
                                        const std::vector<std::string>& asked);

/// Before the work. Error: no such folder, a place that is a folder, or one that the character is read from.
/// @param files  the one that was asked for last
[[nodiscard]] Result<void> checkPlaces(const Source& source, const std::vector<std::filesystem::path>& files);

/// Checks the places and writes all files or none. Returns the bytes of all of them. @param files  as checkPlaces()
[[nodiscard]] Result<std::uint64_t> writeFiles(const Source& source, const std::vector<NamedBytes>& files);

}  // namespace sinew::exporting
