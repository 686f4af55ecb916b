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
#include "fusee/diagnosis/diagnosis.h"

/// What the diagnoses of a sealed benchmark are worth once the seal is opened (docs/gap-benchmark.md).
namespace fusee::blind {

/// How often something was so.
struct Share {
    std::size_t hits = 0, of = 0;
    [[nodiscard]] double value() const;          ///< kNoFigure of none
    [[nodiscard]] core::Range wilson95() const;  ///< 95 % score interval (Wilson 1927); 0 to 1 of none
    void count(bool hit) { hits += hit, ++of; }
};

/// What was said of a case before its label was known, and how far that shrank the gap on rows held out.
struct Answer {
    std::string case_name;
    std::string failure;  ///< why there is no diagnosis; "" if there is one
    diagnosis::VerdictKind verdict = diagnosis::VerdictKind::kUnknown;
    std::vector<diagnosis::FoundEffect> effects;
    std::vector<diagnosis::Alternative> alternatives;
    double claimed_before = diagnosis::kNoFigure,
           claimed_after = diagnosis::kNoFigure;  ///< heldout_before, heldout_after of the diagnosis [sigma]
    double held_out_before = diagnosis::kNoFigure, held_out_after = diagnosis::kNoFigure;  ///< on the case's folder heldout/ [sigma]
    double seconds = diagnosis::kNoFigure;                                                 ///< the diagnosis took, on one thread
};
/// An effect named: "gear.coulomb", else "two effects", "none", "ambiguous", "unknown" or "failed".
[[nodiscard]] std::string answer_name(const Answer& answer);
/// What was built in: an id, "outside.NAME", "two effects" or "none".
[[nodiscard]] std::string truth_name(const Label& label);

/// One figure of the benchmark with its control.
struct Figure {
    std::string key, name;  ///< "effect_named", "effect named"
    Share share;
    core::Range wanted{0.0, 1.0};  ///< what the project asks of itself
    /// The same with the labels dealt anew among the cases: mean, and 95 % of the deals. NaN where labels do not enter.
    double shuffled = diagnosis::kNoFigure;
    core::Range shuffled95{diagnosis::kNoFigure, diagnosis::kNoFigure};
};

/// Effects stated with a probability in [from, to): how often they were there.
struct CalibrationBin {
    core::Range stated;
    double mean_stated = diagnosis::kNoFigure;
    Share right;
};
struct ShrinkRow {
    std::string case_name;
    double claimed = 0.0, measured = 0.0;  ///< gap after over gap before: in the diagnosis, and on heldout/
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
    std::vector<ShrinkRow> shrink;          ///< of cases in whose diagnosis an effect is named
    double median_seconds = diagnosis::kNoFigure, worst_seconds = diagnosis::kNoFigure;
    std::vector<Miss> misses;
    /// @pre there is one
    [[nodiscard]] const Figure& figure(const std::string& key) const;
};

inline constexpr std::size_t kDeals = 400;  ///< of the labels, for the control

/// Pure arithmetic. @param seed of the deals of the control
/// @throws core::InvalidInput "case" if a case has no label, or a label no case
[[nodiscard]] Score score_answers(const std::vector<Label>& labels, const std::vector<Answer>& answers, std::uint64_t seed = 1);

struct ScoreOptions {
    std::filesystem::path folder;  ///< as make_benchmark left it; FOLDER/diagnoses/CASE gets diagnosis.json and held_out.json
    std::string hash;              ///< the seal as told when the benchmark was made; "": as seal.txt says
    unsigned jobs = 0;             ///< cases side by side, each on one thread; 0: as many as cores; the score is the same for any
    std::size_t limit = 0;         ///< the first cases only; 0: all
    bool again = false;            ///< make diagnoses anew that lie there already
    bool force = false;            ///< where files are written: as core::OutputRun has it
    /// Told of each finished case; calls do not overlap. What it throws ends the work.
    std::function<void(std::size_t done, std::size_t of, const std::string& what)> progress;
    /// Asked often: true ends the work with core::Stopped. Finished diagnoses stay and are not made again.
    std::function<bool()> stop;
};
/// Diagnoses every case, and only then opens the seal. A case that cannot be diagnosed is a miss.
/// @throws core::InvalidInput "seal" if it is broken, before any case is diagnosed and again before any is scored; "folder" without cases;
/// core::IoError; core::Stopped
[[nodiscard]] Score score(const ScoreOptions& options);

/// Keys as docs/gap-benchmark.md gives them; a NaN is null. @param model score of the cases that the model itself made, or none
[[nodiscard]] std::string score_json(const Score& score, const std::optional<Score>& model = {});

}  // namespace fusee::blind
