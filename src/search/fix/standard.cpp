#include "standard.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/coil.h"
#include "judge.h"

namespace fusee::search::fix {

namespace {

using core::m_from_mm;
using core::mm_from_m;

constexpr double kSame = 1e-9;     // relative: values that differ by rounding only
constexpr double kRounded = 1e-3;  // relative: the turns of a suggestion have four digits

bool below(double a, double b) { return a < b * (1.0 - kSame); }

std::string rate_key(const std::string& part, const profile::Profile& draft) {
    return part + (kind_of(part, draft) == cam::PartKind::kSeries ? ".spring.rate_Nm_per_rad" : ".spring.rate_N_per_m");
}

/// @param numbers by key, in its unit
profile::Profile with_numbers(profile::Profile draft, const std::map<std::string, double>& numbers) {
    for (const auto& [key, value] : numbers) profile::set_number(draft, key, key.ends_with("_mm") ? m_from_mm(value) : value);
    return draft;
}

const spring::BaseSpring& spring_of(const std::string& part, const profile::Profile& draft) {
    return draft.part(kind_of(part, draft)).spring;
}

/// The turns that give wire and coil the rate; none where they are not known.
std::optional<double> turns_of_spring(const std::string& part, const profile::Profile& draft) {
    const spring::BaseSpring& s = spring_of(part, draft);
    return spring::coil_known(s) && s.rate > 0.0 ? std::optional(spring::turns_for_rate(s)) : std::nullopt;
}
std::optional<double> rate_of_spring(const std::string& part, const profile::Profile& draft) {
    const spring::BaseSpring& s = spring_of(part, draft);
    return spring::coil_known(s) && s.active_coils > 0.0 ? std::optional(spring::rate_of_coils(s)) : std::nullopt;
}

/// Rounded down to four digits, so that no strength is overstated.
std::string floor_text(double value) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 3.0);
    return fmt::format("{:.10g}", std::floor(value / step + kSame) * step);
}

/// Torque from the cam to its shaft [Nm]; none if there is no cam.
std::optional<double> cam_torque(cam::PartKind kind, const profile::Profile& draft) {
    const auto largest = [&]() -> std::optional<double> {
        const auto design = pipeline::resolve(draft);
        if (!design) return std::nullopt;
        const auto cam = pipeline::design_cam(kind, *design);
        if (!cam) return std::nullopt;
        double torque = 0.0;
        for (const cam::Contact& c : cam->working) torque = std::max(torque, c.arm.tension * c.arm.arm);
        return torque;
    };
    return if_allowed(largest).value_or(std::nullopt);
}

class Holder {
public:
    Holder(const profile::Profile& draft, const Drafts& drafts) : draft_(draft), drafts_(drafts), original_(drafts.original()) {}

    Held run(const core::Changes& changes) {
        for (const core::Change& change : changes) {
            if (drafts_.keeps(change.key)) return refused(change.key, "it is kept (--keep)");
            take(change);
            if (!held_.refused.empty()) return std::move(held_);
        }
        for (const cam::PartKind kind : draft_.part_kinds())
            if (const std::string part = draft_.table_of(kind); catalogue_springs(part, draft_).empty()) settle(part);
        for (const auto& [key, leader] : held_.follows)
            if (drafts_.keeps(key)) return refused(leader, fmt::format("{}, which follows it, is kept (--keep)", key));
        return std::move(held_);
    }

private:
    Held refused(const std::string& key, std::string why) { return held_ = {{}, {}, key, std::move(why)}; }

    void add(const std::string& key, std::string value) { held_.changes.push_back({key, std::move(value)}); }
    void join(const std::string& leader, const std::string& key, std::string value) {
        held_.follows[key] = leader;
        add(key, std::move(value));
    }

    void take(const core::Change& change) {
        const std::optional<double> value = number_in(change.value);
        const std::string part = part_of(change.key), leaf = part.empty() ? change.key : change.key.substr(part.size() + 1);
        if (!value) return add(change.key, change.value);
        if (leaf == "cable.diameter_mm") return take_cable(*value);
        if (leaf == "cable.breaking_load_N") return take_breaking_load(*value);
        if (leaf == "hub.bore_mm") return take_shaft(part, *value);
        if (leaf == "hub.key_width_mm" || leaf == "hub.key_depth_mm") return take_key(part, change.key, *value);
        if (leaf == "hub.screw_mm") return take_size(change.key, *value, checks::screw_sizes());
        if (leaf == "spring.wire_mm") return take_size(change.key, *value, checks::wire_sizes());
        if (leaf == "spring.rate_Nm_per_rad" || leaf == "spring.rate_N_per_m") return take_rate(part, change, *value);
        add(change.key, change.value);
    }

