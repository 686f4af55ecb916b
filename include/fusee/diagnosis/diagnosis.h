#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/effects/effect.h"

/// The diagnosis of a gap case: location, cause and size of the gap (docs/gap.md). Written as diagnosis.json and as a page.
namespace fusee::diagnosis {

/// A missing value.
inline constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

enum class VerdictKind { kIdentified, kNone, kAmbiguous, kUnknown, kInconclusive, kPartlyExplained };
[[nodiscard]] const char* to_string(
    VerdictKind verdict);  ///< "identified", "none", "ambiguous", "unknown", "inconclusive", "partly_explained"

struct Parameter {
    double value = 0.0;
    core::Range ci95;
    std::string unit;
};
struct FoundEffect {
    inference::Cause cause;
    double probability = 0.0;
    Parameter parameter;
    std::vector<std::pair<std::string, double>> extra;  ///< further parameters of its law by name, for a later prediction
};
struct Alternative {
    std::vector<inference::Cause> effects;  ///< empty: no effect at all
    double probability = 0.0;
};
/// Contribution of one experiment to the gap. Shares sum to 1, greatest first.
struct GapContribution {
    std::string experiment;
    double share = 0.0;
    std::string variable;  ///< "cocontraction_Nm", ...
    core::Range region;
    std::string component;  ///< the spring, side or direction with most of it; may be empty
};
/// Root mean square of (measured - predicted)/sigma; kNoFigure where there is none.
struct Gap {
    double before = kNoFigure, after = kNoFigure, noise_floor = kNoFigure;
    double heldout_before = kNoFigure, heldout_after = kNoFigure;
    core::Range heldout_after_95{kNoFigure, kNoFigure};  ///< over the held-out blocks
};

/// One row of the ranking: a hypothesis of effects, or of none.
struct Hypothesis {
    std::vector<inference::Cause> effects;
    double log_evidence = 0.0;  ///< relative to the best, <= 0 [nats]
    double probability = 0.0;
    double chi2 = 0.0;                  ///< robust misfit, at the best parameters
    double left_out = kNoFigure;        ///< gap on experiments outside its fit [sigma]
    std::vector<Parameter> parameters;  ///< one for each effect
};
/// The gap in one cell of the map.
struct GapCell {
    std::string experiment, variable;
    core::Range region;
    double before = 0.0, after = 0.0;  ///< [sigma]
    std::size_t rows = 0;
};
struct ExperimentGap {
    std::string experiment;
    std::size_t rows = 0;
    Gap gap;
    double forecast = kNoFigure;  ///< expected heldout_after [sigma]
    std::string held_out = {};    ///< what the folds hold out as a whole: "8 torques", "3 levels"
    std::string unit = {};        ///< of the measured values, if all have the same; then the same gaps in it
    double before_in_unit = kNoFigure, after_in_unit = kNoFigure, heldout_in_unit = kNoFigure;
};
/// Measured values and predictions before and after, of one quantity over one variable.
struct Trace {
    std::string experiment, label;  ///< "q_high_rad over cocontraction_Nm"
    std::string x_name, y_name;
    std::vector<double> x, measured, before, after, sigma;
};
/// Which causes the experiments can distinguish. Similarity: |cosine| of two whitened signatures, nuisance parameters projected out.
struct Isolability {
    std::vector<inference::Cause> causes;
    std::vector<std::vector<double>> signature_similarity;  ///< [i][j], 1 on the diagonal
    std::vector<double> detectable;                         ///< least size detected at 3 sigma, in the unit of the parameter
    std::vector<double> named;                              ///< least size that would be named in 95 of 100 cases, the same unit
    std::vector<std::string> units;
    std::vector<std::vector<std::size_t>> classes;  ///< causes that these experiments cannot distinguish, two or more each
};
/// What the rows of a case would have shown of a cause, if it were there.
struct Power {
    inference::Cause cause;
    double least =
        kNoFigure;       ///< size that would have been named in 95 of 100 cases (of a limit, as a stop: the greatest); kNoFigure: none
    double usual = 0.0;  ///< size of such an effect on rigs that have it
    std::string unit;    ///< of both
    bool shown = false;  ///< the usual size would have been named
};
/// What effects fitted on some files of a case do on the file that is held out; a false cause fits its own file alone.
struct Transfer {
    std::vector<inference::Cause> effects;
    std::string fitted, heldout;                                   ///< names of files
    double fit_before = kNoFigure, fit_after = kNoFigure;          ///< root mean square error on the files of the fit [unit]
    double heldout_before = kNoFigure, heldout_after = kNoFigure;  ///< on the held-out file [unit]
    std::vector<Parameter> parameters;                             ///< the size of each effect in this fit, without an interval
    std::string unit;                                              ///< of the errors
};
/// The form of an effect that the library does not hold: a generic term (effects::Term) that explains the gap.
struct UnknownTerm {
    FoundEffect found;       ///< its cause has the id of the term
    std::string port;        ///< where it enters: "gear", "motor", "K_SE", "joint", ...
    std::string depends_on;  ///< "angle", "time", "load and time", "other motor"
    std::string law;         ///< with its symbols
    std::string sentence;    ///< the law with its values
    double log_odds = 0.0;   ///< against no term and against the library, what a term costs included [nats]
    std::string x_name,
        y_name;  ///< of its curve: "capstan_rad", "joint_rad", "end_share", "time_s", "torque_Nm"; "share", "torque_Nm", ...
    std::vector<double> x, y;
};
/// A further measurement that distinguishes the alternatives.
struct NextExperiment {
    std::string text;  ///< one sentence with its set points
    std::string experiment;
    std::vector<double> set_points;
    std::string variable;
    double information = 0.0;  ///< expected [bit]
    double cost = 0.0;         ///< [min]
};

/// What a fit of all build parameters would have claimed, without any effect and with priors so wide that they hardly count, as tools of
/// system identification fit.
struct Absorption {
    struct Moved {
        std::string name;
        double value = 0.0;             ///< as in Diagnosis::build
        double tolerances = kNoFigure;  ///< the same over its tolerance, one sigma; kNoFigure where nobody states one
        double with_cause = 0.0;        ///< of the fit with the cause
        std::string unit;
    };
    std::vector<Moved> moved;                             ///< every build parameter, most tolerances first
    double after = kNoFigure, heldout_after = kNoFigure;  ///< of this fit, as in Gap [sigma]
};

/// Does a cause hold on another case? kAgrees: the sizes are as close as their intervals allow; kDiffers: it is there with another size;
/// kGone: the other case shows that it is not there; kOpen: the rows of the other case do not tell.
enum class Survival { kAgrees, kDiffers, kGone, kOpen };
[[nodiscard]] const char* to_string(Survival survival);  ///< "agrees", "differs", "gone", "open"

/// The causes of a case on another case of the same model: another unit, gain, load or day.
struct Against {
    struct Carried {
        inference::Cause cause;
        Parameter here, there;  ///< size on the case of the diagnosis; fitted again on the other, kNoFigure where no experiment sees it
        Survival survival = Survival::kOpen;
    };
    std::string case_name, case_sha256;              ///< of the other case
    VerdictKind verdict = VerdictKind::kNone;        ///< of its own diagnosis
    std::vector<FoundEffect> effects;                ///< of its own diagnosis
    std::vector<Carried> causes;                     ///< of the first case
    double before = kNoFigure, carried = kNoFigure;  ///< gap there of the nominal model, and as the first diagnosis predicts it [sigma]
    double refitted = kNoFigure, own = kNoFigure;    ///< with the first case's causes and sizes fitted there; of the own diagnosis [sigma]
};

/// What an effect is, in the words of its model.
struct Meaning {
    std::string id, meaning, remedy, law;
};

struct Diagnosis {
    std::string case_name, case_sha256;
    VerdictKind verdict = VerdictKind::kNone;
    std::vector<FoundEffect> effects;
    std::vector<Alternative> alternatives;
    std::vector<GapContribution> where;
    Gap gap;
    std::string next_experiment;
    // The rest is for the page and for a later prediction; diagnosis.json has it under further keys.
    std::vector<std::pair<std::string, Parameter>> build;  ///< nuisance parameters as fitted, by name
    std::vector<ExperimentGap> experiments;
    std::vector<GapCell> map;
    std::vector<Hypothesis> ranking;
    Isolability isolability;
    std::vector<UnknownTerm> unknown_terms;  ///< at most two, only for the verdict unknown; `gap`, `build` and `traces` are then with them
    std::vector<Power> power;                ///< of every effect of the library on each side; for the verdicts none and inconclusive
    std::vector<Transfer> transfer;          ///< of subsystem cases with few files of different laws
    std::vector<Trace> traces;
    std::vector<NextExperiment> next;
    std::vector<std::string> remarks;           ///< limitations, disagreeing splits, gaps at the noise floor
    std::vector<Meaning> meanings = {};         ///< of the effects named, where the model has its own words
    std::optional<Absorption> absorption = {};  ///< where a cause or a form is shown and the model has figures to fit
    std::optional<Against> against = {};        ///< where another case was given
    std::vector<std::string> doubts = {};  ///< why a subsystem case has no certain answer: a default that decides, a search that stopped
};

inline constexpr std::size_t kLargestFile = 50'000'000;  ///< bytes of a diagnosis.json

/// Keys as docs/gap.md gives them. NaN is written as null.
[[nodiscard]] std::string diagnosis_json(const Diagnosis& diagnosis);
/// Reads what a prediction and the next case need: verdict, effects with extra parameters, build, next measurements. Third-party files may
/// have only `effects`.
/// @param file the name used in messages. @throws core::InvalidInput naming the key
[[nodiscard]] Diagnosis parse_diagnosis(std::string_view json, const std::string& file);
/// The same from a file. @throws core::InvalidInput naming the key, core::IoError
[[nodiscard]] Diagnosis read_diagnosis(const std::filesystem::path& file);

}  // namespace fusee::diagnosis
