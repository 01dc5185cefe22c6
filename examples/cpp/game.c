/* examples/cpp/game.c: the C interface: a clip played into a vertex buffer. game FILE.sinew */
#include <stdio.h>
#include <stdlib.h>

#include "sinew/c/sinew_runtime.h"

static int fail(const char* what) {
  fprintf(stderr, "%s: %s\n", what, sinew_error());
  return 1;
}

/* The whole file; null: it cannot be read. */
static void* read_file(const char* name, size_t* size) {
  FILE* file = fopen(name, "rb");
  void* bytes = NULL;
  long end = 0;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) > 0) bytes = malloc((size_t)end);
  rewind(file);
  if (bytes != NULL && fread(bytes, 1, (size_t)end, file) != (size_t)end) {
    free(bytes);
    bytes = NULL;
  }
  fclose(file);
  *size = (size_t)end;
  return bytes;
}

int main(int argc, char** argv) {
  sinew_character* character;
  sinew_smoother* smoother;
  const sinew_layout layout = {.stride = 24, .normal_offset = 12}; /* 3 floats, 3 floats. */
  sinew_pose pose = {0};
  size_t size, floats, bytes;
  float *bones, *vertices, seconds;
  void* file;
  if (argc != 2) {
    fprintf(stderr, "usage: game FILE.sinew\n");
    return 2;
  }
  file = read_file(argv[1], &size);
  if (file == NULL) return fprintf(stderr, "%s: cannot be read\n", argv[1]), 1;
  if (sinew_character_create(file, size, &character) != SINEW_OK) return fail(argv[1]);
  free(file);
  if (sinew_smoother_create(character, NULL, &smoother) != SINEW_OK) return fail("smoother");

  floats = 16 * (size_t)sinew_bone_count(character);
  bytes = layout.stride * sinew_vertex_count(smoother, SINEW_DRAWN);
  bones = malloc(floats * sizeof *bones);
  vertices = malloc(bytes);
  if (bones == NULL || vertices == NULL) return 1;
  pose.bones = bones;
  pose.bone_count = floats / 16;
  pose.has_clip = 1;
  for (seconds = 0.0f; seconds < sinew_clip_seconds(character, 0); seconds += 0.1f) {
    pose.clip_seconds = seconds;
    if (sinew_clip_sample(character, 0, seconds, bones, floats) != SINEW_OK) return fail("clip");
    if (sinew_smooth(smoother, &pose) != SINEW_OK) fprintf(stderr, "the last surface stays: %s\n", sinew_error());
    if (sinew_write_vertices(smoother, &layout, vertices, bytes) != SINEW_OK) return fail("vertices");
    printf("%.1f s: %zu vertices, the first at %.4f %.4f %.4f\n", seconds, bytes / layout.stride, vertices[0],
           vertices[1], vertices[2]);
  }
  pose.bone_count = 0; /* What a game gets wrong has a reason, and does no harm. */
  if (sinew_smooth(smoother, &pose) == SINEW_BAD_POSE) printf("refused: %s\n", sinew_error());
  free(vertices);
  free(bones);
  sinew_smoother_destroy(smoother);
  sinew_character_destroy(character);
  return 0;
}
