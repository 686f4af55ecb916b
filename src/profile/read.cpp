#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "companions.h"
#include "convert.h"
#include "files.h"
#include "fusee/core/file.h"
#include "fusee/formats/format.h"
#include "fusee/profile/edit.h"
#include "fusee/spring/coil.h"
#include "overrides.h"

namespace fusee::profile {

namespace {

/// Two keys whose values must be in order.
struct Order {
    const char *low, *high;
    bool may_be_equal;
};
constexpr Order kOrders[] = {{"rig.least_torque_Nm", "rig.peak_torque_Nm", false},
                             {"rig.peak_torque_Nm", "rig.overdrive_torque_Nm", true},
                             {"law.start_torque_Nm", "law.end_torque_Nm", false},
                             {"law.from_deg", "law.to_deg", false}};

/// Keys that must not be 0: there would be no curve.
constexpr const char* kFactors[] = {"law.torque_Nm",         "law.series_scale_Nm",       "law.series_rate_per_rad",
                                    "law.parallel_scale_Nm", "law.parallel_rate_per_rad", "law.scale_Nm",
                                    "law.rate_per_rad"};

/// Collects the file's values under their paths, then sets them key by key. A mistake is noted and reading continues; consequences of it
/// (keys of an unreadable table, of an unknown kind) are not reported.
class Reader {
public:
    Reader(const toml::table& table, core::TomlFaults& faults) : faults_(faults) {
        const std::string kind = table["kind"].value_or<std::string>("");
        if (kind == "spring") of_kind_.law.curves = OneSpring{};
        rolls_ = kind == "spring" && table.at_path("cam.family").value_or<std::string>("") == "roller";
        collect(table, "");
    }

    void assign(Profile& profile) {
        profile.has_parts = limits_ != nullptr ||
                            std::any_of(nodes_.begin(), nodes_.end(), [](const auto& node) { return find_key(node.first)->of_part(); });
        bool of_others = false;  // parts of arrangements that cannot be made
        for (const Key& key : keys()) {
            if (key.of_part() && !of_others) of_others = refuse_parts_of_others(profile);
            if (of_others) break;
            assign(key, profile);
        }
        if (limits_ != nullptr && !of_others) profile.limits = read_overrides(*limits_, design_rules(), faults_);
        profile.columns.table = "columns";
        if (columns_ != nullptr) read_columns(*columns_, faults_, profile.columns);
        check_knots(profile);
        if (!of_others) check_companions(profile);
        check_points(profile);
        for (const cam::PartKind part : profile.part_kinds()) check_cable(part, profile);
        for (const Order& order : kOrders) check(order, profile);
        for (const char* factor : kFactors) require_not_0(*find_key(factor), profile);
        for (const auto& [path, node] : nodes_) profile.places[path] = core::toml_place(faults_.file(), node->source(), path);
    }

private:
    /// Notes every leaf under its path, and every unknown key as a mistake.
    void collect(const toml::table& table, const std::string& prefix) {
        regions_[prefix] = table.source();
        for (const auto& [name, node] : table) {
            const std::string path = prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
            if (name.str().find('.') != std::string_view::npos) {  // a name in quotes may have a dot
                refuse_unknown(path, name.source(), false);
            } else if (path == "limits") {
                limits_ = &node;
            } else if (path == "columns") {
                columns_ = &node;
            } else if (node.is_table() && is_table(path)) {
                collect(*node.as_table(), path);
            } else if (find_key(path) != nullptr) {
                nodes_[path] = &node;
            } else {
                refuse_unknown(path, name.source(), node.is_table());
            }
        }
    }

    void refuse_unknown(const std::string& path, const toml::source_region& at, bool table) {
        if (faults_.full()) return faults_.add(at, path, "unknown", "");
        if (is_table(path)) {
            faults_.add(at, path, "a single value", fmt::format("a table [{}]", path));
            misread_.insert(path);
        } else if (table) {
            const std::string near = nearest_table(path, of_kind_);
            faults_.add(at, path, "unknown table", fmt::format("nearest known one: [{}]", near));
            misread_.insert(near);
        } else {
            const Key& near = nearest_key(path, &of_kind_);
            faults_.add(at, path, "unknown key", fmt::format("nearest known one: {}, {}", near.path, allowed_text(near)));
            misread_.insert(near.path);
        }
    }

    /// Does the profile hold the file's value for the key?
    [[nodiscard]] bool is_known(const std::string& path) const { return !unknown_.contains(path); }

    /// Was a misspelt key or table probably meant to be this key or its table?
    [[nodiscard]] bool is_misread(std::string path) const {
        while (!misread_.contains(path)) {
            const auto dot = path.rfind('.');
            if (dot == std::string::npos) return false;
            path.resize(dot);
        }
        return true;
    }

