// app/command/verbs.h: the command line: its verbs, and what they share.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/command/batch.h"
#include "app/command/surface_options.h"
#include "app/document/farm_job.h"

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace sinew::app {

struct FarmCheck {
  std::size_t files = 0;  ///< The job makes.
  TaskNeeds needs;
};

/// One input of a job, opened.
struct InputCheck {
  std::shared_ptr<const Character> character;
  Rig rig;  ///< With the overrides of the command line.
  ClipFrames frames;
  double heldFrames = 0.0;  ///< As taskNeeds().
};

/// Opens every input as the verb would, so that a job fails here and not on each machine. Error: no input, a file that
/// cannot be read, a clip that does not exist or has none of the frames, or an output folder that does not exist.
[[nodiscard]] Result<FarmCheck> checkForFarm(const std::string& verb, const Batch& batch, const BatchOptions& options,
                                             const std::function<Result<InputCheck>(const BatchInput&)>& open);

/// What a verb does after parsing.
struct VerbCalls {
  std::function<int()> run;                  ///< Returns the exit status (docs/formats.md).
  std::function<Result<FarmCheck>()> check;  ///< Whether a farm can run it; null: not for farms.
};

/// A row of the table in verbs.cpp.
struct Verb {
  std::string name;
  std::string summary;                             ///< One line of the help.
  std::function<VerbCalls(CLI::App& parser)> add;  ///< Adds the verb's options to its parser.
};

/// A verb that reads into `Options`.
/// @param add    void(CLI::App&, Options&): the options keep their address.
/// @param run    int(const Options&): returns the exit status (docs/formats.md).
/// @param check  Result<FarmCheck>(const Options&); without it the verb is not for farms.
template <class Options, class Add, class Run, class Check = std::nullptr_t>
[[nodiscard]] Verb makeVerb(std::string name, std::string summary, Add add, Run run, Check check = {}) {
  const auto addTo = [add, run, check](CLI::App& parser) -> VerbCalls {
    const auto options = std::make_shared<Options>();
    add(parser, *options);
    VerbCalls calls{[options, run] { return run(*options); }, nullptr};
    if constexpr (!std::is_null_pointer_v<Check>) calls.check = [options, check] { return check(*options); };
    return calls;
  };
  return {std::move(name), std::move(summary), addTo};
}

/// Adds an option or positional argument that is a path.
CLI::Option* addPath(CLI::App& verb, const char* name, std::filesystem::path& path, const std::string& help);

/// Why a parse failed, with the option that was probably meant.
[[nodiscard]] std::string parseRefusal(const CLI::App& parser, const CLI::ParseError& error);

[[nodiscard]] Verb inspectVerb();
[[nodiscard]] Verb checkRigVerb();
[[nodiscard]] Verb muscleVerb();
[[nodiscard]] Verb retargetVerb();
[[nodiscard]] Verb fitVerb();
[[nodiscard]] Verb smoothVerb();
[[nodiscard]] Verb exportVerb();
[[nodiscard]] Verb packVerb();
[[nodiscard]] Verb renderVerb();
[[nodiscard]] Verb benchVerb();
/// @param verbs  those that a farm can run: they take --shard and --resume
[[nodiscard]] Verb farmVerb(std::vector<Verb> verbs);

/// Options of the editor; main passes them on, since the command line must not depend on the window.
struct EditRequest {
  std::string file;      ///< "" for the bundled character.
  std::string logState;  ///< "" for none.
  float scale = 0.0f;    ///< 0: from preferences or the system.
};
using RunEditor = std::function<int(const EditRequest&)>;

/// Runs the verb of a command line, or `edit` without one. Returns the exit status (docs/formats.md).
[[nodiscard]] int runCommandLine(int argc, const char* const* argv, const RunEditor& edit);

}  // namespace sinew::app
