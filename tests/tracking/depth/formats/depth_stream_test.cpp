// Depth recordings of all formats through one door.
#include "tracking/depth/formats/depth_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tests/support/paths.hpp"
#include "tests/tracking/depth/formats/depth_files.hpp"
#include "tracking/depth/formats/depth_png.hpp"

namespace abstand::testing {
namespace depth_stream_test {

/// An image that tells its number: all `number` / 8 m, one pixel not measured.
tracking::DepthImage numbered(int number, int width = 8, int height = 6) {
  tracking::DepthImage image(width, height);
  for (float& z : image.z) z = static_cast<float>(number) * 0.125f;
  image.at(1, 2) = 0.0f;
  return image;
}

std::string cameraText(int width = 8, int height = 6, double scale = 1000.0) {
  tracking::DepthCamera camera;
  camera.width = width;
  camera.height = height;
  camera.depth_scale = scale;
  return tracking::describeDepthCamera(camera);
}

/// The numbers of all frames of a stream.
std::vector<int> numbers(tracking::DepthStream& stream) {
  std::vector<int> found;
  for (tracking::DepthFrame frame; stream.next(frame);) {
    EXPECT_EQ(frame.image.at(1, 2), 0.0f);
    found.push_back(static_cast<int>(std::lround(frame.image.at(0, 0) * 8.0f)));
  }
  return found;
}

std::string refusal(const std::filesystem::path& path, const tracking::DepthStreamOptions& options = {}) {
  try {
    tracking::openDepthStream(path, options);
  } catch (const ParseError& e) {
    return e.message();
  }
  return "nothing was refused";
}

TEST(DepthStream, ReadsSimulatorClip) {
  const ScratchFolder folder;
  folder.write("camera.yaml", cameraText());
  folder.write("depth.txt", "# time [s], file\n2.000000 depth_000000.png\n2.033333 depth_000001.png\n");
  for (int i = 0; i < 2; ++i)
    tracking::saveDepthPng(numbered(i + 5), 1000.0,
                           folder.path() / ("depth_00000" + std::to_string(i) + ".png"));
  const auto stream = tracking::openDepthStream(folder.path());
  EXPECT_EQ(stream->facts().format, "clip");
  EXPECT_TRUE(stream->facts().camera_known);
  EXPECT_FALSE(stream->facts().pose_known);
  EXPECT_NEAR(stream->facts().rate, 30.0, 1e-3);
  EXPECT_EQ(stream->times(), (std::vector<double>{2.0, 2.033333}));
  EXPECT_EQ(numbers(*stream), (std::vector<int>{5, 6}));
  stream->seek(1);
  EXPECT_EQ(numbers(*stream), std::vector<int>{6});
  EXPECT_EQ(tracking::openDepthStream(folder.path(), {{}, 10.0})->times(), (std::vector<double>{0.0, 0.1}));
  EXPECT_THROW(tracking::openDepthStream(folder.path(), {{}, -1.0}), UsageError);
}

TEST(DepthStream, ReadsTumLayout) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder.path() / "depth");
  for (const int i : {1, 2})
    tracking::saveDepthPng(numbered(i, 640, 480), 5000.0,
                           folder.path() / "depth" / (std::to_string(i) + ".png"));
  folder.write(
      "depth.txt",
      "# depth maps\n# timestamp filename\n1305031102.160407 depth/1.png\n1305031102.194330 depth/2.png\n");
  const auto stream = tracking::openDepthStream(folder.path());
  EXPECT_EQ(stream->facts().format, "tum");
  EXPECT_GT(stream->facts().clock_start, 1.0e9) << "its times are those of a clock";
  EXPECT_EQ(stream->camera().fx, 525.0);
  EXPECT_NEAR(stream->times()[1], 0.033923, 1e-6);
  EXPECT_EQ(numbers(*stream), (std::vector<int>{1, 2}));

