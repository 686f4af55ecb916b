// fix_each_rule FOLDER [RULE ...]: the long test of `fusee fix`. Each rule is broken by a profile and the profile fixed; prints how each
// ended (docs/guides/fix.md). Exit code 1 if a profile does not break its rule, or what is called fixed does.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "bad_profiles.h"
#include "fusee/checks/check.h"
#include "fusee/core/file.h"
#include "fusee/pipeline/check.h"
#include "fusee/search/fix.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

/// How gravely the rule objects.
core::Severity objection(const profile::Profile& profile, const std::string& rule) {
    const std::vector kinds{profile.process.kind};
    core::Severity gravest = core::Severity::kPass;
    for (const core::Finding& f : pipeline::check(profile, kinds).processes.front().all())
        if (f.rule == rule) gravest = std::max(gravest, f.severity);
    return gravest;
}

std::string names(const search::fix::Fix& fixed) {
    std::set<std::string> all;
    if (fixed.end == search::fix::Fix::End::kCannot)
        for (const core::Finding& f : fixed.left) all.insert("`" + f.rule + "`");
    else
        for (const search::fix::MadeChange& change : fixed.changes)
            all.insert(fmt::format("`{}` {} -> {}", change.key, change.was, change.value));
    return fmt::format("{}", fmt::join(all, ", "));
}

/// The columns "ends" and "how" of the table; counts the ends.
std::string ended(const search::fix::Fix& fixed, const search::fix::FixOptions& options, std::map<std::string, int>& ends) {
    const bool cannot = fixed.end == search::fix::Fix::End::kCannot;
    const bool gave_up = cannot && (fixed.judged >= options.most_judged || fixed.made >= options.most_made);
    const char* end = gave_up ? "gives up" : cannot ? "names the limit" : "fixed";
    ++ends[end];
    return fmt::format("{} | {} | {}", end, names(fixed), fixed.judged);
}

/// Breaks the rule and fixes it. @returns what is wrong; empty: nothing
std::string fix_one(const fix_each_rule::BadProfile& bad, const fs::path& folder, std::map<std::string, int>& ends) {
    core::write_file(folder / (bad.rule + ".toml"), bad.toml);
    const profile::Profile profile = profile::parse_profile(bad.toml, folder / (bad.rule + ".toml"));
    const core::Severity severity = objection(profile, bad.rule);
    if (severity < core::Severity::kWarning) return "is not broken";
    const search::fix::FixOptions options{.file = folder / (bad.rule + "-fixed.toml"), .reviews = severity == core::Severity::kWarning};
    const search::fix::Fix fixed = search::fix::find_fix(profile, bad.toml, options);
    const char* word = options.reviews ? "warning" : "error";
    fmt::print("| `{}` | {} | {} |\n", bad.rule, word, ended(fixed, options, ends));
    if (fixed.end == search::fix::Fix::End::kCannot) return fixed.left.empty() ? "cannot be met, and nothing says why" : "";
    if (objection(profile::parse_profile(fixed.toml, options.file), bad.rule) >= severity) return "objects to what is called fixed";
    return "";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: fix_each_rule FOLDER [RULE ...]\n");
        return 2;
    }
    const fs::path folder = argv[1];
    fs::create_directories(folder / "paper");
    fs::copy_file(fs::path(FUSEE_SOURCE_DIR) / "profiles/paper/table_1.csv", folder / "paper/table_1.csv",
                  fs::copy_options::overwrite_existing);
    const std::set<std::string> only(argv + 2, argv + argc);
    std::map<std::string, int> ends;
    std::set<std::string> attempted;
    int wrong = 0;
    fmt::print("| rule | objection | ends | changes, or what binds | judged |\n|---|---|---|---|---|\n");
    for (const fix_each_rule::BadProfile& bad : fix_each_rule::bad_profiles()) {
        if (!only.empty() && !only.contains(bad.rule)) continue;
        attempted.insert(bad.rule);
        const std::string fault = fix_one(bad, folder, ends);
        if (!fault.empty()) fmt::print("{}: {}\n", bad.rule, fault), ++wrong;
    }
    fmt::print("\n");
    for (const auto& [end, count] : ends) fmt::print("{}: {}\n", end, count);
    for (const checks::Rule& rule : checks::rules())
        if (only.empty() && !attempted.contains(rule.id)) fmt::print("no profile: {}\n", rule.id);
    return wrong > 0 ? 1 : 0;
}
