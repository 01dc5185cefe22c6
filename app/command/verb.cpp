// app/command/verb.cpp: inputs checked for a farm, path options, refusals of the parser.
#include "app/command/verb.h"

#include <algorithm>
#include <set>
#include <system_error>

#include <CLI/CLI.hpp>

#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

Result<void> checkFolders(const BatchInput& input, std::set<std::filesystem::path>& known) {
  for (const std::filesystem::path& output : input.outputs) {
    const std::filesystem::path folder = output.parent_path();
    std::error_code failed;
    if (folder.empty() || known.contains(folder)) continue;
    if (!std::filesystem::is_directory(folder, failed)) {
      return Error{output.string(), "", "cannot be written: there is no such folder"};
    }
    known.insert(folder);
  }
  return {};
}

std::vector<std::string> optionNames(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::Option* option : parser.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

Result<FarmCheck> checkForFarm(const std::string& verb, const Batch& batch, const BatchOptions& options,
                               const std::function<Result<InputCheck>(const BatchInput&)>& open) {
  FarmCheck check;
  std::set<std::filesystem::path> folders;
  ProgressLine line("checking", false);
  for (const BatchInput& input : batch.inputs) {
    if (const auto found = checkFolders(input, folders); !found) return found.error();
    const auto opened = open(input);
    if (!opened) return opened.error();
    const auto needs = taskNeeds(verb, opened->character, opened->rig, options.threads, opened->heldFrames);
    if (!needs) return Error{input.file.string(), needs.error().place, needs.error().reason};
    check.needs = larger(check.needs, needs.value());
    check.files += opened->frames.count;
    if (!opened->frames.left.empty()) message(opened->frames.left);
    if (batch.listed)
      line.show(static_cast<double>(&input - batch.inputs.data() + 1) / static_cast<double>(batch.inputs.size()));
  }
  return check;
}

CLI::Option* addPath(CLI::App& verb, const char* name, std::filesystem::path& path, const std::string& help) {
  return verb.add_option_function<std::string>(
      name, [&path](const std::string& text) { path = text; }, help);
}

std::string parseRefusal(const CLI::App& parser, const CLI::ParseError& error) {
  // A required option may be there, misspelled.
  const bool isMissing = dynamic_cast<const CLI::RequiredError*>(&error) && !parser.get_allow_extras();
  if (!isMissing && dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return error.what();
  const std::vector<std::string> extras = parser.remaining(true);
  const auto unknown = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with("--"); });
  if (unknown == extras.end()) return error.what();
  const std::string option = unknown->substr(0, unknown->find('='));
  return "there is no option " + option + didYouMean(option, optionNames(parser));
}

}  // namespace sinew::app
