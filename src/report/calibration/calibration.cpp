#include "fusee/report/calibration.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/provenance.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

std::string shown(const coupon::Figure& f, double si) { return std::isnan(si) ? "unknown" : fmt::format("{:.4g}", si * f.per_unit); }

std::string line_of(const coupon::Figure& f) {
    const std::string range = fmt::format("{} to {}", shown(f, f.range.low), shown(f, f.range.high));
    const std::string verdict = f.key.empty() ? "" : f.changes() ? "-> " + f.key : "the profile's " + shown(f, f.present) + " stands";
    return fmt::format("{:<15}{:>10} {:<7}{:>24}{:>6}  {}\n", f.id, shown(f, f.value), f.unit, range, f.rows,
                       verdict.empty() ? f.what : verdict);
}

}  // namespace

std::string calibration_json(const CalibrationReport& report) {
    Json j{{"fusee", core::version()}, {"name", report.name}, {"file_sha256", report.file_sha256}};
    j["figures"] = Json::array();
    for (const coupon::Figure& f : report.calibration.figures)
        j["figures"].push_back({{"id", f.id},
                                {"what", f.what},
                                {"value", f.value},
                                {"range", {f.range.low, f.range.high}},
                                {"range_is", f.ladder ? "ladder" : "95 %"},
                                {"rows", f.rows},
                                {"key", f.key.empty() ? Json() : Json(f.key)},
                                {"present", f.present},
                                {"changes", f.changes()}});
    j["unknown"] = Json::array();
    for (const coupon::Unknown& u : report.calibration.unknown) j["unknown"].push_back({{"id", u.id}, {"why", u.why}});
    j["remarks"] = report.calibration.remarks;
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string calibration_text(const CalibrationReport& report) {
    std::string text;
    if (!report.calibration.figures.empty())
        text = fmt::format("{:<15}{:>10} {:<7}{:>24}{:>6}\n", "figure", "value", "unit", "95 %, or ladder", "rows");
    for (const coupon::Figure& f : report.calibration.figures) text += line_of(f);
    for (const coupon::Unknown& u : report.calibration.unknown) text += fmt::format("not known: {}: {}\n", u.id, u.why);
    for (const std::string& remark : report.calibration.remarks) text += "- " + remark + "\n";
    return text;
}

}  // namespace fusee::report
