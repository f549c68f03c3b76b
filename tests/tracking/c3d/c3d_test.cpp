// C3D: the six encodings by hand and from c3d.org, traps of header and parameters, and what is refused.
#include "tracking/c3d/c3d_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.hpp"
#include "core/base/text_file.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/c3d/c3d_writer.hpp"
#include "tracking/recording/recording.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::tracking {
namespace c3d_test {

using testing::c3dOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::SmallC3d;

constexpr double kFloatPerValue = 1e-6;  // floats in the file

SmallC3d small() {
  SmallC3d c;
  for (int i = 0; i < 5; ++i)
    c.frames.push_back({{100.0 + i, -20.25, 0.5},
                        {-3.0, 1000.0 - i, 250.75},
                        Vector3d::Constant(i == 2 ? kNaN : 7.0 * i + 1.0)});
  return c;
}

std::vector<PointFrame> framesOf(PointReader& reader) {
  std::vector<PointFrame> frames;
  for (PointFrame f; reader.next(f);) frames.push_back(f);
  return frames;
}

TEST(C3d, SixEncodingsAgree) {
  for (const auto processor : {C3dProcessor::kIntel, C3dProcessor::kDec, C3dProcessor::kMips})
    for (const bool is_float : {false, true}) {
      SmallC3d c = small();
      c.processor = processor;
      c.is_float = is_float;
      const std::string bytes = c3dOf(c);
      ASSERT_TRUE(looksLikeC3d(bytes));
      C3dReader reader(bytes, "t.c3d");
      EXPECT_THAT(reader.names(), ::testing::ElementsAre("LASI", "RASI", "C7"));
      EXPECT_EQ(reader.facts().rate, 100.0);
      EXPECT_EQ(reader.facts().unit->name, "mm");
      EXPECT_EQ(reader.facts().up->axis, "z");
      EXPECT_THAT(reader.facts().notes, Contains(HasSubstr("2 analog samples")));
      EXPECT_THAT(reader.facts().notes, Contains(HasSubstr("residuals: median 1.00")));
      const auto frames = framesOf(reader);
      ASSERT_EQ(frames.size(), 5u);
      for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
          const bool gap = i == 2 && k == 2;
          EXPECT_EQ(frames[i].state[k] == humanmodel::JointState::kMissing, gap) << i << " " << k;
          if (gap) continue;
          EXPECT_EQ(frames[i].p[k], c.frames[i][k]) << i << " " << k;
        }
      EXPECT_TRUE(reader.warnings().empty());
    }
}

TEST(C3d, FollowsParameterPointerOfHeader) {
  SmallC3d c = small();
  c.parameter_block = 7;
  const std::string bytes = c3dOf(c);
  C3dReader reader(bytes, "t.c3d");
  EXPECT_EQ(reader.names()[0], "LASI");
  EXPECT_EQ(framesOf(reader)[1].p[0], c.frames[1][0]);
}

TEST(C3d, ReadsAvailableFramesOfOverstatedCount) {
  SmallC3d c = small();
  c.claimed_more = 60000;
  const std::string bytes = c3dOf(c);
  C3dReader reader(bytes, "t.c3d");
  EXPECT_EQ(framesOf(reader).size(), 5u);
  ASSERT_EQ(reader.warnings().size(), 1u);
  EXPECT_THAT(reader.warnings()[0].text, HasSubstr("claims 60005 frames, found 5"));
}

TEST(C3d, IgnoresResidualsThatAreAllNegative) {
  SmallC3d c = small();
  c.all_invalid = true;
  const std::string bytes = c3dOf(c);
  C3dReader reader(bytes, "t.c3d");
  const auto frames = framesOf(reader);
  EXPECT_EQ(frames[1].p[1], c.frames[1][1]);
  EXPECT_EQ(frames[2].state[2], humanmodel::JointState::kMissing) << "in the origin";
  EXPECT_THAT(reader.warnings()[0].text, HasSubstr("every residual is negative"));
}

TEST(C3d, PointsAtOriginAreMissing) {
  SmallC3d c = small();
  c.frames[3][1].setZero();
  const std::string bytes = c3dOf(c);
  C3dReader reader(bytes, "t.c3d");
  const auto frames = framesOf(reader);
  EXPECT_EQ(frames[3].state[1], humanmodel::JointState::kMissing);
  EXPECT_EQ(frames[3].state[0], humanmodel::JointState::kTracked);
  EXPECT_THAT(reader.facts().notes, Contains(HasSubstr("1 samples at (0, 0, 0)")));
}

