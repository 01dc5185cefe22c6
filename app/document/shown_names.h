// app/document/shown_names.h: names as the editor shows them: bones, clips and parts without what all of them share.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// "1 muscle", "3 muscles". @param one  "muscle"
[[nodiscard]] std::string withCount(std::size_t count, const char* one);

/// "biceps L", or "3 muscles"; a sheet is one. @param indices  into the rig
[[nodiscard]] std::string namedMuscles(const Rig& rig, std::span<const int> indices);

/// "upper_arm.L muscle": name of a new muscle on a bone, which may be taken.
[[nodiscard]] std::string defaultMuscleName(const Skeleton& skeleton, int bone);

/// `after`, where muscles moved to another bone get its default name if they had that of the former one; twins with
/// the mirrored name follow. Both rigs have the same muscles in the same order.
[[nodiscard]] Rig withDefaultNames(const Rig& before, Rig after, const Skeleton& skeleton);

/// The names without their common prefix up to a "|", ":" or "/" and their common suffix from a "|" on:
/// "Armature|Walk", "Armature|Run" -> "Walk", "Run". A prefix up to a "_", "-", "." or space goes if at least
/// kManyNames share it and a letter follows in each: "Bip01_Spine" -> "Spine", but "walk_fast", "walk_slow" stay; a
/// suffix likewise: "Hips_Joint_01" -> "Hips". A name that is only the common part stays whole, and so do all if two
/// would become equal. A single name loses all up to its last "|", ":" or "/".
[[nodiscard]] std::vector<std::string> withoutSharedParts(const std::vector<std::string>& names);
inline constexpr std::size_t kManyNames = 8;

/// [bones] and [clips] of a character. A clip without a name is "clip N"; clips made by the editor keep theirs. Names
/// that no font can show are "bone N" or "clip N" (app/ui/code_points.h).
[[nodiscard]] std::vector<std::string> shownBoneNames(const Skeleton& skeleton);
[[nodiscard]] std::vector<std::string> shownClipNames(const Character& character);
[[nodiscard]] std::vector<std::string> shownPartNames(const Character& character);  ///< [parts] of the mesh.
/// [bones] regardless of fonts: for names of new muscles.
[[nodiscard]] std::vector<std::string> shortBoneNames(const Skeleton& skeleton);
/// [bones] the path where the name is ambiguous: for lists to choose from.
[[nodiscard]] std::vector<std::string> shownFileNames(const Skeleton& skeleton);
[[nodiscard]] std::string shownBoneName(const Skeleton& skeleton, int bone);  ///< "" for index -1.
/// By a rig file's name, which is returned if the bone is unknown.
[[nodiscard]] std::string shownBoneName(const Skeleton& skeleton, const std::string& fileName);

}  // namespace sinew::app
