#include "tracking/c3d/c3d_reader.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/number.hpp"
#include "core/math/quantile.hpp"
#include "core/text/message_text.hpp"
#include "tracking/c3d/c3d_subject.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::uint8_t kKey = 0x50;
constexpr double kHighestRate = 1e6;  // Hz
/// Labels are in POINT:LABELS, LABELS2, ... with 255 each.
constexpr int kMaxLabelLists = 256;

std::optional<UnitChoice> unitOf(const std::string& name) {
  const std::string low = text::lowerCase(name);
  const double scale = low == "mm" ? 0.001 : low == "cm" ? 0.01 : low == "m" ? 1.0 : 0.0;
  if (scale == 0.0) return std::nullopt;
  return UnitChoice{low, "POINT:UNITS of the file", scale, ""};
}

}  // namespace

bool looksLikeC3d(std::string_view bytes) {
  return bytes.size() >= kBlock && bytes[0] > 0 && static_cast<std::uint8_t>(bytes[1]) == kKey;
}

C3dReader::C3dReader(std::string_view bytes, std::string file) : bytes_(bytes, std::move(file)) {
  facts_.format = "c3d";
  facts_.of_markers = true;
  readHead();
  nameMarkers();
  checkResiduals();
  describe();
}

double C3dReader::numberOf(const std::string& name, std::size_t i) const {
  const auto it = parameters_.find(name);
  return it == parameters_.end() || i >= it->second.numbers.size() ? -1.0 : it->second.numbers[i];
}

void C3dReader::readHead() {
  if (bytes_.size() < kBlock)
    bytes_.fail(bytes_.size(), "found the end of the file, expected a header of 512 bytes");
  if (bytes_.u8(1) != kKey)
    bytes_.fail(1, "found " + std::to_string(bytes_.u8(1)) + ", expected C3D's key 80");
  const std::size_t parameters = (std::max<std::size_t>(bytes_.u8(0), 1) - 1) * kBlock;
  const int processor = bytes_.u8(parameters + 3);
  if (processor < 84 || processor > 86)
    bytes_.fail(parameters + 3, "found the processor " + std::to_string(processor) +
                                    ", expected 84 (Intel), 85 (DEC) or 86 (MIPS)");
  bytes_.processor = static_cast<C3dProcessor>(processor);
  parameters_ = readC3dParameters(bytes_, parameters, warnings_);

  points_ = bytes_.u16(2);
  const std::size_t analog = bytes_.u16(4);
  first_frame_ = bytes_.u16(6);
  if (points_ == 0)
    bytes_.fail(2, "found 0 points, expected markers (a file with analog data only has no motion)");
  scale_ = static_cast<double>(bytes_.f32(12));
  if (!std::isfinite(scale_) || scale_ == 0.0 || std::abs(scale_) > kLargestCoordinate)
    bytes_.fail(12, "found a scale of " + formatDouble(scale_) + ", expected a number that is not 0");
  is_float_ = scale_ < 0.0;
  const std::size_t width = is_float_ ? 4 : 2;
  frame_bytes_ = width * (4 * points_ + analog);
  const std::size_t block = bytes_.u16(16);
  if (block < 2)
    bytes_.fail(16, "found the data in block " + std::to_string(block) + ", expected one after the header");
  data_ = (block - 1) * kBlock;

  const auto rate = static_cast<double>(bytes_.f32(20));
  if (!(rate > 0.0) || rate > kHighestRate)
    bytes_.fail(20, "found a rate of " + formatDouble(rate) + " Hz, expected more than 0 and at most 1e6");
  facts_.rate = rate;
  facts_.rate_reason = "the frame rate in the header";
  if (first_frame_ > 1) facts_.rate_reason += "; the first frame is number " + std::to_string(first_frame_);

  const std::size_t claimed = claimedFrames();
  const std::size_t held = data_ < bytes_.size() ? (bytes_.size() - data_) / frame_bytes_ : 0;
  if (held == 0)
    bytes_.fail(data_, "found no complete frame, expected one of " + std::to_string(frame_bytes_) + " bytes");
  frames_ = std::min(claimed, held);
  if (claimed > held)
    warnings_.push_back({0,
                         "claims " + std::to_string(claimed) + " frames, found " + std::to_string(held) +
                             " complete ones, which are read",
                         claimed - held});
}

/// The header has 16 bits for it. On overflow, TRIAL:ACTUAL_*_FIELD (two words each), POINT:FRAMES or
/// LONG_FRAMES state the number.
std::size_t C3dReader::claimedFrames() const {
  const int first = bytes_.u16(6), last = bytes_.u16(8);
  if (last < first)
    bytes_.fail(8, "found the last frame " + std::to_string(last) + " before the first, " +
                       std::to_string(first) + ", expected it after the first");
  double claimed = last - first + 1;
  const double start = numberOf("TRIAL:ACTUAL_START_FIELD") +
                       65536.0 * std::max(numberOf("TRIAL:ACTUAL_START_FIELD", 1), 0.0),
               end = numberOf("TRIAL:ACTUAL_END_FIELD") +
                     65536.0 * std::max(numberOf("TRIAL:ACTUAL_END_FIELD", 1), 0.0);
  if (start > 0.0 && end >= start) claimed = std::max(claimed, end - start + 1.0);
  for (const char* name : {"POINT:LONG_FRAMES", "POINT:FRAMES"})
    if (last == 65535) claimed = std::max(claimed, numberOf(name));
  return static_cast<std::size_t>(std::min(claimed, 1e12));
}

