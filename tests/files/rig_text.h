// tests/files/rig_text.h: helpers for the text of rig files.
#pragma once

#include <string>

namespace sinew {

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Removes layout whitespace.
inline std::string squeezed(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

}  // namespace sinew
