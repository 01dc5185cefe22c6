// app/ui/letters.h: letters of any script from installed fonts, drawn by FreeType into ImGui's atlas.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "app/ui/style.h"

namespace sinew::app {

struct FontFile {
  std::string_view file;
  int face = 0;  ///< Index in the file.
  bool operator==(const FontFile&) const = default;
};

/// Regional forms of Chinese letters, in the order of the faces of fonts-noto-cjk.
enum class HanRegion { kJapan, kKorea, kMainland, kTaiwan, kHongKong };

/// Japan for letters with kana, Korea for hangul; else by the user's language ("ja_JP.UTF-8"), else mainland China.
[[nodiscard]] HanRegion hanRegion(std::u32string_view letters, std::string_view locale);
[[nodiscard]] std::string_view localeOfEnvironment();  ///< The first of LC_ALL, LC_CTYPE, LANG that is set, or "".

/// Font files of Debian's packages for a letter, best first; any may be missing. @param strong  for headings
[[nodiscard]] std::vector<FontFile> fontFilesFor(char32_t c, bool strong, HanRegion region);

/// Em square of Chinese letters beside an interface font of that height, pixels: they fill it and must fit the line.
[[nodiscard]] int wideEm(float fontSize);

/// Pixels from the top, one byte of coverage each.
struct LetterImage {
  glm::ivec2 size{0};
  glm::ivec2 offset{0};  ///< From the pen on the baseline to the upper left corner; y down.
  float advance = 0.0f;
  std::vector<std::uint8_t> coverage;
};

/// Opens font files on demand and keeps them open.
class LetterFaces {
 public:
  LetterFaces();
  ~LetterFaces();
  LetterFaces(const LetterFaces&) = delete;
  LetterFaces& operator=(const LetterFaces&) = delete;

  void setRegion(HanRegion region) { region_ = region; }
  [[nodiscard]] HanRegion region() const { return region_; }

  [[nodiscard]] bool has(char32_t c);
  /// @param height  of the interface font, pixels. nullopt: no font can draw it.
  [[nodiscard]] std::optional<LetterImage> draw(char32_t c, bool strong, float height);

 private:
  struct Library;
  struct Found;

  [[nodiscard]] std::optional<Found> find(char32_t c, bool strong);

  std::unique_ptr<Library> library_;
  HanRegion region_ = HanRegion::kMainland;
  std::map<char32_t, bool> known_;  ///< Results of has(), the same for all regions.
};

/// Letters beyond the fonts' own scripts, from an opened document's names and all text typed or shown: for new ones the
/// font texture is rebuilt.
class NameTexture {
 public:
  void want(std::u32string_view letters);  ///< Adds letters that the texture lacks.
  void setRegion(HanRegion region);
  /// Whether build() would add or change a letter.
  [[nodiscard]] bool outdated() const { return outdated_; }
  void build(const Fonts& fonts);  ///< Builds the current ImGui context's atlas with fonts and all wanted letters.

  [[nodiscard]] bool has(char32_t c);  ///< Whether an installed font has it.

 private:
  LetterFaces faces_;
  std::set<std::pair<int, char32_t>> wanted_;  ///< By ImGui's number of the font that lacks it.
  bool outdated_ = false;
};

}  // namespace sinew::app
