// app/ui/letters.cpp: font files by script, letters drawn by FreeType, and their place in ImGui's atlas.
#include "app/ui/letters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include <imgui.h>

#include "app/ui/code_points.h"

namespace sinew::app {

namespace {

constexpr float kWideEm = 0.87f;  ///< Fraction of the line's height.

/// Face in the files of fonts-noto-cjk.
int faceOfRegion(HanRegion region) { return static_cast<int>(region); }

void addWideFonts(std::vector<FontFile>& files, bool strong, HanRegion region) {
  if (strong) files.push_back({"/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc", faceOfRegion(region)});
  files.push_back({"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", faceOfRegion(region)});
  // Alternatives from smaller packages.
  for (const char* other :
       {"/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",
        "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc", "/usr/share/fonts/opentype/ipafont-gothic/ipag.ttf",
        "/usr/share/fonts/truetype/nanum/NanumGothic.ttf"}) {
    files.push_back({other, 0});
  }
}

void addOtherFonts(std::vector<FontFile>& files, bool strong) {
  if (strong) files.push_back({"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", 0});
  files.push_back({"/usr/share/fonts/opentype/inter/Inter-Regular.otf", 0});
  if (strong) files.push_back({"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", 0});
  files.push_back({"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0});
  // fonts-noto-core, by script.
  for (const char* other : {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansThai-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansDevanagari-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansSymbols-Regular.ttf",
                            "/usr/share/fonts/truetype/noto/NotoSansSymbols2-Regular.ttf"}) {
    files.push_back({other, 0});
  }
}

}  // namespace

HanRegion hanRegion(std::u32string_view letters, std::string_view locale) {
  if (std::ranges::any_of(letters, isKana)) return HanRegion::kJapan;
  if (std::ranges::any_of(letters, isHangul)) return HanRegion::kKorea;
  if (locale.starts_with("ja")) return HanRegion::kJapan;
  if (locale.starts_with("ko")) return HanRegion::kKorea;
  if (locale.starts_with("zh_TW")) return HanRegion::kTaiwan;
  if (locale.starts_with("zh_HK") || locale.starts_with("zh_MO")) return HanRegion::kHongKong;
  return HanRegion::kMainland;
}

std::string_view localeOfEnvironment() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') return value;
  }
  return "";
}

std::vector<FontFile> fontFilesFor(char32_t c, bool strong, HanRegion region) {
  std::vector<FontFile> files;
  const bool wide = isWide(c) || isKana(c);
  if (wide) addWideFonts(files, strong, region);
  addOtherFonts(files, strong);
  if (!wide) addWideFonts(files, strong, region);
  return files;
}

int wideEm(float fontSize) { return static_cast<int>(std::lround(kWideEm * fontSize)); }

namespace {

constexpr int kMostPixels = 256;  ///< Of a letter's side; larger ones come from broken fonts.

/// One byte per pixel.
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

constexpr float kFromRight = 1.1f;  ///< Enlarges Hebrew and Arabic, which have no capitals.

/// As tall as ImGui draws Latin; wide letters by their em square.
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

  /// Null: the file is missing or no font.
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

// Glyphs in rectangles of their own in ImGui's atlas.

namespace {

constexpr std::size_t kMostWanted = 9000;  ///< Beyond it, letters that are not on the screen are dropped.
constexpr int kAround = 1;                 ///< Free pixels around a letter, for blending at its edges.
constexpr char32_t kFirstLetter = 0xA0;
constexpr char32_t kLastLetter = 0xFFFD;

/// ImGui has 16 bits. Without surrogates and private letters.
bool mayBeDrawn(char32_t c) { return c >= kFirstLetter && c <= kLastLetter && !(c >= 0xD800 && c <= 0xF8FF); }

struct NameLetter {
  ImFont* font;
  char32_t letter;
  LetterImage image;
  int rectangle;  ///< ImGui's number.
};

void addLetter(const NameLetter& letter) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const ImFontAtlasCustomRect& place = *atlas.GetCustomRectByIndex(letter.rectangle);
  const glm::ivec2 size = letter.image.size;
  const glm::ivec2 corner(place.X + kAround, place.Y + kAround);
  for (int y = 0; y < size.y; ++y) {
    std::copy_n(letter.image.coverage.begin() + static_cast<std::ptrdiff_t>(y) * size.x, size.x,
                atlas.TexPixelsAlpha8 + static_cast<std::ptrdiff_t>(corner.y + y) * atlas.TexWidth + corner.x);
  }
  const glm::vec2 low = letter.image.offset + glm::ivec2(0, static_cast<int>(letter.font->Ascent + 0.5f));
  const glm::vec2 high = low + glm::vec2(size);
  const glm::vec2 pixel(atlas.TexUvScale.x, atlas.TexUvScale.y);
  const glm::vec2 from = glm::vec2(corner) * pixel;
  const glm::vec2 to = glm::vec2(corner + size) * pixel;
  letter.font->AddGlyph(nullptr, static_cast<ImWchar>(letter.letter), low.x, low.y, high.x, high.y, from.x, from.y,
                        to.x, to.y, letter.image.advance);
}

/// Marks of direction and the like show nothing.
void addInvisible(ImFont& font) {
  for (char32_t c = kFirstLetter; c <= kLastLetter; ++c) {
    if (mayBeDrawn(c) && isInvisible(c)) font.AddGlyph(nullptr, static_cast<ImWchar>(c), 0, 0, 0, 0, 0, 0, 0, 0, 0);
  }
}

}  // namespace

void NameTexture::want(std::u32string_view letters) {
  const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
  std::set<std::pair<int, char32_t>> fresh;
  for (const char32_t c : letters) {
    if (!mayBeDrawn(c) || isInvisible(c)) continue;
    for (int font = 0; font < fonts.Size; ++font) {
      if (fonts[font]->FindGlyphNoFallback(static_cast<ImWchar>(c)) == nullptr) fresh.emplace(font, c);
    }
  }
  std::erase_if(fresh, [&](const auto& each) { return wanted_.contains(each); });
  if (fresh.empty()) return;
  outdated_ = true;
  if (wanted_.size() + fresh.size() > kMostWanted) wanted_.clear();
  wanted_.merge(fresh);
}

bool NameTexture::has(char32_t c) { return (c < kFirstLetter || mayBeDrawn(c)) && faces_.has(c); }

void NameTexture::setRegion(HanRegion region) {
  if (region == faces_.region()) return;
  faces_.setRegion(region);
  outdated_ = outdated_ || !wanted_.empty();
}

void NameTexture::build(const Fonts& fonts) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  std::vector<NameLetter> all;
  for (const auto& [number, c] : wanted_) {
    ImFont* const font = atlas.Fonts[number];
    const bool strong = font == fonts.strong && font != fonts.body;
    std::optional<LetterImage> image = faces_.draw(c, strong, atlas.ConfigData[number].SizePixels);
    if (!image) continue;
    const glm::ivec2 size = image->size + 2 * kAround;
    all.push_back({font, c, std::move(*image), atlas.AddCustomRectRegular(size.x, size.y)});
  }
  atlas.Build();
  for (ImFont* font : atlas.Fonts) addInvisible(*font);
  for (const NameLetter& letter : all) addLetter(letter);
  for (ImFont* font : atlas.Fonts) font->BuildLookupTable();
  outdated_ = false;
}

}  // namespace sinew::app
