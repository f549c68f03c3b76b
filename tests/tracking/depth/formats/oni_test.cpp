// Recordings of OpenNI: one that its own library wrote, and those that this test packs.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/depth/formats/oni_files.hpp"
#include "tests/tracking/depth/formats/refusal.hpp"
#include "tracking/depth/formats/depth_stream.hpp"
#include "tracking/depth/formats/oni_recording.hpp"

namespace abstand::testing {
namespace oni_test {

using Numbers = std::vector<std::uint16_t>;

std::string refusalOf(const std::string& bytes) {
  std::istringstream in(bytes);
  return refusal([&] {
    const tracking::OniDepth depth = tracking::readOni(in, "a.oni");
    for (const tracking::OniFrame& frame : depth.frames) tracking::readOniImage(in, depth, frame, "a.oni");
  });
}

/// Recorded by OpenNI2 2.2.0.33 of Debian 12 from its driver DummyDevice: 320 x 240 pixels, the first row at
/// 2 m, and a disc with its centre at (n, n) in image n, 1 m + 3 mm (x - y) away. The zeros behind its last
/// record are left out.
TEST(OniRecording, ReadsFileOfOpenNI) {
  const auto stream =
      tracking::openDepthStream(projectFile("tests/tracking/depth/formats/openni2_dummy.oni"));
  EXPECT_EQ(stream->facts().format, "oni");
  EXPECT_EQ(stream->camera().width, 320);
  EXPECT_EQ(stream->camera().height, 240);
  ASSERT_EQ(stream->size(), 5u);
  EXPECT_NEAR(stream->facts().rate, 1.0 / 0.033, 1e-6);
  EXPECT_EQ(stream->times().front(), 0.0);
  tracking::DepthFrame frame;
  int n = -1;
  while (stream->next(frame)) {
    const auto expected = [](int k) {
      tracking::DepthImage image(320, 240);
      for (int y = std::max(k - 10, 0); y < k + 10; ++y)
        for (int x = std::max(k - 10, 0); x < k + 10; ++x)
          if ((x - k) * (x - k) + (y - k) * (y - k) < 70)
            image.at(x, y) = static_cast<float>(1000 + 3 * (x - y)) * 0.001f;
      for (int x = 0; x < 320; ++x) image.at(x, 0) = 2.0f;
      return image.z;
    };
    // How far the disc was when the recorder began is not in the file.
    if (n < 0)
      for (n = 0; n < 50 && expected(n) != frame.image.z;) ++n;
    EXPECT_EQ(frame.image.z, expected(n)) << n;
    ++n;
  }
}

TEST(OniPacking, RoundTrips) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    // From flat walls to noise: steps of every coding, and runs of every length.
    const int reach = 1 << random() % 16;
    Numbers numbers(1 + random() % 700);
    int value = static_cast<int>(random() % 10000);
    for (std::uint16_t& n : numbers) {
      if (random() % 8 == 0 || round % 3 == 0) value += static_cast<int>(random() % (2 * reach + 1)) - reach;
      value = std::clamp(value, 0, 32767);  // 15 bits: what a number in full has room for
      n = static_cast<std::uint16_t>(value);
    }
    EXPECT_EQ(tracking::unpackOni(packed16z(numbers), tracking::OniPacking::k16z, numbers.size(), "a"),
              numbers);
    EXPECT_EQ(tracking::unpackOni(packed16zTable(numbers), tracking::OniPacking::kTable, numbers.size(), "a"),
              numbers);
    EXPECT_EQ(tracking::unpackOni(plain16(numbers), tracking::OniPacking::kNone, numbers.size(), "a"),
              numbers);
  }
}