void C3dReader::nameMarkers() {
  for (int list = 1; list <= kMaxLabelLists && names_.size() < points_; ++list) {
    const auto it = parameters_.find("POINT:LABELS" + (list > 1 ? std::to_string(list) : ""));
    if (it == parameters_.end()) break;
    for (const auto& label : it->second.texts)
      if (names_.size() < points_) names_.push_back(label);
  }
  const std::size_t labelled = names_.size();
  while (names_.size() < points_) names_.push_back("point " + std::to_string(names_.size() + 1));
  if (labelled < points_)
    warnings_.push_back({0, "the file names " + std::to_string(labelled) + " of its " +
                                std::to_string(points_) + " points: the others are numbered"});
}

C3dReader::Point C3dReader::point(std::size_t frame, std::size_t i) const {
  const std::size_t width = is_float_ ? 4 : 2, at = data_ + frame * frame_bytes_ + i * 4 * width;
  Point out{Vector3d::Zero(), false, 0.0};
  double fourth = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double v = is_float_ ? static_cast<double>(bytes_.f32(at + 4 * k)) : bytes_.i16(at + 2 * k);
    (k < 3 ? out.p[static_cast<int>(k)] : fourth) = v;
  }
  if (!is_float_) out.p *= scale_;
  // The low byte is the residual in units of the scale, the high one the camera mask; negative: not measured.
  const bool is_word = std::isfinite(fourth) && std::abs(fourth) <= 32768.0;
  const int word = is_word ? static_cast<int>(fourth) : -1;
  out.residual = word < 0 ? -1.0 : (word & 0xff) * std::abs(scale_);
  const bool is_number = out.p.allFinite() && out.p.cwiseAbs().maxCoeff() < kLargestCoordinate;
  out.is_measured = is_number && (!trust_residuals_ || word >= 0);
  return out;
}

void C3dReader::checkResiduals() {
  for (std::size_t f = 0; f < frames_; ++f)
    for (std::size_t i = 0; i < points_; ++i)
      if (point(f, i).is_measured) return;
  trust_residuals_ = false;
  warnings_.push_back({0,
                       "every residual is negative ('not measured'): residuals are ignored, and only "
                       "points at the origin are gaps"});
}

void C3dReader::describe() {
  const auto text = [&](const char* name) {
    const auto it = parameters_.find(name);
    return it == parameters_.end() || it->second.texts.empty() ? std::string() : it->second.texts[0];
  };
  facts_.unit = unitOf(text("POINT:UNITS"));
  std::string up = text::lowerCase(text("POINT:Y_SCREEN"));
  if (up.starts_with('+')) up.erase(0, 1);
  if (up == "x" || up == "y" || up == "z" || up == "-x" || up == "-y" || up == "-z")
    facts_.up = UpChoice{up, "POINT:Y_SCREEN of the file", ""};

  facts_.subjects = subjectsOf(parameters_);
  std::size_t at_origin = 0;
  for (std::size_t f = 0; f < frames_; ++f)
    for (std::size_t i = 0; i < points_; ++i) {
      const Point p = point(f, i);
      at_origin += p.is_measured && !p.isSeen() ? 1 : 0;
    }
  if (at_origin > 0 && trust_residuals_)
    facts_.notes.push_back(std::to_string(at_origin) + " samples at (0, 0, 0) count as missing");

  constexpr const char* kProcessors[]{"Intel", "DEC", "MIPS"};
  facts_.notes.push_back(
      std::string(kProcessors[static_cast<int>(bytes_.processor) - 84]) +
      (is_float_ ? ", floating point" : ", integers of " + text::rounded(scale_, 4) + " units") + ", " +
      std::to_string(points_) + " points");
  if (const auto analog = bytes_.u16(4); analog > 0)
    facts_.notes.push_back(std::to_string(analog) + " analog samples per frame are ignored");
  std::vector<double> residuals;
  for (const auto f : sampleIndices(frames_))
    for (std::size_t i = 0; i < points_; ++i)
      if (const Point p = point(f, i); p.isSeen() && p.residual > 0.0) residuals.push_back(p.residual);
  if (!residuals.empty())
    facts_.notes.push_back("residuals: median " + text::rounded(nearestQuantile(residuals, 0.5), 2) +
                           ", largest " + text::rounded(nearestQuantile(residuals, 1.0), 2) + " units");
}

bool C3dReader::next(PointFrame& frame) {
  if (next_ == frames_) return false;
  frame.clear(points_);
  frame.t = static_cast<double>(next_) / facts_.rate;
  for (std::size_t i = 0; i < points_; ++i)
    if (const Point p = point(next_, i); p.isSeen()) frame.set(i, p.p);
  ++next_;
  return true;
}

}  // namespace abstand::tracking
