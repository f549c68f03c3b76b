#include "core/base/output_file.hpp"

#include <unistd.h>

#include <locale>

#include "core/base/error.hpp"

namespace abstand {

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)) {
  part_ = file_;
  part_ += ".part" + std::to_string(::getpid());
  out_.open(part_, std::ios::binary | std::ios::trunc);
  out_.imbue(std::locale::classic());
  if (!out_) throw UsageError(file_.string() + ": cannot be written");
}

OutputFile::~OutputFile() {
  if (committed_) return;
  out_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void OutputFile::commit() {
  out_.close();
  if (!out_) throw UsageError(file_.string() + ": cannot be written whole");
  std::error_code ec;
  std::filesystem::rename(part_, file_, ec);
  if (ec) throw UsageError(file_.string() + ": " + ec.message());
  committed_ = true;
}

}  // namespace abstand
