#include "app/results/index_tables.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <optional>

#include "app/tune/margin_table.hpp"
#include "app/tune/part_frames.hpp"
#include "app/tune/result_file.hpp"
#include "app/tune/result_key.hpp"
#include "core/base/error.hpp"

namespace abstand::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTables = R"(
CREATE TABLE meta(name TEXT PRIMARY KEY, value);
CREATE TABLE files(name TEXT PRIMARY KEY, bytes INTEGER, modified INTEGER);
CREATE TABLE unreadable(file TEXT PRIMARY KEY, error TEXT);
CREATE TABLE runs(key TEXT PRIMARY KEY, file TEXT, recording TEXT, content TEXT, version TEXT, frames INTEGER, t0 REAL, t1 REAL,
  seconds REAL, not_judged REAL, clearance_limit REAL, reaction_time REAL, deceleration REAL, reservations INTEGER,
  min_clearance REAL, part TEXT, link TEXT, t REAL, proposed REAL, proposed_part TEXT);
CREATE TABLE parts(key TEXT, part TEXT, min_clearance REAL, link TEXT, t REAL, frames_not_seen INTEGER, proposed REAL,
  decided_at REAL, PRIMARY KEY(key, part));
CREATE TABLE margins(key TEXT, part TEXT, margin REAL, stops INTEGER, false_stops INTEGER, missed_stops INTEGER, unseen INTEGER,
  stopped_time REAL, time REAL, min_clearance REAL, lead_time REAL, PRIMARY KEY(key, part, margin));
)";
/// Tables covered by the digest, with their keys.
constexpr const char* kDigested[][2] = {{"files", "name"},
                                        {"unreadable", "file"},
                                        {"runs", "key"},
                                        {"parts", "key, part"},
                                        {"margins", "key, part, margin"}};

/// m: margins whose stops the index lists; those of `--margins` of tune without an argument.
std::vector<double> indexMargins() {
  std::vector<double> margins;
  for (int i = 0; i <= 10; ++i) margins.push_back(i * 0.05);
  return margins;
}

/// Closest approach of a part, at a frame or after it.
struct Nearest {
  double clearance{kInfinity};
  std::size_t part{0};
  std::optional<std::size_t> link;  ///< none: there are no frames
  double t{kNaN};                   ///< s
  std::int64_t not_seen{0};         ///< frames
};

Nearest nearestOf(const tune::PartClearance& p, std::size_t part) {
  Nearest nearest;
  nearest.part = part;
  for (std::size_t i = 0; i < p.track.frames(); ++i) {
    const double least = std::min(p.track.clearance[i], p.track.between[i]);
    if (i == 0 || least < nearest.clearance) {
      nearest.clearance = least;
      nearest.link = p.link[i];
      nearest.t = p.track.t[i];
    }
    nearest.not_seen += std::isinf(p.track.clearance[i]);
  }
  return nearest;
}

/// Adds the rows of one result to all tables.
class RunRows {
 public:
  explicit RunRows(const SqliteDatabase& database)
      : run_(database, "INSERT OR IGNORE INTO runs VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"),
        part_(database, "INSERT OR IGNORE INTO parts VALUES(?,?,?,?,?,?,?,?)"),
        margin_(database, "INSERT OR IGNORE INTO margins VALUES(?,?,?,?,?,?,?,?,?,?,?)") {}

  void add(const std::string& file, tune::StoredResult stored) {
    std::vector<tune::TunedRecording> alone;
    alone.push_back(std::move(stored.tuned));  // a list of initializers would copy all frames
    const tune::TunedRecording& r = alone.front();
    const tune::MarginTable table = tune::marginTable(alone, indexMargins(), stored.options);
    Nearest worst;
    const tune::ProposedMargin* largest = &table.proposed.front();
    tune::PartByPart parts(r);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Nearest nearest = nearestOf(parts.part(i), i);
      if (i == 0 || nearest.clearance < worst.clearance) worst = nearest;
      const auto proposed = std::find_if(table.proposed.begin(), table.proposed.end(),
                                         [&](const auto& p) { return p.part == r.pass.parts[i].part; });
      if (proposed == table.proposed.end()) continue;
      if (proposed->margin > largest->margin) largest = &*proposed;
      addPart(stored.key, r, nearest, *proposed);
    }
    for (const tune::MarginRow& row : table.rows) addMargin(stored.key, row);
    const tune::PassOptions& pass = stored.options.pass;
    run_.bind(stored.key).bind(file).bind(r.recording).bind(r.content).bind(stored.version);
    run_.bind(static_cast<std::int64_t>(r.frames)).bind(r.t0).bind(r.t1).bind(r.seconds()).bind(r.unjudged);
    run_.bind(pass.limit).bind(pass.braking.reaction_time).bind(pass.braking.deceleration);
    run_.bind(static_cast<std::int64_t>(r.reservations.size())).bind(worst.clearance);
    const tune::PartClearance& p = r.pass.parts[worst.part];
    run_.bind(p.part).bind(linkOf(r, worst)).bind(worst.t);
    run_.bind(largest->margin).bind(largest->part).execute();
  }

 private:
  static std::string linkOf(const tune::TunedRecording& r, const Nearest& n) {
    return n.link ? r.pass.links[*n.link] : std::string();
  }
  void addPart(const std::string& key, const tune::TunedRecording& r, const Nearest& nearest,
               const tune::ProposedMargin& proposed) {
    part_.bind(key).bind(proposed.part).bind(nearest.clearance).bind(linkOf(r, nearest));
    part_.bind(nearest.t).bind(nearest.not_seen).bind(proposed.margin);
    part_.bind(proposed.decided_by ? proposed.decided_by->t : kNaN).execute();
  }
  void addMargin(const std::string& key, const tune::MarginRow& row) {
    const margin::MarginOutcome& o = row.outcome;
    margin_.bind(key).bind(row.part).bind(row.margin).bind(std::int64_t{o.stops});
    margin_.bind(std::int64_t{o.false_stops}).bind(std::int64_t{o.missed_stops}).bind(std::int64_t{o.unseen});
    margin_.bind(o.stopped_time).bind(o.time).bind(o.min_clearance).bind(o.lead_time).execute();
  }

  SqliteStatement run_, part_, margin_;
};

