// tests/support/characters/dressed_humanoid.cpp: clothes as offsets of the curved skin, appended to the file.
#include "tests/support/characters/dressed_humanoid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"
#include "sinew/surface/smoother.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using Json = nlohmann::ordered_json;
using JointWeights = std::map<int, float>;

struct Piece {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<JointWeights> weights;
  std::vector<std::array<int, 3>> triangles;
};

class Tailor {
 public:
  explicit Tailor(std::shared_ptr<const Character> character) : character_(std::move(character)) {
    Smoother smoother(character_);
    Rig rig;
    rig.smoothing.depth = 3;  // One vertex inside each triangle: its middle.
    if (!smoother.prepare(rig)) std::abort();
    smoother.smooth(bindPose(character_->skeleton), skin_);
  }

  /// Over the triangles whose vertices all follow these bones most and lie above `least` (y).
  [[nodiscard]] Piece over(const std::set<std::string>& bones, float least, float offset) const {
    const ControlMesh& mesh = character_->mesh;
    std::vector<bool> isIn(mesh.triangles.size());
    for (std::size_t t = 0; t < isIn.size(); ++t) {
      isIn[t] = std::ranges::all_of(mesh.triangles[t].vertices, [&](int v) {
        const std::string& bone = at(character_->skeleton.bones, strongestBone(*character_, v)).name;
        return bones.contains(bone.substr(0, bone.find('.'))) && at(mesh.positions, v).y >= least;
      });
    }
    Piece piece;
    std::map<int, int> ofVertex;
    std::vector<int> middles(isIn.size(), -1);
    std::vector<std::array<int, 2>> atEdge(mesh.edges.size(), {-1, -1});
    const auto vertexOf = [&](int v) {
      const auto [found, isNew] = ofVertex.try_emplace(v, static_cast<int>(piece.positions.size()));
      if (isNew) add(v, {v}, offset, piece);
      return found->second;
    };
    for (std::size_t t = 0; t < isIn.size(); ++t) {
      if (!isIn[t]) continue;
      const auto& corners = mesh.triangles[t].vertices;
      middles[t] = static_cast<int>(piece.positions.size());
      add(skin_.refinement->insideBegin[t], {corners.begin(), corners.end()}, offset, piece);
      for (const int e : mesh.triangles[t].edges) {
        at(at(atEdge, e), at(atEdge, e)[0] < 0 ? 0 : 1) = static_cast<int>(t);
      }
    }
    for (std::size_t t = 0; t < isIn.size(); ++t) {
      if (!isIn[t]) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& pair = at(atEdge, mesh.triangles[t].edges[i]);
        const int other = pair[0] == static_cast<int>(t) ? pair[1] : pair[0];
        const int a = vertexOf(mesh.triangles[t].vertices[i]);
        const int b = vertexOf(mesh.triangles[t].vertices[(i + 1) % 3]);
        if (other < 0) piece.triangles.push_back({a, b, middles[t]});
        else piece.triangles.push_back({a, at(middles, other), middles[t]});
      }
    }
    return piece;
  }

  [[nodiscard]] Bounds boundsOfBone(const std::string& name) const {
    Bounds box;
    for (int v = 0; v < static_cast<int>(character_->mesh.positions.size()); ++v) {
      if (at(character_->skeleton.bones, strongestBone(*character_, v)).name == name) {
        box.add(at(character_->mesh.positions, v));
      }
    }
    return box;
  }

  void addBall(const glm::vec3& center, float radius, int joint, Piece& piece) const {
    constexpr int kColumns = 8;
    constexpr int kRings = 6;
    const int first = static_cast<int>(piece.positions.size());
    for (int ring = 0; ring <= kRings; ++ring) {
      const float polar = 3.14159265f * static_cast<float>(ring) / kRings;
      const bool isPole = ring == 0 || ring == kRings;
      for (int column = 0; column < kColumns; ++column) {
        const float turn = 6.2831853f * static_cast<float>(column) / kColumns;
        const float across = isPole ? 0.0f : std::sin(polar);
        const glm::vec3 n(across * std::sin(turn), std::cos(polar), across * std::cos(turn));
        piece.positions.push_back(center + radius * n);
        piece.normals.push_back(n);
        piece.weights.push_back({{joint, 1.0f}});
      }
    }
    for (int ring = 0; ring < kRings; ++ring) {
      for (int column = 0; column < kColumns; ++column) {
        const int a = first + ring * kColumns + column;
        const int b = first + ring * kColumns + (column + 1) % kColumns;
        if (ring < kRings - 1) piece.triangles.push_back({a, a + kColumns, b + kColumns});
        if (ring > 0) piece.triangles.push_back({a, b + kColumns, b});
      }
    }
  }

  /// A tube around hips and thighs that widens downwards and follows both thighs where it hangs between them.
  [[nodiscard]] Piece skirt(float top, float hem, float offset) const {
    constexpr int kColumns = 24;
    constexpr int kRings = 8;
    Piece piece;
    const Bounds hips = boundsOfBone("hips");
    const glm::vec3 half = 0.5f * hips.extent() + glm::vec3(offset, 0.0f, offset);
    for (int ring = 0; ring <= kRings; ++ring) {
      const float down = static_cast<float>(ring) / kRings;
      for (int column = 0; column < kColumns; ++column) {
        const float turn = 6.2831853f * static_cast<float>(column) / kColumns;
        const glm::vec3 across(half.x * (1.0f + 0.25f * down) * std::sin(turn), 0.0f,
                               half.z * (1.0f + 0.25f * down) * std::cos(turn));
        piece.positions.push_back(glm::vec3(hips.center().x, top + (hem - top) * down, hips.center().z) + across);
        piece.normals.push_back(glm::normalize(glm::vec3(across.x, 0.1f * half.x, across.z)));
        const float left = 0.5f + 0.5f * std::sin(turn);
        const float thighs = std::min(1.5f * down, 1.0f);
        piece.weights.push_back({{jointOf("hips"), 1.0f - thighs},
                                 {jointOf("thigh.L"), thighs * left},
                                 {jointOf("thigh.R"), thighs * (1.0f - left)}});
      }
    }
    for (int ring = 0; ring < kRings; ++ring) {
      for (int column = 0; column < kColumns; ++column) {
        const int a = ring * kColumns + column;
        const int b = ring * kColumns + (column + 1) % kColumns;
        piece.triangles.push_back({a, a + kColumns, b + kColumns});
        piece.triangles.push_back({a, b + kColumns, b});
      }
    }
    return piece;
  }

  /// Joints of the file's skin are its bones in the order of its nodes.
  [[nodiscard]] int jointOf(const std::string& bone) const { return character_->skeleton.findBone(bone).value(); }

 private:
  void add(int refined, const std::vector<int>& corners, float offset, Piece& piece) const {
    piece.positions.push_back(at(skin_.positions, refined) + offset * at(skin_.normals, refined));
    piece.normals.push_back(at(skin_.normals, refined));
    JointWeights weights;
    for (const int v : corners) {
      for (const WeightedBinding& follows : bindingsOf(*character_, v)) {
        weights[follows.bone()] += follows.weight / static_cast<float>(corners.size());
      }
    }
    piece.weights.push_back(std::move(weights));
  }

  std::shared_ptr<const Character> character_;
  Surface skin_;
};

