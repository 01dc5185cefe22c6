// shaders/compute/lift.glsl: sums over a vertex's edges in the patch: of height differences per length, and of 1 /
// length. As core/surface/finish/lift_kernel.cpp.
#define LIFT_SUMS(HEIGHT_OF)                                               \
  vec2 liftSums(int v, float own) {                                        \
    vec3 p = patches[firstVertex() + v].position.xyz;                      \
    vec2 sums = vec2(0.0);                                                 \
    for (int i = rings[v].begin; i < rings[v].end; ++i) {                  \
      int other = firstVertex() + neighbors[i];                            \
      vec3 edge = patches[other].position.xyz - p;                         \
      float squared = dotOf(edge, edge);                                   \
      float perLength = squared > 0.0 ? 1.0 / sqrt(squared) : 0.0;         \
      sums += perLength * vec2(HEIGHT_OF(other) - own, 1.0);               \
    }                                                                      \
    return sums;                                                           \
  }
