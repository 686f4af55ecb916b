// random_profiles COUNT SEED FOLDER [FIRST]: the long test. Makes COUNT random designs there, a hundred at a time, from number FIRST (0)
// on, keeps what ended wrong and prints how many were made and what bound the others (docs/random-profiles.md). Exit code 1 if any ended
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

#include "fusee/core/progress.h"
#include "judge.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

constexpr int kAtATime = 100;
constexpr int kInstances = 4;
constexpr unsigned kLargest = 1'000'000'000;

struct Tally {
    int made = 0, refused = 0, wrong = 0;
    std::map<std::string, std::vector<std::string>> binds;  // refused designs by rule; a design may have several
    double worst_arm_error = 0.0;

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
    if (argc != 4 && argc != 5) {
        fmt::print(stderr, "usage: random_profiles COUNT SEED FOLDER [FIRST]\n");
        return 2;
    }
    const auto seed = whole_number("SEED", argv[2]);
    const int first = argc == 5 ? static_cast<int>(whole_number("FIRST", argv[4])) : 0;
    const int end = first + static_cast<int>(whole_number("COUNT", argv[1]));
    core::catch_interrupts();
    Tally tally;
    int next = first;
    while (next < end && !core::interrupted()) {
        const fs::path folder = fs::path(argv[3]) / fmt::format("from_{:05}", next);
        const int count = std::min(kAtATime, end - next), wrong = tally.wrong;
        const std::vector<batch::Row> rows = random_profiles::make_some(seed, next, count, folder, 0);
        if (core::interrupted()) break;  // a hundred of which some were not begun is made again
        for (const batch::Row& row : rows) tally.count(row);
        if (tally.wrong == wrong) fs::remove_all(folder);
        next += count;
        fmt::print(stderr, "{}: {} made, {} refused, {} wrong\n", next, tally.made, tally.refused, tally.wrong);
    }
    fmt::print("designs {} to {} of seed {}\n", first, next - 1, seed);
    tally.print();
    return tally.wrong > 0 ? 1 : 0;
}