  // Associations: colour before depth, one depth image for two colour images.
  std::filesystem::remove(folder.path() / "depth.txt");
  folder.write(
      "associations.txt",
      "1.0 rgb/1.png 1.1 depth/1.png\n1.05 rgb/2.png 1.1 depth/1.png\n1.2 rgb/3.png 1.3 depth/2.png\n");
  const auto other = tracking::openDepthStream(folder.path() / "associations.txt");
  EXPECT_EQ(numbers(*other), (std::vector<int>{1, 2}));
  EXPECT_EQ(other->facts().notes.size(), 1u);
}

TEST(DepthStream, RejectsBadLists) {
  const auto says = [](const std::string& list) {
    const ScratchFolder folder;
    tracking::saveDepthPng(numbered(1, 640, 480), 5000.0, folder.path() / "1.png");
    return refusal(folder.write("depth.txt", list));
  };
  EXPECT_EQ(says("1.0 1.png\n0.5 1.png\n"), "found the time 0.5 after 1, expected increasing times");
  EXPECT_EQ(says("1.0 ../1.png\n"), "found '../1.png', expected a file within the folder");
  EXPECT_EQ(says("1.0 /1.png\n"), "found '/1.png', expected a file within the folder");
  EXPECT_EQ(says("one 1.png\n"), "found 'one', expected a time in seconds");
  EXPECT_EQ(says("1.0 1.png\n2.0\n"), "found 1 words, expected 2 as before");
  EXPECT_EQ(says("# nothing\n"), "found no image in the list, expected at least one");
}

TEST(DepthStream, ReadsImagesInNaturalOrder) {
  const ScratchFolder folder;
  for (const int i : {1, 2, 10, 11})
    tracking::saveDepthPng(numbered(i), 1000.0, folder.path() / ("d" + std::to_string(i) + ".png"));
  EXPECT_EQ(refusal(folder.path()),
            "found 8 x 6 pixels and no camera file, expected one, as no known sensor has that size");
  folder.write("camera.yaml", cameraText());
  const auto stream = tracking::openDepthStream(folder.path());
  EXPECT_EQ(stream->facts().format, "png");
  EXPECT_EQ(stream->facts().rate_reason, "no times in the files; 30 Hz assumed");
  EXPECT_EQ(numbers(*stream), (std::vector<int>{1, 2, 10, 11}));
  // Another scale in a camera file that is given.
  const ScratchFolder elsewhere;
  const auto camera = elsewhere.write("half.yaml", cameraText(8, 6, 500.0));
  EXPECT_EQ(numbers(*tracking::openDepthStream(folder.path(), {camera, 0.0})),
            (std::vector<int>{2, 4, 20, 22}));
  const auto wrong = elsewhere.write("wrong.yaml", cameraText(9, 6));
  EXPECT_EQ(refusal(folder.path(), {wrong, 0.0}), "found 8 x 6 pixels, expected 9 x 6 as in its camera file");
  // One that is of another size is found when it is its turn.
  tracking::saveDepthPng(numbered(3, 4, 4), 1000.0, folder.path() / "d3.png");
  EXPECT_THROW(numbers(*tracking::openDepthStream(folder.path())), ParseError);
}

TEST(DepthStream, IdentifiesKinectsByImageSize) {
  const ScratchFolder folder;
  tracking::saveDepthPng(numbered(8, 320, 240), 1000.0, folder.path() / "1.png");
  const auto stream = tracking::openDepthStream(folder.path() / "1.png");
  EXPECT_EQ(stream->camera().fx, 285.63);
  EXPECT_FALSE(stream->facts().camera_known);
  EXPECT_EQ(stream->facts().camera_reason,
            "no camera file; 320 x 240 pixels, so the nominal numbers of a Kinect v1");
}