    /// Has this kind of profile another key of that path?
    [[nodiscard]] static bool has_other(const Key& key, const Profile& profile) {
        return std::any_of(keys().begin(), keys().end(), [&](const Key& other) { return other.path == key.path && is_of(other, profile); });
    }

    void assign(const Key& key, Profile& profile) {
        const auto found = nodes_.find(key.path);
        if (is_known("kind") && !is_of(key, profile)) {
            if (found != nodes_.end() && !has_other(key, profile)) refuse(key.path, "has no meaning here", only_of_kind(key.path, profile));
            return;
        }
        const bool decided =
            is_known("kind") && std::all_of(key.when.begin(), key.when.end(), [this](const Condition& when) { return is_known(when.key); });
        if (!decided) {
            unknown_.insert(key.path);
            if (found != nodes_.end()) (void)convert(key, *found->second, faults_);
        } else if (found == nodes_.end()) {
            if (applies(key, profile) && key.required && !follows(key) && !(rolls_ && key.table() == "cable")) refuse_missing(key);
        } else if (!applies(key, profile)) {
            refuse_unused(key, *found->second);
        } else if (const std::optional<Value> value = convert(key, *found->second, faults_)) {
            key.set(profile, *value);
        } else {
            unknown_.insert(key.path);
        }
    }

    /// The table of a missing key, or its parent.
    [[nodiscard]] const toml::source_region& nearest_region(const Key& key) const {
        std::string table = key.table();
        while (!regions_.contains(table)) table = table.substr(0, table.find('.') == std::string::npos ? 0 : table.rfind('.'));
        return regions_.at(table);
    }
    /// A rate may be left out where wire, coil and turns give it.
    [[nodiscard]] bool follows(const Key& key) const {
        if (!key.leaf().starts_with("rate_") || !key.table().ends_with(".spring")) return false;
        const auto stated = [&](const char* leaf) {
            const auto node = nodes_.find(key.table() + leaf);
            return node == nodes_.end() ? 0.0 : node->second->value<double>().value_or(0.0);
        };
        return stated(".wire_mm") > 0.0 && stated(".coil_mm") > stated(".wire_mm") && stated(".active_coils") > 0.0;
    }
    [[nodiscard]] static std::string only_of_kind(const std::string& path, const Profile& profile) {
        const std::string own = counterpart(path, profile);
        return fmt::format("only with kind = \"{}\"{}", profile.is_spring() ? "joint" : "spring", own.empty() ? "" : "; here: " + own);
    }
    void refuse_missing(const Key& key) {
        unknown_.insert(key.path);
        if (is_misread(key.path)) return;
        faults_.add(nearest_region(key), key.path, "missing", allowed_text(key));
    }
    void refuse_unused(const Key& key, const toml::node& node) {
        std::vector<std::string> conditions;
        for (const Condition& when : key.when) conditions.push_back(when.text("", "\""));
        refuse(key.path, "has no meaning here", fmt::format("{}", fmt::join(conditions, ", ")), node);
    }
    void refuse(const std::string& path, std::string value, std::string allowed, const toml::node& node) {
        faults_.add(node.source(), path, std::move(value), std::move(allowed));
    }
    void refuse(const std::string& path, std::string value, std::string allowed) {
        refuse(path, std::move(value), std::move(allowed), *nodes_.at(path));
    }

