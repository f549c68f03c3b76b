// Geometry of a body in a scene file: a mesh, a shape or a structure.
#pragma once

#include <filesystem>
#include <functional>

#include "app/scene_file/body_fields.hpp"
#include "core/base/error.hpp"

namespace abstand::scene_file {

/// Where file names stand.
struct NamedIn {
  const std::string& file;              ///< for errors
  const std::filesystem::path& folder;  ///< base of relative paths
  const char* kind{"scene file"};
};

/// Absolute path of the regular file that a node names. Throws ParseError.
std::filesystem::path existingFile(const config::YamlNode& node, const NamedIn& in, const std::string& label,
                                   const char* expected);
/// Absolute path of the file, or the folder of depth images, that a node names. Throws ParseError.
std::filesystem::path existingRecording(const config::YamlNode& node, const NamedIn& in,
                                        const std::string& label);

/// existingFile() with its NamedIn.
using FindFile = std::function<std::filesystem::path(const config::YamlNode& node, const std::string& label,
                                                     const char* expected)>;

/// Reads `mesh` with `scale`, `shape` or `structure`, one of which is needed. Throws ParseError.
template <class Body>
void readMeshOrShape(const config::YamlFields& fields, const FindFile& find, Body& body) {
  const auto* mesh = fields.find("mesh");
  const auto* shape_node = fields.find("shape");
  const auto* structure = fields.find("structure");
  if (structure && (mesh || shape_node))
    throw ParseError(fields.keyPos("structure"), std::string("found `structure` together with `") +
                                                     (mesh ? "mesh" : "shape") +
                                                     "` in one body, expected one of them");
  if (!structure && !mesh == !shape_node)
    throw ParseError(shape_node ? fields.keyPos("shape") : fields.pos(),
                     std::string("found ") + (mesh ? "both" : "neither") +
                         " `mesh` and `shape` in one body, expected one of them");
  if (mesh) body.mesh = find(*mesh, "`mesh`", "a mesh");
  if (shape_node) body.shape = readShape(*shape_node, fields.file());
  if (structure) {
    body.structure = find(*structure, "`structure`", "a structure file");
    for (const char* key : {"voxel", "point", "outer_layers"})
      if (fields.find(key))
        throw ParseError(
            fields.keyPos(key),
            "found `" + std::string(key) + "` together with `structure`, expected it with a mesh or a shape",
            "the structure file sets its resolution");
  }
  if (!mesh && fields.find("scale"))
    throw ParseError(fields.keyPos("scale"),
                     std::string("found `scale` together with `") + (structure ? "structure" : "shape") +
                         "`, expected it with a mesh only",
                     structure ? "" : "the sizes of a shape are in metres");
  body.scale = readScale(fields);
}

}  // namespace abstand::scene_file
