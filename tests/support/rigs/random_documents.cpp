// tests/support/rigs/random_documents.cpp: rigs as files may hold them.
#include "tests/support/rigs/random_documents.h"

#include <array>
#include <bit>
#include <cmath>

#include "core/files/json/json.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

float anyFloat(Random& random) {
  for (;;) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random.next()));
    if (std::isfinite(value)) return value;
  }
}

float positiveFloat(Random& random) {
  for (;;) {
    const float value = std::abs(anyFloat(random));
    if (value > 0.0f) return value;
  }
}

/// Denormals and extreme values are rare among random bits; make them frequent.
float edgeFloat(Random& random) {
  constexpr std::array<float, 8> kEdges{0.0f, -0.0f, 1e-45f, 1.17549435e-38f, 3.4028235e+38f, 16777216.0f, 0.1f, -1.0f};
  return random.chance(0.3f) ? kEdges[static_cast<std::size_t>(random.below(8))] : anyFloat(random);
}

std::string anyName(Random& random, int number) {
  constexpr std::array<const char*, 12> kPieces{"thigh", " ", "é",  "大腿", "\U0001F4AA", "\"",
                                                "\\",    "/", "\n", "\t",   "\x01",       " L"};
  std::string name = std::to_string(number);
  for (int i = random.below(6); i > 0; --i) name += kPieces[static_cast<std::size_t>(random.below(12))];
  return name;
}

Json anyJson(Random& random, int depth) {
  switch (random.below(depth > 0 ? 7 : 5)) {
    case 0:
      return Json();
    case 1:
      return Json(random.chance(0.5f));
    case 2:
      return Json(random.below(1000000) - 500000);
    case 3:
      return Json(static_cast<double>(anyFloat(random)) / 3.0);
    case 4:
      return Json(anyName(random, 0));
    case 5: {
      Json list = Json::array();
      for (int i = random.below(4); i > 0; --i) list.push(anyJson(random, depth - 1));
      return list;
    }
    default:
      break;
  }
  Json object = Json::object();
  for (int i = random.below(4); i > 0; --i) object.set(anyName(random, i), anyJson(random, depth - 1));
  return object;
}

std::string anyUnknownKeys(Random& random) {
  if (random.chance(0.6f)) return {};
  Json object = Json::object();
  object.set("x-note", anyJson(random, 4));
  if (random.chance(0.5f)) object.set(anyName(random, 1), anyJson(random, 2));
  return object.dump();
}

Primitive anyPrimitive(Random& random, const Rig& rig) {
  Primitive primitive;
  primitive.name = anyName(random, static_cast<int>(rig.primitives.size()));
  primitive.bone = anyName(random, random.below(9));
  primitive.group = rig.groups[static_cast<std::size_t>(random.below(static_cast<int>(rig.groups.size())))].name;
  primitive.placement.center = {edgeFloat(random), edgeFloat(random), edgeFloat(random)};
  primitive.placement.rotation = random.rotation();
  primitive.placement.radii = {positiveFloat(random), positiveFloat(random), random.uniform(0.1f, 9.0f)};
  primitive.reach =
      std::nextafter(1.0f, 2.0f) + std::abs(random.chance(0.5f) ? random.uniform(0.0f, 3.0f) : anyFloat(random));
  if (!std::isfinite(primitive.reach)) primitive.reach = 2.0f;
  if (random.chance(0.3f)) primitive.placement.shape = randomShape(random, primitive.reach);
  primitive.sign = random.chance(0.8f) ? 1 : -1;
  if (random.chance(0.3f)) primitive.amount = random.uniform(0.0f, kMostAmount);
  if (random.chance(0.3f)) {
    primitive.territory.emplace();
    for (int i = random.below(4); i > 0; --i) primitive.territory->push_back(anyName(random, i));
  }
  primitive.unknownKeys = anyUnknownKeys(random);
  return primitive;
}

LineAnchor anyAnchor(Random& random) {
  return {anyName(random, random.below(9)),
          {edgeFloat(random), edgeFloat(random), edgeFloat(random)},
          anyUnknownKeys(random)};
}