TEST(C3d, ReportsSubjectMeasures) {
  struct Stated {
    float height, knee;
    double metres, knee_metres;
  };
  for (const Stated& s :
       {Stated{1630.0f, 102.0f, 1.63, 0.102}, Stated{163.0f, 10.2f, 1.63, 0.102},
        Stated{163.0f, 102.0f, 1.63, 0.102}, Stated{1.63f, 10.2f, 1.63, 0.102},
        Stated{64.0f, 4.0f, 1.6256, 0.1016}, Stated{64.0f, 102.0f, 1.6256, 0.102},
        Stated{0.0f, 102.0f, 0.0, 0.102}, Stated{0.64f, 0.0f, 0.0, 0.0}, Stated{1.63f, 0.102f, 1.63, 0.102},
        Stated{9.0f, 102.0f, 0.0, 0.102}, Stated{std::numeric_limits<float>::infinity(), 102.0f, 0.0, 0.102},
        Stated{-1.0f, 1e30f, 0.0, 0.0}}) {
    SmallC3d c = small();
    c.subject = "Jane";
    c.processing = {{"Height", s.height}, {"Bodymass", 74.0f}, {"LKneeWidth", s.knee}};
    const std::string bytes = c3dOf(c);
    const SubjectFacts facts = C3dReader(bytes, "t.c3d").facts().subjects.at(0).facts;
    EXPECT_EQ(facts.name, "Jane");
    EXPECT_EQ(facts.mass, 74.0);
    EXPECT_NEAR(facts.height, s.metres, kFloatPerValue) << s.height;
    EXPECT_EQ(facts.sizes.size(), s.knee_metres > 0.0 ? 1u : 0u);
    if (!facts.sizes.empty()) {
      EXPECT_NEAR(facts.sizes.at("knee_width_left"), s.knee_metres, kFloatPerValue);
    }
  }
  const std::string none = c3dOf(small());
  EXPECT_TRUE(C3dReader(none, "t.c3d").facts().subjects.empty());
}

TEST(C3d, SaysHowStatedHeightIsTaken) {
  const auto read = [](float height) {
    SmallC3d c = small();
    c.processing = {{"Height", height}};
    return c3dOf(c);
  };
  const std::string inches = read(64.0f), metric = read(1630.0f), unset = read(0.0f);
  const auto said = [](const std::string& bytes) { return C3dReader(bytes, "t").facts().subjects; };
  EXPECT_THAT(said(inches).at(0).notes, Contains("the stated HEIGHT of 64 is taken as inches: 1.626 m"));
  for (const std::string* bytes : {&inches, &metric, &unset})
    for (const StatedSubject& subject : said(*bytes)) EXPECT_TRUE(subject.warnings.empty());
  for (const float height : {0.64f, 36.0f, 2400.0f, -1.0f, 1e30f}) {
    const std::string bytes = read(height);
    ASSERT_EQ(said(bytes).size(), 1u) << height;
    EXPECT_EQ(said(bytes)[0].facts.height, 0.0) << height;
    EXPECT_THAT(said(bytes)[0].warnings, ::testing::SizeIs(1)) << height;
    EXPECT_THAT(said(bytes)[0].warnings.at(0),
                HasSubstr("is no stature of 1.2 to 2.3 m in m, cm, mm or inches: it is ignored"));
  }
}

TEST(C3d, ReadsSubjectsOneByOne) {
  SmallC3d c = small();
  c.subjects = {"Ann", "Bob"};
  c.heights = {1630.0f, 1.85f};
  c.processing = {{"Bodymass", 60.0f}};
  const std::string bytes = c3dOf(c);
  const auto subjects = C3dReader(bytes, "t").facts().subjects;
  ASSERT_EQ(subjects.size(), 2u);
  EXPECT_EQ(subjects[1].facts.name, "Bob");
  EXPECT_NEAR(subjects[0].facts.height, 1.63, kFloatPerValue);
  EXPECT_NEAR(subjects[1].facts.height, 1.85, kFloatPerValue);
  EXPECT_EQ(subjects[0].facts.mass, 60.0);
  EXPECT_EQ(subjects[1].facts.mass, 0.0) << "the mass of the first is not that of the second";
}

