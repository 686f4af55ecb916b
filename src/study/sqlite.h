#pragma once
#include <sqlite3.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace fusee::study {

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

}  // namespace fusee::study
