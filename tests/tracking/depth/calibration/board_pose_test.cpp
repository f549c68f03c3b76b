// Cameras placed by pictures of chessboards whose truth is known.
#include "tracking/depth/calibration/board_pose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/math/random.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/tracking/depth/calibration/board_picture.hpp"
#include "tests/tracking/depth/calibration/pose_errors.hpp"
#include "tracking/depth/calibration/pose_spread.hpp"

namespace abstand::testing {
namespace board_pose_test {

/// Pixels; of corners in pictures with noise of 2 levels, in which a square is 14 to 25 pixels broad.
constexpr double kCornerOff = 0.2;

const tracking::Chessboard kBoard{8, 5, 0.03};
const tracking::Chessboard kSameTurned{8, 6, 0.03};

Transform boardOnTable() { return fromXyzRpy({0.4, -0.2, 0.75}, {0.0, 0.0, 0.6}); }

tracking::PlacedBoard seen(const tracking::DepthCamera& camera, const tracking::Chessboard& board,
                           const Transform& X_WO, const BoardPictureOptions& options = {}) {
  const auto corners = tracking::findChessboard(pictureOf(camera, board, X_WO, options), board);
  if (!corners) throw UsageError("no board");
  return {*corners, X_WO};
}

/// A camera that knows nothing of its pose.
tracking::DepthCamera unplaced(tracking::DepthCamera camera) {
  camera.X_WC = Transform::Identity();
  return camera;
}

TEST(Chessboard, CornersAreFoundInBoardOrder) {
  for (const double roll : {0.0, 1.2, kPi}) {
    tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), 0.7, 0.5, 0.4, roll);
    camera.distortion << -0.15, 0.05, 0.001, -0.001, 0.0;
    const tracking::PlacedBoard board = seen(camera, kBoard, boardOnTable());
    ASSERT_EQ(board.corners.size(), 28u);
    for (std::size_t i = 0; i < board.corners.size(); ++i) {
      const Vector3d p_C = camera.X_WC.inverse() * (boardOnTable() * kBoard.corner(i));
      EXPECT_LT((board.corners[i] - camera.pixelOf(p_C)).norm(), kCornerOff) << roll << ", " << i;
    }
  }
}

TEST(Chessboard, RimIsNotTakenForRowOfSquares) {
  // A view in which OpenCV's search by sectors takes the rim for a row.
  tracking::DepthCamera camera;
  camera.X_WC.linear() = Quaterniond(-0.445374, 0.057295, 0.882136, 0.142112).normalized().toRotationMatrix();
  camera.X_WC.translation() = Vector3d(0.628633, -0.166231, 0.394025);
  camera.distortion << -0.2, 0.06, 0.001, -0.0005, 0.0;
  const tracking::PlacedBoard board = seen(camera, kBoard, Transform::Identity(), {.seed = 17});
  for (std::size_t i = 0; i < board.corners.size(); ++i) {
    const Eigen::Vector2d truth = camera.pixelOf(camera.X_WC.inverse() * kBoard.corner(i));
    EXPECT_LT((board.corners[i] - truth).norm(), 2.0 * kCornerOff) << i;  // it leans by 60 degrees
  }
}

TEST(Chessboard, FindsNothingWithoutMatchingBoard) {
  const tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), 0.7, 0.4, 0.0, 0.0);
  const tracking::GreyImage image = pictureOf(camera, kBoard, boardOnTable());
  EXPECT_FALSE(tracking::findChessboard(image, {9, 6, 0.03}).has_value());
  EXPECT_FALSE(tracking::findChessboard(tracking::GreyImage(640, 480), kBoard).has_value());
  // Half of it is beside the image.
  const tracking::DepthCamera near = cameraBefore(kBoard, boardOnTable(), 0.15, 0.0, 0.0, 0.0);
  EXPECT_FALSE(tracking::findChessboard(pictureOf(near, kBoard, boardOnTable()), kBoard).has_value());
}

