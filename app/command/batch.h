// app/command/batch.h: jobs that write many files, and the part of one that a process makes. docs/install.md.
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

/// One process's part of a job.
struct Shard {
  int index = 0;  ///< 0..count-1.
  int count = 1;

  [[nodiscard]] bool holds(std::size_t item) const {
    return item % static_cast<std::size_t>(count) == static_cast<std::size_t>(index);
  }
};

/// "I/N", or "auto": from the environment of a Slurm (SLURM_ARRAY_TASK_ID, _MIN, _MAX, _STEP) or Grid Engine
/// (SGE_TASK_ID, _FIRST, _LAST, _STEPSIZE) array job. "": the whole job. Error: place is "--shard".
[[nodiscard]] Result<Shard> shardOf(const std::string& text);

/// As given on the command line.
struct BatchOptions {
  std::string frames;  ///< "A:B" or "A:B:STEP", both ends included; empty: one file.
  double framesPerSecond = 30.0;
  std::filesystem::path list;  ///< A file, one input per line, "-" for stdin; empty: the verb's one input.
  std::string shard;           ///< "I/N" or "auto"; empty: the whole job.
  bool resume = false;
  bool dryRun = false;
  int threads = 0;        ///< At most; 0: one per core.
  bool progress = false;  ///< Even where stderr is not a terminal.
};

void addFrameOptions(CLI::App& verb, BatchOptions& options);  ///< --frames and --fps.
/// --list, --shard, --resume, --dry-run, --threads and --progress.
void addBatchOptions(CLI::App& verb, BatchOptions& options);

/// One input of a job.
struct BatchInput {
  std::filesystem::path file;
  std::vector<std::filesystem::path> outputs;  ///< [moments] of the whole job.
  std::vector<std::size_t> wanted;             ///< Moments to make now, ascending.
};

struct Batch {
  std::vector<BatchInput> inputs;  ///< In order.
  std::vector<int> frames;         ///< [moments]; empty: one moment without a frame number.
  bool listed = false;             ///< The inputs come from a list.
};

/// The frames of --frames, ascending; empty without it. Error: place is the option.
[[nodiscard]] Result<std::vector<int>> frameNumbers(const BatchOptions& options);

/// Reads the list, numbers the job's items (input by input, frame by frame) and keeps those of this shard: number
/// modulo N is I. With --resume, items that exist already are skipped.
/// @param output  with frames its name has a printf integer field such as %04d; with a list "{name}", which stands for
///   the input's name without its ending
/// Error: place is the option or the list's file. Also if two items write one file, or one would overwrite its input.
[[nodiscard]] Result<Batch> planBatch(const BatchOptions& options, const std::filesystem::path& input,
                                      const std::filesystem::path& output);

/// A second file for each output, such as a report. Errors as planBatch.
[[nodiscard]] Result<std::vector<std::filesystem::path>> filesBeside(const Batch& batch, const BatchInput& input,
                                                                     const std::filesystem::path& pattern,
                                                                     const std::string& option);

/// Reports the progress of a job on stderr.
class BatchProgress {
 public:
  /// @param what  the work: "rendering fox_%04d.png"
  BatchProgress(const std::string& what, const Batch& batch, const BatchOptions& options);
  /// @param made  files of the current input
  void show(std::size_t made) { showPart(static_cast<double>(made)); }
  void showPart(double part);           ///< @param part  of the current input's one file, 0..1
  void leave(const BatchInput& input);  ///< The input is done.

 private:
  ProgressLine line_;
  std::size_t all_ = 0;
  std::size_t before_ = 0;  ///< Files of the inputs that are done.
};

/// Calls make(input) for every input with work to do, on as many threads as the options allow. A dry run prints the
/// files instead, unless the job has frames: then `make` prints those that the clip holds. `make` returns an exit
/// status and reports its failures. Returns kDone; without a list what `make` returned; kSomeFailed if some inputs of a
/// list failed, kBadInput if all did.
[[nodiscard]] int runBatch(const Batch& batch, const BatchOptions& options,
                           const std::function<int(const BatchInput&)>& make);

/// Prints the files of an input, for a dry run. @param wanted  moments
[[nodiscard]] int putNames(const BatchInput& input, const std::vector<std::size_t>& wanted);

/// The time of a moment. @param index  of Batch::frames
[[nodiscard]] inline double secondsAt(const Batch& batch, const BatchOptions& options, std::size_t index) {
  return batch.frames[index] / options.framesPerSecond;
}

}  // namespace sinew::app
