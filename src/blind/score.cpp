#include "fusee/blind/score.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "faultless.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/json.h"
#include "fusee/core/progress.h"
#include "fusee/effects/joint.h"
#include "side_by_side.h"

namespace fusee::blind {

namespace fs = std::filesystem;

namespace {

struct HeldOutGap {
    double before = diagnosis::kNoFigure, after = diagnosis::kNoFigure;  ///< [sigma]
};
constexpr int kFaultlessRigs = 32;  ///< used to estimate sigma, to 12 %

constexpr std::uint64_t kRigs = 401;  ///< a stream that no case is drawn from

/// Deflections and joint torques are readings too.
gap_case::Rows inputs_off(const gap_case::Case& gap_case, gap_case::Rows rows, plant::Random& random) {
    const gap_case::Sensors& s = gap_case.sensors;
    const double encoder = std::hypot(s.encoder_noise, s.encoder_step / std::sqrt(12.0));
    for (gap_case::SpringPull& row : rows.spring_pull) row.deflection += encoder * random.normal();
    for (gap_case::StiffnessRow& row : rows.joint_stiffness)
        row.joint_torque += std::hypot(s.torque_noise, s.torque_noise_relative * row.joint_torque) * random.normal();
    return rows;
}

template <typename Visit>
void visit_figures(const joint_model::Signals& signals, const Visit& visit) {
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        for (std::size_t i = 0; i < signals[experiment].size(); ++i) visit(experiment, i);
}

joint_model::Signals sigma_of(const gap_case::Case& gap_case, const gap_case::Rows& rows, const joint_model::Signals& nominal) {
    joint_model::Signals sigma = sensor_sigma(gap_case, rows, nominal);
    const double share = 1.0 / std::sqrt(static_cast<double>(kFaultlessRigs));
    for (int i = 0; i < kFaultlessRigs; ++i) {
        plant::Random random(0, static_cast<std::uint64_t>(i), kRigs);
        const Faultless rig = draw_faultless(gap_case, random);
        const joint_model::Signals other =
            joint_model::measured(diagnosis::predict(rig.gap_case, rig.built, inputs_off(gap_case, rows, random)));
        visit_figures(nominal, [&](gap_case::Experiment e, std::size_t k) {
            sigma[e][k] = std::hypot(sigma[e][k], share * (other[e][k] - nominal[e][k]));
        });
    }
    return sigma;
}

/// Gap of the nominal model and of the diagnosed model on held-out measurements: root mean square of
/// (measured - predicted)/sigma over every measured figure, equally weighted. sigma^2 is that of the sensors plus the mean square by which
/// faultless rigs, drawn within tolerance and with noisy inputs, deviate from the nominal prediction
/// (docs/benchmark.md).
HeldOutGap held_out_gap(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found, const gap_case::Rows& rows) {
    const joint_model::Signals measured = joint_model::measured(rows),
                               nominal = joint_model::measured(diagnosis::predict(gap_case, {}, rows)),
                               after = joint_model::measured(diagnosis::predict(gap_case, found, rows)),
                               sigma = sigma_of(gap_case, rows, nominal);
    const auto gap_of = [&](const joint_model::Signals& predicted) {
        double sum = 0.0, figures = 0.0;
        visit_figures(measured, [&](gap_case::Experiment e, std::size_t i) {
            sum += std::pow((measured[e][i] - predicted[e][i]) / sigma[e][i], 2);
            ++figures;
        });
        return std::sqrt(sum / figures);
    };
    return {gap_of(nominal), gap_of(after)};
}

using Json = nlohmann::ordered_json;
constexpr const char *kDiagnosis = "diagnosis.json", *kHeldOut = "held_out.json",
                     *kOldHeldOut = "kept_back.json";  // read for one more version

/// Why a case has no diagnosis.
struct Failure {
    std::string why;
};

/// An error in reading or diagnosing a case, internal errors included, is a miss of that case; the others continue.
template <typename Work>
auto or_failure(const Work& work) {
    try {
        return work();
    } catch (const core::Stopped&) {
        throw;
    } catch (const std::exception& wrong) {
        throw Failure{wrong.what()};
    }
}

double number(const Json& j) { return j.is_number() ? j.get<double>() : diagnosis::kNoFigure; }

/// A file that is not a JSON object is ignored and written again.
Json object_or_none(const fs::path& file) {
    try {
        Json found = core::parse_json(core::read_file(file, diagnosis::kLargestFile), file.string());
        return found.is_object() ? found : Json::object();
    } catch (const core::InvalidInput&) {
        return Json::object();
    }
}

/// Reads alternatives and the claimed reduction of the gap.
void read_claims(const Json& j, Answer& answer) {
    if (j.contains("alternatives"))
        for (const Json& other : j["alternatives"]) {
            diagnosis::Alternative alternative{{}, number(other.at("probability"))};
            for (const Json& cause : other.at("effects"))
                alternative.effects.push_back({cause.at("id").get<std::string>(), cause.at("side").get<std::string>()});
            answer.alternatives.push_back(std::move(alternative));
        }
    if (!j.contains("gap")) return;
    answer.claimed_before = number(j["gap"].value("heldout_before", Json()));
    answer.claimed_after = number(j["gap"].value("heldout_after", Json()));
}

/// One case with its result folder.
class Desk {
public:
    Desk(const ScoreOptions& options, const std::string& name)
        : options_(options),
          place_(options.folder / "diagnoses" / name),
          gap_case_(or_failure([&] { return gap_case::read_case(options.folder / name); })) {
        answer_.case_name = name;
    }

