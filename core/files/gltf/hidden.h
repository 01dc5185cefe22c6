// core/files/gltf/hidden.h: characters that would be invisible because of their alpha.
#pragma once

#include "core/files/gltf/notes.h"
#include "sinew/character/character.h"

namespace sinew::gltf {

/// Some converters write alpha 0 by mistake. A material is hidden if the largest alpha it can have (base color's *
/// texture's * vertex colors') is below its cutoff (MASK) or rounds to 0 (BLEND). A hidden part of a visible character
/// is taken as intended. If every material in use is hidden, all of them become Material::shownOpaque, each with a
/// note.
void showHiddenCharacter(Character& character, Notes& notes);

}  // namespace sinew::gltf
