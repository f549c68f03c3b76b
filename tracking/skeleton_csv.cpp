#include "tracking/skeleton_csv.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "tracking/conversion.hpp"
#include "tracking/derived_joints.hpp"
#include "tracking/message_text.hpp"

namespace abstand {
namespace {

constexpr int kConfidenceField = 3;
constexpr double kLargestValue = 1e9;

/// What a column holds: a joint's x, y, z (0 to 2) or its confidence.
struct Column {
  std::size_t joint{0};
  int field{0};
};

double confidenceOf(JointState s) {
  if (s == JointState::kMissing) return 0.0;
  return s == JointState::kTracked ? kTrackedConfidence : kInferredConfidence;
}

/// Splits a line at its commas and knows the place of each cell.
class Cells {
 public:
  Cells(std::string_view line, const std::string& file, int number)
      : line_(line), file_(file), number_(number) {}

  bool next(std::string_view& cell) {
    start_ = std::min(at_, line_.size());
    if (at_ > line_.size()) return false;
    const auto comma = std::min(line_.find(',', at_), line_.size());
    cell = line_.substr(at_, comma - at_);
    at_ = comma + 1;
    while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t')) cell.remove_prefix(1);
    while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) cell.remove_suffix(1);
    return true;
  }
  SourcePos pos() const { return {file_, number_, static_cast<int>(start_) + 1}; }

 private:
  std::string_view line_;
  const std::string& file_;
  int number_;
  std::size_t at_{0}, start_{0};
};

bool nextLine(std::string_view& text, std::string_view& line) {
  if (text.empty()) return false;
  const auto end = std::min(text.find('\n'), text.size());
  line = text.substr(0, end);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  text.remove_prefix(std::min(end + 1, text.size()));
  return true;
}

std::vector<Column> parseHeader(std::string_view line, const std::string& file) {
  Cells cells(line, file, 1);
  std::string_view cell;
  cells.next(cell);
  if (cell != "t") throw ParseError(cells.pos(), "found " + inQuotes(cell) + ", expected the column 't'");
  std::vector<std::string> known;
  for (std::size_t j = 0; j < kJointCount; ++j) known.emplace_back(jointName(static_cast<Joint>(j)));
  std::array<std::array<bool, 4>, kJointCount> seen{};
  std::vector<Column> columns;
  while (cells.next(cell)) {
    const auto dot = std::min(cell.rfind('.'), cell.size());
    const auto joint = parseJoint(cell.substr(0, dot));
    if (!joint) {
      const auto near = nearestName(std::string(cell.substr(0, dot)), known);
      throw ParseError(cells.pos(),
                       "found the column " + inQuotes(cell) + ", expected JOINT.x, .y, .z or .confidence",
                       near.empty() ? "" : "did you mean '" + near + "'?");
    }
    const auto field = cell.substr(dot);
    const int f = field == ".x"            ? 0
                  : field == ".y"          ? 1
                  : field == ".z"          ? 2
                  : field == ".confidence" ? kConfidenceField
                                           : -1;
    const auto j = static_cast<std::size_t>(*joint);
    if (f < 0)
      throw ParseError(cells.pos(),
                       "found the column " + inQuotes(cell) + ", expected .x, .y, .z or .confidence");
    if (seen[j][static_cast<std::size_t>(f)])
      throw ParseError(cells.pos(),
                       "found the column " + inQuotes(cell) + " a second time, expected it once");
    seen[j][static_cast<std::size_t>(f)] = true;
    columns.push_back({j, f});
  }
  for (std::size_t j = 0; j < kJointCount; ++j)
    if ((seen[j][0] || seen[j][1] || seen[j][2] || seen[j][3]) && !(seen[j][0] && seen[j][1] && seen[j][2]))
      throw ParseError({file, 1}, "found only some columns of " + known[j] + ", expected .x, .y and .z");
  if (columns.empty()) throw ParseError({file, 1}, "found no joint, expected JOINT.x, JOINT.y, JOINT.z");
  return columns;
}

double parseCell(const Cells& cells, std::string_view cell) {
  const auto v = parseDouble(cell);
  if (!v || std::abs(*v) > kLargestValue)
    throw ParseError(cells.pos(), "found " + inQuotes(cell) + ", expected a number below 1e9");
  return *v;
}

SkeletonFrame parseFrame(Cells cells, const std::vector<Column>& columns) {
  SkeletonFrame f;
  std::string_view cell;
  cells.next(cell);
  f.t = parseCell(cells, cell);
  std::array<double, kJointCount> confidence;
  confidence.fill(kTrackedConfidence);
  std::array<bool, kJointCount> present{};
  for (const Column& c : columns) {
    if (!cells.next(cell))
      throw ParseError(cells.pos(), "found the end of the line, expected " +
                                        std::to_string(columns.size() + 1) + " cells");
    if (cell.empty()) continue;
    const double v = parseCell(cells, cell);
    if (c.field == kConfidenceField) {
      confidence[c.joint] = v;
    } else {
      f.p[c.joint][c.field] = v;
      present[c.joint] = true;
    }
  }
  if (cells.next(cell))
    throw ParseError(cells.pos(), "found " + inQuotes(cell) + ", expected " +
                                      std::to_string(columns.size() + 1) + " cells");
  for (std::size_t j = 0; j < kJointCount; ++j) {
    const bool known = present[j] && f.p[j].allFinite() && confidence[j] > 0.0;
    if (known)
      f.state[j] = confidence[j] >= kLeastTrackedConfidence ? JointState::kTracked : JointState::kInferred;
    else
      f.p[j].setConstant(kNaN);
  }
  return f;
}

/// Steps of t whose median says the rate; 0 Hz for a single frame.
double rateOf(const std::vector<SkeletonFrame>& frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i) steps.push_back(frames[i].t - frames[i - 1].t);
  return steps.empty() ? 0.0 : 1.0 / quantile(std::move(steps), 0.5);
}

}  // namespace

