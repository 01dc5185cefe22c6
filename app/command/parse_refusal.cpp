// app/command/parse_refusal.cpp: a misspelled option beside those that there are.
#include "app/command/parse_refusal.h"

#include <algorithm>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

std::vector<std::string> optionNames(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::Option* option : parser.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

std::string parseRefusal(const CLI::App& parser, const CLI::ParseError& error) {
  // What is required may be there, misspelled.
  const bool isMissing = dynamic_cast<const CLI::RequiredError*>(&error) && !parser.get_allow_extras();
  if (!isMissing && dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return error.what();
  const std::vector<std::string> extras = parser.remaining(true);
  const auto unknown = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with("--"); });
  if (unknown == extras.end()) return error.what();
  const std::string option = unknown->substr(0, unknown->find('='));
  return "there is no option " + option + didYouMean(option, optionNames(parser));
}

}  // namespace sinew::app
