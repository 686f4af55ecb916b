#include <algorithm>
#include <cmath>

#include "arguments.h"
#include "case_diagnosis.h"
#include "fusee/drawing/sheet.h"
#include "fusee/report/diagnosis.h"
#include "fusee/report/picture.h"
#include "made_parts.h"
#include "places.h"

namespace fusee::app {

namespace {

struct RenderArguments {
    fs::path source, out;
    std::string view = "assembly";
    int width_px = 1200;
    bool dark = false, force = false;
    double joint_deg = 0.0, co_contraction = 0.0;
};

/// Both capstans at the co-contraction asked for, the joint turned. @throws InvalidInput naming the option with what the joint allows
assembly::Pose pose_of(const RenderArguments& arguments, const pipeline::MadeDesign& design) {
    if (!design.report.assembly) return {};
    const assembly::Assembly& joint = *design.report.assembly;
    const spring::SpringLaw& law = *design.resolved.law();
    double turn = 0.0;
    if (arguments.co_contraction > 0.0) {
        if (!law.loads().holds(arguments.co_contraction))
            throw core::InvalidInput("--co-contraction", fmt::format("{:g}", arguments.co_contraction),
                                     fmt::format("{:g} to {:g} Nm, the loads of the law", law.loads().low, law.loads().high));
        turn = std::min(law.at_load(arguments.co_contraction).theta, joint.greatest_turn);
    }
    const double angle = core::rad_from_deg(arguments.joint_deg);
    const double most = assembly::greatest_joint_angle(joint, turn);
    if (std::abs(angle) > most + 1e-9)
        throw core::InvalidInput(
            "--joint-angle", fmt::format("{:g}", arguments.joint_deg),
            fmt::format("-{0:.3g} to {0:.3g} deg at this co-contraction: beyond, a K_SE would leave its range", core::deg_from_rad(most)));
    return assembly::pose_of(joint, turn, turn, angle);
}

std::string gap_map(const RenderArguments& arguments, report::Theme theme) {
    return report::gap_map_picture(diagnosis_of(arguments.source, {}), theme);
}

int write_bytes(const RenderArguments& arguments, const std::string& bytes, Reply& reply) {
    core::write_file(arguments.out, bytes);
    reply.result = {{"view", arguments.view}, {"file", arguments.out.string()}};
    reply.say(fmt::format("written: {}\n", arguments.out.string()));
    return 0;
}

int write_picture(const RenderArguments& arguments, const std::string& svg, Reply& reply) {
    const bool png = arguments.out.extension() == ".png";
    return write_bytes(arguments, png ? drawing::png_of_svg(svg, arguments.out.string(), arguments.width_px) : svg, reply);
}

void require_picture_file(const RenderArguments& arguments) {
    const std::string ending = arguments.out.extension().string();
    if (ending != ".svg" && ending != ".png")
        throw core::InvalidInput("--out", arguments.out.string(), "a file name that ends in .svg or .png");
    if (arguments.view == report::kMotionView && ending != ".png")
        throw core::InvalidInput("--out", arguments.out.string(), "a file name that ends in .png: the motion is an animated PNG");
    core::require_new_file(arguments.out, arguments.force);
}

int run_render(RenderArguments arguments, Reply& reply) {
    require_picture_file(arguments);
    const report::Theme theme = arguments.dark ? report::Theme::kDark : report::Theme::kLight;
    if (arguments.view == report::kGapMapView) return write_picture(arguments, gap_map(arguments, theme), reply);
    if (fs::is_directory(arguments.source))
        throw core::InvalidInput("--view", arguments.view, fmt::format("{}: the source is the folder of a case", report::kGapMapView));
    const profile::Profile profile = profile::read_profile(arguments.source);
    if (profile.is_spring() && arguments.view == RenderArguments{}.view) arguments.view = "cams";  // one part is all there is
    return with_places(profile, [&] {
        pipeline::require_parts(profile);
        const auto design = made_parts(profile);
        if (!design) {
            reply.show(design.refusal());
            return int{kRefused};
        }
        if (arguments.view == report::kMotionView)
            return write_bytes(arguments, report::motion_picture(design->report, arguments.width_px), reply);
        const report::PictureOptions options{theme, pose_of(arguments, *design), arguments.width_px};
        return write_picture(arguments, report::design_picture(design->report, arguments.view, options), reply);
    });
}

std::string views_text() {
    std::string text = "Views of a profile:\n";
    for (const report::PictureView& view : report::design_views()) text += fmt::format("  {:<16} {}\n", view.name, view.meaning);
    return text + fmt::format("View of the folder of a gap case:\n  {:<16} {}\n", report::kGapMapView,
                              "where the joint departs from its model, before and after the effects found");
}

}  // namespace

void add_render(CLI::App& app, Action& action) {
    constexpr int kLeastPixels = 16, kMostPixels = 8000;
    constexpr double kMostDegrees = 360.0, kMostTorque = 1e4;
    const auto [command, arguments] = add_command(app, action, "render", run_render);
    command->add_option("source", arguments->source, "Profile (*.toml); for the view gap-map, the folder of a case")
        ->type_name("FILE.toml")
        ->check(reads({FileKind::kProfile, FileKind::kCaseFolder}, "a profile; with --view gap-map the folder of a case"))
        ->required();
    command->add_option("--view", arguments->view, "What to draw, see below")->type_name("VIEW")->capture_default_str();
    command->add_option("-o,--out", arguments->out, "The picture, *.png or *.svg")->type_name("FILE")->required();
    add_number(*command, "--width", arguments->width_px, kLeastPixels, kMostPixels,
               "Width or height of the PNG and of shaded pictures, whichever is larger [px]");
    command->add_flag("--dark", arguments->dark, "Charts on a dark page");
    add_number(*command, "--co-contraction", arguments->co_contraction, 0.0, kMostTorque,
               "Load of both capstans in the view assembly [Nm]; 0: the lowest");
    add_number(*command, "--joint-angle", arguments->joint_deg, -kMostDegrees, kMostDegrees,
               "Angle of the joint from its middle in the view assembly [deg]");
    add_force_file(*command, arguments->force);
    command->footer(
        views_text() +
        "\nExample:\n  fusee render profiles/pnrvsa.toml --view cams -o cams.png\n"
        "  fusee render profiles/pnrvsa.toml --view dead-band -o dead_band.svg\n\n"
        "Exit code: 0 the picture is written, 1 the parts cannot be made, 2 bad input (file, line and key are named), 3 internal\n"
        "error, 130 stopped by Ctrl-C.");
}

}  // namespace fusee::app
