// abstand tune --separation-table: terms of the protective distance from a table of one's own.
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace separation_table_test {

using SeparationTable = SevenPeople;

// A table of one's own changes S_p, and its numbers and sources stand in JSON, report and stored results.
TEST_F(SeparationTable, GivesTermsOfTheProtectiveDistance) {
  std::string text = readFile(testing::projectFile("data/standards/iso_13855_2010.yaml"));
  const auto replace = [&](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("edition: ISO 13855:2010\n", "edition: ISO 13855:2099\n");
  replace("person_speed: {m_per_s: 1.6, source: walking}", "person_speed: {m_per_s: 3.2, source: walking}");
  replace("person_speed_near: {m_per_s: 2.0", "person_speed_near: {m_per_s: 4.0");
  write("own.yaml", text);
  const std::string tune = "tune " + scene_ + " --recordings" + recordings_;
  const json usual = runJson(tune);
  const json own = runJson(tune + " --separation-table " + out("own.yaml") + " --out " + out("own") +
                           " --report " + out("own.html"));
  EXPECT_EQ(own["standards"]["person_speed"], "ISO 13855:2099");
  EXPECT_NE(own["separation_table"], usual["separation_table"]);
  EXPECT_NE(own["separation_table"].get<std::string>().find("own.yaml"), std::string::npos);
  // S_h = v_h (T_r + T_s) is twice that of the shipped table where both have the same worst moment.
  bool compared = false;
  for (std::size_t i = 0; i < own["separation"].size(); ++i) {
    const json &a = usual["separation"][i]["worst"], &b = own["separation"][i]["worst"];
    if (a.is_null() || b.is_null() || a["t"] != b["t"] || a["link"] != b["link"]) continue;
    EXPECT_NEAR(b["person"].get<double>(), 2.0 * a["person"].get<double>(), 1e-12);
    compared = true;
  }
  EXPECT_TRUE(compared);
  const json& term = own["separation_terms"][0];
  EXPECT_EQ(term["term"], "person_speed");
  EXPECT_EQ(term["value"], 3.2);
  EXPECT_EQ(term["used"], 3.2);
  EXPECT_NE(term["source"].get<std::string>().find("1,600 mm/s"), std::string::npos);
  EXPECT_NE(readFile(out("own.html")).find("ISO 13855:2099"), std::string::npos);
  // What the user states wins, and the table's number stands beside it.
  const json stated =
      runJson(tune + " --separation-table " + out("own.yaml") + " --separation person_speed=1");
  EXPECT_EQ(stated["separation_terms"][0]["value"], 3.2);
  EXPECT_EQ(stated["separation_terms"][0]["used"], 1.0);
  // Stored results keep the table; results of two tables are not merged.
  const json merged = runJson("merge " + out("own"));
  EXPECT_EQ(merged["separation_terms"], own["separation_terms"]);
  EXPECT_EQ(merged["standards"], own["standards"]);
  runJson(tune + " --out " + out("usual"));
  EXPECT_EQ(run("merge " + out("own") + " " + out("usual")).code, 3);
  const auto wrong = run(tune + " --separation-table " + scene_);
  EXPECT_EQ(wrong.code, 3);
}

}  // namespace separation_table_test
}  // namespace abstand::testing
