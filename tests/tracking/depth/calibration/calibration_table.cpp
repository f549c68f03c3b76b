// Prints the tables of docs/camera-calibration.md, which scripts/calibration-table writes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <vector>

#include "core/base/error.hpp"
#include "tests/tracking/depth/calibration/board_picture.hpp"
#include "tests/tracking/depth/calibration/links_trial.hpp"
#include "tests/tracking/depth/calibration/pcl_table.hpp"
#include "tests/tracking/depth/calibration/room_cases.hpp"
#include "tracking/depth/calibration/board_pose.hpp"
#include "tracking/depth/calibration/room_pose.hpp"

namespace abstand::testing {
namespace {

struct Outcome {
  double camera_error, spread;  ///< m
};

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// One row: cases, position error of the camera, median spread, their ratio, and the share up to 3 spreads.
/// `trial` throws UsageError for a refused case.
void printRow(const std::string& name, std::uint64_t seeds,
              const std::function<Outcome(std::uint64_t seed)>& trial) {
  std::vector<double> errors, spreads, ratios;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    try {
      const Outcome outcome = trial(seed);
      errors.push_back(outcome.camera_error);
      spreads.push_back(outcome.spread);
      ratios.push_back(outcome.camera_error / outcome.spread);
    } catch (const UsageError& e) {
      std::fprintf(stderr, "%s, seed %d: %s\n", name.c_str(), static_cast<int>(seed), e.what());
    }
  }
  std::printf("| %s | %zu of %zu |", name.c_str(), errors.size(), static_cast<std::size_t>(seeds));
  if (!errors.empty()) {
    std::sort(spreads.begin(), spreads.end());
    const auto within = std::count_if(ratios.begin(), ratios.end(), [](double r) { return r <= 3.0; });
    std::printf(" %.1f; %.1f mm | %.1f mm | %.2f; %.2f | %.3f |", 1e3 * rootMeanSquare(errors),
                1e3 * *std::max_element(errors.begin(), errors.end()), 1e3 * spreads[spreads.size() / 2],
                rootMeanSquare(ratios), *std::max_element(ratios.begin(), ratios.end()),
                static_cast<double>(within) / static_cast<double>(ratios.size()));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void printLinks() {
  for (const double aside : {0.0, 0.52})
    for (const int images : {1, 2, 4, 8})
      for (const double distance : {1.5, 1.9, 2.5, 3.0, 3.5, 4.0, 4.5}) {
        char name[100];
        std::snprintf(name, sizeof name, "links | %.1f m, %s | %d", distance,
                      aside > 0.0 ? "half of it out of the image" : "in the middle", images);
        printRow(name, 40, [&](std::uint64_t seed) {
          const LinksTrial trial = linksTrial({distance, images, aside * distance}, seed);
          if (!trial.is_taken) throw UsageError(trial.refusal);
          return Outcome{trial.camera_error, trial.fit.spread};
        });
      }
}

void printRoom() {
  for (const int walls : {2, 1, 0})
    for (const int images : {1, 5, 20}) {
      const std::string name =
          "room | 2.2 to 3 m, " + std::to_string(walls) + " walls | " + std::to_string(images);
      printRow(name, 20, [&](std::uint64_t seed) {
        const RoomCase c = roomCase({.walls = walls}, seed, 320, images);
        const tracking::RoomFit fit = tracking::fitPoseToRoom(c.known, c.camera);
        return Outcome{(fit.X_WC.translation() - c.truth.translation()).norm(), fit.spread};
      });
    }
}

void printBoard() {
  const tracking::Chessboard board{8, 5, 0.03};
  const Transform X_WO = fromXyzRpy({0.4, -0.2, 0.75}, {0.0, 0.0, 0.6});
  for (const double distance : {0.7, 1.2, 2.0}) {
    char name[100];
    std::snprintf(name, sizeof name, "chessboard | %.1f m | 1", distance);
    printRow(name, 40, [&](std::uint64_t seed) {
      const auto k = static_cast<double>(seed);
      tracking::DepthCamera camera =
          cameraBefore(board, X_WO, distance, 0.4 + 0.5 * std::fmod(0.618 * k, 1.0), 0.7 * k, 0.2 * k);
      camera.distortion << -0.2, 0.06, 0.001, -0.0005, 0.0;
      const auto corners = tracking::findChessboard(pictureOf(camera, board, X_WO, {.seed = seed}), board);
      if (!corners) throw UsageError("no board");
      tracking::DepthCamera unplaced = camera;
      unplaced.X_WC = Transform::Identity();
      const tracking::PlacedBoard placed{*corners, X_WO};
      const tracking::BoardFit fit = tracking::fitBoardPose(unplaced, board, std::span(&placed, 1));
      return Outcome{(fit.X_WC.translation() - camera.X_WC.translation()).norm(), fit.spread};
    });
  }
}

}  // namespace
}  // namespace abstand::testing

int main(int argc, char** argv) {
  using namespace abstand::testing;
  const auto is_wanted = [&](const char* name) { return argc < 2 || std::strcmp(argv[1], name) == 0; };
  const char* kSpreadHeader =
      "| method | view | images | taken | position error: RMS; max | spread: median | error / spread: RMS; "
      "max "
      "| within 3 spreads |\n|---|---|---:|---:|---|---:|---|---:|\n";
  if (is_wanted("links") || is_wanted("room") || is_wanted("chessboard")) std::fputs(kSpreadHeader, stdout);
  if (is_wanted("chessboard")) printBoard();
  if (is_wanted("room")) printRoom();
  if (is_wanted("links")) printLinks();
  if (is_wanted("normals")) printNormals();
  if (is_wanted("voxels")) printVoxelGrids();
  return 0;
}
