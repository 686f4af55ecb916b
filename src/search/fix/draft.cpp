#include "draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "judge.h"
#include "standard.h"

namespace fusee::search::fix {

namespace {

constexpr double kWholeRange = 10.0;  // cost of all loads of a law, in addition to its weight
constexpr double kGivenUp = 3.0;      // cost of a feature that is left out

bool ends_law(const std::string& key) { return key == "law.start_torque_Nm" || key == "law.end_torque_Nm"; }

/// Size of a change; 0: none.
double change_size(const std::string& key, const std::string& from, const std::string& to, double law_width) {
    const std::optional<double> a = number_in(from), b = number_in(to);
    if (!a || !b) return 1.0;
    if (*b == 0.0) return kGivenUp;
    if (ends_law(key)) return kWholeRange * std::abs(*b - *a) / law_width;
    return *a > 0.0 && *b > 0.0 ? std::abs(std::log(*b / *a)) : 1.0;
}

/// A repeated change for the same limit keeps the finding that first suggested it.
void keep_choice(Choices& choices, const core::Change& change, Choice choice) {
    const auto before = choices.find(change.key);
    if (before != choices.end() && name_of(before->second.because) == name_of(choice.because)) choice.because = before->second.because;
    choices[change.key] = std::move(choice);
}

std::string why(const core::Finding& f) {
    const std::string unit = f.unit.empty() ? "" : " " + f.unit;
    return fmt::format("{}, measured {:.4g}{}, allowed at {} {:.4g}{}", name_of(f), f.measured, unit,
                       f.bound == core::Bound::kAtMost ? "most" : "least", f.allowed, unit);
}

// Drawn features weigh least, then adjusted values, then bought parts; the law, the purpose of the design, weighs most.
// docs/guides/fix.md shows this table. The first matching row holds.
constexpr Policy kPolicies[] = {
    {"tolerances.", 0.5, "the drawing"},
    {"process.layer_mm", 0.5, "the slicer"},
    {"groove.", 1.0, "the drawing"},
    {"hub.kind", 2.0, "the drawing"},
    {"hub.bore_mm", 5.0, "another shaft"},
    {"hub.screw_mm", 1.0, "another screw"},
    {"hub.", 1.0, "the drawing"},
    {"features.", 1.0, "the drawing"},
    {"flange_height_mm", 1.0, "the drawing"},
    {"machining.", 1.0, "the programs"},
    {"path.kind", 3.0, "the drawing"},
    {"path.", 1.5, "the drawing"},
    {"guide.", 2.0, "the frame"},
    {"roller.", 2.0, "the drawing"},
    {"spring.preload_rad", 3.0, "the spring's preload", true},
    {"spring.preload_mm", 3.0, "the spring's preload", true},
    {"spring.rate_Nm_per_rad", 5.0, "another spring", true},
    {"spring.rate_N_per_m", 5.0, "another spring", true},
    {"spring.active_coils", 6.0, "another spring", true},
    {"spring.", 6.0, "another spring"},
    {"cable.", 6.0, "another cable"},
    {"process.cutter_radius_mm", 7.0, "another tool"},
    {"law.lead_in_deg", 4.0, "the law", true},
    {"law.start_torque_Nm", 10.0, "the law", true},
    {"law.end_torque_Nm", 10.0, "the law", true},
    {"law.c_Nm", 12.0, "the law", true},
};

}  // namespace

std::optional<double> number_in(const std::string& toml) {
    double value = 0.0;
    const char* end = toml.data() + toml.size();
    const auto [at, error] = std::from_chars(toml.data(), end, value);
    return error == std::errc() && at == end ? std::optional(value) : std::nullopt;
}

std::string Drafts::was(const std::string& key) const { return profile::value_text(original_, key).value_or("not there"); }

bool Drafts::keeps(const std::string& key) const {
    return std::any_of(kept_.begin(), kept_.end(), [&key](const std::string& kept) { return key == kept || key.starts_with(kept + "."); });
}

std::vector<profile::Edit> Drafts::edits(const Choices& choices) const {
    std::vector<profile::Edit> all;
    for (const auto& [key, choice] : choices) {
        const std::string from = was(key), reason = choice.follows.empty() ? why(choice.because) : "follows " + choice.follows;
        all.push_back({{key, choice.value, from}, reason, fmt::format("changed by fix from {}", from)});
    }
    return all;
}

std::optional<profile::Profile> Drafts::read(const Choices& choices) const {
    auto draft = if_allowed([&] { return profile::parse_profile(profile::with_edits(toml_, original_, edits(choices)), original_.file); });
    return draft && overrates_cable(*draft, original_) ? std::nullopt : std::move(draft);
}

std::string Drafts::text(const Choices& choices) const {
    std::vector<profile::Edit> all = edits(choices);
    all.push_back(profile::name_edit(original_, "-fixed"));
    const auto files = profile::file_edits(original_, fs::absolute(file_).parent_path());
    all.insert(all.end(), files.begin(), files.end());
    return profile::with_edits(toml_, original_, all,
                               fmt::format("# {} with the changes of fusee fix, each with its reason above it.", original_.name));
}

Choices Drafts::with(Choices choices, const core::Changes& changes, const core::Finding& because, int move, const Follows& follows) const {
    for (const core::Change& change : changes) {
        const std::optional<double> before = number_in(was(change.key)), now = number_in(change.value);
        if (change.value == was(change.key) || (before && before == now))
            choices.erase(change.key);
        else
            keep_choice(choices, change, {change.value, because, move, follows.contains(change.key) ? follows.at(change.key) : ""});
    }
    return choices;
}

double Drafts::cost(const Choices& choices) const {
    double cost = 0.0;
    for (const auto& [key, choice] : choices)
        if (choice.follows.empty())
            cost +=
                policy_of(key)->weight + change_size(key, was(key), choice.value, original_.law.end_torque - original_.law.start_torque);
    return cost;
}

const Policy* policy_of(std::string_view key) {
    if (const std::string part = part_of(std::string(key)); !part.empty()) key.remove_prefix(part.size() + 1);
    const auto fits = [key](const Policy& p) { return p.key.ends_with('.') ? key.starts_with(p.key) : key == p.key; };
    const auto policy = std::find_if(std::begin(kPolicies), std::end(kPolicies), fits);
    return policy == std::end(kPolicies) ? nullptr : &*policy;
}

}  // namespace fusee::search::fix
