#include <fmt/format.h>

#include <algorithm>

#include "design/page.h"
#include "page/html.h"

namespace fusee::report {

namespace {

const std::vector<std::string> kFindingColumns{"#", "", "rule", "finding", "measured", "allowed", "where"};

/// A value with its unit, "199 mm^2" with a raised two.
std::string measured_text(double value, std::string unit) {
    if (unit.ends_with("^2")) unit.replace(unit.size() - 2, 2, "\u00b2");
    return number(value) + (unit.empty() ? "" : " " + unit);
}

std::vector<Cell> finding_row(const NumberedFinding& n) {
    const core::Finding& f = n.finding;
    Cell what = plain(f.what);
    if (!f.suggestion.empty()) what.html += "<br><span class=\"fix\">" + escape(f.suggestion) + "</span>";
    if (!f.source.empty()) what.html += "<br><span class=\"faint\">" + escape(f.source) + "</span>";
    return {num(std::to_string(n.number)),
            {tag(f.severity, core::to_string(f.severity)), ""},
            code(f.rule),
            what,
            num(measured_text(f.measured, f.unit)),
            num((f.bound == core::Bound::kAtMost ? "\u2264 " : "\u2265 ") + measured_text(f.allowed, f.unit)),
            faint(f.where.empty() ? n.part : f.where)};
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
        for (const core::Finding& f : open)
            if (f.rule.starts_with(group.group + "."))
                rows.push_back({{tag(f.severity, "not judged"), ""}, code(f.rule), plain(f.what), code(f.suggestion), faint(f.where)});
    return subheading("Not judged") +
           paragraph(not_judged_text(open) +
                     ". The profile lacks the data of these rules: these failures are neither found nor excluded.") +
           html_table({"", "rule", "guards against", "missing", "where"}, rows);
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
    Rows broken, passed;
    for (const NumberedFinding& n : findings) {
        if (core::is_broken(n.finding)) broken.push_back(finding_row(n));
        if (n.finding.severity == core::Severity::kPass) passed.push_back(finding_row(n));
    }
    std::string out = paragraph(
        "The numbers are those on the drawings. Each rule names the source of its limit. The profile can set the limits of cable, springs "
        "and process.");
    if (!broken.empty()) out += html_table(kFindingColumns, broken);
    out += not_judged_block(findings);
    if (!passed.empty()) out += subheading(fmt::format("{} rules passed", passed.size())) + dense_table(kFindingColumns, passed);
    return section("Findings", out);
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
    return section("Read back from the files",
                   paragraph("Another library read every file. Rays to the groove floor and a taut cable give the lever arm, without any "
                             "code of the synthesis. A file whose bytes are the exact mirror image of one that was read has its arms.") +
                       html_table({"", "file", "reader", "worst arm error", "allowed", "at cam angle", "positions"}, rows));
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
    return section("Files", sides + html_table({"name", "size", "triangles", "chordal error", "SHA-256"}, rows));
}

}  // namespace fusee::report
