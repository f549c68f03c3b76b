#include "core/base/output_place.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <system_error>

#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand {
namespace fs = std::filesystem;
namespace {

constexpr int kMaxLinks = 40;

std::string reason(int error) { return std::generic_category().message(error); }

/// N of /dev/fd/N and /proc/self/fd/N, also if the folder is reached through links.
std::optional<int> descriptorOf(const fs::path& path) {
  std::error_code ec;
  const fs::path folder = fs::canonical(path.parent_path(), ec);
  if (ec || folder != "/proc/" + std::to_string(::getpid()) + "/fd") return std::nullopt;
  const auto number = parseInt(path.filename().string());
  return number ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
}

bool isSame(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

}  // namespace

OutputPlace placeOfOutput(const fs::path& name) {
  const auto fail = [&](const std::string& why) -> void { throw UsageError(name.string() + ": " + why); };
  OutputPlace place;
  std::error_code ec;
  fs::path path = fs::absolute(name, ec);
  for (int links = 0;; ++links) {
    if (links > kMaxLinks) fail("cannot be written: " + reason(ELOOP));
    if (const auto descriptor = descriptorOf(path)) {
      place.kind = OutputPlace::Kind::kDescriptor;
      place.path = path;
      place.descriptor = *descriptor;
      place.exists = true;
      return place;
    }
    const auto status = fs::symlink_status(path, ec);
    if (!fs::is_symlink(status)) break;
    const fs::path to = fs::read_symlink(path, ec);
    if (ec) fail("cannot be written: " + ec.message());
    path = to.is_absolute() ? to : path.parent_path() / to;
  }
  place.path = path;
  const auto status = fs::status(path, ec);
  if (fs::is_directory(status)) fail("found a directory, expected a file to write");
  place.exists = fs::exists(status);
  if (!place.exists) {
    if (path.filename().empty()) fail("found no file name, expected a file to write");
    if (!fs::is_directory(path.parent_path(), ec))
      fail("cannot be written: there is no directory " + path.parent_path().string());
    return place;
  }
  if (!fs::is_regular_file(status)) place.kind = OutputPlace::Kind::kSpecial;
  return place;
}

bool isSameOutput(const fs::path& a, const fs::path& b) {
  const OutputPlace x = placeOfOutput(a), y = placeOfOutput(b);
  const auto statOf = [](const OutputPlace& p, struct stat& s) {
    return p.kind == OutputPlace::Kind::kDescriptor ? ::fstat(p.descriptor, &s) == 0
                                                    : ::stat(p.path.c_str(), &s) == 0;
  };
  struct stat sx {
  }, sy{};
  const bool has_x = statOf(x, sx), has_y = statOf(y, sy);
  if (has_x && has_y)
    return isSame(sx, sy) && !(S_ISCHR(sx.st_mode) && x.kind == OutputPlace::Kind::kSpecial &&
                               y.kind == OutputPlace::Kind::kSpecial);
  if (has_x || has_y) return false;
  std::error_code ec;
  return x.path.filename() == y.path.filename() &&
         fs::equivalent(x.path.parent_path(), y.path.parent_path(), ec);
}

bool isStandardOutput(const OutputPlace& place) {
  if (place.kind == OutputPlace::Kind::kDescriptor && place.descriptor == STDOUT_FILENO) return true;
  struct stat out {
  }, own{};
  if (::fstat(STDOUT_FILENO, &out) != 0) return false;
  const bool known = place.kind == OutputPlace::Kind::kDescriptor ? ::fstat(place.descriptor, &own) == 0
                                                                  : ::stat(place.path.c_str(), &own) == 0;
  // Several outputs may share a character device: a terminal, /dev/null.
  return known && isSame(out, own) && !S_ISCHR(out.st_mode);
}

}  // namespace abstand
