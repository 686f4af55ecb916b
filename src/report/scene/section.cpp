#include "fusee/report/assembly.h"
#include "page/bundle.h"
#include "page/html.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

/// Why there is no assembly.
std::string refusal_text(const DesignReport& design) {
    for (const core::Finding& f : design.findings)
        if (f.rule == "joint.roller" || f.rule == "joint.guide") return f.where + ": " + f.what + ".";
    return "";
}

}  // namespace

std::string joint_viewer_section(const DesignReport& design, const std::vector<NumberedFinding>& findings, const Marks* marks,
                                 const std::string& words) {
    if (!design.assembly) {
        const std::string refusal = refusal_text(design);
        return section("The joint in 3D", refusal.empty() ? "" : paragraph("Not shown. " + refusal));
    }
    return "<section id=\"joint-3d\" class=\"joint3d\" data-joint3d=\"static\"><h2>The joint in 3D</h2>" + words +
           "<p class=\"joint3d-status\" role=\"status\">The joint in 3D needs scripts and WebGL, which this browser does not give the "
           "page: "
           "the drawing shows it along its axis.</p><div class=\"joint3d-view\" hidden></div>"
           "<details class=\"joint3d-drawing\" open><summary>Drawing: along the axis, at the lowest load and at the highest</summary>"
           "<figure class=\"plot\">" +
           assembly_plan(*design.assembly) + "</figure></details><script type=\"application/json\" id=\"joint-scene\">" +
           scene_json(design, findings, marks) + "</script>\n</section>\n";
}

}  // namespace fusee::report
