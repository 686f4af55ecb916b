#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/subsystem/subsystem.h"

/// Columns and parameters of each kind of subsystem: one list for reading, checking and writing.
namespace fusee::subsystem {

struct ColumnKey {
    const char* name;
    bool measured, required, text;
    double low, high;        ///< limits of a number: beyond them it is in another unit
    const char* other = "";  ///< which
};
/// A number of [bench] or of a file's '#' lines.
struct ParameterKey {
    const char* name;
    double low, high;  ///< beyond them it is in another unit
    const char* unit;
    const char* other = "";  ///< which
};
/// A text of [bench] or of a file's '#' lines.
struct WordKey {
    const char* name;
    std::vector<std::string> allowed;  ///< empty: any
};
struct KindKeys {
    Kind kind;
    const char* name;
    const char* experiment;
    std::vector<ColumnKey> columns;
    std::vector<ParameterKey> parameters, sensors;
    bool laws = false;  ///< each record has a file with its nominal law
    std::vector<WordKey> words = {};
};
[[nodiscard]] const KindKeys& keys_of(Kind kind);
[[nodiscard]] const std::vector<KindKeys>& all_keys();

/// Asks about figures that contradict each other in the units of their columns: milliseconds, degrees, counts, grams, mNm, ...
/// @throws core::InvalidInput "FOLDER/FILE: column" with the question
void ask_units(const Case& subsystem_case, const std::filesystem::path& folder);

}  // namespace fusee::subsystem
