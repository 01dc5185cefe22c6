/* core/include/sinew/c/sinew_runtime.h: Sinew's runtime for C and for everything that calls C. docs/games.md. */
#ifndef SINEW_C_SINEW_RUNTIME_H
#define SINEW_C_SINEW_RUNTIME_H

#include <stddef.h>
#include <stdint.h>

#include "sinew/geometry/same_version.h"

/* Seen from outside where a shared library is made of the runtime; of the C++ classes nothing is. */
#pragma GCC visibility push(default)
#ifdef __cplusplus
extern "C" {
#endif

/* Every function that can fail returns a code; sinew_error() then says why, in one line. Nothing throws. What is read
 * from a handle may be read by several threads at once; a smoother belongs to one thread at a time. */
typedef enum sinew_code {
  SINEW_OK = 0,
  SINEW_BAD_FILE = 1,     /* The bytes are no game file, or a damaged one. */
  SINEW_BAD_RIG = 2,      /* The rig or the detail that was asked for is refused. */
  SINEW_BAD_POSE = 3,     /* The pose is refused: the last surface stays. */
  SINEW_BAD_ARGUMENT = 4, /* A null pointer, a number out of range, a buffer that is too short. */
  SINEW_NO_MEMORY = 5
} sinew_code;

/* Why the last call on this thread that failed did so. Never null; until the next call that fails on this thread. */
const char* sinew_error(void);
/* "0.2.0", of the library; SINEW_VERSION_TEXT is that of this header. */
const char* sinew_version(void);

/* Does the work on the caller's threads in place of oneTBB's: sinew/geometry/task_system.h. */
typedef struct sinew_tasks {
  /* Calls task(work, i) once for each i = 0..tasks-1, in any order, on any threads; returns when all have returned. */
  void (*run)(void* user, int tasks, void (*task)(void* work, int index), void* work);
  void* user;
  int threads; /* That run() works on, the calling one among them. */
} sinew_tasks;
/* Null: Sinew's own threads again. Not while another thread calls Sinew. */
void sinew_set_tasks(const sinew_tasks* tasks);

/* A character with its rig. Smoothers keep what they need of it: it may be destroyed before them. */
typedef struct sinew_character sinew_character;

/* From a game file in memory, which may be freed afterwards. On failure *out is null. */
sinew_code sinew_character_create(const void* bytes, size_t size, sinew_character** out);
void sinew_character_destroy(sinew_character* character); /* Null does nothing. */

int sinew_bone_count(const sinew_character* character);
/* "" for an index out of range. Lives as long as the character. */
const char* sinew_bone_name(const sinew_character* character, int bone);
/* -1: none, or an index out of range. */
int sinew_bone_parent(const sinew_character* character, int bone);
/* By name, or by path where several have the name; -1: none. */
int sinew_bone_find(const sinew_character* character, const char* name);
/* 16 floats, column by column: bone space -> world where the skin was bound. */
sinew_code sinew_bone_bind(const sinew_character* character, int bone, float* matrix);
int sinew_clip_count(const sinew_character* character);
const char* sinew_clip_name(const sinew_character* character, int clip);
float sinew_clip_seconds(const sinew_character* character, int clip);
int sinew_morph_count(const sinew_character* character);
int sinew_material_count(const sinew_character* character);
const char* sinew_material_name(const sinew_character* character, int material);

/* A moment. Start from {0}. */
typedef struct sinew_pose {
  const float* bones;         /* 16 floats for each bone, column by column: bone space -> world. */
  size_t bone_count;          /* At least sinew_bone_count(). */
  const float* morph_weights; /* One for each morph target; null: as in the file. */
  size_t morph_count;
  float flex;   /* Added to the activation of muscle lines, 0..1. */
  int has_clip; /* 0: keys of the rig's numbers that name a clip do not count. */
  int clip;     /* Which clip plays, where has_clip is not 0. */
  float clip_seconds;
} sinew_pose;

/* Bones of a clip at a time, clamped to it, into the caller's 16 * sinew_bone_count() floats. */
sinew_code sinew_clip_sample(const sinew_character* character, int clip, float seconds, float* bones, size_t floats);
/* Bones from how each stands to its node's parent, as in glTF: 4 floats x, y, z, w; 3; 3. Null: as at rest. */
sinew_code sinew_pose_from_locals(const sinew_character* character, const float* rotations, const float* translations,
                                  const float* scales, float* bones, size_t floats);

/* How fine a surface is. Start from {0}: as the rig says, the whole body. At most one of depth and tolerance. */
typedef struct sinew_detail {
  int depth;         /* 1..16: each triangle of the character becomes depth * depth. 0: not asked. */
  float tolerance;   /* 0.0001..0.01 of the height: adaptive. 0: not asked. */
  const int* bones;  /* Refined is the skin of these and of all that hang on them. Read by the call alone. */
  size_t bone_count; /* 0: the whole body. */
} sinew_detail;

/* A character prepared at one detail, and its last surface. */
typedef struct sinew_smoother sinew_smoother;

/* Takes as long as opening a character: not in a frame. Detail may be null. On failure *out is null. */
sinew_code sinew_smoother_create(const sinew_character* character, const sinew_detail* detail, sinew_smoother** out);
/* Another one of the same character at another detail, or for another thread: shares all that the detail leaves. */
sinew_code sinew_smoother_share(const sinew_smoother* from, const sinew_detail* detail, sinew_smoother** out);
void sinew_smoother_destroy(sinew_smoother* smoother); /* Null does nothing. */

/* Allocates nothing once all poses of a kind have been seen. SINEW_BAD_POSE: the last surface stays. */
sinew_code sinew_smooth(sinew_smoother* smoother, const sinew_pose* pose);

typedef enum sinew_vertices {
  SINEW_DRAWN = 0,  /* One for each texture coordinate: what is drawn. */
  SINEW_REFINED = 1 /* One for each point of the surface: for shadows and collisions. */
} sinew_vertices;
typedef enum sinew_format {
  SINEW_FLOAT3 = 0, /* 12 bytes. */
  SINEW_HALF4 = 1,  /* Positions: 8 bytes. */
  SINEW_SNORM10 = 2 /* Normals: 10-10-10-2, 4 bytes. */
} sinew_format;

/* Where members lie in the caller's vertices. What lies between them is left as it is. */
typedef struct sinew_layout {
  size_t stride;       /* Bytes from one vertex to the next. */
  int position_offset; /* Byte in the vertex; -1: none. */
  int normal_offset;
  sinew_format position_format;
  sinew_format normal_format;
  sinew_vertices vertices;
  float origin[3]; /* Taken off positions. */
} sinew_layout;

size_t sinew_vertex_count(const sinew_smoother* smoother, sinew_vertices vertices);
size_t sinew_index_count(const sinew_smoother* smoother);
/* The last surface, into the caller's buffer. Each frame; allocates nothing. */
sinew_code sinew_write_vertices(const sinew_smoother* smoother, const sinew_layout* layout, void* out, size_t bytes);
/* Once for each smoother: texture coordinates of drawn vertices, 2 floats each, and triangles in order of materials. */
sinew_code sinew_write_uvs(const sinew_smoother* smoother, size_t stride, size_t offset, void* out, size_t bytes);
/* index_bytes: 2 or 4. */
sinew_code sinew_write_indices(const sinew_smoother* smoother, sinew_vertices vertices, int index_bytes, void* out,
                               size_t bytes);
/* The indices of one material: count 0 where it has none. */
sinew_code sinew_material_indices(const sinew_smoother* smoother, int material, size_t* first, size_t* count);

#ifdef __cplusplus
}
#endif
#pragma GCC visibility pop

#endif
