#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "figures.h"
#include "fusee/core/file.h"
#include "fusee/gap_case/break_away.h"
#include "fusee/paper/paper.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/profile/places.h"
#include "fusee/profile/profile.h"
#include "fusee/search/design.h"

namespace fusee::paper {

namespace {

const pipeline::SimulateOptions kEnds{.levels = 2, .push_torque = {}};  // least and greatest co-contraction

/// The sources of all figures, read before anything long begins.
struct Sources {
    profile::Profile first_prototype, new_springs, pnrvsa;
    std::vector<profile::Profile> relatives;
    std::string break_away_name, break_away;  // the CSV file's bytes
};

Sources read_sources(const fs::path& folder) {
    const fs::path csv = folder / "examples" / "break_away.csv";
    Sources sources{profile::read_profile(folder / "first_prototype.toml"),
                    profile::read_profile(folder / "paper" / "new_springs.toml"),
                    profile::read_profile(folder / "pnrvsa.toml"),
                    {},
                    csv.string(),
                    core::read_file(csv, gap_case::kLargestBreakAwayFile)};
    for (const fs::path& path : profile::find_profiles({folder / "relatives"})) sources.relatives.push_back(profile::read_profile(path));
    return sources;
}

core::Provenance provenance(const Sources& sources) {
    std::string hashes = sources.first_prototype.sha256 + sources.new_springs.sha256 + sources.pnrvsa.sha256;
    for (const profile::Profile& relative : sources.relatives) hashes += relative.sha256;
    return {"paper", core::sha256_hex(hashes + core::sha256_hex(sources.break_away)), ""};
}

/// Makes the figures; keeps refusals with the profile's name.
class Maker {
public:
    Maker(const Sources& sources, const PaperOptions& options) : sources_(sources), options_(options) {
        paper_.provenance = provenance(sources);
    }

    /// @return false: stopped
    bool make_all() {
        const std::pair<const char*, std::function<void()>> pieces[] = {
            {"figure 1", [this] { paper_.figure_1 = noise_figure(); }},
            {"figure 2", [this] { keep(sources_.first_prototype, hill_figure(sources_.first_prototype), paper_.figure_2); }},
            {"figure 6 and table I", [this] { keep(sources_.first_prototype, replay_table(sources_.first_prototype), paper_.table_1); }},
            {"table II", [this] { keep(sources_.new_springs, replay_table(sources_.new_springs), paper_.table_2); }},
            {"figure 8", [this] { identify(); }},
            {"figure 9", [this] { search(); }},
            {"relatives", [this] { survey(); }}};
        static_assert(std::size(pieces) == kPieces);
        for (const auto& [name, make] : pieces) {
            if (options_.stop()) return false;
            make();
            if (options_.note) options_.note(name);
        }
        return !options_.stop();
    }

    [[nodiscard]] Paper paper() && { return std::move(paper_); }
    [[nodiscard]] const core::Findings& refusals() const { return refusals_; }

private:
    template <class T>
    void keep(const profile::Profile& profile, core::Outcome<T> outcome, T& place) {
        if (outcome) {
            place = std::move(outcome).value();
            return;
        }
        for (core::Finding finding : outcome.refusal()) {
            finding.where = profile.name + (finding.where.empty() ? "" : ", " + finding.where);
            refusals_.push_back(std::move(finding));
        }
    }
    void identify() {
        const fs::path file = sources_.break_away_name;
        paper_.figure_8 = {file.stem().string(), core::sha256_hex(sources_.break_away),
                           gap_case::identify_friction(gap_case::parse_break_away(sources_.break_away, sources_.break_away_name))};
    }
    void search() {
        const search::codesign::RunOptions run{.out = {}, .jobs = options_.jobs, .stop = options_.stop};
        search::codesign::RunResult found = search::codesign::run_algorithm_1(sources_.pnrvsa, run);
        using Search = core::Outcome<search::codesign::SearchReport>;
        keep(sources_.pnrvsa, found.search ? Search(std::move(*found.search)) : Search(std::move(found.findings)), paper_.figure_9);
    }
    void survey() {
        for (profile::Profile relative : sources_.relatives) {
            keep(relative, pipeline::simulate(relative, kEnds), paper_.relatives.emplace_back());
            relative.rig.position_stiffness = 0.0;
            pipeline::Simulation alone;
            keep(relative, pipeline::simulate(relative, kEnds), alone);
            paper_.torque_control.push_back(alone.survey);
        }
    }

    const Sources& sources_;
    const PaperOptions& options_;
    Paper paper_;
    core::Findings refusals_;
};

}  // namespace

Result run(const PaperOptions& options) {
    const Sources sources = read_sources(options.profiles);
    Maker maker(sources, options);
    Result result;
    result.interrupted = !maker.make_all();
    result.findings = maker.refusals();
    if (!result.interrupted && result.findings.empty()) result.paper = std::move(maker).paper();
    return result;
}

bool NoiseCurve::monotone() const {
    for (std::size_t i = 0; i < c.size(); ++i)
        if (slope[i] > 1e-9 * joint[i] / c[i]) return false;
    return true;
}

double HillFigure::largest_difference() const {
    double largest = 0.0;
    for (const Row& row : rows) largest = std::max(largest, std::abs(row.series - row.parallel));
    return largest;
}

bool PaperTable::rises() const {
    const auto& rows = simulation.measured;
    return std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.measured < b.measured; });
}

}  // namespace fusee::paper
