#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/core/error.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "fusee/study/store.h"

namespace fusee::study {

namespace {

/// A prepared statement of an open database.
class Statement {
public:
    Statement(sqlite3* database, const std::string& sql, const std::string& file);
    void bind(int place, double number);  ///< NaN: NULL
    void bind(int place, const std::string& text);
    /// @returns whether there is a row @throws core::IoError; core::InvalidInput if the time is up; core::Stopped
    bool step();
    void reset();
    [[nodiscard]] int columns() const { return sqlite3_column_count(statement_.get()); }
    [[nodiscard]] std::string name(int column) const { return sqlite3_column_name(statement_.get(), column); }
    [[nodiscard]] std::string text(int column) const;  ///< "" for NULL
    [[nodiscard]] bool writes() const { return sqlite3_stmt_readonly(statement_.get()) == 0; }

private:
    std::string file_;
    std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)> statement_;
};

/// An open database. @throws core::IoError
class Database {
public:
    /// A file to write, made if it is not there.
    explicit Database(const std::filesystem::path& file);
    /// Somebody else's file, only to be read: it is opened without journal or lock, its views, triggers and functions do nothing, no
    /// other file can be attached, and a statement ends after `most`, with fusee, and within limits of memory.
    Database(const std::filesystem::path& file, std::chrono::seconds most);
    void run(const std::string& sql);
    [[nodiscard]] Statement prepare(const std::string& sql);

private:
    void open(const std::string& name, int flags);
    void restrain();

