#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/statistics.h"
#include "judge.h"
#include "shuffle.h"

namespace fusee::blind {

namespace {

constexpr double kNear = 0.1;  ///< of a claimed shrink
constexpr double kNormal95 = 1.959963984540054;
constexpr std::uint64_t kDealPurpose = 301;  ///< a stream that no case and no label is drawn from
constexpr std::array<double, 11> kStated{0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99, 0.999, 0.9999, 1.0};

/// A question on a case and its answer: whether it applies, and whether it is true.
struct Question {
    const char *key, *name;
    core::Range wanted;
    bool asks_label;  ///< whether shuffled labels are a control
    bool (*applies)(const Label&);
    bool (*so)(const Label&, const Answer&);
};

bool one(const Label& label) { return label.in_library && label.effects.size() == 1; }
bool two(const Label& label) { return label.in_library && label.effects.size() == 2; }
bool none(const Label& label) { return label.effects.empty(); }
bool outside(const Label& label) { return !label.in_library; }
bool inside(const Label& label) { return label.in_library; }
bool doubtful(const Label& label) { return !label.doubt.empty(); }
bool has_form(const Label&, const Answer& answer) { return !answer.form.empty(); }
bool named(const Label& label, const Answer& answer) { return names(answer, label, false); }
bool named_with_side(const Label& label, const Answer& answer) { return names(answer, label, true); }
template <diagnosis::VerdictKind verdict>
bool says(const Label&, const Answer& answer) {
    return has_verdict(answer, verdict);
}

constexpr core::Range kAny{0.0, 1.0};
constexpr std::array<Question, 20> kQuestions{{
    {"effect_named", "effect named", {0.95, 1.0}, true, one, named},
    {"effect_and_side", "effect and side named", {0.90, 1.0}, true, one, named_with_side},
    {"effect_left_open", "effect named, or among those that an ambiguous answer leaves", kAny, true, one,
     [](const Label& label, const Answer& answer) { return leaves_open(answer, label); }},
    {"none_on_null", "none on faultless rigs", {1.0, 1.0}, true, none, says<diagnosis::VerdictKind::kNone>},
    {"both_of_two", "both of two effects named", {0.75, 1.0}, true, two, named},
    {"both_of_two_and_sides", "both of two effects and their sides named", kAny, true, two, named_with_side},
    {"held_out_halved",
     "held-out gap at least halved",
     {0.95, 1.0},
     false,
     knows_effects,
     [](const Label&, const Answer& answer) { return halves_the_gap(answer); }},
    {"unknown_called_unknown", "unknown effects called unknown", {0.85, 1.0}, true, outside, says<diagnosis::VerdictKind::kUnknown>},
    {"known_called_unknown", "known effects called unknown", {0.0, 0.05}, true, knows_effects, says<diagnosis::VerdictKind::kUnknown>},
    {"known_not_seen", "known effects called none", kAny, true, knows_effects, says<diagnosis::VerdictKind::kNone>},
    {"form_given", "unknown effects with a form", kAny, true, outside, has_form},
    {"port_right",
     "unknown effects whose form enters at the right place",
     {0.8, 1.0},
     true,
     outside,
     [](const Label& label, const Answer& answer) { return has_port(answer, label); }},
    {"dependence_right",
     "unknown effects whose form depends on the right quantity",
     {0.7, 1.0},
     true,
     outside,
     [](const Label& label, const Answer& answer) { return has_dependence(answer, label); }},
    {"unknown_halved",
     "unknown effects whose held-out gap is at least halved",
     {0.6, 1.0},
     false,
     outside,
     [](const Label&, const Answer& answer) { return halves_the_gap(answer); }},
    {"outside_identified",
     "unknown effects called by a name of the library",
     {0.0, 0.15},
     true,
     outside,
     says<diagnosis::VerdictKind::kIdentified>},
    {"outside_misplaced",
     "unknown effects answered by a name at another place",
     {0.0, 0.05},
     true,
     outside,
     [](const Label& label, const Answer& answer) { return misplaced(answer, label) > 0; }},
    {"outside_place",
     "unknown effects whose place the answer tells, by a form or by names",
     {0.8, 1.0},
     true,
     outside,
     [](const Label& label, const Answer& answer) { return tells_place(answer, label); }},
    {"doubtful_right",
     "doubtful cases with the right answer, certain or left open",
     {0.9, 1.0},
     true,
     doubtful,
     [](const Label& label, const Answer& answer) { return is_right_in_doubt(answer, label); }},
    {"doubtful_false",
     "doubtful cases with a wrong effect among those identified",
     {0.0, 0.0},
     false,
     doubtful,
     [](const Label& label, const Answer& answer) { return identifies_a_wrong_effect(answer, label); }},
    {"form_invented", "faultless rigs and known effects with a form", {0.0, 0.02}, true, inside, has_form},
}};

Share ask(const Question& question, const std::vector<const Label*>& labels, const std::vector<Answer>& answers) {
    Share share;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (question.applies(*labels[i])) share.count(question.so(*labels[i], answers[i]));
    return share;
}

/// The control: score of the same answers with shuffled labels.
void deal_anew(std::vector<Figure>& figures, std::vector<const Label*> labels, const std::vector<Answer>& answers, std::uint64_t seed) {
    std::vector<std::vector<double>> values(kQuestions.size());
    for (std::size_t deal = 0; deal < kDeals; ++deal) {
        plant::Random random(seed, deal, kDealPurpose);
        shuffle(labels, random);
        for (std::size_t q = 0; q < kQuestions.size(); ++q)
            if (kQuestions[q].asks_label) values[q].push_back(ask(kQuestions[q], labels, answers).value());
    }
    for (std::size_t q = 0; q < kQuestions.size(); ++q) {
        std::vector<double>& v = values[q];
        if (v.empty() || std::isnan(v.front())) continue;
        std::sort(v.begin(), v.end());
        figures[q].shuffled = 0.0;
        for (const double value : v) figures[q].shuffled += value / static_cast<double>(v.size());
        figures[q].shuffled95 = {v[v.size() / 40], v[v.size() - 1 - v.size() / 40]};
    }
}

/// Each answer's label; none twice, none left over.
std::vector<const Label*> labels_of(const std::vector<Label>& labels, const std::vector<Answer>& answers) {
    std::map<std::string, const Label*> by_name;
    for (const Label& label : labels) by_name[label.case_name] = &label;
    std::vector<const Label*> found;
    for (const Answer& answer : answers) {
        const auto label = by_name.extract(answer.case_name);
        if (label.empty()) throw core::InvalidInput("case", answer.case_name, "a case that the sealed labels name, once");
        found.push_back(label.mapped());
    }
    if (!by_name.empty())
        throw core::InvalidInput("case", by_name.begin()->first + " is missing", "every case that the sealed labels name");
    return found;
}

/// Stated effects: probability and interval.
void score_statements(Score& score, const Label& label, const Answer& answer, std::vector<double>& stated, Share& intervals) {
    if (!answer.failure.empty()) return;
    for (const diagnosis::FoundEffect& effect : answer.effects) {
        const LabelEffect* truth = found_in(label, effect);
        for (std::size_t b = 0; b < score.calibration.size(); ++b) {
            CalibrationBin& bin = score.calibration[b];
            const bool last = b + 1 == score.calibration.size();
            if (effect.probability < bin.stated.low || (effect.probability >= bin.stated.high && !last)) continue;
            bin.right.count(truth != nullptr);
            stated[b] += effect.probability;
        }
        if (truth == nullptr) continue;
        const bool holds = effect.parameter.ci95.holds(truth->size);
        intervals.count(holds);
        score.coverage[truth->id].count(holds);
    }
}

void time(Score& score, const std::vector<Answer>& answers) {
    std::vector<double> seconds;
    for (const Answer& answer : answers)
        if (!std::isnan(answer.seconds)) seconds.push_back(answer.seconds);
    if (seconds.empty()) return;
    score.median_seconds = math::median(seconds);
    score.worst_seconds = *std::max_element(seconds.begin(), seconds.end());
}

/// The id of one effect, or how many there are.
std::string name_of(const std::string& first, std::size_t effects) {
    static constexpr std::array kMany{"two effects", "three effects", "four effects"};
    return effects == 1 ? first : kMany.at(std::min(effects - 2, kMany.size() - 1));
}

/// A figure that shuffled labels say nothing about.
Figure counted(const char* key, const char* name, const Share& share, const core::Range& wanted) {
    return {key, name, share, wanted, diagnosis::kNoFigure, {diagnosis::kNoFigure, diagnosis::kNoFigure}};
}

/// Whether the claimed shrink is the one on heldout/: every measured value with the same weight; in the claim's unit; and in that unit with
/// the gap that those runs have before, which a claim cannot know.
std::vector<Figure> shrink_figures(const std::vector<ShrinkRow>& rows) {
    const auto near = [&](const char* key, const char* name, double ShrinkRow::*claimed, double ShrinkRow::*measured) {
        Share share;
        for (const ShrinkRow& row : rows) share.count(std::abs(row.*claimed - row.*measured) <= kNear);
        return counted(key, name, share, {0.9, 1.0});
    };
    return {near("shrink_evenly", "claimed and measured shrink within 0.1", &ShrinkRow::claimed, &ShrinkRow::measured),
            near("shrink_as_claimed", "the same in the claim's unit", &ShrinkRow::claimed, &ShrinkRow::as_claimed),
            near("shrink_of_runs", "the same of the gap that those runs have", &ShrinkRow::of_runs, &ShrinkRow::as_claimed)};
}

}  // namespace

double Share::value() const { return of == 0 ? diagnosis::kNoFigure : static_cast<double>(hits) / static_cast<double>(of); }

core::Range Share::wilson95() const {
    if (of == 0) return {0.0, 1.0};
    const auto n = static_cast<double>(of);
    const double p = value(), z2 = kNormal95 * kNormal95, middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
    const double half = kNormal95 / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
    return {hits == 0 ? 0.0 : middle - half, hits == of ? 1.0 : middle + half};
}

std::string answer_name(const Answer& answer) {
    if (!answer.failure.empty()) return "failed";
    if (!has_name(answer)) return to_string(answer.verdict);
    return answer.effects.empty() ? "failed" : name_of(answer.effects.front().cause.id, answer.effects.size());
}

std::string truth_name(const Label& label) {
    return label.effects.empty() ? "none" : name_of(label.effects.front().id, label.effects.size());
}

const Figure& Score::figure(const std::string& key) const {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.key == key; });
    assert(found != figures.end());
    return *found;
}

