// core/character/name_words.cpp: words in names.
#include "core/character/name_words.h"

#include "core/geometry/lower_case.h"

namespace sinew {
namespace {

bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isLetter(char c) { return isUpper(c) || (c >= 'a' && c <= 'z'); }

}  // namespace

std::string lettersOf(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (isLetter(c)) letters.push_back(toLower(c));
  }
  return letters;
}

std::vector<std::string> wordsOf(std::string_view name) {
  std::vector<std::string> words;
  bool inWord = false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!isLetter(name[i])) {
      inWord = false;
      continue;
    }
    const bool capital = i > 0 && isUpper(name[i]) && isLetter(name[i - 1]) && !isUpper(name[i - 1]);
    if (!inWord || capital) words.emplace_back();
    words.back().push_back(toLower(name[i]));
    inWord = true;
  }
  return words;
}

}  // namespace sinew
