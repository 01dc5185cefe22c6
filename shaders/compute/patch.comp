#version 450 core
// shaders/compute/patch.comp: refined vertices on their patches, and the line along which each is projected.
#include "compute/items.glsl"
#include "compute/numbers.glsl"
#define dot(a, b) dotOf(a, b)
#include "core/geometry/formulas/patch.h"

struct Control {
  vec4 position;
  vec4 normal;
  vec4 rise;
};
struct Refined {
  ivec4 place;   // Carrier, then the control vertices at its corners.
  vec4 weights;  // Barycentric, then 1/L of the rise.
};
struct Vertex {
  vec4 position;  // World; w: the height.
  vec4 normal;
};
struct Line {
  vec4 from;   // World.
  vec4 along;  // Unit.
};
layout(std430, binding = 0) readonly buffer Controls { Control controls[]; };
layout(std430, binding = 1) readonly buffer RefinedVertices { Refined refined[]; };
layout(std430, binding = 2) writeonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) writeonly buffer Lines { Line lines[]; };
layout(std430, binding = 4) writeonly buffer Surface { Vertex surface[]; };
#ifdef REPLACE
struct Anchor {
  vec3 inBone;
  int bone;
};
layout(std430, binding = 5) readonly buffer BoundAnchors { Anchor bound[]; };
layout(std430, binding = 6) readonly buffer Bones { mat4 bones[]; };  // [bodies * bones]
layout(std430, binding = 7) writeonly buffer Anchors { vec4 anchors[]; };
#endif

vec3 P[3];  // Corners.
vec3 N[3];
vec3 R[3];  // Rise directions there.

const int kPn = 0, kPhong = 1, kSpherigon = 2, kFlat = 3;

vec3 weightedOf(vec3 a[3], vec3 w, int corners) {
  return corners == 2 ? weighted(a[0], a[1], w.x, w.y) : weighted(a[0], a[1], a[2], w.x, w.y, w.z);
}
vec3 directionOf(vec3 a[3], vec3 w, int corners) {
  return corners == 2 ? direction(a[0], a[1], w.x, w.y) : direction(a[0], a[1], a[2], w.x, w.y, w.z);
}

vec3 phongPointOf(vec3 w, int corners) {
  vec3 flatPoint = weightedOf(P, w, corners);
  vec3 onPlanes[3];
  for (int i = 0; i < 3; ++i) onPlanes[i] = onPlane(flatPoint, P[i], N[i]);
  return phongPoint(flatPoint, weightedOf(onPlanes, w, corners));
}

vec3 spherigonPoint(vec3 w, vec3 normal, int corners) {
  vec3 flatPoint = weightedOf(P, w, corners);
  precise float height = 0.0;
  precise float sum = 0.0;
  for (int i = 0; i < corners; ++i) {
    float squared = w[i] * w[i];
    height = height + sphereHeight(squared, flatPoint, normal, P[i], N[i]);
    sum = sum + squared;
  }
  precise vec3 point = flatPoint + normal * (height / sum);
  return point;
}

void patchPoint(vec3 w, int corners, out vec3 position, out vec3 normal) {
  if (patchKind == kPn && corners == 2) {
    PnEdge edge = pnEdge(P[0], P[1], N[0], N[1]);
    position = pnPosition(edge, P[0], P[1], w.x, w.y);
    normal = pnNormal(edge, N[0], N[1], w.x, w.y);
    return;
  }
  if (patchKind == kPn) {
    PnTriangle triangle = pnTriangle(P[0], P[1], P[2], N[0], N[1], N[2]);
    position = pnPosition(triangle, P[0], P[1], P[2], w.x, w.y, w.z);
    normal = pnNormal(triangle, N[0], N[1], N[2], w.x, w.y, w.z);
    return;
  }
  normal = directionOf(N, w, corners);
  if (patchKind == kPhong) position = phongPointOf(w, corners);
  else if (patchKind == kSpherigon) position = spherigonPoint(w, normal, corners);
  else position = weightedOf(P, w, corners);
}

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  ivec4 place = refined[v].place;
  vec3 w = refined[v].weights.xyz;
  for (int i = 0; i < 3; ++i) {
    Control control = controls[body() * controlVertices + place[i + 1]];
    P[i] = control.position.xyz;
    N[i] = control.normal.xyz;
    R[i] = control.rise.xyz;
  }
  vec3 position = P[0], normal = N[0];
  Line line = Line(vec4(P[0], 0.0), vec4(R[0], 0.0));
#ifdef REPLACE
  line.along.xyz = N[0];
#endif
  if (place.x >= controlVertices) {
    int corners = place.x < controlVertices + controlEdges ? 2 : 3;
    patchPoint(w, corners, position, normal);
#ifdef REPLACE
    line = Line(vec4(weightedOf(P, w, corners), 0.0), vec4(directionOf(N, w, corners), 0.0));
#else
    line = Line(vec4(position, 0.0), vec4(directionOf(R, w, corners), 0.0));
#endif
  }
  int at = body() * refinedVertices + v;
  patches[at] = surface[at] = Vertex(vec4(position, 0.0), vec4(normal, 0.0));
  lines[at] = line;
#ifdef REPLACE
  anchors[at] = bones[body() * boneCount + bound[v].bone] * vec4(bound[v].inBone, 1.0);
#endif
}
