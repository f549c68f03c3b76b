// abstand export --pairs-csv, --separation-csv and --contact-csv: every pair, and every frame's protective
// distances and contacts.
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "core/base/number.hpp"
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace pair_export_test {

// m: result files have whole steps of 0.01 mm, rounded to the safe side once for each of three numbers.
constexpr double kStep = 1e-5, kRounded = 3.0 * kStep + 1e-9;
constexpr double kSpeedStep = 1.0 / 16.0 + 1e-3;  // m/s, of pairs far apart

// Result files have shares, N, J and N/cm^2 in steps of 1/16384, rounded up.
constexpr double kContactStep = 1.0 / 16384.0 + 1e-9;

// In place of the infinite share of an excluded contact, which JSON does not have.
constexpr double kInfinite = 1e9;

using Rows = std::vector<std::vector<std::string>>;

/// Rows of a file without quotes; the first is the header.
Rows readCsv(const std::string& file) {
  std::ifstream in(file);
  Rows rows;
  for (std::string line; std::getline(in, line);) {
    rows.emplace_back();
    std::string field;
    for (const char c : line)
      if (c == ',')
        rows.back().push_back(std::move(field)), field.clear();
      else
        field += c;
    rows.back().push_back(field);
  }
  return rows;
}

class PairExport : public SevenPeople {};

TEST_F(PairExport, HasRowPerFrameAndPairMatchingPartResults) {
  const json tuned = runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("study"));
  const json j =
      runJson("export " + out("study") + " --pairs-csv " + out("pairs.csv") + " --csv " + out("parts.csv"));
  // One link, so that a pair is a part.
  EXPECT_EQ(j["pair_rows"], tuned["frames"].get<int>() * 14);
  const Rows pairs = readCsv(out("pairs.csv")), parts = readCsv(out("parts.csv"));
  ASSERT_EQ(pairs.size(), parts.size());
  EXPECT_EQ(pairs[0][1], "t_s");
  EXPECT_EQ(pairs[0][7], "clearance_m");
  EXPECT_EQ(pairs[0][10], "closing_speed_m_per_s");
  EXPECT_EQ(pairs[0][17], "tool");
  ASSERT_EQ(pairs[0].size(), 18u);
  int near = 0, far = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const auto &pair = pairs[i], &part = parts[i];
    ASSERT_EQ(pair.size(), pairs[0].size()) << i;
    for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(pair[c], part[c]) << i;
    const auto number = [](const std::string& text) { return std::stod(text); };
    const double distance = number(pair[4]), clearance = number(pair[7]);
    EXPECT_NEAR(distance, number(part[4]), kStep + 1e-9) << i;
    EXPECT_NEAR(clearance, distance - number(pair[5]) - number(pair[6]), 1e-9) << i;
    EXPECT_LE(clearance, number(part[7]) + 1e-9) << "rounded to the safe side, " << i;
    EXPECT_GE(clearance, number(part[7]) - kRounded) << i;
    const double closing = number(pair[10]);
    EXPECT_EQ(closing, number(pair[8]) + number(pair[9]));
    EXPECT_GE(number(pair[8]), number(part[8]) - 1.0 / 16384.0) << i;
    EXPECT_LE(number(pair[8]), std::max(0.0, number(part[8])) + kSpeedStep) << i;
    ++(distance < 0.5 ? near : far);
    EXPECT_EQ(pair[11].empty(), !(distance < 0.5)) << i;
    EXPECT_EQ(pair[17], "") << "nobody holds a tool";
    if (pair[11].empty()) continue;
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k) squared += std::pow(number(pair[14 + k]) - number(pair[11 + k]), 2);
    // Points have whole millimetres.
    EXPECT_NEAR(std::sqrt(squared), std::abs(distance), 2e-3) << i;
  }
  EXPECT_GT(near, 0);
  EXPECT_GT(far, 0);
}