/// Files omit settings at their defaults, so keep some defaults.
LineSettings anySettings(Random& random) {
  LineSettings settings;
  if (random.chance(0.5f)) settings.rest = random.uniform(kLeastRest, kMostRest);
  if (random.chance(0.5f)) settings.tendons = {random.uniform(0.0f, 0.4f), random.uniform(0.0f, 0.4f)};
  if (random.chance(0.5f)) settings.volume = random.uniform(0.0f, kMostVolume);
  if (random.chance(0.5f)) settings.limits = {random.uniform(0.01f, 0.99f), random.uniform(1.01f, 9.0f)};
  if (random.chance(0.5f)) settings.pivot = random.uniform(0.0f, 1.0f);
  if (random.chance(0.5f)) settings.twist = random.uniform(0.0f, 1.0f);
  if (random.chance(0.5f)) settings.flex = {random.uniform(kLeastFlex, kMostFlex), random.uniform(-0.5f, 0.5f)};
  if (random.chance(0.5f)) settings.base = random.uniform(0.0f, 1.0f);
  if (random.chance(0.5f)) settings.gain = random.uniform(0.0f, kMostGain);
  if (random.chance(0.5f)) settings.full = random.uniform(kLeastFull, kMostFull);
  return settings;
}

void addLines(Random& random, Rig& rig) {
  for (int i = random.below(4); i > 0; --i) {
    MuscleLine line;
    line.name = anyName(random, static_cast<int>(rig.lines.size()));
    line.origin = anyAnchor(random);
    line.insertion = anyAnchor(random);
    if (random.chance(0.5f)) line.via = anyAnchor(random);
    line.settings = anySettings(random);
    line.unknownActivationKeys = anyUnknownKeys(random);
    line.unknownKeys = anyUnknownKeys(random);
    rig.lines.push_back(line);
  }
  for (Primitive& primitive : rig.primitives) {
    if (rig.lines.empty() || random.chance(0.5f)) continue;
    primitive.line = rig.lines[static_cast<std::size_t>(random.below(static_cast<int>(rig.lines.size())))].name;
  }
}

Profile anyProfile(Random& random) {
  Profile profile;
  float place = 0.0f;
  for (int i = 1 + random.below(4); i > 0; --i) {
    place += (1.0f - place) * random.uniform(0.0f, 0.5f);
    profile.emplace_back(place, random.uniform(-kMostProfile, kMostProfile));
  }
  return profile;
}

void addSheets(Random& random, Rig& rig) {
  for (int i = random.below(3); i > 0; --i) {
    MuscleSheet& sheet = rig.sheets.emplace_back();
    sheet.name = anyName(random, i);
    sheet.group = rig.groups[static_cast<std::size_t>(random.below(static_cast<int>(rig.groups.size())))].name;
    for (int e = 2 + random.below(3); e > 0; --e) {
      SheetEdge& edge = sheet.edges.emplace_back();
      for (int p = 1 + random.below(3); p > 0; --p) edge.points.push_back(anyAnchor(random));
      edge.unknownKeys = anyUnknownKeys(random);
    }
    sheet.strips = 2 + random.below(kMostStrips - 1);
    sheet.bellies = 1 + random.below(kMostStripBellies);
    if (random.chance(0.5f)) sheet.thickness = random.uniform(0.001f, kMostSheetHeight);
    if (random.chance(0.5f)) sheet.width = random.uniform(0.0f, kMostSheetHeight);
    if (random.chance(0.5f)) sheet.crest = random.uniform(-kMostSheetHeight, kMostSheetHeight);
    if (random.chance(0.5f)) sheet.sunk = random.uniform(-kMostSheetHeight, kMostSheetHeight);
    if (random.chance(0.5f)) sheet.across = anyProfile(random);
    if (random.chance(0.5f)) sheet.along = anyProfile(random);
    if (random.chance(0.5f)) sheet.reach = random.uniform(1.01f, 3.0f);
    if (random.chance(0.5f)) sheet.spacing = random.uniform(kLeastSpacing, kMostSpacing);
    if (random.chance(0.5f)) sheet.amount = random.uniform(0.0f, kMostAmount);
    if (random.chance(0.3f)) sheet.sign = -1;
    if (random.chance(0.5f)) {
      sheet.line = anySettings(random);
      sheet.unknownLineKeys = anyUnknownKeys(random);
      sheet.unknownActivationKeys = anyUnknownKeys(random);
    }
    sheet.unknownKeys = anyUnknownKeys(random);
  }
}

template <class Twinned>
void pairTwins(Random& random, std::vector<Twinned>& items) {
  for (std::size_t i = 0; i + 1 < items.size(); i += 2) {
    if (random.chance(0.5f)) continue;
    items[i].mirror = items[i + 1].name;
    items[i + 1].mirror = items[i].name;
  }
}

