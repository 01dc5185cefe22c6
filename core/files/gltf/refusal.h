// core/files/gltf/refusal.h: how the stages of the import give up.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <tiny_gltf.h>

#include "sinew/geometry/result.h"

namespace sinew::gltf {

// Extensions, which tinygltf keeps as loose values; the guard has seen to their types.

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

// What an import leaves out, gathered into few lines.

/// Things the file holds and Sinew does not use. The same line many times becomes one with a count.
class Notes {
 public:
  void add(const std::string& line) {
    if (counts_.size() >= kMaxLines && !counts_.contains(line)) {
      ++beyond_;
      return;
    }
    if (++counts_[line] == 1) order_.push_back(line);
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> result;
    for (const std::string& line : order_) {
      const int count = counts_.at(line);
      result.push_back(count == 1 ? line : line + " (" + std::to_string(count) + " times)");
    }
    if (beyond_ > 0) result.push_back("and " + std::to_string(beyond_) + " more");
    return result;
  }

 private:
  static constexpr std::size_t kMaxLines = 200;
  std::map<std::string, int> counts_;
  std::vector<std::string> order_;
  int beyond_ = 0;
};

/// importGltf turns it into a Result; it never leaves core/files.
struct Refusal {
  Error error;
};
/// @param subject  what it is about, where the reason is one that people understand who do not know the format
[[noreturn]] inline void refuse(std::string place, std::string reason, std::string subject = {}) {
  throw Refusal{errorAt(std::move(place), std::move(reason), std::move(subject))};
}

/// "nodes[3]", the JSON path of an element.
[[nodiscard]] inline std::string placeOf(const std::string& list, std::size_t index) {
  return list + '[' + std::to_string(index) + ']';
}

}  // namespace sinew::gltf