    /// Only the paper's arrangement has cams; reported once. @returns whether it was reported
    [[nodiscard]] bool refuse_parts_of_others(const Profile& profile) {
        if (!profile.has_parts || !is_known("rig.arrangement") || profile.rig.arrangement == actuator::Arrangement::kPnrvsa) return false;
        const auto part = std::find_if(nodes_.begin(), nodes_.end(), [](const auto& node) { return find_key(node.first)->of_part(); });
        refuse(part == nodes_.end() ? "limits" : part->first, "has no meaning here",
               "only with rig.arrangement = \"pnrvsa\": the others cannot be made", part == nodes_.end() ? *limits_ : *part->second);
        return true;
    }
    void require_not_0(const Key& key, const Profile& profile) {
        if (is_known(key.path) && applies(key, profile) && std::get<double>(key.get(profile)) == 0.0)
            refuse(key.path, "0", "another number than 0");
    }
    void check_knots(const Profile& profile) {
        const auto* curve = std::get_if<spring::FreeCurveOptions>(&profile.law.curves);
        if (curve == nullptr || !is_known("law.loads_Nm")) return;
        const std::vector<double>& loads = curve->loads;
        for (std::size_t i = 1; i < loads.size(); ++i)
            if (loads[i] <= loads[i - 1])
                refuse("law.loads_Nm", fmt::format("{:g}", loads[i]), fmt::format("above the knot before, {:g} Nm", loads[i - 1]));
        for (const auto& [path, knots] :
             {std::pair{"law.series_Nm_per_rad", &curve->series_stiffness}, {"law.transmission", &curve->transmission}})
            if (is_known(path) && knots->size() != loads.size())
                refuse(path, fmt::format("{} numbers", knots->size()), fmt::format("as many as law.loads_Nm, {}", loads.size()));
    }
    void check_points(const Profile& profile) {
        const auto* law = std::get_if<OneSpring>(&profile.law.curves);
        if (law == nullptr || law->kind != OneSpring::Kind::kPoints || !is_known("law.angles_deg")) return;
        const std::vector<double>&x = law->rows.x, &y = law->rows.y;
        for (std::size_t i = 1; i < x.size(); ++i)
            if (x[i] <= x[i - 1])
                refuse("law.angles_deg", fmt::format("{:.6g}", core::deg_from_rad(x[i])),
                       fmt::format("above the angle before, {:.6g} deg", core::deg_from_rad(x[i - 1])));
        if (is_known("law.torques_Nm") && x.size() != y.size())
            refuse("law.torques_Nm", fmt::format("{} numbers", y.size()), fmt::format("as many as law.angles_deg, {}", x.size()));
    }
    /// A fault at the key that needs others, or at its table if it is missing.
    void check_companions(const Profile& profile) {
        for (const Companions& missing : missing_companions(profile)) {
            const auto unread = [this](const std::string& key) { return !is_known(key) || is_misread(key); };
            if (unread(missing.key) || std::any_of(missing.needs.begin(), missing.needs.end(), unread)) continue;
            const auto node = nodes_.find(missing.key);
            faults_.add(node == nodes_.end() ? nearest_region(*find_key(missing.key)) : node->second->source(),
                        fmt::format("{}", fmt::join(missing.needs, " and ")), "missing, or 0",
                        fmt::format("above 0 mm, with {} = \"{}\"", missing.key, missing.value));
        }
    }
    /// A length without stiffness does not determine a cable's compliance.
    void check_cable(cam::PartKind part, const Profile& profile) {
        if (profile.part(part).cable_length <= 0.0 || profile.wrap.stiffness > 0.0 || !is_known("cable.stiffness_N")) return;
        refuse(profile.table_of(part) + ".cable_length_mm", "a length without stiffness",
               "cable.stiffness_N above 0: E A of the cable, load over relative stretch");
    }
    void check(const Order& order, const Profile& profile) {
        const Key &low = *find_key(order.low), &high = *find_key(order.high);
        if (!is_known(order.low) || !is_known(order.high) || !applies(high, profile)) return;
        const double a = std::get<double>(low.get(profile)), b = std::get<double>(high.get(profile));
        if (a < b || (order.may_be_equal && a == b)) return;
        refuse(high.path, toml_text(high, profile),
               fmt::format("{} {} = {} {}", order.may_be_equal ? "at least" : "above", low.path, toml_text(low, profile), low.unit.name));
    }

