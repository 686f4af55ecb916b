#include <fmt/format.h>

#include "fusee/profile/edit.h"
#include "scale.h"

namespace fusee::search::init {

namespace {

std::string basic_string(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
    return quoted + "\"";
}

std::string law_text(const fs::path& file, const Answers& answers) {
    if (!names_file(answers.torque_law))
        return fmt::format("kind = \"formula\"\nformula_Nm = {}\nfrom_deg = {:.9g}\nto_deg = {:.9g}\n", basic_string(answers.torque_law),
                           core::deg_from_rad(answers.first_angle), core::deg_from_rad(answers.last_angle));
    const fs::path csv = fs::absolute(answers.torque_law), folder = fs::absolute(file).parent_path();
    return fmt::format("kind = \"table\"\nfile = {}\n", basic_string(fs::relative(csv, folder).generic_string()));
}

}  // namespace

profile::Profile first_spring(const fs::path& file, const Answers& answers) {
    require_consistent(answers);
    const std::string text = fmt::format(
        "name = \"{}\"\nkind = \"spring\"\n[law]\n{}[cable]\ndiameter_mm = {:.6g}\n[process]\nkind = \"{}\"\n[cam]\nfamily = \"cable\"\n"
        "[cam.spring]\nrate_N_per_m = 5000.0\npreload_mm = 10.0\nwire_class = \"sh\"\ncycles = 1e5\n"
        "[cam.guide]\nkind = \"point\"\ndirection_deg = 90.0\ndistance_mm = 150.0\n{}",
        file.stem().string(), law_text(file, answers), core::mm_from_m(answers.cable), checks::to_string(answers.process),
        profile::columns_toml(answers.columns));
    profile::Profile p = profile::parse_profile(text, file);
    set_parts(p, answers, {});
    p.k_pe.solid.hub.key_fit = solid::KeyFit::kByHand;  // filed to its key: few processes hold P9 or JS9
    return p;
}

}  // namespace fusee::search::init
