/* tests/runtime/c_caller.c: a game in C11: loads a file, plays a clip into its buffer. */
#include <stdlib.h>
#include <string.h>

#include "sinew/c/sinew_runtime.h"

_Static_assert(SINEW_VERSION_NUMBER >= 100, "the version is a number that the preprocessor can compare");

/* 0, or the line that failed. Fills `vertices` (24 bytes each) and `indices` with the surface of a clip's moment. */
int play_in_c(const void* file, size_t size, int clip, float seconds, void* vertices, size_t vertex_bytes,
              uint16_t* indices, size_t index_bytes) {
  sinew_character* character = NULL;
  sinew_smoother* smoother = NULL;
  sinew_pose pose = {0};
  sinew_layout layout = {0};
  size_t floats = 0;
  float* bones = NULL;
  int failed = 0;
  if (sinew_character_create(file, size, &character) != SINEW_OK) return __LINE__;
  floats = 16 * (size_t)sinew_bone_count(character);
  bones = malloc(floats * sizeof *bones);
  layout.stride = 24;
  layout.normal_offset = 12;
  pose.bones = bones;
  pose.bone_count = floats / 16;
  pose.has_clip = 1;
  pose.clip = clip;
  pose.clip_seconds = seconds;
  if (sinew_clip_sample(character, clip, seconds, bones, floats) != SINEW_OK) failed = __LINE__;
  else if (sinew_smoother_create(character, NULL, &smoother) != SINEW_OK) failed = __LINE__;
  else if (sinew_smooth(smoother, &pose) != SINEW_OK) failed = __LINE__;
  else if (sinew_write_vertices(smoother, &layout, vertices, vertex_bytes) != SINEW_OK) failed = __LINE__;
  else if (sinew_write_indices(smoother, SINEW_DRAWN, 2, indices, index_bytes) != SINEW_OK) failed = __LINE__;
  else if (strcmp(sinew_version(), SINEW_VERSION_TEXT) != 0) failed = __LINE__;
  free(bones);
  sinew_smoother_destroy(smoother);
  sinew_character_destroy(character);
  return failed;
}

/* A task system in C: in order, on the calling thread, and counted. */
static void run_in_order(void* user, int tasks, void (*task)(void* work, int index), void* work) {
  int i = 0;
  *(int*)user += tasks;
  for (i = 0; i < tasks; ++i) task(work, i);
}

void use_tasks_of_c(int* count) {
  sinew_tasks tasks = {0};
  tasks.run = run_in_order;
  tasks.user = count;
  tasks.threads = 4;
  sinew_set_tasks(count == NULL ? NULL : &tasks);
}
