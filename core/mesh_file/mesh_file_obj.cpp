// Wavefront OBJ: vertices and faces; materials, normals and texture coordinates are ignored.
#include "core/mesh_file/mesh_file_readers.hpp"
#include "core/text/text_lines.hpp"

namespace abstand::mesh_file {
namespace {

/// Vertex index from 0 of "7", "7/1", "7//3", "-1/..".
std::uint32_t vertexOf(std::string_view word, std::size_t vertices_so_far, const SourcePos& pos) {
  const auto index = parseInt(word.substr(0, word.find('/')));
  const auto n = static_cast<std::int64_t>(vertices_so_far);
  if (!index || *index == 0 || n + *index < 0)
    throw ParseError(
        pos, "found " + text::inDoubleQuotes(word) + ", expected a vertex number (from 1, or back from -1)");
  return static_cast<std::uint32_t>(*index > 0 ? *index - 1 : n + *index);
}

}  // namespace

geometry::TriangleMesh readObj(std::string_view content, const std::string& name) {
  geometry::TriangleMesh mesh;
  struct Face {
    std::size_t first_corner;
    int line;
  };
  std::vector<Face> faces;
  std::vector<std::uint32_t> corners;

  text::Lines lines(content, name);
  std::string joined;
  while (auto line = lines.next()) {
    const int number_of_line = lines.pos().line;
    if (line->ends_with('\\')) {  // the statement continues on the next line
      joined.clear();
      while (line && line->ends_with('\\')) {
        joined.append(line->substr(0, line->size() - 1)).push_back(' ');
        line = lines.next();
      }
      if (line) joined += *line;
      line = joined;
    }
    auto rest = line->substr(0, line->find('#'));
    const auto word = text::nextWord(rest);
    if (word == "v") {
      mesh.vertices.push_back(text::nextPoint(rest, lines.pos()));
    } else if (word == "f") {
      faces.push_back({corners.size(), number_of_line});
      for (auto corner = text::nextWord(rest); !corner.empty(); corner = text::nextWord(rest))
        corners.push_back(vertexOf(corner, mesh.vertices.size(), lines.pos()));
    }
  }
  PolygonCutter cutter(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto end = f + 1 < faces.size() ? faces[f + 1].first_corner : corners.size();
    cutter.add(std::span(corners).subspan(faces[f].first_corner, end - faces[f].first_corner),
               {name, faces[f].line, 0});
  }
  return mesh;
}

}  // namespace abstand::mesh_file
