// FOLDER/index.sqlite, read by SQLite itself.
#include <sqlite3.h>

#include <fstream>

#include "app/tune/margin_table.hpp"
#include "app/tune/result_file.hpp"
#include "tests/app/program.hpp"
#include "tests/app/tune/slide_scene.hpp"

namespace abstand::results {
namespace index_test {

namespace fs = std::filesystem;
using testing::Answer;
using testing::json;
using Rows = std::vector<std::vector<std::string>>;

/// All rows that a query gives of a database file, as text.
Rows query(const std::string& file, const std::string& sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open_v2(file.c_str(), &database, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr), SQLITE_OK)
      << sql << ": " << sqlite3_errmsg(database);
  Rows rows;
  while (statement && sqlite3_step(statement) == SQLITE_ROW) {
    rows.emplace_back();
    for (int i = 0; i < sqlite3_column_count(statement); ++i) {
      const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, i));
      // Its shortest text would hide the last digits of a number.
      rows.back().push_back(sqlite3_column_type(statement, i) == SQLITE_FLOAT
                                ? formatDouble(sqlite3_column_double(statement, i))
                                : (text ? text : "NULL"));
    }
  }
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return rows;
}

class ResultIndexTest : public testing::Cli {
 protected:
  static constexpr int kPeople = 5;
  ResultIndexTest() {
    ::setenv("ABSTAND_CACHE", (folder_.path() / "cache").c_str(), 1);
    for (int i = 0; i < kPeople; ++i) {
      testing::writeSlide(
          folder_, {.robot = 0.5, .person = 0.1 * i, .stops_at = kInfinity, .rate = 50.0, .seconds = 2.0},
          std::to_string(i));
      recordings_ += " " + file("person" + std::to_string(i) + ".csv");
    }
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string index(const std::string& folder) const { return file(folder) + "/index.sqlite"; }
  std::string tuneCommand(const std::string& folder, const std::string& more) const {
    return "tune " + file("slide.yaml") + " --recordings" + recordings_ + " --out " + file(folder) + " " +
           more;
  }
  void tune(const std::string& folder, const std::string& more = "") {
    const Answer a = run(tuneCommand(folder, more));
    ASSERT_EQ(a.code, 0) << a.err;
  }
  /// All that follows from the results, without the times of the files.
  Rows content(const std::string& folder) const {
    Rows all;
    for (const char* table :
         {"runs ORDER BY 1", "parts ORDER BY 1, 2", "margins ORDER BY 1, 2, 3", "unreadable ORDER BY 1"})
      for (auto& row : query(index(folder), std::string("SELECT * FROM ") + table))
        all.push_back(std::move(row));
    return all;
  }
  json results(const std::string& folder, int code = 0) {
    const Answer a = run("results " + file(folder) + " --json");
    EXPECT_EQ(a.code, code) << a.err;
    return json::parse(a.out, nullptr, false);
  }
  fs::path anyResult(const std::string& folder) const {
    fs::path last;
    for (const auto& entry : fs::directory_iterator(file(folder) + "/results"))
      last = std::max(last, entry.path());
    return last;
  }

  std::string recordings_;
};

TEST_F(ResultIndexTest, ContentIsIndependentOfShardsAndProcesses) {
  tune("whole");
  const Rows expected = content("whole");
  EXPECT_EQ(query(index("whole"), "SELECT * FROM runs").size(), kPeople);
  EXPECT_EQ(query(index("whole"), "SELECT * FROM parts").size(), kPeople * 14u);
  EXPECT_EQ(query(index("whole"), "SELECT * FROM margins").size(), kPeople * 15u * 11u);
  for (const int shards : {2, 3}) {
    const std::string folder = "shards" + std::to_string(shards);
    for (int i = shards; i >= 1; --i)
      tune(folder, "--jobs 2 --shard " + std::to_string(i) + "/" + std::to_string(shards));
    EXPECT_EQ(content(folder), expected) << shards;
  }
}

TEST_F(ResultIndexTest, HoldsResultsOfConcurrentProcesses) {
  std::string all;
  for (int i = 1; i <= kPeople; ++i)
    all += "'" ABSTAND_PROGRAM "' " +
           tuneCommand("at_once", "--quiet --shard " + std::to_string(i) + "/" + std::to_string(kPeople)) +
           " & ";
  ASSERT_EQ(std::system((all + "wait").c_str()), 0);
  tune("whole");
  EXPECT_EQ(content("at_once"), content("whole")) << "the last one to write looked again";
  EXPECT_EQ(results("at_once")["rebuilt"], false);
}

TEST_F(ResultIndexTest, MatchesResultFiles) {
  tune("results");
  for (const auto& entry : fs::directory_iterator(file("results") + "/results")) {
    const tune::StoredResult stored = tune::readResult(entry.path());
    const std::string of_run = " FROM runs WHERE key = '" + stored.key + "'";
    const Rows run = query(index("results"),
                           "SELECT recording, frames, t0, t1, seconds, min_clearance, proposed" + of_run);
    ASSERT_EQ(run.size(), 1u);
    double least = kInfinity, largest = 0.0;
    for (const tune::PartClearance& p : stored.tuned.pass.parts) {
      const double part_least =
          std::min(*std::min_element(p.track.clearance.begin(), p.track.clearance.end()),
                   *std::min_element(p.track.between.begin(), p.track.between.end()));
      const margin::SafeMargin safe = margin::smallestSafeMargin(p.track, stored.options.margins());
      const Rows part =
          query(index("results"), "SELECT min_clearance, proposed, frames_not_seen FROM parts WHERE key = '" +
                                      stored.key + "' AND part = '" + p.part + "'");
      ASSERT_EQ(part.size(), 1u);
      EXPECT_EQ(part[0][0], formatDouble(part_least)) << p.part;
      // Rounded up to whole millimetres.
      const double proposed = std::stod(part[0][1]);
      EXPECT_GE(proposed, safe.margin) << p.part;
      EXPECT_LT(proposed, safe.margin + 1.001e-3) << p.part;
      EXPECT_EQ(part[0][2], "0");
      const Rows stops =
          query(index("results"), "SELECT stops, missed_stops, stopped_time FROM margins WHERE key = '" +
                                      stored.key + "' AND part = '" + p.part + "' AND margin = 0.1");
      const margin::MarginOutcome outcome = margin::outcome(p.track, 0.1, stored.options.margins());
      ASSERT_EQ(stops.size(), 1u);
      EXPECT_EQ(stops[0],
                (std::vector<std::string>{std::to_string(outcome.stops), std::to_string(outcome.missed_stops),
                                          formatDouble(outcome.stopped_time)}));
      least = std::min(least, part_least);
      largest = std::max(largest, proposed);
    }
    const tune::TunedRecording& r = stored.tuned;
    EXPECT_EQ(run[0], (std::vector<std::string>{r.recording, std::to_string(r.frames), formatDouble(r.t0),
                                                formatDouble(r.t1), formatDouble(r.seconds()),
                                                formatDouble(least), formatDouble(largest)}));
  }
}

TEST_F(ResultIndexTest, ListsNearestFirst) {
  tune("results");
  const json j = results("results");
  EXPECT_EQ(j["rebuilt"], false) << "tune keeps it up to date";
  ASSERT_EQ(j["runs"].size(), kPeople);
  for (int i = 0; i + 1 < kPeople; ++i)
    EXPECT_LE(j["runs"][i]["min_clearance"], j["runs"][i + 1]["min_clearance"]);
  EXPECT_NE(j["runs"][0]["recording"].get<std::string>().find("person4.csv"), std::string::npos)
      << "the fastest person comes nearest";
  EXPECT_EQ(j["runs"][0]["link"], "ball");
}

TEST_F(ResultIndexTest, IsRebuiltIfDamagedOrForeign) {
  tune("results");
  const Rows expected = content("results");
  const std::string good = readFile(index("results"));
  const auto check = [&](const std::string& what) {
    EXPECT_EQ(results("results")["rebuilt"], true) << what;
    EXPECT_EQ(content("results"), expected) << what;
    EXPECT_EQ(results("results")["rebuilt"], false) << what;
  };
  fs::remove(index("results"));
  check("no index");
  // A value that is changed within a sound database: the recording's name appears in no other place.
  std::string changed = good;
  for (auto at = changed.find("person3.csv"); at != std::string::npos; at = changed.find("person3.csv", at))
    changed.replace(at, 7, "persons");
  ASSERT_NE(changed, good);
  write("results/index.sqlite", changed);
  check("a changed name");
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{100}, good.size() / 2, good.size() - 1}) {
    write("results/index.sqlite", good.substr(0, size));
    check("cut to " + std::to_string(size));
  }
  for (int i = 0; i < 8; ++i) {
    // Not every byte of a database holds anything.
    changed = good;
    for (std::size_t at = static_cast<std::size_t>(i) * 97; at < changed.size(); at += 701)
      changed[at] ^= 0x10;
    write("results/index.sqlite", changed);
    check("bytes changed from " + std::to_string(97 * i));
  }
  tune("other", "--reaction-time 0.3");
  fs::copy_file(index("other"), index("results"), fs::copy_options::overwrite_existing);
  check("that of another folder");
  EXPECT_EQ(run("merge " + file("results")).code, 0);
}

