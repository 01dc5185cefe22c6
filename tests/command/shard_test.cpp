// tests/command/shard_test.cpp: the fraction of a job that an array task takes from its environment.
#include "app/command/verbs.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

class ShardOfAnArray : public testing::Test {
 protected:
  void TearDown() override {
    for (const char* name : {"ID", "MIN", "MAX", "STEP", "COUNT"}) ::unsetenv(variable(name).c_str());
  }
  static std::string variable(const char* name) { return std::string("SLURM_ARRAY_TASK_") + name; }
  static void set(const char* name, const char* value) { ::setenv(variable(name).c_str(), value, 1); }
};

TEST_F(ShardOfAnArray, IsCountedFromItsFirstTask) {
  set("ID", "6");
  set("MIN", "2");
  set("MAX", "10");
  set("STEP", "2");
  set("COUNT", "5");
  const auto shard = shardOf("auto");
  ASSERT_TRUE(shard.ok()) << shard.error().text();
  EXPECT_EQ(shard->index, 2);
  EXPECT_EQ(shard->count, 5);
}

TEST_F(ShardOfAnArray, ArrayWithGapsIsRefused) {
  set("ID", "6");
  set("MIN", "2");
  set("MAX", "10");
  set("COUNT", "3");
  EXPECT_FALSE(shardOf("auto").ok()) << "tasks of the gaps would be missing";
}

}  // namespace
}  // namespace sinew::app