/// A parsed .glb.
class GlbFile {
 public:
  explicit GlbFile(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    std::uint32_t length = 0;
    std::memcpy(&length, whole.data() + 12, 4);
    json = Json::parse(whole.substr(20, length));
    binary = whole.substr(20 + length + 8);
  }

  void addMesh(const std::string& name, const Piece& piece, const std::array<double, 4>& color) {
    std::vector<float> positions;
    std::vector<float> normals;
    std::vector<std::uint8_t> joints;
    std::vector<float> weights;
    Bounds box;
    for (std::size_t v = 0; v < piece.positions.size(); ++v) {
      box.add(piece.positions[v]);
      for (int axis = 0; axis < 3; ++axis) positions.push_back(piece.positions[v][axis]);
      for (int axis = 0; axis < 3; ++axis) normals.push_back(piece.normals[v][axis]);
      std::vector<std::pair<float, int>> sorted;
      for (const auto& [joint, weight] : piece.weights[v]) sorted.emplace_back(-weight, joint);
      std::ranges::sort(sorted);
      sorted.resize(4, {0.0f, 0});
      float sum = 0.0f;
      for (const auto& [weight, joint] : sorted) sum -= weight;
      for (const auto& [weight, joint] : sorted) {
        joints.push_back(static_cast<std::uint8_t>(joint));
        weights.push_back(-weight / sum);
      }
    }
    std::vector<std::uint16_t> indices;
    for (const auto& triangle : piece.triangles) {
      for (const int v : triangle) indices.push_back(static_cast<std::uint16_t>(v));
    }
    Json attributes;
    attributes["POSITION"] = accessor(positions, 5126, "VEC3");
    json["accessors"].back()["min"] = {box.low.x, box.low.y, box.low.z};
    json["accessors"].back()["max"] = {box.high.x, box.high.y, box.high.z};
    attributes["NORMAL"] = accessor(normals, 5126, "VEC3");
    attributes["JOINTS_0"] = accessor(joints, 5121, "VEC4");
    attributes["WEIGHTS_0"] = accessor(weights, 5126, "VEC4");
    const int index = accessor(indices, 5123, "SCALAR");
    const int material = static_cast<int>(json["materials"].size());
    json["materials"].push_back(
        {{"name", name}, {"pbrMetallicRoughness", {{"baseColorFactor", color}, {"metallicFactor", 0.0}}}});
    const int mesh = static_cast<int>(json["meshes"].size());
    Json primitive{{"attributes", attributes}, {"indices", index}, {"material", material}};
    json["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    json["scenes"][0]["nodes"].push_back(json["nodes"].size());
    json["nodes"].push_back({{"name", name}, {"mesh", mesh}, {"skin", 0}});
  }

  [[nodiscard]] std::string bytes() {
    json["buffers"][0]["byteLength"] = binary.size();
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string out;
    const auto put = [&](std::uint32_t number) { out.append(reinterpret_cast<const char*>(&number), 4); };
    put(0x46546C67);
    put(2);
    put(static_cast<std::uint32_t>(28 + text.size() + binary.size()));
    put(static_cast<std::uint32_t>(text.size()));
    put(0x4E4F534A);
    out += text;
    put(static_cast<std::uint32_t>(binary.size()));
    put(0x004E4942);
    return out + binary;
  }

  Json json;
  std::string binary;

 private:
  template <class Number>
  int accessor(const std::vector<Number>& numbers, int componentType, const char* type) {
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::size_t bytes = numbers.size() * sizeof(Number);
    const std::map<std::string, std::size_t> width{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", componentType},
                                 {"count", numbers.size() / width.at(type)},
                                 {"type", type}});
    const std::size_t from = binary.size();
    binary.resize(from + bytes);
    std::memcpy(binary.data() + from, numbers.data(), bytes);
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    return static_cast<int>(json["accessors"].size()) - 1;
  }
};

}  // namespace

