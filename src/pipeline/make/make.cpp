#include "fusee/pipeline/make.h"

#include <algorithm>
#include <future>
#include <iterator>
#include <numeric>
#include <set>

#include "evaluate/each_part.h"
#include "export/whole.h"
#include "fusee/actuator/dead_band.h"
#include "fusee/core/kept.h"
#include "fusee/core/lists.h"
#include "fusee/core/progress.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/as_exported.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/spring/potential.h"

namespace fusee::pipeline {

namespace {

constexpr int kDraws = 200;  // joints sampled for the error budget

constexpr std::size_t kDeadBandLevels = 41;
constexpr std::size_t kLawSamples = 401;

/// The table's rows with the springs smoothed from them; none for other kinds of law.
std::optional<SmoothedTable> smoothed_table(const profile::LawSpec& law) {
    const auto* pair = std::get_if<profile::TablePair>(&law.curves);
    if (pair == nullptr) return std::nullopt;
    const auto series = spring::make_tabulated(pair->angle, pair->series, pair->smoothing);
    const auto parallel = spring::make_tabulated(pair->angle, pair->parallel, pair->smoothing);
    SmoothedTable table{pair->file.string(), {}};
    for (std::size_t i = 0; i < pair->angle.size(); ++i)
        table.rows.push_back(
            {pair->angle[i], pair->series[i], pair->parallel[i], series->force(pair->angle[i]), parallel->force(pair->angle[i])});
    return table;
}

LawReport law_report(const ResolvedDesign& design) {
    const profile::LawSpec& spec = design.profile.law;
    LawReport law;
    law.samples = spring::sample_by_load(*design.law(), kLawSamples);
    law.design_loads = design.design_loads;
    law.lead_in_travel = spec.lead_in_travel;
    if (!design.profile.is_spring()) law.stiction_loads = design.actuator.loads();
    law.table = smoothed_table(spec);
    if (const auto* options = std::get_if<spring::StictionLawOptions>(&spec.curves))
        law.least_feasible_start = spring::least_feasible_load(*options);
    return law;
}

/// Announces external programs, which take seconds for each part.
void announce(const profile::Profile& profile, const MakeOptions& options) {
    if (!options.note) return;
    std::set<std::string> notes;  // a program that several formats need is announced once
    if (options.via == Via::kOpenScad) notes.insert(formats::kOpenScadRenders);
    for (const formats::Format& format : formats::all_formats())
        if (profile.outputs.has(format.name) && *format.note != '\0') notes.insert(format.note);
    for (const std::string& note : notes) options.note(profile.name + ": " + note);
}

void ask_to_stop(const MakeOptions& options) {
    if (options.stop && options.stop()) throw core::Stopped();
}

using Parts = std::vector<Pair>;  // as parts_of

/// Refusal: the law's findings and those of the parts.
core::Outcome<Parts> joined(const ResolvedDesign& design, std::vector<EvaluatedPart> evaluated, bool both_sides) {
    core::Findings refusal = design.findings;
    for (const EvaluatedPart& part : evaluated) core::append(refusal, part.findings);
    Parts parts;
    for (EvaluatedPart& part : evaluated) {
        auto made = designed(std::move(part));
        if (!made) return refusal;
        parts.push_back(pair_of(std::move(made).value(), both_sides));
    }
    return parts;
}

core::Outcome<Parts> design_parts(const ResolvedDesign& design, bool both_sides) {
    const auto evaluated = [](const AskedPart& part) { return evaluate_part(part.kind, *part.design, Depth::kSolid); };
    return joined(design, each_part(parts_of(design), evaluated), both_sides);
}

std::vector<std::size_t> places_of(const std::vector<AskedPart>& parts) {
    std::vector<std::size_t> places(parts.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
}

/// All that a joint's part follows from: the profile without its name, the other part and the formats. Empty: rows of a file, too, or no
/// joint.
std::string source_of(cam::PartKind kind, const profile::Profile& profile) {
    const auto& law = profile.law.curves;
    if (profile.is_spring() || std::holds_alternative<profile::TablePair>(law) || std::holds_alternative<profile::DeadBandSpec>(law) ||
        !profile.rig.gear_friction_table.x.empty())
        return "";
    const std::string own = to_string(kind);
    std::string source = own + (profile.places.contains(own + ".path.margin_deg") ? ", anchor in its place\n" : "\n"), table;
    for (const std::string& line : core::pieces_of<std::string>(profile::to_toml(profile), "\n")) {
        if (line.starts_with('[')) table = line.substr(1, line.find_first_of(".]") - 1);
        const bool of_part = table == "k_se" || table == "k_pe";
        if (of_part ? table == own : !table.empty() && table != "outputs") source += line + '\n';
    }
    return source;
}

/// Solid parts of the designs before, which those of a study share that differ in keys of the other part. Their paths are known where the
/// files of the design before asked for them.
core::Kept<std::string, EvaluatedPart>& known_parts() {
    constexpr std::size_t kParts = 4;
    static core::Kept<std::string, EvaluatedPart> parts(kParts);
    return parts;
}

void keep_known(const EvaluatedPart& part, const ResolvedDesign& design) {
    constexpr std::size_t kMostTriangles = 100000;
    if (part.reached < Depth::kSolid || part.body->mesh.triangles.size() > kMostTriangles) return;
    if (std::string source = source_of(part.kind, design.profile); !source.empty()) known_parts().keep(std::move(source), part);
}

/// The same, but a part that the rules without a mesh refuse ends the design before any part is meshed. Refusal: then the findings of
/// these rules only.
core::Outcome<Parts> design_parts_outlines_first(const ResolvedDesign& design, bool both_sides) {
    const std::vector<AskedPart> asked = parts_of(design);
    auto outlined = each_part(asked, [](const AskedPart& part) {
        const std::string source = source_of(part.kind, part.design->profile);
        auto known = source.empty() ? std::nullopt : known_parts().find(source);
        return known ? *std::move(known) : evaluate_part(part.kind, *part.design, Depth::kOutline);
    });
    core::Findings refusal;
    for (const EvaluatedPart& part : outlined)
        if (core::any_error(part.findings)) core::append(refusal, part.findings);
    if (!refusal.empty()) {
        refusal.insert(refusal.begin(), design.findings.begin(), design.findings.end());
        return refusal;
    }
    return joined(design,
                  each_part(places_of(asked),
                            [&](std::size_t place) {
                                EvaluatedPart part = std::move(outlined[place]);
                                if (part.reached == Depth::kSolid) return part;
                                deepen(part, *asked[place].design, Depth::kSolid);
                                keep_known(part, *asked[place].design);
                                return part;
                            }),
                  both_sides);
}

/// Where both spools of two cables stand on their shaft: the one that pulls back on top of the other.
std::vector<std::optional<OnShaft>> on_shaft(const ResolvedDesign& design, const Parts& parts) {
    std::vector<std::optional<OnShaft>> all(parts.size());
    if (design.ways.empty()) return all;
    const core::Range angles = law_angles(design);
    const double top = solid::bounding_box(parts[0].agonist->part.mesh).high_mm[2],
                 bottom = solid::bounding_box(parts[1].agonist->part.mesh).low_mm[2];
    all[0] = OnShaft{.first_rad = angles.low, .sense = 1, .height_mm = 0.0};
    all[1] = OnShaft{.first_rad = angles.high, .sense = -1, .height_mm = top - bottom};
    return all;
}

/// Both sides of both parts, each part on its thread, and all on one plate. @return the exact solids of their STEP files
ExactSolids export_parts(DesignReport& report, const Parts& parts, const ResolvedDesign& design, const profile::Profile& profile, Via via,
                         const fs::path& folder) {
    const std::vector<AskedPart> asked = parts_of(design);
    const std::vector<std::optional<OnShaft>> shafts = on_shaft(design, parts);
    auto exported = each_part(places_of(asked), [&](std::size_t place) {
        const profile::Profile& own = design.ways.empty() ? profile : asked[place].design->profile;
        return export_pair(parts[place], own, report.provenance, via, folder, shafts[place]);
    });
    std::vector<ExportedPart> all;
    for (std::vector<ExportedPart>& sides : exported) std::move(sides.begin(), sides.end(), std::back_inserter(all));
    PlateFiles plate = write_plate(all, profile, report.provenance, folder);
    ExactSolids exact;
    for (ExportedPart& one : all) {
        if (one.exact) exact.emplace(one.name, *one.exact);
        (one.mirrored ? report.mirrored : report.parts).push_back(std::move(one.report));
    }
    core::append(report.findings, plate.findings);
    report.files = std::move(plate.files);
    report.plate_errors = std::move(plate.arm_errors);
    return exact;
}

void export_joint(DesignReport& report, Assembled joint, const ExactSolids& parts, const profile::Profile& profile,
                  const fs::path& folder) {
    core::append(report.findings, joint.findings);
    report.assembly = std::move(joint.assembly);
    if (!report.assembly) return;
    JointFiles written = write_joint(*report.assembly, parts, profile, report.provenance, folder);
    core::append(report.findings, written.findings);
    report.files.insert(report.files.end(), written.files.begin(), written.files.end());
}

Assembled assemble_pairs(const ResolvedDesign& design, const Parts& parts) {
    const auto part = [](const Pair& pair) { return std::shared_ptr<const solid::Part>(pair.agonist, &pair.agonist->part); };
    if (design.profile.is_spring()) return {};  // no joint
    return assemble(design, part(parts[0]), part(parts[1]));
}

/// A design with its law alone. Refusal: the law's.
core::Outcome<MadeDesign> start_design(const profile::Profile& profile) {
    auto resolved = resolve(profile);
    if (!resolved) return resolved.refusal();
    MadeDesign made{std::move(resolved).value(), {}, {}};
    made.report.provenance = {profile.name, profile.sha256, ""};
    made.report.actuator = made.resolved.actuator;
    made.report.findings = made.resolved.findings;
    return made;
}

}  // namespace

core::Outcome<MadeDesign> make_parts(const profile::Profile& profile, core::OutputFolder& output, const MakeOptions& options) {
    require_parts(profile);
    require_sliceable(profile);
    const auto begin = [&options](const char* stage) {
        if (options.stage) options.stage(stage);
    };
    begin("spring law");
    auto law = start_design(profile);
    if (!law) return law;
    MadeDesign made = std::move(law).value();
    made.resolved.profile.assembly.frame &= options.frame;
    const ResolvedDesign& design = made.resolved;
    const bool joint = !profile.is_spring();
    std::future<Simulation> simulation;  // needs no part
    if (joint) simulation = std::async(std::launch::async | std::launch::deferred, [&] { return simulate(design); });
    begin("cams, solids and rules");
    const auto parts = design_parts(design, profile.outputs.pair);
    if (!parts) return parts.refusal();
    ask_to_stop(options);

    DesignReport& report = made.report;
    report.provenance.options = std::string("via=") + to_string(options.via) + (options.frame ? "" : " no-frame");
    report.law = law_report(design);
    if (joint) report.dead_band = actuator::dead_band_curve(design.actuator, kDeadBandLevels);
    auto assembled = std::async(std::launch::async | std::launch::deferred, [&] { return assemble_pairs(design, *parts); });
    announce(profile, options);
    begin("part files and read-back");
    const ExactSolids exact = export_parts(report, *parts, design, profile, options.via, output.path());
    if (!design.ways.empty()) judge_both_ways(report, design);
    ask_to_stop(options);
    if (joint) report.as_exported = as_exported(design, report);
    begin("joint and its files");
    export_joint(report, assembled.get(), exact, profile, output.path());
    begin("simulation and error budget");
    if (joint) made.simulation = simulation.get();
    report.headline = headline_of(design, made.simulation, report.parts, kDraws);
    return made;
}

core::Outcome<MadeDesign> make_figures(const profile::Profile& profile, core::OutputFolder* output) {
    require_parts(profile);
    if (output != nullptr) require_sliceable(profile);
    auto law = start_design(profile);
    if (!law) return law;
    MadeDesign made = std::move(law).value();
    const ResolvedDesign& design = made.resolved;
    const auto parts = design_parts_outlines_first(design, output != nullptr && profile.outputs.pair);
    if (!parts) return parts.refusal();
    DesignReport& report = made.report;
    if (output != nullptr) {
        report.provenance.options = std::string("via=") + to_string(Via::kCgal);
        (void)export_parts(report, *parts, design, profile, Via::kCgal, output->path());
        if (!design.ways.empty()) judge_both_ways(report, design);
        if (!profile.is_spring()) report.as_exported = as_exported(design, report);
    } else {
        const std::vector<AskedPart> asked = parts_of(design);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            report.parts.push_back(without_files((*parts)[i].agonist, asked[i].design->spec(asked[i].kind).spring));
            report.parts.back().name = asked[i].design->profile.name_of(asked[i].kind);
        }
    }
    if (!profile.is_spring()) made.simulation = headline_simulation(design);
    report.headline = headline_of(design, made.simulation, report.parts);
    return made;
}

std::vector<std::string> sheets_of(const profile::Profile& profile) {
    if (!profile.outputs.has("drawing")) return {};
    std::vector<std::string> names;
    for (const char* side : {"", "_mirrored"})
        for (const cam::PartKind kind : profile.part_kinds())
            if (*side == '\0' || profile.outputs.pair) names.push_back(profile.table_of(kind) + side + "_inspection.csv");
    if (profile.has_two_cables()) names.emplace_back("cam_back_inspection.csv");
    return names;
}

}  // namespace fusee::pipeline
