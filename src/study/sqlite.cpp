#include "sqlite.h"

#include <cmath>

#include "fusee/core/error.h"

namespace fusee::study {

namespace {

void require(bool good, sqlite3* database, const std::string& file) {
    if (!good) throw core::IoError(file, database != nullptr ? sqlite3_errmsg(database) : "out of memory");
}

}  // namespace

Statement::Statement(sqlite3* database, const std::string& sql, const std::string& file)
    : file_(file), statement_(nullptr, sqlite3_finalize) {
    sqlite3_stmt* statement = nullptr;
    const char* rest = nullptr;
    if (sqlite3_prepare_v2(database, sql.c_str(), static_cast<int>(sql.size()), &statement, &rest) != SQLITE_OK)
        throw core::InvalidInput(file, sqlite3_errmsg(database),
                                 "one SQL statement, e.g. SELECT name, mass_g FROM designs ORDER BY mass_g");
    statement_.reset(statement);
    if (statement == nullptr || std::string(rest).find_first_not_of(" \t\r\n;") != std::string::npos)
        throw core::InvalidInput(file, sql, "one SQL statement");
}

void Statement::bind(int place, double number) {
    if (std::isfinite(number))
        sqlite3_bind_double(statement_.get(), place, number);
    else
        sqlite3_bind_null(statement_.get(), place);
}

void Statement::bind(int place, const std::string& text) {
    sqlite3_bind_text(statement_.get(), place, text.c_str(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

bool Statement::step() {
    const int result = sqlite3_step(statement_.get());
    require(result == SQLITE_ROW || result == SQLITE_DONE, sqlite3_db_handle(statement_.get()), file_);
    return result == SQLITE_ROW;
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

std::string Statement::text(int column) const {
    const unsigned char* text = sqlite3_column_text(statement_.get(), column);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

Database::Database(const std::filesystem::path& file, bool read_only) : file_(file.string()), database_(nullptr, sqlite3_close) {
    sqlite3* database = nullptr;
    const int flags = read_only ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    const int result = sqlite3_open_v2(file.c_str(), &database, flags, nullptr);
    database_.reset(database);
    require(result == SQLITE_OK, database, file_);
}

void Database::run(const std::string& sql) {
    require(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK, database_.get(), file_);
}

Statement Database::prepare(const std::string& sql) { return {database_.get(), sql, file_}; }

}  // namespace fusee::study
