#version 450 core
// shaders/shadow.frag: x: shadow, weaker the higher it is cast from; y: contact, only of what nearly touches the floor.
#include "frame.glsl"
in float above;
layout(location = 0) out vec2 shade;

void main() {
  float h = above / picture.z;
  shade = vec2(exp(-0.9 * h), exp(-22.0 * h));
}
