// core/runtime/c_interface.cpp: the C interface: its handles, errors, characters, poses and surfaces.
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/at.h"
#include "sinew/c/sinew_runtime.h"
#include "sinew/character/character.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/local_pose.h"
#include "sinew/character/pose_check.h"
#include "sinew/geometry/result.h"
#include "sinew/geometry/task_system.h"
#include "sinew/geometry/version.h"
#include "sinew/rig/rig.h"
#include "sinew/runtime/game_file.h"
#include "sinew/runtime/vertex_buffer.h"
#include "sinew/surface/region.h"
#include "sinew/surface/smoother.h"

struct sinew_character {
  std::shared_ptr<const sinew::Character> character;
  sinew::Rig rig;
};

struct sinew_smoother {
  sinew_character of;
  sinew::Smoother smoother;
  sinew::Surface surface;
  sinew::Pose pose{};                       ///< Reused from frame to frame.
  std::vector<sinew::IndexRange> ranges{};  ///< Of materials.
};

namespace sinew::capi {
namespace {

thread_local std::array<char, 512> lastError{};

/// Keeps the reason for sinew_error(), truncated if very long; does not allocate.
sinew_code fail(sinew_code code, const char* reason) {
  const std::size_t size = std::min(std::strlen(reason), lastError.size() - 1);
  std::memcpy(lastError.data(), reason, size);
  lastError[size] = '\0';
  return code;
}

sinew_code fail(sinew_code code, const Error& error) { return fail(code, error.text().c_str()); }

/// No exception leaves the interface.
template <class Work>
sinew_code guarded(Work work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(SINEW_NO_MEMORY, "out of memory");
  } catch (...) {
    return fail(SINEW_NO_MEMORY, "the call could not be finished");
  }
}

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

std::optional<BufferVertices> verticesOf(sinew_vertices vertices) {
  if (vertices == SINEW_DRAWN) return BufferVertices::kDrawn;
  if (vertices == SINEW_REFINED) return BufferVertices::kRefined;
  return std::nullopt;
}

Result<Rig> detailed(Rig rig, const sinew_detail* detail) {
  if (detail == nullptr || (detail->depth == 0 && detail->tolerance == 0.0f)) return rig;
  if (detail->depth != 0 && detail->tolerance != 0.0f) return errorAt("detail", "give depth or tolerance, not both");
  if (detail->depth != 0) {
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = detail->depth;
  } else {
    rig.smoothing.detail = DetailKind::kAdaptive;
    rig.smoothing.tolerance = detail->tolerance;
  }
  return rig;
}

Result<Region> regionOf(const Character& character, const sinew_detail* detail) {
  if (detail == nullptr || detail->bone_count == 0) return Region();
  if (detail->bones == nullptr) return errorAt("detail", "bones: null");
  const std::span bones(detail->bones, detail->bone_count);
  for (const int bone : bones) {
    if (bone < 0 || toIndex(bone) >= character.skeleton.bones.size()) {
      return errorAt("detail", "bones: there is no bone " + std::to_string(bone));
    }
  }
  return regionOfBones(character, bones);
}

/// Prepares the smoother and makes the surface of the bind pose, so that there always is one.
sinew_code finish(std::unique_ptr<sinew_smoother> made, const sinew_detail* detail, sinew_smoother** out) {
  const auto rig = detailed(made->of.rig, detail);
  if (!rig) return fail(SINEW_BAD_ARGUMENT, rig.error());
  const Character& character = *made->of.character;
  const auto region = regionOf(character, detail);
  if (!region) return fail(SINEW_BAD_ARGUMENT, region.error());
  if (const auto prepared = made->smoother.prepare(rig.value(), {}, region.value()); !prepared) {
    return fail(SINEW_BAD_RIG, prepared.error());
  }
  made->smoother.smooth(bindPose(character.skeleton), made->surface);
  made->ranges = indexRanges(*made->surface.refinement, character.mesh);
  *out = made.release();
  return SINEW_OK;
}

Result<VertexLayout> layoutOf(const sinew_layout& from) {
  const auto vertices = verticesOf(from.vertices);
  if (!vertices) return errorAt("layout", "vertices: SINEW_DRAWN or SINEW_REFINED");
  if (from.position_format != SINEW_FLOAT3 && from.position_format != SINEW_HALF4) {
    return errorAt("layout", "position_format: SINEW_FLOAT3 or SINEW_HALF4");
  }
  if (from.normal_format != SINEW_FLOAT3 && from.normal_format != SINEW_SNORM10) {
    return errorAt("layout", "normal_format: SINEW_FLOAT3 or SINEW_SNORM10");
  }
  VertexLayout layout;
  layout.stride = from.stride;
  layout.position = from.position_offset;
  layout.normal = from.normal_offset;
  layout.positions = from.position_format == SINEW_HALF4 ? PositionFormat::kHalf : PositionFormat::kFloat;
  layout.normals = from.normal_format == SINEW_SNORM10 ? NormalFormat::kSnorm10 : NormalFormat::kFloat;
  layout.vertices = *vertices;
  layout.origin = {from.origin[0], from.origin[1], from.origin[2]};
  return layout;
}

/// Converts the caller's pose, reusing memory.
Result<void> takePose(const Character& character, const sinew_pose& from, Pose& to) {
  if (from.bones == nullptr) return errorAt("pose", "bones: null");
  const std::size_t bones = std::min(from.bone_count, character.skeleton.bones.size());
  to.boneInWorld.resize(bones);
  std::memcpy(static_cast<void*>(to.boneInWorld.data()), from.bones, bones * sizeof(glm::mat4));
  if (from.morph_weights == nullptr) to.morphWeights.clear();
  else if (from.morph_count != character.morphTargets.size()) {
    return errorAt("pose", "expected weights of " + std::to_string(character.morphTargets.size()) +
                               " morph targets, got " + std::to_string(from.morph_count));
  } else to.morphWeights.assign(from.morph_weights, from.morph_weights + from.morph_count);
  to.flex = from.flex;
  to.clip.clear();
  to.time = 0.0f;
  if (from.has_clip == 0) return {};
  if (from.clip < 0 || toIndex(from.clip) >= character.clips.size()) return errorAt("pose", "clip: out of range");
  to.clip = at(character.clips, from.clip).name;
  to.time = from.clip_seconds;
  return {};
}

sinew_code codeOf(const Result<void>& done) { return done ? SINEW_OK : fail(SINEW_BAD_ARGUMENT, done.error()); }

const Refinement& refinementOf(const sinew_smoother& smoother) { return *smoother.surface.refinement; }

}  // namespace
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

