// tests/fuzz/gltf_mutator.cpp: a .glb is changed inside its chunks, JSON by its meaning.

#include "tests/fuzz/gltf_mutator.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <random>
#include <vector>

#include <nlohmann/json.hpp>

namespace sinew::fuzz {
namespace {

using Json = nlohmann::ordered_json;
using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

/// All values inside, the whole among them.
void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  if (value.is_structured()) {
    for (Json& inner : value) collect(inner, all);
  }
}

Json otherNumber(const Json& value, Random& random) {
  const Json values[] = {0,           1,    -1,     2,   3,      4,    255,  65535, 2147483647, -2147483648LL,
                         4294967295u, 1e30, -1e-30, 0.5, 1.0e38, 5121, 5123, 5125,  5126};
  if (value.is_number_integer() && random() % 2) return value.get<std::int64_t>() + (random() % 2 ? 1 : -1);
  return values[below(random, std::size(values))];
}

/// One change of the JSON's meaning: a number, a key, an element.
void change(Json& json, Random& random) {
  std::vector<Json*> all;
  collect(json, all);
  Json& value = *all[below(random, all.size())];
  if (value.is_number()) {
    value = otherNumber(value, random);
  } else if (value.is_array() && !value.empty()) {
    const std::size_t at = below(random, value.size());
    if (random() % 2) {
      value.erase(at);
    } else {
      value.push_back(Json(value[at]));
    }
  } else if (value.is_object() && !value.empty()) {
    auto at = value.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(below(random, value.size())));
    if (random() % 2) {
      value.erase(at.key());
    } else {
      at.value() = Json(*all[below(random, all.size())]);
    }
  } else {
    value = otherNumber(value, random);
  }
}

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, 4);
  return word;
}

void putWord(std::string& bytes, std::uint32_t word) { bytes.append(reinterpret_cast<const char*>(&word), 4); }

struct Glb {
  std::string json, binary;

  [[nodiscard]] std::string bytes() const {
    std::string padded = json, data = binary;
    padded.resize((padded.size() + 3) / 4 * 4, ' ');
    data.resize((data.size() + 3) / 4 * 4, '\0');
    std::string out = "glTF";
    putWord(out, 2);
    putWord(out, static_cast<std::uint32_t>(12 + 8 + padded.size() + (data.empty() ? 0 : 8 + data.size())));
    putWord(out, static_cast<std::uint32_t>(padded.size()));
    out += "JSON" + padded;
    if (!data.empty()) {
      putWord(out, static_cast<std::uint32_t>(data.size()));
      out += std::string("BIN\0", 4) + data;
    }
    return out;
  }
};

/// False: it is none, or one that is cut off.
bool split(std::string_view bytes, Glb& glb) {
  if (bytes.size() < 20 || !bytes.starts_with("glTF")) return false;
  const std::size_t length = wordAt(bytes, 12);
  if (length > bytes.size() - 20) return false;
  glb.json = bytes.substr(20, length);
  if (bytes.size() - 20 - length > 8) glb.binary = bytes.substr(28 + length);
  return true;
}

}  // namespace

std::string mutated(std::string_view bytes, std::size_t most, unsigned seed, const MutateBytes& mutateBytes) {
  Random random(seed);
  Glb glb;
  const bool isGlb = split(bytes, glb);
  if (!isGlb) glb.json = bytes;
  Json json = Json::parse(glb.json, nullptr, false);
  const std::size_t way = random() % 8;
  if (way == 0 || (!isGlb && json.is_discarded())) return mutateBytes(std::string(bytes), most);
  if (way == 1 || json.is_discarded()) {
    glb.json = mutateBytes(glb.json, glb.json.size() + 64);
  } else if (way < 4 && isGlb) {
    glb.binary = mutateBytes(glb.binary, glb.binary.size() + 64);
  } else {
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) change(json, random);
    glb.json = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  std::string out = isGlb ? glb.bytes() : glb.json;
  return out.size() <= most ? out : mutateBytes(std::string(bytes), most);
}

}  // namespace sinew::fuzz
