// app/command/verb.h: what a verb of the command line is, and all verbs.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/command/farm_check.h"

namespace CLI {
class App;
}

namespace sinew::app {

/// What a verb does after the parse.
struct VerbCalls {
  std::function<int()> run;                  ///< Returns the exit status (docs/formats.md).
  std::function<Result<FarmCheck>()> check;  ///< Whether a farm can run it; null: it is not for farms.
};

/// A row of the table in app/command/verbs.cpp.
struct Verb {
  std::string name;
  std::string summary;  ///< One line of the help.
  /// Adds what the verb reads to its parser. Returns what it does after the parse.
  std::function<VerbCalls(CLI::App& parser)> add;
};

/// A verb that reads into `Options`.
/// @param add  void(CLI::App&, Options&): the options stay where they are.
/// @param run  int(const Options&): returns the exit status (docs/formats.md).
template <class Options, class Add, class Run>
[[nodiscard]] Verb makeVerb(std::string name, std::string summary, Add add, Run run) {
  const auto addTo = [add, run](CLI::App& parser) -> VerbCalls {
    const auto options = std::make_shared<Options>();
    add(parser, *options);
    return {[options, run] { return run(*options); }, nullptr};
  };
  return {std::move(name), std::move(summary), addTo};
}

/// The same for farms. @param check  Result<FarmCheck>(const Options&)
template <class Options, class Add, class Run, class Check>
[[nodiscard]] Verb makeVerb(std::string name, std::string summary, Add add, Run run, Check check) {
  const auto addTo = [add, run, check](CLI::App& parser) -> VerbCalls {
    const auto options = std::make_shared<Options>();
    add(parser, *options);
    return {[options, run] { return run(*options); }, [options, check] { return check(*options); }};
  };
  return {std::move(name), std::move(summary), addTo};
}

[[nodiscard]] Verb inspectVerb();
[[nodiscard]] Verb checkRigVerb();
[[nodiscard]] Verb muscleVerb();
[[nodiscard]] Verb retargetVerb();
[[nodiscard]] Verb smoothVerb();
[[nodiscard]] Verb exportVerb();
[[nodiscard]] Verb packVerb();
[[nodiscard]] Verb renderVerb();
[[nodiscard]] Verb benchVerb();
/// @param verbs  those that a farm can share: they take --shard and --resume.
[[nodiscard]] Verb farmVerb(std::vector<Verb> verbs);

}  // namespace sinew::app
