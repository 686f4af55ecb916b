#include "fusee/batch/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "figures.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/parallel.h"
#include "fusee/core/progress.h"
#include "fusee/core/provenance.h"
#include "fusee/report/report.h"
#include "fusee/report/study.h"
#include "run_each.h"
#include "study_folder.h"

namespace fusee::batch {

namespace {

constexpr std::size_t kMostReasons = 20;

/// What determines a design's result: two designs with one key have the same row.
/// @throws as study::Plan::profile
std::string key_of(const study::Plan& plan, const study::Planned& planned) {
    const study::Study& study = plan.study();
    std::string all = fmt::format("fusee {}\n{}\n{}\n{}\n", core::version(), to_string(study.outputs), plan.digest(planned), planned.name);
    for (const double torque : study.torques) all += fmt::format("{}\n", torque);
    return core::sha256_hex(all);
}

/// The files that a study asks for.
void choose_outputs(profile::Outputs& outputs, study::Outputs chosen, bool joint) {
    if (chosen == study::Outputs::kAll) return;
    const bool meshes = chosen == study::Outputs::kMeshes;
    outputs.formats = meshes ? std::vector<std::string>{"stl", "scad", "dxf"} : std::vector<std::string>{};
    outputs.pair = meshes && joint;
    outputs.plate = false;
    outputs.kerf = 0.0;
}

/// Makes one design; its files appear together in its folder, or not at all.
Figures make_design(profile::Profile asked, const study::Study& study, const StudyOptions& options, const std::string& name,
                    Outcome& outcome) {
    choose_outputs(asked.outputs, study.outputs, !asked.is_spring());
    pipeline::require_parts(asked);
    const bool all = study.outputs == study::Outputs::kAll;
    std::optional<core::OutputFolder> output;  // none: no files
    if (study.outputs != study::Outputs::kFigures)
        output.emplace(
            options.out, fs::path(study.name) / "designs" / name,
            core::OutputRun{
                .command = "make", .source = asked.file, .force = options.force, .sheets = pipeline::sheets_of(asked), .stays = true});
    const auto made = all ? pipeline::make_parts(asked, *output) : pipeline::make_figures(asked, output ? &*output : nullptr);
    const core::Findings findings = made ? made->report.all_findings() : made.refusal();
    outcome = made && !core::any_error(findings) ? Outcome::kMade : Outcome::kRefused;
    if (outcome == Outcome::kRefused) return finding_figures(findings);
    if (all) report::write_design(*made, output->path());
    if (output) output->commit();
    return design_figures(*made, study.torques);
}

/// One run over a study: shares the counters between its threads.
class Run {
public:
    Run(const study::Plan& plan, const StudyOptions& options, const core::OutputFolder& folder)
        : plan_(plan),
          options_(options),
          earlier_(folder, row_fault(plan)),
          log_(folder, fmt::format("{}-of-{}", options.shard.number, options.shard.count)) {}

    void make_all(core::Progress& progress) {
        core::parallel_for(options_.shard.size(plan_.size()), options_.jobs, [&](std::size_t i) {
            if (core::interrupted()) return;
            const study::Planned planned = plan_.at(options_.shard.index(i));
            progress.advance(planned.name + ": " + make_one(planned));
        });
    }
    [[nodiscard]] StudyResult result() && {
        result_.bad_rows = earlier_.bad();
        for (auto& [index, reason] : reasons_) result_.reasons.push_back(std::move(reason));
        return std::move(result_);
    }

private:
    /// @returns the outcome in words
    std::string make_one(const study::Planned& planned) {
        if (!planned.excluded_by.empty()) return count(result_.excluded, "left out: " + planned.excluded_by);
        const auto begin = std::chrono::steady_clock::now();
        Ended ended;
        study::Row row{{}, planned.index, planned.name, {}, 0.0};
        bool known = false;
        guarded(ended, [&] {
            row.key = key_of(plan_, planned);
            if ((known = earlier_.find(row.key, row.name).has_value())) return;
            const Figures figures = make_design(plan_.profile(planned), plan_.study(), options_, planned.name, ended.outcome);
            row.figures = varied_figures(plan_, planned);
            row.figures.insert(row.figures.begin(), {"outcome", std::string(to_string(ended.outcome))});
            row.figures.insert(row.figures.end(), figures.begin(), figures.end());
            row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            log_.append(row);
        });
        if (known) return count(result_.earlier, "made earlier");
        return note(planned, ended);
    }
    std::string count(std::size_t& counter, std::string words) {
        const std::lock_guard lock(mutex_);
        ++counter;
        return words;
    }
    std::string note(const study::Planned& planned, const Ended& ended) {
        const std::lock_guard lock(mutex_);
        switch (ended.outcome) {
            case Outcome::kMade:
                ++result_.made;
                break;
            case Outcome::kRefused:
                ++result_.refused;
                break;
            case Outcome::kBadInput:
            case Outcome::kOutOfResources:
                ++result_.bad_input;
                break;
            case Outcome::kInterrupted:
                break;  // as if it had not begun
            default:
                ++result_.failed;
        }
        if (!ended.error.empty()) keep(planned.index, planned.name + ": " + ended.error);
        return to_string(ended.outcome);
    }

