#include <functional>
#include <optional>

#include "arguments.h"
#include "fusee/pipeline/coupons.h"
#include "fusee/pipeline/design.h"
#include "fusee/report/calibration.h"
#include "places.h"

namespace fusee::app {

namespace {

constexpr std::size_t kLargestSheet = 10'000'000;  // bytes

struct CalibrateArguments {
    fs::path sheet, profile, corrected;
    bool force = false;
    std::vector<std::string> columns;
};

void require_pair(const CalibrateArguments& arguments) {
    if (arguments.corrected.empty()) return;
    if (arguments.profile.empty())
        throw core::InvalidInput("--profile", "missing", "the profile of the coupons, together with --write-profile");
    require_new_profile("--write-profile", arguments.corrected, arguments.profile, arguments.force);
}

/// What a sheet says, and the text of the profile that it gives.
struct Read {
    coupon::Calibration calibration;
    std::function<std::string(const profile::Profile&, const std::string& toml)> corrected;
};

Read read_sheet(const std::string& bytes, const CalibrateArguments& arguments, const coupon::Present& present) {
    const std::string file = arguments.sheet.string();
    const fs::path& out = arguments.corrected;
    const core::CsvMapping columns = core::CsvMapping::of(arguments.columns);
    if (coupon::is_inspection(bytes, columns)) {
        const coupon::InspectionSheet sheet = coupon::parse_inspection(bytes, file, columns);
        const coupon::Calibration found = coupon::inspect_contour(sheet, present);
        return {found,
                [=](const auto& profile, const auto& toml) { return pipeline::inspected_profile(profile, toml, sheet, found, out); }};
    }
    const coupon::Sheet sheet = coupon::parse_sheet(bytes, file, columns);
    const coupon::Calibration found = coupon::calibrate(sheet, present, file);
    return {found, [=](const auto& profile, const auto& toml) { return pipeline::calibrated_profile(profile, toml, sheet, found, out); }};
}

int calibrate(const CalibrateArguments& arguments, Reply& reply) {
    require_pair(arguments);
    std::string toml;
    std::optional<profile::Profile> profile;
    if (!arguments.profile.empty()) {
        toml = core::read_file(arguments.profile, profile::kLargestFile);
        profile = profile::parse_profile(toml, arguments.profile);
        with_places(*profile, [&] { pipeline::require_parts(*profile); });
    }
    const std::string bytes = core::read_file(arguments.sheet, kLargestSheet);
    const Read read = read_sheet(bytes, arguments, profile ? pipeline::present_of(*profile) : coupon::Present{});
    const pipeline::CalibrationReport found{arguments.sheet.stem().string(), core::sha256_hex(bytes), read.calibration};
    if (!arguments.corrected.empty()) core::write_file(arguments.corrected, read.corrected(*profile, toml));
    reply.set_all(report::calibration_json(found));
    reply.print(report::calibration_text(found));
    if (!arguments.corrected.empty()) reply.say(fmt::format("written: {}\n", arguments.corrected.string()));
    return found.calibration.figures.empty() ? 1 : 0;
}

}  // namespace

void add_calibrate(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "calibrate", calibrate);
    command->add_option("sheet", arguments->sheet, "COUPON.csv of fusee coupons or k_xx_inspection.csv of fusee make, filled in")
        ->type_name("FILE.csv")
        ->check(reads({FileKind::kCoupons, FileKind::kInspection}, "a filled-in sheet of fusee coupons or fusee make"))
        ->required();
    command->add_option("--profile", arguments->profile, "Profile of the coupons; its present values are compared with the measured ones")
        ->type_name("FILE.toml")
        ->check(reads_profile());
    command->add_option("--write-profile", arguments->corrected, "File of the calibrated profile; needs --profile")->type_name("FILE.toml");
    add_columns(*command, arguments->columns);
    add_force_file(*command, arguments->force);
    command->footer(
        "Example:\n  fusee calibrate profiles/examples/coupon.csv --profile profiles/pnrvsa.toml --write-profile /tmp/calibrated.toml\n\n"
        "Exit code: 0 at least one value is found, 1 no value is found, 2 bad input (file, line and column are named), 3 internal error.");
}

}  // namespace fusee::app
