// app/document/damaged_file.cpp: why a file could not be opened, in the words of who made it.

#include "app/document/damaged_file.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace sinew::app {
namespace {

/// "line 12, column 3" of "byte 61 (line 12, column 3)"; empty for any other place.
std::string lineOf(const std::string& place) {
  const std::size_t from = place.find("(line ");
  if (!place.starts_with("byte ") || from == std::string::npos || !place.ends_with(')')) return "";
  return place.substr(from + 1, place.size() - from - 2);
}

/// What the parser says (core/files/json/json.cpp), and what it means.
struct Meaning {
  std::string_view said;
  const char* meant;
};

constexpr std::array kMeanings{
    Meaning{"unexpected end of input", "the file ends too early"},
    Meaning{"missing closing quote", "a text has no closing quote"},
    Meaning{"UTF-8", "this is no text (not UTF-8)"},
    Meaning{"invalid number", "this is no number"},
    Meaning{"control character", "a line break or control character inside a text"},
    Meaning{"expected end of input", "the file goes on after its end"},
    Meaning{"'}'; expected", "a \"}\" where something else should be, perhaps after a comma too many"},
    Meaning{"']'; expected", "a \"]\" where something else should be, perhaps after a comma too many"},
    Meaning{"; expected '}'", "a comma or a closing bracket is missing before this"},
    Meaning{"; expected ']'", "a comma or a closing bracket is missing before this"},
    Meaning{"expected ':'", "a colon is missing before this"},
};

std::string meaningOf(const std::string& reason) {
  for (const Meaning& meaning : kMeanings) {
    if (reason.find(meaning.said) != std::string::npos) return meaning.meant;
  }
  return "this cannot be read";
}

}  // namespace

std::string openErrorText(const Error& error) {
  const std::string line = lineOf(error.place);
  if (line.empty()) return error.plainText();
  const std::string name = std::filesystem::path(error.file).filename().string();
  const bool rig = name.ends_with(".json");
  return (name.empty() ? "The file" : name) + " is damaged or not a " + (rig ? "rig" : "character") + ": " + line +
         ": " + meaningOf(error.reason);
}

}  // namespace sinew::app
