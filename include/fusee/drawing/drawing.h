#pragma once
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/coupon/calibration.h"
#include "fusee/drawing/sheet.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"

/// Example:
/// @code
/// const drawing::Subject subject{part, spring, p.cable, p.process, p.name, "k_se", provenance.line(), p.title};  // p: the profile
/// const std::vector<drawing::Sheet> sheets = drawing::draw(subject);
/// drawing::write_svg("out/mine/k_se_drawing", sheets);  // k_se_drawing.svg, k_se_drawing_2.svg, ...
/// core::write_file("out/mine/k_se_drawing.pdf", drawing::pdf(sheets));  // the same sheets as pages
/// @endcode
namespace fusee::drawing {

/// The input of a workshop drawing.
struct Subject {
    const solid::Part& part;  ///< with its mesh: views are cuts through the exported body
    const spring::BaseSpring& spring;
    const checks::Cable& cable;
    const checks::Process& process;
    std::string design;      ///< its name
    std::string name;        ///< of the part's files: "k_se", "k_se_mirrored"; "cam" of a single spring
    std::string provenance;  ///< core::Provenance::line
    TitleOptions title = {};
    /// The beginning of a joint's law is its least load, that of a single spring its first angle.
    [[nodiscard]] const char* beginning() const { return name == "cam" ? "first angle" : "least load"; }
};

/// The part on A3 sheets: front view along the axis, section A-A, the groove enlarged, notes, radii of the groove's floor every 10 degrees,
/// and a table of arm, tension and torque; more sheets if a table does not fit. First angle, millimetres (docs/drawing.md).
[[nodiscard]] std::vector<Sheet> draw(const Subject& subject);

/// The sheet for its inspection, to be filled in: the check rows of the drawing, bore, key and top face, each with its allowed deviation.
[[nodiscard]] coupon::InspectionSheet inspection_sheet(const Subject& subject);

}  // namespace fusee::drawing