std::vector<std::uint32_t> bitsOf(const Primitive& p) {
  const auto& [c, q, r, s] = p.placement;
  std::vector<std::uint32_t> bits;
  for (const float value : {c.x, c.y, c.z, q.x, q.y, q.z, q.w, r.x, r.y, r.z, p.reach}) {
    bits.push_back(std::bit_cast<std::uint32_t>(value));
  }
  for (const ShapeNumber& number : shapeNumbers()) bits.push_back(std::bit_cast<std::uint32_t>(number.of(s)));
  return bits;
}

}  // namespace

Rig randomDocument(std::uint64_t seed) {
  Random random(seed);
  Rig rig;
  rig.character = anyName(random, 0) + ".glb";
  rig.surface = {random.chance(0.5f) ? SurfaceMode::kSwell : SurfaceMode::kReplace,
                 random.uniform(kLeastIso, kMostIso),
                 std::min(positiveFloat(random), kMostSkinBlend),
                 random.chance(0.5f) ? 0.0f : random.uniform(0.0f, kMostGrooves),
                 {},
                 anyUnknownKeys(random)};
  rig.smoothing = {1 + random.below(kMaxDepth),
                   static_cast<PatchKind>(random.below(4)),
                   random.chance(0.3f),
                   random.chance(0.5f) ? kDefaultCreaseAngle : random.uniform(0.0f, 180.0f),
                   random.chance(0.5f) ? DetailKind::kUniform : DetailKind::kAdaptive,
                   random.chance(0.5f) ? kDefaultTolerance : random.uniform(kLeastTolerance, kMostTolerance),
                   random.chance(0.3f),
                   anyUnknownKeys(random)};
  const int groups = 1 + random.below(5);
  for (int i = 0; i < groups; ++i) rig.groups.push_back({anyName(random, i), anyUnknownKeys(random)});
  for (int a = 0; a < groups; ++a) {
    for (int b = a + 1; b < groups; ++b) {
      if (!random.chance(0.4f)) continue;
      const float amount = random.chance(0.5f) ? 1.0f : random.uniform(0.001f, 1.0f);
      rig.links.push_back({{at(rig.groups, a).name, at(rig.groups, b).name}, amount});
      if (random.chance(0.1f)) rig.links.back().unknownKeys = anyUnknownKeys(random);
    }
  }
  for (int i = random.below(8); i > 0; --i) rig.primitives.push_back(anyPrimitive(random, rig));
  pairTwins(random, rig.primitives);
  addLines(random, rig);
  pairTwins(random, rig.lines);
  addSheets(random, rig);
  pairTwins(random, rig.sheets);
  if (random.chance(0.5f)) addAnimation(random, {anyName(random, 1), anyName(random, 2)}, {"Walk", "跑"}, rig);
  if (random.chance(0.3f)) {
    rig.slots.push_back({"upperArm.L", anyName(random, 1)});
    if (random.chance(0.5f)) rig.slots.push_back({"tail", random.chance(0.5f) ? std::string() : anyName(random, 2)});
  }
  if (random.chance(0.3f)) {
    constexpr std::array kLayers{SkinLayer::kSkin, SkinLayer::kCloth, SkinLayer::kRigid};
    for (int i = random.below(3); i >= 0; --i) {
      rig.layers.push_back({anyName(random, i), kLayers[static_cast<std::size_t>(random.below(3))]});
    }
  }
  rig.unknownKeys = anyUnknownKeys(random);
  if (random.chance(0.3f)) rig.clipFiles = {anyName(random, 1) + ".glb", "../" + anyName(random, 2) + ".gltf"};
  return rig;
}

bool sameFloatBits(const Rig& a, const Rig& b) {
  if (a.primitives.size() != b.primitives.size() || a.lines.size() != b.lines.size()) return false;
  for (std::size_t i = 0; i < a.primitives.size(); ++i) {
    if (bitsOf(a.primitives[i]) != bitsOf(b.primitives[i])) return false;
  }
  for (std::size_t i = 0; i < a.lines.size(); ++i) {
    if (!sameBits(a.lines[i].origin.point, b.lines[i].origin.point)) return false;
  }
  return std::bit_cast<std::uint32_t>(a.surface.iso) == std::bit_cast<std::uint32_t>(b.surface.iso) &&
         std::bit_cast<std::uint32_t>(a.surface.skinBlend) == std::bit_cast<std::uint32_t>(b.surface.skinBlend) &&
         std::bit_cast<std::uint32_t>(a.surface.grooves) == std::bit_cast<std::uint32_t>(b.surface.grooves) &&
         std::bit_cast<std::uint32_t>(a.smoothing.creaseAngle) == std::bit_cast<std::uint32_t>(b.smoothing.creaseAngle);
}

}  // namespace sinew::test