    /// The next standard size on the permitted side; none: refused.
    std::optional<double> size(const std::string& key, double wanted, const checks::StandardSizes& sizes) {
        const double now = number_in(profile::value_text(draft_, key).value_or("")).value_or(0.0);
        const bool smaller = wanted < now;
        const std::optional<double> found = smaller ? sizes.at_most(wanted) : sizes.at_least(wanted);
        if (!found)
            (void)refused(key,
                          fmt::format("no {} of a standard size has {} {:.4g} mm", sizes.what, smaller ? "at most" : "at least", wanted));
        return found;
    }
    void take_size(const std::string& key, double wanted, const checks::StandardSizes& sizes) {
        if (const auto found = size(key, wanted, sizes)) add(key, fmt::format("{:g}", *found));
    }

    void take_cable(double wanted) {
        const std::string key = "cable.diameter_mm", load = "cable.breaking_load_N";
        const double now = mm_from_m(draft_.cable.diameter), was = mm_from_m(original_.cable.diameter), bears = draft_.cable.breaking_load;
        const auto found = size(key, wanted, checks::cable_sizes(draft_.cable.construction));
        if (!found) return;
        if (bears <= 0.0 && below(*found, was))
            return (void)refused(key, "its breaking load is not stated (cable.breaking_load_N), and a thinner cable bears less");
        add(key, fmt::format("{:g}", *found));
        const double share = std::min(*found, was) / std::min(now, was);  // a thicker one than the original is not counted as stronger
        if (bears > 0.0 && std::abs(share - 1.0) > kSame)
            join(key, load, *found >= was * (1.0 - kSame) ? drafts_.was(load) : floor_text(bears * share * share));
    }

    void take_breaking_load(double wanted) {
        const std::string key = "cable.breaking_load_N";
        const double most = checks::strongest_cable(draft_.cable.construction, draft_.cable.diameter), d = mm_from_m(draft_.cable.diameter);
        if (below(draft_.cable.diameter, original_.cable.diameter))
            return (void)refused(key, "the cable was made thinner, and its strength per area stays");
        if (wanted > most)
            return (void)refused(key, fmt::format("no {} cable of {:g} mm bears {:.4g} N; the strongest bears {:.4g} N",
                                                  draft_.cable.construction, d, wanted, most));
        add(key, fmt::format("{:.6g}", wanted));
    }

    void take_shaft(const std::string& part, double wanted) {
        const std::string key = part + ".hub.bore_mm";
        const auto found = size(key, wanted, checks::shaft_sizes());
        if (!found) return;
        const cam::PartKind kind = kind_of(part, draft_);
        const solid::HubOptions& hub = draft_.part(kind).solid.hub;
        const bool keyed = hub.lock == solid::HubLock::kKeyway;
        const checks::KeySize* din = checks::key_size(m_from_mm(*found));
        if (keyed && din == nullptr) return (void)refused(key, fmt::format("DIN 6885 has no key for a shaft of {:g} mm", *found));
        if (below(m_from_mm(*found), original_.part(kind).solid.hub.bore_diameter) && !bears(kind, key, *found, keyed)) return;
        add(key, fmt::format("{:g}", *found));
        if (!keyed) return;
        for (const auto& [leaf, now, then] :
             {std::tuple{".hub.key_width_mm", hub.key_width, din->width}, std::tuple{".hub.key_depth_mm", hub.key_depth, din->hub_depth}})
            if (std::abs(now - then) > kSame) join(key, part + leaf, fmt::format("{:g}", mm_from_m(then)));
    }

    /// Is a thinner shaft known to be strong enough?
    bool bears(cam::PartKind kind, const std::string& key, double mm, bool keyed) {
        const std::optional<double> torque = cam_torque(kind, draft_);
        if (!torque) return refused(key, "its torque is unknown because there is no cam"), false;
        const double stress = checks::torsion_stress(*torque, m_from_mm(mm)), most = checks::shaft_shear_limit(keyed);
        if (stress > most)
            return refused(key, fmt::format("a steel shaft of {:g} mm has {:.3g} MPa of shear at {:.3g} Nm, at most {:.3g} MPa are allowed",
                                            mm, 1e-6 * stress, *torque, 1e-6 * most)),
                   false;
        return true;
    }

    void take_key(const std::string& part, const std::string& key, double wanted) {
        const solid::HubOptions& hub = draft_.part(kind_of(part, draft_)).solid.hub;
        const checks::KeySize* din = checks::key_size(hub.bore_diameter);
        const bool width = key.ends_with("width_mm");
        if (din != nullptr && std::abs(m_from_mm(wanted) - (width ? din->width : din->hub_depth)) > kSame)
            return (void)refused(key, fmt::format("a shaft of {:g} mm has a key {:g} mm wide and {:g} mm deep in its hub by DIN 6885",
                                                  mm_from_m(hub.bore_diameter), mm_from_m(din->width), mm_from_m(din->hub_depth)));
        add(key, fmt::format("{:g}", wanted));
    }

