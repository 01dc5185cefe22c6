// shaders/frame.glsl: what every drawer of one picture shares. The same as FrameBlock in app/viewport/render/frame.h.
layout(std140, binding = 0) uniform Frame {
  mat4 clipFromWorld;
  mat4 viewFromWorld;
  vec4 eye;      // World; w = 1 where orthographic.
  vec4 forward;  // World, unit.
  vec4 picture;  // Width and height in pixels, height of the character, height of the floor.
  vec4 key;      // World, unit, towards the light that casts the shadow.
  vec4 occluded;  // x: 1 where the picture has an occlusion texture. y: 1 where it is one of a mean.
};

vec3 toEye(vec3 world) { return eye.w > 0.5 ? -forward.xyz : normalize(eye.xyz - world); }
