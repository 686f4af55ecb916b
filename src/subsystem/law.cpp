#include "law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/inference/constants.h"
#include "fusee/math/statistics.h"

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

}  // namespace fusee::subsystem
