#version 450 core
// shaders/fullscreen.vert: one triangle over the whole picture.
out vec2 at;  // 0..1, y up.

void main() {
  at = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(at * 2.0 - 1.0, 0.0, 1.0);
}
