#version 450 core
// shaders/ground.vert: a wide square on the floor around the character.
#include "frame.glsl"
uniform vec4 ground;  // Center x and z, half extent, grid cell.
out vec3 world;

void main() {
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  world = vec3(ground.x + corner.x * ground.z, picture.w, ground.y + corner.y * ground.z);
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
