// Container format of OpenNI recordings (.oni).
#include "tracking/depth/formats/oni_recording.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <memory>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"
#include "tracking/depth/formats/depth_sources.hpp"

namespace abstand::tracking {
namespace {

constexpr std::uint32_t kMagic = 0x0052494e;  // "NIR" and a zero byte
constexpr std::uint32_t kMaxOniFields = 1u << 20, kMaxData = 64u << 20;
constexpr std::uint32_t kDepthStream = 2;
constexpr std::uint64_t kOniMillimetres = 100, kTenthsOfThem = 101;  // ONI_PIXEL_FORMAT_DEPTH_...

enum Type : std::uint32_t {
  kAdded4 = 0x02,
  kIntProperty = 0x03,
  kGeneralProperty = 0x06,
  kData = 0x0a,
  kEnd = 0x0b,
  kAdded5 = 0x0c,
  kAdded = 0x0d
};

std::uint64_t lowFirst(std::string_view bytes) {
  std::uint64_t n = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) n = n << 8 | static_cast<unsigned char>(bytes[i]);
  return n;
}

double realOf(std::string_view eight) { return std::bit_cast<double>(lowFirst(eight)); }

std::uint32_t codec(const char* four) { return static_cast<std::uint32_t>(lowFirst({four, 4})); }

class Reader {
 public:
  Reader(std::istream& in, const std::string& file) : in_{in}, file_{file} {}

