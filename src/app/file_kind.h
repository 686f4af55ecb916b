#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/core/error.h"

namespace fusee::app {

/// What a file or folder can be to a command.
enum class FileKind {
    kProfile,
    kStudy,
    kCaseFile,  ///< case.toml, or the model of a simulator
    kToml,      ///< of any kind
    kBreakAway,
    kCoupons,
    kInspection,
    kMeasuredSprings,
    kCatalogue,
    kCaseSheet,
    kCsv,  ///< of any kind
    kDiagnosis,
    kJson,  ///< of any kind
    kMesh,
    kPage,
    kPicture,
    kCaseFolder,
    kStudyFolder,
    kUnknown,  ///< also what is not there
};

/// What `path` is, by its ending and its beginning. @throws nothing
[[nodiscard]] FileKind kind_of_file(const std::filesystem::path& path);

/// "is a study, which fusee batch reads", for a command that reads other kinds. "": it may be one of `read`, and the command's own reader
/// knows more. @throws nothing
[[nodiscard]] std::string other_kind(const std::filesystem::path& path, const std::vector<FileKind>& read);

/// Checks an argument: no file of another kind. @param allowed what the command reads, for the message
[[nodiscard]] CLI::Validator reads(std::vector<FileKind> kinds, std::string allowed);
[[nodiscard]] CLI::Validator reads_profile();
[[nodiscard]] CLI::Validator reads_case();
[[nodiscard]] CLI::Validator reads_diagnosis();
[[nodiscard]] CLI::Validator reads_catalogue();

/// A row of bad input says it too, in place of what a profile's reader finds wrong with such a file.
/// @param rows with `profile`, `error` and `mistakes`
template <class Rows>
void name_other_kinds(Rows& rows) {
    for (auto& row : rows) {
        if (row.error.empty()) continue;
        const std::string kind = other_kind(row.profile, {FileKind::kProfile});
        if (kind.empty()) continue;
        row.mistakes = {core::InvalidInput(row.profile.string(), kind, "a profile")};
        row.error = row.mistakes.front().what();
    }
}

}  // namespace fusee::app
