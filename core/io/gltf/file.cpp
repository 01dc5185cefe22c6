// core/io/gltf/file.cpp: container, buffers and sibling files of a glTF file.

#include "core/io/gltf/file.h"

#include <algorithm>
#include <cstring>

#include "core/io/files/atomic_file.h"
#include "core/io/gltf/uri.h"

namespace sinew::gltf {
namespace {

namespace fs = std::filesystem;

/// No character comes near it; it keeps a slip of the hand from filling the memory.
constexpr std::uintmax_t kLargestFile = 1ULL << 30;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

Bytes bytesOf(std::string_view text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

std::uint32_t littleEndian(std::string_view text, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[offset + i])) << (8 * i);
  }
  return value;
}

struct Container {
  std::string_view json;
  std::optional<std::string_view> binary;
};

/// GLB container: header of 12 bytes, then chunks of length, type, data (glTF 2.0, section 4.4).
Container splitGlb(std::string_view file) {
  if (file.size() < 12) refuse("byte " + std::to_string(file.size()), "the file ends within the GLB header");
  if (littleEndian(file, 4) != 2)
    refuse("byte 4", "GLB version " + std::to_string(littleEndian(file, 4)) + "; 2 expected");
  const std::size_t length = littleEndian(file, 8);
  if (length > file.size()) {
    refuse("byte " + std::to_string(file.size()),
           "the file is cut off: its header promises " + std::to_string(length) + " bytes");
  }
  Container result;
  for (std::size_t at = 12; at + 8 <= length;) {
    const std::size_t size = littleEndian(file, at);
    const std::uint32_t type = littleEndian(file, at + 4);
    if (size > length - at - 8) refuse("byte " + std::to_string(at), "a GLB chunk reaches beyond the end of the file");
    const std::string_view chunk = file.substr(at + 8, size);
    if (at == 12 && type != kJsonChunk) refuse("byte 16", "the first GLB chunk must be JSON");
    if (type == kJsonChunk && at == 12) result.json = chunk;
    if (type == kBinaryChunk && !result.binary) result.binary = chunk;
    at += 8 + size;
  }
  // Some exporters fill the last four bytes with zeros instead of spaces.
  while (!result.json.empty() && result.json.back() == '\0') result.json.remove_suffix(1);
  if (result.json.empty()) refuse("byte 12", "a GLB without a JSON chunk");
  return result;
}

}  // namespace

File::File(const fs::path& path) : folder_(path.has_parent_path() ? path.parent_path() : fs::path(".")) {
  Result<std::string> contents = readWholeFile(path, kLargestFile);
  if (!contents) throw Refusal{contents.error()};
  contents_ = std::make_shared<const std::string>(std::move(contents).value());
  json_ = parseJson(openContainer());
  const std::string_view version = root().member("asset").member("version").text("");
  if (!version.starts_with("2.")) {
    refuse("asset.version", version.empty() ? "missing; this is no glTF 2.0 file"
                                            : "glTF version " + std::string(version) + "; 2.0 expected");
  }
  checkUris();
  openBuffers();
  openViews();
}

std::string_view File::openContainer() {
  if (contents_->empty()) refuse("", "the file is empty");
  if (!contents_->starts_with("glTF")) return *contents_;
  const Container container = splitGlb(*contents_);
  if (container.binary) binaryChunk_ = bytesOf(*container.binary);
  hasBinaryChunk_ = container.binary.has_value();
  return container.json;
}

/// Also those nothing uses: a file that names something outside its folder is not to be trusted.
void File::checkUris() const {
  for (const char* list : {"buffers", "images"}) {
    const Field things = root().member(list);
    for (std::size_t i = 0; i < things.size(); ++i) {
      const Field uri = things.item(i).member("uri");
      if (!uri.exists() || isDataUri(uri.text(""))) continue;
      const Result<fs::path> path = relativePathOf(uri.text(""));
      if (!path) refuse(uri.place(), path.error().reason);
    }
  }
}

