// STL, binary and ASCII.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "core/mesh_file/mesh_file_readers.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::mesh_file {
namespace {

static_assert(std::endian::native == std::endian::little,
              "binary STL is read and written as it lies in memory");

constexpr std::size_t kHeader = 84;
constexpr std::size_t kRecord = 50;

geometry::TriangleMesh readBinary(std::string_view content, std::uint32_t count, const std::string& name) {
  geometry::TriangleMesh mesh;
  mesh.vertices.reserve(3 * std::size_t{count});
  mesh.triangles.reserve(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    float v[9];
    std::memcpy(v, content.data() + kHeader + kRecord * t + 12, sizeof v);  // after the normal
    for (int i = 0; i < 9; i += 3) {
      mesh.vertices.emplace_back(v[i], v[i + 1], v[i + 2]);
      if (!mesh.vertices.back().allFinite())
        throw ParseError({name}, "found a coordinate that is not finite in triangle " +
                                     std::to_string(t + 1) + ", expected finite numbers");
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

bool isWord(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

geometry::TriangleMesh readAscii(std::string_view content, const std::string& name) {
  geometry::TriangleMesh mesh;
  text::Lines lines(content, name);
  std::size_t loop_first = 0;
  while (auto line = lines.next()) {
    auto rest = *line;
    for (auto word = text::nextWord(rest); !word.empty(); word = text::nextWord(rest)) {
      if (isWord(word, "solid") || isWord(word, "endsolid")) break;  // an arbitrary name follows
      if (isWord(word, "vertex")) {
        mesh.vertices.push_back(text::nextPoint(rest, lines.pos()));
      } else if (isWord(word, "endloop") || isWord(word, "endfacet")) {
        const auto corners = mesh.vertices.size() - loop_first;
        if (corners == 0) continue;
        if (corners != 3)
          throw ParseError(lines.pos(),
                           "found a facet of " + std::to_string(corners) + " vertices, expected 3");
        const auto first = static_cast<std::uint32_t>(loop_first);
        mesh.triangles.push_back({first, first + 1, first + 2});
        loop_first = mesh.vertices.size();
      }
    }
  }
  if (loop_first != mesh.vertices.size())
    throw ParseError(lines.pos(), "the file ends within a facet, expected endloop");
  return mesh;
}

}  // namespace

geometry::TriangleMesh readStl(std::string_view content, const std::string& name) {
  const auto first = content.find_first_not_of(text::kBlank);
  const bool solid = first != std::string_view::npos && isWord(content.substr(first, 5), "solid");
  if (content.size() >= kHeader) {
    std::uint32_t count = 0;
    std::memcpy(&count, content.data() + kHeader - 4, 4);
    const std::uint64_t needed = kHeader + std::uint64_t{kRecord} * count;
    // Binary files may begin with "solid" too: only their size distinguishes them.
    if (needed == content.size() || (!solid && needed < content.size()))
      return readBinary(content, count, name);
    if (!solid)
      throw ParseError({name}, "the header of a binary STL claims " + std::to_string(count) +
                                   " triangles, the file has room for " +
                                   std::to_string((content.size() - kHeader) / kRecord));
  }
  if (!solid)
    throw ParseError({name}, "is neither an ascii STL, which begins with \"solid\", nor a binary one");
  return readAscii(content, name);
}

}  // namespace abstand::mesh_file
