// app/viewport/render/movie.cpp: .webp through its library; .gif and .mp4 through ffmpeg, which reads the pictures from
// a pipe.
#include "app/viewport/render/movie.h"

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include <unistd.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include "app/document/farm_job.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

bool hasFfmpeg() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  }
  return false;
}

constexpr float kQuality = 90.0f;  ///< Of 100: clay and skin show no blocks.
constexpr int kEffort = 4;         ///< 0..6: slower files are hardly smaller.

/// Plays for ever. Same pictures, same bytes.
class WebpFile : public Movie {
 public:
  WebpFile(std::filesystem::path file, double rate) : file_(std::move(file)), rate_(rate) {}
  ~WebpFile() override { WebPAnimEncoderDelete(encoder_); }
  WebpFile(const WebpFile&) = delete;
  WebpFile& operator=(const WebpFile&) = delete;

  Result<void> add(const Image& image) override {
    if (encoder_ == nullptr && !begin(image)) return failure("another version of libwebp is installed");
    WebPPicture picture;
    if (encoder_ == nullptr || WebPPictureInit(&picture) == 0) return failure("there is no memory for it");
    picture.width = image.width;
    picture.height = image.height;
    picture.use_argb = 1;
    const bool read = WebPPictureImportRGBA(&picture, image.rgba.data(), 4 * image.width) != 0;
    const bool added = read && WebPAnimEncoderAdd(encoder_, &picture, millisecondsAt(count_++), &config_) != 0;
    WebPPictureFree(&picture);
    if (!added) return failure(read ? WebPAnimEncoderGetError(encoder_) : "there is no memory for it");
    return {};
  }
  Result<void> finish() override {
    WebPData data;
    WebPDataInit(&data);
    if (encoder_ == nullptr) return failure("there are none");
    if (WebPAnimEncoderAdd(encoder_, nullptr, millisecondsAt(count_), nullptr) == 0 ||
        WebPAnimEncoderAssemble(encoder_, &data) == 0) {
      return failure(WebPAnimEncoderGetError(encoder_));
    }
    const std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
    WebPDataClear(&data);
    return writeFileAtomically(file_, bytes);
  }

 private:
  bool begin(const Image& image) {
    WebPAnimEncoderOptions options;
    if (WebPAnimEncoderOptionsInit(&options) == 0 || WebPConfigInit(&config_) == 0) return false;
    config_.quality = kQuality;
    config_.method = kEffort;
    encoder_ = WebPAnimEncoderNew(image.width, image.height, &options);
    return true;
  }
  [[nodiscard]] int millisecondsAt(int picture) const {
    return static_cast<int>(std::lround(1000.0 * picture / rate_));
  }
  [[nodiscard]] Error failure(const char* reason) const {
    return {file_.string(), "", std::string("the pictures could not be encoded as WebP: ") + reason};
  }

  std::filesystem::path file_;
  double rate_;
  int count_ = 0;
  WebPAnimEncoder* encoder_ = nullptr;
  WebPConfig config_{};
};

class FfmpegFile : public Movie {
 public:
  FfmpegFile(std::filesystem::path file, double rate) : file_(std::move(file)), rate_(rate) {
    part_ = file_.parent_path() / ("." + file_.stem().string() + ".part" + lowerEnding(file_));
    std::signal(SIGPIPE, SIG_IGN);  // Its end is an error of the write.
  }
  ~FfmpegFile() override {
    if (pipe_ != nullptr) ::pclose(pipe_);
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }
  FfmpegFile(const FfmpegFile&) = delete;
  FfmpegFile& operator=(const FfmpegFile&) = delete;

  Result<void> add(const Image& image) override {
    if (pipe_ == nullptr) pipe_ = ::popen(commandFor(image).c_str(), "w");
    if (pipe_ == nullptr) return failure();
    return std::fwrite(image.rgba.data(), 1, image.rgba.size(), pipe_) == image.rgba.size() ? Result<void>()
                                                                                            : failure();
  }
  Result<void> finish() override {
    std::FILE* const pipe = std::exchange(pipe_, nullptr);
    if (pipe == nullptr || ::pclose(pipe) != 0) return failure();
    return putFileAtomically(part_, file_);
  }

 private:
  [[nodiscard]] Error failure() const { return {file_.string(), "", "ffmpeg could not write it"}; }

  /// Both are shown everywhere: 4:2:0 wants even sides, a .gif a palette of its own.
  [[nodiscard]] std::string commandFor(const Image& image) const {
    std::array<char, 32> rate{};
    std::snprintf(rate.data(), rate.size(), "%.6f", rate_);
    const bool isGif = lowerEnding(file_) == ".gif";
    const std::string form = isGif ? "-vf 'split[a][b];[a]palettegen[p];[b][p]paletteuse' -loop 0"
                                   : "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -c:v libx264 -crf 18 -pix_fmt yuv420p "
                                     "-movflags +faststart";
    return "ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgba -s " + std::to_string(image.width) + 'x' +
           std::to_string(image.height) + " -r " + rate.data() + " -i - " + form + ' ' +
           shellWord(std::filesystem::absolute(part_).string());
  }

  std::filesystem::path file_;
  std::filesystem::path part_;
  double rate_;
  std::FILE* pipe_ = nullptr;
};

}  // namespace

bool isMovieName(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".webp" || ending == ".gif" || ending == ".mp4";
}

Result<void> checkMovieName(const std::filesystem::path& file) {
  if (lowerEnding(file) == ".webp" || hasFfmpeg()) return {};
  return Error{file.string(), "",
               lowerEnding(file) + " needs the program ffmpeg, which is not installed; .webp does not"};
}

std::unique_ptr<Movie> makeMovie(const std::filesystem::path& file, double picturesPerSecond) {
  if (lowerEnding(file) == ".webp") return std::make_unique<WebpFile>(file, picturesPerSecond);
  return std::make_unique<FfmpegFile>(file, picturesPerSecond);
}

}  // namespace sinew::app
