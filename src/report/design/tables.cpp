#include <fmt/format.h>

#include <algorithm>

#include "design/page.h"
#include "page/html.h"

namespace fusee::report {

namespace {

const std::vector<std::string> kFindingColumns{"#", "", "rule", "finding", "measured", "allowed", "where"};

/// The section of what a finding is about.
std::string section_of(const NumberedFinding& n) {
    if (n.part.starts_with("k_se")) return "k_se";
    if (n.part.starts_with("k_pe")) return "k_pe";
    return n.finding.rule.starts_with("assembly.") ? "the-joint" : "spring-law";
}

/// A link to the mark on the drawing, or to the section where the place is no point of a part.
Cell where_cell(const NumberedFinding& n) {
    const std::string id = n.finding.place && (n.part == "k_se" || n.part == "k_pe") ? fmt::format("place-{}", n.number) : section_of(n);
    return {link_to(id, n.finding.where.empty() ? n.part : n.finding.where), "faint"};
}

/// A value with its unit, "199 mm^2" with a raised two.
std::string measured_text(double value, std::string unit) {
    if (unit.ends_with("^2")) unit.replace(unit.size() - 2, 2, "\u00b2");
    return number(value) + (unit.empty() ? "" : " " + unit);
}

std::vector<Cell> finding_row(const NumberedFinding& n) {
    const core::Finding& f = n.finding;
    Cell what = plain(f.what);
    if (!f.suggestion.empty()) what.html += "<br><span class=\"fix\">" + escape(f.suggestion.text()) + "</span>";
    if (!f.source.empty()) what.html += "<br><span class=\"faint\">" + escape(f.source) + "</span>";
    return {{std::to_string(n.number), "num", fmt::format("finding-{}", n.number)},
            {tag(f.severity, core::to_string(f.severity)), ""},
            code(f.rule),
            what,
            num(measured_text(f.measured, f.unit)),
            num((f.bound == core::Bound::kAtMost ? "\u2264 " : "\u2265 ") + measured_text(f.allowed, f.unit)),
            where_cell(n)};
}

void add_files(Rows& rows, const std::vector<FileRow>& files) {
    for (const FileRow& file : files)
        rows.push_back({code(file.entry.name),
                        num(bytes_text(static_cast<double>(file.bytes))),
                        num(file.entry.triangles > 0 ? std::to_string(file.entry.triangles) : "\u2013"),
                        num(file.entry.chordal_error_mm > 0.0 ? number(file.entry.chordal_error_mm) + " mm" : "\u2013"),
                        {fmt::format("<span title=\"{0}\">{0}</span>", escape(file.entry.sha256)), "code"}});
}

/// Rules that were not judged, by group, with the keys that they need.
std::string not_judged_block(const std::vector<NumberedFinding>& findings) {
    core::Findings open;
    for (const NumberedFinding& n : findings)
        if (n.finding.severity == core::Severity::kNotJudged) open.push_back(n.finding);
    if (open.empty()) return "";
    Rows rows;
    for (const RuleCounts& group : count_rules(open))
        for (const NumberedFinding& n : findings)
            if (const core::Finding& f = n.finding; f.severity == core::Severity::kNotJudged && f.rule.starts_with(group.group + "."))
                rows.push_back({{tag(f.severity, "not judged"), "", fmt::format("finding-{}", n.number)},
                                code(f.rule),
                                plain(f.what),
                                code(f.suggestion.text()),
                                where_cell(n)});
    return subheading("Not judged") +
           paragraph(not_judged_text(open) +
                     ". The profile lacks the data of these rules: these failures are neither found nor excluded.") +
           card_table("Rules that were not judged", {"", "rule", "guards against", "missing", "where"}, rows);
}

}  // namespace

std::vector<NumberedFinding> numbered(const DesignReport& design) {
    std::vector<NumberedFinding> all;
    const auto add = [&all](const core::Findings& findings, const std::string& part) {
        for (const core::Finding& finding : findings) all.push_back({0, part, finding});
    };
    add(design.findings, "law");
    for (const PartReport& part : design.parts) add(part.findings, cam::to_string(part.part->cam.kind));
    for (const PartReport& part : design.mirrored) add(part.findings, std::string(cam::to_string(part.part->cam.kind)) + " mirrored");
    return ranked(std::move(all));
}

std::vector<NumberedFinding> ranked(std::vector<NumberedFinding> all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const NumberedFinding& a, const NumberedFinding& b) { return a.finding.severity > b.finding.severity; });
    for (std::size_t i = 0; i < all.size(); ++i) all[i].number = static_cast<int>(i) + 1;
    return all;
}