const char* nameOf(Outfit outfit) {
  constexpr std::array kNames{"usual", "tight", "loose", "long sleeves", "skirt"};
  return kNames[static_cast<std::size_t>(outfit)];
}

std::string dressedHumanoidGlb(Outfit outfit) {
  const std::filesystem::path file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb";
  const Tailor tailor(importGltf(file).value());
  const Bounds head = tailor.boundsOfBone("head");
  const glm::vec3 size = head.extent();
  Piece eyes;
  for (const float side : {-1.0f, 1.0f}) {
    const glm::vec3 place(side * 0.22f * size.x, 0.0f, 0.2f * size.z);
    tailor.addBall(head.center() + place, 0.09f * size.x, tailor.jointOf("head"), eyes);
  }
  std::set<std::string> shirt{"spine", "chest", "clavicle", "upper_arm"};
  if (outfit == Outfit::kLongSleeves) shirt.insert("forearm");
  const std::map<Outfit, float> shirts{
      {Outfit::kTight, 0.003f}, {Outfit::kLoose, 0.04f}, {Outfit::kLongSleeves, 0.01f}};
  const std::map<Outfit, float> trousers{{Outfit::kTight, 0.002f}, {Outfit::kLoose, 0.03f}};
  const auto offsetOf = [&](const std::map<Outfit, float>& offsets, float usual) {
    const auto found = offsets.find(outfit);
    return found == offsets.end() ? usual : found->second;
  };
  GlbFile glb(file);
  glb.addMesh("Shirt", tailor.over(shirt, 0.0f, offsetOf(shirts, 0.016f)), {0.2, 0.35, 0.6, 1.0});
  if (outfit == Outfit::kSkirt) {
    const Bounds shin = tailor.boundsOfBone("shin.L");
    glb.addMesh("Skirt", tailor.skirt(tailor.boundsOfBone("hips").high.y, shin.high.y, 0.02f), {0.25, 0.22, 0.2, 1.0});
  } else {
    glb.addMesh("Trousers", tailor.over({"hips", "thigh", "shin"}, 0.0f, offsetOf(trousers, 0.012f)),
                {0.25, 0.22, 0.2, 1.0});
  }
  glb.addMesh("Eyes", eyes, {0.9, 0.9, 0.95, 1.0});
  glb.addMesh("Hair", tailor.over({"head"}, head.center().y, 0.014f), {0.2, 0.1, 0.05, 1.0});
  return glb.bytes();
}

std::filesystem::path writeDressedHumanoid(const std::filesystem::path& folder, Outfit outfit) {
  const std::filesystem::path path = folder / "dressed.glb";
  std::ofstream(path, std::ios::binary) << dressedHumanoidGlb(outfit);
  return path;
}

std::shared_ptr<const Character> dressedHumanoid(Outfit outfit) {
  static std::map<Outfit, std::shared_ptr<const Character>> made;
  std::shared_ptr<const Character>& character = made[outfit];
  if (!character) {
    const TemporaryFolder folder;
    character = importGltf(writeDressedHumanoid(folder.path(), outfit)).value();
  }
  return character;
}

std::vector<Pose> posesOfClips(const Character& character, int each) {
  std::vector<Pose> poses;
  for (const AnimationClip& clip : character.clips) {
    for (int i = 0; i < each; ++i) {
      const float time = clip.duration * static_cast<float>(i) / static_cast<float>(each);
      poses.push_back(samplePose(character.skeleton, clip, time));
    }
  }
  return poses;
}

}  // namespace sinew::test
