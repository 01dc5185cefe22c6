#version 450 core
// shaders/compute/patch.comp: refined vertices on their patches, and the line along which each is projected.
#include "compute/items.glsl"
#include "compute/patch.glsl"

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
    line = Line(vec4(weighted(P, w, corners), 0.0), vec4(direction(N, w, corners), 0.0));
#else
    line = Line(vec4(position, 0.0), vec4(direction(R, w, corners), 0.0));
#endif
  }
  int at = body() * refinedVertices + v;
  patches[at] = surface[at] = Vertex(vec4(position, 0.0), vec4(normal, 0.0));
  lines[at] = line;
#ifdef REPLACE
  anchors[at] = bones[body() * boneCount + bound[v].bone] * vec4(bound[v].inBone, 1.0);
#endif
}
