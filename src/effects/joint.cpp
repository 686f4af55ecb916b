#include "fusee/effects/joint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "fusee/effects/term.h"

namespace fusee::effects {

namespace {

constexpr std::size_t kStretch = 8;       ///< rows of a path that are held out together, where no whole run can be
constexpr std::size_t kLogParts = 4;      ///< of a log, which is one run: held out one after the other
constexpr std::size_t kFormPoints = 201;  ///< of the curve of a generic term
/// T of each experiment above which the model lacks something [sigma]: a break-away scatters with the built friction, spring pulls
/// are known best, paths that stick and slip least.
constexpr std::array<double, gap_case::kExperiments> kUnexplained{2.0, 1.35, 3.5, 3.25, 2.0, 2.75};

const char* variable_of(gap_case::Experiment experiment) {
    switch (experiment) {
        case gap_case::Experiment::kBreakAway:
            return "motor_torque_Nm";
        case gap_case::Experiment::kSpringPull:
            return "deflection_rad";
        case gap_case::Experiment::kDeadBand:
            return "cocontraction_Nm";
        case gap_case::Experiment::kJointStiffness:
            return "joint_torque_Nm";
        case gap_case::Experiment::kCocontraction:
            return "motor_torque_Nm";
        default:
            return "t_s";
    }
}

/// The place of a row's key among the different ones.
template <typename Key>
class Levels {
public:
    template <typename RowList, typename KeyOf>
    Levels(const RowList& rows, const KeyOf& key_of) {
        std::set<Key> all;
        for (const auto& row : rows) all.insert(key_of(row));
        levels_.assign(all.begin(), all.end());
    }
    [[nodiscard]] int place(const Key& key) const {
        return static_cast<int>(std::lower_bound(levels_.begin(), levels_.end(), key) - levels_.begin());
    }
    [[nodiscard]] bool several() const { return levels_.size() > 1; }

private:
    std::vector<Key> levels_;
};

/// Where the values of an experiment stand. A whole set point or a whole run is one block; of a single run its stretches are.
class PlacesOf {
public:
    explicit PlacesOf(const gap_case::Case& gap_case) : rows_(gap_case.rows) {}
    void put(gap_case::Experiment experiment, inference::Experiment& own) {
        columns_ = joint_model::measured_columns(experiment, rows_);
        own.unit = own.direct ? "Nm" : "rad";
        switch (experiment) {
            case gap_case::Experiment::kBreakAway:
                own.blocks = put_rows(
                    rows_.breakaway, "torques", [](const auto& row) { return row.motor_torque; },
                    [this](const auto& row, int block) {
                        add(row.motor_torque, row.side + (row.backdrive ? " backdrive" : " drive"), "", block);
                    });
                break;
            case gap_case::Experiment::kSpringPull:
                own.blocks = put_rows(
                    rows_.spring_pull, "strokes", [](const auto& row) { return std::tuple(row.series, row.side, row.load); },
                    [this](const auto& row, int block) {
                        add(row.deflection, std::string(row.series ? "se " : "pe ") + to_string(row.side), "", block);
                    });
                break;
            case gap_case::Experiment::kJointStiffness:
                own.blocks = put_rows(
                    rows_.joint_stiffness, "levels", [](const auto& row) { return row.cocontraction; },
                    [this](const auto& row, int block) {
                        add(row.joint_torque, "q_rad", fmt::format(" at {:g} Nm", row.cocontraction), block);
                    });
                break;
            default:
                own.blocks = put_columns(experiment);
        }
        own.places = std::move(places_);
    }

private:
    /// Adds every row with its block: that of its key, or a stretch where all have the same key. Returns what the blocks are.
    template <typename RowList, typename KeyOf, typename Add>
    static std::string put_rows(const RowList& rows, const char* blocks, const KeyOf& key_of, const Add& add_row) {
        using Row = typename RowList::value_type;
        const Levels<decltype(key_of(std::declval<const Row&>()))> levels(rows, key_of);
        for (std::size_t i = 0; i < rows.size(); ++i)
            add_row(rows[i], levels.several() ? levels.place(key_of(rows[i])) : static_cast<int>(i / kStretch));
        return levels.several() ? blocks : "stretches";
    }
    /// The same of experiments with several columns. A log is one run: no row of it is seen before or after its quarter.
    std::string put_columns(gap_case::Experiment experiment) {
        if (experiment == gap_case::Experiment::kDeadBand)
            return put_rows(
                rows_.dead_band, "levels", [](const auto& row) { return row.cocontraction; },
                [this](const auto& row, int block) { add_columns(row.cocontraction, block); });
        if (experiment == gap_case::Experiment::kCocontraction)
            return put_rows(
                rows_.cocontraction, "strokes", [](const auto& row) { return row.up; },
                [this](const auto& row, int block) { add_columns(row.motor_torque, block); });
        for (std::size_t i = 0; i < rows_.log.size(); ++i)
            add_columns(rows_.log[i].time, static_cast<int>(i * kLogParts / rows_.log.size()));
        return "quarters of the log";
    }
    void add(double at, const std::string& component, const std::string& curve, int block) {
        places_.push_back({at, component, component + curve, block});
    }
    void add_columns(double at, int block) {
        for (const std::string& column : columns_) add(at, column, "", block);
    }

