#include "app/session/poses_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "app/moment/moment_file.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/text_file.hpp"

namespace abstand::session {
namespace {

constexpr std::array<std::string_view, 12> kSuffixes{"r00", "r01", "r02", "tx",  "r10", "r11",
                                                     "r12", "ty",  "r20", "r21", "r22", "tz"};

struct Field {
  std::string_view text;
  int column;
};

std::vector<Field> split(std::string_view line) {
  std::vector<Field> fields;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
    if (end == line.size()) return fields;
    begin = end + 1;
  }
}

std::vector<std::string> readHeader(std::string_view line, const std::string& name) {
  const auto fields = split(line);
  if (fields[0].text != "t")
    throw ParseError({name, 1, 1},
                     "found '" + std::string(fields[0].text.substr(0, 40)) + "', expected the column 't'");
  if (fields.size() < 13 || (fields.size() - 1) % 12 != 0)
    throw ParseError(
        {name, 1}, "found " + std::to_string(fields.size()) + " columns, expected t and 12 for each object");
  std::vector<std::string> names;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto suffix = kSuffixes[(i - 1) % 12];
    const auto& text = fields[i].text;
    if ((i - 1) % 12 == 0) names.emplace_back(text.substr(0, text.rfind('.')));
    if (text != names.back() + "." + std::string(suffix))
      throw ParseError({name, 1, fields[i].column}, "found '" + std::string(text.substr(0, 60)) +
                                                        "', expected '" + names.back() + "." +
                                                        std::string(suffix) + "'");
  }
  return names;
}

/// Pose values may be nan (lost tracking): the scene rejects them. Other words are errors.
double poseNumber(std::string_view text, const SourcePos& pos) {
  if (const auto v = parseDouble(text)) return *v;
  if (text == "nan" || text == "NaN" || text == "inf" || text == "-inf") return kNaN;
  throw ParseError(pos, "found '" + std::string(text.substr(0, 40)) + "', expected a number");
}

/// Poses of recorded moments of a server; not finite where the server did not know them.
PosesTable posesOfMoments(const std::filesystem::path& file) {
  PosesTable table;
  const auto begin = [&](const moment::SceneCard& card) { table.names = card.objects; };
  const auto take = [&](std::span<const std::byte>, const moment::Moment& m) {
    table.t.push_back(m.shown.t);
    for (const view::ObjectSnapshot& object : m.shown.objects) {
      const bool known =
          object.pose_state == scene::PoseState::kFresh || object.pose_state == scene::PoseState::kInferred;
      table.X_WB.push_back(object.X_WB);
      if (!known) table.X_WB.back().matrix().topRows<3>().setConstant(kNaN);
    }
  };
  moment::readMomentFile(file, begin, take);
  return table;
}

}  // namespace

std::size_t PosesTable::rowAt(double time) const {
  const auto after = std::upper_bound(t.begin(), t.end(), time);
  return after == t.begin() ? 0 : static_cast<std::size_t>(after - t.begin()) - 1;
}

PosesTable loadPoses(const std::filesystem::path& file) {
  if (moment::isMomentFile(file)) return posesOfMoments(file);
  const std::string text = readFile(file);
  const std::string name = file.string();
  PosesTable table;
  int line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line(text.data() + begin, end - begin);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    begin = end + 1;
    ++line_number;
    if (line_number == 1) {
      table.names = readHeader(line, name);
      continue;
    }
    if (line.empty()) continue;
    const auto fields = split(line);
    if (fields.size() != 1 + 12 * table.names.size())
      throw ParseError({name, line_number}, "found " + std::to_string(fields.size()) + " values, expected " +
                                                std::to_string(1 + 12 * table.names.size()));
    const auto time = parseDouble(fields[0].text);
    if (!time || (!table.t.empty() && *time <= table.t.back()))
      throw ParseError({name, line_number, 1}, "found t = '" + std::string(fields[0].text.substr(0, 40)) +
                                                   "', expected a finite time that rises from row to row");
    table.t.push_back(*time);
    for (std::size_t o = 0; o < table.names.size(); ++o) {
      Transform X = Transform::Identity();
      for (std::size_t k = 0; k < 12; ++k) {
        const auto& f = fields[1 + 12 * o + k];
        X.matrix()(static_cast<int>(k / 4), static_cast<int>(k % 4)) =
            poseNumber(f.text, {name, line_number, f.column});
      }
      table.X_WB.push_back(X);
    }
  }
  if (table.t.empty()) throw ParseError({name, line_number}, "found no row, expected at least one pose");
  return table;
}

}  // namespace abstand::session
