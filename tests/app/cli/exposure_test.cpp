// abstand exposure as a user runs it.
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace exposure_test {

using Exposure = SevenPeople;

TEST_F(Exposure, ReportsTimeNearPerPartAndLink) {
  for (const int i : {1, 2})
    EXPECT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + " --out " +
                  out("half" + std::to_string(i)) + " --shard " + std::to_string(i) + "/2")
                  .code,
              0);
  const std::string both = out("half1") + " " + out("half2");
  const json all = runJson("exposure " + both + " --segment 0.5 --html " + out("page.html") + " --csv " +
                           out("table.csv") + " --room " + out("room.ply") + " --body " + out("body.ply"));
  EXPECT_EQ(all["recordings"], kPeople);
  EXPECT_EQ(all["bands"], (std::vector<double>{0.0, 0.05, 0.1, 0.2, 0.5}));
  // Parts of both halves add up, and stretches to the whole.
  const json one = runJson("exposure " + out("half1")), two = runJson("exposure " + out("half2"));
  constexpr double kSums = 1e-9;
  ASSERT_EQ(all["parts"].size(), one["parts"].size());
  for (std::size_t p = 0; p < all["parts"].size(); ++p)
    EXPECT_NEAR(all["parts"][p]["weighted"],
                one["parts"][p]["weighted"].get<double>() + two["parts"][p]["weighted"].get<double>(), kSums);
  double weighted = 0.0, cells = 0.0, parts = 0.0;
  for (const json& row : all["phases"]) weighted += row["weighted"].get<double>();
  for (const json& cell : all["body"]) cells += cell["weighted"].get<double>();
  for (const json& row : all["parts"]) parts += row["weighted"].get<double>();
  EXPECT_GT(weighted, 0.1);
  EXPECT_NEAR(weighted, all["whole_body"]["weighted"], kSums);
  EXPECT_NEAR(cells, parts, kSums);
  EXPECT_EQ(all["phases"].size(), 5u) << "2.5 s";
  EXPECT_NEAR(all["whole_body"]["time"], 2.5 * kPeople, kSums);
  EXPECT_EQ(all["whole_body"]["near_misses"], all["approaches"].size());
  const std::string page = readFile(out("page.html"));
  for (const char* there :
       {"<h2>Exposure</h2>", "exposure on the body", "exposure on the floor", "left side"})
    EXPECT_NE(page.find(there), std::string::npos) << there;
  const std::string csv = readFile(out("table.csv"));
  EXPECT_EQ(csv.substr(0, 20), "of,part,link,t0,t1,t");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            2 + all["parts"].size() + all["links"].size() + all["pairs"].size() + all["phases"].size());
  for (const char* mesh : {"room.ply", "body.ply"})
    EXPECT_EQ(readFile(out(mesh), 1 << 28, true).substr(0, 4), "ply\n");
  EXPECT_EQ(run("merge " + both + " --report " + out("margins.html")).code, 0);
  EXPECT_NE(readFile(out("margins.html")).find("<h2>Exposure</h2>"), std::string::npos);
  EXPECT_EQ(run("exposure " + out("nothing")).code, 2);
  EXPECT_EQ(run("exposure " + both + " --segment 0").code, 2);
}

}  // namespace exposure_test
}  // namespace abstand::testing
