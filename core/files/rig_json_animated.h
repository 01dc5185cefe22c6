// core/files/rig_json_animated.h: keys, drivers and channels in a rig file. docs/formats.md.
#pragma once

#include <vector>

#include "core/files/json/reader.h"
#include "core/files/json/writer.h"
#include "sinew/rig/animated_number.h"

namespace sinew {

/// "animated" of a primitive, a line or the surface; nothing where it is empty.
void setAnimated(ObjectWriter& writer, const std::vector<AnimatedNumber>& animated);
[[nodiscard]] std::vector<AnimatedNumber> readAnimated(Reader& reader, const Json& owner, const Place& place);

[[nodiscard]] Json channelNode(const RigChannel& channel);
[[nodiscard]] RigChannel readChannel(Reader& reader, const Json& node, const Place& place);

/// A bone and a point in its space: ends of lines, and of distances.
[[nodiscard]] Json anchorNode(const LineAnchor& anchor);
[[nodiscard]] LineAnchor readAnchor(Reader& reader, const Json& node, const Place& place);

}  // namespace sinew
