// app/command/farm_check.cpp: every input is opened here once, rather than fail on each machine.
#include "app/command/farm_check.h"

#include <set>
#include <system_error>

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

}  // namespace sinew::app
