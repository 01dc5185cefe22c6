// app/panels/palette_search.h: fuzzy search of the palette's entries.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::app {

/// How well a text matches a query.
struct Fit {
  int score = 0;                   ///< Greater is better.
  std::vector<std::size_t> marks;  ///< Bytes of the text that match the query's letters, ascending.
};

/// Every word of the query must be in the text, its letters in order but not necessarily adjacent; case does not
/// matter. Adjacent letters and beginnings of words and of the text score higher. An empty query matches with score 0.
[[nodiscard]] std::optional<Fit> fitOf(std::string_view query, std::string_view text);

struct Candidate {
  std::string label;    ///< Searched first.
  std::string context;  ///< "View", "Muscle on thigh.L": also searched, scores lower.
  int recent = -1;      ///< 0: used last, 1: the one before ...; -1: not recently.
  bool usable = true;
  std::string synonyms = {};  ///< Searched like the context, not shown.
  int later = 0;              ///< Subtracted from the score, so that files come after actions.
};

struct Found {
  std::size_t index = 0;           ///< Into the candidates.
  int score = 0;                   ///< Greater is better.
  std::vector<std::size_t> marks;  ///< In the label.
};

/// Matching candidates, best first; unusable ones come after equally good matches but before bad ones, and never first.
/// Without a query: recently used ones, then the others in order, then unusable ones. At most `most`.
[[nodiscard]] std::vector<Found> search(std::string_view query, const std::vector<Candidate>& candidates,
                                        std::size_t most);

/// The row that Enter takes unless another is chosen: the first usable one. -1 if there is none, or if an unusable one
/// matches clearly better: Enter must not do something else instead.
[[nodiscard]] int preselected(const std::vector<Found>& found, const std::vector<Candidate>& candidates);

}  // namespace sinew::app
