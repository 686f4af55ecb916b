#include "fusee/profile/follow.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "fusee/checks/limits.h"
#include "fusee/spring/coil.h"
#include "key.h"

namespace fusee::profile {

namespace {

constexpr double kSame = 1e-6;     // [m] of key and keyway
constexpr double kRodStep = 1e-4;  // [m]

/// A number's key: its value after the edits, and whether they move it.
class Values {
public:
    Values(const Profile& profile, const std::vector<Edit>& moved) : profile_(profile) {
        for (const Edit& edit : moved) moved_[edit.key] = edit.value;
    }
    [[nodiscard]] bool moves(const std::string& key) const { return moved_.contains(key); }
    [[nodiscard]] bool states(const std::string& key) const { return profile_.places.contains(key); }
    [[nodiscard]] double was(const std::string& key) const { return number_of(profile_, key); }
    /// The key's value in SI; NaN if it is not a number.
    [[nodiscard]] double now(const std::string& key) const {
        const auto found = moved_.find(key);
        if (found == moved_.end()) return was(key);
        double value = std::nan("");
        std::from_chars(found->second.data(), found->second.data() + found->second.size(), value);
        return find_key(key)->unit.to_si(value);
    }
    [[nodiscard]] double change(const std::string& key) const { return now(key) - was(key); }

    void leave_out(const std::string& key) {
        if (states(key) && !moves(key)) edits_.push_back({key, "", toml_text(*find_key(key), profile_), ""});
    }
    void set(const std::string& key, double value) {
        if (states(key) && !moves(key) && was(key) > 0.0 && value > 0.0) edits_.push_back(number_edit(profile_, key, value, ""));
    }
    [[nodiscard]] std::vector<Edit> edits() && { return std::move(edits_); }

private:
    const Profile& profile_;
    std::map<std::string, std::string> moved_;
    std::vector<Edit> edits_;
};

/// The place and the width of the leg's slot, and the rod: what stands beside the coils.
void follow_coils(Values& values, const std::string& part) {
    const std::string t = part + ".spring.", wire = t + "wire_mm", coil = t + "coil_mm", rod = t + "rod_mm";
    const double inside = values.was(coil) - values.was(wire);
    if (inside > 0.0) values.set(rod, kRodStep * std::floor(values.was(rod) * (values.now(coil) - values.now(wire)) / inside / kRodStep));
    if (part != "k_se") return;
    const std::string slot = part + ".features.leg_slot_";
    if (values.change(wire) != 0.0) values.set(slot + "width_mm", values.was(slot + "width_mm") + values.change(wire));
    if (values.change(coil) != 0.0) values.set(slot + "radius_mm", values.was(slot + "radius_mm") + 0.5 * values.change(coil));
}

void follow_spring(Values& values, const std::string& part, const spring::BaseSpring& s) {
    const bool torsion = part == "k_se";
    const std::string t = part + ".spring.", rate = t + (torsion ? "rate_Nm_per_rad" : "rate_N_per_m"), wire = t + "wire_mm",
                      coil = t + "coil_mm", turns = t + "active_coils",
                      modulus = t + (torsion ? "youngs_modulus_MPa" : "shear_modulus_MPa");
    const bool winds = values.moves(turns), shapes = values.moves(wire) || values.moves(coil) || values.moves(modulus);
    if (!(values.now(wire) > 0.0 && values.now(coil) > values.now(wire)) || !(winds || shapes || values.moves(rate))) return;
    if (winds)
        values.leave_out(rate);
    else if (values.moves(rate) || values.states(rate))
        values.leave_out(turns);
    values.leave_out(t + "free_length_mm");
    if (spring::tensile_strength(s) > 0.0 || values.moves(t + "wire_class") || values.moves(t + "tensile_strength_MPa"))
        for (const char* rating : torsion ? std::array{"max_angle_rad", "max_torque_Nm"} : std::array{"max_travel_mm", "max_force_N"})
            values.leave_out(t + rating);
    if (values.was(coil) > 0.0 && values.was(wire) > 0.0) follow_coils(values, part);
}

void follow_cable(Values& values) {
    const double ratio = values.now("cable.diameter_mm") / values.was("cable.diameter_mm");
    values.set("cable.breaking_load_N", values.was("cable.breaking_load_N") * ratio * ratio);
    for (const char* edge : {"k_se.features.anchor_edge_mm", "k_pe.features.anchor_edge_mm"}) values.set(edge, values.was(edge) * ratio);
}

/// A key that was not by the standard was chosen for another reason.
void follow_bore(Values& values, const std::string& hub) {
    const std::string bore = hub + "bore_mm", width = hub + "key_width_mm", depth = hub + "key_depth_mm";
    const checks::KeySize *was = checks::key_size(values.was(bore)), *now = checks::key_size(values.now(bore));
    if (was == nullptr || now == nullptr) return;
    if (std::abs(was->width - values.was(width)) > kSame || std::abs(was->hub_depth - values.was(depth)) > kSame) return;
    values.set(width, now->width);
    values.set(depth, now->hub_depth);
}

/// Does the key shape the contour of the part's cam, or what stands around its anchor?
bool shapes_cam(const std::string& key, const std::string& part) {
    return key.starts_with("law.") || key.starts_with("rig.") || key.starts_with("cable.") || key.starts_with(part + ".");
}

}  // namespace

std::vector<Edit> following(const Profile& profile, const std::vector<Edit>& moved) {
    if (!profile.has_parts) return {};
    Values values(profile, moved);
    follow_spring(values, "k_se", profile.k_se.spring);
    follow_spring(values, "k_pe", profile.k_pe.spring);
    if (values.moves("cable.diameter_mm")) follow_cable(values);
    for (const char* hub : {"k_se.hub.", "k_pe.hub."})
        if (values.moves(std::string(hub) + "bore_mm")) follow_bore(values, hub);
    return std::move(values).edits();
}

void let_anchors_follow(Profile& profile, const std::vector<Edit>& moved) {
    for (const std::string part : {"k_se", "k_pe"}) {
        const std::string margin = part + ".path.margin_deg";
        const auto is = [&](const Edit& edit) { return edit.key == margin; };
        const auto shapes = [&](const Edit& edit) { return shapes_cam(edit.key, part); };
        if (std::none_of(moved.begin(), moved.end(), is) && std::any_of(moved.begin(), moved.end(), shapes)) profile.places.erase(margin);
    }
}

}  // namespace fusee::profile
