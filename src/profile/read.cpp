#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "companions.h"
#include "convert.h"
#include "files.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/toml.h"
#include "overrides.h"

namespace fs = std::filesystem;

namespace fusee::profile {

namespace {

/// One pair of keys that must stand in order.
struct Order {
    const char *low, *high;
    bool may_be_equal;
};
constexpr Order kOrders[] = {{"rig.least_torque_Nm", "rig.peak_torque_Nm", false},
                             {"rig.peak_torque_Nm", "rig.overdrive_torque_Nm", true},
                             {"law.start_torque_Nm", "law.end_torque_Nm", false}};

/// Keys whose 0 would leave no curve.
constexpr const char* kFactors[] = {"law.series_scale_Nm", "law.series_rate_per_rad", "law.parallel_scale_Nm", "law.parallel_rate_per_rad"};

class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    /// Notes every leaf of the file under its path. @throws InvalidInput for what the list of keys does not know
    void collect(const toml::table& table, const std::string& prefix) {
        regions_[prefix] = table.source();
        for (const auto& [name, node] : table) {
            const std::string path = prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
            if (name.str().find('.') != std::string_view::npos) refuse_unknown(path, name.source(), false);  // "a.b" in quotes is no a.b
            if (path == "limits") {
                limits_ = &node;
            } else if (node.is_table() && is_table(path)) {
                collect(*node.as_table(), path);
            } else if (find_key(path) != nullptr) {
                nodes_[path] = &node;
            } else {
                refuse_unknown(path, name.source(), node.is_table());
            }
        }
    }

    void assign(Profile& profile) const {
        profile.has_parts = limits_ != nullptr ||
                            std::any_of(nodes_.begin(), nodes_.end(), [](const auto& node) { return find_key(node.first)->of_part(); });
        for (const Key& key : keys()) {
            if (key.of_part()) refuse_parts_of_others(profile);
            const auto found = nodes_.find(key.path);
            const bool wanted = applies(key, profile);
            if (found == nodes_.end()) {
                if (wanted && key.required) refuse_missing(key);
            } else if (!wanted) {
                refuse_unused(key, *found->second);
            } else {
                key.set(profile, convert(key, *found->second, file_));
            }
        }
        if (limits_ != nullptr) profile.limits = read_overrides(*limits_, file_, design_rules());
        check_knots(profile);
        check_companions(profile);
        for (const PartSpec* part : {&profile.k_se, &profile.k_pe}) check_cable(*part, profile);
        for (const Order& order : kOrders) check(order, profile);
        for (const char* factor : kFactors) require_not_0(*find_key(factor), profile);
        for (const auto& [path, node] : nodes_) profile.places[path] = place(file_, node->source(), path);
    }

private:
    [[noreturn]] void refuse_unknown(const std::string& path, const toml::source_region& at, bool table) const {
        if (is_table(path)) throw core::InvalidInput(place(file_, at, path), "a single value", fmt::format("a table [{}]", path));
        if (table)
            throw core::InvalidInput(place(file_, at, path), "unknown table", fmt::format("nearest known one: [{}]", nearest_table(path)));
        const Key& near = nearest_key(path);
        throw core::InvalidInput(place(file_, at, path), "unknown key",
                                 fmt::format("nearest known one: {}, {}", near.path, allowed_text(near)));
    }
    [[noreturn]] void refuse_missing(const Key& key) const {
        std::string table = key.table();
        while (!regions_.contains(table)) table = table.substr(0, table.find('.') == std::string::npos ? 0 : table.rfind('.'));
        throw core::InvalidInput(place(file_, regions_.at(table), key.path), "missing", allowed_text(key));
    }
    [[noreturn]] void refuse_unused(const Key& key, const toml::node& node) const {
        std::vector<std::string> conditions;
        for (const Condition& when : key.when) conditions.push_back(when.text("", "\""));
        throw core::InvalidInput(place(file_, node.source(), key.path), "has no meaning here",
                                 fmt::format("{}", fmt::join(conditions, ", ")));
    }
    /// Cams are known for the paper's arrangement only.
    void refuse_parts_of_others(const Profile& profile) const {
        if (!profile.has_parts || profile.rig.arrangement == actuator::Arrangement::kPnrvsa) return;
        const auto refuse = [this](const toml::node& node, const std::string& path) {
            throw core::InvalidInput(place(file_, node.source(), path), "has no meaning here",
                                     "only with rig.arrangement = \"pnrvsa\": the others cannot be made");
        };
        for (const auto& [path, node] : nodes_)
            if (find_key(path)->of_part()) refuse(*node, path);
        if (limits_ != nullptr) refuse(*limits_, "limits");
    }
    void require_not_0(const Key& key, const Profile& profile) const {
        if (applies(key, profile) && std::get<double>(key.get(profile)) == 0.0)
            throw core::InvalidInput(place(file_, nodes_.at(key.path)->source(), key.path), "0", "another number than 0");
    }
    void check_knots(const Profile& profile) const {
        const auto* curve = std::get_if<spring::FreeCurveOptions>(&profile.law.curves);
        if (curve == nullptr) return;
        const auto refuse = [this](const char* path, std::string value, std::string allowed) {
            throw core::InvalidInput(place(file_, nodes_.at(path)->source(), path), std::move(value), std::move(allowed));
        };
        const std::vector<double>& loads = curve->loads;
        for (std::size_t i = 1; i < loads.size(); ++i)
            if (loads[i] <= loads[i - 1])
                refuse("law.loads_Nm", fmt::format("{:g}", loads[i]), fmt::format("above the knot before, {:g} Nm", loads[i - 1]));
        for (const auto& [path, knots] :
             {std::pair{"law.series_Nm_per_rad", &curve->series_stiffness}, {"law.transmission", &curve->transmission}})
            if (knots->size() != loads.size())
                refuse(path, fmt::format("{} numbers", knots->size()), fmt::format("as many as law.loads_Nm, {}", loads.size()));
    }
    /// @throws InvalidInput at the key that asks for others, or at its table where it is left out
    void check_companions(const Profile& profile) const {
        const std::vector<Companions> missing = missing_companions(profile);
        if (missing.empty()) return;
        const Companions& first = missing.front();
        const Key& key = *find_key(first.key);
        std::string table = key.table();
        while (!regions_.contains(table)) table = table.substr(0, table.find('.') == std::string::npos ? 0 : table.rfind('.'));
        const auto node = nodes_.find(first.key);
        const toml::source_region& at = node == nodes_.end() ? regions_.at(table) : node->second->source();
        throw core::InvalidInput(place(file_, at, fmt::format("{}", fmt::join(first.needs, " and "))), "missing, or 0",
                                 fmt::format("above 0 mm, with {} = \"{}\"", first.key, first.value));
    }
    /// A length alone says nothing of how far a cable stretches.
    void check_cable(const PartSpec& part, const Profile& profile) const {
        if (part.cable_length <= 0.0 || profile.wrap.stiffness > 0.0) return;
        const std::string path = &part == &profile.k_se ? "k_se.cable_length_mm" : "k_pe.cable_length_mm";
        throw core::InvalidInput(place(file_, nodes_.at(path)->source(), path), "a length without stiffness",
                                 "cable.stiffness_N above 0: E A of the cable, load over relative stretch");
    }
    void check(const Order& order, const Profile& profile) const {
        const Key &low = *find_key(order.low), &high = *find_key(order.high);
        if (!applies(high, profile)) return;
        const double a = std::get<double>(low.get(profile)), b = std::get<double>(high.get(profile));
        if (a < b || (order.may_be_equal && a == b)) return;
        throw core::InvalidInput(
            place(file_, nodes_.at(high.path)->source(), high.path), toml_text(high, profile),
            fmt::format("{} {} = {} {}", order.may_be_equal ? "at least" : "above", low.path, toml_text(low, profile), low.unit.name));
    }

