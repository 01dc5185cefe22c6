// shaders/compute/mesh.glsl: the refined mesh as the stages after projection read it, and which part of it has
// moved.
struct Ring {
  int begin, end;                // Of its neighbors.
  int cornersBegin, cornersEnd;  // Of its triangles' corners.
  int acrossBegin, acrossEnd;    // Of the vertices across, after all neighbors.
  float share;                   // Of one neighbor in the mean.
  int isBorder;
};
struct Triangle {
  int a, b, c;
  float bindFront;
};
struct Vertex {
  vec4 position;  // World; w: the height.
  vec4 normal;
};
struct Mark {
  uint moved;     // kNear where a neighbor has moved, kMoved where the vertex itself has.
  float filtered;  // Weight of the filter of heights.
};
const uint kNear = 1u, kMoved = 3u;

int firstVertex() { return body() * refinedVertices; }

// As on the processor.
#define dot(a, b) dotOf(a, b)
#define cross(a, b) crossOf(a, b)
