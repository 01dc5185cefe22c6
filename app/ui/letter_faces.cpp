// app/ui/letter_faces.cpp: FreeType, as ImGui's own font builder uses it.

#include "app/ui/letter_faces.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <filesystem>
#include <span>
#include <system_error>
#include <utility>

#include "app/ui/code_points.h"

namespace sinew::app {
namespace {

constexpr int kMostPixels = 256;  ///< Of a letter's side: what is larger comes from a broken font.

/// One byte a pixel, whatever FreeType made of it.
std::vector<std::uint8_t> coverageOf(const FT_Bitmap& bitmap) {
  std::vector<std::uint8_t> out;
  out.reserve(static_cast<std::size_t>(bitmap.rows) * bitmap.width);
  for (unsigned y = 0; y < bitmap.rows; ++y) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(y) * bitmap.pitch;
    const std::span<const std::uint8_t> row(bitmap.buffer + from, bitmap.width);
    out.insert(out.end(), row.begin(), row.end());
  }
  return out;
}

constexpr float kFromRight = 1.1f;  ///< Hebrew and Arabic have small letters, and no large ones among them.

/// Latin and its like as tall as ImGui makes them; wide letters by their em square.
void setPixelSize(FT_Face face, char32_t c, float height) {
  const bool wide = isWide(c) || isKana(c);
  const float tall = isRightToLeft(c) ? kFromRight * height : height;
  FT_Size_RequestRec request{};
  request.type = wide ? FT_SIZE_REQUEST_TYPE_NOMINAL : FT_SIZE_REQUEST_TYPE_REAL_DIM;
  request.height = wide ? wideEm(height) * 64 : static_cast<FT_Long>(tall * 64.0f);
  FT_Request_Size(face, &request);
}

}  // namespace

struct LetterFaces::Found {
  FT_Face face;
  FT_UInt glyph;
};

struct LetterFaces::Library {
  Library() {
    if (FT_Init_FreeType(&library) != 0) library = nullptr;
  }
  ~Library() {
    if (library != nullptr) FT_Done_FreeType(library);  // And all its faces.
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Null: there is no such file, or it is no font.
  FT_Face open(const FontFile& font) {
    const auto [at, isNew] = faces.try_emplace({std::string(font.file), font.face}, nullptr);
    if (!isNew || library == nullptr) return at->second;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(font.file, ignored)) return nullptr;
    if (FT_New_Face(library, at->first.first.c_str(), font.face, &at->second) != 0) at->second = nullptr;
    return at->second;
  }

  FT_Library library = nullptr;
  std::map<std::pair<std::string, int>, FT_Face> faces;
};

LetterFaces::LetterFaces() : library_(std::make_unique<Library>()) {}
LetterFaces::~LetterFaces() = default;

std::optional<LetterFaces::Found> LetterFaces::find(char32_t c, bool strong) {
  for (const FontFile& file : fontFilesFor(c, strong, region_)) {
    const FT_Face face = library_->open(file);
    const FT_UInt glyph = face == nullptr ? 0 : FT_Get_Char_Index(face, c);
    if (glyph != 0) return Found{face, glyph};
  }
  return std::nullopt;
}

bool LetterFaces::has(char32_t c) {
  const auto [at, isNew] = known_.try_emplace(c, false);
  if (isNew) at->second = isInvisible(c) || find(c, false).has_value();
  return at->second;
}

std::optional<LetterImage> LetterFaces::draw(char32_t c, bool strong, float height) {
  const std::optional<Found> found = find(c, strong);
  if (!found) return std::nullopt;
  setPixelSize(found->face, c, height);
  if (FT_Load_Glyph(found->face, found->glyph, FT_LOAD_TARGET_LIGHT) != 0) return std::nullopt;
  const FT_GlyphSlot slot = found->face->glyph;
  if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) return std::nullopt;
  const FT_Bitmap& bitmap = slot->bitmap;
  if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY && bitmap.rows > 0) return std::nullopt;
  LetterImage image;
  image.size = {static_cast<int>(bitmap.width), static_cast<int>(bitmap.rows)};
  if (image.size.x > kMostPixels || image.size.y > kMostPixels) return std::nullopt;
  image.offset = {slot->bitmap_left, -slot->bitmap_top};
  // Whole pixels, as ImGui's; rounded down where letters touch, or there would be a gap.
  image.advance = static_cast<float>((slot->advance.x + (isJoinedForm(c) ? 0 : 32)) / 64);
  image.coverage = coverageOf(bitmap);
  return image;
}

}  // namespace sinew::app