void writeSkeletonCsv(std::ostream& out, const Recording& recording) {
  std::vector<std::size_t> joints;
  for (std::size_t j = 0; j < kJointCount; ++j)
    if (std::any_of(recording.frames.begin(), recording.frames.end(),
                    [j](const SkeletonFrame& f) { return f.state[j] != JointState::kMissing; }))
      joints.push_back(j);
  out << 't';
  for (const auto j : joints)
    for (const char* field : {".x", ".y", ".z", ".confidence"})
      out << ',' << jointName(static_cast<Joint>(j)) << field;
  out << '\n';
  for (const auto& f : recording.frames) {
    out << formatDouble(f.t);
    for (const auto j : joints) {
      const bool known = f.state[j] != JointState::kMissing;
      for (int k = 0; k < 3; ++k) out << ',' << (known ? formatDouble(f.p[j][k]) : "");
      out << ',' << formatDouble(confidenceOf(f.state[j]));
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
  return nextLine(text, line) && line.starts_with("t,") && line.find(".x") != std::string_view::npos;
}

Recording readSkeletonCsv(std::string_view text, const std::string& file, const RecordingOptions& options) {
  std::string_view line;
  if (!nextLine(text, line)) throw ParseError({file}, "the file is empty");
  const auto columns = parseHeader(line, file);

  RawRecording raw;
  raw.format = "csv";
  raw.is_canonical = true;
  raw.match.joint.fill(-1);
  for (const Column& c : columns)
    if (c.field == 0) {
      raw.match.joint[c.joint] = static_cast<int>(raw.joints.size());
      raw.joints.emplace_back(jointName(static_cast<Joint>(c.joint)));
    }
  for (int number = 2; nextLine(text, line); ++number) {
    if (line.empty()) continue;
    raw.frames.push_back(parseFrame(Cells(line, file, number), columns));
    const auto n = raw.frames.size();
    if (n > 1 && raw.frames[n - 1].t <= raw.frames[n - 2].t)
      throw ParseError({file, number, 1}, "found t = " + formatDouble(raw.frames[n - 1].t) + " after " +
                                              formatDouble(raw.frames[n - 2].t) + ", expected t to rise");
  }
  if (raw.frames.empty()) throw ParseError({file, 2}, "found no frame, expected at least one");
  raw.rate = rateOf(raw.frames);
  return convert(std::move(raw), options);
}

}  // namespace abstand
