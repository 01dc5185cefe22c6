// app/command/contact_sheet.h: many pictures in one, in rows.
#pragma once

#include <cstddef>
#include <vector>

#include "app/viewport/render/viewport.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {

/// From left to right, then from top to bottom; cells without a picture are transparent.
/// @param cells  columns, rows  @param pictures  at least one, all as large as the first, at most as many as cells
[[nodiscard]] Image contactSheet(const std::vector<Image>& pictures, const glm::ivec2& cells);

/// Which of `count` things are shown where there is room for `most`: as many, evenly spread, first and last among them.
[[nodiscard]] std::vector<std::size_t> evenly(std::size_t count, std::size_t most);

}  // namespace sinew::app
