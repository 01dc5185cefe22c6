// core/files/gltf/notes.h: what an import leaves out, gathered into few lines.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace sinew::gltf {

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

}  // namespace sinew::gltf
