// core/files/gltf/guard.cpp: checks a glTF file's JSON by the rules and writes it again.

#include "core/files/gltf/guard.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/files/gltf/rules.h"

namespace sinew::gltf {
namespace {

using Kind = Json::Kind;

/// Elements of all lists; each takes up to about 2 KiB during the import.
constexpr std::size_t kMaxJsonElements = 500'000;
constexpr std::size_t kMaxFaults = 1000;  ///< One more fault refuses the file, used or not.
constexpr Rule kAttribute = {.type = Type::kIndex, .list = "accessors", .otherwise = "-1", .whenUsed = true};
constexpr std::array<double, 6> kComponentTypes{5120, 5121, 5122, 5123, 5125, 5126};
// MAT2 and MAT3 have padded columns; nothing that is read uses them.
constexpr std::array<std::string_view, 5> kGuardShapes{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT4"};

/// The current JSON path, built only for a refusal.
struct GuardPlace {
  const GuardPlace* above = nullptr;
  std::string_view key{};  // "" for an element
  std::size_t index = 0;   // of an element

  [[nodiscard]] std::string text() const {
    std::string result = above ? above->text() : "";
    if (key.empty()) return above ? placeOf(result, index) : result;
    return result.empty() ? std::string(key) : result + '.' + std::string(key);
  }
};

std::string singular(std::string_view list) {
  return std::string(list.substr(0, list.size() - (list == "meshes" ? 2 : 1)));
}

class Guard {
 public:
  explicit Guard(const Json& root) : root_(root) {
    for (const Rule& rule : fileRules()) {
      if (rule.type == Type::kList) sizes_[rule.key] = root.at(rule.key).items().size();
    }
  }

  Guarded run() && {
    const GuardPlace place;
    out() += '{';
    writeMember(root_, assetRule(), place);
    checkVersion(root_.at("asset").at("version").text(""));
    for (const Rule& rule : fileRules()) writeMember(root_, rule, place);
    out() += '}';
    return std::move(result_);
  }

 private:
  std::string& out() { return result_.text; }

  static void checkVersion(const std::string& version) {
    if (version.starts_with("2.")) return;
    refuse("asset.version", version.empty() ? "missing; this is no glTF 2.0 file"
                                            : "glTF version " + shortened(version) + "; 2.0 expected");
  }

  void separate() {
    if (out().back() != '{' && out().back() != '[') out() += ',';
  }

  void writeMember(const Json& object, const Rule& rule, const GuardPlace& above) {
    const GuardPlace place{.above = &above, .key = rule.key};
    const Json* value = object.find(rule.key);
    if (!value && rule.needed) refuse(place.text(), "missing");
    if (!value && rule.otherwise.empty()) return;
    const std::size_t before = out().size();
    separate();
    out() += '"' + std::string(rule.key) + "\":";
    if (value) write(*value, rule, place);
    else out() += rule.otherwise;
    if (rule.aside) out().resize(before);
  }

  void write(const Json& value, const Rule& rule, const GuardPlace& place) {
    const std::size_t before = out().size();
    try {
      writeSound(value, rule, place);
    } catch (const Refusal& refusal) {
      if (!rule.whenUsed || result_.faults.size() == kMaxFaults) throw;
      out().resize(before);
      out() += rule.otherwise;
      result_.faults.emplace(place.text(), refusal.error);
    }
  }

  void writeSound(const Json& value, const Rule& rule, const GuardPlace& place) {
    switch (rule.type) {
      case Type::kAnything:
        return void(out() += "null");
      case Type::kMarker:
        return void(out() += R"({"index":0})");  // a texture for tinygltf; harmless in other markers
      case Type::kBoolean:
        if (value.kind != Kind::kTrue && value.kind != Kind::kFalse) refuse(place.text(), "expected true or false");
        return void(out() += value.dump());
      case Type::kNumber:
        return writeNumber(value, place);
      case Type::kNumbers:
        return writeNumbers(value, rule, place);
      case Type::kText:
        return void(out() += expectText(value, place).dump());
      case Type::kWhole:
        return writeWhole(value, rule, place);
      case Type::kIndex:
        return writeIndex(value, rule, place);
      case Type::kComponentType:
        return writeComponentType(value, place);
      case Type::kShape:
        if (std::ranges::find(kGuardShapes, expectText(value, place).content) == kGuardShapes.end()) {
          refuse(place.text(), "unknown or unusable type " + shortened(value.dump()));
        }
        return void(out() += value.dump());
      case Type::kAttributes:
        return writeAttributes(value, place);
      case Type::kObject:
        expectObject(value, place);
        out() += '{';
        for (const Rule& member : rule.members) writeMember(value, member, place);
        return void(out() += '}');
      case Type::kList:
        return writeList(value, rule, place);
    }
  }

  static void expectObject(const Json& value, const GuardPlace& place) {
    if (value.kind != Kind::kObject) refuse(place.text(), "expected an object");
  }

  static const Json& expectText(const Json& value, const GuardPlace& place) {
    if (value.kind != Kind::kString) refuse(place.text(), "expected a string");
    return value;
  }

  static const std::vector<Json>& itemsOf(const Json& value, const GuardPlace& place) {
    if (value.kind != Kind::kArray) refuse(place.text(), "expected an array");
    return value.children;
  }

  static std::uint64_t wholeOf(const Json& value, const GuardPlace& place) {
    if (value.kind != Kind::kNumber) refuse(place.text(), "expected a number");
    const double number = value.number(0.0);
    if (number < 0.0 || number > static_cast<double>(kMaxWhole) || number != std::floor(number)) {
      refuse(place.text(), "expected a whole number >= 0");
    }
    return static_cast<std::uint64_t>(number);
  }

  /// With a point or an exponent: tinygltf truncates whole numbers in extensions to int.
  void writeNumber(const Json& value, const GuardPlace& place) {
    if (value.kind != Kind::kNumber) refuse(place.text(), "expected a number");
    out() += value.content;
    if (value.content.find_first_of(".eE") == std::string::npos) out() += ".0";
  }

  void writeNumbers(const Json& value, const Rule& rule, const GuardPlace& place) {
    const std::vector<Json>& items = itemsOf(value, place);
    if (items.size() != rule.limit) refuse(place.text(), "expected " + std::to_string(rule.limit) + " numbers");
    out() += '[';
    for (std::size_t i = 0; i < items.size(); ++i) {
      separate();
      writeNumber(items[i], {.above = &place, .index = i});
    }
    out() += ']';
  }

  void writeWhole(const Json& value, const Rule& rule, const GuardPlace& place) {
    const std::uint64_t whole = wholeOf(value, place);
    if (whole > rule.limit && rule.whenUsed) {  // an index into a list that the guard does not know
      refuse(place.text(), "there is no " + std::string(rule.key) + " " + std::to_string(whole));
    }
    out() += std::to_string(std::min(whole, rule.limit));
  }

  void writeIndex(const Json& value, const Rule& rule, const GuardPlace& place) {
    const std::uint64_t index = wholeOf(value, place);
    const std::size_t size = sizes_.at(rule.list);
    if (index >= size) {
      refuse(place.text(), "there is no " + singular(rule.list) + " " + std::to_string(index) + "; the file has " +
                               std::to_string(size));
    }
    out() += std::to_string(index);
  }

  void writeComponentType(const Json& value, const GuardPlace& place) {
    const std::uint64_t type = wholeOf(value, place);
    if (std::ranges::find(kComponentTypes, static_cast<double>(type)) == kComponentTypes.end()) {
      refuse(place.text(), "unknown component type " + std::to_string(type));
    }
    out() += std::to_string(type);
  }

  /// Attributes that are read, with their accessors; those that are noted, without. Names are plain.
  void writeAttributes(const Json& value, const GuardPlace& place) {
    expectObject(value, place);
    out() += '{';
    for (const Json& attribute : value.children) {
      const std::string& name = attribute.key;
      if (name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") != std::string::npos) continue;
      const bool read = name == "POSITION" || name.starts_with("TEXCOORD_") || name.starts_with("JOINTS_") ||
                        name.starts_with("WEIGHTS_") || name == "COLOR_0";
      if (!read && name != "TANGENT" && !name.starts_with("COLOR_")) continue;
      separate();
      out() += '"' + name + "\":";
      if (read) write(attribute, kAttribute, {.above = &place, .key = name});
      else out() += '0';
    }
    out() += '}';
  }

  void writeList(const Json& value, const Rule& rule, const GuardPlace& place) {
    const std::vector<Json>& items = itemsOf(value, place);
    if (rule.limit != 0 && items.size() > rule.limit) refuse(place.text(), std::string(rule.beyond));
    if (rule.element->type == Type::kObject) {
      elements_ += items.size();
      if (elements_ > kMaxJsonElements) refuse(place.text(), "more than 500,000 elements in one file");
    }
    out() += '[';
    for (std::size_t i = 0; i < items.size(); ++i) {
      separate();
      write(items[i], *rule.element, {.above = &place, .index = i});
    }
    out() += ']';
  }

  const Json& root_;
  std::map<std::string_view, std::size_t> sizes_;  // of the file's lists
  std::size_t elements_ = 0;
  Guarded result_;
};

}  // namespace

Guarded guard(const Json& root) { return Guard(root).run(); }

}  // namespace sinew::gltf
