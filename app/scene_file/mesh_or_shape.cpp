#include "app/scene_file/mesh_or_shape.hpp"

#include <system_error>

namespace abstand::scene_file {

namespace fs = std::filesystem;

fs::path existingRecording(const config::YamlNode& node, const NamedIn& in, const std::string& label) {
  const fs::path path = (in.folder / config::yamlText(node, in.file, label)).lexically_normal();
  std::error_code ec;
  // What is in it is the business of the readers.
  if (fs::is_directory(path, ec)) return path;
  return existingFile(node, in, label, "a recording");
}

fs::path existingFile(const config::YamlNode& node, const NamedIn& in, const std::string& label,
                      const char* expected) {
  const std::string text = config::yamlText(node, in.file, label);
  const fs::path path = (in.folder / text).lexically_normal();
  std::error_code ec;
  const auto status = fs::status(path, ec);
  if (fs::is_regular_file(status)) return path;
  const SourcePos pos{in.file, node.line, node.column};
  if (fs::exists(status))
    throw ParseError(pos, "found " + std::string(fs::is_directory(status) ? "a folder" : "no regular file") +
                              " at " + path.string() + " for " + label + ", expected " + expected);
  throw ParseError(pos, "found no file " + path.string() + " for " + label + ", expected " + expected,
                   fs::path(text).is_absolute() ? ""
                                                : "the path is relative to the folder of the " +
                                                      std::string(in.kind) + ", " + in.folder.string());
}

}  // namespace abstand::scene_file