void File::openBuffers() {
  const Field buffers = root().member("buffers");
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    const Field buffer = buffers.item(i);
    const std::uint64_t length = buffer.member("byteLength").requiredCount();
    const Field uri = buffer.member("uri");
    SharedBytes bytes;
    if (uri.exists()) {
      std::string why;
      std::optional<SharedBytes> found = read(uri, why);
      if (!found) refuse(uri.place(), why);
      bytes = std::move(*found);
    } else if (i == 0 && hasBinaryChunk_) {
      bytes = {contents_, binaryChunk_};
    } else {
      // Allowed (extensions fill such buffers); an error once something reads from it.
      buffers_.push_back({});
      continue;
    }
    if (bytes.bytes.size() < length) {
      refuse(buffer.place(),
             "promises " + std::to_string(length) + " bytes but has " + std::to_string(bytes.bytes.size()));
    }
    bytes.bytes = bytes.bytes.first(static_cast<std::size_t>(length));
    buffers_.push_back(std::move(bytes));
  }
}

void File::openViews() {
  const Field views = root().member("bufferViews");
  views_.reserve(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Field view = views.item(i);
    View result;
    result.buffer = view.member("buffer").requiredIndex(buffers_.size(), "buffer");
    result.offset = view.member("byteOffset").count(0);
    result.length = view.member("byteLength").requiredCount();
    const std::uint64_t stride = view.member("byteStride").count(0);
    if (stride > 65536) refuse(view.place() + ".byteStride", "larger than 65536");
    result.stride = static_cast<std::size_t>(stride);
    const SharedBytes& buffer = buffers_[static_cast<std::size_t>(result.buffer)];
    const std::uint64_t available = buffer.bytes.size();
    if (buffer.owner && (result.offset > available || result.length > available - result.offset)) {
      refuse(view.place(), "bytes " + std::to_string(result.offset) + " to " +
                               std::to_string(result.offset + result.length) + " reach beyond the buffer's " +
                               std::to_string(available));
    }
    views_.push_back(result);
  }
}

Bytes File::bufferView(std::size_t index) const {
  const View& view = views_[index];
  const SharedBytes& buffer = buffers_[static_cast<std::size_t>(view.buffer)];
  if (!buffer.owner)
    refuse("buffers[" + std::to_string(view.buffer) + "]", "has no uri and the file holds no bytes for it");
  return buffer.bytes.subspan(static_cast<std::size_t>(view.offset), static_cast<std::size_t>(view.length));
}

std::optional<SharedBytes> File::read(const Field& uri, std::string& why) {
  const std::string_view text = uri.text("");
  if (!isDataUri(text)) return readSibling(uri, why);
  Result<std::string> decoded = decodeDataUri(text);
  if (!decoded) {
    why = decoded.error().reason;
    return std::nullopt;
  }
  auto owner = std::make_shared<const std::string>(std::move(decoded).value());
  const Bytes bytes = bytesOf(*owner);
  return SharedBytes{std::move(owner), bytes};
}

std::optional<SharedBytes> File::readSibling(const Field& uri, std::string& why) {
  const Result<fs::path> relative = relativePathOf(uri.text(""));
  if (!relative) refuse(uri.place(), relative.error().reason);
  std::error_code error;
  const fs::path asked = folder_ / relative.value();
  const std::optional<fs::path> place = placeInside(folder_, relative.value());
  if (!place && fs::exists(asked, error)) refuse(uri.place(), "leads out of this file's own folder");
  if (!place || !fs::is_regular_file(*place, error)) {
    why = "there is no file " + asked.string();
    return std::nullopt;
  }
  const auto known = std::ranges::find(siblings_, *place, &std::pair<fs::path, SharedBytes>::first);
  if (known != siblings_.end()) return known->second;
  Result<std::string> contents = readWholeFile(*place, kLargestFile - siblingBytes_);
  if (!contents) {
    why = contents.error().reason + " (" + asked.string() + ")";
    return std::nullopt;
  }
  siblingBytes_ += contents->size();
  auto owner = std::make_shared<const std::string>(std::move(contents).value());
  const Bytes bytes = bytesOf(*owner);
  siblings_.emplace_back(*place, SharedBytes{std::move(owner), bytes});
  return siblings_.back().second;
}

}  // namespace sinew::gltf
