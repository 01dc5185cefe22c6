#version 450 core
// shaders/copy.frag: a picture of the same size, times a factor.
uniform sampler2D source;
uniform float factor;
layout(location = 0) out vec4 outColor;

void main() { outColor = texelFetch(source, ivec2(gl_FragCoord.xy), 0) * factor; }
