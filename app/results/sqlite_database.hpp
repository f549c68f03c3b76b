// A database of SQLite in memory. Internal to this module.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace abstand::results {

/// What the library refused. Of bytes that were read: they are no database, or a damaged one.
class SqliteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Never opens a file: its bytes come from and go to somewhere else, so that no lock is ever asked of a
/// network folder and no journal of a stranger is replayed. One thread. Everything throws SqliteError.
class SqliteDatabase {
 public:
  /// An empty one.
  SqliteDatabase();
  /// The bytes of a database file, to be read only. What it defines itself (views, triggers) is not trusted.
  explicit SqliteDatabase(std::string bytes);
  ~SqliteDatabase();
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  void run(const std::string& sql);
  /// As a database file. The same statements give the same bytes.
  std::string bytes() const;
  sqlite3* handle() const { return handle_; }

 private:
  void open();

  sqlite3* handle_{nullptr};
  std::string bytes_;  ///< that are read
};

/// A statement and its rows. The database must outlive it.
class SqliteStatement {
 public:
  enum class Type : std::uint8_t { kInteger, kNumber, kText, kNull };

  SqliteStatement(const SqliteDatabase& database, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  /// The value of the next `?`. Infinities are kept; NaN becomes NULL.
  SqliteStatement& bind(double value);
  SqliteStatement& bind(std::int64_t value);
  SqliteStatement& bind(const std::string& value);
  SqliteStatement& bind(const std::optional<double>& value);
  /// Runs with what was bound, for no rows; then the next values may be bound.
  void execute();

  /// Goes to the next row; false behind the last one.
  bool next();
  int columns() const;
  Type type(int column) const;
  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string text(int column) const;

 private:
  void check(int code) const;

  sqlite3* database_;
  sqlite3_stmt* statement_{nullptr};
  int bound_{0};
};

}  // namespace abstand::results
