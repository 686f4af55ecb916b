#include "data/json.h"

#include "fusee/report/calibration.h"

namespace fusee::report {

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
