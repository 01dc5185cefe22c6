// core/geometry/result.cpp: errors as one line of text.
#include "sinew/geometry/result.h"

#include <initializer_list>

namespace sinew {
namespace {

std::string joined(std::initializer_list<const std::string*> parts) {
  std::string line;
  for (const std::string* part : parts) {
    if (part->empty()) continue;
    if (!line.empty()) line += ": ";
    line += *part;
  }
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace

std::string Error::text() const { return joined({&file, &place, &reason}); }

std::string Error::plainText() const {
  if (subject.empty()) return text();
  const std::string name = file.substr(file.find_last_of('/') + 1);
  std::string line = joined({&name, &subject, &reason});
  if (name.empty() && line[0] >= 'a' && line[0] <= 'z') line[0] = static_cast<char>(line[0] - 'a' + 'A');
  return line;
}

Error errorAt(std::string place, std::string reason, std::string subject) {
  return Error{{}, std::move(place), std::move(reason), std::move(subject)};
}

Error about(const std::string& whole, Error error) {
  error.subject = error.subject.empty() ? whole : whole + ", " + error.subject;
  return error;
}

}  // namespace sinew
