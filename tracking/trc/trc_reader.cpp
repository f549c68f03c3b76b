#include "tracking/trc/trc_reader.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr double kHighestRate = 1e6;  // Hz

std::vector<std::string_view> tabbed(std::string_view line) {
  const std::string file;
  Cells cells(line, file, 0, '\t');
  std::vector<std::string_view> out;
  for (std::string_view cell; cells.next(cell);) out.push_back(cell);
  return out;
}

std::optional<UnitChoice> unitOf(const std::string& name) {
  const std::string low = text::lowerCase(name);
  const double scale = low == "mm"                      ? 0.001
                       : low == "cm"                    ? 0.01
                       : low == "m"                     ? 1.0
                       : low == "in" || low == "inches" ? 0.0254
                                                        : 0.0;
  if (scale == 0.0) return std::nullopt;
  return UnitChoice{scale == 0.0254 ? "inches" : low, "Units in the head of the file", scale, ""};
}

}  // namespace

bool looksLikeTrc(std::string_view text) { return text.starts_with("PathFileType"); }

TrcReader::TrcReader(std::string_view text, std::string file) : file_(std::move(file)), lines_(text) {
  facts_.format = "trc";
  facts_.of_markers = true;
  facts_.from_first_frame = true;
  facts_.rate_reason = "the median step of the column Time";
  need("the line PathFileType");
  readHead();
  readNames(need("the names of the markers"));
  need("the line X1, Y1, Z1, ...");
}

std::string_view TrcReader::need(const char* what) {
  std::string_view line;
  if (!lines_.next(line))
    throw ParseError({file_, lines_.number() + 1},
                     std::string("found the end of the file, expected ") + what);
  return line;
}

void TrcReader::readHead() {
  const auto keys = tabbed(need("DataRate, CameraRate, ..."));
  const auto values = tabbed(need("the values of DataRate, CameraRate, ..."));
  const SourcePos pos{file_, lines_.number()};
  for (std::size_t i = 0; i < keys.size() && i < values.size(); ++i) {
    const std::string key = text::lowerCase(keys[i]);
    if (key == "units") facts_.unit = unitOf(std::string(values[i]));
    if (key != "datarate" && key != "numframes" && key != "nummarkers") continue;
    const auto v = parseDouble(values[i]);
    if (!v || *v < 0.0 || *v > kLargestCoordinate)
      throw ParseError(
          pos, "found " + text::inQuotes(values[i]) + " for " + std::string(keys[i]) + ", expected a number");
    if (key == "numframes") claimed_frames_ = static_cast<long long>(*v);
    if (key == "nummarkers") claimed_markers_ = static_cast<long long>(*v);
    if (key == "datarate" && *v > 0.0 && *v <= kHighestRate) {
      facts_.rate = *v;
      facts_.rate_reason = "DataRate in the head of the file";
    }
  }
}

void TrcReader::readNames(std::string_view line) {
  const auto cells = tabbed(line);
  if (cells.size() < 2 || text::lowerCase(cells[0]) != "frame#" || text::lowerCase(cells[1]) != "time")
    throw ParseError({file_, lines_.number()},
                     "found " + text::inQuotes(line) + ", expected Frame#, Time and the markers");
  for (std::size_t i = 2; i < cells.size(); ++i)
    if (!cells[i].empty()) names_.emplace_back(cells[i]);
  if (names_.empty()) throw ParseError({file_, lines_.number()}, "found no marker, expected their names");
  if (claimed_markers_ >= 0 && static_cast<std::size_t>(claimed_markers_) != names_.size())
    warnings_.push_back({lines_.number(), "the head claims " + std::to_string(claimed_markers_) +
                                              " markers, found " + std::to_string(names_.size()) +
                                              ": those present are read"});
}

void TrcReader::finish() {
  done_ = true;
  if (frames_ == 0) throw ParseError({file_, lines_.number() + 1}, "found no frame, expected at least one");
  if (claimed_frames_ >= 0 && static_cast<std::size_t>(claimed_frames_) != frames_)
    warnings_.push_back({3,
                         "claims " + std::to_string(claimed_frames_) + " frames, found " +
                             std::to_string(frames_) + ": those present are read",
                         static_cast<std::size_t>(claimed_frames_) > frames_
                             ? static_cast<std::size_t>(claimed_frames_) - frames_
                             : 0});
  if (first_short_line_ > 0)
    warnings_.push_back(
        {first_short_line_, "rows end early from this line on: the remaining markers are missing there"});
  if (first_odd_line_ > 0)
    warnings_.push_back(
        {first_odd_line_, "rows end early from here on, within a marker: all markers are missing there"});
  if (first_long_line_ > 0)
    warnings_.push_back({first_long_line_,
                         "rows hold more markers than the header names from this line on: those "
                         "beyond the named ones are ignored"});
}

void TrcReader::readRow(Cells& cells, PointFrame& frame) {
  const std::size_t expected = 3 * names_.size();
  const auto note = [this](int& line) {
    if (line == 0) line = lines_.number();
  };
  std::string_view cell;
  std::size_t cell_count = 0, value_count = 0;  // up to the last cell, and to the last non-empty one
  SourcePos beyond;
  std::string first_beyond;
  while (cells.next(cell)) {
    if (cell_count++ == expected) {
      beyond = cells.pos();
      first_beyond = text::inQuotes(cell);
    }
    if (cell.empty()) continue;
    value_count = cell_count;
    const double v = text::lowerCase(cell) == "nan" ? kNaN : cells.number(cell);
    if (cell_count <= expected) frame.p[(cell_count - 1) / 3][static_cast<int>((cell_count - 1) % 3)] = v;
  }
  if (value_count > expected) {
    if (value_count % 3 != 0)
      throw ParseError(beyond, "found " + first_beyond + ", expected " + std::to_string(names_.size()) +
                                   " markers of three numbers");
    note(first_long_line_);
  } else if (cell_count < expected && value_count % 3 == 0) {
    note(first_short_line_);
  } else if (cell_count < expected) {
    note(first_odd_line_);
    for (Vector3d& p : frame.p) p.setConstant(kNaN);
  }
}

bool TrcReader::next(PointFrame& frame) {
  if (done_) return false;
  std::string_view line;
  do {
    if (!lines_.next(line)) {
      finish();
      return false;
    }
  } while (line.find_first_not_of(" \t") == std::string_view::npos);

  Cells cells(line, file_, lines_.number(), '\t');
  cells.number(cells.need("the number of a frame"));
  frame.clear(names_.size());
  frame.t = cells.number(cells.need("a time"));
  if (frames_ > 0 && frame.t <= last_t_)
    throw ParseError({file_, lines_.number()}, "found the time " + formatDouble(frame.t) + " after " +
                                                   formatDouble(last_t_) + ", expected it to rise");
  last_t_ = frame.t;
  readRow(cells, frame);
  for (std::size_t i = 0; i < frame.p.size(); ++i) {
    if (frame.p[i].allFinite())
      frame.state[i] = humanmodel::JointState::kTracked;
    else
      frame.p[i].setConstant(kNaN);
  }
  ++frames_;
  return true;
}

}  // namespace abstand::tracking
