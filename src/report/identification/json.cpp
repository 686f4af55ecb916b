#include <nlohmann/json.hpp>

#include "fusee/core/provenance.h"
#include "fusee/report/identification.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json range(const core::Range& r) { return Json::array({r.low, r.high}); }

Json line_json(const gap::FrictionLine& line) {
    return {{"group", line.group},
            {"rows", line.rows},
            {"mu", line.mu},
            {"mu_95", range(line.mu_95)},
            {"constant_Nm", line.constant},
            {"constant_95_Nm", range(line.constant_95)},
            {"scatter_Nm", line.scatter},
            {"r_squared", line.r_squared},
            {"through_zero_mu", line.through_zero_mu},
            {"through_zero_mu_95", range(line.through_zero_mu_95)},
            {"robust_mu", line.robust_mu},
            {"robust_constant_Nm", line.robust_constant},
            {"outlier_rows", line.outliers}};
}

Json repeat_json(const gap::FrictionReport::Repeat& r) {
    return {{"side", r.side},
            {"direction", r.backdrive ? "backdrive" : "drive"},
            {"motor_torque_Nm", r.motor_torque},
            {"rows", r.rows},
            {"mean_load_Nm", r.mean_load},
            {"mean_friction_Nm", r.mean_friction},
            {"deviation_Nm", r.deviation}};
}

}  // namespace

std::string identification_json(const Identification& identification) {
    const gap::FrictionReport& friction = identification.friction;
    Json j;
    j["fusee"] = core::version();
    j["name"] = identification.name;
    j["file_sha256"] = identification.file_sha256;
    j["law"] = nullptr;
    if (friction.law) j["law"] = {{"gear_friction", friction.law->mu}, {"gear_friction_constant_Nm", friction.law->constant}};
    j["remarks"] = Json::array();
    for (const gap::FrictionRemark& remark : friction.remarks)
        j["remarks"].push_back({{"id", remark.id}, {"text", remark.text}, {"p", remark.p}});
    j["scatter_growth"] = friction.scatter_growth;
    j["lines"] = Json::array();
    for (const gap::FrictionLine& line : friction.lines) j["lines"].push_back(line_json(line));
    j["repeats"] = Json::array();
    for (const gap::FrictionReport::Repeat& r : friction.repeats) j["repeats"].push_back(repeat_json(r));
    // A broken byte in a side's name is replaced rather than losing the file.
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::report