void addValue(ContentHash& hash, const SqliteStatement& row, int column) {
  hash.add(row.type(column));
  if (row.type(column) == SqliteStatement::Type::kInteger) return hash.add(row.integer(column));
  if (row.type(column) == SqliteStatement::Type::kNumber) return hash.add(row.number(column));
  const std::string text = row.text(column);
  hash.add(text.size());
  hash.add(text.data(), text.size());
}

/// Digest of all rows: SQLite itself does not detect a changed value.
std::string digestOf(const SqliteDatabase& database) {
  ContentHash hash;
  for (const auto& [table, key] : kDigested) {
    SqliteStatement rows(database, std::string("SELECT * FROM ") + table + " ORDER BY " + key);
    while (rows.next())
      for (int i = 0; i < rows.columns(); ++i) addValue(hash, rows, i);
  }
  return hash.value().hex();
}

std::string metaOf(const SqliteDatabase& database, const std::string& name) {
  SqliteStatement row(database, "SELECT value FROM meta WHERE name = ?");
  row.bind(name);
  return row.next() ? row.text(0) : std::string();
}

}  // namespace

std::vector<FileStamp> stampsOf(const fs::path& folder) {
  std::vector<FileStamp> stamps;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(folder / "results", ec)) {
    if (entry.path().extension() != ".h5") continue;
    struct stat status {};
    if (::stat(entry.path().c_str(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
    stamps.push_back({entry.path().filename().string(), std::int64_t{status.st_size},
                      std::int64_t{status.st_mtim.tv_sec} * 1000000000 + status.st_mtim.tv_nsec});
  }
  if (stamps.empty())
    throw UsageError(folder.string() +
                     ": found no results (results/*.h5), expected a folder of `tune --out`");
  std::sort(stamps.begin(), stamps.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return stamps;
}

void fillIndex(SqliteDatabase& database, const fs::path& folder, const std::vector<FileStamp>& stamps) {
  database.run("BEGIN");
  database.run(kTables);
  RunRows runs(database);
  SqliteStatement file(database, "INSERT INTO files VALUES(?,?,?)");
  SqliteStatement unreadable(database, "INSERT INTO unreadable VALUES(?,?)");
  for (const FileStamp& stamp : stamps) {
    file.bind(stamp.name).bind(stamp.bytes).bind(stamp.modified).execute();
    try {
      runs.add(stamp.name, tune::readResult(folder / "results" / stamp.name, tune::HeldFrames::kUsual));
    } catch (const ParseError& e) {
      unreadable.bind(stamp.name).bind(e.message()).execute();
    } catch (const UsageError& e) {
      // A file with impossible numbers.
      unreadable.bind(stamp.name).bind(std::string(e.what())).execute();
    }
  }
  SqliteStatement meta(database, "INSERT INTO meta VALUES(?,?)");
  meta.bind(std::string("abstand_index")).bind(kIndexFormat).execute();
  meta.bind(std::string("digest")).bind(digestOf(database)).execute();
  meta.bind(std::string("version")).bind(tune::resultVersion()).execute();
  database.run("COMMIT");
}

bool isCurrent(const SqliteDatabase& database, const std::vector<FileStamp>& stamps) {
  if (metaOf(database, "abstand_index") != std::to_string(kIndexFormat) ||
      metaOf(database, "version") != tune::resultVersion())
    return false;
  std::vector<FileStamp> indexed;
  SqliteStatement row(database, "SELECT name, bytes, modified FROM files ORDER BY name");
  while (row.next()) indexed.push_back({row.text(0), row.integer(1), row.integer(2)});
  return indexed == stamps && metaOf(database, "digest") == digestOf(database);
}

ResultIndex readIndex(const SqliteDatabase& database) {
  ResultIndex index;
  SqliteStatement row(database,
                      "SELECT key, file, recording, part, link, proposed_part, frames, seconds, not_judged, "
                      "min_clearance, t, proposed FROM runs ORDER BY min_clearance, recording, key");
  while (row.next()) {
    IndexedRun run;
    run.key = row.text(0), run.file = row.text(1), run.recording = row.text(2);
    run.part = row.text(3), run.link = row.text(4), run.proposed_part = row.text(5);
    run.frames = row.integer(6);
    run.seconds = row.number(7), run.not_judged = row.number(8);
    run.min_clearance = row.number(9), run.t = row.number(10), run.proposed = row.number(11);
    index.runs.push_back(std::move(run));
  }
  SqliteStatement bad(database, "SELECT file, error FROM unreadable ORDER BY file");
  while (bad.next()) index.unreadable.push_back({bad.text(0), bad.text(1)});
  return index;
}

}  // namespace abstand::results
