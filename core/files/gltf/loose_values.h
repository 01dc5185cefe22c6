// core/files/gltf/loose_values.h: extensions, which tinygltf keeps as loose values; the guard has seen to their types.
#pragma once

#include <array>

#include <tiny_gltf.h>

namespace sinew::gltf {

/// Null where it is absent.
inline const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

inline double looseNumber(const tinygltf::Value& object, const char* key, double fallback) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

template <std::size_t N>
void looseNumbers(const tinygltf::Value& object, const char* key, std::array<double, N>& out) {
  for (std::size_t i = 0; object.Has(key) && i < N; ++i) {
    out[i] = object.Get(key).Get(static_cast<int>(i)).GetNumberAsDouble();
  }
}

}  // namespace sinew::gltf
