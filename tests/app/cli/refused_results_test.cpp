// What is refused with one line: results of two versions, and tables of limits that contradict themselves.
#include <algorithm>
#include <fstream>

#include "app/hdf5/file_seal.hpp"
#include "app/tune/result_key.hpp"
#include "core/contact/contact_limits_reader.hpp"
#include "tests/app/cli/seven_people.hpp"

namespace abstand::testing {
namespace refused_results_test {

class RefusedResults : public SevenPeople {
 protected:
  std::filesystem::path onlyResult(const std::string& folder) const {
    std::filesystem::path file;
    for (const auto& entry : std::filesystem::directory_iterator(out(folder) + "/results"))
      if (entry.path().extension() == ".h5") file = entry.path();
    return file;
  }
  static void expectOneLine(const Answer& a, const std::string& place, const std::string& said) {
    EXPECT_EQ(a.code, 3) << a.err;
    EXPECT_EQ(std::count(a.err.begin(), a.err.end(), '\n'), 1) << a.err;
    EXPECT_NE(a.err.find(place), std::string::npos) << a.err;
    EXPECT_NE(a.err.find(said), std::string::npos) << a.err;
    EXPECT_EQ(a.out, "");
  }
};

TEST_F(RefusedResults, OfTwoVersionsAreNotMerged) {
  for (const std::string shard : {"1", "2"})
    ASSERT_EQ(run("tune " + scene_ + " --recordings" + recordings_ + " --out " + out(shard) + " --shard " +
                  shard + "/7")
                  .code,
              0);
  EXPECT_EQ(run("merge " + out("1") + " " + out("2")).code, 0);
  // As another program would have written it: the number of its version, and the checksum of that file.
  const std::filesystem::path file = onlyResult("2");
  std::string bytes = readFile(file);
  const std::string version = tune::resultVersion();
  std::string other = version;
  other.back() = other.back() == '0' ? '1' : '0';
  const auto at = bytes.find(version);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, version.size(), other);
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_EQ(run("merge " + out("2")).code, 3) << "the checksum is still that of the old bytes";
  hdf5::seal(file);
  EXPECT_EQ(run("merge " + out("2")).code, 0) << "alone it is a result";
  for (const std::string& command :
       std::vector<std::string>{"merge ", "events --margin 0.1 ", "report --html " + out("page.html") + " "})
    // Files are read in the order of their names; the second one is named.
    expectOneLine(run(command + out("1") + " " + out("2")), ".h5: error: ", "of another version than ");
  EXPECT_FALSE(std::filesystem::exists(out("page.html"))) << "nothing half-written";
}

TEST_F(RefusedResults, TableWhoseEnergyDoesNotFitItsForce) {
  std::string table = readFile(contact::defaultContactLimits());
  const std::string chest = "energy: {j: 1.568";
  const auto at = table.find(chest);
  ASSERT_NE(at, std::string::npos);
  const auto line =
      std::to_string(1 + std::count(table.begin(), table.begin() + static_cast<long>(at), '\n'));
  write("limits.yaml", table);
  EXPECT_EQ(run("tune " + scene_ + " --contact-limits " + out("limits.yaml")).code, 0);
  table.replace(at, chest.size(), "energy: {j: 15.68");
  write("limits.yaml", table);
  expectOneLine(run("tune " + scene_ + " --contact-limits " + out("limits.yaml") + " --out " + out("none")),
                "limits.yaml:" + line + ":", "found an energy of 15.68 J in region `chest`");
  EXPECT_EQ(results("none"), 0u);
}

}  // namespace refused_results_test
}  // namespace abstand::testing
