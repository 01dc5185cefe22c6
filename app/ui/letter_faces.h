// app/ui/letter_faces.h: single letters drawn by FreeType, from whichever installed font has them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace sinew::app {

// In which font files letters are looked for, in what order.

struct FontFile {
  std::string_view file;
  int face = 0;  ///< Of those in the file.
  bool operator==(const FontFile&) const = default;
};

/// Where a Chinese letter comes from: one code point has another form in each.
enum class HanRegion { kJapan, kKorea, kMainland, kTaiwan, kHongKong };

/// What the names of a document say: kana means Japan, hangul Korea. Else the user's language ("ja_JP.UTF-8"), else
/// mainland China.
[[nodiscard]] HanRegion hanRegion(std::u32string_view letters, std::string_view locale);
/// The language of the environment: the first of LC_ALL, LC_CTYPE, LANG that is set, or "".
[[nodiscard]] std::string_view localeOfEnvironment();

/// Files of Debian's packages that may have a letter, best first; any may be missing. @param strong  for headings
[[nodiscard]] std::vector<FontFile> fontFilesFor(char32_t c, bool strong, HanRegion region);

/// Height of the em square in pixels, beside an interface font of a height: Chinese letters fill theirs, so that
/// theirs is a little larger than that of Latin letters and still fits into the line.
[[nodiscard]] int wideEm(float fontSize);

/// Pixels from the top, one byte of coverage each.
struct LetterImage {
  glm::ivec2 size{0};
  glm::ivec2 offset{0};  ///< Of the upper left corner, from the pen on the baseline; y down.
  float advance = 0.0f;
  std::vector<std::uint8_t> coverage;
};

/// Opens a font file when a letter is first looked for in it, and keeps it open.
class LetterFaces {
 public:
  LetterFaces();
  ~LetterFaces();
  LetterFaces(const LetterFaces&) = delete;
  LetterFaces& operator=(const LetterFaces&) = delete;

  void setRegion(HanRegion region) { region_ = region; }
  [[nodiscard]] HanRegion region() const { return region_; }

  [[nodiscard]] bool has(char32_t c);
  /// @param height  of the interface font, pixels. None: no font has it, or its file is broken.
  [[nodiscard]] std::optional<LetterImage> draw(char32_t c, bool strong, float height);

 private:
  struct Library;
  struct Found;

  [[nodiscard]] std::optional<Found> find(char32_t c, bool strong);

  std::unique_ptr<Library> library_;
  HanRegion region_ = HanRegion::kMainland;
  std::map<char32_t, bool> known_;  ///< What has() found; regions have the same letters.
};

}  // namespace sinew::app
