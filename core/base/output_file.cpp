#include "core/base/output_file.hpp"

#include <unistd.h>

#include <atomic>
#include <locale>

#include "core/base/error.hpp"

namespace abstand {

namespace {
// Two threads may write the same file at once; the last one to end wins.
std::atomic<unsigned> files_made{0};
}  // namespace

OutputFile::OutputFile(std::filesystem::path file) : file_(std::move(file)) {
  part_ = file_;
  part_ += ".part" + std::to_string(::getpid()) + "." + std::to_string(files_made.fetch_add(1));
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

void writeFile(const std::filesystem::path& file, std::string_view text) {
  OutputFile out(file);
  out.stream() << text;
  out.commit();
}

}  // namespace abstand
