// app/ui/letter_faces.h: single letters drawn by FreeType, from whichever installed font has them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/ui/letter_fonts.h"

namespace sinew::app {

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
