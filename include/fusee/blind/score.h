#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fusee/blind/blind.h"
#include "fusee/core/units.h"
#include "fusee/diagnosis/diagnose.h"

/// Score of the diagnoses of a sealed benchmark after the seal is opened (docs/benchmark.md).
namespace fusee::blind {

/// A share: hits of a number.
struct Share {
    std::size_t hits = 0, of = 0;
    [[nodiscard]] double value() const;          ///< kNoFigure if of = 0
    [[nodiscard]] core::Range wilson95() const;  ///< 95 % score interval (Wilson 1927); 0 to 1 if of = 0
    void count(bool hit) { hits += hit, ++of; }
};

/// Diagnosis of a case before its label was known, and its gap on held-out rows.
struct Answer {
    std::string case_name;
    std::string failure;  ///< reason for a missing diagnosis; "" if there is one
    diagnosis::VerdictKind verdict = diagnosis::VerdictKind::kUnknown;
    std::vector<diagnosis::FoundEffect> effects;
    std::vector<diagnosis::Alternative> alternatives;
    std::vector<diagnosis::UnknownTerm> form;  ///< of an unknown effect
    double claimed_before = diagnosis::kNoFigure,
           claimed_after = diagnosis::kNoFigure;  ///< heldout_before, heldout_after of the diagnosis [sigma]
    double held_out_before = diagnosis::kNoFigure, held_out_after = diagnosis::kNoFigure;  ///< on the case's folder heldout/ [sigma]
    diagnosis::CarriedGap as_claimed;       ///< on heldout/ in the claim's own unit and weights
    double seconds = diagnosis::kNoFigure;  ///< of the diagnosis, on one thread
};
/// An effect named: "gear.coulomb", else "two effects", "none", "ambiguous", "unknown" or "failed".
[[nodiscard]] std::string answer_name(const Answer& answer);
/// Built-in effects: an id, "outside.NAME", "two effects" or "none".
[[nodiscard]] std::string truth_name(const Label& label);

/// One metric of the benchmark with its control.
struct Figure {
    std::string key, name;  ///< "effect_named", "effect named"
    Share share;
    core::Range wanted{0.0, 1.0};  ///< target of the project
    /// The same with shuffled labels: mean, and 95 % of the shuffles. NaN where labels do not matter.
    double shuffled = diagnosis::kNoFigure;
    core::Range shuffled95{diagnosis::kNoFigure, diagnosis::kNoFigure};
};

/// Effects stated with a probability in [from, to): share of true ones.
struct CalibrationBin {
    core::Range stated;
    double mean_stated = diagnosis::kNoFigure;
    Share right;
};
struct ShrinkRow {
    std::string case_name;
    double claimed = 0.0, measured = 0.0;  ///< gap after over gap before: in the diagnosis, and on heldout/
    double as_claimed = 0.0;               ///< on heldout/, in the claim's own unit and weights
    double of_runs = 0.0;                  ///< claimed gap after over the gap before on heldout/, in that unit
};
struct Miss {
    Label truth;
    Answer answer;
    std::string what;  ///< "another effect", "another side", "not halved", ...
};

struct Score {
    std::string seal;  ///< SHA-256 of the labels
    std::size_t cases = 0;
    std::vector<Figure> figures;
    std::map<std::string, std::map<std::string, std::size_t>> confusion;  ///< truth_name, answer_name
    std::vector<CalibrationBin> calibration;
    std::map<std::string, Share> coverage;  ///< by id: 95 % intervals that hold the true size
    std::vector<ShrinkRow> shrink;          ///< of cases with a named effect
    double median_seconds = diagnosis::kNoFigure, worst_seconds = diagnosis::kNoFigure;
    std::vector<Miss> misses;
    /// @pre there is one
    [[nodiscard]] const Figure& figure(const std::string& key) const;
};

inline constexpr std::size_t kDeals = 400;  ///< shuffles of the labels for the control

/// Pure arithmetic. @param seed of the shuffles
/// @throws core::InvalidInput "case" if a case has no label, or a label no case
[[nodiscard]] Score score_answers(const std::vector<Label>& labels, const std::vector<Answer>& answers, std::uint64_t seed = 1);

struct ScoreOptions {
    std::filesystem::path folder;  ///< as make_benchmark left it; FOLDER/diagnoses/CASE gets diagnosis.json and held_out.json
    std::string hash;              ///< the seal printed when the benchmark was made; "": that of seal.txt
    unsigned jobs = 0;             ///< cases in parallel, one thread each; 0: as many as cores; the score does not depend on it
    std::size_t limit = 0;         ///< the first cases only; 0: all
    bool again = false;            ///< repeat existing diagnoses
    bool force = false;            ///< as in core::OutputRun
    /// Called after each finished case, never concurrently. An exception ends the work.
    std::function<void(std::size_t done, std::size_t of, const std::string& what)> progress;
    /// Polled: true ends the work with core::Stopped. Finished diagnoses are kept.
    std::function<bool()> stop;
};
/// Diagnoses every case, then opens the seal. A case that cannot be diagnosed is a miss.
/// @throws core::InvalidInput "seal" if it is broken, before any case is diagnosed and again before any is scored; "folder" without cases;
/// core::IoError; core::Stopped
[[nodiscard]] Score score(const ScoreOptions& options);

/// Keys as docs/benchmark.md gives them; a NaN is null. @param model score of the cases made by the model, or none
[[nodiscard]] std::string score_json(const Score& score, const std::optional<Score>& model = {});

}  // namespace fusee::blind
