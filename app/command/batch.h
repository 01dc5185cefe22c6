// app/command/batch.h: a job of many files, whole or a share of it: what every verb that writes files in series has in
// common. docs/install.md.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/command/console.h"
#include "sinew/geometry/result.h"

namespace CLI {
class App;
}

namespace sinew::app {

/// As the command line says it.
struct BatchOptions {
  std::string frames;  ///< "A:B" or "A:B:STEP", both ends included; empty: one moment.
  double framesPerSecond = 30.0;
  std::filesystem::path list;  ///< A file, one input per line, "-" for stdin; empty: the verb's one input.
  std::string shard;           ///< "I/N" or "auto"; empty: the whole job.
  bool resume = false;
  bool dryRun = false;
  int threads = 0;        ///< At most; 0: one a core.
  bool progress = false;  ///< Also where stderr is no terminal.
};

/// --frames and --fps.
void addFrameOptions(CLI::App& verb, BatchOptions& options);
/// --list, --shard, --resume, --dry-run, --threads and --progress.
void addBatchOptions(CLI::App& verb, BatchOptions& options);

/// One input of a job.
struct BatchInput {
  std::filesystem::path file;
  std::vector<std::filesystem::path> outputs;  ///< [moments] of the whole job.
  std::vector<std::size_t> wanted;             ///< The moments to be made now, ascending.
};

struct Batch {
  std::vector<BatchInput> inputs;  ///< In order.
  std::vector<int> frames;         ///< [moments]; empty: one moment without a frame.
  bool listed = false;             ///< The inputs are from a list.
};

/// The frames that --frames names, ascending; empty without it. Error: place is the option.
[[nodiscard]] Result<std::vector<int>> frameNumbers(const BatchOptions& options);

/// Reads the list, numbers the job's items (input by input, frame by frame) and keeps this shard's: those whose number
/// modulo N is I; to resume, those of them that are not there yet.
/// @param output  with frames a printf integer field such as %04d in its name; with a list "{name}", which stands for
///   the input's name without its ending
/// Error: place is the option or the list's file, reason what was expected of it; two items write one file,
/// or one writes what it is read from.
[[nodiscard]] Result<Batch> planBatch(const BatchOptions& options, const std::filesystem::path& input,
                                      const std::filesystem::path& output);

/// A second file beside each output, such as a report. Errors as planBatch. @param batch  of `options`
[[nodiscard]] Result<std::vector<std::filesystem::path>> filesBeside(const Batch& batch, const BatchInput& input,
                                                                     const std::filesystem::path& pattern,
                                                                     const std::string& option);

/// How much of a job is made, on stderr.
class BatchProgress {
 public:
  /// @param what  the work: "rendering fox_%04d.png"
  BatchProgress(const std::string& what, const Batch& batch, const BatchOptions& options);
  /// @param made  files of the input at hand
  void show(std::size_t made);
  /// @param part  of the one file of the input at hand, 0..1
  void showPart(double part);
  /// All that will come of this input is made.
  void leave(const BatchInput& input);

 private:
  ProgressLine line_;
  std::size_t all_ = 0;
  std::size_t before_ = 0;  ///< Files of the inputs that are done.
};

/// Calls make(input) for every input that has work to do, on as many threads as the options say. A dry run prints the
/// files instead, unless the job has frames: which of them the clip holds, `make` finds out and prints. `make` returns
/// an exit status and has named its failures. Returns kDone, what `make` returned where there is no list, kSomeFailed
/// where some inputs of a list failed, kBadInput where all did.
[[nodiscard]] int runBatch(const Batch& batch, const BatchOptions& options,
                           const std::function<int(const BatchInput&)>& make);

/// What a dry run says of an input. @param wanted  moments
[[nodiscard]] int putNames(const BatchInput& input, const std::vector<std::size_t>& wanted);

/// The time of a moment. @param index  of Batch::frames
[[nodiscard]] inline double secondsAt(const Batch& batch, const BatchOptions& options, std::size_t index) {
  return batch.frames[index] / options.framesPerSecond;
}

}  // namespace sinew::app
