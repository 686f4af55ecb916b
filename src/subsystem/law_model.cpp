#include "law_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "study.h"

namespace fusee::subsystem {

LawModel::LawModel(const Law& law) : law_(law) {
    add_experiments();
    for (std::size_t k = 0; k < law.nominal; ++k) {
        const Parameter& own = law.parameters[k];
        const bool stated = own.prior > 0.0;
        build_.push_back({own.name, own.unit, stated ? own.prior : own.range(), own.null_value, false, stated});
    }
    for (const LawEffect& effect : law.effects) add_effect(effect);
}

/// The rows of each group of files, block by block.
void LawModel::add_experiments() {
    for (std::size_t b = 0; b < law_.blocks.size(); ++b) {
        const Block& block = law_.blocks[b];
        const Target& target = law_.targets[block.record];
        auto own = std::find_if(experiments_.begin(), experiments_.end(),
                                [&](const inference::Experiment& experiment) { return experiment.name == target.group; });
        if (own == experiments_.end()) {
            own = experiments_.emplace(own);
            own->name = target.group;
            own->variable = law_.region_name;
            own->outputs = {law_.measured_name};
        }
        experiment_of_.push_back(static_cast<std::size_t>(own - experiments_.begin()));
        own->rows += block.rows.size();
        for (const std::size_t i : block.rows) {
            own->measured.push_back(target.measured[i]);
            own->sigma.push_back(target.sigma[i]);
            own->places.push_back({target.region[i], law_.measured_name, law_.measured_name, static_cast<int>(b)});
        }
    }
}

/// The first start of a parameter is its usual size, which is tried with four times as much. A size that may be negative is tried so, too.
void LawModel::add_effect(const LawEffect& effect) {
    const auto known =
        std::find_if(effects_.begin(), effects_.end(), [&](const inference::Effect& other) { return other.id == effect.cause.id; });
    if (known != effects_.end()) {
        known->sides.push_back(effect.cause.side);
        return;
    }
    inference::Effect own{effect.cause.id, {}, {effect.cause.side}, {}, {1.0, 4.0}, {}, {}};
    for (const std::size_t k : effect.parameters) {
        const Parameter& of_law = law_.parameters[k];
        const double usual = of_law.starts.empty() ? of_law.range() : of_law.starts.front();
        own.parameters.push_back({of_law.name, of_law.unit, usual, {of_law.low, of_law.high}, of_law.null_value, of_law.starts});
    }
    if (own.parameters.front().allowed.low < 0.0) own.starts.insert(own.starts.end(), {-1.0, -4.0});
    for (std::size_t e = 0; e < experiments_.size() && effect.unseen.empty(); ++e) own.seen_by.push_back(e);
    effects_.push_back(std::move(own));
}

inference::Outputs LawModel::predict(const inference::Setting& setting, inference::Extent) const {
    Values values;
    for (const Parameter& own : law_.parameters) values.push_back(own.null_value);
    for (std::size_t k = 0; k < law_.nominal; ++k) values[k] += setting.build[k];
    for (const inference::Setting::Applied& applied : setting.effects) {
        const auto own =
            std::find_if(law_.effects.begin(), law_.effects.end(), [&](const LawEffect& effect) { return effect.cause == applied.cause; });
        for (std::size_t k = 0; k < applied.values.size(); ++k) values[own->parameters[k]] = applied.values[k];
    }
    return outputs(values);
}

inference::Outputs LawModel::outputs(const Values& values) const {
    std::vector<std::vector<double>> records(law_.targets.size());
    for (std::size_t r = 0; r < records.size(); ++r) law_.predict(r, values, records[r]);
    inference::Outputs outputs(experiments_.size());
    for (std::size_t b = 0; b < law_.blocks.size(); ++b)
        for (const std::size_t i : law_.blocks[b].rows) outputs[experiment_of_[b]].push_back(records[law_.blocks[b].record][i]);
    return outputs;
}

std::vector<std::string> LawModel::remarks() const {
    std::vector<std::string> all = law_.remarks();
    all.insert(all.end(), law_.floor_remarks.begin(), law_.floor_remarks.end());
    for (const LawEffect& effect : law_.effects)
        if (!effect.unseen.empty()) all.push_back(fmt::format("{} cannot be seen here: {}", name_of(effect), effect.unseen));
    return all;
}

}  // namespace fusee::subsystem
