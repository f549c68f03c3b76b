// SQLite database in memory. Internal to this module.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace abstand::results {

/// Error of the library. For bytes that were read: not a database, or damaged.
class SqliteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Never opens a file: bytes are read and written elsewhere, so that no locks are needed on a network folder
/// and no untrusted journal is replayed. One thread. Everything throws SqliteError.
class SqliteDatabase {
 public:
  /// An empty database.
  SqliteDatabase();
  /// Bytes of a database file, read-only. Its own definitions (views, triggers) are not trusted.
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
  std::string bytes_;  ///< input bytes
};

/// A prepared statement and its rows. The database must outlive this object.
class SqliteStatement {
 public:
  enum class Type : std::uint8_t { kInteger, kNumber, kText, kNull };

  SqliteStatement(const SqliteDatabase& database, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  /// Binds the next `?`. Infinities are kept; NaN becomes NULL.
  SqliteStatement& bind(double value);
  SqliteStatement& bind(std::int64_t value);
  SqliteStatement& bind(const std::string& value);
  SqliteStatement& bind(const std::optional<double>& value);
  /// Runs a statement without rows; values can then be bound again.
  void execute();

  /// Advances to the next row; false after the last one.
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