    std::string file_;
    std::map<std::string, const toml::node*> nodes_;
    const toml::node* limits_ = nullptr;  ///< [[limits]]
    std::map<std::string, toml::source_region> regions_;
};

/// What stands once in the file and in several rooms' options.
void distribute(Profile& p) {
    p.k_pe.solid.groove = p.k_se.solid.groove;
    const bool stacked = p.process.kind == checks::ProcessKind::kEdm || p.process.kind == checks::ProcessKind::kLaser;
    if (!p.places.contains("outputs.formats")) p.outputs.plates = stacked;
    p.k_pe.solid.chordal_error = p.k_se.solid.chordal_error;
    p.k_pe.allowance.cable_axis = p.k_se.allowance.cable_axis;
    for (PartSpec* part : {&p.k_se, &p.k_pe})
        if (part->cable_length > 0.0) part->allowance.cable_give = part->cable_length / p.wrap.stiffness;
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
}

std::string Profile::place_of(const std::string& key) const {
    const auto found = places.find(key);
    return found != places.end() ? found->second : fmt::format("{}: {}", file.string(), key);
}

Profile read_profile(const fs::path& path) { return parse_profile(core::read_file(path, kLargestFile), path); }

Profile parse_profile(std::string toml, const fs::path& path) {
    const toml::table table = core::parse_toml(toml, path.string());
    Reader reader(path.string());
    reader.collect(table, "");
    Profile profile;
    profile.file = path;
    reader.assign(profile);
    distribute(profile);
    toml += read_files(profile);
    profile.sha256 = core::sha256_hex(toml);
    return profile;
}

}  // namespace fusee::profile