    const gap_case::Rows& rows_;
    std::vector<std::string> columns_;
    std::vector<inference::Place> places_;
};

std::vector<inference::Experiment> experiments_of(const gap_case::Case& gap_case, const joint_model::Uncertainty& known) {
    const joint_model::Signals measured = joint_model::measured(gap_case.rows);
    std::vector<inference::Experiment> all;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments) {
        const auto e = static_cast<std::size_t>(experiment);
        inference::Experiment& own = all.emplace_back();
        own.name = to_string(experiment);
        own.variable = variable_of(experiment);
        own.rows = gap_case.rows.size(experiment);
        own.outputs = joint_model::measured_columns(experiment, gap_case.rows);
        own.measured = measured[experiment];
        own.sigma = known.sigma[experiment];
        own.weight = known.weight[e];
        own.unexplained = kUnexplained[e];
        own.direct = experiment == gap_case::Experiment::kBreakAway || experiment == gap_case::Experiment::kSpringPull;
        PlacesOf(gap_case).put(experiment, own);
    }
    return all;
}

inference::Effect engine_effect(const Effect& effect, bool generic) {
    inference::Effect own{effect.id, effect.law, {"none"}, effect.parameters, effect.starts, {}, effect.confused_with, generic};
    own.figure = effect.figure;
    if (effect.figure) own.meaning = effect.meaning, own.remedy = effect.advice;  // the reader knows those of the library
    for (const Experiment experiment : effect.seen_by) own.seen_by.push_back(static_cast<std::size_t>(experiment));
    if (effect.sided) own.sides = {"agonist", "antagonist", "both"};
    if (effect.sided && generic && own.has_phase()) own.sides.pop_back();  // a ripple has a phase of its own on each side
    return own;
}

/// What a build parameter is beyond its tolerance: an effect of the same law. "K_SE rate agonist" is a size of se.rate on the agonist.
inference::BuildParameter engine_build(const joint_model::BuildParameter& build, const gap_case::NominalRig& rig) {
    static const std::map<std::string, std::string> kCauses{{"gear load friction", "gear.load_friction"},
                                                            {"K_SE rate", "se.rate"},
                                                            {"K_PE rate", "pe.rate"},
                                                            {"K_SE radius", "se.radius"},
                                                            {"K_PE radius", "pe.radius"},
                                                            {"K_SE preload", "se.preload"},
                                                            {"K_PE preload", "pe.preload"},
                                                            {"torque scale", "sensor.torque_scale"},
                                                            {"joint radius", "figure.joint_radius"},
                                                            {"motor inertia", "figure.motor_inertia"},
                                                            {"joint inertia", "figure.joint_inertia"},
                                                            {"joint bearing friction", "joint.coulomb"},
                                                            {"joint encoder zero", "sensor.joint_offset"}};
    inference::BuildParameter own{build.name, build.unit, build.sigma, 0.0, build.of_rig};
    const std::size_t last = build.name.rfind(' ');
    const auto whole = kCauses.find(build.name), sided = kCauses.find(build.name.substr(0, last));
    if (whole != kCauses.end()) own.cause = {whole->second, "none"};
    if (sided != kCauses.end()) own.cause = {sided->second, build.name.substr(last + 1)};
    if (own.cause.id == "gear.load_friction" && rig.gear_load_friction > 0.0) own.cause_size = 1.0 / rig.gear_load_friction;
    return own;
}

}  // namespace

