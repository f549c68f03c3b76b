#include "tracking/table/skeleton_csv.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>

#include "core/base/clock_range.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/text/message_text.hpp"
#include "tracking/markers/point_recording.hpp"

namespace abstand::tracking {
namespace {

/// Hz; used if a table counts frames and states no rate.
constexpr double kAssumedRate = 30.0;

double confidenceOf(humanmodel::JointState s) {
  if (s == humanmodel::JointState::kMissing) return 0.0;
  return s == humanmodel::JointState::kTracked ? kTrackedConfidence : kInferredConfidence;
}

double spreadOf(const Cells& cells, double v) {
  if (v >= 0.0 && v <= kLargestCoordinate) return v;
  throw ParseError(cells.pos(), "found the spread " + formatDouble(v) + ", expected 0 or more");
}

/// s, since any moment or since 1970 UTC.
double secondsOf(const Cells& cells, std::string_view cell) {
  const std::optional<double> t = parseDouble(cell);
  if (t && *t >= kLatestClock)
    throw ParseError(cells.pos(), "found the time " + text::inQuotes(cell) +
                                      ", expected seconds, at most 1e11: since the start or since 1970");
  return t && *t >= kEarliestClock ? *t : cells.number(cell);
}

void setElement(const CovarianceColumn& at, double v, Matrix3d& covariance) {
  covariance(at.row, at.column) = covariance(at.column, at.row) = v;
}

bool isStated(const Matrix3d& covariance) { return !covariance.isZero(0.0); }

}  // namespace

void writeSkeletonCsv(std::ostream& out, const Recording& recording) {
  std::vector<std::size_t> joints;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (std::any_of(recording.frames.begin(), recording.frames.end(),
                    [j](const humanmodel::SkeletonFrame& f) {
                      return f.state[j] != humanmodel::JointState::kMissing;
                    }))
      joints.push_back(j);
  std::array<bool, humanmodel::kJointCount> has_spread{}, has_covariance{}, has_lateral{};
  for (const auto& f : recording.frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      has_covariance[j] |= isStated(f.covariance[j]);
      has_lateral[j] |= !f.lateral[j].isZero(0.0f);
      has_spread[j] |= f.spread[j] > 0.0 || has_covariance[j];
    }
  out << 't';
  for (const auto j : joints) {
    for (const char* field : {".x", ".y", ".z", ".confidence"})
      out << ',' << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << field;
    if (has_spread[j]) out << ',' << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << ".spread";
    for (const CovarianceColumn& column : kCovarianceColumns)
      if (has_covariance[j])
        out << ',' << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << '.' << column.name;
    for (const std::string_view column : kLateralColumns)
      if (has_lateral[j])
        out << ',' << humanmodel::jointName(static_cast<humanmodel::Joint>(j)) << '.' << column;
  }
  out << '\n';
  for (const auto& f : recording.frames) {
    out << formatDouble(f.t);
    for (const auto j : joints) {
      const bool known = f.state[j] != humanmodel::JointState::kMissing;
      for (int k = 0; k < 3; ++k) out << ',' << (known ? formatDouble(f.p[j][k]) : "");
      out << ',' << formatDouble(confidenceOf(f.state[j]));
      if (has_spread[j]) out << ',' << (known ? formatDouble(f.spread[j]) : "");
      const bool has_shape = known && isStated(f.covariance[j]);
      for (const CovarianceColumn& at : kCovarianceColumns)
        if (has_covariance[j])
          out << ',' << (has_shape ? formatDouble(f.covariance[j](at.row, at.column)) : "");
      const bool has_axis = known && !f.lateral[j].isZero(0.0f);
      for (int k = 0; k < 3 && has_lateral[j]; ++k)
        out << ',' << (has_axis ? formatDouble(static_cast<double>(f.lateral[j][k])) : "");
    }
    out << '\n';
  }
}

void writeSkeletonCsv(const std::filesystem::path& file, const Recording& recording) {
  OutputFile out(file);
  writeSkeletonCsv(out.stream(), recording);
  out.commit();
}

bool looksLikeSkeletonCsv(std::string_view text) {
  std::string_view line;
  return Lines(text).next(line) && looksLikeCsvColumns(line);
}

SkeletonCsvReader::SkeletonCsvReader(std::string_view text, std::string file)
    : file_(std::move(file)), lines_(text) {
  std::string_view line;
  if (!lines_.next(line)) throw ParseError({file_}, "the file is empty");
  head_ = parseCsvColumns(line, file_);
  facts_.format = "csv";
  facts_.rate_reason = "the median step of t";
  facts_.is_canonical = head_.is_canonical;
  if (head_.is_canonical) {
    facts_.unit = UnitChoice{"m", "the format's own", 1.0, ""};
    facts_.up = UpChoice{"z", "the format's own", ""};
  }
  if (head_.time == CsvTime::kFrames) {
    facts_.rate = kAssumedRate;
    facts_.rate_reason = "the file counts frames and gives no rate: 30 Hz are assumed";
  }
}

bool SkeletonCsvReader::next(PointFrame& frame) {
  std::string_view line;
  do {
    if (!lines_.next(line)) {
      if (frames_ == 0)
        throw ParseError({file_, lines_.number() + 1}, "found no frame, expected at least one");
      return false;
    }
  } while (line.empty());
  Cells cells(line, file_, lines_.number());
  std::string_view cell;
  cells.next(cell);
  const bool counts = head_.time == CsvTime::kFrames;
  const double t = counts ? cells.number(cell) : secondsOf(cells, cell);
  if (frames_ == 0 && !counts && t >= kEarliestClock) facts_.from_first_frame = true;
  parsePoints(cells, frame);
  if (frames_ > 0 && t <= last_t_)
    throw ParseError({file_, lines_.number(), 1}, "found t = " + formatDouble(t) + " after " +
                                                      formatDouble(last_t_) + ", expected t to rise");
  last_t_ = t;
  frame.t = counts ? static_cast<double>(frames_) / kAssumedRate : t;
  ++frames_;
  return true;
}

void SkeletonCsvReader::parsePoints(Cells& cells, PointFrame& frame) {
  frame.clear(head_.joints.size());
  if (head_.has_covariances) frame.covariance.assign(head_.joints.size(), Matrix3d::Zero());
  if (head_.has_laterals) frame.lateral.assign(head_.joints.size(), Eigen::Vector3f::Zero());
  confidence_.assign(head_.joints.size(), kTrackedConfidence);
  std::string_view cell;
  const std::string cell_count = std::to_string(head_.columns.size() + 1) + " cells";
  for (const CsvColumn& c : head_.columns) {
    cell = cells.need(cell_count);
    if (cell.empty()) continue;
    const double v = cells.number(cell);
    if (c.field == kConfidenceField)
      confidence_[c.joint] = v;
    else if (c.field == kSpreadField)
      frame.spread[c.joint] = spreadOf(cells, v);
    else if (c.field >= kLateralField)
      frame.lateral[c.joint][c.field - kLateralField] = static_cast<float>(v);
    else if (c.field >= kCovarianceField)
      setElement(kCovarianceColumns[static_cast<std::size_t>(c.field - kCovarianceField)], v,
                 frame.covariance[c.joint]);
    else
      frame.p[c.joint][c.field] = v;
  }
  if (cells.next(cell))
    throw ParseError(cells.pos(), "found " + text::inQuotes(cell) + ", expected " + cell_count);
  for (std::size_t j = 0; j < frame.p.size(); ++j) {
    if (frame.p[j].allFinite() && confidence_[j] > 0.0)
      frame.state[j] = confidence_[j] >= kMinTrackedConfidence ? humanmodel::JointState::kTracked
                                                               : humanmodel::JointState::kInferred;
    else
      frame.p[j].setConstant(kNaN);
  }
}

Recording readSkeletonCsv(std::string_view text, const std::string& file, const RecordingOptions& options) {
  SkeletonCsvReader reader(text, file);
  return readPoints(reader, file, options);
}

}  // namespace abstand::tracking
