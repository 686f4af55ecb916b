#include "fusee/batch/batch.h"

#include <chrono>

#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/check.h"
#include "fusee/report/report.h"
#include "run_each.h"

namespace fusee::batch {

namespace {

/// Keeps the time of each stage from its beginning to that of the next.
class Clock {
public:
    explicit Clock(std::vector<Stage>& stages) : stages_(stages) {}
    void begin(const char* stage) {
        end();
        stages_.push_back({stage, 0.0});
    }
    void end() {
        const auto now = std::chrono::steady_clock::now();
        if (!stages_.empty()) stages_.back().seconds = std::chrono::duration<double>(now - began_).count();
        began_ = now;
    }

private:
    std::vector<Stage>& stages_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

/// The folder of a design's files, checked before the work.
core::OutputFolder design_folder(const OutFolder& folder, const profile::Profile& profile) {
    std::vector<std::string> files{"report.json", "report.html"};
    for (const char* name : {"springs.csv", "simulation.json", "simulation.html", "dead_band.csv"})
        if (!profile.is_spring()) files.emplace_back(name);
    if (profile.is_spring()) files.emplace_back("law.csv");
    return {folder.out,
            profile.name,
            {.command = "make",
             .source = profile.file,
             .force = folder.force,
             .files = files,
             .sheets = pipeline::sheets_of(profile),
             .stays = true}};
}

/// What is printed was tried: the suggestions of all findings.
void judge_suggestions(pipeline::DesignReport& report, const profile::Profile& profile) {
    pipeline::judge_suggestions(report.findings, profile);
    for (auto* side : {&report.parts, &report.mirrored})
        for (pipeline::PartReport& part : *side) pipeline::judge_suggestions(part.findings, profile);
}

}  // namespace

MakeResult make(const profile::Profile& profile, const OutFolder& folder, const pipeline::MakeOptions& options) {
    pipeline::require_parts(profile);
    core::OutputFolder output = design_folder(folder, profile);
    MakeResult result;
    result.name = profile.name;
    Clock clock(result.stages);
    pipeline::MakeOptions timed = options;
    timed.stage = [&](const char* stage) {
        clock.begin(stage);
        if (options.stage) options.stage(stage);
    };
    auto made = pipeline::make_parts(profile, output, timed);
    if (made) {
        pipeline::MadeDesign judged = std::move(made).value();
        judge_suggestions(judged.report, profile);
        made = std::move(judged);
    }
    result.findings = made ? made->report.all_findings() : made.refusal();
    if (!made) pipeline::judge_suggestions(result.findings, profile);
    if (made) {
        if (options.stop && options.stop()) throw core::Stopped();
        result.headline = made->report.headline;
        result.file_errors = made->report.file_errors();
    }
    if (made && !core::any_error(result.findings)) {  // else a file does not carry the law: the files go
        timed.stage("reports");
        report::write_design(*made, output.path());
        output.commit();
        result.made = true;
        result.folder = output.target();
        const actuator::Actuator& joint = made->resolved.actuator;
        if (!profile.is_spring()) result.dead_band_peak_deg = core::deg_from_rad(actuator::dead_band(joint, joint.peak_torque).exact_width);
        result.design = std::move(made).value();
    }
    clock.end();
    return result;
}

std::vector<Row> make_all(const std::vector<fs::path>& profiles, const OutFolder& folder, unsigned jobs, pipeline::Via via, bool frame) {
    const bool one = profiles.size() == 1;
    core::Progress progress("make", one ? kStages : profiles.size(), one ? core::Progress::Of::kStages : core::Progress::Of::kItems);
    pipeline::MakeOptions watched{.via = via, .frame = frame, .note = [&](const std::string& what) { progress.note(what); }};
    if (one) watched.stage = [&](const char* stage) { progress.advance(stage); };
    std::vector<Row> rows(profiles.size());
    const auto work = [&](const profile::Profile& profile, std::size_t place) {
        rows[place].result = make(profile, folder, watched);
        rows[place].result.design.reset();  // many designs would fill the memory
        return rows[place].result.made;
    };
    const std::vector<Ended> ended = run_each(profiles, work, jobs, one ? nullptr : &progress);
    return joined(std::move(rows), ended);
}

}  // namespace fusee::batch
