// core/base/result.cpp: an error as one line.
#include "sinew/base/result.h"

namespace sinew {

std::string Error::text() const {
  std::string line;
  for (const std::string* part : {&file, &place, &reason}) {
    if (part->empty()) continue;
    if (!line.empty()) line += ": ";
    line += *part;
  }
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

Error errorAt(std::string place, std::string reason) { return Error{{}, std::move(place), std::move(reason)}; }

}  // namespace sinew
