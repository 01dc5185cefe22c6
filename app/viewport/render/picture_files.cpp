// app/viewport/render/picture_files.cpp: .png by libspng, .webp by libwebp; .gif and .mp4 by ffmpeg through a pipe.
#include "app/viewport/render/picture_files.h"

#include <array>
#include <cassert>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include <spng.h>
#include <unistd.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include "app/document/farm_job.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {

namespace {

constexpr int kCompressionLevel = 1;  // A fifth of the time of the strongest compression; files are a fifth larger.

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
struct FreeBytes {
  void operator()(void* bytes) const { std::free(bytes); }
};

bool isOpaque(const Image& image) {
  for (std::size_t at = 3; at < image.rgba.size(); at += 4) {
    if (image.rgba[at] != 255) return false;
  }
  return true;
}

std::vector<std::uint8_t> withoutAlpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t at = 0; at < rgba.size(); at += 4) {
    rgb.insert(rgb.end(), {rgba[at], rgba[at + 1], rgba[at + 2]});
  }
  return rgb;
}

}  // namespace

Result<std::string> pngBytes(const Image& image) {
  assert(image.rgba.size() == 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  const bool opaque = isOpaque(image);
  const std::vector<std::uint8_t> rgb = opaque ? withoutAlpha(image.rgba) : std::vector<std::uint8_t>{};
  const std::vector<std::uint8_t>& pixels = opaque ? rgb : image.rgba;

  const std::unique_ptr<spng_ctx, FreeContext> context(spng_ctx_new(SPNG_CTX_ENCODER));
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 8;
  header.color_type = opaque ? SPNG_COLOR_TYPE_TRUECOLOR : SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  int error = context ? SPNG_OK : SPNG_EMEM;
  const auto then = [&error](int status) { error = error == SPNG_OK ? status : error; };
  if (context) {
    then(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
    then(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel));
    then(spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB));
    then(spng_set_ihdr(context.get(), &header));
  }
  if (error == SPNG_OK) {
    then(spng_encode_image(context.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE));
  }
  std::size_t size = 0;
  std::unique_ptr<void, FreeBytes> bytes;
  if (error == SPNG_OK) bytes.reset(spng_get_png_buffer(context.get(), &size, &error));
  if (!bytes) return Error{"", "", std::string("the picture could not be encoded as PNG: ") + spng_strerror(error)};
  return std::string(static_cast<const char*>(bytes.get()), size);
}

namespace {

bool hasFfmpeg() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/ffmpeg").c_str(), X_OK) == 0) return true;
  }
  return false;
}

constexpr float kQuality = 90.0f;  ///< Of 100: no blocks on clay and skin.
constexpr int kEffort = 4;         ///< 0..6: more effort hardly makes smaller files.

/// Loops. The same bytes for the same pictures.
class WebpFile : public Movie {
 public:
  WebpFile(std::filesystem::path file, double rate) : file_(std::move(file)), rate_(rate) {}
  ~WebpFile() override { WebPAnimEncoderDelete(encoder_); }
  WebpFile(const WebpFile&) = delete;
  WebpFile& operator=(const WebpFile&) = delete;

  Result<void> add(const Image& image) override {
    if (encoder_ == nullptr && !begin(image)) return failure("another version of libwebp is installed");
    WebPPicture picture;
    if (encoder_ == nullptr || WebPPictureInit(&picture) == 0) return failure("out of memory");
    picture.width = image.width;
    picture.height = image.height;
    picture.use_argb = 1;
    const bool read = WebPPictureImportRGBA(&picture, image.rgba.data(), 4 * image.width) != 0;
    const bool added = read && WebPAnimEncoderAdd(encoder_, &picture, millisecondsAt(count_++), &config_) != 0;
    WebPPictureFree(&picture);
    if (!added) return failure(read ? WebPAnimEncoderGetError(encoder_) : "out of memory");
    return {};
  }
  Result<void> finish() override {
    WebPData data;
    WebPDataInit(&data);
    if (encoder_ == nullptr) return failure("there are no pictures");
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
    std::signal(SIGPIPE, SIG_IGN);  // Reported as a failed write.
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

  /// 4:2:0 video needs even sides, a .gif its own palette.
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
