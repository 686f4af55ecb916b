// random_profiles COUNT SEED FOLDER: the long test. Makes COUNT random designs there, a hundred at a time, keeps what ended wrong and
// prints how many were made and what bound the others (docs/random-profiles.md). Exit code 1 if any ended wrong.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "judge.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

constexpr int kAtATime = 100;

struct Tally {
    int made = 0, refused = 0, wrong = 0;
    std::map<std::string, int> binds;  // refused designs by rule; a design may have several
    double worst_arm_error = 0.0;

    void count(const batch::Row& row) {
        if (const std::string fault = random_profiles::fault(row); !fault.empty()) {
            ++wrong;
            fmt::print("{}: {}\n", row.profile.string(), fault);
            return;
        }
        row.outcome == batch::Outcome::kMade ? ++made : ++refused;
        if (row.outcome == batch::Outcome::kMade) worst_arm_error = std::max(worst_arm_error, row.result.worst_arm_error);
        std::set<std::string> rules;
        for (const core::Finding& f : row.result.findings)
            if (f.severity == core::Severity::kRequired) rules.insert(f.rule);
        for (const std::string& rule : rules) ++binds[rule];
    }

    void print() const {
        fmt::print("\n{} made and read back (worst arm error {:.4f} %), {} refused, {} wrong\n\n| binds | designs |\n|---|---|\n", made,
                   100.0 * worst_arm_error, refused, wrong);
        std::vector<std::pair<int, std::string>> rows;
        for (const auto& [rule, count] : binds) rows.emplace_back(-count, rule);
        std::sort(rows.begin(), rows.end());
        for (const auto& [count, rule] : rows) fmt::print("| `{}` | {} |\n", rule, -count);
    }
};

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        fmt::print(stderr, "usage: random_profiles COUNT SEED FOLDER\n");
        return 2;
    }
    const int count = std::atoi(argv[1]);
    const auto seed = std::strtoull(argv[2], nullptr, 10);
    Tally tally;
    for (int first = 0; first < count; first += kAtATime) {
        const fs::path folder = fs::path(argv[3]) / fmt::format("from_{:05}", first);
        const int wrong = tally.wrong;
        for (const batch::Row& row : random_profiles::make_some(seed, first, std::min(kAtATime, count - first), folder, 0))
            tally.count(row);
        if (tally.wrong == wrong) fs::remove_all(folder);
    }
    tally.print();
    return tally.wrong > 0 ? 1 : 0;
}
