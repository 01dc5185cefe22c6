// app/document/export_queue.cpp: the running export on its own thread; pictures in a process of their own.
#include "app/document/export_queue.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/files/disk/atomic_file.h"
#include "sinew/geometry/threads.h"

namespace sinew::app {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestPicture = std::uintmax_t{4} << 30;
constexpr int kLookMilliseconds = 100;  ///< Between checks for cancellation.
constexpr std::string_view kProgram = "sinew: ";

/// "sinew: rendering fox.webp: 45 %" -> 0.45
std::optional<double> fractionIn(std::string_view line) {
  if (!line.ends_with(" %")) return std::nullopt;
  line.remove_suffix(2);
  line.remove_prefix(line.rfind(' ') + 1);
  int percent = 0;
  const auto [end, failed] = std::from_chars(line.data(), line.data() + line.size(), percent);
  if (failed != std::errc{} || end != line.data() + line.size()) return std::nullopt;
  return percent / 100.0;
}

/// Output of the process, line by line: progress and the last other line.
class Talk {
 public:
  explicit Talk(const ExportProgress& progress) : progress_(progress) {}

  void add(std::string_view text) {
    rest_ += text;
    for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
      const std::string line = rest_.substr(0, end);
      rest_.erase(0, end + 1);
      if (const std::optional<double> done = fractionIn(line)) done_ = *done;
      else if (!line.empty()) last_ = line;
    }
  }
  [[nodiscard]] bool goesOn() const { return progress_(done_); }
  [[nodiscard]] const std::string& last() const { return last_; }

 private:
  const ExportProgress& progress_;
  std::string rest_, last_;
  double done_ = 0.0;
};

/// A running program in its own process group. The destructor kills it and waits for its end.
class Child {
 public:
  [[nodiscard]] static Result<Child> start(std::vector<std::string> words) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return failure(errno, words.front());
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, pipe[1], STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    Child child;
    const int failed =
        ::posix_spawnp(&child.process_, arguments.front(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    ::close(pipe[1]);
    child.errors_ = pipe[0];
    if (failed == 0) return child;
    child.process_ = 0;
    return failure(failed, words.front());
  }
  Child(Child&& other) noexcept
      : process_(std::exchange(other.process_, 0)), errors_(std::exchange(other.errors_, -1)) {}
  Child& operator=(Child&&) = delete;
  ~Child() {
    if (errors_ >= 0) ::close(errors_);
    if (process_ == 0) return;
    ::kill(-process_, SIGKILL);
    static_cast<void>(end());
  }

  /// Passes its output to `talk` until it ends. @return false: it was canceled and killed
  bool listen(Talk& talk) {
    std::array<char, 4096> text{};
    while (talk.goesOn()) {
      pollfd wanted{errors_, POLLIN, 0};
      if (::poll(&wanted, 1, kLookMilliseconds) <= 0) continue;
      const ssize_t size = ::read(errors_, text.data(), text.size());
      if (size == 0 || (size < 0 && errno != EINTR)) return true;
      if (size > 0) talk.add({text.data(), static_cast<std::size_t>(size)});
    }
    ::kill(-process_, SIGKILL);
    static_cast<void>(end());
    return false;
  }
  /// Waits for its end. @return whether it succeeded
  bool end() {
    int status = 0;
    pid_t ended = 0;
    do ended = ::waitpid(process_, &status, 0);
    while (ended < 0 && errno == EINTR);
    process_ = 0;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  Child() = default;
  static Error failure(int number, const std::string& program) {
    return {program, "", "cannot be started: " + std::generic_category().message(number)};
  }

  pid_t process_ = 0;
  int errors_ = -1;
};

/// Without the paths of the job's folder, which is gone when the reason is read.
std::string reasonIn(std::string line, const fs::path& folder) {
  if (line.starts_with(kProgram)) line.erase(0, kProgram.size());
  const std::string prefix = folder.string() + '/';
  for (std::size_t at = line.find(prefix); at != std::string::npos; at = line.find(prefix))
    line.erase(at, prefix.size());
  return line.empty() ? "it could not be made" : line;
}

}  // namespace

Result<std::shared_ptr<const JobFolder>> JobFolder::make() {
  std::error_code failed;
  std::string name = (fs::temp_directory_path(failed) / "sinew-XXXXXX").string();
  if (failed || ::mkdtemp(name.data()) == nullptr) {
    return Error{name, "", "cannot be made: " + std::generic_category().message(failed ? failed.value() : errno)};
  }
  return std::shared_ptr<const JobFolder>(new JobFolder(name));
}

JobFolder::~JobFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Result<void> runPictureJob(const PictureJob& job, const fs::path& file, const ExportProgress& progress) {
  const fs::path made = job.folder->path() / file.filename();
  std::vector<std::string> words{job.program, "render", (job.folder->path() / job.input).string()};
  words.insert(words.end(), job.arguments.begin(), job.arguments.end());
  words.insert(words.end(), {"--progress", "-o", made.string()});
  Result<Child> child = Child::start(std::move(words));
  if (!child) return child.error();
  Talk talk(progress);
  if (!child.value().listen(talk)) return Error{file.string(), "", std::string(kCanceled)};
  if (!child.value().end()) return Error{file.string(), "", reasonIn(talk.last(), job.folder->path())};
  const auto bytes = readWholeFile(made, kLargestPicture);
  if (!bytes) return Error{file.string(), "", bytes.error().reason};
  return writeFileAtomically(file, bytes.value());
}

/// `result` belongs to the thread until `done` is set, then to the owner.
struct ExportQueue::Run {
  explicit Run(ExportOrder what) : order(std::move(what)) {}
  ~Run() { canceled = true; }