    /// Keeps the reasons of the first designs, whatever the order in which they end.
    void keep(std::size_t index, std::string reason) {
        reasons_.emplace(index, std::move(reason));
        if (reasons_.size() > kMostReasons) reasons_.erase(std::prev(reasons_.end()));
    }

    const study::Plan& plan_;
    const StudyOptions& options_;
    study::RowIndex earlier_;
    study::RowLog log_;
    std::mutex mutex_;
    StudyResult result_;
    std::map<std::size_t, std::string> reasons_;
};

/// A design that is not left out, and where its row stands; none: not finished.
struct Finished {
    std::size_t index = 0;
    std::optional<study::RowIndex::Place> place;
};

/// The finished designs in the order of the plan.
std::vector<Finished> find_rows(const study::Plan& plan, const study::RowIndex& rows) {
    std::vector<Finished> found;
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (core::interrupted()) throw core::Stopped();
        const study::Planned planned = plan.at(i);
        if (!planned.excluded_by.empty()) continue;
        found.push_back({i, {}});
        try {
            found.back().place = rows.find(key_of(plan, planned), planned.name);
        } catch (const core::InputError&) {  // a profile that cannot be read has no row
        }
    }
    return found;
}

/// Adds the rows that are of no design.
void add_foreign(study::BadRows& bad, const study::RowIndex& rows, const std::vector<Finished>& designs) {
    using Line = std::pair<std::uint32_t, std::uint64_t>;
    std::set<Line> used;
    for (const Finished& design : designs)
        if (design.place) used.insert({design.place->file, design.place->line});
    if (used.size() == rows.size()) return;
    std::map<Line, study::RowIndex::Place> foreign;
    rows.each([&](const auto& place) {
        if (const Line line{place.file, place.line}; !used.contains(line)) foreign[line] = place;
    });
    for (const auto& [line, place] : foreign)
        bad.add(fmt::format("{}: is of no design of this study as it is: of other inputs or another study, or by another version of fusee",
                            rows.named(place)));
}

/// The most shards that a log's name states: 8 of "3-of-8.jsonl"; 0: none.
std::size_t shards_of(const std::vector<std::string>& logs) {
    std::size_t most = 0;
    for (const std::string& log : logs) {
        Shard shard;
        const std::size_t of = log.find("-of-"), end = log.find('.');
        if (of == std::string::npos || end == std::string::npos || of > end) continue;
        try {
            shard = parse_shard(log.substr(0, of) + '/' + log.substr(of + 4, end - of - 4));
        } catch (const core::InvalidInput&) {
            continue;  // a log of another name
        }
        most = std::max(most, shard.count);
    }
    return most > 1 ? most : 0;
}

/// Counts and names the designs without a row.
IndexSize size_of(const study::Plan& plan, const study::RowIndex& rows, const std::vector<Finished>& designs) {
    IndexSize size{.shards = shards_of(rows.logs()), .bad_rows = rows.bad()};
    for (const Finished& design : designs) {
        if (design.place) {
            ++size.designs;
            continue;
        }
        if (size.missing++ < kMostReasons) size.names.push_back(plan.at(design.index).name);
        if (size.shards > 0) ++size.missing_of_shard[design.index % size.shards + 1];
    }
    add_foreign(size.bad_rows, rows, designs);
    return size;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    Shard shard;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, shard.number);
    const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
    const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
    if (!slash || second.ec != std::errc() || second.ptr != end || shard.number < 1 || shard.number > shard.count ||
        shard.count > study::kMostDesigns)
        throw core::InvalidInput("--shard", text,
                                 fmt::format("NUMBER/COUNT with 1 <= NUMBER <= COUNT <= {}, e.g. 3/8", study::kMostDesigns));
    return shard;
}