TEST(DepthStream, ReadsFreenectRecords) {
  const ScratchFolder folder;
  folder.write("INDEX.txt",
               "r-1300000000.100000-1.ppm\nd-1300000000.200000-2.pgm\na-1300000000.210000-2.dump\n"
               "d-1300000000.233000-3.pgm\n");
  folder.write("camera.yaml", cameraText());
  for (const int n : {2, 3}) {
    std::string pgm = "P5 8 6 65535\n";
    for (const float z : numbered(n * 4).z)
      pgm += bytesOf(z > 0.0f ? static_cast<unsigned>(
                                    std::lround((3.3309495161 - 1.0 / static_cast<double>(z)) / 0.0030711016))
                              : 2047u,
                     2);
    folder.write("d-1300000000." + std::string(n == 2 ? "200000-2" : "233000-3") + ".pgm", pgm);
  }
  const auto stream = tracking::openDepthStream(folder.path());
  EXPECT_EQ(stream->facts().format, "freenect");
  EXPECT_NEAR(stream->times().at(1), 0.033, 1e-6);
  EXPECT_EQ(numbers(*stream), (std::vector<int>{8, 12}));
  folder.write("INDEX.txt", "r-1300000000.100000-1.ppm\n");
  EXPECT_EQ(refusal(folder.path()), "found no depth frame (d-...pgm), expected at least one");
  folder.write("INDEX.txt", "d-x.pgm\n");
  EXPECT_EQ(refusal(folder.path()), "found 'd-x.pgm', expected d-TIME-TIMESTAMP.pgm");
}

TEST(DepthStream, ReadsCloudsTiffAndArrays) {
  const ScratchFolder clouds, tiffs, arrays;
  tracking::DepthCamera camera = tracking::parseDepthCamera(cameraText(12, 12), "c");
  camera.fx = camera.fy = 10.0;
  camera.cx = camera.cy = 5.5;
  std::string stack;
  tiffs.write("camera.yaml", cameraText());
  for (const int n : {9, 10}) {
    clouds.write(std::to_string(n) + ".pcd", pcd(numbered(n, 12, 12), camera, "binary_compressed"));
    TiffText tiff;
    tiff.width = 8;
    tiff.height = 6;
    for (const float z : numbered(n).z) {
      tiff.strip += bytesOf(static_cast<unsigned>(z * 1000.0f), 2);
      stack += bytesOf(std::bit_cast<std::uint32_t>(z), 4);
    }
    tiffs.write(std::to_string(n) + ".tif", tiff.bytes());
  }
  const auto cloud = tracking::openDepthStream(clouds.path());
  EXPECT_NEAR(cloud->camera().fx, 10.0, 1e-4);
  EXPECT_EQ(cloud->facts().format, "pcd");
  EXPECT_EQ(numbers(*cloud), (std::vector<int>{9, 10}));
  EXPECT_EQ(numbers(*tracking::openDepthStream(tiffs.path())), (std::vector<int>{9, 10}));
  const auto array = arrays.write("a.npy", npy("<f4", "(2, 6, 8)", stack));
  const auto camera_file = arrays.write("8x6.yaml", cameraText());
  EXPECT_EQ(numbers(*tracking::openDepthStream(array, {camera_file, 0.0})), (std::vector<int>{9, 10}));
  // Two kinds in one folder.
  tracking::saveDepthPng(numbered(1), 1000.0, clouds.path() / "1.png");
  EXPECT_EQ(refusal(clouds.path()), "found depth as png and as pcd in one folder, expected one kind");
}

TEST(DepthStream, ReportsReasonForRejection) {
  const ScratchFolder folder;
  EXPECT_EQ(refusal(folder.path() / "none"), "found no such file, expected a depth recording");
  EXPECT_EQ(refusal(folder.path()),
            "found no depth image in the folder, expected PNG of 16 bits, TIFF, PCD or NumPy");
  EXPECT_NE(refusal(folder.write("a.oni", "NI10 and more")).find("OpenNI"), std::string::npos);
  EXPECT_NE(refusal(folder.write("a.txt", "hello")).find("no depth recording"), std::string::npos);
}