  void work() {
    const ExportProgress progress = [this](double part) {
      share = part;
      return !canceled;
    };
    if (order.pictures) result = pictures(progress);
    else result = runExport(*order.kind, order.source, order.settings, order.file, progress);
    done = true;
  }

  Result<ExportReport> pictures(const ExportProgress& progress) const {
    const Result<void> made = runPictureJob(*order.pictures, order.file, progress);
    if (!made) return made.error();
    return ExportReport{};
  }

  const ExportOrder order;
  std::atomic<double> share = 0.0;
  std::atomic<bool> canceled = false;
  std::atomic<bool> done = false;
  std::optional<Result<ExportReport>> result;
  std::jthread thread;  ///< Last, so that it ends first.
};

ExportQueue::ExportQueue() = default;
ExportQueue::~ExportQueue() = default;
ExportQueue::ExportQueue(ExportQueue&&) noexcept = default;
ExportQueue& ExportQueue::operator=(ExportQueue&&) noexcept = default;

void ExportQueue::add(ExportOrder order) {
  waiting_.push_back(std::move(order));
  if (!run_) startNext();
}

void ExportQueue::startNext() {
  run_.reset();
  while (!waiting_.empty() && !run_) {
    run_ = std::make_unique<Run>(std::move(waiting_.front()));
    waiting_.erase(waiting_.begin());
    try {
      run_->thread = std::jthread([run = run_.get()] {
        const ThreadLimit limit(std::max(1, threadCount() - 1));  // The editor stays live.
        run->work();
      });
    } catch (const std::system_error& error) {
      done_.push_back(
          {run_->order.file, Error{run_->order.file.string(), {}, std::string("no thread for it: ") + error.what()}});
      run_.reset();
    }
  }
}

void ExportQueue::cancel() {
  if (run_) run_->canceled = true;
}

std::vector<ExportStand> ExportQueue::stands() const {
  std::vector<ExportStand> stands;
  if (run_) stands.push_back({run_->order.file, run_->share, true, run_->canceled});
  for (const ExportOrder& order : waiting_) stands.push_back({order.file});
  return stands;
}

bool ExportQueue::empty() const { return !run_ && done_.empty(); }

std::vector<ExportOutcome> ExportQueue::takeDone() {
  if (run_ && run_->done) {
    run_->thread.join();
    const bool canceled = !run_->result->ok() && run_->result->error().reason == kCanceled;
    done_.push_back({run_->order.file, std::move(*run_->result), canceled, run_->order});
    startNext();
  }
  return std::exchange(done_, {});
}

}  // namespace sinew::app
