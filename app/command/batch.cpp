// app/command/batch.cpp: the files of a job, and those that this process makes.

#include "app/command/batch.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <set>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/command/verbs.h"
#include "app/document/folder_listing.h"
#include "core/files/disk/atomic_file.h"
#include "sinew/files/rig_json.h"
#include "sinew/geometry/threads.h"

namespace sinew::app {
namespace {

constexpr const char* kNameField = "{name}";

/// The place of a %d or %0Nd field in a file name; length 0: none.
struct FrameField {
  std::size_t at = 0, length = 0;
  int width = 0;
  bool zeros = false;
};

/// nullopt: a '%' that is not such a field, or several fields.
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

/// "{name}" replaced by the input's name without folder and ending (fox of a/fox.rig.json), and %d or %0Nd by the
/// frame. Error: a frame and no such field, several, another '%', or "{name}" missing where there is a list.
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

constexpr int kMostFrames = 100000;
constexpr std::size_t kMostItems = 10000000;
constexpr std::uintmax_t kLongestList = 1 << 26;  // Bytes.
constexpr const char* kStandardInput = "standard input";
constexpr int kMostThreads = 1024;
constexpr int kMostShards = 1000000;

std::optional<std::vector<int>> numbersIn(std::string_view text, char between) {
  std::vector<int> numbers;
  while (true) {
    const std::size_t end = std::min(text.find(between), text.size());
    int value = 0;
    const auto [stop, failed] = std::from_chars(text.data(), text.data() + end, value);
    if (failed != std::errc{} || stop != text.data() + end) return std::nullopt;
    numbers.push_back(value);
    if (end == text.size()) return numbers;
    text.remove_prefix(end + 1);
  }
}

Result<std::string> standardInput() {
  std::string text;
  std::array<char, 1 << 16> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), stdin)) {
    text.append(part.data(), size);
    if (text.size() > kLongestList) return errorAt(kStandardInput, "expected a list of at most 64 MB");
  }
  if (std::ferror(stdin) != 0) return errorAt(kStandardInput, "cannot be read");
  return text;
}

/// Lines, trimmed; empty ones and those that begin with '#' are skipped.
Result<std::vector<std::filesystem::path>> linesOf(const std::filesystem::path& file) {
  const bool isStandard = file == "-";
  const Result<std::string> text = isStandard ? standardInput() : readWholeFile(file, kLongestList);
  if (!text) return text.error();
  std::vector<std::filesystem::path> lines;
  constexpr const char* kBlank = " \t\r";
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  for (std::size_t at = text->starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0; at < text->size();) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    const std::string line = text->substr(at, end - at);
    at = end + 1;
    const std::size_t first = line.find_first_not_of(kBlank);
    if (first == std::string::npos || line[first] == '#') continue;
    lines.emplace_back(line.substr(first, line.find_last_not_of(kBlank) + 1 - first));
  }
  if (lines.empty())
    return Error{isStandard ? kStandardInput : file.string(), "", "names no input: expected a file name a line"};
  return lines;
}

Result<std::vector<std::filesystem::path>> inputsOf(const BatchOptions& options, const std::filesystem::path& input) {
  if (options.list.empty() == input.empty()) {
    return errorAt("FILE", input.empty() ? "expected a file, or --list" : "cannot be combined with --list");
  }
  if (options.list.empty()) return std::vector{input};
  return linesOf(options.list);
}

bool isThere(const std::filesystem::path& file) {
  std::error_code absent;
  return std::filesystem::is_regular_file(file, absent);
}

/// The files an input is read from: itself and, for a rig, its character.
class InputFiles {
 public:
  explicit InputFiles(const std::filesystem::path& input) : input_(input) {}

  [[nodiscard]] bool hold(const std::filesystem::path& file) {
    if (!isThere(file)) return false;
    if (!character_) {                   // Only now: most jobs write new files.
      const auto rig = loadRig(input_);  // An error for a character.
      character_ = rig ? characterPath(rig.value(), input_) : input_;
    }
    std::error_code absent;
    return std::filesystem::equivalent(file, input_, absent) || std::filesystem::equivalent(file, *character_, absent);
  }