TEST(BoardPose, RecoversPose) {
  struct Case {
    double distance, lean, side, roll;
  };
  std::uint64_t seed = 1;
  for (const Case& c : {Case{0.6, 0.5, 0.0, 0.0}, Case{0.8, 0.9, 2.0, 3.0}, Case{1.2, 0.6, -1.0, 0.3}}) {
    tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), c.distance, c.lean, c.side, c.roll);
    camera.distortion << -0.2, 0.06, 0.001, -0.0005, 0.0;
    const tracking::PlacedBoard board = seen(camera, kBoard, boardOnTable(), {.seed = seed++});
    const tracking::BoardFit fit = tracking::fitBoardPose(unplaced(camera), kBoard, std::span(&board, 1));
    EXPECT_LT(fit.rms, kCornerOff);
    EXPECT_NEAR(fit.depth, c.distance, 0.05);
    // Corners to 0.05 pixels: 0.1 mm across at 1.2 m, along the rays some 10 times that.
    EXPECT_LT((fit.X_WC.translation() - camera.X_WC.translation()).norm(), 0.003) << c.distance;
    EXPECT_LT(angleBetween(fit.X_WC, camera.X_WC), unit::deg(0.2)) << c.distance;
    // What is said of it holds a metre beside the board, too.
    const Vector3d p_C = camera.X_WC.inverse() * (boardOnTable() * Vector3d(0.7, 0.7, 0.3));
    EXPECT_LT((fit.X_WC * p_C - camera.X_WC * p_C).norm(), 3.0 * std::sqrt(3.0) * fit.spread) << c.distance;
    EXPECT_LT(fit.spread, 0.004);
  }
}

TEST(BoardPose, SeveralPlacementsAreOneFit) {
  const tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), 1.0, 0.6, 0.3, 0.0);
  const Transform beside = boardOnTable() * fromXyzRpy({0.1, 0.15, 0.05}, {0.2, -0.1, 0.5});
  const std::vector<tracking::PlacedBoard> boards{seen(camera, kBoard, boardOnTable()),
                                                  seen(camera, kBoard, beside)};
  const tracking::BoardFit one = tracking::fitBoardPose(unplaced(camera), kBoard, std::span(boards).first(1));
  const tracking::BoardFit both = tracking::fitBoardPose(unplaced(camera), kBoard, boards);
  EXPECT_LT((both.X_WC.translation() - camera.X_WC.translation()).norm(), 0.003);
  EXPECT_LT(both.spread, one.spread);
  // A place that is wrong by 2 cm is seen in what is left.
  std::vector<tracking::PlacedBoard> wrong = boards;
  wrong[1].X_WO.translation().x() += 0.02;
  EXPECT_THROW(tracking::fitBoardPose(unplaced(camera), kBoard, wrong), UsageError);
}

TEST(BoardPose, SymmetricBoardNeedsRoughPose) {
  for (const double roll : {0.0, 3.0}) {
    const tracking::DepthCamera camera = cameraBefore(kSameTurned, boardOnTable(), 0.7, 0.5, 0.2, roll);
    const tracking::PlacedBoard board = seen(camera, kSameTurned, boardOnTable());
    try {
      tracking::fitBoardPose(unplaced(camera), kSameTurned, std::span(&board, 1));
      FAIL() << "taken";
    } catch (const UsageError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr("a board with ambiguous orientation (8 x 6)"));
    }
    tracking::DepthCamera rough = camera;
    rough.X_WC = camera.X_WC * fromXyzRpy({0.3, -0.2, 0.1}, {0.5, 0.3, -0.4});
    const tracking::BoardFit fit = tracking::fitBoardPose(rough, kSameTurned, std::span(&board, 1));
    EXPECT_LT((fit.X_WC.translation() - camera.X_WC.translation()).norm(), 0.003) << roll;
  }
}

/// Corners as a camera with `noise` (pixels) measures them, without a picture.
tracking::PlacedBoard measured(const tracking::DepthCamera& camera, const Transform& X_WO, double noise,
                               std::uint64_t seed) {
  Random random(seed, 0);
  tracking::PlacedBoard board;
  board.X_WO = X_WO;
  for (std::size_t i = 0; i < kBoard.corners(); ++i) {
    Eigen::Vector2d p = camera.pixelOf(camera.X_WC.inverse() * (X_WO * kBoard.corner(i)));
    for (int k = 0; k < 2; ++k) p[k] += noise * std::sqrt(12.0) * (random.unit() - 0.5);
    board.corners.push_back(p);
  }
  return board;
}

