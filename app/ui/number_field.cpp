// app/ui/number_field.cpp: arithmetic, and number fields on ImGui's drags.
#include "app/ui/number_field.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <imgui_internal.h>  // Typing state and the rest of a drag, which 1.86 keeps internal.

namespace sinew::app {

namespace {

constexpr int kDeepest = 64;  ///< Nested brackets and signs.
constexpr std::string_view kUnits[] = {"%", "\xc2\xb0", "deg", "x"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0; }
bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isSpace(text.front())) text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back())) text.remove_suffix(1);
  return text;
}

/// Recursive descent that calculates at once. After the first error every part gives 0.
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

  bool take(char c) {
    skipSpaces();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

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

namespace {

constexpr float kPrecise = 0.1f;  ///< Factor on a drag with Shift.

/// Hides Shift, Alt and Ctrl from ImGui, which gives them other meanings in these fields.
class ModifiersUp {
 public:
  explicit ModifiersUp(bool typing) : io_(ImGui::GetIO()), typing_(typing) {
    if (typing_) return;
    ctrl_ = std::exchange(io_.KeyCtrl, false);
    shift_ = std::exchange(io_.KeyShift, false);
    alt_ = std::exchange(io_.KeyAlt, false);
    io_.ConfigDragClickToInputText = ctrl_;
  }
  ~ModifiersUp() {
    if (typing_) return;
    io_.KeyCtrl = ctrl_;
    io_.KeyShift = shift_;
    io_.KeyAlt = alt_;
    io_.ConfigDragClickToInputText = false;
  }
  ModifiersUp(const ModifiersUp&) = delete;
  ModifiersUp& operator=(const ModifiersUp&) = delete;

 private:
  ImGuiIO& io_;
  bool typing_;
  bool ctrl_ = false;
  bool shift_ = false;
  bool alt_ = false;
};

float stepOf(const NumberLook& look, const ImGuiIO& io) {
  const float step = io.KeyCtrl ? look.step * (io.KeyShift ? kPrecise : 1.0f) : 0.0f;
  return look.whole ? std::max(std::round(step), 1.0f) : step;
}

/// Fraction of the range, 0 to 1.
float fractionOf(float value, const NumberLook& look) {
  if (look.logarithmic) return std::log(value / look.least) / std::log(look.most / look.least);
  return (value - look.least) / (look.most - look.least);
}

void drawBar(Ui& ui, float fraction) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high{low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()};
  const float end = low.x + std::clamp(fraction, 0.0f, 1.0f) * (high.x - low.x);
  const float edge = std::min(ui.px(2), end - low.x);
  const float rounding = ImGui::GetStyle().FrameRounding;
  const bool lit = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ImGui::GetColorU32(lit ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), rounding);
  list.PushClipRect(low, {end, high.y}, true);
  list.AddRectFilled(low, high, palette::kAccent.faded(lit ? 0.34f : 0.26f).packed(), rounding);
  list.PopClipRect();
  // A short stroke at the lower edge marks the end.
  list.AddRectFilled({end - edge, high.y - ui.px(5)}, {end, high.y}, ImGui::GetColorU32(palette::kAccent));
}

/// A frame around a field with a mistake, and the reason below.
void drawMistake(const ImRect& box, const std::string& reason) {
  ImGui::GetWindowDrawList()->AddRect(box.Min, box.Max, palette::kWarning.packed(), ImGui::GetStyle().FrameRounding);
  ImGui::SetNextWindowPos({box.Min.x, box.Max.y + 0.25f * ImGui::GetFontSize()});
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(reason.c_str());
  ImGui::EndTooltip();
}

/// A text field in place of the number, because ImGui's own reads single numbers only. @return the text
std::string textField(const char* label, ImGuiID id, const ImRect& box) {
  constexpr int kLongest = 128;
  ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
  if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable)) return {};
  // ImGui's buffer has room for one number.
  ImVector<ImWchar>& room = ImGui::GetCurrentContext()->InputTextState.TextW;
  if (room.Size <= kLongest) room.resize(kLongest + 1);
  char text[kLongest] = "";
  ImGui::TempInputText(box, id, label, text, kLongest, ImGuiInputTextFlags_NoMarkEdited);
  return text;
}