    Answer answer() {
        if (options_.again || !holds_this_case()) diagnose();
        const std::string text = core::read_file(diagnosis_file(), diagnosis::kLargestFile);
        const diagnosis::Diagnosis found = or_failure([&] {
            const std::string file = diagnosis_file().string();
            diagnosis::Diagnosis read = diagnosis::parse_diagnosis(text, file);
            diagnosis::require_possible(gap_case_, read, file);
            read_claims(core::parse_json(text, file), answer_);
            return read;
        });
        answer_.verdict = found.verdict;
        answer_.effects = found.effects;
        answer_.form = found.unknown_terms;
        hold_out(found, core::sha256_hex(text));
        return answer_;
    }

private:
    [[nodiscard]] fs::path diagnosis_file() const { return place_ / kDiagnosis; }
    [[nodiscard]] bool holds_this_case() const {
        if (!fs::exists(diagnosis_file())) return false;
        const Json found = object_or_none(diagnosis_file());
        return found.value("case_sha256", Json()) == gap_case_.sha256;
    }

    void diagnose() {
        const auto asked = [this](std::size_t, std::size_t, const std::string&) {
            if (options_.stop && options_.stop()) throw core::Stopped();
        };
        const auto begin = std::chrono::steady_clock::now();
        const std::string found = or_failure([&] { return diagnosis::diagnosis_json(diagnosis::diagnose(gap_case_, {1, asked})); });
        answer_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        put(kDiagnosis, found);
    }

    /// The gap on heldout/ of the diagnosis with this hash. held_out.json holds the figures of an earlier run and its seconds.
    void hold_out(const diagnosis::Diagnosis& found, const std::string& diagnosis) {
        for (const char* name : {kHeldOut, kOldHeldOut}) {
            const Json known = fs::exists(place_ / name) ? object_or_none(place_ / name) : Json::object();
            if (known.value("diagnosis_sha256", Json()) != diagnosis || !known.contains("as_claimed_before")) continue;
            answer_.held_out_before = number(known.value("before", Json()));
            answer_.held_out_after = number(known.value("after", Json()));
            answer_.as_claimed = {number(known.value("as_claimed_before", Json())), number(known.value("as_claimed_after", Json()))};
            answer_.seconds = number(known.value("seconds", Json()));
            return;
        }
        const auto rows = or_failure([&] { return gap_case::read_inputs(gap_case_, options_.folder / answer_.case_name / "heldout"); });
        const HeldOutGap gap = or_failure([&] { return held_out_gap(gap_case_, found, rows); });
        answer_.as_claimed = or_failure([&] {
            gap_case::Case held_out = gap_case_;
            held_out.rows = rows;
            return diagnosis::carried_gap(effects::Joint(held_out), found);
        });
        answer_.held_out_before = gap.before;
        answer_.held_out_after = gap.after;
        const Json file{{"before", gap.before},
                        {"after", gap.after},
                        {"as_claimed_before", answer_.as_claimed.before},
                        {"as_claimed_after", answer_.as_claimed.after},
                        {"seconds", answer_.seconds},
                        {"diagnosis_sha256", diagnosis}};
        put(kHeldOut, file.dump(2) + "\n");
    }