std::size_t Shard::size(std::size_t designs) const { return (designs + count - number) / count; }

StudyResult run_study(const study::Plan& plan, const StudyOptions& options) {
    const core::OutputFolder folder = claim_study_folder(plan, options.out, options.force);
    core::Progress progress("batch", options.shard.size(plan.size()));
    Run run(plan, options, folder);
    run.make_all(progress);
    StudyResult result = std::move(run).result();
    result.folder = folder.target();
    result.planned = plan.size();
    result.interrupted = core::interrupted();
    if (options.shard.count == 1 && !result.interrupted) {
        IndexSize index = write_index(plan, options.out, options.force);
        result.indexed = index.designs;
        result.bad_rows = std::move(index.bad_rows);
    }
    return result;
}

IndexSize write_index(const study::Plan& plan, const fs::path& out, bool force) {
    core::OutputFolder output = study_folder(plan, out, force);
    const study::RowIndex rows(output, row_fault(plan));
    const std::vector<Finished> designs = find_rows(plan, rows);
    IndexSize size = size_of(plan, rows, designs);
    if (size.designs == 0) return size;
    const std::vector<study::Column> columns = index_columns(plan);
    const study::EachRow each = [&](const auto& take) {
        for (const Finished& design : designs) {
            if (core::interrupted()) throw core::Stopped();
            if (!design.place) continue;
            study::Row row = rows.read(*design.place);
            row.index = design.index;  // a list of profiles may have grown since
            take(row);
        }
    };
    write_study_file(plan, output.path());
    study::write_csv(output.path() / "index.csv", columns, each);
    study::write_sqlite(output.path() / "index.sqlite", columns, each);
    report::write_study_page(output.path() / "index.html", plan.study(), columns, each);
    output.commit();
    return size;
}

Cost usual_cost(study::Outputs outputs) {
    switch (outputs) {
        case study::Outputs::kFigures:
            return {0.11, 3e3};
        case study::Outputs::kMeshes:
            return {0.21, 2.8e6};
        case study::Outputs::kAll:
            return {2.4, 8.5e6};
    }
    return {};
}

int exit_code(const StudyResult& result) {
    if (result.interrupted) return 130;
    if (result.failed > 0) return 3;
    return result.bad_input > 0 ? 2 : 0;
}

core::OutputFolder study_folder(const study::Plan& plan, const fs::path& out, bool force, const std::string& command,
                                std::vector<std::string> files) {
    const study::Study& study = plan.study();
    return {out,
            study.name,
            {.command = command,
             .source = study.varies() ? study.file : study.profiles.front(),
             .force = force,
             .files = std::move(files),
             .stays = true}};
}

void write_study_file(const study::Plan& plan, const fs::path& folder) {
    const study::Study& study = plan.study();
    std::string text;
    if (study.varies())
        text = core::read_file(study.file);
    else
        for (const fs::path& profile : study.profiles) text += "# " + profile.string() + "\n";
    core::write_file(folder / "study.toml", text);
}

core::OutputFolder claim_study_folder(const study::Plan& plan, const fs::path& out, bool force) {
    core::OutputFolder output = study_folder(plan, out, force);
    const auto place = output.find();
    if (!place || place->kind(core::kManifestName) == core::OpenFolder::Kind::kNone) {
        write_study_file(plan, output.path());
        output.commit();
    }
    return output;
}

}  // namespace fusee::batch
