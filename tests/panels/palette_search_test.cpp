// tests/panels/palette_search_test.cpp: the best match of a few letters comes first.

#include "app/panels/palette_search.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace sinew::app {
namespace {

std::vector<std::string> found(const std::string& query, const std::vector<Candidate>& candidates) {
  std::vector<std::string> labels;
  for (const Found& one : search(query, candidates, 100)) labels.push_back(candidates[one.index].label);
  return labels;
}

std::vector<Candidate> named(const std::vector<std::string>& labels) {
  std::vector<Candidate> candidates;
  for (const std::string& label : labels) candidates.push_back({label, "", -1, true});
  return candidates;
}

TEST(PaletteSearch, MatchesLettersInOrder) {
  EXPECT_TRUE(fitOf("smn", "Select nothing") == std::nullopt);
  EXPECT_TRUE(fitOf("sn", "Select nothing").has_value());
  EXPECT_TRUE(fitOf("SELECT", "select nothing").has_value());
  EXPECT_FALSE(fitOf("nothings", "nothing").has_value());
  EXPECT_TRUE(fitOf("", "anything").has_value());
  EXPECT_TRUE(fitOf("  ", "anything").has_value());
  EXPECT_FALSE(fitOf("a", "").has_value());
}

TEST(PaletteSearch, MatchesWordsInAnyOrder) {
  EXPECT_TRUE(fitOf("left thigh", "thigh left").has_value());
  EXPECT_FALSE(fitOf("left arm", "thigh left").has_value());
}

TEST(PaletteSearch, MarksAreTheMatchedLetters) {
  const auto fit = fitOf("sk", "Skeleton");
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->marks, (std::vector<std::size_t>{0, 1}));
  const auto initials = fitOf("fs", "Frame selection");
  ASSERT_TRUE(initials.has_value());
  EXPECT_EQ(initials->marks, (std::vector<std::size_t>{0, 6}));
}

TEST(PaletteSearch, WordStartBeatsWordMiddle) {
  EXPECT_EQ(found("wi", named({"Show wide", "Wire", "Swim"})).front(), "Wire");
  EXPECT_EQ(found("sa", named({"Mesa", "Save as..."})).front(), "Save as...");
  EXPECT_EQ(found("redo", named({"Reverse direction of", "Redo"})).front(), "Redo");
  EXPECT_EQ(found("ll", named({"ball", "LeftLeg"})).front(), "LeftLeg");
}

TEST(PaletteSearch, ContiguousLettersBeatScatteredLetters) {
  EXPECT_EQ(found("tend", named({"To the end", "semitendinosus", "Tendon at the origin"})),
            (std::vector<std::string>{"Tendon at the origin", "To the end", "semitendinosus"}));
}

TEST(PaletteSearch, ExactNameBeatsALongerName) {
  EXPECT_EQ(found("spine", named({"spine upper", "Spine"})).front(), "Spine");
}

TEST(PaletteSearch, LabelOutweighsContext) {
  std::vector<Candidate> candidates{{"glute L", "Muscle on hips", -1, true}, {"hips", "Bone", -1, true}};
  EXPECT_EQ(found("hips", candidates), (std::vector<std::string>{"hips", "glute L"}));
  EXPECT_EQ(found("muscle", candidates), (std::vector<std::string>{"glute L"}));
}

TEST(PaletteSearch, EmptyQueryListsRecentEntriesThenTableOrder) {
  std::vector<Candidate> candidates{{"a", "", -1, true}, {"b", "", 1, true}, {"c", "", -1, true}, {"d", "", 0, true}};
  EXPECT_EQ(found("", candidates), (std::vector<std::string>{"d", "b", "a", "c"}));
}

TEST(PaletteSearch, RecentEntryWinsATie) {
  std::vector<Candidate> candidates{{"Left", "", -1, true}, {"Lift", "", 2, true}};
  EXPECT_EQ(found("l", candidates).front(), "Lift");
}

