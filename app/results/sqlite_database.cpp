#include "app/results/sqlite_database.hpp"

#include <sqlite3.h>

#include <cmath>

namespace abstand::results {
namespace {

// Limits for an untrusted database: longest text or row, and cost of one query.
constexpr int kMaxValueBytes = 1 << 20;

[[noreturn]] void failWith(sqlite3* database) {
  throw SqliteError(database ? sqlite3_errmsg(database) : "no memory for a database");
}

}  // namespace

void SqliteDatabase::open() {
  if (sqlite3_open_v2(":memory:", &handle_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY, nullptr) == SQLITE_OK)
    return;
  const std::string reason = handle_ ? sqlite3_errmsg(handle_) : "no memory for a database";
  sqlite3_close(handle_);
  handle_ = nullptr;
  throw SqliteError(reason);
}

SqliteDatabase::SqliteDatabase() { open(); }

SqliteDatabase::SqliteDatabase(std::string bytes) : bytes_(std::move(bytes)) {
  open();
  sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, kMaxValueBytes);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  const auto size = static_cast<sqlite3_int64>(bytes_.size());
  const int code = sqlite3_deserialize(handle_, "main", reinterpret_cast<unsigned char*>(bytes_.data()), size,
                                       size, SQLITE_DESERIALIZE_READONLY);
  if (code == SQLITE_OK) return;
  sqlite3_close(handle_);
  handle_ = nullptr;
  throw SqliteError("the bytes are no database");
}

SqliteDatabase::~SqliteDatabase() { sqlite3_close(handle_); }

void SqliteDatabase::run(const std::string& sql) {
  if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) failWith(handle_);
}

std::string SqliteDatabase::bytes() const {
  sqlite3_int64 size = 0;
  unsigned char* bytes = sqlite3_serialize(handle_, "main", &size, 0);
  if (!bytes) failWith(handle_);
  std::string text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  sqlite3_free(bytes);
  return text;
}

SqliteStatement::SqliteStatement(const SqliteDatabase& database, const std::string& sql)
    : database_(database.handle()) {
  check(sqlite3_prepare_v2(database_, sql.c_str(), -1, &statement_, nullptr));
}

SqliteStatement::~SqliteStatement() { sqlite3_finalize(statement_); }

void SqliteStatement::check(int code) const {
  if (code != SQLITE_OK) failWith(database_);
}

SqliteStatement& SqliteStatement::bind(double value) {
  check(std::isnan(value) ? sqlite3_bind_null(statement_, ++bound_)
                          : sqlite3_bind_double(statement_, ++bound_, value));
  return *this;
}

SqliteStatement& SqliteStatement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(statement_, ++bound_, value));
  return *this;
}

SqliteStatement& SqliteStatement::bind(const std::string& value) {
  check(sqlite3_bind_text(statement_, ++bound_, value.data(), static_cast<int>(value.size()),
                          SQLITE_TRANSIENT));
  return *this;
}

SqliteStatement& SqliteStatement::bind(const std::optional<double>& value) {
  if (value) return bind(*value);
  check(sqlite3_bind_null(statement_, ++bound_));
  return *this;
}

void SqliteStatement::execute() {
  while (next()) {
  }
  check(sqlite3_reset(statement_));
  bound_ = 0;
}

bool SqliteStatement::next() {
  const int code = sqlite3_step(statement_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) failWith(database_);
  return code == SQLITE_ROW;
}

int SqliteStatement::columns() const { return sqlite3_column_count(statement_); }

SqliteStatement::Type SqliteStatement::type(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return Type::kInteger;
    case SQLITE_FLOAT:
      return Type::kNumber;
    case SQLITE_NULL:
      return Type::kNull;
    default:
      return Type::kText;
  }
}

std::int64_t SqliteStatement::integer(int column) const { return sqlite3_column_int64(statement_, column); }

double SqliteStatement::number(int column) const { return sqlite3_column_double(statement_, column); }

std::string SqliteStatement::text(int column) const {
  const void* bytes = sqlite3_column_blob(statement_, column);
  const int size = sqlite3_column_bytes(statement_, column);
  return bytes ? std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size)) : std::string();
}

}  // namespace abstand::results
