#include "law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/inference/constants.h"
#include "fusee/math/statistics.h"
#include "study.h"

namespace fusee::subsystem {

bool Parameter::stops_at(double value) const {
    constexpr double kNear = inference::kNearEnd;
    if (own_ends == OwnEnds::kBoth) return false;
    const bool own_low = own_ends == OwnEnds::kLow || null_value == low;
    return value >= high - kNear * range() || (!own_low && value <= low + kNear * range());
}

void stop_if_asked() {
    if (core::interrupted()) throw core::Stopped();
}

std::unique_ptr<Law> law_of(const Case& subsystem_case, const Case* inputs) {
    const Case& rows = inputs != nullptr ? *inputs : subsystem_case;
    switch (subsystem_case.kind) {
        case Kind::kFrictionElement:
            return friction_element(rows, inputs != nullptr);
        case Kind::kServoPendulum:
            return servo_pendulum(rows, inputs != nullptr);
        case Kind::kMotorBreakaway:
            return motor_breakaway(rows, inputs != nullptr);
        case Kind::kCamJoint:
            return cam_joint(subsystem_case, inputs);
    }
    throw core::InvalidInput("bench.kind", "unknown", "a kind of subsystem");
}

std::size_t thinning(const std::vector<Record>& records) {
    std::size_t rows = 0;
    for (const Record& record : records) rows += record.rows();
    return std::max<std::size_t>(1, (rows + inference::kMostRows - 1) / inference::kMostRows);
}

std::vector<double> every(const std::vector<double>& column, std::size_t step) {
    std::vector<double> out;
    for (std::size_t i = 0; i < column.size(); i += step) out.push_back(column[i]);
    return out;
}

double scatter_of(const std::vector<double>& column) {
    std::vector<double> sizes;
    for (std::size_t i = 1; i + 1 < column.size(); ++i) sizes.push_back(std::abs(column[i - 1] - 2.0 * column[i] + column[i + 1]));
    return sizes.empty() ? 0.0 : 1.4826 * math::upper_median(std::move(sizes)) / std::sqrt(6.0);
}

double number_or(const std::map<std::string, double>& numbers, const char* name, double otherwise) {
    const auto at = numbers.find(name);
    return at != numbers.end() ? at->second : otherwise;
}

double number_of(const Record& record, const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (const auto at = record.parameters.find(name); at != record.parameters.end()) return at->second;
    throw core::InvalidInput(record.file + ": " + names.front(), "missing",
                             "a number in [bench] or a word key=value in the file's '#' line");
}

std::vector<Fold> folds_of(const Scheme& scheme) {
    std::vector<Fold> folds;
    for (std::size_t b = 0; b < scheme.labels.size(); ++b) {
        auto own = std::find_if(folds.begin(), folds.end(), [&](const Fold& fold) { return fold.label == scheme.labels[b]; });
        if (own == folds.end()) own = folds.insert(own, {scheme.labels[b], {}});
        own->blocks.push_back(b);
    }
    return folds;
}

std::vector<std::size_t> all_blocks(const Law& law) { return blocks_without(law, {}); }

std::vector<std::size_t> blocks_without(const Law& law, const std::vector<std::size_t>& some) {
    std::vector<std::size_t> others;
    for (std::size_t b = 0; b < law.blocks.size(); ++b)
        if (std::find(some.begin(), some.end(), b) == some.end()) others.push_back(b);
    return others;
}

std::vector<std::vector<std::size_t>> subsets_of(const std::vector<std::size_t>& set) {
    std::vector<std::vector<std::size_t>> subsets(set.size(), set);
    for (std::size_t i = 0; i < set.size(); ++i) std::erase(subsets[i], set[i]);
    return subsets;
}

void make_blocks(Law& law, const Case& subsystem_case, std::size_t least_files) {
    const std::size_t parts = subsystem_case.records.size() < least_files ? 3 : 1;
    Scheme scheme{parts == 1 ? "file" : "part", {}};
    for (std::size_t r = 0; r < subsystem_case.records.size(); ++r) {
        const std::size_t rows = law.targets[r].measured.size();
        for (std::size_t p = 0; p < parts; ++p) {
            Block block{subsystem_case.records[r].file, r, {}};
            if (parts > 1) block.name += fmt::format(" part {}", p + 1);
            for (std::size_t i = rows * p / parts; i < rows * (p + 1) / parts; ++i)
                if (law.targets[r].settled.empty() || law.targets[r].settled[i]) block.rows.push_back(i);
            scheme.labels.push_back(block.name);
            law.blocks.push_back(std::move(block));
        }
    }
    law.schemes.push_back(std::move(scheme));
}

namespace {

bool same_split(const std::vector<Fold>& a, const std::vector<Fold>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Fold& one, const Fold& other) { return one.blocks == other.blocks; });
}

}  // namespace

void add_scheme(Law& law, const std::string& name, const std::vector<std::string>& label_of_record) {
    Scheme scheme{name, {}};
    for (const Block& block : law.blocks) scheme.labels.push_back(name + " " + label_of_record[block.record]);
    const std::vector<Fold> folds = folds_of(scheme);
    if (folds.size() < 2) return;
    for (const Scheme& other : law.schemes)
        if (same_split(folds_of(other), folds)) return;
    law.schemes.push_back(std::move(scheme));
}

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
