// abstand calibrate --chessboard: pose and lens of a camera from images of a board.
#include "app/cli/calibrate_modes.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "tracking/depth/calibration/board_pose.hpp"

namespace abstand::cli {
namespace {

tracking::Chessboard boardOf(const CalibrateArguments& args) {
  tracking::Chessboard board;
  const std::string_view text = args.squares;
  const std::size_t cross = std::min(text.find('x'), text.size());
  board.columns = parseInt(text.substr(0, cross)).value_or(0);
  board.rows = parseInt(text.substr(std::min(cross + 1, text.size()))).value_or(0);
  if (std::min(board.columns, board.rows) < tracking::Chessboard::kMinSquares ||
      std::max(board.columns, board.rows) > tracking::Chessboard::kMaxSquares)
    throw UsageError("--squares: found '" + args.squares +
                     "', expected the squares along both sides, 4 to 40 each, like 8x5");
  if (board.columns == board.rows)
    throw UsageError(
        "--squares: found a square board, whose orientation is ambiguous, expected 8x5 or the "
        "like");
  board.square = numberWithin(args.square, "--square", 1e-3, 1.0, "m");
  return board;
}

Transform placeOf(const std::string& text) {
  const std::vector<double> v = numberList(text, "--board");
  if (v.size() != 3 && v.size() != 6)
    throw UsageError("--board: found '" + text + "', expected X,Y,Z or X,Y,Z,ROLL,PITCH,YAW (m, rad)");
  return fromXyzRpy({v[0], v[1], v[2]}, v.size() == 6 ? Vector3d(v[3], v[4], v[5]) : Vector3d::Zero());
}

/// Hint for users who counted inner corners, or squares as corners.
std::string hintOf(const tracking::GreyImage& image, const tracking::Chessboard& board) {
  for (const int more : {1, -1}) {
    const tracking::Chessboard other{board.columns + more, board.rows + more, board.square};
    if (std::min(other.columns, other.rows) >= tracking::Chessboard::kMinSquares &&
        tracking::findChessboard(image, other))
      return "the image shows a board of " + std::to_string(other.columns) + " x " +
             std::to_string(other.rows) + " squares; --squares counts squares, not inner corners";
  }
  return {};
}

/// Corners in each image; all images have one size.
std::vector<tracking::BoardCorners> cornersIn(const CalibrateArguments& args,
                                              const tracking::Chessboard& board, int& width, int& height) {
  std::vector<tracking::BoardCorners> views;
  for (const std::filesystem::path& file : args.images) {
    const tracking::GreyImage image = tracking::loadGreyPng(file);
    if (width == 0) width = image.width, height = image.height;
    if (image.width != width || image.height != height)
      throw ParseError({file.string()}, format("found %d x %d pixels, expected the camera's %d x %d",
                                               image.width, image.height, width, height));
    auto corners = tracking::findChessboard(image, board);
    if (!corners)
      throw ParseError(
          {file.string()},
          format("found no complete chessboard, expected one of %d x %d squares", board.columns, board.rows),
          hintOf(image, board));
    views.push_back(std::move(*corners));
  }
  return views;
}

/// Each view with the pose of its board: one pose for all, or one for each of the first views.
std::vector<tracking::PlacedBoard> placed(const CalibrateArguments& args,
                                          const std::vector<tracking::BoardCorners>& views) {
  const std::size_t places = args.boards.size();
  if (places > views.size() || (!args.intrinsics && places != 1 && places != views.size()))
    throw UsageError(format("--board: found %zu poses for %zu images, expected one for all or one for each",
                            places, views.size()));
  const std::size_t count = args.intrinsics ? places : views.size();
  std::vector<tracking::PlacedBoard> boards;
  for (std::size_t i = 0; i < count; ++i)
    boards.push_back({views[i], placeOf(args.boards[places == 1 ? 0 : i])});
  return boards;
}

}  // namespace

int calibrateByBoard(const CommandLine& line, const CalibrateArguments& args) {
  if (args.squares.empty() || args.square.empty())
    throw UsageError("--chessboard: found no --squares or no --square, expected both");
  if (args.boards.empty() && !args.intrinsics)
    throw UsageError("--chessboard: found neither --board nor --intrinsics, expected one or both");
  if (args.camera.empty() && !args.intrinsics)
    throw UsageError("--camera: found none, expected a camera file, or --intrinsics");
  const tracking::Chessboard board = boardOf(args);
  tracking::DepthCamera camera;
  int width = 0, height = 0;
  if (!args.camera.empty()) {
    camera = tracking::loadDepthCamera(args.camera);
    width = camera.width;
    height = camera.height;
  }
  const std::vector<tracking::BoardCorners> views = cornersIn(args, board, width, height);
  nlohmann::ordered_json document{{"images", views.size()}, {"corners", views.size() * board.corners()}};
  std::string text = format("%zu images, %zu corners\n", views.size(), views.size() * board.corners());
  if (args.intrinsics) {
    const tracking::IntrinsicsFit fit = tracking::fitIntrinsics(board, views, width, height);
    const tracking::DepthCamera& c = fit.camera;
    camera.width = c.width;
    camera.height = c.height;
    camera.fx = c.fx;
    camera.fy = c.fy;
    camera.cx = c.cx;
    camera.cy = c.cy;
    camera.distortion = c.distortion;
    document["intrinsics"] = {{"fx", c.fx},
                              {"fy", c.fy},
                              {"cx", c.cx},
                              {"cy", c.cy},
                              {"distortion", std::vector<double>(c.distortion.begin(), c.distortion.end())},
                              {"rms_px", fit.rms},
                              {"focal_spread", fit.focal_spread}};
    text += format(
        "lens: fx %.2f, fy %.2f, cx %.2f, cy %.2f, reprojection error %.3f pixels; focal lengths within %.2f "
        "%%\n",
        c.fx, c.fy, c.cx, c.cy, fit.rms, 100.0 * fit.focal_spread);
  }
  if (!args.boards.empty()) {
    const tracking::BoardFit fit = tracking::fitBoardPose(camera, board, placed(args, views));
    camera.X_WC = fit.X_WC;
    camera.spread = fit.spread;
    document["T_WC"] = rowsOf(fit.X_WC);
    document["rms_px"] = fit.rms;
    document["worst_px"] = fit.worst;
    document["worst_image"] = args.images[fit.worst_view].string();
    document["depth"] = fit.depth;
    document["spread"] = fit.spread;
    text += format("RMS reprojection error %.3f pixels at %.2f m, maximum %.3f in %s\n", fit.rms, fit.depth,
                   fit.worst, args.images[fit.worst_view].filename().string().c_str()) +
            placedText(fit.X_WC, fit.spread);
  }
  if (!args.out.empty()) writeFile(args.out, tracking::describeDepthCamera(camera));
  line.print(document, text);
  return kDone;
}

}  // namespace abstand::cli