TEST_F(ResultIndexTest, TracksResultFileChanges) {
  tune("results", "--shard 1/2");
  EXPECT_EQ(results("results")["runs"].size(), 3u);
  tune("results");
  EXPECT_EQ(results("results")["runs"].size(), kPeople);
  fs::remove(anyResult("results"));
  const json fewer = results("results");
  EXPECT_EQ(fewer["rebuilt"], true);
  EXPECT_EQ(fewer["runs"].size(), kPeople - 1);
  // Of the same size at another time.
  const fs::path again = anyResult("results");
  fs::last_write_time(again, fs::last_write_time(again) + std::chrono::seconds(1));
  EXPECT_EQ(run("merge " + file("results")).code, 0);
  EXPECT_EQ(results("results")["rebuilt"], false) << "merge brought it up to date";
}

TEST_F(ResultIndexTest, ReportsUnreadableResult) {
  tune("results");
  const fs::path damaged = anyResult("results");
  fs::resize_file(damaged, fs::file_size(damaged) / 2);
  for (int i = 0; i < 2; ++i) {
    const json j = results("results", 5);
    EXPECT_EQ(j["runs"].size(), kPeople - 1);
    ASSERT_EQ(j["unreadable"].size(), 1u);
    EXPECT_EQ(j["unreadable"][0]["file"], damaged.filename().string());
    EXPECT_NE(j["unreadable"][0]["error"].get<std::string>().find("checksum"), std::string::npos);
    EXPECT_EQ(j["rebuilt"], i == 0);
  }
}

TEST_F(ResultIndexTest, IsOptional) {
  tune("results");
  fs::remove(index("results"));
  fs::create_directory(index("results"));
  const Answer a = run("results " + file("results"));
  EXPECT_EQ(a.code, 0);
  EXPECT_NE(a.err.find("warning: the index could not be written"), std::string::npos) << a.err;
  EXPECT_EQ(std::count(a.out.begin(), a.out.end(), '\n'), kPeople + 1);
  EXPECT_EQ(run("merge " + file("results")).code, 0);
  EXPECT_EQ(run("results " + file("nothing")).code, 2);
}

TEST_F(ResultIndexTest, AnswersQueriesInDocs) {
  tune("results");
  std::ifstream in(testing::projectFile("docs/margins.md"));
  std::string line, sql;
  int queries = 0;
  for (bool inside = false; std::getline(in, line);) {
    if (line == "```sql") {
      inside = true;
    } else if (line == "```" && inside) {
      inside = false;
      EXPECT_FALSE(query(index("results"), sql).empty()) << sql;
      sql.clear();
      ++queries;
    } else if (inside) {
      sql += line + "\n";
    }
  }
  EXPECT_GE(queries, 2);
}

}  // namespace index_test
}  // namespace abstand::results
