// app/document/shown_names.h: names of clips and bones as the editor shows them: without what all of them share.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"

namespace sinew::app {

/// The names in the same order, without what all share in front up to a "|", ":" or "/" and behind from a "|" on:
/// "Armature|Walk", "Armature|Run" -> "Walk", "Run". What they share up to a "_", "-", "." or space goes where at least
/// kManyNames share it and a letter follows in each: "Bip01_Spine" -> "Spine", but "walk_fast", "walk_slow" stay. So
/// does what as many share behind from one of these on: "Hips_Joint_01", "Neck_Joint_01" -> "Hips", "Neck". A name
/// that is nothing but the shared part stays whole, and so do all where two would become the same. A single name
/// loses all up to its last "|", ":" or "/".
[[nodiscard]] std::vector<std::string> withoutSharedParts(const std::vector<std::string>& names);
inline constexpr std::size_t kManyNames = 8;

/// [bones] and [clips] of a character. A clip without a name is "clip N"; one that the editor has made keeps its name.
/// Files and the command line use the names of the file. What no font can show is "bone N" or "clip N"
/// (app/ui/readable_names.h).
[[nodiscard]] std::vector<std::string> shownBoneNames(const Skeleton& skeleton);
[[nodiscard]] std::vector<std::string> shownClipNames(const Character& character);
/// [parts] The same of the parts of the mesh: "part N".
[[nodiscard]] std::vector<std::string> shownPartNames(const Character& character);
/// [bones] The same, whatever fonts there are: what new muscles are named after.
[[nodiscard]] std::vector<std::string> shortBoneNames(const Skeleton& skeleton);
/// [bones] The same where it names one bone alone, else its path: for lists to choose from.
[[nodiscard]] std::vector<std::string> shownFileNames(const Skeleton& skeleton);
/// One of the bones. Index -1: "".
[[nodiscard]] std::string shownBoneName(const Skeleton& skeleton, int bone);
/// The bone that a rig file calls so, else the name itself.
[[nodiscard]] std::string shownBoneName(const Skeleton& skeleton, const std::string& fileName);

}  // namespace sinew::app
