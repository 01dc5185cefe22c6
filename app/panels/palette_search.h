// app/panels/palette_search.h: which entries of the palette fit what was typed, best first.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::app {

/// How well a text fits a query.
struct Fit {
  int score = 0;                   ///< Greater is better.
  std::vector<std::size_t> marks;  ///< Bytes of the text that the query's letters stand at, ascending.
};

/// Every word of the query must be in the text, its letters in order but not side by side; case does not count.
/// Letters side by side, at the beginning of words and of the text weigh more. An empty query fits with score 0.
[[nodiscard]] std::optional<Fit> fitOf(std::string_view query, std::string_view text);

/// Something to be found.
struct Candidate {
  std::string label;    ///< What is read and searched first.
  std::string context;  ///< "View", "Muscle on thigh.L": searched as well, weighs less.
  int recent = -1;      ///< 0: used last, 1: the one before ...; -1: not lately.
  bool usable = true;
  std::string synonyms = {};  ///< Searched like the context, not shown.
  int later = 0;              ///< Score less than an equally good fit: files stand behind actions.
};

struct Found {
  std::size_t index = 0;           ///< Into the candidates.
  int score = 0;                   ///< Greater is better.
  std::vector<std::size_t> marks;  ///< In the label.
};

/// Fitting candidates, best first; what cannot be used now comes after what fits as well, but stays above what fits
/// badly. Without a query: lately used ones, then the others as they stand, at last what cannot be used. At most
/// `most`.
[[nodiscard]] std::vector<Found> search(std::string_view query, const std::vector<Candidate>& candidates,
                                        std::size_t most);

/// The row that Enter takes unless another is chosen: the first that can be used. -1 if there is none, or if it fits
/// clearly worse than one that cannot be used, which is what was meant: Enter never does something else instead.
[[nodiscard]] int preselected(const std::vector<Found>& found, const std::vector<Candidate>& candidates);

}  // namespace sinew::app
