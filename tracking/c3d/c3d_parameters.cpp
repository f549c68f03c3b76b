#include "tracking/c3d/c3d_parameters.hpp"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kHead = 4;  // bytes before the first record
constexpr std::string_view kPadding(" \0", 2);

std::string upperCase(std::string_view s) {
  std::string out(s);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

/// Values of a parameter whose type is at `at`. Throws ParseError if they exceed the file.
C3dParameter readValues(const C3dBytes& bytes, std::size_t at) {
  const int type = bytes.i8(at);
  const std::size_t dimensions = bytes.u8(at + 1);
  if (type != -1 && type != 1 && type != 2 && type != 4)
    bytes.fail(at, "found the type " + std::to_string(type) + ", expected -1, 1, 2 or 4");
  std::size_t count = 1;
  for (std::size_t i = 0; i < dimensions; ++i) {
    count *= bytes.u8(at + 2 + i);
    if (count > bytes.size()) bytes.fail(at, "found more values than the file has bytes, expected fewer");
  }
  const std::size_t first = at + 2 + dimensions, width = static_cast<std::size_t>(std::abs(type));
  bytes.text(first, count * width);
  C3dParameter out;
  if (type == -1) {
    const std::size_t length = dimensions > 0 ? bytes.u8(at + 2) : 1;
    for (std::size_t i = 0; length > 0 && i + length <= count; i += length)
      out.texts.emplace_back(text::trimmed(bytes.text(first + i, length), " ", kPadding));
  } else {
    for (std::size_t i = 0; i < count; ++i)
      out.numbers.push_back(type == 1   ? bytes.u8(first + i)
                            : type == 2 ? static_cast<double>(bytes.u16(first + 2 * i))
                                        : static_cast<double>(bytes.f32(first + 4 * i)));
  }
  return out;
}

}  // namespace

C3dParameters readC3dParameters(const C3dBytes& bytes, std::size_t start,
                                std::vector<FileWarning>& warnings) {
  C3dParameters out;
  std::map<int, std::string> groups;
  std::vector<std::tuple<int, std::string, std::size_t>> found;  // group, name, offset of the type
  const auto stop = [&](std::size_t at, const std::string& why) {
    warnings.push_back(
        {0, "at byte " + std::to_string(at) + ": " + why + ": parameters after it are ignored"});
  };
  std::size_t at = start + kHead;
  while (at + 2 <= bytes.size()) {
    const auto length = static_cast<std::size_t>(std::abs(int{bytes.i8(at)}));  // negative: locked
    const int id = bytes.i8(at + 1);
    if (length == 0) break;
    const std::size_t pointer = at + 2 + length;
    if (pointer + 2 > bytes.size()) {
      stop(at, "a parameter that is longer than the file");
      break;
    }
    const std::string name = upperCase(bytes.text(at + 2, length));
    const int step = bytes.i16(pointer);
    if (id < 0)
      groups.emplace(-id, name);
    else
      found.emplace_back(id, name, pointer + 2);
    if (step == 0) break;
    if (step < 2) {
      stop(pointer, "the record " + text::inQuotes(name) + " points back by " + std::to_string(step));
      if (id >= 0) found.pop_back();
      break;
    }
    at = pointer + static_cast<std::size_t>(step);
  }
  for (const auto& [group, name, place] : found) {
    const auto it = groups.find(group);
    try {
      out.emplace((it == groups.end() ? "" : it->second) + ":" + name, readValues(bytes, place));
    } catch (const ParseError& e) {
      warnings.push_back({0, e.message() + ": the parameter " + text::inQuotes(name) + " is ignored"});
    }
  }
  return out;
}

}  // namespace abstand::tracking