Score score_answers(const std::vector<Label>& labels, const std::vector<Answer>& answers, std::uint64_t seed) {
    const std::vector<const Label*> of = labels_of(labels, answers);
    Score score;
    score.cases = answers.size();
    for (const Question& q : kQuestions)
        score.figures.push_back(
            {q.key, q.name, ask(q, of, answers), q.wanted, diagnosis::kNoFigure, {diagnosis::kNoFigure, diagnosis::kNoFigure}});
    deal_anew(score.figures, of, answers, seed);
    for (std::size_t b = 0; b + 1 < kStated.size(); ++b)
        score.calibration.push_back({{kStated[b], kStated[b + 1]}, diagnosis::kNoFigure, {}});
    std::vector<double> stated(score.calibration.size(), 0.0);
    Share intervals;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Answer& answer = answers[i];
        ++score.confusion[truth_name(*of[i])][answer_name(answer)];
        score_statements(score, *of[i], answer, stated, intervals);
        if (!answer.effects.empty() && answer.claimed_before > 0.0 && answer.held_out_before > 0.0)
            score.shrink.push_back({answer.case_name, answer.claimed_after / answer.claimed_before,
                                    answer.held_out_after / answer.held_out_before, answer.as_claimed.after / answer.as_claimed.before,
                                    answer.claimed_after / answer.as_claimed.before});
        if (const std::string what = miss_of(*of[i], answer); !what.empty()) score.misses.push_back({*of[i], answer, what});
    }
    for (std::size_t b = 0; b < stated.size(); ++b)
        if (score.calibration[b].right.of > 0)
            score.calibration[b].mean_stated = stated[b] / static_cast<double>(score.calibration[b].right.of);
    score.figures.push_back(counted("intervals_hold", "95 % intervals that hold the true size", intervals, {0.90, 0.99}));
    for (Figure& figure : shrink_figures(score.shrink)) score.figures.push_back(std::move(figure));
    time(score, answers);
    return score;
}

}  // namespace fusee::blind