    std::string file_;
    std::unique_ptr<sqlite3, int (*)(sqlite3*)> database_;
    std::chrono::steady_clock::time_point end_;
};

void require(bool good, sqlite3* database, const std::string& file) {
    if (!good) throw core::IoError(file, database != nullptr ? sqlite3_errmsg(database) : "out of memory");
}

constexpr int kLongestText = 1'000'000;             // [bytes] of one value
constexpr sqlite3_int64 kMostMemory = 500'000'000;  // [bytes] of a query

/// Only what a SELECT on tables does; PRAGMA only to list columns.
int may(void*, int action, const char* first, const char*, const char*, const char*) {
    const std::string_view name = first != nullptr ? first : "";
    const bool reads = action == SQLITE_SELECT || action == SQLITE_READ || action == SQLITE_FUNCTION || action == SQLITE_RECURSIVE ||
                       (action == SQLITE_PRAGMA && (name == "table_info" || name == "table_list"));
    return reads ? SQLITE_OK : SQLITE_DENY;
}

/// Every byte of the path that is not a letter, digit or '/' as %XX.
std::string uri_of(const std::filesystem::path& file) {
    std::string uri = "file:";
    for (const unsigned char c : std::filesystem::absolute(file).string())
        uri += (std::isalnum(c) != 0 && c < 0x80) || c == '/' ? std::string(1, static_cast<char>(c)) : fmt::format("%{:02x}", c);
    return uri + "?immutable=1";
}

/// The columns of an index's tables.
std::vector<std::string> columns_of_index(sqlite3* database) {
    std::vector<std::string> names;
    for (const char* sql : {"SELECT * FROM designs", "SELECT * FROM columns"}) {
        sqlite3_stmt* statement = nullptr;
        if (sqlite3_prepare_v2(database, sql, -1, &statement, nullptr) == SQLITE_OK)
            for (int i = 0; i < sqlite3_column_count(statement); ++i) names.emplace_back(sqlite3_column_name(statement, i));
        sqlite3_finalize(statement);
    }
    return names;
}

/// The near names for SQLite's "no such column: mas_g" and "no such table: design".
std::string near_names_of(sqlite3* database, const std::string& message) {
    constexpr std::string_view kColumn = "no such column: ", kTable = "no such table: ";
    if (message.starts_with(kColumn)) return core::did_you_mean(message.substr(kColumn.size()), columns_of_index(database));
    if (message.starts_with(kTable)) return "; the tables are designs and columns";
    return "";
}

[[noreturn]] void refuse_statement(sqlite3* database, const std::string& file) {
    const bool forbidden = sqlite3_errcode(database) == SQLITE_AUTH;
    const std::string message = forbidden ? "the index is only read" : sqlite3_errmsg(database);  // the next call replaces it
    throw core::InvalidInput(file, message + near_names_of(database, message),
                             "one SQL statement, e.g. SELECT name, mass_g FROM designs ORDER BY mass_g");
}

Statement::Statement(sqlite3* database, const std::string& sql, const std::string& file)
    : file_(file), statement_(nullptr, sqlite3_finalize) {
    sqlite3_stmt* statement = nullptr;
    const char* rest = nullptr;
    if (sqlite3_prepare_v2(database, sql.c_str(), static_cast<int>(sql.size()), &statement, &rest) != SQLITE_OK)
        refuse_statement(database, file);
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
    if (result == SQLITE_INTERRUPT) {
        if (core::interrupted()) throw core::Stopped();
        throw core::InvalidInput("SQL", "the query takes longer than its time: ask for less, or give it more with --seconds", "");
    }
    require(result == SQLITE_ROW || result == SQLITE_DONE, sqlite3_db_handle(statement_.get()), file_);
    return result == SQLITE_ROW;
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

std::string Statement::text(int column) const {
    const unsigned char* text = sqlite3_column_text(statement_.get(), column);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

Database::Database(const std::filesystem::path& file) : file_(file.string()), database_(nullptr, sqlite3_close) {
    open(file_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOFOLLOW);
}

Database::Database(const std::filesystem::path& file, std::chrono::seconds most)
    : file_(file.string()), database_(nullptr, sqlite3_close), end_(std::chrono::steady_clock::now() + most) {
    // immutable: SQLite looks for no journal beside it, which may be a pipe. An index is replaced whole, never changed.
    open(uri_of(file), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
    restrain();
}

void Database::open(const std::string& name, int flags) {
    sqlite3* database = nullptr;
    const int result = sqlite3_open_v2(name.c_str(), &database, flags, nullptr);
    database_.reset(database);
    require(result == SQLITE_OK, database, file_);
}

/// https://www.sqlite.org/security.html
void Database::restrain() {
    constexpr int kSteps = 10'000;      // of SQLite's machine: some 0.1 ms
    run("PRAGMA temp_store = MEMORY");  // an endless sort meets the limit of memory, not a full disk
    sqlite3* database = database_.get();
    const auto over = [](void* end) {
        return int(core::interrupted() || std::chrono::steady_clock::now() > *static_cast<std::chrono::steady_clock::time_point*>(end));
    };
    sqlite3_progress_handler(database, kSteps, over, &end_);
    sqlite3_set_authorizer(database, may, nullptr);
    for (const auto& [option, on] : {std::pair{SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                     {SQLITE_DBCONFIG_DEFENSIVE, 1},
                                     {SQLITE_DBCONFIG_ENABLE_VIEW, 0},
                                     {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0}})
        sqlite3_db_config(database, option, on, nullptr);
    for (const auto& [limit, most] : {std::pair{SQLITE_LIMIT_LENGTH, kLongestText},
                                      {SQLITE_LIMIT_SQL_LENGTH, kLongestText},
                                      {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 1000},
                                      {SQLITE_LIMIT_ATTACHED, 0},
                                      {SQLITE_LIMIT_EXPR_DEPTH, 200}})
        sqlite3_limit(database, limit, most);
    sqlite3_hard_heap_limit64(kMostMemory);
}

void Database::run(const std::string& sql) {
    require(sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK, database_.get(), file_);
}

Statement Database::prepare(const std::string& sql) { return {database_.get(), sql, file_}; }

std::string cell_of(const Figure& figure) {
    if (const auto* number = std::get_if<double>(&figure)) return std::isfinite(*number) ? fmt::format("{}", *number) : "";
    return core::csv_cell(std::get<std::string>(figure));
}

/// SQLite opens a file of any kind and reports what it is when it is read.
void require_index(Database& database, const fs::path& file) {
    try {
        Statement tables = database.prepare("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name IN ('designs', 'columns')");
        if (tables.step() && tables.text(0) == "2") return;
    } catch (const core::InputError&) {  // reported below
    }
    throw core::IoError(file.string(), "is not the index of a study (index.sqlite)");
}

std::string quoted(const std::string& name) { return '"' + name + '"'; }

}  // namespace

std::string column_name(const std::string& key) {
    std::string name = key;
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

void write_csv(const fs::path& file, const std::vector<Column>& columns, const EachRow& rows) {
    constexpr std::size_t kPiece = 1 << 16;
    core::NewFile out(file);
    std::string text = "number,name";
    for (const Column& column : columns) text += ',' + column.name;
    text += '\n';
    rows([&](const Row& row) {
        text += fmt::format("{},{}", row.index, core::csv_cell(row.name));
        for (const Column& column : columns) {
            const Figure* figure = row.find(column.name);
            text += ',' + (figure != nullptr ? cell_of(*figure) : "");
        }
        text += '\n';
        if (text.size() < kPiece) return;
        out.add(text);
        text.clear();
    });
    out.add(text);
    out.commit();
}

void write_sqlite(const fs::path& file, const std::vector<Column>& columns, const EachRow& rows) {
    fs::remove(file);
    Database database(file);
    database.run("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN");  // a new file: a killed run leaves none
    std::string table = "CREATE TABLE designs (number INTEGER PRIMARY KEY, name TEXT NOT NULL", places = "?, ?";
    for (const Column& column : columns) {
        table += ", " + quoted(column.name) + (column.is_text ? " TEXT" : " REAL");
        places += ", ?";
    }
    database.run(table + ")");
    database.run("CREATE TABLE columns (name TEXT PRIMARY KEY, meaning TEXT NOT NULL)");
    Statement column_row = database.prepare("INSERT INTO columns VALUES (?, ?)");
    for (const Column& column : columns) {
        column_row.reset();
        column_row.bind(1, column.name);
        column_row.bind(2, column.meaning);
        column_row.step();
    }
    Statement insert = database.prepare("INSERT INTO designs VALUES (" + places + ")");
    rows([&](const Row& row) {
        insert.reset();
        insert.bind(1, static_cast<double>(row.index));
        insert.bind(2, row.name);
        int place = 3;
        for (const Column& column : columns) {
            const Figure* figure = row.find(column.name);
            std::visit([&](const auto& value) { insert.bind(place++, value); }, figure != nullptr ? *figure : Figure(std::nan("")));
        }
        insert.step();
    });
    insert.reset();
    column_row.reset();
    database.run("COMMIT");
}

void query(const fs::path& file, const std::string& sql, std::chrono::seconds most,
           const std::function<bool(const std::vector<std::string>&)>& take) {
    if (!fs::is_regular_file(file)) throw core::IoError(file.string(), "is not there; `fusee batch` writes the index of a study");
    Database database(file, most);
    require_index(database, file);
    Statement statement = database.prepare(sql);
    if (statement.writes()) throw core::InvalidInput("SQL", sql, "a statement that only reads");
    std::vector<std::string> cells;
    for (int i = 0; i < statement.columns(); ++i) cells.push_back(statement.name(i));
    for (bool goes_on = take(cells); goes_on && statement.step(); goes_on = take(cells))
        for (int i = 0; i < statement.columns(); ++i) cells[static_cast<std::size_t>(i)] = statement.text(i);
}

}  // namespace fusee::study
