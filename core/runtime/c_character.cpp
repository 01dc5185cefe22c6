// core/runtime/c_character.cpp: the C interface of characters and poses, and its errors.
#include <algorithm>
#include <array>
#include <cstring>

#include "core/geometry/at.h"
#include "core/runtime/c_handles.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/local_pose.h"
#include "sinew/geometry/task_system.h"
#include "sinew/geometry/version.h"
#include "sinew/runtime/game_file.h"

namespace sinew::capi {
namespace {

thread_local std::array<char, 512> lastError{};

bool isOne(int index, std::size_t size) { return index >= 0 && toIndex(index) < size; }

sinew_code putBones(const Pose& pose, float* out, std::size_t floats) {
  if (out == nullptr) return fail(SINEW_BAD_ARGUMENT, "bones: null");
  if (floats < 16 * pose.boneInWorld.size()) return fail(SINEW_BAD_ARGUMENT, "bones: too few floats for all bones");
  std::memcpy(out, pose.boneInWorld.data(), sizeof(glm::mat4) * pose.boneInWorld.size());
  return SINEW_OK;
}

template <class T>
std::span<const T> floatsAs(const float* from, std::size_t size, std::vector<T>& copies) {
  if (from == nullptr) return {};
  copies.resize(size);
  std::memcpy(static_cast<void*>(copies.data()), from, size * sizeof(T));
  return copies;
}

}  // namespace

sinew_code fail(sinew_code code, const char* reason) {
  const std::size_t size = std::min(std::strlen(reason), lastError.size() - 1);
  std::memcpy(lastError.data(), reason, size);
  lastError[size] = '\0';
  return code;
}

sinew_code fail(sinew_code code, const Error& error) { return fail(code, error.text().c_str()); }

}  // namespace sinew::capi

using namespace sinew;
using namespace sinew::capi;

extern "C" {

const char* sinew_error(void) { return lastError.data(); }
const char* sinew_version(void) { return SINEW_VERSION_TEXT; }

void sinew_set_tasks(const sinew_tasks* tasks) {
  if (tasks == nullptr) setTaskSystem({});
  else setTaskSystem({tasks->run, tasks->user, tasks->threads});
}

sinew_code sinew_character_create(const void* bytes, size_t size, sinew_character** out) {
  if (out == nullptr) return fail(SINEW_BAD_ARGUMENT, "out: null");
  *out = nullptr;
  if (bytes == nullptr) return fail(SINEW_BAD_ARGUMENT, "bytes: null");
  return guarded([&] {
    auto read = readGameFile({static_cast<const std::byte*>(bytes), size});
    if (!read) return fail(SINEW_BAD_FILE, read.error());
    *out = new sinew_character{std::move(read.value().character), std::move(read.value().rig)};
    return SINEW_OK;
  });
}

void sinew_character_destroy(sinew_character* character) { delete character; }

int sinew_bone_count(const sinew_character* character) {
  return character == nullptr ? 0 : static_cast<int>(character->character->skeleton.bones.size());
}

const char* sinew_bone_name(const sinew_character* character, int bone) {
  if (!isOne(bone, toIndex(sinew_bone_count(character)))) return "";
  return at(character->character->skeleton.bones, bone).name.c_str();
}

int sinew_bone_parent(const sinew_character* character, int bone) {
  if (!isOne(bone, toIndex(sinew_bone_count(character)))) return -1;
  return at(character->character->skeleton.bones, bone).parent;
}

int sinew_bone_find(const sinew_character* character, const char* name) {
  if (character == nullptr || name == nullptr) return -1;
  return character->character->skeleton.findBone(name).value_or(-1);
}

sinew_code sinew_bone_bind(const sinew_character* character, int bone, float* matrix) {
  if (matrix == nullptr) return fail(SINEW_BAD_ARGUMENT, "matrix: null");
  if (!isOne(bone, toIndex(sinew_bone_count(character)))) return fail(SINEW_BAD_ARGUMENT, "bone: out of range");
  std::memcpy(matrix, &at(character->character->skeleton.bones, bone).bindInWorld, sizeof(glm::mat4));
  return SINEW_OK;
}

int sinew_clip_count(const sinew_character* character) {
  return character == nullptr ? 0 : static_cast<int>(character->character->clips.size());
}

const char* sinew_clip_name(const sinew_character* character, int clip) {
  return isOne(clip, toIndex(sinew_clip_count(character))) ? at(character->character->clips, clip).name.c_str() : "";
}

float sinew_clip_seconds(const sinew_character* character, int clip) {
  return isOne(clip, toIndex(sinew_clip_count(character))) ? at(character->character->clips, clip).duration : 0.0f;
}

int sinew_morph_count(const sinew_character* character) {
  return character == nullptr ? 0 : static_cast<int>(character->character->morphTargets.size());
}

int sinew_material_count(const sinew_character* character) {
  return character == nullptr ? 0 : static_cast<int>(character->character->materials.size());
}

const char* sinew_material_name(const sinew_character* character, int material) {
  if (!isOne(material, toIndex(sinew_material_count(character)))) return "";
  return at(character->character->materials, material).name.c_str();
}

sinew_code sinew_clip_sample(const sinew_character* character, int clip, float seconds, float* bones, size_t floats) {
  if (!isOne(clip, toIndex(sinew_clip_count(character)))) return fail(SINEW_BAD_ARGUMENT, "clip: out of range");
  if (!(seconds == seconds)) return fail(SINEW_BAD_ARGUMENT, "seconds: not a number");
  return guarded([&] {
    const Character& of = *character->character;
    return putBones(samplePose(of.skeleton, at(of.clips, clip), seconds), bones, floats);
  });
}

sinew_code sinew_pose_from_locals(const sinew_character* character, const float* rotations, const float* translations,
                                  const float* scales, float* bones, size_t floats) {
  if (character == nullptr) return fail(SINEW_BAD_ARGUMENT, "character: null");
  return guarded([&] {
    const Skeleton& skeleton = character->character->skeleton;
    const std::size_t count = skeleton.bones.size();
    std::vector<glm::quat> turns;
    if (rotations != nullptr) {
      for (std::size_t b = 0; b < count; ++b) {
        const float* q = rotations + 4 * b;
        turns.emplace_back(q[3], q[0], q[1], q[2]);
      }
    }
    std::vector<glm::vec3> places;
    std::vector<glm::vec3> sizes;
    const auto pose =
        poseFromLocals(skeleton, {turns, floatsAs(translations, count, places), floatsAs(scales, count, sizes)});
    if (!pose) return fail(SINEW_BAD_POSE, pose.error());
    return putBones(pose.value(), bones, floats);
  });
}

}  // extern "C"