    core::TomlFaults& faults_;
    Profile of_kind_;     ///< of the kind that the file states: unknown keys are compared with its keys alone
    bool rolls_ = false;  ///< the part of a single spring is a roller's rim, and nothing has a cable
    std::map<std::string, const toml::node*> nodes_;
    const toml::node* limits_ = nullptr;   ///< [[limits]]
    const toml::node* columns_ = nullptr;  ///< [columns]
    std::map<std::string, toml::source_region> regions_;
    std::set<std::string> misread_;  ///< keys and tables that were probably misspelt
    std::set<std::string> unknown_;  ///< keys without a value: refused, missing, or of an unknown kind
};

/// Copies values that appear once in the file to the options of several modules.
void distribute(Profile& p) {
    p.k_pe.solid.groove = p.k_se.solid.groove;
    follow_process(p);
    if (!p.places.contains("outputs.formats")) p.outputs.formats = formats::default_formats(p.process);
    p.k_pe.solid.chordal_error = p.k_se.solid.chordal_error;
    p.k_pe.allowance.cable_axis = p.k_se.allowance.cable_axis;
    for (PartSpec* part : {&p.k_se, &p.k_pe}) spring::derive_coils(part->spring);
    for (PartSpec* part : {&p.k_se, &p.k_pe})
        if (part->cable_length > 0.0) part->allowance.cable_compliance = part->cable_length / p.wrap.stiffness;
    if (const auto* one = std::get_if<OneSpring>(&p.law.curves)) {
        p.k_pe.cam.family = one->family == OneSpring::Family::kRoller ? cam::Family::kRoller : cam::Family::kCable;
        if (one->family != OneSpring::Family::kSpool) p.rig.capstan_radius = 1.0;  // no pulley: the part turns with the angle itself
        p.outputs.pair = false;
    }
    p.k_se.cam.cable_diameter = p.k_pe.cam.cable_diameter = p.cable.diameter;
    if (p.k_pe.cam.family == cam::Family::kRoller) {  // neither cable nor anchor nor lips
        p.k_pe.cam.cable_diameter = p.k_pe.solid.features.anchor_hole_diameter = p.k_pe.solid.flange_height = 0.0;
        p.k_pe.allowance = {};
    }
    if (auto* law = std::get_if<spring::StictionLawOptions>(&p.law.curves)) {
        law->mu = p.rig.rest_friction();
        law->start_torque = p.law.start_torque;
        law->end_torque = p.law.end_torque;
    }
    if (const auto* law = std::get_if<spring::FreeCurveOptions>(&p.law.curves)) {
        p.law.start_torque = law->loads.front();
        p.law.end_torque = law->loads.back();
    }
}

}  // namespace

Profile::Profile(const Profile&) = default;
Profile::Profile(Profile&&) noexcept = default;
Profile& Profile::operator=(const Profile&) = default;
Profile& Profile::operator=(Profile&&) noexcept = default;
Profile::~Profile() = default;

Profile::Profile() {
    k_se.spring.kind = spring::BaseKind::kTorsion;
    k_pe.spring.kind = spring::BaseKind::kCompression;
    // Assumed: a small geared motor and a light arm; noise that moves a joint of 0.3 Nm/rad by about a degree.
    dynamics = {.motor_inertia = 2e-3,
                .joint_inertia = 6e-3,
                .motor_viscous = 4e-3,
                .joint_viscous = 2e-3,
                .motor_noise = 1e-6,
                .joint_noise = 1e-6};
    outputs.formats = formats::default_formats(process);
}

void follow_process(Profile& p) {
    p.k_se.solid.groove.stacked = p.k_pe.solid.groove.stacked = checks::is_stacked(p.process);
    const bool milled = checks::is_milled(p.process) && std::ranges::count(p.outputs.formats, "ngc") > 0;
    const auto pins = [&](toolpath::Method method) {
        return milled && method == toolpath::Method::kStack ? p.machining.dowel_diameter : 0.0;
    };
    p.k_se.solid.dowel_diameter = pins(p.machining.k_se), p.k_pe.solid.dowel_diameter = pins(p.machining.k_pe);
}

bool Outputs::has(std::string_view format) const { return std::find(formats.begin(), formats.end(), format) != formats.end(); }

std::vector<cam::PartKind> Profile::part_kinds() const {
    const auto* one = std::get_if<OneSpring>(&law.curves);
    if (one == nullptr) return {cam::PartKind::kSeries, cam::PartKind::kParallel};
    return {one->family == OneSpring::Family::kSpool ? cam::PartKind::kSeries : cam::PartKind::kParallel};
}

bool Profile::has_two_cables() const {
    const auto* one = std::get_if<OneSpring>(&law.curves);
    return one != nullptr && one->family == OneSpring::Family::kTwoCables && one->two_cables.way == OneSpring::TwoCables::Way::kBoth;
}

std::string Profile::name_of(cam::PartKind kind) const {
    const auto* one = std::get_if<OneSpring>(&law.curves);
    return table_of(kind) + (one != nullptr && one->pulls_back() ? "_back" : "");
}

std::string Profile::in_its_words(std::string text) const {
    if (!is_spring()) return text;
    for (const std::string part : {"k_se", "k_pe"})
        for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;) text.replace(at, part.size(), "cam");
    return text;
}

std::string Profile::place_of(const std::string& part_key) const {
    const std::string key = in_its_words(part_key);
    const auto found = places.find(key);
    return found != places.end() ? found->second : fmt::format("{}: {}", file.string(), key);
}

Profile read_profile(const fs::path& path) { return parse_profile(core::read_file(path, kLargestFile), path); }

Profile parse_profile(std::string toml, const fs::path& path) {
    const toml::table table = core::parse_toml(toml, path.string());
    core::TomlFaults faults(path.string());
    Profile profile;
    profile.file = path;
    Reader(table, faults).assign(profile);
    toml += read_files(profile, faults);
    faults.throw_if_any();
    distribute(profile);
    profile.sha256 = core::sha256_hex(toml);
    return profile;
}

}  // namespace fusee::profile