TEST(BoardPose, CovarianceMatchesMonteCarlo) {
  constexpr double kNoise = 0.2;  // pixels
  constexpr int kSets = 300;
  const tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), 0.8, 0.7, 0.2, 0.0);
  const Vector3d middle = boardOnTable() * Vector3d(0.09, 0.045, 0.0);
  double said = 0.0;
  Matrix3d around = Matrix3d::Zero(), of_camera = Matrix3d::Zero();
  for (int i = 0; i < kSets; ++i) {
    const tracking::PlacedBoard board =
        measured(camera, boardOnTable(), kNoise, static_cast<std::uint64_t>(i) + 1);
    const tracking::BoardFit fit = tracking::fitBoardPose(unplaced(camera), kBoard, std::span(&board, 1));
    const double across = kNoise * fit.depth / camera.fx;
    said += fit.spread * fit.spread - across * across;
    // Points on a sphere of a metre about the board's middle: its six poles stand for all directions.
    const auto squares = [&](const Vector3d& p_W) -> Matrix3d {
      const Vector3d off = fit.X_WC * (camera.X_WC.inverse() * p_W) - p_W;
      return off * off.transpose();
    };
    for (int k = 0; k < 6; ++k)
      around +=
          squares(middle + (k % 2 ? -tracking::kUsedWithin : tracking::kUsedWithin) * Vector3d::Unit(k / 2)) /
          6.0;
    of_camera += squares(camera.X_WC.translation());
  }
  const auto largest = [](const Matrix3d& sum) {
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(sum).eigenvalues()[2];
  };
  // 300 sets of mostly one bad direction: their mean square is within a fourth.
  EXPECT_NEAR(said / std::max(largest(around), largest(of_camera)), 1.0, 0.25);
}

TEST(BoardPose, RejectsAmbiguousPoses) {
  const tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), 6.0, 0.4, 0.2, 0.0);
  const tracking::PlacedBoard board = measured(camera, boardOnTable(), 0.5, 3);
  EXPECT_THROW(tracking::fitBoardPose(unplaced(camera), kBoard, std::span(&board, 1)), UsageError);
  const tracking::BoardFit fit = tracking::fitBoardPose(camera, kBoard, std::span(&board, 1));
  EXPECT_LT((fit.X_WC.translation() - camera.X_WC.translation()).norm(), 1.0);
  EXPECT_GT(fit.spread, 0.01);
}

TEST(Intrinsics, AreRecovered) {
  std::vector<tracking::BoardCorners> views;
  tracking::DepthCamera truth;
  for (int i = 0; i < 6; ++i) {
    tracking::DepthCamera camera =
        cameraBefore(kBoard, boardOnTable(), 0.42 + 0.05 * i, 0.55, 1.1 * i, 0.3 * i);
    camera.fx = 571.0;
    camera.fy = 574.0;
    camera.cx = 312.0;
    camera.cy = 246.0;
    camera.distortion << -0.12, 0.04, 0.0, 0.0, 0.0;
    truth = camera;
    views.push_back(
        seen(camera, kBoard, boardOnTable(), {.seed = static_cast<std::uint64_t>(i) + 1}).corners);
  }
  const tracking::IntrinsicsFit fit = tracking::fitIntrinsics(kBoard, views, 640, 480);
  EXPECT_LT(fit.rms, 0.1);
  EXPECT_LT(fit.focal_spread, 0.01);
  EXPECT_NEAR(fit.camera.fx, truth.fx, 0.005 * truth.fx);
  EXPECT_NEAR(fit.camera.fy, truth.fy, 0.005 * truth.fy);
  EXPECT_NEAR(fit.camera.cx, truth.cx, 3.0);
  EXPECT_NEAR(fit.camera.cy, truth.cy, 3.0);
  // The coefficients share one curve; what counts is where they put a pixel halfway to the image's corner.
  const Vector3d aside(0.28, 0.2, 1.0);
  EXPECT_LT((fit.camera.pixelOf(aside) - truth.pixelOf(aside)).norm(), 3.0);
  EXPECT_THROW(tracking::fitIntrinsics(kBoard, std::span(views).first(4), 640, 480), UsageError);
}

TEST(Intrinsics, FrontalBoardsLeaveFocalLengthUndetermined) {
  std::vector<tracking::BoardCorners> views;
  for (int i = 0; i < 5; ++i) {
    const tracking::DepthCamera camera = cameraBefore(kBoard, boardOnTable(), 0.5, 0.0, 0.0, 0.5 * i);
    views.push_back(measured(camera, boardOnTable(), 0.1, static_cast<std::uint64_t>(i) + 1).corners);
  }
  try {
    tracking::fitIntrinsics(kBoard, views, 640, 480);
    FAIL() << "taken";
  } catch (const UsageError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("do not determine the focal length"));
  }
}

}  // namespace board_pose_test
}  // namespace abstand::testing
