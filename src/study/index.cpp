#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/csv.h"
#include "fusee/core/error.h"
#include "fusee/core/folder.h"
#include "fusee/study/store.h"
#include "sqlite.h"

namespace fs = std::filesystem;

namespace fusee::study {

namespace {

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
