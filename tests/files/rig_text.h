// tests/files/rig_text.h: looks at a rig file's text.
#pragma once

#include <string>

namespace sinew {

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Without the layout.
inline std::string squeezed(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

}  // namespace sinew
