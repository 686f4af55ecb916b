#include "fusee/report/calibration.h"

#include <fmt/format.h>

#include <cmath>

#include "data/json.h"

namespace fusee::report {

namespace {

std::string in_unit(const coupon::Figure& f, double si) { return std::isnan(si) ? "unknown" : fmt::format("{:.4g}", si * f.per_unit); }

std::string figure_line(const coupon::Figure& f) {
    const std::string range = fmt::format("{} to {}", in_unit(f, f.range.low), in_unit(f, f.range.high));
    const std::string verdict = f.key.empty() ? "" : f.changes() ? "-> " + f.key : "keeps the profile's " + in_unit(f, f.present);
    return fmt::format("{:<15}{:>10} {:<7}{:>24}{:>6}  {}\n", f.id, in_unit(f, f.value), f.unit, range, f.rows,
                       verdict.empty() ? f.what : verdict);
}

}  // namespace

std::string calibration_text(const CalibrationReport& report) {
    std::string text;
    if (!report.calibration.figures.empty())
        text = fmt::format("{:<15}{:>10} {:<7}{:>24}{:>6}\n", "figure", "value", "unit", "95 %, or ladder", "rows");
    for (const coupon::Figure& f : report.calibration.figures) text += figure_line(f);
    for (const coupon::Unknown& u : report.calibration.unknown) text += fmt::format("unknown: {}: {}\n", u.id, u.why);
    for (const core::Finding& f : report.calibration.findings) text += to_line(f) + "\n";
    for (const std::string& remark : report.calibration.remarks) text += "- " + remark + "\n";
    return text;
}

std::string calibration_json(const CalibrationReport& report) {
    const coupon::Calibration& found = report.calibration;
    return json_text({{"fusee", core::version()},
                      {"name", report.name},
                      {"file_sha256", report.file_sha256},
                      {"figures", json_list(found.figures,
                                            [](const coupon::Figure& f) {
                                                return Json{{"id", f.id},
                                                            {"what", f.what},
                                                            {"value", f.value},
                                                            {"range", range_json(f.range)},
                                                            {"range_is", f.ladder ? "ladder" : "95 %"},
                                                            {"rows", f.rows},
                                                            {"key", f.key.empty() ? Json() : Json(f.key)},
                                                            {"present", f.present},
                                                            {"changes", f.changes()}};
                                            })},
                      {"unknown", json_list(found.unknown,
                                            [](const coupon::Unknown& u) {
                                                return Json{{"id", u.id}, {"why", u.why}};
                                            })},
                      {"findings", findings_json(found.findings)},
                      {"remarks", found.remarks}});
}

}  // namespace fusee::report