    void take_rate(const std::string& part, const core::Change& change, double wanted) {
        const double now = *number_in(*profile::value_text(draft_, change.key));
        std::vector<core::Changes> springs = catalogue_springs(part, draft_);
        if (springs.empty()) {
            add(change.key, change.value);
            return;
        }
        const auto fits = [&](const core::Changes& spring) {
            const double rate = *number_in(spring.front().value);
            return wanted < now ? rate <= wanted * (1.0 + kSame) : rate >= wanted * (1.0 - kSame);
        };
        const auto found = std::find_if(springs.begin(), springs.end(), fits);  // of those on the permitted side the nearest to the present
        if (found == springs.end())
            return (void)refused(change.key, fmt::format("no spring of the catalogue has {} {:.4g}",
                                                         wanted < now ? "a rate of at most" : "a rate of at least", wanted));
        add(change.key, found->front().value);
        for (auto with = found->begin() + 1; with != found->end(); ++with) join(change.key, with->key, with->value);
    }

    /// The spring of a rate, wire or coil that changes has the turns that give them the rate; other turns give another rate.
    void settle(const std::string& part) {
        const std::string t = part + ".spring.", turns = t + "active_coils", rate = rate_key(part, draft_);
        std::string leader;
        std::map<std::string, double> moved;
        for (const core::Change& change : held_.changes)
            for (const std::string& key : {rate, t + "wire_mm", t + "coil_mm", turns})
                if (const auto value = number_in(change.value); value && change.key == key) {
                    moved[key] = *value;
                    if (leader.empty() || key == turns) leader = key;
                }
        if (leader.empty()) return;
        const profile::Profile settled = with_numbers(draft_, moved);
        const std::optional<double> consistent = leader == turns ? rate_of_spring(part, settled) : turns_of_spring(part, settled);
        const std::string follower = leader == turns ? rate : turns;
        if (!consistent || moved.contains(follower) || !original_.places.contains(follower)) return;
        if (std::abs(*consistent / *number_in(*profile::value_text(settled, follower)) - 1.0) > kRounded)
            join(leader, follower, fmt::format("{:.6g}", *consistent));
    }

    const profile::Profile& draft_;
    const Drafts& drafts_;
    const profile::Profile& original_;
    Held held_;
};

}  // namespace

Held hold(const core::Changes& changes, const profile::Profile& draft, const Drafts& drafts) { return Holder(draft, drafts).run(changes); }

std::optional<double> settled_follower(const std::string& key, const profile::Profile& draft) {
    for (const cam::PartKind kind : draft.part_kinds()) {
        const std::string part = draft.table_of(kind);
        if (key == part + ".spring.active_coils") return turns_of_spring(part, draft);
        if (key == rate_key(part, draft)) return rate_of_spring(part, draft);
    }
    return std::nullopt;
}

bool overrates_cable(const profile::Profile& draft, const profile::Profile& original) {
    if (!below(draft.cable.diameter, original.cable.diameter)) return false;
    const double share = draft.cable.diameter / original.cable.diameter;
    return draft.cable.breaking_load > original.cable.breaking_load * share * share * (1.0 + 1e-6);
}

std::vector<core::Changes> catalogue_springs(const std::string& part, const profile::Profile& draft) {
    const bool torsion = kind_of(part, draft) == cam::PartKind::kSeries;
    auto rows = draft.co_design.catalogue.of(torsion ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression);
    const double now = spring_of(part, draft).rate;
    std::stable_sort(rows.begin(), rows.end(), [now](const spring::CatalogueSpring& a, const spring::CatalogueSpring& b) {
        return std::abs(std::log(a.spring.rate / now)) < std::abs(std::log(b.spring.rate / now));
    });
    std::vector<core::Changes> all;
    for (const spring::CatalogueSpring& row : rows) {
        const std::string t = part + ".spring.";
        const spring::BaseSpring& s = row.spring;
        const auto text = [](double value) { return fmt::format("{:.9g}", value); };
        core::Changes changes{{t + (torsion ? "rate_Nm_per_rad" : "rate_N_per_m"), text(s.rate)},
                              {t + (torsion ? "max_angle_rad" : "max_travel_mm"), text(torsion ? s.max_state : mm_from_m(s.max_state))},
                              {t + (torsion ? "max_torque_Nm" : "max_force_N"), text(s.max_load)},
                              {t + "wire_mm", text(mm_from_m(s.wire_diameter))},
                              {t + "coil_mm", text(mm_from_m(s.coil_diameter))},
                              {t + "active_coils", text(s.active_coils)},
                              {t + "tensile_strength_MPa", text(1e-6 * s.tensile_strength)},
                              {t + "stress_share", text(s.stress_share)}};
        if (!torsion) changes.push_back({t + "free_length_mm", text(mm_from_m(s.free_length))});
        all.push_back(std::move(changes));
    }
    return all;
}

}  // namespace fusee::search::fix