 private:
  const std::filesystem::path& input_;
  std::optional<std::filesystem::path> character_;
};

std::optional<int> intIn(std::string_view text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Grid Engine writes "undefined" for jobs that are not arrays.
std::optional<int> variable(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::nullopt : intIn(text);
}

struct ArrayVariables {
  const char* id;
  const char* first;
  const char* last;
  const char* step;
  const char* count;  ///< Null: the system has none.
};
constexpr ArrayVariables kSlurm{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
                                "SLURM_ARRAY_TASK_STEP", "SLURM_ARRAY_TASK_COUNT"};
constexpr ArrayVariables kGridEngine{"SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE", nullptr};

std::optional<Shard> shardIn(const ArrayVariables& names) {
  const auto id = variable(names.id), first = variable(names.first), last = variable(names.last);
  const int step = variable(names.step).value_or(1);
  if (!id || !first || !last || step < 1 || *first < 0 || *id < *first || *id > *last) return std::nullopt;
  const Shard shard{(*id - *first) / step, (*last - *first) / step + 1};
  // An array with gaps, such as one of failed tasks only, would skip items.
  const int tasks = names.count == nullptr ? shard.count : variable(names.count).value_or(shard.count);
  if ((*id - *first) % step != 0 || tasks != shard.count) return std::nullopt;
  return shard;
}

}  // namespace

