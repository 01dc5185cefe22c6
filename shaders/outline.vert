#version 450 core
// shaders/outline.vert: the outline of every primitive as seen, 96 segments. Seen from a point, a ball's outline is a
// circle; the ellipsoid's own map carries it to the ellipsoid, exactly. A shape's is given, and that of a sheet's belly,
// of which only parts are drawn.
#include "frame.glsl"
layout(location = 2) in vec4 placeX;
layout(location = 3) in vec4 placeY;
layout(location = 4) in vec4 placeZ;
layout(location = 5) in vec4 placeAt;
layout(location = 6) in vec4 tint;   // Linear color and opacity.
layout(location = 7) in vec4 style;  // Width in pixels; dashes around, 0: unbroken; number of the given outline, or 0.
layout(std430, binding = 1) readonly buffer Outlines { vec4 outlines[]; };  // World, 96 points each; w: 0 where it is not drawn.
uniform float extra;                 // More width, pixels.
uniform vec4 halo;                   // Replaces the color where its w > 0.
out float acrossPixels;
flat out float halfWidth;
flat out vec4 color;
out float dash;

void main() {
  const int segments = 96;
  int segment = gl_VertexID / 6, corner = gl_VertexID % 6;
  mat3 linear = mat3(placeX.xyz, placeY.xyz, placeZ.xyz);
  vec3 yz = cross(linear[1], linear[2]);
  float det = dot(linear[0], yz);
  mat3 toBall = transpose(mat3(yz, cross(linear[2], linear[0]), cross(linear[0], linear[1]))) / det;
  // Where the sight leaves the ball it touches it: x . eye = 1, or x . direction = 0 without perspective.
  vec3 seen = eye.w > 0.5 ? toBall * forward.xyz : toBall * (eye.xyz - placeAt.xyz);
  float reach = dot(seen, seen);
  float inverse_ = eye.w > 0.5 ? 0.0 : 1.0 / reach;
  color = halo.w > 0.0 ? vec4(halo.rgb, halo.a * tint.a) : tint;
  dash = 0.0;
  if (det == 0.0 || (inverse_ >= 1.0 && style.z < 0.5)) {  // Flat, or seen from inside.
    acrossPixels = halfWidth = 0.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  // The end of this segment, and what lies before and after it: strips that meet share their normal.
  int place = segment + (corner == 0 || corner == 1 || corner == 3 ? 0 : 1);
  dash = float(place) / float(segments) * style.y;
  vec4 before, here, after;
  if (style.z > 0.5) {
    int first = (int(style.z + 0.5) - 1) * segments;
    if (min(outlines[first + segment].w, outlines[first + (segment + 1) % segments].w) < 0.5) {
      acrossPixels = halfWidth = 0.0;
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    before = clipFromWorld * vec4(outlines[first + (place + segments - 1) % segments].xyz, 1.0);
    here = clipFromWorld * vec4(outlines[first + place % segments].xyz, 1.0);
    after = clipFromWorld * vec4(outlines[first + (place + 1) % segments].xyz, 1.0);
  } else {
    vec3 axis = seen * inversesqrt(reach);
    vec3 u = normalize(cross(axis, abs(axis.x) < 0.6 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 w = cross(axis, u);
    mat4 clipFromCircle = clipFromWorld * mat4(vec4(linear * (sqrt(1.0 - inverse_) * u), 0.0),
                                               vec4(linear * (sqrt(1.0 - inverse_) * w), 0.0), vec4(0.0),
                                               vec4(linear * (seen * inverse_) + placeAt.xyz, 1.0));
    const float turn = 6.2831853 / float(segments);
    float at = float(place) * turn;
    before = clipFromCircle * vec4(cos(at - turn), sin(at - turn), 0.0, 1.0);
    here = clipFromCircle * vec4(cos(at), sin(at), 0.0, 1.0);
    after = clipFromCircle * vec4(cos(at + turn), sin(at + turn), 0.0, 1.0);
  }
  halfWidth = 0.5 * (style.x + extra);
  acrossPixels = (corner % 2 == 0 ? -1.0 : 1.0) * (halfWidth + 1.0);
  if (min(before.w, min(here.w, after.w)) < 1e-4) {  // Beside the eye: nothing that a picture shows.
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 along = (after.xy / after.w - before.xy / before.w) * picture.xy;
  along = dot(along, along) > 1e-12 ? normalize(along) : vec2(1.0, 0.0);
  here.xy += vec2(-along.y, along.x) * acrossPixels * 2.0 / picture.xy * here.w;
  gl_Position = here;
}
