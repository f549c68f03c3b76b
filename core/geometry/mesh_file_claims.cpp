// Headers that claim more than their file holds.
#include <algorithm>
#include <cctype>
#include <cstring>

#include "core/base/number.hpp"
#include "core/geometry/mesh_file_readers.hpp"

namespace abstand::mesh_file {
namespace {

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

void refuseStl(std::string_view content, const std::string& name) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  const bool ascii = content.substr(0, 5) == "solid" && content.find("facet") != std::string_view::npos;
  if (ascii) return;
  if (content.size() < kHeader)
    throw ParseError({name}, "found " + std::to_string(content.size()) +
                                 " bytes, expected the header of a binary STL (84 bytes) or an ascii one");
  std::uint32_t claimed = 0;
  std::memcpy(&claimed, content.data() + 80, sizeof claimed);
  const std::size_t held = (content.size() - kHeader) / kTriangle;
  if (claimed > held)
    throw ParseError({name}, "the header claims " + std::to_string(claimed) + " triangles, the file holds " +
                                 std::to_string(held));
}

/// An element of a PLY file takes at least a byte, ascii or binary.
void refusePly(std::string_view content, const std::string& name) {
  const std::size_t end = std::min(content.find("end_header"), content.size());
  int line = 1;
  for (std::size_t at = 0; at < end; ++line) {
    const std::size_t stop = std::min(content.find('\n', at), end);
    const std::string_view text = content.substr(at, stop - at);
    if (text.substr(0, 8) == "element ") {
      const std::size_t blank = text.find(' ', 8);
      std::string_view number = blank == std::string_view::npos ? "" : text.substr(blank + 1);
      while (!number.empty() && isSpace(number.back())) number.remove_suffix(1);
      const auto count = parseDouble(number);
      if (!count || *count < 0.0 || *count > static_cast<double>(content.size()))
        throw ParseError({name, line}, "found a count of '" + std::string(number.substr(0, 40)) +
                                           "', expected no more elements than the file has bytes");
    }
    at = stop + 1;
  }
}

/// The counts of vertices and faces follow the word OFF; '#' begins a comment.
void refuseOff(std::string_view content, const std::string& name) {
  std::size_t at = std::min(content.find("OFF"), content.size());
  at = std::min(at + 3, content.size());
  int line = 1;
  for (int i = 0; i < 2; ++i) {
    while (at < content.size() && (isSpace(content[at]) || content[at] == '#')) {
      if (content[at] == '#') at = std::min(content.find('\n', at), content.size());
      if (at < content.size() && content[at] == '\n') ++line;
      if (at < content.size()) ++at;
    }
    const std::size_t stop = std::min(content.find_first_of(" \t\r\n", at), content.size());
    const auto count = parseDouble(content.substr(at, stop - at));
    if (!count || *count < 0.0 || *count > static_cast<double>(content.size()))
      throw ParseError({name, line},
                       "found '" + std::string(content.substr(at, std::min<std::size_t>(stop - at, 40))) +
                           "', expected a count of vertices or faces that the file can hold");
    at = stop;
  }
}

}  // namespace

void refuseFalseClaims(std::string_view content, std::string_view format, const std::string& name) {
  if (format == "stl") refuseStl(content, name);
  if (format == "ply") refusePly(content, name);
  if (format == "off") refuseOff(content, name);
}

}  // namespace abstand::mesh_file
