// core/io/json/json.cpp: Json over the tree of json_text.h.
#include "core/io/json/json.h"

#include <cassert>
#include <charconv>
#include <utility>

#include "core/io/json/json_text.h"

namespace sinew {

using Kind = JsonNode::Kind;

struct Json::Impl {
  JsonNode node;
};

Json::Json(Impl&& impl) : impl_(std::make_unique<Impl>(std::move(impl))) {}
Json::Json() : Json(Impl{}) {}
Json::Json(bool value) : Json(Impl{{value ? Kind::kTrue : Kind::kFalse, {}, {}, {}}}) {}
Json::Json(int value) : Json(static_cast<long long>(value)) {}
Json::Json(long long value) : Json(Impl{numberNode(value)}) {}
Json::Json(double value) : Json(Impl{numberNode(value)}) {}
Json::Json(float value) : Json(Impl{numberNode(value)}) {}
Json::Json(const char* value) : Json(std::string(value)) {}
Json::Json(const std::string& value) : Json(Impl{stringNode(value)}) {}
Json::Json(const Json& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(Json other) {
  impl_ = std::move(other.impl_);
  return *this;
}
Json::~Json() = default;

Json Json::object() { return Json(Impl{{Kind::kObject, {}, {}, {}}}); }
Json Json::array() { return Json(Impl{{Kind::kArray, {}, {}, {}}}); }

Result<Json> Json::parse(std::string_view text) {
  auto node = parseJson(text);
  if (!node) return node.error();
  return Json(Impl{std::move(node).value()});
}

Json& Json::set(const std::string& key, const Json& value) {
  assert(impl_->node.kind == Kind::kObject);
  JsonNode child = value.impl_->node;
  child.key = key;
  std::vector<JsonNode>& children = impl_->node.children;
  for (JsonNode& present : children) {
    if (present.key != key) continue;
    present = std::move(child);
    return *this;
  }
  children.push_back(std::move(child));
  return *this;
}

Json& Json::push(const Json& value) {
  assert(impl_->node.kind == Kind::kArray);
  JsonNode child = value.impl_->node;
  child.key.clear();
  impl_->node.children.push_back(std::move(child));
  return *this;
}

Json Json::at(const std::string& key) const {
  const JsonNode* child = impl_->node.find(key);
  return child ? Json(Impl{*child}) : Json();
}

std::vector<Json> Json::items() const {
  std::vector<Json> result;
  if (impl_->node.kind != Kind::kArray) return result;
  for (const JsonNode& child : impl_->node.children) result.push_back(Json(Impl{child}));
  return result;
}

std::vector<std::string> Json::keys() const {
  std::vector<std::string> result;
  if (impl_->node.kind != Kind::kObject) return result;
  for (const JsonNode& child : impl_->node.children) result.push_back(child.key);
  return result;
}

bool Json::boolean(bool fallback) const {
  if (impl_->node.kind == Kind::kTrue) return true;
  return impl_->node.kind == Kind::kFalse ? false : fallback;
}

double Json::number(double fallback) const {
  if (impl_->node.kind != Kind::kNumber) return fallback;
  const std::string& token = impl_->node.text;
  double value = 0.0;
  // What is too small for a double is reported as out of range and is 0; too large does not pass the parser.
  const auto [end, status] = std::from_chars(token.data(), token.data() + token.size(), value);
  return status == std::errc{} ? value : 0.0;
}

std::string Json::text(const std::string& fallback) const {
  return impl_->node.kind == Kind::kString ? impl_->node.text : fallback;
}

bool Json::isNull() const { return impl_->node.kind == Kind::kNull; }

std::string Json::dump(bool indented) const { return writeJson(impl_->node, indented); }

}  // namespace sinew
