// shaders/compute/fold.glsl: how far a lifted triangle has turned over against its patch. As
// core/surface/finish/fold.h.
struct Fold {
  float area;    // q: its area over the patch's, signed along the patch's face.
  float weight;  // 0..1, how far q can be trusted.
  vec3 face;     // Of the patch.
  float whole;   // Its squared length.
};

const float kWholeFront = 0.05;

bool isNear(Triangle t) {
  return (marks[firstVertex() + t.a].moved | marks[firstVertex() + t.b].moved | marks[firstVertex() + t.c].moved) != 0u;
}

// @param least  q from which on it counts as level.
Fold foldOf(Triangle t, float least) {
  Fold fold = Fold(1.0, 0.0, patchFace(t), 0.0);
  fold.whole = dotOf(fold.face, fold.face);
  vec3 a = folded[firstVertex() + t.a].xyz;
  vec3 lifted = crossOf(folded[firstVertex() + t.b].xyz - a, folded[firstVertex() + t.c].xyz - a);
  float left = dotOf(lifted, fold.face);
  if (!(left < least * fold.whole)) return fold;
  vec2 front = frontOf(t);
  float ratio = front.y > 0.0 ? front.x / front.y : 0.0;
  fold.area = left / fold.whole;
  fold.weight = t.bindFront > 0.0 ? smoothstep(0.0, kWholeFront, ratio / t.bindFront) : 0.0;
  return fold;
}