std::vector<Marker> markers_of(const std::vector<NumberedFinding>& findings, const std::string& part) {
    std::vector<Marker> markers;
    for (const NumberedFinding& n : findings)
        if (n.part == part && n.finding.place)
            markers.push_back({n.number, n.finding.severity, n.finding.place->point_mm[0], n.finding.place->point_mm[1],
                               fmt::format("{}. {}: {}", n.number, n.finding.rule, n.finding.what)});
    return markers;
}

std::string findings_section(const std::vector<NumberedFinding>& findings) {
    if (findings.empty()) return "";
    Rows broken;
    for (const NumberedFinding& n : findings)
        if (core::is_broken(n.finding)) broken.push_back(finding_row(n));
    std::string out = broken.empty() ? paragraph("No error and no warning.")
                                     : paragraph("The numbers are those on the drawings. Each rule names the source of its limit.") +
                                           card_table("Errors and warnings", kFindingColumns, broken);
    return section("Findings", out + not_judged_block(findings));
}

std::string passed_section(const std::vector<NumberedFinding>& findings) {
    Rows passed;
    for (const NumberedFinding& n : findings)
        if (n.finding.severity == core::Severity::kPass) passed.push_back(finding_row(n));
    if (passed.empty()) return "";
    return folded_section(
        "Rules passed", std::to_string(passed.size()),
        paragraph("The profile can set the limits of cable, springs and process.") + dense_table("Rules passed", kFindingColumns, passed));
}

std::string read_back_section(const DesignReport& design) {
    Rows rows;
    for (const readback::ArmError* e : design.arm_errors()) {
        const core::Severity severity = e->passed() ? core::Severity::kPass : e->when_broken;
        rows.push_back({{tag(severity, core::to_string(severity)), ""},
                        code(e->file),
                        plain(e->mirror_of.empty() ? e->reader : "mirror image of " + e->mirror_of + ", " + e->reader),
                        num(number(100.0 * e->worst_relative, 3) + " %"),
                        num("\u2264 " + number(100.0 * e->allowed, 3) + " %"),
                        num(deg(e->worst_angle_rad) + " deg"),
                        num(std::to_string(e->rows))});
    }
    if (rows.empty()) return "";
    return folded_section(
        "Read back from the files", counted(rows.size(), "reading"),
        paragraph("Another library read every file. Rays to the groove floor and a taut cable give the lever arm, without any "
                  "code of the synthesis. A file whose bytes are the exact mirror image of one that was read has its arms.") +
            html_table("Arm errors of every file and reader",
                       {"", "file", "reader", "worst arm error", "allowed", "at cam angle", "positions"}, rows));
}

std::string files_section(const DesignReport& design) {
    Rows rows;
    for (const PartReport* part : design.sides()) add_files(rows, part->files);
    add_files(rows, design.files);
    if (rows.empty()) return "";
    const std::string sides = design.mirrored.empty()
                                  ? ""
                                  : paragraph(
                                        "Files named _mirrored are the antagonist's parts: mirror images in the plane of axis and timing "
                                        "mark, for a torsion spring of the other hand. The law is the same.");
    return folded_section("Files", counted(rows.size(), "file") + ", with SHA-256",
                          sides + html_table("Files with size and hash", {"name", "size", "triangles", "chordal error", "SHA-256"}, rows));
}

}  // namespace fusee::report
