// shaders/compute/fold_move.glsl: a vertex stays as near to where muscles have put it as they have moved it. As
// core/smoothing/finish/fold_moves.h.
vec3 keptNear(vec3 to, vec3 from, vec3 patchPlace) {
  vec3 way = to - from;
  float most = distance(from, patchPlace), far = length(way);
  return from + (far > most ? most / far : 1.0) * way;
}
