// random_profiles COUNT SEED FOLDER [FIRST [near [FIXED]]]: the long test; "near" draws designs near the shipped ones, and then every
// FIXED-th refused one is given to `fusee fix`. Makes COUNT random designs there, fifty at a time, from number FIRST (0)
// on, keeps what ended wrong and prints how many were made and what bound the others (docs/robustness.md). Exit code 1 if any ended
// wrong. Ctrl-C ends it with the tally of those that are finished, and with the FIRST to go on from.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/profile/profile.h"
#include "fusee/search/fix.h"
#include "generator.h"
#include "judge.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

constexpr int kAtATime = 50;
constexpr int kInstances = 4;
constexpr unsigned kLargest = 1'000'000'000;

struct Tally {
    int made = 0, refused = 0, wrong = 0;
    std::map<std::string, std::vector<std::string>> binds;  // refused designs by rule; a design may have several
    double worst_arm_error = 0.0;
    int tried = 0, fixed = 0;         // refused designs given to fix, and made by it
    std::map<std::string, int> left;  // limits that bind what fix could not make

    /// Gives a refused design to fix, which makes all files of its result.
    void fix(const fs::path& file) {
        const std::string toml = core::read_file(file);
        const profile::Profile profile = profile::parse_profile(toml, file);
        const search::fix::Fix found = search::fix::find_fix(profile, toml, {.file = file, .stop = core::interrupted});
        ++tried;
        if (found.end == search::fix::Fix::End::kFixed || found.end == search::fix::Fix::End::kShortened) ++fixed;
        std::set<std::string> rules;
        if (found.end == search::fix::Fix::End::kCannot)
            for (const core::Finding& f : found.left) rules.insert(f.rule);
        for (const std::string& rule : rules) ++left[rule];
    }

    void count(const batch::Row& row) {
        if (const std::string fault = random_profiles::fault(row); !fault.empty()) {
            ++wrong;
            fmt::print("{}: {}\n", row.profile.string(), fault);
            return;
        }
        row.outcome == batch::Outcome::kMade ? ++made : ++refused;
        if (row.outcome == batch::Outcome::kMade) worst_arm_error = std::fmax(worst_arm_error, row.result.file_errors.arm);
        std::set<std::string> rules;
        for (const core::Finding& f : row.result.findings)
            if (f.severity == core::Severity::kError) rules.insert(f.rule);
        for (const std::string& rule : rules) binds[rule].push_back(row.profile.stem().string());
    }

    void print() const {
        fmt::print(
            "\n{} made and read back (worst arm error {:.4f} %), {} refused, {} wrong\n\n| binds | designs | for instance "
            "|\n|---|---|---|\n",
            made, 100.0 * worst_arm_error, refused, wrong);
        std::vector<std::pair<std::string, std::vector<std::string>>> rows(binds.begin(), binds.end());
        std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
        for (auto& [rule, designs] : rows) {
            const std::size_t count = designs.size();
            designs.resize(std::min<std::size_t>(count, kInstances));
            fmt::print("| `{}` | {} | {} |\n", rule, count, fmt::join(designs, ", "));
        }
        if (tried > 0) fmt::print("\nfix made {} of {} refused designs\n", fixed, tried);
        for (const auto& [rule, count] : left) fmt::print("not made by fix: {} of them by {}\n", count, rule);
    }
};

/// Ends the program where the argument is none.
unsigned whole_number(const char* name, const std::string& text) {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && value <= kLargest) return value;
    fmt::print(stderr, "random_profiles: {}: '{}' (allowed: a whole number, 0 to {})\n", name, text, kLargest);
    std::exit(2);
}

}  // namespace

int main(int argc, char** argv) {
    const bool near = argc > 5 && std::string(argv[5]) == "near";
    if (argc < 4 || argc > 7 || (argc > 5 && !near)) {
        fmt::print(stderr, "usage: random_profiles COUNT SEED FOLDER [FIRST [near [FIXED]]]\n");
        return 2;
    }
    const int each = argc == 7 ? static_cast<int>(whole_number("FIXED", argv[6])) : 0;
    const auto seed = whole_number("SEED", argv[2]);
    const int first = argc > 4 ? static_cast<int>(whole_number("FIRST", argv[4])) : 0;
    const int end = first + static_cast<int>(whole_number("COUNT", argv[1]));
    core::catch_interrupts();
    Tally tally;
    int next = first;
    while (next < end && !core::interrupted()) {
        const fs::path folder = fs::path(argv[3]) / fmt::format("from_{:05}", next);
        const int count = std::min(kAtATime, end - next), wrong = tally.wrong;
        const std::vector<batch::Row> rows = random_profiles::make_some(
            seed, next, count, folder, near ? 1 : 0, near ? random_profiles::near_profile : random_profiles::random_profile);
        if (core::interrupted()) break;  // fifty of which some were not begun is made again
        int refused = 0;
        for (const batch::Row& row : rows) {
            tally.count(row);
            if (each > 0 && row.outcome == batch::Outcome::kRefused && refused++ % each == 0) tally.fix(row.profile);
        }
        if (tally.wrong == wrong) fs::remove_all(folder);
        next += count;
        fmt::print(stderr, "{}: {} made, {} refused, {} wrong, {} of {} fixed\n", next, tally.made, tally.refused, tally.wrong, tally.fixed,
                   tally.tried);
    }
    fmt::print("designs {} to {} of seed {}\n", first, next - 1, seed);
    tally.print();
    return tally.wrong > 0 ? 1 : 0;
}
