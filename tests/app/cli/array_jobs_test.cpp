// Shards that take their number from the variables of schedulers.
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace array_jobs_test {

class ArrayJobs : public SevenPeople {
 protected:
  void TearDown() override {
    for (const std::string& name : set_) ::unsetenv(name.c_str());
  }
  /// Sets the variables of "A=1 B=2" and no others, and runs `tune` with these options.
  Answer tuneWith(const std::string& variables, const std::string& options) {
    TearDown();
    set_.clear();
    std::istringstream in(variables);
    for (std::string pair; in >> pair;) {
      const auto equals = pair.find('=');
      set_.push_back(pair.substr(0, equals));
      ::setenv(set_.back().c_str(), pair.substr(equals + 1).c_str(), 1);
    }
    return run("tune " + scene_ + " --recordings" + recordings_ + " --margins 0.1 --json " + options);
  }
  /// Numbers of the people that were run: "036".
  std::string peopleWith(const std::string& variables, const std::string& options) {
    const Answer a = tuneWith(variables, options);
    EXPECT_EQ(a.code, 0) << variables << ": " << a.err;
    const json answer = json::parse(a.out, nullptr, false);
    std::string people;
    if (a.code != 0) return people;
    for (const json& input : answer["inputs"]) {
      const std::string name = input["recording"];
      people += name[name.find("person") + 6];
    }
    return people;
  }

 private:
  std::vector<std::string> set_;
};

TEST_F(ArrayJobs, EachSchedulerNamesItsShard) {
  // Shard 3 of 3: people 2 and 5; shard 1: people 0, 3 and 6.
  EXPECT_EQ(peopleWith("SLURM_ARRAY_TASK_ID=7 SLURM_ARRAY_TASK_MIN=5", "--shard /3"), "25");
  EXPECT_EQ(peopleWith("SLURM_ARRAY_TASK_ID=9 SLURM_ARRAY_TASK_MIN=5 SLURM_ARRAY_TASK_STEP=2", "--shard /3"),
            "25");
  EXPECT_EQ(peopleWith("SGE_TASK_ID=3", "--shard /3"), "25");
  EXPECT_EQ(peopleWith("SGE_TASK_ID=14 SGE_TASK_FIRST=10 SGE_TASK_LAST=14 SGE_TASK_STEPSIZE=2", "--shard /3"),
            "25");
  EXPECT_EQ(peopleWith("PBS_ARRAY_INDEX=1", "--shard /3"), "036");
  EXPECT_EQ(peopleWith("PBS_ARRAYID=3", "--shard /3"), "25");
  EXPECT_EQ(peopleWith("LSB_JOBINDEX=3", "--shard /3"), "25");
  EXPECT_EQ(peopleWith("PARALLEL_SEQ=1", "--shard /3"), "036");
}

TEST_F(ArrayJobs, OnlySchedulersThatCountTheirTasksNeedNoShard) {
  EXPECT_EQ(peopleWith("SLURM_ARRAY_TASK_ID=0 SLURM_ARRAY_TASK_MIN=0 SLURM_ARRAY_TASK_COUNT=3", ""), "036");
  EXPECT_EQ(peopleWith("SGE_TASK_ID=3 SGE_TASK_FIRST=1 SGE_TASK_LAST=3 SGE_TASK_STEPSIZE=1", ""), "25");
  EXPECT_EQ(peopleWith("SGE_TASK_ID=undefined SGE_TASK_LAST=undefined", ""), "0123456") << "no array";
  for (const char* alone : {"PBS_ARRAY_INDEX=2", "PBS_ARRAYID=2", "LSB_JOBINDEX=2", "PARALLEL_SEQ=2"})
    EXPECT_EQ(peopleWith(alone, ""), "0123456") << alone << ": nothing says how many tasks there are";
}

TEST_F(ArrayJobs, PrecedenceAndConflicts) {
  EXPECT_EQ(peopleWith("LSB_JOBINDEX=3 PARALLEL_SEQ=1", "--shard /3"), "25") << "of the submitting shell";
  EXPECT_EQ(peopleWith("LSB_JOBINDEX=0 PARALLEL_SEQ=1", "--shard /3"), "036")
      << "an LSF job without an array";
  EXPECT_EQ(peopleWith("PBS_ARRAY_INDEX=3 PBS_ARRAYID=3", "--shard /3"), "25") << "they agree";
  EXPECT_EQ(peopleWith("SLURM_ARRAY_TASK_ID=2 PBS_ARRAYID=9", "--shard 1/3"), "036") << "stated, not asked";
  const Answer two = tuneWith("SLURM_ARRAY_TASK_ID=2 PBS_ARRAYID=2", "--shard /3");
  EXPECT_EQ(two.code, 2) << "Slurm counts from 0 here";
  EXPECT_NE(two.err.find("SLURM_ARRAY_TASK_ID and PBS_ARRAYID"), std::string::npos) << two.err;
  const Answer zero = tuneWith("PBS_ARRAY_INDEX=0", "--shard /3");
  EXPECT_EQ(zero.code, 2);
  EXPECT_NE(zero.err.find("counts from 1"), std::string::npos) << zero.err;
  for (const char* outside : {"LSB_JOBINDEX=4", "SGE_TASK_ID=undefined", "PARALLEL_SEQ=0", "PBS_ARRAYID=x"})
    EXPECT_EQ(tuneWith(outside, "--shard /3").code, 2) << outside;
}

}  // namespace array_jobs_test
}  // namespace abstand::testing
