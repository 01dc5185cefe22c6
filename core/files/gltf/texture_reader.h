// core/files/gltf/texture_reader.h: the textures of a file, each decoded once.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "core/files/gltf/file.h"
#include "core/files/gltf/notes.h"
#include "sinew/character/material.h"

namespace sinew::gltf {

/// Reads textures as they are asked for, within one budget for all.
class TextureReader {
 public:
  TextureReader(File& file, Notes& notes) : file_(file), notes_(notes) {}

  /// Index into take(), or -1: one that cannot be read is noted and left out. Refuses an unsound texture, and a uri
  /// outside the folder.
  int read(int index);
  [[nodiscard]] std::vector<Texture> take() && { return std::move(textures_); }

 private:
  [[nodiscard]] Texture readSampler(int index) const;
  int decode(std::size_t image, Texture texture);

  File& file_;
  Notes& notes_;
  std::map<std::tuple<int, TextureWrap, TextureWrap, bool>, int> known_;
  std::size_t pixels_ = 0;
  std::size_t encodedBytes_ = 0;
  std::vector<Texture> textures_;
};

}  // namespace sinew::gltf
