#include "tracking/kinect/irds.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/kinect/kinect_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr double kMillisecond = 1e-3;
/// Limit of columns in a line.
constexpr std::size_t kMaxCells = 1000;

std::vector<std::string_view> cellsOf(std::string_view line, const std::string& file, int number) {
  Cells cells(line, file, number);
  std::vector<std::string_view> out;
  for (std::string_view cell; cells.next(cell);) {
    if (out.size() == kMaxCells)
      throw ParseError(cells.pos(), "found more than 1000 cells, expected a line of a skeleton");
    out.push_back(cell);
  }
  return out;
}

}  // namespace

bool looksLikeIrdsCsv(std::string_view text) {
  std::string_view line;
  return Lines(text).next(line) && line.find("JointName") != std::string_view::npos &&
         line.find("TrackingStatus") != std::string_view::npos;
}

bool looksLikeIrdsText(std::string_view text) {
  return text.starts_with("Version0.") && text.size() > 9 && text[9] >= '0' && text[9] <= '9';
}

IrdsReader::IrdsReader(std::string_view text, std::string file)
    : file_(std::move(file)), lines_(text), is_text_(looksLikeIrdsText(text)) {
  facts_.format = is_text_ ? "kinect-v2-txt" : "kinect-v2-csv";
  facts_.rate_reason = "the third integer of the time stamps, in ms";
  facts_.from_first_frame = true;
  facts_.sensor = kKinectError;
  facts_.unit = UnitChoice{"m", "Kinect v2 gives metres", 1.0, ""};
  facts_.up = UpChoice{"y", "the camera's up axis; a tilted camera is not corrected", ""};
  if (!lines_.next(line_)) throw ParseError({file_}, "the file is empty");
  if (!is_text_) readColumns(line_);
}

std::span<const std::string> IrdsReader::names() const { return kinectV2Joints(); }

void IrdsReader::readColumns(std::string_view line) {
  const auto head = cellsOf(line, file_, 1);
  const auto column = [&](const char* name) {
    const auto it = std::find(head.begin(), head.end(), name);
    if (it == head.end())
      throw ParseError({file_, 1},
                       std::string("found no column ") + name + ", expected it in the first line");
    return static_cast<std::size_t>(it - head.begin());
  };
  columns_ = {{column("Timestamp1"), column("Timestamp2"), column("Timestamp3")},
              column("JointName"),
              column("TrackingStatus"),
              {column("X"), column("Y"), column("Z")},
              head.size()};
}

bool IrdsReader::nextLine() {
  has_line_ = has_line_ || [this] {
    do {
      if (!lines_.next(line_)) return false;
    } while (line_.empty());
    return true;
  }();
  return has_line_;
}

bool IrdsReader::next(PointFrame& frame) {
  frame.clear(names().size());
  if (is_text_ ? nextOfText(frame) : nextOfTable(frame)) {
    ++frames_;
    return true;
  }
  if (frames_ == 0) throw ParseError({file_, lines_.number() + 1}, "found no frame, expected at least one");
  return false;
}

IrdsReader::Stamp IrdsReader::readStamp(std::span<const std::string_view> cells) const {
  Stamp stamp;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& c = cells[i];
    const auto r = std::from_chars(c.data(), c.data() + c.size(), stamp[i]);
    if (r.ec != std::errc{} || r.ptr != c.data() + c.size())
      throw ParseError(pos(), "found " + text::inQuotes(c) + " in a time stamp, expected an integer");
  }
  return stamp;
}

void IrdsReader::begin(const Stamp& stamp, PointFrame& frame) {
  frame.t = static_cast<double>(stamp[2]) * kMillisecond;
  if (std::abs(frame.t) > kLargestCoordinate)
    throw ParseError(pos(), "found a time stamp of " + std::to_string(stamp[2]) + " ms, expected below 1e12");
  if (frames_ > 0 && frame.t <= last_t_)
    throw ParseError(pos(), "found a time stamp of " + std::to_string(stamp[2]) + " ms after " +
                                text::rounded(last_t_ / kMillisecond, 0) + ", expected it to rise");
  last_t_ = frame.t;
}

void IrdsReader::setJoint(std::string_view name, std::string_view state, std::span<const std::string_view> p,
                          PointFrame& frame) const {
  const auto all = names();
  const auto joint = std::find(all.begin(), all.end(), name);
  if (joint == all.end())
    throw ParseError(pos(), "found the joint " + text::inQuotes(name) + ", expected one of Kinect v2");
  const auto tracked = parseTrackingState(state);
  if (!tracked)
    throw ParseError(pos(), "found " + text::inQuotes(state) + ", expected Tracked, Inferred or NotTracked");
  const auto index = static_cast<std::size_t>(joint - all.begin());
  Vector3d p_C;
  for (int i = 0; i < 3; ++i) {
    const auto v = parseDouble(p[static_cast<std::size_t>(i)]);
    if (!v || std::abs(*v) > kLargestCoordinate)
      throw ParseError(pos(), "found " + text::inQuotes(p[static_cast<std::size_t>(i)]) + " for " +
                                  std::string(name) + ", expected a number below 1e9");
    p_C[i] = *v;
  }
  if (frame.p[index].allFinite())
    throw ParseError(pos(), "found " + std::string(name) + " a second time in a frame, expected it once");
  if (*tracked != humanmodel::JointState::kMissing) frame.set(index, p_C, *tracked);
}

bool IrdsReader::nextOfTable(PointFrame& frame) {
  std::optional<Stamp> first;
  for (; nextLine(); has_line_ = false) {
    const auto cells = cellsOf(line_, file_, lines_.number());
    if (cells.size() != columns_.count)
      throw ParseError(pos(), "found " + std::to_string(cells.size()) + " cells, expected " +
                                  std::to_string(columns_.count) + " as in the first line");
    const std::string_view three[]{cells[columns_.stamp[0]], cells[columns_.stamp[1]],
                                   cells[columns_.stamp[2]]};
    const Stamp stamp = readStamp(three);
    if (first && stamp != *first) break;
    if (!first) begin(stamp, frame);
    first = stamp;
    const std::string_view p[]{cells[columns_.p[0]], cells[columns_.p[1]], cells[columns_.p[2]]};
    setJoint(cells[columns_.joint], cells[columns_.state], p, frame);
  }
  return first.has_value();
}

/// `8028,5,18432,(SpineBase,Tracked,x,y,z,u,v),(SpineMid,...`
bool IrdsReader::nextOfText(PointFrame& frame) {
  has_line_ = false;
  if (!nextLine()) return false;
  const auto cells = cellsOf(line_, file_, lines_.number());
  constexpr std::size_t kStamp = 3, kPerJoint = 7;
  if (cells.size() <= kStamp || (cells.size() - kStamp) % kPerJoint != 0)
    throw ParseError(pos(), "found " + std::to_string(cells.size()) +
                                " cells, expected three integers and seven values a joint");
  begin(readStamp(std::span(cells).first(kStamp)), frame);
  for (std::size_t i = kStamp; i < cells.size(); i += kPerJoint) {
    std::string_view name = cells[i], end = cells[i + kPerJoint - 1];
    if (!name.starts_with('(') || !end.ends_with(')'))
      throw ParseError(pos(), "found " + text::inQuotes(name) + ", expected '(JointName,State,x,y,z,u,v)'");
    name.remove_prefix(1);
    setJoint(name, cells[i + 1], std::span(cells).subspan(i + 2, 3), frame);
  }
  return true;
}

}  // namespace abstand::tracking
