#include <fmt/format.h>

#include <algorithm>

#include "fusee/blind/blind.h"
#include "fusee/core/error.h"
#include "fusee/gap_case/case.h"
#include "fusee/plant/case_files.h"
#include "shuffle.h"

namespace fusee::blind {

namespace {

/// Streams of the benchmark as a whole, and of a case's effects: none of those that the plant draws a case from.
enum Purpose : std::uint64_t { kOrder = 101, kEffects };
enum class Kind { kNone, kOne, kTwo, kOutside };

/// Ids in shuffled order, shuffled again after each pass.
class Deck {
public:
    Deck(std::vector<std::string> ids, plant::Random& random) : ids_(std::move(ids)), random_(random) {}
    std::string deal() {
        if (next_ % ids_.size() == 0) shuffle(ids_, random_);
        return ids_[next_++ % ids_.size()];
    }

private:
    std::vector<std::string> ids_;
    plant::Random& random_;
    std::size_t next_ = 0;
};

std::vector<Kind> draw_kinds(std::size_t cases, const Mix& mix, plant::Random& random) {
    for (const auto& [name, share] : {std::pair{"mix.none", mix.none}, {"mix.two", mix.two}, {"mix.outside", mix.outside}})
        core::require_within(name, share, 0.0, 1.0);
    core::require_within("mix", mix.none + mix.two + mix.outside, 0.0, 1.0 + 1e-12);
    std::vector<Kind> kinds;
    double wanted = 0.0;
    for (const auto& [kind, share] : {std::pair{Kind::kNone, mix.none}, {Kind::kTwo, mix.two}, {Kind::kOutside, mix.outside}}) {
        wanted += share * static_cast<double>(cases);
        while (static_cast<double>(kinds.size()) + 0.5 <= wanted && kinds.size() < cases) kinds.push_back(kind);
    }
    kinds.resize(cases, Kind::kOne);
    shuffle(kinds, random);
    return kinds;
}

std::string part_of(const std::string& id) { return id.substr(0, id.find('.')); }

/// Another id, of another part of the rig.
std::string partner(const std::string& first, plant::Random& random) {
    const std::vector<std::string>& ids = plant::library_ids();
    std::string second = first;
    while (part_of(second) == part_of(first)) second = ids[random.below(ids.size())];
    return second;
}

std::vector<std::string> ids_of(Family family) {
    if (family == Family::kFormBlind) return plant::form_blind_ids();
    std::vector<std::string> ids = plant::outside_ids();
    if (family == Family::kEngine) ids.insert(ids.end(), plant::engine_ids().begin(), plant::engine_ids().end());
    return ids;
}

LabelEffect drawn(const std::string& id, const plant::Nominal& nominal, plant::Random& random) {
    const plant::Effect effect = plant::draw_effect(id, nominal, random);
    return {effect.id, effect.side, effect.size, effect.extra};
}

constexpr double kUnstatedNoise = 3.0;

plant::Conditions conditions_of(const std::string& doubt, plant::Random& random) {
    plant::Conditions conditions;
    conditions.linear_springs = doubt == "linear springs";
    if (doubt.starts_with("noise")) conditions.noise = kUnstatedNoise;
    if (doubt != "two experiments") return conditions;
    std::vector<std::string> all;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments) all.emplace_back(to_string(experiment));
    shuffle(all, random);
    conditions.experiments.assign(all.begin(), all.begin() + 2);
    return conditions;
}

/// One effect with a size of its own on each side.
std::vector<LabelEffect> unequal_sides(Deck& library, const plant::Nominal& nominal, plant::Random& random) {
    LabelEffect agonist;
    do agonist = drawn(library.deal(), nominal, random);
    while (agonist.side == "none" || agonist.id == "gear.stribeck");  // whose second parameter is one for both sides
    LabelEffect antagonist = agonist;
    agonist.side = "agonist", antagonist.side = "antagonist";
    (random.below(2) == 0 ? agonist : antagonist).size *= random.uniform(0.35, 0.5);
    return {agonist, antagonist};
}

/// So many effects of different parts of the rig.
std::vector<LabelEffect> several(std::size_t count, Deck& library, const plant::Nominal& nominal, plant::Random& random) {
    std::vector<LabelEffect> effects;
    while (effects.size() < count) {
        const std::string id = library.deal();
        if (std::none_of(effects.begin(), effects.end(), [&](const LabelEffect& e) { return part_of(e.id) == part_of(id); }))
            effects.push_back(drawn(id, nominal, random));
    }
    return effects;
}

Label doubtful_label(const std::string& doubt, std::uint64_t seed, std::size_t index, Deck& library) {
    plant::Random random(seed, index, kEffects);
    Label label{fmt::format("case{:03}", index), {}, true, doubt, conditions_of(doubt, random)};
    const plant::Nominal nominal = plant::draw_test_rig(seed, index, label.conditions.linear_springs).nominal;
    if (doubt.starts_with("figure.")) label.effects.push_back(drawn(doubt, nominal, random));
    if (doubt == "unequal sides") label.effects = unequal_sides(library, nominal, random);
    if (doubt == "three effects") label.effects = several(3, library, nominal, random);
    if (doubt == "four effects") label.effects = several(4, library, nominal, random);
    if (label.effects.empty() && doubt != "noise alone") label.effects = several(1, library, nominal, random);
    return label;
}

std::vector<Label> doubtful_labels(std::uint64_t seed, std::size_t cases, plant::Random& order) {
    std::vector<std::string> kinds;
    while (kinds.size() < cases)
        for (const std::string& doubt : doubts()) kinds.push_back(doubt);
    kinds.resize(cases);
    shuffle(kinds, order);
    Deck library(plant::library_ids(), order);
    std::vector<Label> labels;
    for (std::size_t i = 0; i < cases; ++i) labels.push_back(doubtful_label(kinds[i], seed, i, library));
    return labels;
}

}  // namespace

std::vector<std::string> doubts() {
    std::vector<std::string> all{"three effects", "four effects",    "unequal sides", "noise",
                                 "noise alone",   "two experiments", "linear springs"};
    all.insert(all.end(), plant::figure_ids().begin(), plant::figure_ids().end());
    return all;
}

std::vector<Label> draw_labels(std::uint64_t seed, std::size_t cases, const Mix& mix, Family family) {
    core::require_within("cases", static_cast<double>(cases), 1.0, 10'000.0);
    plant::Random order(seed, 0, kOrder);
    if (family == Family::kDoubtful) return doubtful_labels(seed, cases, order);
    const std::vector<Kind> kinds = draw_kinds(cases, mix, order);
    Deck library(plant::library_ids(), order), outside(ids_of(family), order);
    std::vector<Label> labels;
    for (std::size_t i = 0; i < cases; ++i) {
        const plant::Nominal nominal = plant::draw_test_rig(seed, i).nominal;
        plant::Random random(seed, i, kEffects);
        Label label{fmt::format("case{:03}", i), {}, kinds[i] != Kind::kOutside, "", {}};
        if (kinds[i] == Kind::kOutside) label.effects.push_back(drawn(outside.deal(), nominal, random));
        if (kinds[i] == Kind::kOne || kinds[i] == Kind::kTwo) label.effects.push_back(drawn(library.deal(), nominal, random));
        if (kinds[i] == Kind::kTwo) label.effects.push_back(drawn(partner(label.effects[0].id, random), nominal, random));
        labels.push_back(std::move(label));
    }
    return labels;
}

}  // namespace fusee::blind