TEST(DepthStream, RemovesDistortion) {
  const ScratchFolder folder;
  tracking::DepthCamera camera;
  camera.width = 64;
  camera.height = 48;
  camera.fx = camera.fy = 50.0;
  camera.cx = 31.5;
  camera.cy = 23.5;
  camera.distortion[0] = -0.2;
  folder.write("camera.yaml", tracking::describeDepthCamera(camera));
  // The one pixel that a lens with k1 = -0.2 shows for the ideal (55, 40): 1 + k1 rr nearer to the middle.
  const double x = (55 - 31.5) / 50.0, y = (40 - 23.5) / 50.0, shrink = 1.0 - 0.2 * (x * x + y * y);
  tracking::DepthImage image(64, 48);
  image.at(static_cast<int>(std::lround(50.0 * x * shrink + 31.5)),
           static_cast<int>(std::lround(50.0 * y * shrink + 23.5))) = 1.5f;
  tracking::saveDepthPng(image, 1000.0, folder.path() / "1.png");
  const auto stream = tracking::openDepthStream(folder.path());
  EXPECT_TRUE(stream->camera().distortion.isZero(0.0));
  tracking::DepthFrame frame;
  ASSERT_TRUE(stream->next(frame));
  EXPECT_EQ(frame.image.at(55, 40), 1.5f);
  EXPECT_EQ(stream->facts().notes.size(), 1u);
}

// Real recordings.

TEST(DepthStream, FivePeopleMatchPcl) {
  const auto file = sharedData("depth/pcl/five_people.pcd");
  if (!exists(file)) GTEST_SKIP() << file;
  const auto stream = tracking::openDepthStream(file);
  EXPECT_NEAR(stream->camera().fx, 525.0, 0.01);
  EXPECT_NEAR(stream->camera().fy, 525.0, 0.01);
  tracking::DepthFrame frame;
  ASSERT_TRUE(stream->next(frame));
  std::size_t measured = 0;
  double sum = 0.0;
  for (const float z : frame.image.z) measured += z > 0.0f, sum += static_cast<double>(z);
  // What PCL 1.13's loadPCDFile gives for this file.
  EXPECT_EQ(measured, 239075u);
  EXPECT_NEAR(sum, 754365.616794944, 1e-6);
}

TEST(DepthStream, ItopArrayMatchesImage) {
  const auto array = sharedData("depth/itop/ITOP_train_000000000053.npy");
  if (!exists(array)) GTEST_SKIP() << array;
  tracking::DepthFrame a, b;
  const auto stream = tracking::openDepthStream(array);
  EXPECT_EQ(stream->camera().fx, 285.7143);
  ASSERT_TRUE(stream->next(a));
  ASSERT_TRUE(tracking::openDepthStream(sharedData("depth/itop/ITOP_train_000000000053.png"))->next(b));
  EXPECT_EQ(a.image.z, b.image.z);
}

TEST(DepthStream, UtdMhadMatrixMatchesImages) {
  const auto file = sharedData("depth/utd_mhad/a18_s1_t1_depth.mat");
  if (!exists(file)) GTEST_SKIP() << file;
  const auto matrix = tracking::openDepthStream(file),
             images = tracking::openDepthStream(sharedData("depth/utd_mhad/a18_s1_t1"));
  EXPECT_EQ(matrix->facts().format, "utd-mhad");
  EXPECT_EQ(matrix->size(), 65u);
  tracking::DepthFrame a, b;
  while (matrix->next(a)) {
    ASSERT_TRUE(images->next(b));
    // The set's images are mirrored; of the matrix that is known, of loose images it is not.
    for (int v = 0; v < b.image.height; ++v)
      std::reverse(&b.image.at(0, v), &b.image.at(0, v) + b.image.width);
    ASSERT_EQ(a.image.z, b.image.z) << a.t;
  }
  EXPECT_FALSE(images->next(b));
}

TEST(DepthStream, ReadsPackBitsTiff) {
  const auto folder = sharedData("depth/pcl/grabber");
  if (!exists(folder)) GTEST_SKIP() << folder;
  tracking::DepthFrame frame;
  ASSERT_TRUE(tracking::openDepthStream(folder)->next(frame));
  std::size_t measured = 0;
  for (const float z : frame.image.z) measured += z > 0.3f && z < 10.0f;
  EXPECT_GT(measured, frame.image.z.size() / 2);
}

}  // namespace depth_stream_test
}  // namespace abstand::testing
