// app/panels/palette_search.cpp: fuzzy search of short texts.

#include "app/panels/palette_search.h"

#include <algorithm>
#include <cctype>
#include <tuple>

#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

constexpr int kLetter = 1;
constexpr int kSideBySide = 6;
constexpr int kWordBegins = 8;
constexpr int kTextBegins = 6;
constexpr int kWholeText = 20;
constexpr int kPrefixOfWord = 20;   ///< Bonus for a word of the query that begins a word of the text ...
constexpr int kPartOfWord = 8;      ///< ... or is in it in one piece.
constexpr int kOnlyInContext = 24;  ///< Penalty if the label alone does not match.
constexpr int kRecentBonus = 4;     ///< For the one used last; one less for every five before.
constexpr int kUnusable = 6;        ///< Penalty for an unusable entry.
constexpr int kClearlyWorse = 8;    ///< A larger difference means that the other entry was meant.
constexpr int kWorst = -1000000;

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; }

bool beginsWord(std::string_view text, std::size_t at) {
  if (at == 0 || !isWordCharacter(text[at - 1])) return true;
  const auto upper = [&](std::size_t i) { return std::isupper(static_cast<unsigned char>(text[i])) != 0; };
  return upper(at) && !upper(at - 1);  // "LeftLeg"
}

int weightAt(std::string_view text, std::size_t at) {
  return kLetter + (beginsWord(text, at) ? kWordBegins : 0) + (at == 0 ? kTextBegins : 0);
}

/// The best match of a word's letters by dynamic programming; best[i][j]: score of the first i + 1, the last one at j.
std::optional<Fit> fitWord(std::string_view word, std::string_view text) {
  if (word.size() > text.size()) return std::nullopt;
  std::vector<std::vector<int>> best(word.size(), std::vector<int>(text.size(), kWorst));
  std::vector<std::vector<std::size_t>> from(word.size(), std::vector<std::size_t>(text.size(), 0));
  for (std::size_t i = 0; i < word.size(); ++i) {
    // Further bytes of a letter must follow its first byte.
    const bool continues = (static_cast<unsigned char>(word[i]) & 0xC0U) == 0x80U;
    int before = kWorst;  // The best of the letter before, anywhere left of j - 1.
    std::size_t beforeAt = 0;
    for (std::size_t j = i; j < text.size(); ++j) {
      if (i > 0 && !continues && j >= 2 && best[i - 1][j - 2] > before) {
        before = best[i - 1][j - 2];
        beforeAt = j - 2;
      }
      if (toLower(word[i]) != toLower(text[j])) continue;
      if (i == 0) {
        best[i][j] = weightAt(text, j);
        continue;
      }
      const int beside = best[i - 1][j - 1] == kWorst ? kWorst : best[i - 1][j - 1] + kSideBySide;
      const int most = std::max(beside, before);
      if (most == kWorst) continue;
      best[i][j] = most + weightAt(text, j);
      from[i][j] = beside >= before ? j - 1 : beforeAt;
    }
  }
  const auto last = std::ranges::max_element(best.back());
  if (*last == kWorst) return std::nullopt;
  Fit fit{*last, {}};
  auto at = static_cast<std::size_t>(last - best.back().begin());
  for (std::size_t i = word.size(); i-- > 0;) {
    fit.marks.push_back(at);
    at = from[i][at];
  }
  std::ranges::reverse(fit.marks);
  return fit;
}

/// The best match of the word in one piece.
std::optional<Fit> fitInOnePiece(std::string_view word, std::string_view text) {
  std::optional<Fit> best;
  if (word.size() < 2) return best;
  for (std::size_t at = 0; at + word.size() <= text.size(); ++at) {
    if (!std::ranges::equal(word, text.substr(at, word.size()), {}, toLower, toLower)) continue;
    Fit fit{beginsWord(text, at) ? kPrefixOfWord : kPartOfWord, {}};
    for (std::size_t i = 0; i < word.size(); ++i) {
      fit.score += weightAt(text, at + i) + (i > 0 ? kSideBySide : 0);
      fit.marks.push_back(at + i);
    }
    if (!best || fit.score > best->score) best = std::move(fit);
  }
  return best;
}