sinew_code sinew_smoother_create(const sinew_character* character, const sinew_detail* detail, sinew_smoother** out) {
  if (out == nullptr) return fail(SINEW_BAD_ARGUMENT, "out: null");
  *out = nullptr;
  if (character == nullptr) return fail(SINEW_BAD_ARGUMENT, "character: null");
  return guarded([&] {
    return finish(std::make_unique<sinew_smoother>(sinew_smoother{*character, Smoother(character->character), {}}),
                  detail, out);
  });
}

sinew_code sinew_smoother_share(const sinew_smoother* from, const sinew_detail* detail, sinew_smoother** out) {
  if (out == nullptr) return fail(SINEW_BAD_ARGUMENT, "out: null");
  *out = nullptr;
  if (from == nullptr) return fail(SINEW_BAD_ARGUMENT, "from: null");
  return guarded([&] {
    return finish(std::make_unique<sinew_smoother>(sinew_smoother{from->of, from->smoother.twin(), {}}), detail, out);
  });
}

void sinew_smoother_destroy(sinew_smoother* smoother) { delete smoother; }

sinew_code sinew_smooth(sinew_smoother* smoother, const sinew_pose* pose) {
  if (smoother == nullptr || pose == nullptr) return fail(SINEW_BAD_ARGUMENT, "smoother or pose: null");
  return guarded([&] {
    const Character& character = *smoother->of.character;
    if (const auto taken = takePose(character, *pose, smoother->pose); !taken) {
      return fail(SINEW_BAD_POSE, taken.error());
    }
    if (smoother->smoother.smooth(smoother->pose, smoother->surface)) return SINEW_OK;
    return fail(SINEW_BAD_POSE, checkPose(character, smoother->pose).error());
  });
}

size_t sinew_vertex_count(const sinew_smoother* smoother, sinew_vertices vertices) {
  const auto which = verticesOf(vertices);
  return smoother == nullptr || !which ? 0 : vertexCount(refinementOf(*smoother), *which);
}

size_t sinew_index_count(const sinew_smoother* smoother) {
  return smoother == nullptr ? 0 : indexCount(refinementOf(*smoother));
}

sinew_code sinew_write_vertices(const sinew_smoother* smoother, const sinew_layout* layout, void* out, size_t bytes) {
  if (smoother == nullptr || layout == nullptr || out == nullptr) {
    return fail(SINEW_BAD_ARGUMENT, "smoother, layout or out: null");
  }
  return guarded([&] {
    const auto known = layoutOf(*layout);
    if (!known) return fail(SINEW_BAD_ARGUMENT, known.error());
    return codeOf(writeVertices(smoother->surface, known.value(), {static_cast<std::byte*>(out), bytes}));
  });
}

sinew_code sinew_write_uvs(const sinew_smoother* smoother, size_t stride, size_t offset, void* out, size_t bytes) {
  if (smoother == nullptr || out == nullptr) return fail(SINEW_BAD_ARGUMENT, "smoother or out: null");
  return guarded([&] {
    return codeOf(writeUvs(refinementOf(*smoother), stride, offset, {static_cast<std::byte*>(out), bytes}));
  });
}

sinew_code sinew_write_indices(const sinew_smoother* smoother, sinew_vertices vertices, int index_bytes, void* out,
                               size_t bytes) {
  if (smoother == nullptr || out == nullptr) return fail(SINEW_BAD_ARGUMENT, "smoother or out: null");
  const auto which = verticesOf(vertices);
  if (!which) return fail(SINEW_BAD_ARGUMENT, "vertices: SINEW_DRAWN or SINEW_REFINED");
  return guarded([&] {
    const Refinement& refinement = refinementOf(*smoother);
    const ControlMesh& mesh = smoother->of.character->mesh;
    if (index_bytes == 2) {
      return codeOf(writeIndices(refinement, mesh, *which, std::span(static_cast<std::uint16_t*>(out), bytes / 2)));
    }
    if (index_bytes == 4) {
      return codeOf(writeIndices(refinement, mesh, *which, std::span(static_cast<std::uint32_t*>(out), bytes / 4)));
    }
    return fail(SINEW_BAD_ARGUMENT, "index_bytes: 2 or 4");
  });
}

sinew_code sinew_material_indices(const sinew_smoother* smoother, int material, size_t* first, size_t* count) {
  if (smoother == nullptr || first == nullptr || count == nullptr) {
    return fail(SINEW_BAD_ARGUMENT, "smoother, first or count: null");
  }
  *first = *count = 0;
  if (material < 0 || toIndex(material) >= smoother->of.character->materials.size()) {
    return fail(SINEW_BAD_ARGUMENT, "material: out of range");
  }
  const auto found = std::ranges::find(smoother->ranges, material, &IndexRange::material);
  if (found == smoother->ranges.end()) return SINEW_OK;
  *first = found->first;
  *count = found->count;
  return SINEW_OK;
}

}  // extern "C"
