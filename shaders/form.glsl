// shaders/form.glsl: what a primitive's shape makes of the unit ball, as core's shape.h has it.

#define FORM_VECTORS 1  // Of four numbers each, in the order of core/geometry/affine_image.cpp.

struct Form {
  float core;
  float belly;
  vec2 bend;  // x and z.
};

Form formOf(vec4 numbers[FORM_VECTORS]) { return Form(numbers[0].x, numbers[0].y, numbers[0].zw); }

float formNu(Form form) {
  float e = 1.0 - form.core;
  float s = 1.0 + form.belly * form.belly - 2.0 * abs(form.belly) * form.core;
  return 2.0 / (s + sqrt(max(s * s - 4.0 * form.belly * form.belly * e * e, 0.0)));
}

// The point of the surface rho = scale that belongs to a point of the unit sphere.
vec3 onForm(Form form, float scale, vec3 p) {
  float e = 1.0 - form.core;
  float height = min(abs(p.y), 1.0);
  float straight = 0.6 * form.core / (form.core + e * scale);
  float beyond = max(height - straight, 0.0) / (1.0 - straight);
  float along = height < straight ? form.core * height / straight : form.core + e * scale * beyond;
  float y = p.y < 0.0 ? -along : along;
  float s = 1.0 + form.belly * form.belly - 2.0 * form.belly * y;
  float lateral = scale * sqrt(max(1.0 - beyond * beyond, 0.0) / (formNu(form) * s));
  vec2 across = p.xz * lateral / max(length(p.xz), 1e-6) + form.bend * (1.0 - y * y);
  return vec3(across.x, y, across.y);
}

// rho^2.
float formSquared(Form form, vec3 p) {
  float end = max(abs(p.y) - form.core, 0.0) / (1.0 - form.core);
  vec2 across = p.xz - form.bend * (1.0 - p.y * p.y);
  float s = max(1.0 + form.belly * form.belly - 2.0 * form.belly * p.y, 0.0);
  return formNu(form) * s * dot(across, across) + end * end;
}

// d(rho^2)/dp: the normal.
vec3 formSlope(Form form, vec3 p) {
  float e = 1.0 - form.core;
  float end = max(abs(p.y) - form.core, 0.0) / e;
  vec2 across = p.xz - form.bend * (1.0 - p.y * p.y);
  float nu = formNu(form);
  float s = nu * (1.0 + form.belly * form.belly - 2.0 * form.belly * p.y);
  float along = -2.0 * nu * form.belly * dot(across, across) + 4.0 * s * p.y * dot(form.bend, across) +
                2.0 * end / e * (p.y < 0.0 ? -1.0 : 1.0);
  return vec3(2.0 * s * across.x, along, 2.0 * s * across.y);
}