TEST(OniPacking, RejectsDamagedData) {
  const auto says = [](const std::string& bytes, tracking::OniPacking packing, std::size_t count) {
    return refusal([&] { tracking::unpackOni(bytes, packing, count, "a.oni"); });
  };
  using enum tracking::OniPacking;
  EXPECT_TRUE(holds(says("", k16z, 4), "found its end"));
  EXPECT_TRUE(holds(says(plain16({1, 2}), kNone, 3), "4 bytes of pixels, expected 6"));
  EXPECT_TRUE(holds(says(packed16z({1, 1, 1, 1, 1}), k16z, 4), "more than 4 pixels"));
  EXPECT_TRUE(holds(says(packed16z({1, 1, 1}), k16z, 4), "3 pixels, expected 4"));
  EXPECT_TRUE(holds(says(bytesOf(7, 2) + "\xff", k16z, 2), "found its end"));
  EXPECT_TRUE(holds(says(bytesOf(7, 2) + "\xff\x12", k16z, 2), "found its end"));
  EXPECT_TRUE(holds(says(bytesOf(7, 2) + "\xf3", k16z, 2), "unknown code"));
  EXPECT_TRUE(holds(says(bytesOf(7, 2) + "\x6e", k16z, 2), "unknown difference"));
  EXPECT_TRUE(holds(says(bytesOf(2, 2) + bytesOf(5, 2) + bytesOf(6, 2) + bytesOf(2, 2), kTable, 1),
                    "place 2 in a table of 2"));
  EXPECT_TRUE(holds(says(bytesOf(9, 2) + bytesOf(5, 2), kTable, 1), "found its end"));
}

const Numbers kFirst{0, 800, 801, 2000, 2000, 2000, 0, 9999}, kSecond{1, 1, 1, 1, 1, 1, 1, 1};

tracking::OniDepth depthOf(const std::string& bytes) {
  std::istringstream in(bytes);
  return tracking::readOni(in, "a.oni");
}

tracking::DepthImage imageOf(const std::string& bytes, std::size_t i) {
  std::istringstream in(bytes);
  const tracking::OniDepth depth = tracking::readOni(in, "a.oni");
  return tracking::readOniImage(in, depth, depth.frames.at(i), "a.oni");
}

TEST(OniRecording, SelectsDepthAmongStreams) {
  for (const bool old : {false, true}) {
    OniText text(old);
    text.stream(1, "JPEG", 3).size(1, 2, 2).stream(4, "16zP").size(4, 4, 2);
    text.property(4, "oniPixelFormat", bytesOf(101, 8), true);
    text.property(4, "xnMirror", bytesOf(1, 8), true);
    text.property(4, "xnFOV", OniText::real(1.0) + OniText::real(0.8));
    text.image(1, 0.0, "colour").image(4, 0.5, packed16z(kFirst)).image(1, 0.6, "colour");
    text.image(4, 0.54, packed16z(kSecond));
    const tracking::OniDepth depth = depthOf(text.end());
    EXPECT_EQ(depth.width, 4);
    EXPECT_EQ(depth.height, 2);
    EXPECT_EQ(depth.metres, 1e-4);
    EXPECT_EQ(depth.rate, 30.0);
    EXPECT_EQ(depth.across, 1.0);
    EXPECT_EQ(depth.down, 0.8);
    EXPECT_TRUE(depth.is_mirrored);
    EXPECT_FALSE(depth.is_cut);
    ASSERT_EQ(depth.frames.size(), 2u);
    EXPECT_DOUBLE_EQ(depth.frames[1].t, 0.54);
    EXPECT_FLOAT_EQ(imageOf(text.end(), 0).at(1, 0), 0.08f);
    EXPECT_FLOAT_EQ(imageOf(text.end(), 0).at(3, 1), 0.9999f);
    EXPECT_FLOAT_EQ(imageOf(text.end(), 1).at(0, 0), 1e-4f);
  }
}

