// shaders/form.glsl: what a primitive's shape makes of the unit ball, as core's shape.h has it. form: core, belly, bend.

float formNu(vec4 form) {
  float e = 1.0 - form.x;
  float s = 1.0 + form.y * form.y - 2.0 * abs(form.y) * form.x;
  return 2.0 / (s + sqrt(max(s * s - 4.0 * form.y * form.y * e * e, 0.0)));
}

// The point of the surface rho = scale that belongs to a point of the unit sphere.
vec3 onForm(vec4 form, float scale, vec3 p) {
  float e = 1.0 - form.x;
  float height = min(abs(p.y), 1.0);
  float straight = 0.6 * form.x / (form.x + e * scale);
  float beyond = max(height - straight, 0.0) / (1.0 - straight);
  float along = height < straight ? form.x * height / straight : form.x + e * scale * beyond;
  float y = p.y < 0.0 ? -along : along;
  float s = 1.0 + form.y * form.y - 2.0 * form.y * y;
  float lateral = scale * sqrt(max(1.0 - beyond * beyond, 0.0) / (formNu(form) * s));
  vec2 across = p.xz * lateral / max(length(p.xz), 1e-6) + form.zw * (1.0 - y * y);
  return vec3(across.x, y, across.y);
}

// rho^2.
float formSquared(vec4 form, vec3 p) {
  float end = max(abs(p.y) - form.x, 0.0) / (1.0 - form.x);
  vec2 across = p.xz - form.zw * (1.0 - p.y * p.y);
  float s = max(1.0 + form.y * form.y - 2.0 * form.y * p.y, 0.0);
  return formNu(form) * s * dot(across, across) + end * end;
}

// d(rho^2)/dp: the normal.
vec3 formSlope(vec4 form, vec3 p) {
  float e = 1.0 - form.x;
  float end = max(abs(p.y) - form.x, 0.0) / e;
  vec2 across = p.xz - form.zw * (1.0 - p.y * p.y);
  float nu = formNu(form);
  float s = nu * (1.0 + form.y * form.y - 2.0 * form.y * p.y);
  float along = -2.0 * nu * form.y * dot(across, across) + 4.0 * s * p.y * dot(form.zw, across) +
                2.0 * end / e * (p.y < 0.0 ? -1.0 : 1.0);
  return vec3(2.0 * s * across.x, along, 2.0 * s * across.y);
}
