#version 450 core
// shaders/ground.frag: grid, axes and a pool of light. Premultiplied.
#include "frame.glsl"
in vec3 world;
uniform vec4 ground;
uniform float lineScale;
#ifdef CHOSEN_LOOK
uniform vec3 grid;  // Factors: on the pool of light, on the colors of the lines, on their opacity.
#define POOL(value) ((value) * grid.x)
#define TONE(value) ((value) * grid.y)
#define LINES(value) ((value) * grid.z)
#else
#define POOL(value) (value)
#define TONE(value) (value)
#define LINES(value) (value)
#endif
uniform vec2 zoom;  // Factor on the floor's extent; 0..1: how far the grid is on its way to cells five times as large.
layout(location = 0) out vec4 outColor;

// How much of a pixel a line at every integer covers; fades out before lines run together.
float lines(vec2 cells, vec2 width) {
  vec2 away = abs(fract(cells - 0.5) - 0.5) / width;
  vec2 line = clamp(1.0 - away, 0.0, 1.0) * clamp(1.25 - 3.0 * width, 0.0, 1.0);
  return max(line.x, line.y);
}

void paint(inout vec4 below, vec3 color, float alpha) { below = vec4(color * alpha, alpha) + below * (1.0 - alpha); }

void main() {
  vec2 from = (world.xz - ground.xy) / (picture.z * zoom.x);
  float away2 = dot(from, from);
  float near = clamp(1.0 - away2 / 11.5, 0.0, 1.0);
  float sight = toEye(world).y;
  float fade = near * near * clamp(10.0 * abs(sight), 0.0, 1.0);
  vec2 cells = world.xz / ground.w;
  vec2 width = max(fwidth(cells), vec2(1e-6)) * lineScale;
  vec2 axes = clamp(1.2 - abs(cells) / width, 0.0, 1.0) * 0.85 * fade;
  float pool = fade * fade;
  vec4 color = vec4(vec3(0.23, 0.235, 0.245), 1.0) * POOL(0.40 * pool * pool);
  // Three ranks of lines; while the eye draws back each takes the place of the one below.
  paint(color, TONE(vec3(0.36, 0.37, 0.39)), LINES(0.085 * (1.0 - zoom.y) * lines(cells * 5.0, width * 5.0) * fade));
  paint(color, TONE(vec3(0.40, 0.41, 0.43)), LINES(mix(0.27, 0.085, zoom.y) * lines(cells, width) * fade));
  paint(color, TONE(vec3(0.40, 0.41, 0.43)), LINES(0.20 * zoom.y * lines(cells * 0.2, width * 0.2) * fade));
  paint(color, vec3(0.52, 0.055, 0.050), axes.y);
  paint(color, vec3(0.045, 0.150, 0.58), axes.x);
  outColor = color * (sight < 0.0 ? 0.35 : 1.0);
}
