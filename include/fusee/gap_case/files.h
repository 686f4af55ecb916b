#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/csv.h"

namespace fusee::gap_case {

/// The files of a case by name: "case.toml", "dead_band.csv".
using CaseTexts = std::map<std::string, std::string>;

/// Where the files of a case are: in a folder, or in memory.
class CaseFiles {
public:
    CaseFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}  // NOLINT(google-explicit-constructor)
    /// @param name stands for the folder in messages. @param texts must outlive this
    CaseFiles(std::string name, const CaseTexts& texts) : folder_(std::move(name)), texts_(&texts) {}

    /// The folder, or the name that stands for it.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// The name of the folder itself: that of the case.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] bool has(const std::string& file) const;
    /// Are they one file?
    [[nodiscard]] bool same(const std::string& one, const std::string& other) const;
    /// @throws core::IoError if it is missing or larger than `most` bytes
    [[nodiscard]] std::string read(const std::string& file, std::size_t most) const;
    /// @throws as core::read_csv
    [[nodiscard]] core::CsvTable read_csv(const std::string& file, const std::vector<core::CsvColumn>& columns,
                                          const core::CsvOptions& options, const std::function<void(std::string_view)>& seen) const;

private:
    std::filesystem::path folder_;
    const CaseTexts* texts_ = nullptr;
};

}  // namespace fusee::gap_case