TEST(OniRecording, IsDepthStream) {
  ScratchFolder folder;
  OniText text;
  text.stream(1, "NONE").size(1, 4, 2).property(1, "xnFOV", OniText::real(1.0) + OniText::real(0.8));
  text.property(1, "xnMirror", bytesOf(1, 8), true);
  text.image(1, 3.0, plain16(kFirst)).image(1, 3.04, plain16(kSecond));
  const auto stream = tracking::openDepthStream(folder.write("a.oni", text.end()));
  EXPECT_EQ(stream->times(), (std::vector<double>{0.0, 3.04 - 3.0}));
  EXPECT_EQ(stream->facts().camera_reason, "the field of view in the file");
  EXPECT_NEAR(stream->camera().fx, 2.0 / std::tan(0.5), 1e-12);
  EXPECT_NEAR(stream->camera().fy, 1.0 / std::tan(0.4), 1e-12);
  EXPECT_NEAR(stream->camera().cx, 4 - 1 - 2.0, 1e-12);  // of a mirror
  tracking::DepthFrame frame;
  ASSERT_TRUE(stream->next(frame));
  EXPECT_FLOAT_EQ(frame.image.at(3, 0), 0.0f);
  EXPECT_FLOAT_EQ(frame.image.at(2, 0), 0.8f);
  stream->seek(1);
  ASSERT_TRUE(stream->next(frame));
  EXPECT_FLOAT_EQ(frame.image.at(0, 1), 0.001f);
  EXPECT_FALSE(stream->next(frame));
}

/// As a recorder leaves it that did not end: every cut gives the whole images before, or a sentence.
TEST(OniRecording, ReadsWholeImagesOfTruncatedFile) {
  OniText text;
  text.stream(1, "16zT").size(1, 4, 2).image(1, 0.0, packed16zTable(kFirst));
  const std::size_t one = text.cut().size();
  text.image(1, 0.1, packed16zTable(kSecond));
  const std::string bytes = text.cut();
  for (std::size_t n = 0; n <= bytes.size(); ++n) {
    const std::string part = bytes.substr(0, n);
    if (n < one) {
      EXPECT_TRUE(holds(refusalOf(part), "a.oni: error: at byte")) << n;
      continue;
    }
    const tracking::OniDepth depth = depthOf(part);
    EXPECT_EQ(depth.frames.size(), n == bytes.size() ? 2u : 1u) << n;
    EXPECT_TRUE(depth.is_cut);
    EXPECT_FLOAT_EQ(imageOf(part, 0).at(1, 0), 0.8f);
  }
}

TEST(OniRecording, ReportsErrors) {
  OniText depth;
  depth.stream(1, "16zP").size(1, 4, 2);
  const auto with = [&](const std::string& name, const std::string& value) {
    return refusalOf(OniText(depth).property(1, name, value, true).image(1, 0.0, packed16z(kFirst)).end());
  };
  EXPECT_TRUE(holds(refusalOf("NI10"), "found no OpenNI recording"));
  EXPECT_TRUE(holds(refusalOf(OniText().end()), "found no depth"));
  EXPECT_TRUE(holds(refusalOf(depth.end()), "found no image of depth"));
  EXPECT_TRUE(holds(refusalOf(OniText().stream(1, "JPEG").end()), "packed by 'JPEG'"));
  EXPECT_TRUE(holds(refusalOf(OniText().stream(1, "NONE").image(1, 0.0, "ab").end()), "before its size"));
  EXPECT_TRUE(holds(refusalOf(OniText().stream(1, "NONE").size(1, 5000, 2).end()), "5000 x 2 pixels"));
  EXPECT_TRUE(holds(with("oniPixelFormat", bytesOf(102, 8)), "pixels of kind 102"));
  EXPECT_TRUE(holds(with("xnCropping", bytesOf(1, 4) + bytesOf(0, 8)), "cropped"));
  OniText falls(depth);
  falls.image(1, 0.5, packed16z(kFirst)).image(1, 0.4, packed16z(kFirst));
  EXPECT_TRUE(holds(refusalOf(falls.end()), "a decreasing time"));
  EXPECT_TRUE(holds(refusalOf(depth.cut() + std::string(40, 'x')), "found no record, expected NIR"));
  std::string future = depth.image(1, 0.0, packed16z(kFirst)).end();
  future[5] = 3;
  EXPECT_TRUE(holds(refusalOf(future), "version 1.3.1.0"));
}

}  // namespace oni_test
}  // namespace abstand::testing