    /// Writes one file next to existing ones; a third-party diagnosis is not replaced.
    void put(const char* name, const std::string& bytes) const {
        core::OutputFolder output(options_.folder, fs::path("diagnoses") / place_.filename(),
                                  {.command = std::string("blind score, ") + name,
                                   .source = options_.folder / answer_.case_name,
                                   .force = options_.force,
                                   .stays = true,
                                   .among_others = true});
        core::write_file(output.path() / name, bytes);
        output.commit();
    }

    const ScoreOptions& options_;
    const fs::path place_;
    const gap_case::Case gap_case_;
    Answer answer_;
};

/// The cases of a benchmark: its folders that hold a case.toml, by name; the first `limit` of them, 0: all.
/// @throws core::InvalidInput "folder" if it has none
std::vector<std::string> case_names(const fs::path& folder, std::size_t limit) {
    std::error_code failed;
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder, failed))
        if (fs::exists(entry.path() / "case.toml")) names.push_back(entry.path().filename().string());
    if (names.empty()) throw core::InvalidInput("folder", folder.string(), "a folder with cases of `fusee blind make`");
    std::sort(names.begin(), names.end());
    if (limit != 0 && names.size() > limit) names.resize(limit);
    return names;
}

/// Diagnoses a case on one thread and measures its gap on heldout/, or reads the existing result for the same case in FOLDER/diagnoses.
/// Opens only the folder of the case. A case that cannot be diagnosed gives an answer with `failure`.
/// @throws core::IoError if results cannot be written, core::Stopped
Answer answer_case(const ScoreOptions& options, const std::string& name) {
    try {
        return Desk(options, name).answer();
    } catch (const Failure& failure) {
        Answer answer;
        answer.case_name = name;
        answer.failure = failure.why;
        return answer;
    }
}

std::string told_hash(const ScoreOptions& options) {
    constexpr std::size_t kLargestSeal = 1000;
    return options.hash.empty() ? core::read_file(options.folder / "seal.txt", kLargestSeal) : options.hash;
}

std::vector<Answer> answer_all(const ScoreOptions& options) {
    const std::vector<std::string> names = case_names(options.folder, options.limit);
    std::vector<Answer> answers(names.size());
    side_by_side(
        names.size(), options.jobs,
        [&](std::size_t i) {
            if (options.stop && options.stop()) throw core::Stopped();
            answers[i] = answer_case(options, names[i]);
        },
        [&](std::size_t done, std::size_t i) {
            if (options.progress) options.progress(done, names.size(), names[i] + ": " + answer_name(answers[i]));
        });
    return answers;
}

}  // namespace

Score score(const ScoreOptions& options) {
    const std::string hash = told_hash(options);
    const std::string seal = core::sha256_hex(check_seal(options.folder, hash));
    const std::vector<Answer> answers = answer_all(options);
    std::vector<Label> labels = open_seal(options.folder, hash);
    if (options.limit != 0)  // labels of the cases that were left out
        std::erase_if(labels, [&](const Label& label) {
            return std::none_of(answers.begin(), answers.end(), [&](const Answer& a) { return a.case_name == label.case_name; });
        });
    Score score = score_answers(labels, answers);
    score.seal = seal;
    return score;
}

}  // namespace fusee::blind
