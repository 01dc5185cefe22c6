// core/files/export/plain_source.h: a compressed file's JSON as that of the plain file it stands for.
#pragma once

#include "core/files/gltf/file.h"
#include "core/files/json/json.h"

namespace sinew::exporting {

/// Views, accessors and primitives as in the file's model, where those that were compressed are plain; the extensions
/// that compressed them are gone. What Draco has taken the place of nothing refers to any more.
/// @param root  all of the file's JSON, as it stands
void makePlain(Json& root, const gltf::File& file);

}  // namespace sinew::exporting
