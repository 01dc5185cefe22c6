// app/viewport/render/png.h: a picture as the bytes of a .png file.
#pragma once

#include <string>

#include "app/viewport/render/viewport.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Same picture, same bytes. Opaque pictures are written without alpha. Error: the encoder had no memory.
[[nodiscard]] Result<std::string> pngBytes(const Image& image);

}  // namespace sinew::app