TEST(PaletteSearch, UnavailableEntryRanksLowerThanASimilarMatch) {
  std::vector<Candidate> candidates{{"Undo", "", 0, false}, {"Sound", "", -1, true}, {"Undone", "", -1, true}};
  EXPECT_EQ(found("und", candidates), (std::vector<std::string>{"Undone", "Undo", "Sound"}));
  EXPECT_EQ(found("undo", candidates), (std::vector<std::string>{"Undone", "Undo"}));
  EXPECT_EQ(found("", candidates), (std::vector<std::string>{"Sound", "Undone", "Undo"}));
}

TEST(PaletteSearch, AvailableEntryWinsATie) {
  std::mt19937 random(8);
  for (int round = 0; round < 100; ++round) {
    std::vector<Candidate> candidates;
    for (int i = 0; i < 6; ++i)
      candidates.push_back({"Delete", "", static_cast<int>(random() % 9) - 1, random() % 2 == 0});
    for (const char* query : {"", "del", "delete"}) {
      bool grayed = false;
      for (const Found& one : search(query, candidates, 100)) {
        EXPECT_FALSE(grayed && candidates[one.index].usable) << query;
        grayed = grayed || !candidates[one.index].usable;
      }
    }
  }
}

TEST(PaletteSearch, UnavailableEntryIsNeverPreselected) {
  std::mt19937 random(9);
  int none = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<Candidate> candidates;
    for (int i = 0; i < 5; ++i) {
      std::string label;
      for (unsigned c = 0; c < 3 + random() % 5; ++c) label.push_back(static_cast<char>('a' + random() % 3));
      candidates.push_back({label, "", -1, random() % 2 == 0});
    }
    const std::vector<Found> all = search("ab", candidates, 100);
    const int row = preselected(all, candidates);
    none += row < 0 ? 1 : 0;
    if (row < 0) continue;
    EXPECT_TRUE(candidates[all[static_cast<std::size_t>(row)].index].usable);
    for (int above = 0; above < row; ++above) {
      EXPECT_FALSE(candidates[all[static_cast<std::size_t>(above)].index].usable) << "not the first that can be done";
    }
  }
  EXPECT_GT(none, 10);
  EXPECT_LT(none, 490);
}

TEST(PaletteSearch, NothingIsPreselectedIfTheBestMatchIsUnavailable) {
  const std::vector<Candidate> candidates{{"Duplicate", "Edit", -1, false}, {"odd cup hole", "Muscle", -1, true}};
  const std::vector<Found> all = search("dupl", candidates, 100);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].index, 1u);
  EXPECT_EQ(preselected(all, candidates), -1);
}

TEST(PaletteSearch, ScatteredMatchBeforeAnUnavailableEntryIsNotPreselected) {
  std::vector<Candidate> candidates = named({"Edit territory", "End the range here"});
  candidates[0].usable = false;
  const std::vector<Found> found = search("terr", candidates, 10);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].index, 1u);
  EXPECT_EQ(preselected(found, candidates), -1);
}

TEST(PaletteSearch, ReturnsNoMoreThanTheLimit) { EXPECT_EQ(search("", named({"a", "b", "c"}), 2).size(), 2u); }

TEST(PaletteSearch, TextMatchesItselfBestAndMarksSpellTheQuery) {
  std::mt19937 random(5);
  for (int round = 0; round < 500; ++round) {
    std::string text;
    for (unsigned i = 0; i < 1 + random() % 20; ++i) text.push_back(static_cast<char>('a' + random() % 4));
    std::string query;
    for (const char c : text) {
      if (random() % 2 == 0) query.push_back(c);
    }
    const auto fit = fitOf(query, text);
    ASSERT_TRUE(fit.has_value()) << query << " in " << text;
    std::string marked;
    for (const std::size_t mark : fit->marks) marked.push_back(text.at(mark));
    EXPECT_EQ(marked, query);
    EXPECT_GE(fitOf(text, text)->score, fit->score);
  }
}

}  // namespace
}  // namespace sinew::app
