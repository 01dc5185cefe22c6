// core/files/rig_json_parts.h: lines, keys, drivers and channels of a rig file. docs/formats.md.
#pragma once

#include <vector>

#include "core/files/json/json.h"
#include "sinew/rig/animated_number.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/rig/rig.h"

namespace sinew {

[[nodiscard]] Json lineNode(const MuscleLine& line);  ///< Omits defaults.
[[nodiscard]] MuscleLine readLine(Reader& reader, const Json& node, const Place& place);

[[nodiscard]] Json anchorNode(const LineAnchor& anchor);
[[nodiscard]] LineAnchor readAnchor(Reader& reader, const Json& node, const Place& place);

/// The settings of a line, without defaults, as members of its own object.
void setLineSettings(ObjectWriter& writer, const LineSettings& settings, const std::string& unknownActivation);
[[nodiscard]] LineSettings readLineSettings(Reader& reader, const Json& node, const Place& place,
                                            std::string& unknownActivation);

/// Everything of a sheet but name, group, edges and twin, without defaults.
void setSheetSettings(ObjectWriter& writer, const MuscleSheet& sheet);
void readSheetSettings(Reader& reader, const Json& node, const Place& place, MuscleSheet& sheet);
[[nodiscard]] Json sheetNode(const MuscleSheet& sheet);  ///< Omits defaults.
[[nodiscard]] MuscleSheet readSheet(Reader& reader, const Json& node, const Place& place);

/// Sets "animated" of a primitive, line, shape, link or the surface, unless empty.
void setAnimated(ObjectWriter& writer, const std::vector<AnimatedNumber>& animated);
[[nodiscard]] std::vector<AnimatedNumber> readAnimated(Reader& reader, const Json& owner, const Place& place);

/// A list, without an amount of 1; with keys, drivers or unknown keys an object.
[[nodiscard]] Json linkNode(const Link& link);
[[nodiscard]] Link readLink(Reader& reader, const Json& node, const Place& place);
[[nodiscard]] Json channelNode(const RigChannel& channel);
[[nodiscard]] RigChannel readChannel(Reader& reader, const Json& node, const Place& place);

/// An optional name; refuses an empty one. @param expected  "the name of a line"
void readName(Reader& reader, const Json& object, const Place& place, const char* key, const char* expected,
              std::string& name);

/// A required member of three numbers.
void readNeededPoint(Reader& reader, const Json& object, const Place& place, const char* key, glm::vec3& point);

}  // namespace sinew