/// @param begun  the value before typing
float typedValue(const char* label, ImGuiID id, float begun, const NumberLook& look) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImRect box(low, {low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()});
  Typing ignored;
  Typing& typing = look.typing != nullptr ? *look.typing : ignored;
  const std::string text = textField(label, id, box);
  typing = {true, {}};
  // Unchanged text keeps the value, whatever its digits round to.
  if (text == ImGui::GetCurrentContext()->InputTextState.InitialTextA.Data) return begun;
  const Result<Typed> typed = evaluate(text, static_cast<double>(begun));
  if (!typed) {
    const std::string reason = '"' + text + "\" gives no number: " + typed.error().reason;
    if (ImGui::IsItemDeactivated()) typing.refusal = reason;
    else drawMistake(box, typed.error().reason);
    return begun;
  }
  typing.relative = typed->relative;
  const auto value = static_cast<float>(typed->value);
  return look.clampTyped ? std::clamp(value, look.least, look.most) : value;
}

}  // namespace

std::string numberText(const char* format, float value) {
  char text[64];
  std::snprintf(text, sizeof text, format, static_cast<double>(value));
  return text;
}

float toStep(float value, float step, float least, float most) {
  if (!(step > 0.0f)) return value;
  return std::clamp(std::round(value / step) * step, least, most);
}

bool numberField(const char* label, float& value, const NumberLook& look) {
  const ImGuiID id = ImGui::GetID(label);
  const bool typing = ImGui::TempInputIsActive(id);
  const ImGuiIO& io = ImGui::GetIO();
  const float step = stepOf(look, io);
  const float speed = look.speed * (io.KeyShift && !look.whole ? kPrecise : 1.0f);
  ImGuiSliderFlags flags = ImGuiSliderFlags_NoRoundToFormat;
  if (look.clampTyped) flags |= ImGuiSliderFlags_AlwaysClamp;
  if (look.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
  const float before = value;
  ImGuiStorage& begun = *ImGui::GetStateStorage();
  if (typing) {
    value = typedValue(label, id, begun.GetFloat(id, value), look);
    if (value != before) ImGui::MarkItemEdited(id);
  } else {
    const ModifiersUp up(typing);
    ImGui::DragFloat(label, &value, speed, look.least, look.most, look.format, flags);
    if (ImGui::TempInputIsActive(id)) begun.SetFloat(id, before);
  }
  const bool dragged = ImGui::GetActiveID() == id && !ImGui::TempInputIsActive(id);
  if (dragged && step > 0.0f && value != before) {
    const float wanted = value;
    value = toStep(wanted, step, look.least, look.most);
    // The rest counts with the next movement, in ImGui's unit.
    float left = wanted - value;
    if (look.logarithmic) left = fractionOf(wanted, look) - fractionOf(value, look);
    ImGui::GetCurrentContext()->DragCurrentAccum += left;
  } else if (look.whole) {
    value = toStep(value, 1.0f, look.least, look.most);
  }
  return value != before;
}

bool numberSlider(Ui& ui, const char* label, float& value, const NumberLook& look) {
  drawBar(ui, fractionOf(value, look));
  constexpr ImGuiCol kFrames[] = {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive};
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID(label));
  if (!typing) {
    for (const ImGuiCol frame : kFrames) ImGui::PushStyleColor(frame, palette::kAccent.faded(0.0f));
  }
  NumberLook slider = look;
  slider.speed = (look.most - look.least) / std::max(ImGui::CalcItemWidth(), 1.0f);
  const bool changed = numberField(label, value, slider);
  if (!typing) ImGui::PopStyleColor(static_cast<int>(std::size(kFrames)));
  return changed;
}

}  // namespace sinew::app
