// app/ui/expression.cpp: a descent through sums, products, signs and powers.

#include "app/ui/expression.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace sinew::app {
namespace {

constexpr int kDeepest = 64;  ///< Brackets and signs within one another.
constexpr std::string_view kUnits[] = {"%", "\xc2\xb0", "deg", "x"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

/// Parses and calculates at once. After the first mistake every part gives 0 and the reason stays.
class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  Result<double> whole() {
    const double value = sum();
    skipSpaces();
    if (!wrong_ && !rest_.empty()) unexpected();
    if (wrong_) return errorAt("", *wrong_);
    if (!std::isfinite(value)) return errorAt("", "the result is not a number");
    return value;
  }

 private:
  double fail(const std::string& reason) {
    if (!wrong_) wrong_ = reason;
    rest_ = {};
    return 0.0;
  }

  double unexpected() {
    if (rest_.empty()) return fail("a number is missing at the end");
    if (rest_.front() == ')') return fail("\")\" without \"(\"");
    std::size_t length = 1;
    while (length < rest_.size() && isLetter(rest_.front()) && isLetter(rest_[length])) ++length;
    const std::string found(rest_.substr(0, length));
    return fail(isLetter(found.front()) ? "\"" + found + "\" is not known" : "\"" + found + "\" is not expected here");
  }

  void skipSpaces() {
    while (!rest_.empty() && isSpace(rest_.front())) rest_.remove_prefix(1);
  }

  /// Takes the next character if it is `c`.
  bool take(char c) {
    skipSpaces();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  /// Takes a whole word.
  bool takeWord(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    if (rest_.size() > word.size() && isLetter(rest_[word.size()])) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  double sum() {
    double value = product();
    while (!wrong_) {
      if (take('+')) value += product();
      else if (take('-')) value -= product();
      else break;
    }
    return value;
  }

  double product() {
    double value = signedPower();
    while (!wrong_) {
      if (take('*')) {
        value *= signedPower();
      } else if (take('/')) {
        const double divisor = signedPower();
        if (divisor == 0.0 && !wrong_) return fail("division by zero");
        value /= divisor;
      } else {
        break;
      }
    }
    return value;
  }

  /// -2^2 is -4; 2^-1 is 0.5; 2^3^2 is 2^9.
  double signedPower() {
    if (++depth_ > kDeepest) return fail("too many brackets and signs");
    double value = 0.0;
    if (take('-')) {
      value = -signedPower();
    } else if (take('+')) {
      value = signedPower();
    } else {
      value = atom();
      if (take('^')) value = std::pow(value, signedPower());
    }
    --depth_;
    return value;
  }

  double atom() {
    skipSpaces();
    if (take('(')) return closed(sum());
    if (takeWord("pi")) return std::numbers::pi;
    if (takeWord("sqrt")) {
      if (!take('(')) return fail("\"(\" is missing after sqrt");
      const double value = closed(sum());
      return value < 0.0 ? fail("the root of a negative number") : std::sqrt(value);
    }
    return number();
  }

  double closed(double value) {
    if (wrong_ || take(')')) return value;
    return rest_.empty() ? fail("\")\" is missing") : unexpected();
  }

  double number() {
    if (rest_.empty() || !(isDigit(rest_.front()) || rest_.front() == '.' || rest_.front() == ',')) return unexpected();
    std::string text(rest_);
    if (const std::size_t comma = text.find_first_not_of("0123456789"); comma < text.size() && text[comma] == ',') {
      text[comma] = '.';
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) return fail("a number is too large or too small");
    if (error != std::errc()) return unexpected();
    rest_.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!rest_.empty() && (rest_.front() == '.' || rest_.front() == ',')) return fail("two decimal points in a number");
    return value;
  }

  std::string_view rest_;
  std::optional<std::string> wrong_;
  int depth_ = 0;
};

std::string_view withoutUnit(std::string_view text) {
  for (const std::string_view unit : kUnits) {
    if (text.size() > unit.size() && text.ends_with(unit)) return trimmed(text.substr(0, text.size() - unit.size()));
  }
  return text;
}

}  // namespace

Result<Typed> evaluate(std::string_view text, double current) {
  text = withoutUnit(trimmed(text));
  if (text.empty()) return errorAt("", "a number is missing");
  constexpr std::string_view kOperators = "+-*/";
  const bool relative = text.size() >= 2 && text[1] == '=' && kOperators.find(text[0]) != kOperators.npos;
  const Result<double> right = Parser(relative ? text.substr(2) : text).whole();
  if (!right) return right.error();
  double value = right.value();
  if (relative) {
    if (text[0] == '/' && value == 0.0) return errorAt("", "division by zero");
    if (text[0] == '+') value = current + value;
    else if (text[0] == '-') value = current - value;
    else if (text[0] == '*') value = current * value;
    else value = current / value;
    if (!std::isfinite(value)) return errorAt("", "the result is not a number");
  }
  return Typed{value, relative};
}

}  // namespace sinew::app