TEST(C3d, RejectsBadFilesWithByteOffset) {
  const std::string good = c3dOf(small());
  const auto with = [&](std::size_t at, const std::string& bytes) {
    std::string s = good;
    return s.replace(at, bytes.size(), bytes);
  };
  struct Case {
    std::string bytes;
    const char* message;
  };
  using namespace std::string_literals;
  for (const Case& c :
       {Case{good.substr(0, 100), "found the end of the file"},
        Case{with(512 + 3, "\x07"), "at byte 515: found the processor 7"},
        Case{with(2, "\0\0"s), "found 0 points"}, Case{with(12, "\0\0\0\0"s), "found a scale of 0"},
        Case{with(16, "\0\0"s), "found the data in block 0"},
        Case{with(20, "\0\0\0\0"s), "found a rate of 0"},
        Case{with(6, "\x09"), "found the last frame 5 before the first, 9"},
        Case{with(16, "\xff\xff"), "found no complete frame"},
        Case{with(0, "\xff"), "found the end of the file"}}) {
    try {
      C3dReader reader(c.bytes, "t.c3d");
      FAIL() << c.message;
    } catch (const ParseError& e) {
      EXPECT_THAT(e.what(), HasSubstr(c.message));
    }
  }
}

TEST(C3d, IgnoresContentAfterBadParameter) {
  // The group points back: no parameter behind it, so markers have numbers for names.
  std::string bytes = c3dOf(small());
  const std::size_t pointer = 512 + 4 + 2 + 5;
  bytes[pointer] = bytes[pointer + 1] = '\xff';
  C3dReader reader(bytes, "t.c3d");
  EXPECT_EQ(reader.names()[1], "point 2");
  EXPECT_EQ(framesOf(reader).size(), 5u);
  EXPECT_THAT(reader.warnings()[0].text, HasSubstr("points back by -1"));
}

std::filesystem::path c3d(const std::string& name) { return testing::sharedData("mocap/c3d/" + name); }

// c3d.org's test suite: one trial in six encodings. Floats were made from the integers, so all are equal.
TEST(C3d, SixFilesOfOneTrialAgree) {
  if (!std::filesystem::exists(c3d("sample01"))) GTEST_SKIP();
  std::vector<std::vector<PointFrame>> all;
  for (const char* name : {"Eb015pi", "Eb015pr", "Eb015si", "Eb015sr", "Eb015vi", "Eb015vr"}) {
    const std::string bytes = readFile(c3d(std::string("sample01/") + name + ".c3d"));
    C3dReader reader(bytes, name);
    EXPECT_EQ(reader.names().size(), 26u);
    all.push_back(framesOf(reader));
    ASSERT_EQ(all.back().size(), 450u);
  }
  double largest = 0.0;
  std::size_t known = 0;
  for (std::size_t k = 1; k < all.size(); ++k)
    for (std::size_t i = 0; i < 450; ++i)
      for (std::size_t j = 0; j < 26; ++j) {
        ASSERT_EQ(all[k][i].state[j], all[0][i].state[j]) << k << " " << i << " " << j;
        if (all[0][i].state[j] == humanmodel::JointState::kMissing) continue;
        largest = std::max(largest, (all[k][i].p[j] - all[0][i].p[j]).norm());
        ++known;
      }
  EXPECT_GT(known, 40000u);
  EXPECT_LT(largest, 1e-3) << "mm; single precision at a metre";
}

TEST(C3d, RealFilesOpenOrAreRejected) {
  if (!std::filesystem::exists(c3d("sample01"))) GTEST_SKIP();
  struct Case {
    const char* file;
    std::size_t markers, frames;
    double rate;
  };
  for (const Case& c :
       {Case{"sample08/TESTBPI.c3d", 26, 450, 50}, Case{"sample08/TESTDPI.c3d", 26, 450, 50},
        Case{"sample09/PlugInC3D.c3d", 86, 281, 60}, Case{"PiG/PiG_Motion3_FF.c3d", 97, 293, 100},
        Case{"others/MyCube.c3d", 14, 1, 50}, Case{"others/mocap36.c3d", 36, 1380, 100},
        Case{"sample18/bad_parameter_section.c3d", 45, 332, 120},
        Case{"sample20/phasespace_sample.c3d", 40, 701, 30}}) {
    const Recording r = openRecording(c3d(c.file));
    EXPECT_EQ(r.report.format, "c3d");
    EXPECT_EQ(r.report.joints.size(), c.markers) << c.file;
    EXPECT_EQ(r.frames.size(), c.frames) << c.file;
    EXPECT_NEAR(r.report.rate, c.rate, 1e-3) << c.file;
  }
  EXPECT_THROW(openRecording(c3d("others/Empty.c3d")), ParseError);
  EXPECT_THAT(openRecording(c3d("sample18/bad_parameter_section.c3d")).report.joints, Contains("P1"));
}

}  // namespace c3d_test
}  // namespace abstand::tracking
