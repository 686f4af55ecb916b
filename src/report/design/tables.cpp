#include <fmt/format.h>

#include <algorithm>

#include "design/page.h"
#include "page/html.h"

namespace fusee::report {

namespace {

std::string tag(core::Severity severity) {
    switch (severity) {
        case core::Severity::kPass:
            return "<span class=\"tag pass-tag\">\u2713 pass</span>";
        case core::Severity::kNotJudged:
            return "<span class=\"tag unjudged-tag\">? not judged</span>";
        case core::Severity::kWarning:
            return "<span class=\"tag review-tag\">! review</span>";
        case core::Severity::kError:
            return "<span class=\"tag required-tag\">\u2715 change</span>";
    }
    return "";
}

/// "199 mm^2" with a raised two.
std::string with_unit(double value, std::string unit) {
    if (unit.ends_with("^2")) unit.replace(unit.size() - 2, 2, "\u00b2");
    return number(value) + (unit.empty() ? "" : " " + escape(unit));
}

std::vector<Cell> finding_row(const NumberedFinding& n) {
    const core::Finding& f = n.finding;
    std::string text = escape(f.what);
    if (!f.suggestion.empty()) text += "<br><span class=\"fix\">" + escape(f.suggestion) + "</span>";
    if (!f.source.empty()) text += "<br><span class=\"faint\">" + escape(f.source) + "</span>";
    const std::string bound = f.bound == core::Bound::kAtMost ? "\u2264 " : "\u2265 ";
    return {{fmt::format("{}", n.number), "num"},
            {tag(f.severity), ""},
            {escape(f.rule), "code"},
            {text, ""},
            {with_unit(f.measured, f.unit), "num"},
            {bound + with_unit(f.allowed, f.unit), "num"},
            {escape(f.where.empty() ? n.part : f.where), "faint"}};
}

void add_files(std::vector<std::vector<Cell>>& rows, const std::vector<FileRow>& files) {
    for (const FileRow& file : files)
        rows.push_back({{escape(file.entry.name), "code"},
                        {bytes_text(static_cast<double>(file.bytes)), "num"},
                        {file.entry.triangles > 0 ? fmt::format("{}", file.entry.triangles) : "\u2013", "num"},
                        {file.entry.chordal_error_mm > 0.0 ? number(file.entry.chordal_error_mm) + " mm" : "\u2013", "num"},
                        {fmt::format("<span title=\"{0}\">{0}</span>", escape(file.entry.sha256)), "code"}});
}

}  // namespace

std::vector<NumberedFinding> numbered(const DesignReport& design) {
    std::vector<NumberedFinding> all;
    for (const core::Finding& finding : design.findings) all.push_back({0, "law", finding});
    for (const PartReport& part : design.parts)
        for (const core::Finding& finding : part.findings) all.push_back({0, cam::to_string(part.part->cam.kind), finding});
    for (const PartReport& part : design.mirrored)
        for (const core::Finding& finding : part.findings)
            all.push_back({0, std::string(cam::to_string(part.part->cam.kind)) + " mirrored", finding});
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

namespace {

/// Rules that were not judged, group by group, with the keys that they ask for.
std::string not_judged_block(const std::vector<NumberedFinding>& findings) {
    core::Findings open;
    for (const NumberedFinding& n : findings)
        if (n.finding.severity == core::Severity::kNotJudged) open.push_back(n.finding);
    if (open.empty()) return "";
    std::vector<std::vector<Cell>> rows;
    for (const RuleCounts& group : count_rules(open))
        for (const core::Finding& f : open)
            if (f.rule.starts_with(group.group + "."))
                rows.push_back({{tag(f.severity), ""},
                                {escape(f.rule), "code"},
                                {escape(f.what), ""},
                                {escape(f.suggestion), "code"},
                                {escape(f.where), "faint"}});
    return "<h3 class=\"held\">Not judged</h3><p>" + escape(not_judged_text(open)) +
           ". The profile does not state what these rules need: nothing is known of what they guard against.</p>" +
           html_table({"", "rule", "guards against", "missing", "where"}, rows);
}

}  // namespace

std::string findings_section(const std::vector<NumberedFinding>& findings) {
    if (findings.empty()) return "";
    std::vector<std::vector<Cell>> broken, held;
    for (const NumberedFinding& n : findings) {
        if (core::is_broken(n.finding)) broken.push_back(finding_row(n));
        if (n.finding.severity == core::Severity::kPass) held.push_back(finding_row(n));
    }
    const std::vector<std::string> head{"#", "", "rule", "finding", "measured", "allowed", "where"};
    std::string out =
        "<section><h2>Findings</h2><p>Numbers are those on the drawings. Each rule names the source of its limit; those of cable, springs "
        "and process can be set in the profile.</p>";
    if (!broken.empty()) out += html_table(head, broken);
    out += not_judged_block(findings);
    if (!held.empty())
        out += fmt::format("<h3 class=\"held\">{} rules hold</h3><div class=\"dense\">", held.size()) + html_table(head, held) + "</div>";
    return out + "</section>\n";
}

std::string read_back_section(const DesignReport& design) {
    std::vector<std::vector<Cell>> rows;
    for (const readback::ArmError* e : design.arm_errors())
        rows.push_back({{tag(e->passed() ? core::Severity::kPass : e->when_broken), ""},
                        {escape(e->file), "code"},
                        {escape(e->reader), ""},
                        {number(100.0 * e->worst_relative, 3) + " %", "num"},
                        {"\u2264 " + number(100.0 * e->allowed, 3) + " %", "num"},
                        {number(core::deg_from_rad(e->worst_angle_rad), 4) + " deg", "num"},
                        {fmt::format("{}", e->rows), "num"}});
    if (rows.empty()) return "";
    return "<section><h2>Read back from the files</h2><p>Every file was read again and its lever arm found anew, by rays to the groove's "
           "floor "
           "and a taut cable, with no code of the synthesis.</p>" +
           html_table({"", "file", "reader", "worst arm error", "allowed", "at cam angle", "positions"}, rows) + "</section>\n";
}

std::string files_section(const DesignReport& design) {
    std::vector<std::vector<Cell>> rows;
    for (const PartReport* part : design.sides()) add_files(rows, part->files);
    add_files(rows, design.files);
    if (rows.empty()) return "";
    const std::string sides = design.mirrored.empty() ? ""
                                                      : "<p>Files named _mirrored are the antagonist's: mirror images in the plane of axis "
                                                        "and timing mark, for a torsion spring of the other hand. The law is the same.</p>";
    return "<section><h2>Files</h2>" + sides + html_table({"name", "size", "triangles", "chordal error", "SHA-256"}, rows) + "</section>\n";
}

}  // namespace fusee::report
