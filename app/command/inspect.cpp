// app/command/inspect.cpp: `sinew inspect`: counts, names and defects of characters and rigs, as JSON or text.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/inspect_facts.h"
#include "app/command/surface_options.h"
#include "app/command/verbs.h"
#include "app/document/document.h"

namespace sinew::app {
namespace {

struct InspectOptions {
  std::vector<std::string> files;
  std::vector<std::string> clips;  ///< Files whose clips are added.
  bool json = false;
  bool strict = false;  ///< A rig with missing bones is a bad input.
};

/// Passes the facts of one file, or the error, to `put`. False: the file fails.
template <class Put>
bool inspectFile(const InspectOptions& options, const std::string& file, Put put) {
  const auto document = openDocument(file, {options.clips.begin(), options.clips.end()});
  if (!document) {
    put(nullptr, document.error());
    return badInput(document.error()) == kDone;
  }
  const InspectFacts facts = factsOf(document.value());
  put(&facts, Error{});
  const std::size_t missing = facts.rig.missing.size();
  const std::vector<Error> clipFiles = missingOf(document->clipFiles.files);
  if (options.strict && missing == 0 && !clipFiles.empty()) {
    return badInput({file, "", "clips of the rig are left out: " + clipFiles.front().text()}) == kDone;
  }
  if (!options.strict || missing == 0) return true;
  const std::string bones = std::to_string(missing) + (missing == 1 ? " bone" : " bones");
  return badInput({file, "", bones + " of the rig missing in " + facts.document.characterFile.string()}) == kDone;
}

/// Columns as wide as needed: the first aligned left, the numbers right.
std::string tableOf(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      widths[column] = std::max(widths[column], row[column].size());
    }
  }
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string blank(widths[column] - row[column].size(), ' ');
      text += column == 0 ? row[column] + blank : "  " + blank + row[column];
    }
    text += '\n';
  }
  return text;
}

int runInspect(const InspectOptions& options) {
  Json array = Json::array();
  std::vector<std::vector<std::string>> rows{inspectHead()};
  const bool several = options.files.size() > 1;
  std::string one;
  std::size_t failed = 0;
  ProgressLine line("inspecting", false);
  for (std::size_t i = 0; i < options.files.size(); ++i) {
    const std::string& file = options.files[i];
    const auto put = [&](const InspectFacts* facts, const Error& error) {
      if (facts == nullptr) {
        array.push(Json::object().set("file", file).set("error", error.text()));
      } else if (options.json) {
        array.push(inspectJson(*facts, file));
      } else if (several) {
        rows.push_back(inspectRow(*facts, file));
      } else {
        one = inspectText(*facts);
      }
    };
    if (!inspectFile(options, file, put)) ++failed;
    if (several) line.show(static_cast<double>(i + 1) / static_cast<double>(options.files.size()));
  }
  line.end();
  const bool nothingRead = rows.size() == 1 && one.empty() && !options.json;
  if (options.json && several) one = array.dump(true) + '\n';
  else if (options.json) one = array.items().front().find("error") ? "" : array.items().front().dump(true) + '\n';
  else if (several && !nothingRead) one = tableOf(rows);
  if (const int status = putResult(one); status != kDone) return status;
  if (failed == 0) return kDone;
  return failed == options.files.size() ? kBadInput : kSomeFailed;
}

void addInspectOptions(CLI::App& verb, InspectOptions& options) {
  verb.add_option("FILE", options.files, "Characters (.glb, .gltf, .vrm) or rigs (.rig.json); of several, a table")
      ->required();
  addClipsOption(verb, options.clips);
  verb.add_flag("--json", options.json,
                "Print JSON, for programs: an object, or an array where there are several files");
  verb.add_flag("--strict", options.strict,
                "Exit with status 1 if a rig names bones that its character lacks, or clip files that cannot be read");
}

}  // namespace

Verb inspectVerb() {
  return makeVerb<InspectOptions>("inspect", "Describe characters and rigs, and what is wrong with them",
                                  addInspectOptions, runInspect);
}

}  // namespace sinew::app
