// app/command/contact_sheet.cpp: rows of pixels copied into place.
#include "app/command/contact_sheet.h"

#include <algorithm>
#include <cassert>

namespace sinew::app {

Image contactSheet(const std::vector<Image>& pictures, const glm::ivec2& cells) {
  assert(!pictures.empty() && pictures.size() <= static_cast<std::size_t>(cells.x * cells.y));
  const int width = pictures.front().width;
  const int height = pictures.front().height;
  Image sheet{width * cells.x, height * cells.y, {}};
  const auto rowBytes = 4 * static_cast<std::ptrdiff_t>(width);
  const std::ptrdiff_t sheetRow = rowBytes * cells.x;
  sheet.rgba.assign(static_cast<std::size_t>(sheetRow) * static_cast<std::size_t>(sheet.height), 0);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int column = static_cast<int>(i) % cells.x;
    const int row = static_cast<int>(i) / cells.x;
    for (int y = 0; y < height; ++y) {
      std::copy_n(pictures[i].rgba.begin() + y * rowBytes, rowBytes,
                  sheet.rgba.begin() + (row * height + y) * sheetRow + column * rowBytes);
    }
  }
  return sheet;
}

std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t shown = std::min(count, most);
  for (std::size_t i = 0; i < shown; ++i)
    chosen.push_back(shown == 1 ? 0 : (i * (count - 1) + (shown - 1) / 2) / (shown - 1));
  return chosen;
}

}  // namespace sinew::app