Joint::Joint(const gap_case::Case& gap_case)
    : gap_case_(gap_case),
      cams_(gap_case.rig),
      known_(joint_model::uncertainty(gap_case)),
      changes_(joint_model::build_parameters(gap_case)),
      experiments_(experiments_of(gap_case, known_)),
      thin_(gap_case.rows) {
    const gap_case::Reference reference = gap_case::reference_of(gap_case.rig);
    for (const Effect& effect : effects_on(reference)) effects_.push_back(engine_effect(effect, false));
    for (const Effect& term : terms_on(reference)) effects_.push_back(engine_effect(term, true));
    for (const joint_model::BuildParameter& build : changes_) build_.push_back(engine_build(build, gap_case.rig));
    thin_.dead_band.clear();
    for (const gap_case::DeadBandRow& row : gap_case.rows.dead_band) {
        const auto same = std::find_if(thin_.dead_band.begin(), thin_.dead_band.end(),
                                       [&](const gap_case::DeadBandRow& other) { return other.cocontraction == row.cocontraction; });
        like_.push_back(static_cast<std::size_t>(same - thin_.dead_band.begin()));
        if (same == thin_.dead_band.end()) thin_.dead_band.push_back(row);
        thin_.dead_band[like_.back()].row = like_.size();
    }
}

joint_model::BuiltRig Joint::rig(const inference::Setting& setting) const {
    joint_model::BuiltRig rig(gap_case_.rig);
    for (std::size_t i = 0; i < changes_.size(); ++i) changes_[i].add(rig, setting.build[i]);
    for (const auto& [cause, values] : setting.effects) apply_effect(find_effect_or_term(cause.id), cause, values, rig);
    rig.assemble(cams_);
    return rig;
}

inference::Outputs Joint::predict(const inference::Setting& setting, inference::Extent extent) const {
    return std::move(predict_each({setting}, extent).front());
}

std::vector<inference::Outputs> Joint::predict_each(const std::vector<inference::Setting>& settings, inference::Extent extent) const {
    std::vector<joint_model::BuiltRig> rigs;
    rigs.reserve(settings.size());
    for (const inference::Setting& setting : settings) rigs.push_back(rig(setting));
    const bool once = extent == inference::Extent::kOncePerSetPoint;
    std::vector<inference::Outputs> all(rigs.size(), inference::Outputs(gap_case::kExperiments));
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments) {
        const auto e = static_cast<std::size_t>(experiment);
        if (extent == inference::Extent::kDirect && !experiments_[e].direct) continue;
        auto read = joint_model::predict_experiment(rigs, once ? thin_ : gap_case_.rows, gap_case_.protocol, experiment);
        for (std::size_t i = 0; i < all.size(); ++i) all[i][e] = std::move(read[i]);
    }
    if (once)
        for (inference::Outputs& outputs : all) repeat_levels(outputs[static_cast<std::size_t>(gap_case::Experiment::kDeadBand)]);
    return all;
}

void Joint::repeat_levels(std::vector<double>& read) const {
    const std::size_t columns = thin_.dead_band_width_only ? 1 : 2;
    const std::vector<double> levels = std::exchange(read, {});
    for (const std::size_t level : like_)
        for (std::size_t c = 0; c < columns; ++c) read.push_back(levels[level * columns + c]);
}

std::vector<std::string> Joint::remarks() const {
    std::vector<std::string> all = gap_case_.remarks;
    all.insert(all.end(), known_.scatter.remarks.begin(), known_.scatter.remarks.end());
    if (known_.stick_slip)
        all.emplace_back("cocontraction: a capstan sticks and slips; the moment of a slip cannot be predicted, so paths get less weight");
    return all;
}