Result<Shard> shardOf(const std::string& text) {
  if (text.empty()) return Shard{};
  if (text == "auto") {
    if (const auto slurm = shardIn(kSlurm)) return *slurm;
    if (const auto gridEngine = shardIn(kGridEngine)) return *gridEngine;
    return errorAt("--shard", "auto: this is no task of a Slurm or Grid Engine array job without gaps");
  }
  const std::size_t slash = text.find('/');
  const auto index = intIn(std::string_view(text).substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : intIn(std::string_view(text).substr(slash + 1));
  if (!index || !count || *count < 1 || *count > kMostShards || *index < 0 || *index >= *count) {
    return errorAt("--shard", "expected auto, or I/N with 0 <= I < N, got \"" + text + '"');
  }
  return Shard{*index, *count};
}

Result<std::vector<int>> frameNumbers(const BatchOptions& options) {
  if (options.frames.empty()) return std::vector<int>{};
  const auto range = numbersIn(options.frames, ':');
  const bool formed = range && (range->size() == 2 || range->size() == 3);
  const int step = formed && range->size() == 3 ? (*range)[2] : 1;
  if (!formed || step < 1 || (*range)[0] < 0 || (*range)[1] < (*range)[0] ||
      ((*range)[1] - (*range)[0]) / step >= kMostFrames) {
    return errorAt("--frames",
                   "expected FIRST:LAST or FIRST:LAST:STEP with 0 <= FIRST <= LAST, STEP > 0 and at most 100000 "
                   "frames, got \"" +
                       options.frames + '"');
  }
  if (!(options.framesPerSecond > 0.0) || !std::isfinite(options.framesPerSecond)) {
    return errorAt("--fps", "expected a number > 0");
  }
  std::vector<int> frames;
  for (int i = 0; i <= ((*range)[1] - (*range)[0]) / step; ++i) frames.push_back((*range)[0] + i * step);
  return frames;
}

void addFrameOptions(CLI::App& verb, BatchOptions& options) {
  verb.add_option("--frames", options.frames, "One file per clip frame from A to B, both included, or every STEPth")
      ->type_name("A:B[:STEP]");
  verb.add_option("--fps", options.framesPerSecond, "Clip frames per second (30)")->type_name("N");
}

void addBatchOptions(CLI::App& verb, BatchOptions& options) {
  addPath(verb, "--list", options.list,
          "Instead of FILE: a text file, one input per line, or - for stdin; {name} in OUT is its name")
      ->type_name("FILE.txt");
  verb.add_option("--shard", options.shard, "Make part I of N, 0 to N-1; auto: from the Slurm or Grid Engine array job")
      ->type_name("I/N");
  verb.add_flag("--resume", options.resume, "Skip files that exist already: files appear whole or not at all");
  verb.add_flag("--dry-run", options.dryRun, "Print the names of the files, and make none");
  verb.add_option("--threads", options.threads, "Work on N cores at most; without it, on all; the files are the same")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
  verb.add_flag("--progress", options.progress,
                "Report progress on stderr every 5 percent; a terminal always shows it");
}

Result<Batch> planBatch(const BatchOptions& options, const std::filesystem::path& input,
                        const std::filesystem::path& output) {
  Batch batch;
  const auto frames = frameNumbers(options);
  if (!frames) return frames.error();
  const auto shard = shardOf(options.shard);
  if (!shard) return shard.error();
  const auto inputs = inputsOf(options, input);
  if (!inputs) return inputs.error();
  batch.frames = frames.value();
  batch.listed = !options.list.empty();
  if (inputs->size() * std::max<std::size_t>(batch.frames.size(), 1) > kMostItems) {
    return errorAt("--list", "expected at most 10000000 files in a job");
  }
  std::set<std::string> names;
  std::size_t item = 0;
  for (const std::filesystem::path& file : inputs.value()) {
    BatchInput of{file, {}, {}};
    const auto outputs = filesBeside(batch, of, output, "--output");
    if (!outputs) return outputs.error();
    of.outputs = outputs.value();
    for (std::size_t moment = 0; moment < of.outputs.size(); ++moment, ++item) {
      const std::filesystem::path& name = of.outputs[moment];
      if (!names.insert(name.lexically_normal().string()).second) {
        return errorAt("--output", "two items of the job write " + name.string());
      }
      if (shard->holds(item) && !(options.resume && isThere(name))) of.wanted.push_back(moment);
    }
    batch.inputs.push_back(std::move(of));
  }
  return batch;
}

Result<std::vector<std::filesystem::path>> filesBeside(const Batch& batch, const BatchInput& input,
                                                       const std::filesystem::path& pattern,
                                                       const std::string& option) {
  std::vector<std::filesystem::path> files;
  InputFiles read(input.file);
  for (std::size_t i = 0; i < std::max<std::size_t>(batch.frames.size(), 1); ++i) {
    const std::optional<int> frame = batch.frames.empty() ? std::nullopt : std::optional(batch.frames[i]);
    auto name = nameOfItem(pattern, option, input.file, batch.listed, frame);
    if (!name) return name.error();
    if (read.hold(name.value())) return errorAt(option, name->string() + ": is the input; it is not overwritten");
    files.push_back(std::move(name.value()));
  }
  return files;
}

BatchProgress::BatchProgress(const std::string& what, const Batch& batch, const BatchOptions& options)
    : line_(what, options.progress) {
  for (const BatchInput& input : batch.inputs) all_ += input.wanted.size();
  if (!options.dryRun) show(0);
}

void BatchProgress::showPart(double part) {
  if (all_ > 0) line_.show((static_cast<double>(before_) + part) / static_cast<double>(all_));
}

void BatchProgress::leave(const BatchInput& input) {
  before_ += input.wanted.size();
  show(0);
}

int putNames(const BatchInput& input, const std::vector<std::size_t>& wanted) {
  std::string names;
  for (const std::size_t moment : wanted) names += input.outputs[moment].string() + '\n';
  return putResult(names);
}

int runBatch(const Batch& batch, const BatchOptions& options, const std::function<int(const BatchInput&)>& make) {
  const ThreadLimit limit(options.threads);
  const bool namesAlone = options.dryRun && batch.frames.empty();
  std::size_t begun = 0;
  std::size_t failed = 0;
  for (const BatchInput& input : batch.inputs) {
    if (input.wanted.empty()) continue;
    ++begun;
    const int status = namesAlone ? putNames(input, input.wanted) : make(input);
    if (!batch.listed || status == kBadCommandLine) {
      if (status != kDone) return status;
    } else if (status != kDone) {
      ++failed;
    }
  }
  if (failed == 0) return kDone;
  return failed == begun ? kBadInput : kSomeFailed;
}

}  // namespace sinew::app
