#include "tracking/compact/compact_recording.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <ostream>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/output_file.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::string_view kMagic = "ABSTREC1";
// Marks: of frames, with spreads, with y axes of parts, or with both.
constexpr std::uint8_t kEnd = 0, kFrame = 1, kFrameWithSpread = 2, kFrameWithAxes = 3, kFrameWithBoth = 4;
/// Step of the components of unit vectors.
constexpr double kAxisStep = 1e-4;
constexpr std::int64_t kMaxAxisSteps = 10000;
/// m; larger spreads are stored as this value.
constexpr double kMaxSpread = 1e3;
/// m; larger positions are not written, and differences beyond twice this are rejected.
constexpr double kFarthest = 1e6;
constexpr auto kMaxSteps = static_cast<std::int64_t>(kFarthest / kCompactStep);

void writeU64(std::ostream& out, std::uint64_t v) {
  for (int i = 0; i < 8; ++i, v >>= 8) out.put(static_cast<char>(v & 0xff));
}

/// Zigzag varint: seven bits in each byte, lowest first, high bit set if more follow.
void writeDifference(std::ostream& out, std::int64_t v) {
  auto z = static_cast<std::uint64_t>(v) << 1 ^ static_cast<std::uint64_t>(v >> 63);
  for (; z >= 0x80; z >>= 7) out.put(static_cast<char>(0x80 | (z & 0x7f)));
  out.put(static_cast<char>(z));
}

bool hasSpread(std::uint8_t mark) { return mark == kFrameWithSpread || mark == kFrameWithBoth; }
bool hasAxes(std::uint8_t mark) { return mark >= kFrameWithAxes; }

std::uint8_t markOf(const humanmodel::SkeletonFrame& f) {
  const bool spread = std::any_of(f.spread.begin(), f.spread.end(), [](double s) { return s > 0.0; });
  if (f.lateral.isStated()) return spread ? kFrameWithBoth : kFrameWithAxes;
  return spread ? kFrameWithSpread : kFrame;
}

std::uint64_t readU64(std::string_view bytes) {
  std::uint64_t v = 0;
  for (int i = 7; i >= 0; --i) v = v << 8 | static_cast<std::uint8_t>(bytes[static_cast<std::size_t>(i)]);
  return v;
}

}  // namespace

void writeCompact(std::ostream& out, const Recording& recording) {
  out.write(kMagic.data(), static_cast<std::streamsize>(kMagic.size()));
  out.put(static_cast<char>(humanmodel::kJointCount));
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto name = humanmodel::jointName(static_cast<humanmodel::Joint>(j));
    out.put(static_cast<char>(name.size()));
    out.write(name.data(), static_cast<std::streamsize>(name.size()));
  }
  std::array<std::array<std::int64_t, 3>, humanmodel::kJointCount> last{};
  for (const humanmodel::SkeletonFrame& f : recording.frames) {
    const std::uint8_t mark = markOf(f);
    out.put(static_cast<char>(mark));
    writeU64(out, std::bit_cast<std::uint64_t>(f.t));
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      out.put(static_cast<char>(f.state[j]));
      if (f.state[j] == humanmodel::JointState::kMissing) continue;
      if (!(f.p[j].cwiseAbs().maxCoeff() <= kFarthest))
        throw UsageError("found " + std::string(humanmodel::jointName(static_cast<humanmodel::Joint>(j))) +
                         " farther than 1e6 m away at t = " + formatDouble(f.t) + ", expected less");
      for (int k = 0; k < 3; ++k) {
        const auto steps = static_cast<std::int64_t>(std::llround(f.p[j][k] / kCompactStep));
        writeDifference(out, steps - last[j][static_cast<std::size_t>(k)]);
        last[j][static_cast<std::size_t>(k)] = steps;
      }
      if (hasSpread(mark))
        writeDifference(out, std::llround(std::min(f.spread[j], kMaxSpread) / kCompactStep));
      for (int k = 0; hasAxes(mark) && k < 3; ++k)
        writeDifference(out, std::llround(static_cast<double>(f.lateral[j][k]) / kAxisStep));
    }
  }
  out.put(static_cast<char>(kEnd));
  writeU64(out, recording.frames.size());
}

void writeCompact(const std::filesystem::path& file, const Recording& recording) {
  OutputFile out(file);
  writeCompact(out.stream(), recording);
  out.commit();
}

bool looksLikeCompact(std::string_view bytes) { return bytes.starts_with(kMagic); }

CompactReader::CompactReader(std::string_view bytes, std::string file)
    : bytes_(bytes), file_(std::move(file)) {
  if (!looksLikeCompact(bytes_)) fail("found another file signature, expected ABSTREC1");
  at_ = kMagic.size();
  std::uint8_t joints = 0, length = 0;
  if (!readByte(joints) || joints == 0) fail("found no joint, expected how many there are");
  for (int j = 0; j < joints; ++j) {
    if (!readByte(length) || length > bytes_.size() - at_)
      fail("found the end, expected the name of a joint");
    names_.emplace_back(bytes_.substr(at_, length));
    at_ += length;
    if (!humanmodel::parseJoint(names_.back()))
      fail("found the joint " + text::inQuotes(names_.back()) + ", expected a canonical one");
  }
  last_.resize(names_.size());
  facts_.format = "compact";
  facts_.is_canonical = true;
  facts_.rate_reason = "the median step of the times in the file";
  facts_.unit = UnitChoice{"m", "the format's own", 1.0, ""};
  facts_.up = UpChoice{"z", "the format's own", ""};
}

