// Arrays, TIFF, packed clouds and dumps, byte by byte.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.hpp"
#include "tests/tracking/depth/formats/depth_files.hpp"
#include "tests/tracking/depth/formats/refusal.hpp"
#include "tracking/depth/formats/depth_tiff.hpp"
#include "tracking/depth/formats/freenect_depth.hpp"
#include "tracking/depth/formats/lzf.hpp"
#include "tracking/depth/formats/npy_array.hpp"
#include "tracking/depth/formats/pcd_cloud.hpp"

namespace abstand::testing {
namespace depth_formats_test {

TEST(NpyArray, ReadsAllNumberTypes) {
  const auto only = [](const std::string& type, const std::string& data) {
    const std::string bytes = npy(type, "(2,)", data);
    const tracking::NpyArray a = tracking::parseNpy(bytes, "a.npy");
    EXPECT_EQ(a.size, std::vector<std::size_t>{2}) << type;
    return std::pair(a.at(0), a.at(1));
  };
  EXPECT_EQ(only("<u2", bytesOf(258, 2) + bytesOf(65535, 2)), std::pair(258.0, 65535.0));
  EXPECT_EQ(only(">u2", bytesOf(258, 2, false) + bytesOf(65535, 2, false)), std::pair(258.0, 65535.0));
  EXPECT_EQ(only("<i2", bytesOf(65535, 2) + bytesOf(32767, 2)), std::pair(-1.0, 32767.0));
  EXPECT_EQ(only("|u1", bytesOf(7, 1) + bytesOf(255, 1)), std::pair(7.0, 255.0));
  EXPECT_EQ(only("<f4", bytesOf(std::bit_cast<std::uint32_t>(1.5f), 4) +
                            bytesOf(std::bit_cast<std::uint32_t>(-2.25f), 4)),
            std::pair(1.5, -2.25));
  EXPECT_EQ(only(">f8", bytesOf(std::bit_cast<std::uint64_t>(0.1), 8, false) +
                            bytesOf(std::bit_cast<std::uint64_t>(3.0), 8, false)),
            std::pair(0.1, 3.0));
  // IEEE 754 halves: 1, the largest, the smallest above 0, -2.
  EXPECT_EQ(only("<f2", bytesOf(0x3c00, 2) + bytesOf(0x7bff, 2)), std::pair(1.0, 65504.0));
  EXPECT_EQ(only("<f2", bytesOf(0x0001, 2) + bytesOf(0xc000, 2)), std::pair(std::ldexp(1.0, -24), -2.0));
  EXPECT_TRUE(std::isnan(only("<f2", bytesOf(0x7e00, 2) + bytesOf(0, 2)).first));
}

TEST(NpyArray, RejectsUnsupportedFiles) {
  const auto says = [](const std::string& bytes) {
    return refusal([&] { tracking::parseNpy(bytes, "a.npy"); });
  };
  EXPECT_TRUE(holds(says("\x93NUMPX______"), "no NumPy"));
  EXPECT_TRUE(holds(says(npy("<c8", "(1,)", "12345678")), "type '\\'<c8\\''") ||
              holds(says(npy("<c8", "(1,)", "12345678")), "type"));
  EXPECT_TRUE(holds(says(npy("<u2", "(3,)", "1234")), "found 4 bytes of numbers, expected 6"));
  EXPECT_TRUE(holds(says(npy("<u2", "()", "")), "bytes of numbers"));
  EXPECT_TRUE(holds(says(npy("<u2", "(-1,)", "")), "size"));
  EXPECT_TRUE(holds(says(npy("<u2", "(2000000000, 2000000000)", "")), "shape"));
  EXPECT_TRUE(holds(says(std::string("\x93NUMPY\1\0\xff\xff{", 11) + "      "), "header"));
}

TEST(DepthTiff, ReadsPlainAndPackBits) {
  for (const bool low : {true, false}) {
    TiffText tiff;
    tiff.is_low_first = low;
    for (const unsigned mm : {1000u, 0u, 2500u, 65535u}) tiff.strip += bytesOf(mm, 2, low);
    const std::string plain = tiff.strip;
    for (const unsigned packing : {1u, 32773u}) {
      tiff.packing = packing;
      // PackBits, a row at a time: a byte n below 128 copies n + 1.
      if (packing == 32773)
        tiff.strip = std::string(1, 3) + plain.substr(0, 4) + std::string(1, 3) + plain.substr(4);
      const tracking::DepthImage image = tracking::decodeDepthTiff(tiff.bytes(), 1000.0, "a.tiff");
      ASSERT_EQ(image.width, 2);
      ASSERT_EQ(image.height, 2);
      EXPECT_EQ(image.z, (std::vector<float>{1.0f, 0.0f, 2.5f, 65.535f})) << low << " " << packing;
    }
  }
}

TEST(DepthTiff, RejectsNonDepthImages) {
  const auto says = [](const std::string& bytes) {
    return refusal([&] { tracking::decodeDepthTiff(bytes, 1000.0, "a.tiff"); });
  };
  TiffText tiff;
  tiff.strip = std::string(8, '\1');
  EXPECT_TRUE(holds(says("GIF89a"), "no TIFF"));
  EXPECT_TRUE(holds(says(tiff.bytes().substr(0, 40)), "found the end"));
  EXPECT_TRUE(holds(says(tiff.bytes().substr(0, 132)), "damaged"));
  tiff.bits = 8;
  EXPECT_TRUE(holds(says(tiff.bytes()), "of 8 bits"));
  tiff.bits = 16;
  tiff.form = 3;
  EXPECT_TRUE(holds(says(tiff.bytes()), "sample format 3"));
  tiff.form = 1;
  tiff.width = 60000;
  EXPECT_TRUE(holds(says(tiff.bytes()), "60000 x 2 pixels"));
}

TEST(Lzf, UnpacksRunsAndRepeats) {
  std::string out;
  // "ab", then 3 bytes from 2 back, then a long run of the last byte: 7 + 5 + 2 from 1 back.
  const std::string packed = std::string(
                                 "\x01"
                                 "ab",
                                 3) +
                             std::string("\x20\x01", 2) + std::string("\xe0\x05\x00", 3);
  ASSERT_TRUE(tracking::unpackLzf(packed, 100, out));
  EXPECT_EQ(out, "ababa" + std::string(14, 'a'));
  EXPECT_TRUE(tracking::unpackLzf(packed, 19, out));
  EXPECT_FALSE(tracking::unpackLzf(packed, 18, out));
  EXPECT_FALSE(tracking::unpackLzf(std::string("\x05"
                                               "ab",
                                               3),
                                   100, out));
  EXPECT_FALSE(tracking::unpackLzf(std::string("\x20\x01", 2), 100, out)) << "copies from before the start";
  EXPECT_FALSE(tracking::unpackLzf(std::string("\x00"
                                               "a\xe0\x05",
                                               4),
                                   100, out))
      << "ends in a copy";
}

TEST(PcdCloud, ReadsAllEncodingsAndFindsCamera) {
  tracking::DepthCamera camera;
  camera.width = 40;
  camera.height = 30;
  camera.fx = 36.0;
  camera.fy = 35.0;
  camera.cx = 19.0;
  camera.cy = 15.5;
  tracking::DepthImage image(40, 30);
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 40; ++u)
      image.at(u, v) = u % 7 == 0 ? 0.0f : 1.0f + 0.01f * static_cast<float>(u + v);
  for (const char* kind : {"ascii", "binary", "binary_compressed"}) {
    const tracking::PcdCloud cloud = tracking::parsePcd(pcd(image, camera, kind), "a.pcd");
    ASSERT_EQ(cloud.points.size(), 1200u) << kind;
    for (std::size_t i = 0; i < image.z.size(); ++i) {
      if (image.z[i] > 0.0f)
        ASSERT_EQ(cloud.points[i].z(), image.z[i]) << kind << " " << i;
      else
        ASSERT_TRUE(std::isnan(cloud.points[i].z())) << kind << " " << i;
    }
    const tracking::FittedCamera fit = tracking::fitCamera(cloud, "a.pcd");
    constexpr double kFloat = 1e-4;  // pixels, of points kept in float
    EXPECT_NEAR(fit.camera.fx, camera.fx, kFloat);
    EXPECT_NEAR(fit.camera.fy, camera.fy, kFloat);
    EXPECT_NEAR(fit.camera.cx, camera.cx, kFloat);
    EXPECT_NEAR(fit.camera.cy, camera.cy, kFloat);
    EXPECT_LT(fit.residual, kFloat);
  }
  tracking::PcdCloud moved = tracking::parsePcd(pcd(image, camera, "binary"), "a.pcd");
  for (Vector3f& p : moved.points)
    p = Eigen::AngleAxisf(0.5f, Vector3f::UnitX()) * p + Vector3f(0.1f, 0.0f, 0.5f);
  EXPECT_TRUE(holds(refusal([&] { tracking::fitCamera(moved, "a.pcd"); }), "do not fit a pinhole camera"));
}

TEST(PcdCloud, RejectsUnorganizedClouds) {
  const std::string whole = pcd(tracking::DepthImage(4, 3), {}, "binary");
  const auto says = [](const std::string& bytes) {
    return refusal([&] { tracking::parsePcd(bytes, "a.pcd"); });
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TRUE(holds(says(with("HEIGHT 3", "HEIGHT 1")), "organised"));
  EXPECT_TRUE(holds(says(with("WIDTH 4", "WIDTH 4000000")), "along a side"));
  EXPECT_TRUE(holds(says(with("POINTS 12", "POINTS 13")), "a.pcd:11: error: found POINTS 13"));
  EXPECT_TRUE(holds(says(with("FIELDS x y z", "FIELDS x y w")), "no field z"));
  EXPECT_TRUE(holds(says(with("TYPE F F F", "TYPE F F I")), "z of type I4"));
  EXPECT_TRUE(holds(says(with("DATA binary", "DATA zip")), "DATA 'zip'"));
  EXPECT_TRUE(holds(says(with("SIZE 4 4 4 4", "SIZE 4 4 4")), "3 values after SIZE"));
  EXPECT_TRUE(holds(says(whole.substr(0, whole.size() - 1)), "bytes of points"));
  std::string packed = pcd(tracking::DepthImage(4, 3), {}, "binary_compressed");
  // A copy from before the start in the place of the first run.
  packed[packed.find("_compressed\n") + 12 + 8] = '\x7f';
  EXPECT_TRUE(holds(says(packed), "damaged"));
  EXPECT_TRUE(holds(refusal([] {
                      tracking::fitCamera({4, 3, std::vector<Vector3f>(12, Vector3f::Zero())}, "a.pcd");
                    }),
                    "found 0 points"));
}

TEST(FreenectDepth, RoundTrips) {
  int depths = 0;
  for (int raw = 0; raw < 2048; ++raw) {
    const float z = tracking::freenectDepth(raw);
    EXPECT_EQ(tracking::freenectRaw(z), z > 0.0f ? raw : 2047) << raw;
    depths += z > 0.0f;
  }
  EXPECT_GT(depths, 1000);
  for (const float none : {0.0f, -1.0f, 0.29f, 10.5f, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity()})
    EXPECT_EQ(tracking::freenectRaw(none), 2047) << none;
  // Half a step of the line off, at most: dz = z^2 / 2 * step.
  for (float z = 0.31f; z < 9.0f; z += 0.01f)
    EXPECT_NEAR(tracking::freenectDepth(tracking::freenectRaw(z)), z,
                0.5 * 0.0030711016 * z * z * 1.02 + 1e-6)
        << z;
  tracking::DepthImage image(3, 2);
  image.z = {
      0.0f, tracking::freenectDepth(800), 0.0f, tracking::freenectDepth(1), tracking::freenectDepth(1050),
      0.0f};
  const tracking::FreenectImage read = tracking::parseFreenectDepth(tracking::freenectDump(image), "d.pgm");
  EXPECT_TRUE(read.units.is_raw);
  EXPECT_TRUE(read.units.is_low_first);
  EXPECT_EQ(read.image.z, image.z);
}

TEST(FreenectDepth, DistinguishesDisparityMillimetresAndByteOrder) {
  const auto dump = [](const std::vector<unsigned>& values, bool low,
                       const std::string& header = "P5 3 2 65535\n") {
    std::string bytes = header;
    for (const unsigned v : values) bytes += bytesOf(v, 2, low);
    return bytes;
  };
  for (const bool low : {true, false}) {
    const tracking::FreenectImage raw =
        tracking::parseFreenectDepth(dump({2047, 800, 2047, 700, 1000, 2047}, low), "d.pgm");
    EXPECT_TRUE(raw.units.is_raw);
    EXPECT_EQ(raw.units.is_low_first, low);
    EXPECT_EQ(raw.image.at(0, 0), 0.0f);
    EXPECT_NEAR(raw.image.at(1, 0), 1.0 / (3.3309495161 - 0.0030711016 * 800), 1e-6);
    const tracking::FreenectImage mm =
        tracking::parseFreenectDepth(dump({0, 800, 0, 4700, 1000, 0}, low), "d.pgm");
    EXPECT_FALSE(mm.units.is_raw);
    EXPECT_EQ(mm.units.is_low_first, low);
    EXPECT_FLOAT_EQ(mm.image.at(0, 1), 4.7f);
    EXPECT_EQ(mm.image.at(0, 0), 0.0f);
  }
  EXPECT_EQ(tracking::freenectDepth(1085), 0.0f) << "behind the horizon of the line";
  const auto says = [](const std::string& bytes) {
    return refusal([&] { tracking::parseFreenectDepth(bytes, "d.pgm"); });
  };
  EXPECT_TRUE(holds(says(dump({1, 2}, true)), "4 bytes of pixels, expected 12"));
  EXPECT_TRUE(holds(says(dump({1, 2}, true, "P6 3 2 65535\n")), "P5"));
  EXPECT_TRUE(holds(says(dump({1, 2}, true, "P5 3 2 255\n")), "one byte a pixel"));
  EXPECT_TRUE(holds(says(dump({1, 2}, true, "P5 3000000 2 255\n")), "a width from 1"));
  EXPECT_TRUE(holds(says(dump({60000, 60001, 60002, 0, 0, 0}, true)), "above 10000"));
}

}  // namespace depth_formats_test
}  // namespace abstand::testing