TEST_F(PairExport, HasPredictedContactPerFrameAndPart) {
  const json tuned = runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("contacts"));
  const json j = runJson("export " + out("contacts") + " --contact-csv " + out("contacts.csv"));
  EXPECT_EQ(j["contact_rows"], tuned["frames"].get<int>() * 14);
  const Rows rows = readCsv(out("contacts.csv"));
  ASSERT_EQ(rows.size(), tuned["frames"].get<std::size_t>() * 14 + 1);
  ASSERT_EQ(rows[0].size(), 9u);
  std::map<std::string, std::size_t> row_of;  // "recording t part"
  std::size_t predicted = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size()) << i;
    row_of[rows[i][0] + " " + rows[i][1] + " " + rows[i][2]] = i;
    if (rows[i][8].empty()) continue;
    ++predicted;
    // Excluded, not seen, or an area that is not certain.
    EXPECT_EQ(rows[i][8] == "inf", rows[i][2] == "head" || rows[i][4].empty() || rows[i][7] == "inf") << i;
  }
  EXPECT_GT(predicted, 20u);
  // The JSON has the time beyond the limits, and the hardest contact, of each part.
  std::map<std::string, double> beyond, hardest;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][8].empty()) continue;
    const std::string& part = rows[i][2];
    hardest[part] = std::max(hardest[part], std::stod(rows[i][8]));
    // The rows of the next frame are the 14 after the next; the last frame lasts no time.
    const bool last = i + 14 >= rows.size() || rows[i + 14][0] != rows[i][0];
    if (std::stod(rows[i][8]) > 1.0 && !last)
      beyond[part] += std::stod(rows[i + 14][1]) - std::stod(rows[i][1]);
  }
  for (const json& row : tuned["contacts"]) {
    const std::string part = row["part"];
    EXPECT_NEAR(row["exceeded_time"].get<double>(), beyond[part], 1e-9) << part;
    ASSERT_EQ(row["worst"].is_null(), !hardest.count(part)) << part;
    if (row["worst"].is_null()) continue;
    const json& share = row["worst"]["share"];
    EXPECT_NEAR(share.is_null() ? kInfinite : share.get<double>(), std::min(hardest[part], kInfinite),
                kContactStep)
        << part;
  }
  // Approaches judge the contact of the nearest pair; the frame has the worst of all near pairs.
  std::size_t compared = 0;
  for (const json& approach : tuned["approaches"]) {
    const json& contact = approach["contact"];
    if (contact.is_null() || contact["excluded"].get<bool>() || contact["pressure"].is_null()) continue;
    const auto row =
        row_of.find(approach["recording"].get<std::string>() + " " +
                    formatDouble(contact["t"].get<double>()) + " " + approach["part"].get<std::string>());
    ASSERT_NE(row, row_of.end()) << approach;
    const auto& fields = rows[row->second];
    const double share = std::max(contact["share"].get<double>(), contact["pressure_share"].get<double>());
    EXPECT_GE(std::stod(fields[8]), share - kContactStep) << approach;
    if (std::stod(fields[8]) > share + kContactStep) continue;
    EXPECT_EQ(fields[4], contact["region"]);
    EXPECT_NEAR(std::stod(fields[5]), contact["force"].get<double>(), kContactStep);
    EXPECT_NEAR(std::stod(fields[6]), contact["energy"].get<double>(), kContactStep);
    EXPECT_NEAR(std::stod(fields[7]), contact["pressure"].get<double>() / 1e4, kContactStep);
    ++compared;
  }
  EXPECT_GT(compared, 3u);
}

TEST_F(PairExport, HasTermsOfProtectiveDistancePerFrameAndPart) {
  const json tuned = runJson("tune " + scene_ + " --recordings" + recordings_ + " --out " + out("terms") +
                             " --separation intrusion=0.3 stopping_time=0.4 reaction_time=0.2");
  const json j = runJson("export " + out("terms") + " --separation-csv " + out("terms.csv"));
  EXPECT_EQ(j["separation_rows"], tuned["frames"].get<int>() * 14);
  const Rows rows = readCsv(out("terms.csv"));
  ASSERT_EQ(rows.size(), tuned["frames"].get<std::size_t>() * 14 + 1);
  ASSERT_EQ(rows[0].size(), 15u);
  std::map<std::string, double> largest_excess;  // m, of each part
  std::map<std::string, int> broken;             // frames of each part
  int empty = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), rows[0].size()) << i;
    if (rows[i][3].empty()) {
      ++empty;
      for (std::size_t c = 4; c < rows[i].size(); ++c) EXPECT_EQ(rows[i][c], "");
      continue;
    }
    const auto number = [&](std::size_t column) { return std::stod(rows[i][column]); };
    const double clearance = number(4), robot = number(5), person = number(7), reaction = number(8),
                 stopping = number(9), constant = number(10), needed = number(11), excess = number(12);
    EXPECT_GT(robot, 0.0);
    // The ball moves with 0.5 m/s; T_r = 0.2 s, T_s = 0.4 s, C = 0.3 m.
    EXPECT_LE(robot, 0.5 + kSpeedStep);
    EXPECT_NEAR(person, (clearance < 0.5 ? 2.0 : 1.6) * 0.6, 1e-12);
    EXPECT_NEAR(reaction, robot * 0.2, 1e-12);
    EXPECT_NEAR(stopping, robot * 0.4 / 2.0, 1e-12);
    EXPECT_EQ(constant, 0.3);
    EXPECT_NEAR(needed, person + reaction + stopping + constant, 1e-12);
    EXPECT_NEAR(excess, needed - clearance, 1e-12);
    EXPECT_LE(number(13), robot);
    EXPECT_EQ(rows[i][14], "person") << "0.96 m or more";
    auto& most = largest_excess.try_emplace(rows[i][2], excess).first->second;
    most = std::max(most, excess);
    broken[rows[i][2]] += excess > 0.0;
  }
  EXPECT_GT(empty, 0) << "the ball stands at the end";
  for (const json& part : tuned["separation"]) {
    const std::string name = part["part"];
    ASSERT_FALSE(part["worst"].is_null()) << name;
    const double worst = part["worst"]["needed"].get<double>() - part["worst"]["clearance"].get<double>();
    EXPECT_GE(largest_excess.at(name), worst - 1e-9) << "rounded to the safe side: " << name;
    EXPECT_LE(largest_excess.at(name), worst + kRounded + 0.4 * kSpeedStep) << name;
    EXPECT_GT(broken.at(name), 0) << name;
  }
}

TEST_F(PairExport, RequiresOutputFile) {
  const Answer a = run("export " + out("study"));
  EXPECT_EQ(a.code, 2);
  EXPECT_NE(a.err.find("--pairs-csv"), std::string::npos) << a.err;
}

}  // namespace pair_export_test
}  // namespace abstand::testing
