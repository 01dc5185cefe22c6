// tests/viewport/render/brdf_oracle.h: glTF 2.0, appendix B, implemented from the specification for one directional
// light.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sinew::test {

struct OracleMaterial {
  glm::dvec3 baseColor{1.0};
  double metallic = 0.0;
  double roughness = 1.0;
};

/// Radiance towards v under a light that makes a white Lambert surface facing it exactly white. All vectors are unit.
inline glm::dvec3 appendixB(const OracleMaterial& material, const glm::dvec3& n, const glm::dvec3& v,
                            const glm::dvec3& l) {
  const double nl = glm::dot(n, l), nv = glm::dot(n, v);
  if (!(nl > 0.0 && nv > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3 h = glm::normalize(l + v);
  const double nh = glm::dot(n, h), vh = glm::dot(v, h);
  const double alpha = material.roughness * material.roughness, alpha2 = alpha * alpha;
  const double distribution = alpha2 / (std::numbers::pi * std::pow(nh * nh * (alpha2 - 1.0) + 1.0, 2.0));
  // Smith's Lambda of GGX (Heitz 2014, equation 72), height-correlated (equation 99).
  const auto lambda = [&](double cosine) {
    const double tangent2 = (1.0 - cosine * cosine) / (cosine * cosine);
    return 0.5 * (std::sqrt(1.0 + alpha2 * tangent2) - 1.0);
  };
  const double unmasked = 1.0 / (1.0 + lambda(nl) + lambda(nv));
  const double specular = distribution * unmasked / (4.0 * nl * nv);
  const auto fresnel = [&](const glm::dvec3& f0) { return f0 + (1.0 - f0) * std::pow(1.0 - vh, 5.0); };
  const glm::dvec3 ofDielectric = fresnel(glm::dvec3(0.04));
  const glm::dvec3 dielectric = (1.0 - ofDielectric) * material.baseColor / std::numbers::pi + ofDielectric * specular;
  const glm::dvec3 metal = fresnel(material.baseColor) * specular;
  const glm::dvec3 brdf = dielectric + material.metallic * (metal - dielectric);
  return std::numbers::pi * nl * brdf;
}

/// 0..255
inline double srgbOf(double linear) {
  const double l = std::clamp(linear, 0.0, 1.0);
  return 255.0 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055);
}

}  // namespace sinew::test
