// The compact recording: there and back, cut anywhere, and what is refused.
#include "tracking/compact/compact_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random_pose.hpp"
#include "tracking/registry/open_recording.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::tracking {
namespace compact_test {

using ::testing::HasSubstr;

Recording someone(std::size_t frames) {
  Recording r;
  for (std::uint64_t i = 0; i < frames; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = 0.1 + static_cast<double>(i) / 120.0;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if ((i + j) % 7 != 0)
        f.set(static_cast<humanmodel::Joint>(j), 3.0 * testing::randomPose(i * 100 + j).translation(),
              j % 3 == 0 ? humanmodel::JointState::kInferred : humanmodel::JointState::kTracked);
    r.frames.push_back(f);
  }
  return r;
}

std::string bytesOf(const Recording& r) {
  std::ostringstream out;
  writeCompact(out, r);
  return out.str();
}

TEST(Compact, RoundTrips) {
  const Recording written = someone(20);
  const testing::ScratchFolder folder;
  const auto file = folder.path() / "a.rec";
  writeCompact(file, written);
  const Recording read = openRecording(file);
  EXPECT_EQ(read.report.format, "compact");
  ASSERT_EQ(read.frames.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(read.frames[i].t, written.frames[i].t);
    EXPECT_EQ(read.frames[i].state, written.frames[i].state);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      if (!read.frames[i].has(static_cast<humanmodel::Joint>(j))) continue;
      EXPECT_LE((read.frames[i].p[j] - written.frames[i].p[j]).cwiseAbs().maxCoeff(), 0.5001 * kCompactStep);
    }
  }
  EXPECT_EQ(bytesOf(read), bytesOf(written)) << "whole steps stay as they are";
}

TEST(Compact, ReadsWholeFramesOfTruncatedFile) {
  const std::string whole = bytesOf(someone(3));
  std::size_t last = 4;
  for (std::size_t size = whole.size(); size-- > 400;) {
    const std::string cut = whole.substr(0, size);
    CompactReader reader(cut, "a");
    std::size_t frames = 0;
    for (PointFrame f; reader.next(f);) ++frames;
    EXPECT_LE(frames, last);
    last = frames;
    if (size + 9 < whole.size()) {
      ASSERT_EQ(reader.warnings().size(), 1u) << size;
      EXPECT_THAT(reader.warnings()[0].text, HasSubstr("is truncated"));
    }
  }
  EXPECT_LT(last, 3u);
}

TEST(Compact, KeepsAxesOfParts) {
  Recording recording = someone(2);
  const Eigen::Vector3f y = Eigen::Vector3f(0.2f, -0.9f, 0.4f).normalized();
  recording.frames[1].lateral[5] = y;
  const std::string bytes = bytesOf(recording);
  CompactReader reader(bytes, "a");
  PointFrame frame;
  ASSERT_TRUE(reader.next(frame));
  EXPECT_TRUE(frame.lateral.empty()) << "none is stated";
  ASSERT_TRUE(reader.next(frame));
  ASSERT_EQ(frame.lateral.size(), humanmodel::kJointCount);
  EXPECT_LT((frame.lateral[5] - y).norm(), 1e-4f) << "half a step along each axis";
  EXPECT_TRUE(frame.lateral[6].isZero(0.0f));
}

TEST(Compact, RejectsBadFiles) {
  const std::string good = bytesOf(someone(2));
  const std::size_t head = good.find('\x01', 200);
  const auto with = [&](std::size_t at, const std::string& bytes) {
    std::string s = good;
    return s.replace(at, bytes.size(), bytes);
  };
  struct Case {
    std::string bytes;
    const char* message;
  };
  for (const Case& c :
       {Case{with(0, "X"), "expected ABSTREC1"}, Case{good.substr(0, 8), "found no joint"},
        Case{with(10, "q"), "expected a canonical one"}, Case{good.substr(0, 12), "the name of a joint"},
        Case{with(head, "\x05"), "found the mark 5"},
        Case{with(head, "\x03"), "of an axis, expected -10000 to 10000"},
        Case{with(head + 1, std::string(8, '\xff')), "nan, expected one after that of the last frame"},
        Case{with(head + 9, "\x07"), "found the state 7"},
        Case{with(head + 11, std::string(12, '\xff')), "more than nine bytes"},
        Case{with(good.size() - 8, "\x07"), "after 2 frames, expected 7"}}) {
    try {
      CompactReader reader(c.bytes, "a");
      for (PointFrame f; reader.next(f);) {
      }
      ADD_FAILURE() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
    }
  }
  Recording far = someone(1);
  far.frames[0].p[5] = Vector3d(2e6, 0, 0);
  std::ostringstream out;
  EXPECT_THROW(writeCompact(out, far), UsageError);
}

TEST(Compact, KeepsSpread) {
  Recording r = someone(3);
  r.frames[1].spread[2] = 0.0123456;
  r.frames[1].spread[3] = 5e4;  // m: more than anybody needs to know
  const std::string bytes = bytesOf(r);
  CompactReader reader(bytes, "a");
  PointFrame f;
  ASSERT_TRUE(reader.next(f));
  EXPECT_EQ(f.spreadOf(2), 0.0);
  ASSERT_TRUE(reader.next(f));
  EXPECT_NEAR(f.spreadOf(2), 0.0123456, 0.5 * kCompactStep);
  EXPECT_EQ(f.spreadOf(3), 1e3);
  ASSERT_TRUE(reader.next(f));
  EXPECT_FALSE(reader.next(f));
  EXPECT_TRUE(reader.warnings().empty());
}

// The same person as CSV is larger by a factor; a walk moves by millimetres a frame.
TEST(Compact, IsSmallerThanCsv) {
  Recording r;
  for (int i = 0; i < 100; ++i) {
    humanmodel::SkeletonFrame f;
    f.t = i / 100.0;
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      f.set(static_cast<humanmodel::Joint>(j),
            Vector3d(0.0123456 * i, 0.1 * static_cast<double>(j) + 1.0 / 3.0, 1.0 / (2.0 + i)));
    r.frames.push_back(f);
  }
  std::ostringstream csv;
  writeSkeletonCsv(csv, r);
  EXPECT_LT(5 * bytesOf(r).size(), csv.str().size());
}

}  // namespace compact_test
}  // namespace abstand::tracking
