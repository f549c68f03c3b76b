#include "core/base/error.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "core/base/message_line.hpp"

namespace abstand {
namespace {

std::string text(const SourcePos& pos, const std::string& message, const std::string& hint) {
  std::string s = messageLine(pos.file);
  if (pos.line > 0) s += ":" + std::to_string(pos.line);
  if (pos.line > 0 && pos.column > 0) s += ":" + std::to_string(pos.column);
  s += ": error: " + messageLine(message);
  if (!hint.empty()) s += "\nhint: " + messageLine(hint);
  return s;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t up = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = up;
    }
  }
  return row[b.size()];
}

}  // namespace

ParseError::ParseError(const SourcePos& pos, const std::string& message, const std::string& hint)
    : std::runtime_error(text(pos, message, hint)), pos_(pos), message_(messageLine(message)) {}

std::string nearestName(const std::string& name, const std::vector<std::string>& known) {
  std::string best;
  std::size_t best_distance = 4;
  for (const auto& candidate : known) {
    if (candidate.size() > name.size() + 4 || name.size() > candidate.size() + 4) continue;
    const auto d = editDistance(name, candidate);
    if (d < best_distance && d < std::max<std::size_t>(candidate.size(), 2)) {
      best_distance = d;
      best = candidate;
    }
  }
  return best;
}

void checkFailed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "internal error: %s:%d: %s does not hold\n", file, line, condition);
  std::abort();
}

}  // namespace abstand
