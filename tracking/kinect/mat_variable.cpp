#include "tracking/kinect/mat_variable.hpp"

#include <zlib.h>

#include <array>
#include <cstring>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kHeaderBytes = 128, kVersion = 124, kMaxUnpacked = std::size_t{256} << 20;
enum : std::uint32_t { kInt8 = 1, kInt32 = 5, kUint32 = 6, kMatrix = 14, kCompressed = 15 };
constexpr std::uint32_t kComplex = 0x800, kDoubleClass = 6, kSingleClass = 7;

template <typename T>
T valueAt(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Iterates over the elements of a file, or of a matrix: type, length, bytes.
class Elements {
 public:
  Elements(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  bool atEnd() const { return at_ >= bytes_.size(); }

  /// The next element. Small ones have type and length in one word.
  std::string_view next(std::uint32_t& type) {
    if (at_ > bytes_.size() || bytes_.size() - at_ < 8) fail("found the end, expected an element");
    const auto first = valueAt<std::uint32_t>(bytes_, at_);
    const bool is_small = first >> 16 != 0;
    type = is_small ? first & 0xffff : first;
    const std::size_t length = is_small ? first >> 16 : valueAt<std::uint32_t>(bytes_, at_ + 4);
    const std::size_t start = at_ + (is_small ? 4 : 8);
    if ((is_small && length > 4) || length > bytes_.size() - start)
      fail("found an element of " + std::to_string(length) + " bytes, expected what fits");
    // All elements except compressed ones are padded to a multiple of eight.
    at_ = is_small ? at_ + 8 : start + (type == kCompressed ? length : (length + 7) / 8 * 8);
    return bytes_.substr(start, length);
  }

  std::string_view need(std::uint32_t wanted, const char* what) {
    std::uint32_t type = 0;
    const auto content = next(type);
    if (type != wanted) fail("found an element of type " + std::to_string(type) + ", expected " + what);
    return content;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError({file_}, "at byte " + std::to_string(at_) + ": " + message);
  }

 private:
  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_{0};
};

std::string unpack(std::string_view packed, const std::string& file) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw ParseError({file}, "zlib does not start, expected memory for it");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string out;
  std::array<char, 1 << 16> chunk;
  int state = Z_OK;
  while (state == Z_OK && out.size() <= kMaxUnpacked) {
    stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
    stream.avail_out = static_cast<uInt>(chunk.size());
    state = inflate(&stream, Z_NO_FLUSH);
    out.append(chunk.data(), chunk.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END)
    throw ParseError({file}, state == Z_OK ? "found more than 256 MB packed, expected a skeleton"
                                           : "found packed data that is damaged or cut, expected zlib's");
  return out;
}

template <typename T>
std::vector<double> numbersOf(std::string_view content) {
  std::vector<double> values;
  values.reserve(content.size() / sizeof(T));
  for (std::size_t at = 0; at + sizeof(T) <= content.size(); at += sizeof(T))
    values.push_back(static_cast<double>(valueAt<T>(content, at)));
  return values;
}

/// Number types of MATLAB: doubles with integer values are stored in fewer bytes.
std::vector<double> numbersOf(std::string_view content, std::uint32_t type, const Elements& at) {
  switch (type) {
    case 1:
      return numbersOf<std::int8_t>(content);
    case 2:
      return numbersOf<std::uint8_t>(content);
    case 3:
      return numbersOf<std::int16_t>(content);
    case 4:
      return numbersOf<std::uint16_t>(content);
    case 5:
      return numbersOf<std::int32_t>(content);
    case 6:
      return numbersOf<std::uint32_t>(content);
    case 7:
      return numbersOf<float>(content);
    case 9:
      return numbersOf<double>(content);
    default:
      at.fail("found numbers of type " + std::to_string(type) + ", expected 1 to 7 or 9");
  }
}

std::string sizeText(const std::vector<std::size_t>& size) {
  std::string s;
  for (const auto n : size) s += (s.empty() ? "" : " x ") + std::to_string(n);
  return s;
}

/// Header of a matrix, before its numbers.
struct MatrixHead {
  std::uint32_t flags{0};
  std::vector<std::size_t> size;
  std::string name;
};

MatrixHead readHead(Elements& in) {
  MatrixHead head;
  const auto flags = in.need(kUint32, "the flags of an array");
  if (flags.size() < 4) in.fail("found flags of less than four bytes, expected eight");
  head.flags = valueAt<std::uint32_t>(flags, 0);
  for (const double n : numbersOf<std::int32_t>(in.need(kInt32, "the size of an array"))) {
    if (n < 0) in.fail("found a negative size, expected none");
    head.size.push_back(static_cast<std::size_t>(n));
  }
  head.name = in.need(kInt8, "the name of an array");
  return head;
}

MatVariable readNumbers(Elements& in, const MatrixHead& head) {
  const std::uint32_t kind = head.flags & 0xff;
  if ((kind != kDoubleClass && kind != kSingleClass) || (head.flags & kComplex) != 0)
    in.fail("found " + text::inQuotes(head.name) + " that is no array of real numbers, expected one");
  std::uint32_t type = 0;
  const auto content = in.next(type);
  MatVariable out{head.size, numbersOf(content, type, in)};
  std::size_t count = 1;
  for (const auto n : head.size) {
    count *= n;
    if (count > out.values.size()) break;
  }
  if (count != out.values.size())
    in.fail("found " + std::to_string(out.values.size()) + " numbers, expected " + sizeText(head.size));
  return out;
}

}  // namespace

MatVariable readMatVariable(std::string_view bytes, const std::string& name, const std::string& file) {
  if (bytes.size() < kHeaderBytes || bytes.substr(kVersion, 4) != std::string_view("\0\1IM", 4))
    throw ParseError({file}, "found no MATLAB file of version 5 to 7.2 in little-endian order, expected one");
  Elements elements(bytes.substr(kHeaderBytes), file);
  std::string others;
  while (!elements.atEnd()) {
    std::uint32_t type = 0;
    std::string_view content = elements.next(type);
    std::string unpacked;
    if (type == kCompressed) {
      unpacked = unpack(content, file);
      content = Elements(unpacked, file).next(type);
    }
    if (type != kMatrix) continue;
    Elements matrix(content, file);
    const MatrixHead head = readHead(matrix);
    if (head.name == name) return readNumbers(matrix, head);
    if (others.size() < 200)
      others += (others.empty() ? "" : ", ") + text::inQuotes(head.name) + " (" + sizeText(head.size) + ")";
  }
  throw ParseError(
      {file}, (others.empty() ? std::string("found no variable") : "found " + others) + ", expected " + name,
      others.find("'d_depth'") != std::string::npos ? "this is a depth recording, not a skeleton" : "");
}

}  // namespace abstand::tracking
