// core/files/export/source.h: the file a character came from, open again, with the way from its triangles to the mesh.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/files/gltf/accessor.h"
#include "core/files/gltf/file.h"
#include "core/files/gltf/mesh.h"
#include "core/files/gltf/skin.h"
#include "core/files/json/json.h"
#include "core/geometry/weld.h"
#include "sinew/character/character.h"

namespace sinew::exporting {

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

}  // namespace sinew::exporting
