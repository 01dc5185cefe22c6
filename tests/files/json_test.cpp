// tests/files/json_test.cpp: parsing and writing of JSON values.
#include "core/files/json/json.h"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

TEST(Json, KeepsKeyOrderAndReplacesInPlace) {
  Json json = Json::object();
  json.set("zebra", 1).set("apple", 2).set("zebra", "three");
  EXPECT_EQ(json.dump(), R"({"zebra":"three","apple":2})");
}

TEST(Json, HasValueSemantics) {
  Json first = Json::object().set("list", Json::array().push(1));
  Json second = first;
  second.set("list", 5);
  EXPECT_EQ(first.dump(), R"({"list":[1]})");
  first = second;
  EXPECT_EQ(first.dump(), R"({"list":5})");
}

TEST(Json, WritesShortestDecimals) {
  EXPECT_EQ(Json(1.4142135f).dump(), "1.4142135");
  EXPECT_EQ(Json(0.1f).dump(), "0.1");
  EXPECT_EQ(Json(0.1).dump(), "0.1");
  EXPECT_EQ(Json(-0.0f).dump(), "-0.0");
  EXPECT_EQ(Json(std::numeric_limits<double>::quiet_NaN()).dump(), "null");
  EXPECT_EQ(Json(std::numeric_limits<float>::infinity()).dump(), "null");
}

TEST(Json, EveryDoubleRoundTrips) {
  test::Random random(11);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random.next());
    if (!std::isfinite(value)) continue;
    const auto back = Json::parse(Json(value).dump());
    ASSERT_TRUE(back.ok()) << value;
    // Including denormals; only the fallback differs from a number.
    ASSERT_EQ(std::bit_cast<std::uint64_t>(back->number(-7.0)), std::bit_cast<std::uint64_t>(value)) << value;
  }
}

TEST(Json, MissingValuesGiveTheFallback) {
  const auto json = Json::parse(R"({"a": 1, "b": "text", "c": [true, null], "d": {"e": -2.5}})");
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->at("a").number(0), 1.0);
  EXPECT_EQ(json->at("a").text("none"), "none");
  EXPECT_EQ(json->at("b").number(7), 7.0);
  EXPECT_EQ(json->at("missing").boolean(true), true);
  EXPECT_TRUE(json->at("missing").isNull());
  EXPECT_EQ(json->at("d").at("e").number(0), -2.5);
  ASSERT_EQ(json->at("c").items().size(), 2u);
  EXPECT_TRUE(json->at("c").items()[0].boolean(false));
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_TRUE(json->at("c").keys().empty());
  EXPECT_TRUE(json->items().empty());
}

TEST(Json, IndentedTextRoundTrips) {
  const std::string text = R"({"a":[1,2,3],"b":{"c":{"d":[{"e":"x"},[],{}]}},"long":[)" + std::string(60, '1') + "," +
                           std::string(60, '2') + "]}";
  const auto json = Json::parse(text);
  ASSERT_TRUE(json.ok());
  const auto again = Json::parse(json->dump(true));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->dump(), json->dump());
  EXPECT_NE(json->dump(true).find("\n  \"a\": [1, 2, 3],\n"), std::string::npos) << json->dump(true);
}

TEST(Json, InvalidUtf8IsReplacedWhenWritten) {
  const std::string text = Json(std::string("a\xff") + "b").dump();
  EXPECT_EQ(text,
            "\"a\xEF\xBF\xBD"
            "b\"");
}

TEST(Json, SyntaxErrorsNameByteLineAndPath) {
  const auto json = Json::parse("{\n  \"a\": [1, NaN]\n}");
  ASSERT_FALSE(json.ok());
  EXPECT_TRUE(json.error().place.starts_with("byte 14 (line 2, column 12)")) << json.error().text();
  EXPECT_NE(json.error().reason.find("a[1]"), std::string::npos) << json.error().text();
}

TEST(Json, RefusesInvalidJson) {
  for (const char* text :
       {"", " ", "{", "[1,]", "{\"a\":}", "{'a':1}", "[1] 2", "nul", "\"\xff\"", "// c\n1", "[01]", "+1"}) {
    EXPECT_FALSE(Json::parse(text).ok()) << text;
  }
}

TEST(Json, OutOfRangeNumbersAndDuplicateKeysAreLocatedByPath) {
  const auto huge = Json::parse(R"({"a": {"b": [0, 1e999]}})");
  ASSERT_FALSE(huge.ok());
  EXPECT_EQ(huge.error().place, "a.b[1]");
  const auto twice = Json::parse(R"({"a": [{"b": 1, "b": 2}]})");
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.error().place, "a[0].b");
}

TEST(Json, DeepNestingIsRefusedWithoutOverflowingTheStack) {
  const std::string deep(5'000'000, '[');
  EXPECT_FALSE(Json::parse(deep).ok());
  std::string objects;
  for (int i = 0; i < 200000; ++i) objects += "{\"a\":";
  const auto json = Json::parse(objects);
  ASSERT_FALSE(json.ok());
  EXPECT_LT(json.error().place.size(), 100u);
  const auto fits = Json::parse(std::string(kMaxJsonDepth, '[') + std::string(kMaxJsonDepth, ']'));
  ASSERT_TRUE(fits.ok());
  EXPECT_EQ(fits->dump().size(), 2u * kMaxJsonDepth);
}

TEST(Json, TooManyValuesAreRefused) {
  std::string text = "[0";
  for (int i = 0; i < kMaxJsonValues; ++i) text += ",0";
  text += ']';
  EXPECT_FALSE(Json::parse(text).ok());
}

TEST(Json, CustomLimitsApply) {
  const JsonLimits limits{.depth = 2, .values = 4, .leftOut = {}};
  EXPECT_TRUE(Json::parse("[[1, 2]]", limits).ok());
  const auto deep = Json::parse(R"({"a": {"b": []}})", limits);
  ASSERT_FALSE(deep.ok());
  EXPECT_EQ(deep.error().place, "a.b");
  EXPECT_EQ(deep.error().reason, "JSON nested deeper than 2 levels");
  const auto many = Json::parse("[1, 2, 3, 4]", limits);
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().reason, "more than 4 JSON values");
}

TEST(Json, SkippedMembersAreParsedAndCountedButNotKept) {
  const std::string text = R"({"a": {"extras": {"x": [1, {"extras": 2}], "y": 3}, "b": 1}, "extras": 4, "c": 5})";
  const auto json = Json::parse(text, {.leftOut = "extras"});
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->dump(), R"({"a":{"b":1},"c":5})");
  EXPECT_FALSE(Json::parse(text, {.values = 8, .leftOut = "extras"}).ok());
  EXPECT_FALSE(Json::parse(R"({"extras": [1, }, "b": 1})", {.leftOut = "extras"}).ok());
}

TEST(Json, LongKeysAreShortenedInErrors) {
  const auto json = Json::parse(R"({")" + std::string(100000, 'k') + R"(": 1e999})");
  ASSERT_FALSE(json.ok());
  EXPECT_LT(json.error().text().size(), 300u);
}

TEST(Json, ValidUtf8IsKeptAndTheRestReplaced) {
  EXPECT_EQ(validUtf8("M\xC3\xBCll\"er\n"), "M\xC3\xBCll\"er\n");
  EXPECT_EQ(validUtf8("a\xff"), "a\xEF\xBF\xBD");
}

}  // namespace
}  // namespace sinew
