#version 450 core
// shaders/tendon.vert: a tendon as a tube along a cubic curve: its first section is the belly's, then it tapers to a
// cord that closes at the anchor. 24 rings of 14 corners.
#include "frame.glsl"
layout(location = 0) in vec4 curve0;  // World; w: where it begins and ends, of the whole tendon's length.
layout(location = 1) in vec4 curve1;
layout(location = 2) in vec4 curve2;  // w: the tendon's length in half lengths of the belly.
layout(location = 3) in vec4 curve3;  // w: radius of the cord, world.
layout(location = 4) in vec4 halfX;   // World: half axes of the belly across. w: radius of the first section, of these.
layout(location = 5) in vec4 halfZ;   // w: where along the belly that lies; below 0 at its other end.
layout(location = 6) in vec4 tint;    // As muscle.glsl has it.
layout(location = 7) in vec4 style;   // Glow 0..1.
uniform float pixel;  // World size of a pixel, at a distance of 1 where there is perspective.
#include "muscle.glsl"

const int kRings = 24, kCorners = 14;
const float kFunnel = 0.20;  // The belly's section fades within this, in half lengths of the belly.

struct Ring {
  vec3 center;
  vec3 x;
  vec3 z;
};

Ring ringAt(float t) {
  float s = 1.0 - t;
  Ring ring;
  ring.center = s * s * s * curve0.xyz + 3.0 * s * s * t * curve1.xyz + 3.0 * s * t * t * curve2.xyz +
                t * t * t * curve3.xyz;
  vec3 along = normalize(s * s * (curve1.xyz - curve0.xyz) + 2.0 * s * t * (curve2.xyz - curve1.xyz) +
                         t * t * (curve3.xyz - curve2.xyz));
  vec3 x = normalize(halfX.xyz - along * dot(along, halfX.xyz));
  vec3 z = cross(x, along);
  if (dot(z, halfZ.xyz) < 0.0) z = -z;
  float share = mix(curve0.w, curve1.w, t);
  float belly = exp(-share * curve2.w / kFunnel);
  float closing = clamp((1.0 - share) * curve2.w * 0.5 * (length(halfX.xyz) + length(halfZ.xyz)) / curve3.w, 0.0, 1.0);
  float closed = sqrt(1.0 - (1.0 - closing) * (1.0 - closing));
  float cord = curve3.w * mix(1.0, 0.72, smoothstep(0.0, 1.0, share));
  cord = max(cord, 0.75 * pixel * (clipFromWorld * vec4(ring.center, 1.0)).w);  // Seen from far as well.
  ring.x = x * mix(cord, halfX.w * length(halfX.xyz), belly) * closed;
  ring.z = z * mix(cord, halfX.w * length(halfZ.xyz), belly) * closed;
  return ring;
}

void main() {
  float t = float(gl_VertexID / kCorners) / float(kRings);
  float turn = 6.2831853 * float(gl_VertexID % kCorners) / float(kCorners);
  vec2 at = vec2(sin(turn), cos(turn));
  Ring here = ringAt(t);
  float step_ = t < 0.5 ? 0.01 : -0.01;
  Ring beside = ringAt(t + step_);
  vec3 outwards = here.x * at.x + here.z * at.y;
  vec3 along = (beside.center + beside.x * at.x + beside.z * at.y - here.center - outwards) / step_;
  world = here.center + outwards;
  around = here.x * at.y - here.z * at.x;
  vec3 normal = cross(along, around);
  shapeNormal = dot(normal, outwards) < 0.0 ? -normal : normal;
  float share = mix(curve0.w, curve1.w, t);
  inMuscle = vec3(at.x, halfZ.w + sign(halfZ.w) * share * curve2.w, at.y);
  fibres = tint;
  glow = style.x;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
