// app/command/batch_names.cpp: fields in names, filled in.
#include "app/command/batch_names.h"

#include <charconv>
#include <cstddef>

#include "app/document/rig_list.h"

namespace sinew::app {
namespace {

constexpr const char* kNameField = "{name}";

/// The place of a %d or %0Nd field in a file name; length 0: none.
struct FrameField {
  std::size_t at = 0, length = 0;
  int width = 0;
  bool zeros = false;
};

/// nullopt: there is a '%' that is no such field, or more than one field.
std::optional<FrameField> frameField(const std::string& name) {
  FrameField field;
  const std::size_t at = name.find('%');
  if (at == std::string::npos) return field;
  std::size_t end = at + 1;
  while (end < name.size() && name[end] >= '0' && name[end] <= '9') ++end;
  if (end == name.size() || name[end] != 'd' || end - at > 3 || name.find('%', end) != std::string::npos)
    return std::nullopt;
  field.at = at;
  field.length = end + 1 - at;
  field.zeros = name[at + 1] == '0';
  std::from_chars(name.data() + at + 1, name.data() + end, field.width);
  return field;
}

std::string withFrame(const std::string& name, const FrameField& field, int frame) {
  std::string digits = std::to_string(frame);
  const auto width = static_cast<std::size_t>(field.width);
  if (digits.size() < width) digits.insert(0, width - digits.size(), field.zeros ? '0' : ' ');
  return std::string(name).replace(field.at, field.length, digits);
}

}  // namespace

Result<std::filesystem::path> nameOfItem(const std::filesystem::path& pattern, const std::string& option,
                                         const std::filesystem::path& input, bool listed, std::optional<int> frame) {
  std::string name = pattern.string();
  if (frame) {
    const auto field = frameField(name);
    if (!field || field->length == 0) {
      return errorAt(option, "expected one frame number field such as %04d in the name, got \"" + name + '"');
    }
    name = withFrame(name, *field, *frame);
  }
  if (const auto field = frameField(name); !frame && field && field->width > 0) {
    return errorAt("--frames", "expected, for the frame number in \"" + name + '"');
  }
  if (!listed) return std::filesystem::path(name);
  std::size_t at = name.find(kNameField);
  if (at == std::string::npos) {
    return errorAt(option, "expected {name} in the name, for the inputs of the list, got \"" + name + '"');
  }
  const std::string own = nameWithoutEnding(input);
  for (; at != std::string::npos; at = name.find(kNameField, at + own.size())) {
    name.replace(at, std::string(kNameField).size(), own);
  }
  return std::filesystem::path(name);
}

}  // namespace sinew::app
