// OFF and its variants with colours, normals or texture coordinates, which are ignored.
#include "core/mesh_file/mesh_file_readers.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::mesh_file {
namespace {

int count(std::string_view word, const char* what, const SourcePos& pos) {
  const auto n = parseInt(word);
  if (!n || *n < 0)
    throw ParseError(pos, "found " + text::inDoubleQuotes(word) + ", expected the number of " + what);
  return *n;
}

std::string_view expectLine(text::Lines& lines, const char* what) {
  const auto line = lines.nextData();
  if (!line) throw ParseError(lines.pos(), std::string("the file ends, expected ") + what);
  return *line;
}

}  // namespace

geometry::TriangleMesh readOff(std::string_view content, const std::string& name) {
  text::Lines lines(content, name);
  auto line = expectLine(lines, "OFF");
  auto rest = line;
  const auto word = text::nextWord(rest);
  // The keyword may be missing; [ST][C][N] before OFF announce columns after x, y, z.
  const bool keyword = word.ends_with("OFF");
  if (keyword && word.find_first_of("4n") != std::string_view::npos)
    throw ParseError(lines.pos(),
                     "found " + text::inDoubleQuotes(word) + ", expected vertices with three coordinates");
  if (!keyword && !parseInt(word))
    throw ParseError(lines.pos(), "found " + text::inDoubleQuotes(word) + ", expected OFF");
  if (!keyword) rest = line;
  if (rest.find_first_not_of(text::kBlank) == std::string_view::npos)
    rest = expectLine(lines, "the numbers of vertices and faces");
  const int vertices = count(text::nextWord(rest), "vertices", lines.pos());
  const int faces = count(text::nextWord(rest), "faces", lines.pos());

  geometry::TriangleMesh mesh;
  for (int v = 0; v < vertices; ++v) {
    rest = expectLine(lines, "a vertex");
    mesh.vertices.push_back(text::nextPoint(rest, lines.pos()));
  }
  PolygonCutter cutter(mesh);
  std::vector<std::uint32_t> corners;
  for (int f = 0; f < faces; ++f) {
    rest = expectLine(lines, "a face");
    const int n = count(text::nextWord(rest), "corners", lines.pos());
    corners.clear();
    for (int i = 0; i < n; ++i)
      corners.push_back(static_cast<std::uint32_t>(count(text::nextWord(rest), "a vertex", lines.pos())));
    cutter.add(corners, lines.pos());
  }
  return mesh;
}

}  // namespace abstand::mesh_file
