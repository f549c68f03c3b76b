#include "tracking/kinect/ui_prmd.hpp"

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/kinect/kinect_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kNumbers = 66;
constexpr double kRate = 30.0;

bool nextRow(Lines& lines, const std::string& file, std::vector<double>& row) {
  std::string_view line;
  do {
    if (!lines.next(line)) return false;
  } while (line.empty());
  row.clear();
  Cells cells(line, file, lines.number());
  for (std::size_t i = 0; i < kNumbers; ++i) row.push_back(cells.number(cells.need("66 numbers")));
  std::string_view more;
  if (cells.next(more))
    throw ParseError(cells.pos(), "found " + text::inQuotes(more) + ", expected 66 numbers");
  return true;
}

Vector3d threeOf(const std::vector<double>& row, std::size_t joint) {
  return {row[3 * joint], row[3 * joint + 1], row[3 * joint + 2]};
}

Matrix3d rotation(const Vector3d& degrees) {
  const Vector3d a = degrees * (kPi / 180.0);
  return (Eigen::AngleAxisd(a.z(), Vector3d::UnitZ()) * Eigen::AngleAxisd(a.x(), Vector3d::UnitX()) *
          Eigen::AngleAxisd(a.y(), Vector3d::UnitY()))
      .toRotationMatrix();
}

}  // namespace

bool looksLikeUiPrmd(std::string_view text) {
  std::string_view line, cell;
  if (!Lines(text).next(line)) return false;
  const std::string file;
  Cells cells(line, file, 1);
  std::size_t numbers = 0;
  while (cells.next(cell)) {
    if (!parseDouble(cell)) return false;
    ++numbers;
  }
  return numbers == kNumbers;
}

std::filesystem::path uiPrmdPartner(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (const auto& [one, other] : {std::pair{"positions", "angles"}, {"angles", "positions"}}) {
    const auto at = name.rfind(one);
    if (at == std::string::npos) continue;
    std::string partner = name;
    partner.replace(at, std::string_view(one).size(), other);
    const auto path = file.parent_path() / partner;
    std::error_code ec;
    if (std::filesystem::exists(path, ec)) return path;
    throw ParseError({file.string()}, std::string("found the ") + one +
                                          " of a UI-PRMD skeleton without its " + other + ", expected " +
                                          text::inQuotes(partner) + " next to it");
  }
  throw ParseError(
      {file.string(), 1},
      "found 66 numbers a line as in UI-PRMD, expected 'positions' or 'angles' in the name of the "
      "file, to find the other one");
}

UiPrmdReader::UiPrmdReader(std::string_view positions, std::string positions_file, std::string_view angles,
                           std::string angles_file)
    : positions_file_(std::move(positions_file)),
      angles_file_(std::move(angles_file)),
      positions_(positions),
      angles_(angles) {
  facts_.format = "ui-prmd";
  facts_.sensor = kKinectError;
  facts_.rate = kRate;
  facts_.rate_reason = "no time in the file; the set was recorded at 30 Hz";
}

std::span<const std::string> UiPrmdReader::names() const { return uiPrmdJoints(); }

std::vector<int> UiPrmdReader::parents() const {
  const auto parents = uiPrmdParents();
  return {parents.begin(), parents.end()};
}

std::vector<Vector3d> UiPrmdReader::turnRest() const { return rest_; }

void UiPrmdReader::keepRest() {
  const auto parents = uiPrmdParents();
  for (std::size_t i = 0; i < parents.size(); ++i)
    rest_.push_back(threeOf(p_, i) + (parents[i] < 0 ? Vector3d(Vector3d::Zero())
                                                     : rest_[static_cast<std::size_t>(parents[i])]));
}

bool UiPrmdReader::next(PointFrame& frame) {
  const bool has_places = nextRow(positions_, positions_file_, p_),
             has_angles = nextRow(angles_, angles_file_, a_);
  if (has_places != has_angles)
    throw ParseError(has_places ? SourcePos{angles_file_, angles_.number()}
                                : SourcePos{positions_file_, positions_.number()},
                     "found the end after " + std::to_string(frames_) +
                         " frames, expected as many as in the other file of the pair");
  if (!has_places) {
    if (frames_ == 0) throw ParseError({positions_file_, 1}, "found no frame, expected at least one");
    return false;
  }
  const auto parents = uiPrmdParents();
  std::array<Matrix3d, kNumbers / 3> R_FJ;
  frame.clear(parents.size());
  if (frames_ == 0) keepRest();
  for (std::size_t i = 0; i < parents.size(); ++i) {
    R_FJ[i] = rotation(threeOf(a_, i));
    Vector3d p = threeOf(p_, i);
    if (parents[i] >= 0) {
      const auto parent = static_cast<std::size_t>(parents[i]);
      p = frame.p[parent] + R_FJ[parent] * p;
      R_FJ[i] = R_FJ[parent] * R_FJ[i];
    }
    frame.set(i, p);
  }
  frame.turn.assign(R_FJ.begin(), R_FJ.end());
  frame.t = static_cast<double>(frames_++) / kRate;
  return true;
}

}  // namespace abstand::tracking
