// Skeletons as JSON lines: what is read, and what is refused.
#include "tracking/table/skeleton_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace skeleton_json_test {

using ::testing::HasSubstr;

const std::string kTwo =
    R"({"t": 0.5, "joints": {"pelvis": [0, 0, 1], "neck": [0, 0.25, 1.5, "inferred"], "head": [0, 0, 2, 0]}})"
    "\n\n"
    R"({"t": 1, "joints": {"neck": [1, 2, 3, 0.9], "pelvis": null}})"
    "\n";

TEST(SkeletonJson, ReadsOneFramePerLine) {
  const testing::ScratchFolder folder;
  const Recording r = openRecording(folder.write("a.txt", kTwo));
  EXPECT_EQ(r.report.format, "jsonl");
  EXPECT_EQ(r.report.rate, 2.0);
  ASSERT_EQ(r.frames.size(), 2u);
  EXPECT_EQ(r.frames[0].t, 0.5);
  EXPECT_EQ(r.frames[0][humanmodel::Joint::kNeck], Vector3d(0, 0.25, 1.5));
  EXPECT_EQ(r.frames[0].state[static_cast<std::size_t>(humanmodel::Joint::kNeck)],
            humanmodel::JointState::kInferred);
  EXPECT_FALSE(r.frames[0].has(humanmodel::Joint::kHead)) << "confidence 0";
  EXPECT_FALSE(r.frames[1].has(humanmodel::Joint::kPelvis));
  EXPECT_EQ(r.frames[1].state[static_cast<std::size_t>(humanmodel::Joint::kNeck)],
            humanmodel::JointState::kTracked);
}

TEST(SkeletonJson, ReadsServePackets) {
  const testing::ScratchFolder folder;
  const Recording r = openRecording(folder.write(
      "a", R"({"type":"skeleton","seq":1,"time_us":5000000,"person":"p","joints":{"pelvis":[0,0,1]}})"
           "\n"
           R"({"type":"skeleton","seq":2,"time_us":5010000,"person":"p","joints":{"pelvis":[0,0,1]}})"));
  EXPECT_NEAR(r.report.rate, 100.0, 1e-6);
  EXPECT_EQ(r.frames[0].t, 0.0);
}

TEST(SkeletonJson, RejectsBadFilesWithLine) {
  struct Case {
    std::string text;
    int line;
    const char* message;
  };
  const std::string deep(1000, '[');
  for (const Case& c :
       {Case{"{\"joints\": 1}", 1, "expected an object"}, Case{"{\"joints\": {", 1, "expected an object"},
        Case{"{\"joints\": {}}", 1, "found no joint"},
        Case{"{\"joints\": {\"neck\": [0,0,0]}}", 1, "found no time"},
        Case{"{\"t\": true, \"joints\": {\"neck\": [0,0,0]}}", 1, "no number below 1e9 for t"},
        Case{kTwo + "{\"t\": 1, \"joints\": {}}", 4, "expected t to rise"},
        Case{kTwo + "{\"t\": 2, \"joints\": {\"toe\": null}}", 4, "found the joint 'toe'"},
        Case{kTwo + "{\"t\": 2, \"joints\": {\"neck\": [0,0]}}", 4, "expected [x, y, z] or null"},
        Case{kTwo + "{\"t\": 2, \"joints\": {\"neck\": [0,0,1e300]}}", 4, "no number below 1e9"},
        Case{kTwo + "{\"t\": 2, \"joints\": {\"neck\": [0,0,1,\"seen\"]}}", 4, "unknown state"},
        Case{"{\"joints\": " + deep, 1, "nested more than 16 deep"}}) {
    try {
      SkeletonJsonReader reader(c.text, "t");
      for (PointFrame f; reader.next(f);) {
      }
      FAIL() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
      EXPECT_EQ(e.pos().line, c.line) << e.what();
    }
  }
}

}  // namespace skeleton_json_test
}  // namespace abstand::tracking