void CompactReader::fail(const std::string& message) const {
  throw ParseError({file_}, "at byte " + std::to_string(at_) + ": " + message);
}

bool CompactReader::readByte(std::uint8_t& value) {
  if (at_ >= bytes_.size()) return false;
  value = static_cast<std::uint8_t>(bytes_[at_++]);
  return true;
}

bool CompactReader::readDifference(std::int64_t& value) {
  std::uint64_t z = 0;
  std::uint8_t byte = 0;
  for (int shift = 0;; shift += 7) {
    if (!readByte(byte)) return false;
    if (shift > 56) fail("found a number of more than nine bytes, expected fewer");
    z |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) break;
  }
  value = static_cast<std::int64_t>(z >> 1) ^ -static_cast<std::int64_t>(z & 1);
  return true;
}

bool CompactReader::readSpread(double& spread) {
  std::int64_t steps = 0;
  if (!readDifference(steps)) return false;
  if (steps < 0 || static_cast<double>(steps) * kCompactStep > kMaxSpread)
    fail("found the spread " + std::to_string(steps) + " um, expected 0 to 1e9");
  spread = static_cast<double>(steps) * kCompactStep;
  return true;
}

/// Zero if none is stated; otherwise a unit vector but for rounding.
bool CompactReader::readAxis(Eigen::Vector3f& axis) {
  for (int k = 0; k < 3; ++k) {
    std::int64_t steps = 0;
    if (!readDifference(steps)) return false;
    if (steps > kMaxAxisSteps || steps < -kMaxAxisSteps)
      fail("found the component " + std::to_string(steps) + " of an axis, expected -10000 to 10000");
    axis[k] = static_cast<float>(static_cast<double>(steps) * kAxisStep);
  }
  return true;
}

/// False if the file ends within the frame.
bool CompactReader::readFrame(PointFrame& frame, std::uint8_t mark) {
  frame.clear(names_.size());
  if (hasAxes(mark)) frame.lateral.assign(names_.size(), Eigen::Vector3f::Zero());
  if (bytes_.size() - at_ < 8) return false;
  frame.t = std::bit_cast<double>(readU64(bytes_.substr(at_, 8)));
  if (!std::isfinite(frame.t) || std::abs(frame.t) > kLargestCoordinate ||
      (frames_ > 0 && frame.t <= last_t_))
    fail("found the time " + formatDouble(frame.t) + ", expected one after that of the last frame");
  at_ += 8;
  for (std::size_t j = 0; j < names_.size(); ++j) {
    std::uint8_t state = 0;
    if (!readByte(state)) return false;
    if (state > static_cast<std::uint8_t>(humanmodel::JointState::kTracked))
      fail("found the state " + std::to_string(state) + " of a joint, expected 0 to 2");
    if (state == 0) continue;
    Vector3d p;
    for (std::size_t k = 0; k < 3; ++k) {
      std::int64_t difference = 0;
      if (!readDifference(difference)) return false;
      if (difference > 2 * kMaxSteps || difference < -2 * kMaxSteps ||
          std::abs(last_[j][k] + difference) > kMaxSteps)
        fail("found a position beyond 1e6 m, expected less");
      last_[j][k] += difference;
      p[static_cast<int>(k)] = static_cast<double>(last_[j][k]) * kCompactStep;
    }
    frame.set(j, p, static_cast<humanmodel::JointState>(state));
    if (hasSpread(mark) && !readSpread(frame.spread[j])) return false;
    if (hasAxes(mark) && !readAxis(frame.lateral[j])) return false;
  }
  last_t_ = frame.t;
  ++frames_;
  return true;
}

void CompactReader::readEnd() {
  if (bytes_.size() - at_ < 8) return;
  const auto count = readU64(bytes_.substr(at_, 8));
  if (count != frames_)
    fail("found the end after " + std::to_string(frames_) + " frames, expected " + std::to_string(count));
}

bool CompactReader::next(PointFrame& frame) {
  if (done_) return false;
  std::uint8_t kind = 0;
  if (readByte(kind)) {
    if (kind > kFrameWithBoth)
      fail("found the mark " + std::to_string(kind) + ", expected 1 to 4 (a frame) or 0 (the end)");
    if (kind != kEnd && readFrame(frame, kind)) return true;
    if (kind == kEnd) readEnd();
  }
  done_ = true;
  if (kind != kEnd || at_ >= bytes_.size())
    warnings_.push_back(
        {0, "the file is truncated: its " + std::to_string(frames_) + " complete frames are read", 1});
  return false;
}

}  // namespace abstand::tracking