std::vector<std::string_view> wordsOf(std::string_view query) {
  std::vector<std::string_view> words;
  while (!query.empty()) {
    const std::size_t space = query.find(' ');
    if (space != 0) words.push_back(query.substr(0, space));
    if (space == std::string_view::npos) break;
    query.remove_prefix(space + 1);
  }
  return words;
}

bool sameText(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, toLower, toLower); }

/// Matches the label; else label, context and synonyms as one text.
std::optional<Fit> fitCandidate(std::string_view query, const Candidate& candidate) {
  if (std::optional<Fit> fit = fitOf(query, candidate.label)) return fit;
  std::optional<Fit> fit = fitOf(query, candidate.label + " " + candidate.context + " " + candidate.synonyms);
  if (!fit) return fit;
  fit->score -= kOnlyInContext;
  std::erase_if(fit->marks, [&](std::size_t mark) { return mark >= candidate.label.size(); });
  return fit;
}

}  // namespace

std::optional<Fit> fitOf(std::string_view query, std::string_view text) {
  Fit all;
  for (const std::string_view word : wordsOf(query)) {
    std::optional<Fit> fit = fitWord(word, text);
    if (!fit) return std::nullopt;
    if (std::optional<Fit> piece = fitInOnePiece(word, text); piece && piece->score > fit->score)
      fit = std::move(piece);
    all.score += fit->score;
    all.marks.insert(all.marks.end(), fit->marks.begin(), fit->marks.end());
  }
  if (!query.empty() && sameText(query, text)) all.score += kWholeText;
  std::ranges::sort(all.marks);
  const auto repeated = std::ranges::unique(all.marks);
  all.marks.erase(repeated.begin(), repeated.end());
  return all;
}

std::vector<Found> search(std::string_view query, const std::vector<Candidate>& candidates, std::size_t most) {
  struct Ranked {
    bool last;
    int score;
    bool grayed;
    std::size_t rank;  ///< Among equals.
    Found found;
  };
  const bool asked = !wordsOf(query).empty();
  std::vector<Ranked> ranked;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Candidate& candidate = candidates[i];
    std::optional<Fit> fit = fitCandidate(query, candidate);
    if (!fit) continue;
    const bool recent = candidate.recent >= 0;
    if (asked && recent) fit->score += std::max(kRecentBonus - candidate.recent / 5, 0);
    if (asked && !candidate.usable) fit->score -= kUnusable;
    if (asked) fit->score -= candidate.later;
    // Among equals, the shorter label first.
    const std::size_t rank =
        asked ? candidate.label.size() : (recent ? static_cast<std::size_t>(candidate.recent) : candidates.size() + i);
    ranked.push_back({!asked && !candidate.usable,
                      asked ? -fit->score : 0,
                      !candidate.usable,
                      rank,
                      {i, fit->score, std::move(fit->marks)}});
  }
  std::ranges::stable_sort(ranked, [](const Ranked& a, const Ranked& b) {
    return std::tie(a.last, a.score, a.grayed, a.rank) < std::tie(b.last, b.score, b.grayed, b.rank);
  });
  // An unusable entry never comes first.
  if (asked && !ranked.empty() && ranked.front().grayed) {
    const auto usable = std::ranges::find(ranked, false, &Ranked::grayed);
    if (usable != ranked.end()) std::rotate(ranked.begin(), usable, usable + 1);
  }
  std::vector<Found> found;
  for (Ranked& entry : ranked) {
    if (found.size() == most) break;
    found.push_back(std::move(entry.found));
  }
  return found;
}

int preselected(const std::vector<Found>& found, const std::vector<Candidate>& candidates) {
  const auto isUsable = [&](const Found& entry) { return candidates[entry.index].usable; };
  const auto usable = std::ranges::find_if(found, isUsable);
  if (usable == found.end()) return -1;
  int best = usable->score;
  for (const Found& entry : found) best = std::max(best, entry.score + (isUsable(entry) ? 0 : kUnusable));
  return usable->score + kClearlyWorse < best ? -1 : static_cast<int>(usable - found.begin());
}

}  // namespace sinew::app
