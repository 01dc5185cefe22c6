#version 450 core
// shaders/ellipsoid.frag: a translucent shell that thickens towards its rim. Premultiplied.
#include "frame.glsl"
in vec3 world;
in vec3 shapeNormal;
flat in vec4 color;
flat in vec4 look;
uniform float opacity;
layout(location = 0) out vec4 outColor;

void main() {
  vec3 n = normalize(shapeNormal);
  vec3 v = toEye(world);
  float facing = abs(dot(n, v));
  float rim = pow(1.0 - facing, 2.5);
  float light = 0.62 + 0.38 * dot(n, key.xyz) + 0.25 * max(n.y, 0.0);
  float alpha = color.a * (0.55 + 0.15 * look.y + 1.3 * rim);
  vec3 shown = color.rgb * light + vec3(0.30) * pow(max(dot(n, normalize(v + key.xyz)), 0.0), 40.0) + 0.25 * color.rgb * rim;
  // The outline: where the shell turns away, 2 pixels wide at any size.
  float outline = look.x * (1.0 - smoothstep(1.2, 2.4, facing / max(fwidth(facing), 1e-5)));
  alpha = clamp(mix(alpha, 1.0, outline), 0.0, 1.0) * opacity;
  shown = mix(shown, color.rgb * 1.6 + 0.15, max(outline, 0.25 * look.y));
  outColor = vec4(shown * alpha, alpha);
}
