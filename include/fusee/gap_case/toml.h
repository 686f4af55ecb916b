#pragma once
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/gap_case/files.h"

namespace fusee::gap_case {

/// A number of a table and its target.
struct NumberKey {
    std::string name;              ///< "capstan_radius_m"
    double low = 0.0, high = 0.0;  ///< allowed, both ends included
    const char* unit = "";         ///< asked for; "" for a pure number
    double* to = nullptr;
    const char* meaning = "";  ///< for the person who fills it in
    const char* other = "";    ///< unit in which a figure beyond the range may be: "grams"
};

/// A case.toml, flattened: every leaf under its path "rig.capstan_radius_m", with the place where it stands.
class CaseToml {
public:
    using Value = std::variant<double, bool, std::string, std::vector<std::string>, std::vector<double>>;

    /// Reads case.toml, or another file of the folder. @throws core::IoError if it is no TOML; core::InvalidInput for a leaf that is none
    /// of Value
    explicit CaseToml(const CaseFiles& files, const std::string& file = "case.toml");

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] bool has(const std::string& path) const { return leaves_.contains(path) || tables_.contains(path); }
    [[nodiscard]] bool has_table(const std::string& path) const { return tables_.contains(path); }
    [[nodiscard]] const Value& at(const std::string& path) const { return leaves_.at(path).value; }

    /// @throws core::InvalidInput naming what stands outside of these tables
    void allow_tables(const std::vector<std::string>& names) const;
    /// Fills in the numbers that the table holds and returns the names of those it lacks, whose targets stay.
    /// @param others keys of the table that are no numbers
    /// @throws core::InvalidInput for an unknown key, a value of another type, out of range or not finite
    std::vector<std::string> read_numbers(const std::string& table, const std::vector<NumberKey>& keys,
                                          const std::vector<std::string>& others = {}) const;
    /// The same, each of them required.
    void require_numbers(const std::string& table, const std::vector<NumberKey>& keys, const std::vector<std::string>& others = {}) const;
    /// A text. @throws core::InvalidInput if it is missing, empty or no text
    [[nodiscard]] std::string text(const std::string& path, const std::string& allowed) const;
    /// One file or an array of them: each a plain name inside the folder, none twice in the whole case.toml, each there.
    [[nodiscard]] std::vector<std::string> files(const std::string& path) const;
    /// The names of the tables directly below a table, in their order.
    [[nodiscard]] std::vector<std::string> tables_below(const std::string& table) const;
    /// The keys of a table, in the order of their names.
    [[nodiscard]] std::vector<std::string> keys_of(const std::string& table) const;

    /// The caller's mistake at `path`: "file:line:column: path"; at its table, or the file's first line, where it does not stand.
    [[nodiscard]] core::InvalidInput fault(const std::string& path, std::string value, std::string allowed) const;

private:
    struct Place {
        std::size_t line = 1, column = 1;
    };
    struct Leaf {
        Value value;
        Place place;
    };
    struct Builder;
    void read_number(const std::string& path, const NumberKey& key) const;
    void check_file(const std::string& path, const std::string& name) const;

    CaseFiles source_;
    std::string file_, bytes_;
    std::map<std::string, Leaf> leaves_;
    std::map<std::string, Place> tables_;
};

}  // namespace fusee::gap_case
