// Promises of cli/batch/shard.h.
#include "cli/batch/shard.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "terrain/error.h"

namespace terrview {
namespace {

using Variables = std::map<std::string, std::string>;

Shard found(const std::string& text, const Variables& variables = {}) {
  return find_shard(text, [&](const char* name) {
    const auto variable = variables.find(name);
    return variable == variables.end() ? nullptr : variable->second.c_str();
  });
}

Variables slurm(const std::string& id, const std::string& first, const std::string& step,
                const std::string& count) {
  return {{"SLURM_ARRAY_TASK_ID", id},
          {"SLURM_ARRAY_TASK_MIN", first},
          {"SLURM_ARRAY_TASK_STEP", step},
          {"SLURM_ARRAY_TASK_COUNT", count}};
}

RC_GTEST_PROP(ShardProperty, EveryJobIsInOneShardAndShardsAreEven, ()) {
  const int count = *rc::gen::inRange(1, 40);
  const int jobs = *rc::gen::inRange(1, 200);
  std::vector<int> sizes(static_cast<std::size_t>(count));
  for (int job = 1; job <= jobs; ++job) {
    int owners = 0;
    for (int number = 0; number < count; ++number) {
      if (!Shard{number, count}.has(job)) continue;
      ++owners;
      ++sizes[static_cast<std::size_t>(number)];
    }
    RC_ASSERT(owners == 1);
  }
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  RC_ASSERT(*most - *least <= 1);
}

TEST(Shard, IsWhatTheOptionSays) {
  EXPECT_EQ(found("3/8").number, 3);
  EXPECT_EQ(found("3/8").count, 8);
  EXPECT_EQ(found("").count, 1);
  EXPECT_EQ(found("2/3", slurm("5", "1", "1", "8")).number, 2);
  for (const std::string text : {"8/8", "-1/8", "a/8", "1/", "/8", "1/0", "1/8x", "x", "0"})
    EXPECT_THROW(static_cast<void>(found(text)), InputError) << text;
}

TEST(Shard, IsThatOfASlurmArrayByItself) {
  const Shard shard = found("", slurm("7", "1", "2", "4"));
  EXPECT_EQ(shard.number, 3);
  EXPECT_EQ(shard.count, 4);
  EXPECT_EQ(found("", slurm("0", "0", "1", "8")).number, 0);
}

TEST(Shard, OfAnArrayWithGapsIsRefused) {
  EXPECT_THROW(static_cast<void>(found("", slurm("7", "1", "1", "3"))), InputError);
  EXPECT_THROW(static_cast<void>(found("", slurm("6", "1", "2", "4"))), InputError);
  EXPECT_THROW(static_cast<void>(found("", slurm("x", "1", "2", "4"))), InputError);
}

TEST(Shard, OfAKubernetesIndexedJobNeedsN) {
  const Variables kubernetes{{"JOB_COMPLETION_INDEX", "5"}};
  EXPECT_EQ(found("", kubernetes).count, 1);
  EXPECT_EQ(found("8", kubernetes).number, 5);
  EXPECT_EQ(found("8", kubernetes).count, 8);
  EXPECT_THROW(static_cast<void>(found("5", kubernetes)), InputError);
  EXPECT_THROW(static_cast<void>(found("8")), InputError);
}

}  // namespace
}  // namespace terrview
