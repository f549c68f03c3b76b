// Reads NumPy arrays.
#include "tracking/depth/formats/npy_array.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kMaxHeader = 1 << 16;
constexpr std::size_t kMaxNumbers = std::size_t{1} << 31;

/// The value of a key in the header's dictionary, up to the next comma outside of brackets.
std::string_view valueOf(std::string_view header, std::string_view key, const std::string& file) {
  const std::size_t at = header.find(key);
  std::size_t from = at == std::string_view::npos ? at : header.find(':', at + key.size());
  if (from == std::string_view::npos)
    throw ParseError({file}, "found a header without " + std::string(key) + ", expected one");
  ++from;
  while (from < header.size() && header[from] == ' ') ++from;
  std::size_t end = from;
  for (int depth = 0; end < header.size(); ++end) {
    depth += header[end] == '(' ? 1 : header[end] == ')' ? -1 : 0;
    if (depth <= 0 && (header[end] == ',' || header[end] == '}')) break;
  }
  return header.substr(from, end - from);
}

/// IEEE 754 half precision.
double halfFloat(std::uint64_t bits) {
  const int exponent = static_cast<int>(bits >> 10 & 31);
  const double mantissa = static_cast<double>(bits & 1023), sign = bits >> 15 & 1 ? -1.0 : 1.0;
  if (exponent == 31) return mantissa == 0.0 ? sign * HUGE_VAL : std::nan("");
  return sign * (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024.0 + mantissa, exponent - 25));
}

}  // namespace

double NpyArray::at(std::size_t i) const {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < bytes_each; ++k)
    bits = bits << 8 |
           static_cast<unsigned char>(data[i * bytes_each + (is_low_first ? bytes_each - 1 - k : k)]);
  if (kind == 'u') return static_cast<double>(bits);
  if (kind == 'f') {
    if (bytes_each == 2) return halfFloat(bits);
    if (bytes_each == 4) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    return std::bit_cast<double>(bits);
  }
  const auto shift = static_cast<int>(64 - 8 * bytes_each);
  return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
}

NpyArray parseNpy(std::string_view bytes, const std::string& file) {
  const auto fail = [&](const std::string& message) { throw ParseError({file}, message); };
  if (!bytes.starts_with("\x93NUMPY") || bytes.size() < 12) fail("found no NumPy array, expected one");
  const int version = bytes[6];
  if (version < 1 || version > 3)
    fail("found version " + std::to_string(version) + " of NumPy's format, expected 1 to 3");
  const std::size_t start = version == 1 ? 10 : 12;
  std::size_t length = 0;
  for (std::size_t i = start; i-- > 8;) length = length << 8 | static_cast<unsigned char>(bytes[i]);
  if (length > kMaxHeader || bytes.size() - start < length)
    fail("found a header of " + std::to_string(length) + " bytes, expected what fits");
  const std::string_view header = bytes.substr(start, length);

  NpyArray array;
  const std::string_view type = valueOf(header, "'descr'", file);
  const bool known = type.size() == 5 && type.front() == '\'' && type.back() == '\'' &&
                     std::string_view("<>|").find(type[1]) != std::string_view::npos &&
                     std::string_view("uif").find(type[2]) != std::string_view::npos &&
                     std::string_view("1248").find(type[3]) != std::string_view::npos &&
                     !(type[2] == 'f' && type[3] == '1');
  if (!known) fail("found numbers of type " + text::inQuotes(type) + ", expected one like '<u2' or '<f4'");
  array.is_low_first = type[1] != '>';
  array.kind = type[2];
  array.bytes_each = static_cast<std::size_t>(type[3] - '0');
  if (!valueOf(header, "'fortran_order'", file).starts_with("False"))
    fail("found columns before rows (Fortran order), expected rows first");

  std::string_view shape = valueOf(header, "'shape'", file);
  std::size_t count = 1;
  if (!shape.starts_with("("))
    fail("found the shape " + text::inQuotes(shape) + ", expected sizes in brackets");
  shape.remove_prefix(1);
  while (!shape.empty() && shape.front() != ')') {
    const std::size_t end = shape.find_first_of(",)");
    std::string_view word = shape.substr(0, end);
    while (word.starts_with(' ')) word.remove_prefix(1);
    const auto n = parseInt(word);
    if (!n || *n < 1 || array.size.size() == 4)
      fail("found the size " + text::inQuotes(word) + " in the shape, expected up to four above 0");
    array.size.push_back(static_cast<std::size_t>(n.value_or(1)));
    count *= array.size.back();
    if (count > kMaxNumbers) fail("found a shape of more than 2147483648 numbers, expected fewer");
    shape.remove_prefix(end == std::string_view::npos ? shape.size() : end + (shape[end] == ',' ? 1 : 0));
    while (shape.starts_with(' ')) shape.remove_prefix(1);
  }
  array.data = bytes.substr(start + length);
  if (array.size.empty() || array.data.size() != count * array.bytes_each)
    fail("found " + std::to_string(array.data.size()) + " bytes of numbers, expected " +
         std::to_string(count * array.bytes_each));
  return array;
}

}  // namespace abstand::tracking