core::Range Joint::curve_range_of(const std::string& over, const std::vector<double>& values) const {
    const gap_case::Rows& rows = gap_case_.rows;
    if (over == "capstan_rad") return {0.0, cams_.end()};
    if (over == "end_share") return {0.0, 1.0};
    if (over == "time_s" || over == "session_s") return {0.0, 4.0 * (values.size() > 1 ? values[1] : values[0])};
    if (over == "torque_Nm") {
        const gap_case::NominalRig::SpringRow& end = gap_case_.rig.springs.back();
        return {0.0, end.se_torque + end.pe_torque};
    }
    if (over == "rad_per_s") {
        double most = 0.1;  // as fast as it was seen
        for (std::size_t i = 1; i < rows.log.size(); ++i)
            if (const double time = rows.log[i].time - rows.log[i - 1].time; time > 0.0)
                most = std::max(most, std::abs(rows.log[i].q - rows.log[i - 1].q) / time);
        return {0.0, most};
    }
    double most = 0.1;  // joint_rad: as far as it was seen
    for (const gap_case::DeadBandRow& row : rows.dead_band)
        if (!rows.dead_band_width_only) most = std::max({most, std::abs(row.q_low), std::abs(row.q_high)});
    for (const gap_case::StiffnessRow& row : rows.joint_stiffness) most = std::max(most, std::abs(row.q));
    for (const gap_case::LogRow& row : rows.log) most = std::max(most, std::abs(row.q));
    return {-most, most};
}

inference::Form Joint::form_of(const Cause& cause, const std::vector<double>& values) const {
    const Term& term = *term_or_none(cause.id);
    inference::Form form{term.port, term.depends_on, sentence_of(term, cause.side, values), term.over, term.gives, {}, {}};
    const core::Range range = curve_range_of(term.over, values);
    for (std::size_t i = 0; i < kFormPoints; ++i) {
        form.x.push_back(range.low + range.width() * static_cast<double>(i) / (kFormPoints - 1));
        form.y.push_back(term.curve(values, form.x.back()));
    }
    return form;
}

std::unique_ptr<inference::Menu> Joint::menu() const { return std::make_unique<JointMenu>(*this, measurement_menu(gap_case_)); }

namespace {

joint_model::Signals signals_of(const gap_case::Rows& rows, const std::vector<double>& all, std::size_t& next) {
    joint_model::Signals signals = joint_model::measured(rows);
    for (std::vector<double>& figures : signals.of)
        for (double& figure : figures) figure = all[next++];
    return signals;
}

}  // namespace

JointMenu::JointMenu(const Joint& joint, MeasurementMenu menu) : joint_(joint), menu_(std::move(menu)) {
    std::vector<std::array<std::size_t, gap_case::kExperiments>> first;  // of each sheet, the first value of each experiment
    std::size_t size = 0;
    for (const gap_case::Rows& sheet : menu_.sheets) {
        const joint_model::Signals signals = joint_model::measured(sheet);
        first.emplace_back();
        for (std::size_t e = 0; e < gap_case::kExperiments; ++e) {
            first.back()[e] = size;
            size += signals.of[e].size();
        }
    }
    for (const SheetMeasurement& m : menu_.measurements) {
        const std::size_t columns = joint_model::measured_columns(m.experiment, menu_.sheets[m.sheet]).size();
        measurements_.push_back(m.offer());
        for (const std::size_t row : m.rows)
            for (std::size_t c = 0; c < columns; ++c)
                measurements_.back().values.push_back(
                    static_cast<int>(first[m.sheet][static_cast<std::size_t>(m.experiment)] + row * columns + c));
    }
}

std::vector<double> JointMenu::predict(const inference::Setting& setting) const {
    const joint_model::BuiltRig rig = joint_.rig(setting);
    std::vector<double> all;
    for (const gap_case::Rows& rows : menu_.sheets)
        for (const std::vector<double>& figures : joint_model::predict_signals(rig, rows, joint_.gap_case().protocol).of)
            all.insert(all.end(), figures.begin(), figures.end());
    return all;
}

std::vector<double> JointMenu::precisions(const std::vector<double>& predicted) const {
    std::vector<double> all;
    std::size_t next = 0;
    for (const gap_case::Rows& sheet : menu_.sheets) {
        gap_case::Case asked = joint_.gap_case();
        asked.rows = joint_model::with_measured(sheet, signals_of(sheet, predicted, next));
        const joint_model::Uncertainty known = joint_model::uncertainty(asked, joint_.known().scatter);
        for (std::size_t e = 0; e < gap_case::kExperiments; ++e)
            for (const double sigma : known.sigma.of[e]) all.push_back(std::sqrt(known.weight[e]) / sigma);
    }
    return all;
}

}  // namespace fusee::effects