  OniDepth read() {
    readHeader();
    for (depth_.is_cut = true; depth_.is_cut && readRecord();) {
    }
    if (!stream_) fail("found no depth in the OpenNI recording, expected a stream of it");
    if (depth_.frames.empty()) fail("found no image of depth, expected at least one");
    return std::move(depth_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError({file_}, "at byte " + std::to_string(at_) + ": " + message);
  }

  /// Reads `size` bytes; false if the file ends before.
  bool readBytes(std::size_t size) {
    bytes_.resize(size);
    in_.read(bytes_.data(), static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(in_.gcount()) == size;
  }

  void readHeader() {
    constexpr std::size_t kHeader = 24;
    if (!readBytes(kHeader) || bytes_.substr(0, 4) != "NI10")
      fail("found no OpenNI recording, expected NI10");
    const std::string_view b = bytes_;
    const std::uint64_t major = lowFirst(b.substr(4, 1)), minor = lowFirst(b.substr(5, 1));
    const std::uint64_t third = lowFirst(b.substr(6, 2)), fourth = lowFirst(b.substr(8, 4));
    const std::string version = std::to_string(major) + "." + std::to_string(minor) + "." +
                                std::to_string(third) + "." + std::to_string(fourth);
    if (major != 1 || minor != 0 || (third == 0 && fourth < 4))
      fail("found version " + version + " of the format, expected 1.0.0.4 to 1.0.1");
    header_ = third == 0 ? 24 : 28;
    at_ = kHeader;
  }

  /// Reads one record; false if the file ends within it.
  bool readRecord() {
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(at_));
    if (!readBytes(header_)) return false;
    const std::string head = bytes_;
    const auto word = [&](std::size_t i) {
      return static_cast<std::uint32_t>(lowFirst(std::string_view(head).substr(4 * i, 4)));
    };
    if (word(0) != kMagic) fail("found no record, expected NIR");
    const std::uint32_t type = word(1), stream = word(2), fields = word(3), data = word(4);
    if (fields < header_ || fields - header_ > kMaxOniFields || data > kMaxData)
      fail("found a record of " + std::to_string(fields) + " and " + std::to_string(data) +
           " bytes, expected smaller ones");
    if (!readBytes(fields - header_)) return false;
    switch (type) {
      case kAdded4:
      case kAdded5:
      case kAdded:
        addStream(stream);
        break;
      case kIntProperty:
      case kGeneralProperty:
        if (stream_ == stream) takeProperty();
        break;
      case kData:
        if (stream_ == stream && !takeImage(data)) return false;
        break;
      case kEnd:
        depth_.is_cut = false;
        break;
      default:
        break;
    }
    at_ += std::uint64_t{fields} + data;
    return true;
  }

  /// A text, preceded by its length and followed by a zero byte; advances `from` past it.
  std::string_view text(std::size_t& from) const {
    const std::uint64_t size = number(from, 4);
    if (size == 0 || size > bytes_.size() - from) fail("found a text that is longer than its record");
    const std::string_view found = std::string_view(bytes_).substr(from, size - 1);
    from += size;
    return found;
  }

  std::uint64_t number(std::size_t& from, std::size_t size) const {
    if (size > bytes_.size() - from) fail("found a record that is too short");
    const std::uint64_t n = lowFirst(std::string_view(bytes_).substr(from, size));
    from += size;
    return n;
  }

  void addStream(std::uint32_t stream) {
    std::size_t from = 0;
    text(from);
    if (number(from, 4) != kDepthStream || stream_) return;
    const auto packing = static_cast<std::uint32_t>(number(from, 4));
    if (packing == codec("NONE"))
      depth_.packing = OniPacking::kNone;
    else if (packing == codec("16zP"))
      depth_.packing = OniPacking::k16z;
    else if (packing == codec("16zT"))
      depth_.packing = OniPacking::kTable;
    else
      fail("found depth packed by " + text::inQuotes(std::string_view(bytes_).substr(from - 4, 4)) +
           ", expected NONE, 16zP or 16zT");
    stream_ = stream;
  }

  void takeProperty() {
    std::size_t from = 0;
    const std::string_view name = text(from);
    const std::uint64_t size = number(from, 4);
    if (size != bytes_.size() - from) fail("found a property of another size than its record");
    const std::string_view value = std::string_view(bytes_).substr(from);
    if (name == "xnMapOutputMode" && size >= 12) {
      setSize(lowFirst(value.substr(0, 4)), lowFirst(value.substr(4, 4)));
      const auto rate = static_cast<double>(lowFirst(value.substr(8, 4)));
      depth_.rate = rate <= 1000.0 ? rate : 0.0;
    } else if (name == "xnFOV" && size >= 16) {
      depth_.across = angle(realOf(value.substr(0, 8)));
      depth_.down = angle(realOf(value.substr(8, 8)));
    } else if (name == "xnMirror" && size >= 1) {
      depth_.is_mirrored = lowFirst(value.substr(0, std::min<std::size_t>(8, size))) != 0;
    } else if (name == "xnCropping" && size >= 4) {
      if (lowFirst(value.substr(0, 4)) != 0) fail("found images that are cropped, expected whole ones");
    } else if (name == "oniPixelFormat" && size == 8) {
      const std::uint64_t unit = lowFirst(value);
      if (unit != kOniMillimetres && unit != kTenthsOfThem)
        fail("found depth in pixels of kind " + std::to_string(unit) +
             ", expected millimetres (100) or tenths of them (101)");
      depth_.metres = unit == kOniMillimetres ? 1e-3 : 1e-4;
    }
  }

  static std::optional<double> angle(double rad) {
    // The comparisons also reject NaN.
    if (rad > 0.1 && rad < 3.0) return rad;
    return std::nullopt;
  }

  void setSize(std::uint64_t width, std::uint64_t height) {
    constexpr auto kMax = static_cast<std::uint64_t>(DepthCamera::kMaxPixels);
    if (width < 1 || height < 1 || width > kMax || height > kMax)
      fail("found images of " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
    const bool is_other =
        depth_.width != static_cast<int>(width) || depth_.height != static_cast<int>(height);
    if (is_other && !depth_.frames.empty())
      fail("found images of another size than before, expected one size");
    depth_.width = static_cast<int>(width);
    depth_.height = static_cast<int>(height);
  }

  bool takeImage(std::uint32_t data) {
    std::size_t from = 0;
    OniFrame frame;
    frame.t = 1e-6 * static_cast<double>(number(from, 8));
    frame.begin = at_ + header_ + bytes_.size();
    frame.bytes = data;
    if (depth_.width == 0) fail("found an image before its size, expected xnMapOutputMode");
    in_.seekg(0, std::ios::end);
    if (static_cast<std::uint64_t>(in_.tellg()) < frame.begin + data) return false;
    if (!depth_.frames.empty() && frame.t <= depth_.frames.back().t) {
      if (frame.t < depth_.frames.back().t) fail("found a decreasing time, expected increasing times");
      return true;
    }
    depth_.frames.push_back(frame);
    return true;
  }

  std::istream& in_;
  const std::string& file_;
  std::uint64_t at_{0};  ///< position of the current record
  std::size_t header_{28};
  std::string bytes_;  ///< of the current record, without its header
  std::optional<std::uint32_t> stream_;
  OniDepth depth_;
};

/// OpenNI's pinhole camera: the field of view spans the whole image, whose centre is between the pixels.
std::optional<GivenCamera> cameraOf(const OniDepth& depth) {
  if (!depth.across || !depth.down) return std::nullopt;
  GivenCamera given;
  given.reason = "the field of view in the file";
  DepthCamera& c = given.camera;
  c.width = depth.width;
  c.height = depth.height;
  c.fx = 0.5 * c.width / std::tan(0.5 * *depth.across);
  c.fy = 0.5 * c.height / std::tan(0.5 * *depth.down);
  c.cx = 0.5 * c.width;
  c.cy = 0.5 * c.height;
  return given;
}

}  // namespace

OniDepth readOni(std::istream& in, const std::string& file) { return Reader(in, file).read(); }

DepthImage readOniImage(std::istream& in, const OniDepth& depth, const OniFrame& frame,
                        const std::string& file) {
  std::string bytes(frame.bytes, '\0');
  in.clear();
  in.seekg(static_cast<std::streamoff>(frame.begin));
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (static_cast<std::size_t>(in.gcount()) != bytes.size())
    throw ParseError({file}, "found the end of the file in an image, expected all of it");
  const std::size_t count = static_cast<std::size_t>(depth.width) * static_cast<std::size_t>(depth.height);
  const std::vector<std::uint16_t> numbers = unpackOni(bytes, depth.packing, count, file);
  DepthImage image(depth.width, depth.height);
  const auto metres = static_cast<float>(depth.metres);
  for (std::size_t i = 0; i < numbers.size(); ++i) image.z[i] = static_cast<float>(numbers[i]) * metres;
  return image;
}

DepthSource openOni(const std::filesystem::path& file, const DepthStreamOptions& options) {
  const std::string name = file.string();
  const auto in = std::make_shared<std::ifstream>(file, std::ios::binary);
  if (!*in) throw ParseError({name}, "found a file that cannot be opened, expected an OpenNI recording");
  const OniDepth depth = readOni(*in, name);
  DepthSource source;
  source.facts.format = "oni";
  source.facts.notes.push_back(depth.metres == 1e-3 ? "millimetres" : "tenths of millimetres");
  if (depth.is_cut)
    source.facts.notes.push_back("the recorder did not close the file; its complete images are read");
  source.mirrored = depth.is_mirrored;
  chooseCamera(source, givenCamera(options, file.parent_path()), depth.width, depth.height, name,
               cameraOf(depth));
  if (options.rate > 0.0) {
    countTimes(source, depth.frames.size(), options);
  } else {
    for (const OniFrame& f : depth.frames) source.t.push_back(f.t - depth.frames.front().t);
    source.facts.rate_reason = "the time stamps of the file";
  }
  source.load = [in, depth, name](std::size_t i) { return readOniImage(*in, depth, depth.frames[i], name); };
  return source;
}

}  // namespace abstand::tracking
