#include "core/base/output_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>

#include "core/base/error.hpp"
#include "core/base/input_log.hpp"
#include "core/base/output_file.hpp"
#include "core/base/write_error.hpp"

namespace abstand {
namespace fs = std::filesystem;
namespace {

std::atomic<unsigned> folders_made{0};

[[noreturn]] void fail(const fs::path& name, const std::error_code& ec) {
  if (ec == std::errc::no_space_on_device || ec == std::errc::io_error)
    throw WriteError(name.string(), ec.value());
  throw UsageError(name.string() + ": cannot be written: " + ec.message());
}

/// Target of a link to a folder that does not exist yet.
fs::path followed(fs::path path) {
  std::error_code ec;
  path = fs::absolute(path, ec).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  constexpr int kMaxLinks = 40;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, ec); ++i) {
    const fs::path to = fs::read_symlink(path, ec);
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  return path;
}

bool haveSameContent(const fs::path& a, const fs::path& b) {
  std::ifstream x(a, std::ios::binary), y(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return x && y && std::equal(Bytes(x), Bytes(), Bytes(y), Bytes());
}

/// Copies into a device, a pipe or another file system, where a rename is impossible.
std::unique_ptr<OutputFile> copyTo(const fs::path& from, const fs::path& to) {
  auto out = std::make_unique<OutputFile>(to);
  std::ifstream in(from, std::ios::binary);
  std::vector<char> block(1 << 16);
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0)
    out->stream().write(block.data(), in.gcount());
  return out;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) : name_(folder), folder_(followed(folder)) {
  std::error_code ec;
  const auto status = fs::status(folder_, ec);
  existed_ = fs::exists(status);
  if (existed_ && !fs::is_directory(status))
    throw UsageError(name_.string() + ": found a file, expected a directory or a name for a new one");
  const std::string own =
      ".part" + std::to_string(::getpid()) + "." + std::to_string(folders_made.fetch_add(1));
  if (existed_) {
    staging_ = folder_ / own;
  } else {
    std::vector<fs::path> missing;
    for (fs::path p = folder_.parent_path(); !p.empty() && !fs::exists(p, ec) && p != p.parent_path();
         p = p.parent_path())
      missing.insert(missing.begin(), p);
    for (const fs::path& p : missing) {
      if (!fs::create_directory(p, ec) && ec) break;
      made_.push_back(p);
    }
    staging_ = folder_;
    staging_ += own;
  }
  if (!ec) fs::create_directory(staging_, ec);
  if (!ec) return;
  std::error_code ignored;
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
  fail(name_, ec);
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (committed_) return;
  for (auto p = made_.rbegin(); p != made_.rend(); ++p) fs::remove(*p, ignored);
}

fs::path OutputFolder::place(const std::string& name) {
  if (!files_.insert(name).second)
    throw UsageError((name_ / name).string() +
                     ": found two outputs of this name, expected names that differ");
  if (existed_) placeOfOutput(folder_ / name);
  return staging_ / name;
}

void OutputFolder::commit() {
  std::error_code ec;
  if (!existed_) {
    // If the folder still does not exist, one rename makes it appear with all its files.
    fs::rename(staging_, folder_, ec);
    committed_ = !ec;
    if (committed_) return;
    ec.clear();
    fs::create_directory(folder_, ec);
    if (ec) fail(name_, ec);
  }
  struct Move {
    fs::path from, to;
    std::unique_ptr<OutputFile> copy;
  };
  std::vector<Move> moves;
  for (const std::string& file : files_) {
    const fs::path from = staging_ / file;
    if (!fs::exists(from, ec)) continue;
    const OutputPlace final = placeOfOutput(folder_ / file);
    if (isInput(final.path)) {
      // A file identical to an input is skipped: a clip repeats its camera file, for example.
      if (haveSameContent(from, final.path)) continue;
      throw UsageError((name_ / file).string() +
                       ": found a file that is also an input, expected a different output");
    }
    moves.push_back({from, final.path, nullptr});
    // A link may lead to another file system, where a rename is impossible.
    if (final.kind != OutputPlace::Kind::kFile || fs::is_symlink(folder_ / file, ec))
      moves.back().copy = copyTo(from, folder_ / file);
  }
  for (const Move& move : moves)
    if (move.copy) move.copy->finish();
  for (const Move& move : moves) {
    if (move.copy) {
      move.copy->commit();
      continue;
    }
    fs::rename(move.from, move.to, ec);
    if (ec) throw WriteError(name_.string(), ec.value());
  }
  committed_ = true;
}

}  // namespace abstand
