#include "judge.h"

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "fusee/core/file.h"
#include "generator.h"

namespace fs = std::filesystem;

namespace fusee::random_profiles {

namespace {

std::string fault_of_made(const batch::Row& row) {
    if (!row.result.made || core::any_error(row.result.findings)) return "made in spite of an error";
    for (const char* file : {"report.json", "report.html", "springs.csv", "k_se.json", "k_se.stl", "k_pe.json", "k_pe.stl"})
        if (!fs::is_regular_file(row.result.folder / file)) return fmt::format("{} is missing", file);
    std::size_t arms = 0;
    for (const core::Finding& f : row.result.findings) arms += f.rule == "readback.arm" ? 1 : 0;
    if (arms < 4) return fmt::format("{} arms were read back; at least those of two readers for two parts are", arms);
    if (row.result.file_errors.arm > 1e-3) return fmt::format("an arm is off by {}", row.result.file_errors.arm);
    return "";
}

/// Does a finding say "nan" or "inf" where a number belongs? One that was not judged has none to say.
bool without_number(const core::Finding& f) {
    static const std::regex kNone(R"(\b(nan|inf)\b)");
    return f.severity != core::Severity::kNotJudged && std::regex_search(core::to_line(f), kNone);
}

std::string fault_of_refused(const batch::Row& row) {
    if (!core::any_error(row.result.findings)) return "refused without an error";
    if (!row.result.folder.empty()) return "refused and something was written";
    for (const core::Finding& f : row.result.findings) {
        if (f.severity != core::Severity::kError) continue;
        if (f.rule.empty() || f.what.empty() || f.where.empty() || f.suggestion.empty())
            return "a refusal without rule, place or suggestion: " + core::to_line(f);
        if (without_number(f)) return "a refusal without a number: " + core::to_line(f);
    }
    return "";
}

}  // namespace

std::vector<batch::Row> make_some(std::uint64_t seed, int first, int count, const fs::path& folder, unsigned jobs, Generator generator) {
    fs::create_directories(folder);
    std::vector<fs::path> profiles;
    for (int i = first; i < first + count; ++i) {
        profiles.push_back(folder / fmt::format("random_{:05}.toml", i));
        core::write_file(profiles.back(), generator(seed, i));
    }
    return batch::make_all(profiles, {.out = folder / "out"}, jobs);
}

std::string fault(const batch::Row& row) {
    switch (row.outcome) {
        case batch::Outcome::kMade:
            return fault_of_made(row);
        case batch::Outcome::kRefused:
            return fault_of_refused(row);
        default:
            return fmt::format("{}: {}", to_string(row.outcome), row.error);
    }
}

}  // namespace fusee::random_profiles
