/* core/include/sinew/c/sinew_runtime.h: Sinew's runtime for C and languages that call C. docs/games.md. */
#ifndef SINEW_C_SINEW_RUNTIME_H
#define SINEW_C_SINEW_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

#include "sinew/geometry/same_version.h"

/* Exported if a shared library is made from the runtime, unlike the C++ classes. */
#pragma GCC visibility push(default)
#ifdef __cplusplus
extern "C" {
#endif

/* Functions that can fail return a code; sinew_error() then gives the reason in one line. Nothing throws. Several
 * threads may read from a handle at once; a smoother belongs to one thread at a time. */
typedef enum sinew_code {
  SINEW_OK = 0,
  SINEW_BAD_FILE = 1,     /* The bytes are no game file, or a damaged one. */
  SINEW_BAD_RIG = 2,      /* The rig or the requested detail is refused. */
  SINEW_BAD_POSE = 3,     /* The pose is refused: the last surface stays. */
  SINEW_BAD_ARGUMENT = 4, /* A null pointer, a number out of range, a buffer that is too short. */
  SINEW_NO_MEMORY = 5
} sinew_code;

/* Reason of the last failure on this thread. Never null; valid until the next failure on this thread. */
const char* sinew_error(void);
/* Version of the library, "0.2.0"; SINEW_VERSION_TEXT is that of this header. */
const char* sinew_version(void);

/* Runs the work on the caller's threads instead of oneTBB's: sinew/geometry/task_system.h. */
typedef struct sinew_tasks {
  /* Calls task(work, i) once for each i = 0..tasks-1, in any order, on any threads; returns when all have returned. */
  void (*run)(void* user, int tasks, void (*task)(void* work, int index), void* work);
  void* user;
  int threads; /* Number of threads of run(), including the calling one. */
} sinew_tasks;
/* Null: Sinew's own threads again. Not while another thread calls Sinew. */
void sinew_set_tasks(const sinew_tasks* tasks);

/* A character with its rig. May be destroyed before its smoothers. */
typedef struct sinew_character sinew_character;

/* From a game file in memory, which may be freed afterwards. On failure *out is null. */
sinew_code sinew_character_create(const void* bytes, size_t size, sinew_character** out);
void sinew_character_destroy(sinew_character* character); /* Null does nothing. */

int sinew_bone_count(const sinew_character* character);
/* "": index out of range. Valid as long as the character. */
const char* sinew_bone_name(const sinew_character* character, int bone);
/* -1: none, or an index out of range. */
int sinew_bone_parent(const sinew_character* character, int bone);
/* By name, or by path if several have the name; -1: none. */
int sinew_bone_find(const sinew_character* character, const char* name);
/* 16 floats, column by column: bone space -> world in the bind pose. */
sinew_code sinew_bone_bind(const sinew_character* character, int bone, float* matrix);
int sinew_clip_count(const sinew_character* character);
const char* sinew_clip_name(const sinew_character* character, int clip);
float sinew_clip_seconds(const sinew_character* character, int clip);
int sinew_morph_count(const sinew_character* character);
int sinew_material_count(const sinew_character* character);
const char* sinew_material_name(const sinew_character* character, int material);

/* Initialize with {0}. */
typedef struct sinew_pose {
  const float* bones;         /* 16 floats for each bone, column by column: bone space -> world. */
  size_t bone_count;          /* At least sinew_bone_count(). */
  const float* morph_weights; /* One for each morph target; null: as in the file. */
  size_t morph_count;
  float flex;   /* Added to the activation of muscle lines, 0..1. */
  int has_clip; /* 0: no clip, and keys for clips do not apply. */
  int clip;     /* The clip, if has_clip is not 0. */
  float clip_seconds;
} sinew_pose;

/* Writes the bones of a clip at a time, clamped to it, to the caller's 16 * sinew_bone_count() floats. */
sinew_code sinew_clip_sample(const sinew_character* character, int clip, float seconds, float* bones, size_t floats);
/* Bones from transforms relative to the parents of nodes, as in glTF: 4 floats x, y, z, w; 3; 3. Null: as at rest. */
sinew_code sinew_pose_from_locals(const sinew_character* character, const float* rotations, const float* translations,
                                  const float* scales, float* bones, size_t floats);

/* Detail of a surface. Initialize with {0} for the rig's detail of the whole body. Set at most one of depth and
 * tolerance. */
typedef struct sinew_detail {
  int depth;         /* 1..16: each triangle of the character becomes depth * depth. 0: not set. */
  float tolerance;   /* 0.0001..0.01 of the height: adaptive. 0: not set. */
  const int* bones;  /* Refines the skin of these bones and all below them. Only read during the call. */
  size_t bone_count; /* 0: the whole body. */
} sinew_detail;

/* A character prepared at one detail, and its last surface. */
typedef struct sinew_smoother sinew_smoother;

/* Too slow for use within a frame. Detail may be null. On failure *out is null. */
sinew_code sinew_smoother_create(const sinew_character* character, const sinew_detail* detail, sinew_smoother** out);
/* A smoother of the same character at another detail, or for another thread; shares data that is independent of it. */
sinew_code sinew_smoother_share(const sinew_smoother* from, const sinew_detail* detail, sinew_smoother** out);
void sinew_smoother_destroy(sinew_smoother* smoother); /* Null does nothing. */

/* Allocates nothing once memory has grown. SINEW_BAD_POSE: the last surface stays. */
sinew_code sinew_smooth(sinew_smoother* smoother, const sinew_pose* pose);

typedef enum sinew_vertices {
  SINEW_DRAWN = 0,  /* One for each texture coordinate, for drawing. */
  SINEW_REFINED = 1 /* One for each point of the surface, for shadows and collisions. */
} sinew_vertices;
typedef enum sinew_format {
  SINEW_FLOAT3 = 0, /* 12 bytes. */
  SINEW_HALF4 = 1,  /* Positions: 8 bytes. */
  SINEW_SNORM10 = 2 /* Normals: 10-10-10-2, 4 bytes. */
} sinew_format;

/* Layout of the caller's vertices. Bytes between members are not changed. */
typedef struct sinew_layout {
  size_t stride;       /* Bytes from one vertex to the next. */
  int position_offset; /* Byte in the vertex; -1: none. */
  int normal_offset;
  sinew_format position_format;
  sinew_format normal_format;
  sinew_vertices vertices;
  float origin[3]; /* Subtracted from positions. */
} sinew_layout;

size_t sinew_vertex_count(const sinew_smoother* smoother, sinew_vertices vertices);
size_t sinew_index_count(const sinew_smoother* smoother);
/* Writes the last surface to the caller's buffer, once per frame. Allocates nothing. */
sinew_code sinew_write_vertices(const sinew_smoother* smoother, const sinew_layout* layout, void* out, size_t bytes);
/* Once per smoother: texture coordinates of drawn vertices, 2 floats each, and triangles in order of materials. */
sinew_code sinew_write_uvs(const sinew_smoother* smoother, size_t stride, size_t offset, void* out, size_t bytes);
/* index_bytes: 2 or 4. */
sinew_code sinew_write_indices(const sinew_smoother* smoother, sinew_vertices vertices, int index_bytes, void* out,
                               size_t bytes);
/* The indices of one material; count may be 0. */
sinew_code sinew_material_indices(const sinew_smoother* smoother, int material, size_t* first, size_t* count);

#ifdef __cplusplus
}
#endif
#pragma GCC visibility pop

#endif
