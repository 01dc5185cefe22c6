// shaders/brdf.glsl: glTF 2.0, appendix B: GGX, Smith's visibility and Schlick's Fresnel. The visibility is the
// height-correlated one (Heitz, "Understanding the masking-shadowing function", JCGT 2014), as other viewers have it.

struct Reflection {
  float entering;  // The share of the light that is not mirrored where it meets the dielectric part: it is scattered.
  vec3 specular;  // For one light, times pi: what a white, dull surface sends back of it is 1.
};

Reflection reflection(vec3 f0, vec3 n, vec3 v, vec3 l, float roughness) {
  vec3 h = normalize(v + l);
  float nh = max(dot(n, h), 0.0), nv = max(dot(n, v), 0.0), nl = max(dot(n, l), 0.0);
  float alpha = roughness * roughness;
  float alpha2 = alpha * alpha;
  float grazing = 1.0 - clamp(dot(v, h), 0.0, 1.0);
  float grazing2 = grazing * grazing;
  float least = grazing2 * grazing2 * grazing;
  vec3 fresnel = f0 + (1.0 - f0) * least;
  float d = nh * nh * (alpha2 - 1.0) + 1.0;
  float hidden = nl * sqrt(nv * nv * (1.0 - alpha2) + alpha2) + nv * sqrt(nl * nl * (1.0 - alpha2) + alpha2);
  return Reflection(0.96 - 0.96 * least, fresnel * (alpha2 / (d * d) * 0.5 / max(hidden, 1e-6)));
}
