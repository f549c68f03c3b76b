#include "core/base/text_file.hpp"

#include <fstream>

#include "core/base/error.hpp"
#include "core/base/input_log.hpp"

namespace abstand {

void needRegularFile(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  const SourcePos pos{file.string()};
  std::error_code ec;
  const auto status = fs::status(file, ec);
  if (!fs::exists(status)) throw ParseError(pos, "no such file, expected a readable file");
  if (fs::is_directory(status)) throw ParseError(pos, "found a directory, expected a file");
  // Reading a pipe would block forever, and a pipe cannot be read twice.
  if (fs::is_fifo(status) || fs::is_socket(status))
    throw ParseError(pos, "found a pipe, expected a regular file", "write its content to a file first");
  if (!fs::is_regular_file(status)) throw ParseError(pos, "found a device, expected a regular file");
  noteInput(file);
}

std::string readFile(const std::filesystem::path& file, std::uintmax_t max_bytes, bool may_be_empty) {
  namespace fs = std::filesystem;
  needRegularFile(file);
  const SourcePos pos{file.string()};
  std::error_code ec;
  const auto bytes = fs::file_size(file, ec);
  if (ec) throw ParseError(pos, "cannot be read: " + ec.message());
  if (bytes == 0 && !may_be_empty) throw ParseError(pos, "the file is empty");
  if (bytes > max_bytes)
    throw ParseError(
        pos, "found " + std::to_string(bytes) + " bytes, expected at most " + std::to_string(max_bytes));
  std::ifstream in(file, std::ios::binary);
  std::string content(bytes, '\0');
  if (!in || !in.read(content.data(), static_cast<std::streamsize>(bytes)))
    throw ParseError(pos, "cannot be read, expected a readable file");
  return content;
}

}  // namespace abstand
