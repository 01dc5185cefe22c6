// core/files/rig_json_lines.h: muscle lines in a rig file. docs/formats.md.
#pragma once

#include "core/files/json/reader.h"
#include "sinew/rig/muscle_line.h"

namespace sinew {

/// Members at their defaults are left out.
[[nodiscard]] Json lineNode(const MuscleLine& line);
[[nodiscard]] MuscleLine readLine(Reader& reader, const Json& node, const Place& place);

}  // namespace sinew
