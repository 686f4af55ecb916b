#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/coupon/calibration.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/profile/profile.h"

namespace fusee::pipeline {

struct Coupons {
    bool made = false;
    std::filesystem::path folder;  ///< empty when nothing was written
    core::Findings findings;       ///< passes too; a refusal holds the binding limits
    std::vector<FileRow> files;
};
/// The coupons of a profile in `out`/NAME-coupons, complete or not at all: plate, groove ladder and disc as STL and 3MF, disc.json, the
/// empty COUPON.csv and README.md (docs/guides/calibrate.md). They are nominal, without the profile's compensation.
/// A filled COUPON.csv is never replaced, even with `force`.
/// @throws core::InvalidInput; core::IoError, also if the folder may not be written (core::OutputFolder)
[[nodiscard]] Coupons make_coupons(const profile::Profile& profile, const std::filesystem::path& out, bool force = false);

/// The profile's figures that coupons measure.
[[nodiscard]] coupon::Present present_of(const profile::Profile& profile);

/// The calibration that a sheet of coupons gives.
struct CalibrationReport {
    std::string name;         ///< of the sheet
    std::string file_sha256;  ///< of its bytes
    coupon::Calibration calibration;
};

/// The profile with the figures that the calibration changes and "-calibrated" at the end of its name; the rest of the text stays.
/// @param toml the text that `profile` was read from
/// @param file of the new profile
/// @throws core::InvalidInput if the sheet is of another cable than the profile, if the profile holds a radius allowance, which would count
/// the coupons' figures twice, or if a key cannot be inserted
[[nodiscard]] std::string calibrated_profile(const profile::Profile& profile, const std::string& toml, const coupon::Sheet& sheet,
                                             const coupon::Calibration& calibration, const std::filesystem::path& file);

/// The same from an inspected part: the offset of its contour. @throws core::InvalidInput if the profile holds a radius allowance of the
/// part or a cable axis from coupons, which would count the offset twice, or if a key cannot be inserted
[[nodiscard]] std::string inspected_profile(const profile::Profile& profile, const std::string& toml, const coupon::InspectionSheet& sheet,
                                            const coupon::Calibration& calibration, const std::filesystem::path& file);

}  // namespace fusee::pipeline
