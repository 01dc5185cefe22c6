// tests/ui/expression_test.cpp: arithmetic in number fields.

#include "app/ui/number_field.h"

#include <charconv>
#include <clocale>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

double valueOf(const std::string& text, double current = 0.0) {
  const Result<Typed> typed = evaluate(text, current);
  EXPECT_TRUE(typed.ok()) << text << ": " << (typed ? "" : typed.error().reason);
  return typed ? typed->value : std::nan("");
}

TEST(Expression, FollowsTheUsualPrecedence) {
  const std::pair<const char*, double> rows[] = {{"0.2*1.5", 0.2 * 1.5},
                                                 {"12/5", 2.4},
                                                 {"1 + 2 * 3", 7},
                                                 {"(1+2)*3", 9},
                                                 {"-2^2", -4},
                                                 {"2^-1", 0.5},
                                                 {"2^3^2", 512},
                                                 {"8/4/2", 1},
                                                 {"5-3-1", 1},
                                                 {"--3", 3},
                                                 {"sqrt(16)", 4},
                                                 {".5", 0.5},
                                                 {"5.", 5},
                                                 {"1e-3", 0.001},
                                                 {" 7 ", 7},
                                                 {"0,25", 0.25},
                                                 {"30 %", 30},
                                                 {"45\xc2\xb0", 45},
                                                 {"2*45 deg", 90},
                                                 {"0.5 x", 0.5},
                                                 {"+4", 4},
                                                 {"2*-3", -6},
                                                 {"((((1))))", 1}};
  for (const auto& [text, value] : rows) EXPECT_DOUBLE_EQ(valueOf(text), value) << text;
  EXPECT_DOUBLE_EQ(valueOf("pi/2"), 0.5 * std::numbers::pi);
}

TEST(Expression, AppliesRelativeOperators) {
  EXPECT_DOUBLE_EQ(valueOf("+=0.1", 2.0), 2.1);
  EXPECT_DOUBLE_EQ(valueOf("-= 0.5", 2.0), 1.5);
  EXPECT_DOUBLE_EQ(valueOf("*=1+1", 2.0), 4.0);
  EXPECT_DOUBLE_EQ(valueOf("/=4", 2.0), 0.5);
  EXPECT_TRUE(evaluate("+=1", 0.0)->relative);
  EXPECT_FALSE(evaluate("+1", 5.0)->relative);
}

TEST(Expression, ReportsSyntaxErrors) {
  const std::pair<const char*, const char*> rows[] = {
      {"", "a number is missing"},
      {"1+", "a number is missing at the end"},
      {"+=", "a number is missing at the end"},
      {"(1+2", "\")\" is missing"},
      {"1)", "\")\" without \"(\""},
      {"1/0", "division by zero"},
      {"/=0", "division by zero"},
      {"two", "\"two\" is not known"},
      {"2 apples", "\"apples\" is not known"},
      {"pie", "\"pie\" is not known"},
      {"1..2", "two decimal points in a number"},
      {"1.000,5", "two decimal points in a number"},
      {"2 3", "\"3\" is not expected here"},
      {"*3", "\"*\" is not expected here"},
      {"sqrt(-1)", "the root of a negative number"},
      {"sqrt 4", "\"(\" is missing after sqrt"},
      {"1e999", "a number is too large or too small"},
      {"9^999", "the result is not a number"},
      {"inf", "\"inf\" is not known"},
      {"nan", "\"nan\" is not known"},
  };
  for (const auto& [text, reason] : rows) {
    const Result<Typed> typed = evaluate(text, 1.0);
    ASSERT_FALSE(typed.ok()) << text;
    EXPECT_EQ(typed.error().reason, reason) << text;
  }
  for (const char open : {'(', '-'}) EXPECT_FALSE(evaluate(std::string(100000, open), 0.0).ok());
}

/// Random expression tree: its value is computed from the tree, its text is parsed.
struct Tree {
  char kind = 'n';  // 'n'umber, 'm'inus sign, else an operator.
  double number = 0.0;
  std::unique_ptr<Tree> left;
  std::unique_ptr<Tree> right;

  [[nodiscard]] double value() const {
    if (kind == 'n') return number;
    if (kind == 'm') return -left->value();
    const double a = left->value();
    const double b = right->value();
    if (kind == '/') return b == 0.0 ? std::nan("") : a / b;  // Refused, whatever follows.
    return kind == '+' ? a + b : (kind == '-' ? a - b : a * b);
  }
  /// Precedence.
  [[nodiscard]] int rank() const { return kind == 'n' ? 3 : (kind == 'm' ? 2 : (kind == '+' || kind == '-' ? 0 : 1)); }
  [[nodiscard]] std::string text(std::mt19937& random) const {
    const auto part = [&](const Tree& tree, int least) {
      const std::string inner = tree.text(random);
      return tree.rank() < least || random() % 4 == 0 ? "(" + inner + ")" : inner;
    };
    const std::string space(random() % 3, ' ');
    if (kind == 'm') return "-" + part(*left, 2);
    if (kind != 'n') return part(*left, rank()) + space + kind + space + part(*right, rank() + 1);
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, number);
    return {digits, end.ptr};
  }
};

std::unique_ptr<Tree> randomTree(std::mt19937& random, int depth) {
  auto tree = std::make_unique<Tree>();
  if (depth == 0 || random() % 4 == 0) {
    tree->number = std::uniform_real_distribution<double>(0.1, 20.0)(random);
    if (random() % 2 == 0) tree->number = std::round(tree->number) + 1.0;
    return tree;
  }
  tree->kind = "+-*/m"[random() % 5];
  tree->left = randomTree(random, depth - 1);
  if (tree->kind != 'm') tree->right = randomTree(random, depth - 1);
  return tree;
}

TEST(Expression, RandomExpressionsMatchTheirTrees) {
  std::mt19937 random(5);
  int finite = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto tree = randomTree(random, 5);
    const double wanted = tree->value();
    const std::string text = tree->text(random);
    const Result<Typed> typed = evaluate(text, 0.0);
    if (!std::isfinite(wanted)) continue;
    ASSERT_TRUE(typed.ok()) << text << ": " << typed.error().reason;
    ASSERT_EQ(typed->value, wanted) << text;
    ++finite;
  }
  EXPECT_GT(finite, 2900);
}

TEST(Expression, ArbitraryTextIsANumberOrAnError) {
  std::mt19937 random(6);
  const std::string letters = "0123456789.,+-*/^()= episqrtx%\xc2\xb0";
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t n = random() % 12; n > 0; --n) text += letters[random() % letters.size()];
    const Result<Typed> typed = evaluate(text, 3.0);
    if (typed) EXPECT_TRUE(std::isfinite(typed->value)) << text;
    else EXPECT_FALSE(typed.error().reason.empty()) << text;
  }
}

TEST(Expression, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
    std::setlocale(LC_NUMERIC, locale);
    EXPECT_EQ(valueOf("0.25*2"), 0.5);
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

}  // namespace
}  // namespace sinew::app
