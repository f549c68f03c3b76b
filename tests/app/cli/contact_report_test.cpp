// Predicted contacts beside their limits, in the JSON and in the report.
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace contact_report_test {

class ContactReport : public SevenPeople {
 protected:
  // The ball passes within a metre of every part.
  const std::string options_ = " --near 1 --margins 0.1 --clamped forearm_left --recordings" + recordings_;

  static json regionNamed(const json& answer, const std::string& name) {
    for (const json& r : answer["contact_regions"])
      if (r["region"] == name) return r;
    return nullptr;
  }
  /// From the heading to the end of its table.
  static std::string sectionOf(const std::string& html, const std::string& heading) {
    const auto begin = html.find(heading + "</h3>");
    return begin == std::string::npos ? std::string()
                                      : html.substr(begin, html.find("</table>", begin) - begin);
  }
};

TEST_F(ContactReport, EveryValueFollowsFromTheLimitsThatAreStated) {
  const json j = runJson("tune " + scene_ + options_);
  int limited = 0, excluded = 0, clamped = 0;
  for (const json& a : j["approaches"]) {
    const json& c = a["contact"];
    if (c.is_null()) continue;
    const json region = regionNamed(j, c["region"]);
    ASSERT_FALSE(region.is_null()) << c;
    EXPECT_EQ(region["excluded"], c["excluded"]);
    EXPECT_EQ(c["robot_mass"], nullptr) << "the rail has no masses: a wall";
    EXPECT_EQ(c["body_mass"], region["body_mass"]["value"]);
    if (c["excluded"]) {
      ++excluded;
      for (const char* key : {"force_limit", "energy_limit", "pressure_limit"})
        EXPECT_EQ(c[key], nullptr) << key << ": contact with the head is excluded, not limited";
      continue;
    }
    ++limited;
    const bool is_clamped = c["kind"] == "quasi-static";
    clamped += is_clamped;
    const double k = c["spring"], limit = c["force_limit"];
    const double factor = is_clamped ? 1.0 : region["transient_factor"]["value"].get<double>();
    EXPECT_DOUBLE_EQ(limit, factor * region["force"]["value"].get<double>());
    EXPECT_DOUBLE_EQ(c["energy_limit"], limit * limit / (2.0 * k));
    EXPECT_DOUBLE_EQ(c["pressure_limit"], factor * region["pressure"]["value"].get<double>());
    if (is_clamped) {
      EXPECT_EQ(c["reduced_mass"], nullptr) << "a wall against a part that cannot recoil";
      continue;
    }
    const double v = c["closing_speed"], mu = c["reduced_mass"];
    EXPECT_DOUBLE_EQ(mu, c["body_mass"]);
    EXPECT_DOUBLE_EQ(c["force"], v * std::sqrt(mu * k));
    EXPECT_DOUBLE_EQ(c["energy"], 0.5 * mu * v * v);
    EXPECT_DOUBLE_EQ(c["share"], c["force"].get<double>() / limit);
  }
  EXPECT_GT(limited, 0);
  EXPECT_GT(excluded, 0);
  EXPECT_GT(clamped, 0);
  for (const json& region : j["contact_regions"])
    for (const char* key : {"force", "transient_factor", "pressure", "spring", "body_mass"})
      EXPECT_FALSE(region[key]["source"].get<std::string>().empty()) << region["region"] << key;
}

TEST_F(ContactReport, PageShowsValuesBesideLimitsAndTheirSources) {
  EXPECT_EQ(run("tune " + scene_ + options_ + " --out " + out("r") + " --report " + out("page.html")).code,
            0);
  const json j = runJson("merge " + out("r") + " --margins 0.1 --report " + out("merged.html"));
  const std::string html = readFile(out("page.html")), merged = readFile(out("merged.html"));
  for (const std::string heading : {"Predicted contacts", "Contact limits used"}) {
    const std::string section = sectionOf(html, heading);
    EXPECT_NE(section.find(j["contact_limits"].get<std::string>()), std::string::npos) << heading;
    EXPECT_EQ(section, sectionOf(merged, heading)) << "the files keep the limits";
  }
  const std::string limits = sectionOf(html, "Contact limits used");
  EXPECT_NE(limits.find("ISO/TS 15066:2016, A.2"), std::string::npos) << limits;
  // The head's regions are there, without a limit.
  for (const json& region : j["contact_regions"]) {
    const auto row = limits.find("<td>" + region["region"].get<std::string>() + "</td>");
    ASSERT_NE(row, std::string::npos) << region["region"];
    EXPECT_EQ(
        limits.substr(row, limits.find("</tr>", row) - row).find("contact excluded") != std::string::npos,
        region["excluded"].get<bool>())
        << region["region"];
  }
  EXPECT_NE(sectionOf(html, "Predicted contacts").find("energy (J)"), std::string::npos);
}

}  // namespace contact_report_test
}  // namespace abstand::testing
