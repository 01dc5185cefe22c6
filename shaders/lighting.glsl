// shaders/lighting.glsl: a quiet studio: key, fill and rim go around with the camera, so that every side is shown well.

const vec3 kSky = vec3(0.36, 0.39, 0.44);
const vec3 kFloorBounce = vec3(0.135, 0.122, 0.112);
const vec3 kKeyColor = vec3(1.30, 1.24, 1.15);
const vec3 kFillColor = vec3(0.20, 0.22, 0.25);
const vec3 kRimColor = vec3(0.34, 0.38, 0.44);

vec3 hemisphere(float up) { return mix(kFloorBounce, kSky, smoothstep(-1.0, 1.0, up)); }

// GGX highlight of one light, Schlick's Fresnel, Hammon's visibility (GDC 2017).
float highlight(vec3 n, vec3 v, vec3 l, float roughness) {
  vec3 h = normalize(v + l);
  float alpha = roughness * roughness;
  float nh = max(dot(n, h), 0.0), nv = max(dot(n, v), 0.05), nl = max(dot(n, l), 0.0);
  float d = nh * nh * (alpha * alpha - 1.0) + 1.0;
  return nl * alpha * alpha / (3.14159 * d * d) * 0.5 / mix(2.0 * nl * nv, nl + nv, alpha);
}

// From above, left of the camera whichever way it looks.
vec3 studioKey() {
  vec3 side = vec3(viewFromWorld[0][0], 0.0, viewFromWorld[2][0]);
  vec3 towards = vec3(-side.z, 0.0, side.x);  // Towards the eye, level.
  return normalize(-0.62 * side + 0.66 * towards + vec3(0.0, 0.92, 0.0));
}

// Physically inclined shading of a metallic-roughness material.
vec3 studio(vec3 albedo, float metallic, float roughness, vec3 n, vec3 v, vec3 right, vec3 up) {
  vec3 l = studioKey();
  vec3 fill = normalize(0.75 * right + 0.15 * up + 0.65 * v);
  vec3 back = normalize(0.55 * right + 0.55 * up - 0.75 * v);
  float lit = max((dot(n, l) + 0.22) / 1.22, 0.0);
  vec3 diffuse = kKeyColor * lit * (0.35 + 0.65 * lit) + hemisphere(n.y) + kFillColor * max(dot(n, fill), 0.0);
  float grazing = 1.0 - max(dot(n, v), 0.0);
  float grazing2 = grazing * grazing;
  vec3 f0 = mix(vec3(0.04), albedo, metallic);
  vec3 fresnel = f0 + (max(vec3(1.0 - roughness), f0) - f0) * grazing2 * grazing2 * grazing;
  vec3 mirrored = hemisphere(clamp(reflect(-v, n).y * (1.6 - roughness), -1.0, 1.0));
  vec3 specular = fresnel * (mirrored * (1.0 - 0.6 * roughness) + 2.6 * kKeyColor * highlight(n, v, l, max(roughness, 0.25)));
  vec3 rim = kRimColor * grazing2 * grazing * max(dot(n, back) + 0.35, 0.0);
  return albedo * (1.0 - metallic) * (diffuse + rim) * 0.86 + specular + rim * 0.06;
}

// Light on a sculptor's clay, by where the normal points as seen: x right, y up, z to the eye. 1 = clay as it is.
vec3 clayLight(vec3 m) {
  const vec3 keyDirection = vec3(-0.46, 0.62, 0.635);
  float d = dot(m, keyDirection);
  float lit = smoothstep(-0.30, 1.05, d);
  vec3 light = mix(vec3(0.135, 0.130, 0.135), vec3(0.34, 0.35, 0.365), smoothstep(-0.9, 0.9, m.y));
  light += vec3(1.18, 1.10, 1.00) * lit * lit;
  light += vec3(0.085, 0.038, 0.018) * smoothstep(-0.35, 0.05, d) * (1.0 - smoothstep(0.05, 0.55, d));  // Warm terminator.
  light += vec3(0.12, 0.14, 0.18) * max(dot(m, vec3(0.80, -0.20, 0.56)), 0.0);
  float edge = 1.0 - clamp(m.z, 0.0, 1.0);
  light *= 1.0 - 0.38 * edge * edge;                                                        // Forms turn away darker,
  light += vec3(0.42, 0.47, 0.55) * edge * edge * edge * smoothstep(-0.1, 0.8, 0.7 * m.x + 0.55 * m.y);  // then rimmed.
  return light;
}

vec3 clayGloss(vec3 m) {
  vec3 h = normalize(vec3(-0.46, 0.62, 0.635) + vec3(0.0, 0.0, 1.0));
  float s = max(dot(m, h), 0.0);
  return vec3(0.085) * pow(s, 22.0) + vec3(0.045) * pow(s, 90.0);
}
