// tests/support/surface/prepared_in_turn.h: rigs prepared one after the other, to see what is kept.
#pragma once

#include <gtest/gtest.h>

#include "core/surface/preparation.h"

namespace sinew::test {

class PreparedInTurn {
 public:
  explicit PreparedInTurn(std::shared_ptr<const Character> character)
      : tables_(characterTables(std::move(character))) {}

  std::shared_ptr<const Preparation> next(const Rig& rig, std::span<const int> hidden = {}) {
    PreparationOptions options;
    options.hidden = hidden;
    auto made = prepare(tables_, rig, options, last_.get(), graphs_);
    EXPECT_TRUE(made.ok());
    if (made) last_ = std::move(made).value();
    return last_;
  }

 private:
  std::shared_ptr<const CharacterTables> tables_;
  std::shared_ptr<const Preparation> last_;
  BlendingGraphMemo graphs_;
};

}  // namespace sinew::test
