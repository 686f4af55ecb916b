#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "fusee/core/error.h"
#include "fusee/diagnosis/gap_map.h"
#include "fusee/diagnosis/grounds.h"
#include "fusee/inference/search.h"
#include "fusee/math/statistics.h"
#include "law.h"
#include "remarks.h"
#include "study.h"

namespace fusee::subsystem {

namespace {

/// 95 % interval of a parameter: the wider of the fit's covariance, for rows that depend on each other, and the jackknife over what is held
/// out one by one (J. W. Tukey, Ann. Math. Statist. 29, 1958).
diagnosis::Parameter parameter_of(const Law& law, const Study& study, const Candidate& candidate, std::size_t parameter) {
    const auto& free = candidate.fit.free;
    const auto j = static_cast<std::size_t>(std::find(free.begin(), free.end(), parameter) - free.begin());
    const double rows = std::accumulate(study.effective_rows.begin(), study.effective_rows.end(), 0.0),
                 square = std::pow(candidate.seen_gap(), 2);
    double variance = candidate.fit.covariance[j][j] * square * candidate.fit.rows / rows;
    double freedom = std::max(1.0, rows - static_cast<double>(free.size()));
    if (!candidate.refits.empty() && candidate.refits[0].size() > 2) {
        const auto& refits = candidate.refits[0];
        const auto n = static_cast<double>(refits.size());
        double mean = 0.0, spread = 0.0;
        for (const Values& v : refits) mean += v[parameter] / n;
        for (const Values& v : refits) spread += std::pow(v[parameter] - mean, 2);
        const double jackknife = spread * (n - 1.0) / n;
        if (jackknife > variance) variance = jackknife, freedom = n - 1.0;
    }
    const double half = math::student_quantile(0.95, static_cast<std::size_t>(freedom)) * std::sqrt(variance);
    const double value = candidate.fit.values[parameter];
    core::Range ci95{value - half, value + half};
    if (law.each_fold && !candidate.refits.empty())  // few files: what each part alone says
        for (const Values& refit : candidate.refits[0])
            ci95 = {std::min(ci95.low, refit[parameter]), std::max(ci95.high, refit[parameter])};
    return {value,
            {std::max(law.parameters[parameter].low, ci95.low), std::min(law.parameters[parameter].high, ci95.high)},
            law.parameters[parameter].unit};
}

/// The set that the evidence prefers although the splits refuse it, if a gap remains.
const Candidate* preferred_by_evidence(const Law& law, const Study& study) {
    const Candidate& best = study.candidates[study.best];
    if (best.seen_gap() <= inference::kStructure * law.setup_floor) return nullptr;
    const Candidate* most = &best;
    for (const Candidate& t : study.candidates)
        if (t.effects.size() <= law.most_effects && !t.refused.empty() && !t.unlikely && !t.stopped && t.log_evidence > most->log_evidence)
            most = &t;
    return most->log_evidence > best.log_evidence + inference::kDisagreement ? most : nullptr;
}

void share_with_refused(const Law& law, Study& study, diagnosis::Diagnosis& out) {
    const Candidate* other = study.equals.empty() ? preferred_by_evidence(law, study) : nullptr;
    if (other == nullptr) return;
    const auto place = static_cast<std::size_t>(other - study.candidates.data());
    for (Candidate& t : study.candidates) t.probability *= inference::kUnsureShare;
    study.candidates[place].probability += 1.0 - inference::kUnsureShare;
    out.remarks.push_back(fmt::format("evidence and splits disagree: the evidence prefers {} by {:.0f} nats, which the splits refuse ({})",
                                      name_of(law, other->effects), other->log_evidence - study.candidates[study.best].log_evidence,
                                      other->refused));
}

/// The set that the evidence prefers although the search for one of its effects stopped at an end, if a gap remains.
const Candidate* beyond_range(const Law& law, const Study& study) {
    const Candidate& best = study.candidates[study.best];
    if (best.seen_gap() <= law.setup_floor) return nullptr;
    const Candidate* most = nullptr;
    for (const Candidate& t : study.candidates)
        if (t.stopped && t.log_evidence > (most != nullptr ? most->log_evidence : best.log_evidence + inference::kDisagreement)) most = &t;
    return most;
}

/// Figures that nobody gave and that decide. @param left by the fit [sigma]
std::vector<std::string> defaults_of(const Law& law, double left) {
    std::vector<std::string> doubts = law.defaults;
    if (!law.default_sigma.empty() && (left < 1.0 / inference::kOtherSigma || left > inference::kOtherSigma))
        doubts.push_back(fmt::format("{}, but the fit leaves {:.2g} of it", law.default_sigma, left));
    return doubts;
}

/// What forbids a certain answer.
std::vector<std::string> doubts_of(const Law& law, const Study& study) {
    const Candidate& best = study.candidates[study.best];
    std::vector<std::string> doubts = defaults_of(law, best.seen_gap());
    if (const Candidate* other = beyond_range(law, study)) {
        const LawEffect& effect = law.effects[*other->stopped];
        doubts.push_back(fmt::format("the rows prefer {} by {:.0f} nats, with {} {}: that is no size of an effect{}",
                                     name_of(law, other->effects), other->log_evidence - best.log_evidence, name_of(effect),
                                     stopped_at(law, effect.parameters, other->fit.values),
                                     effect.figures.empty() ? "" : "; check " + effect.figures));
    }
    for (std::size_t k = 0; k < law.nominal; ++k)
        if (const std::string end = stopped_at(law, {k}, best.fit.values); !end.empty())
            doubts.push_back(fmt::format("{} is {}: the model does not hold there", law.parameters[k].name, end));
    for (const std::size_t e : best.effects) {
        const std::size_t k = law.effects[e].parameters.front();
        const diagnosis::Parameter size = parameter_of(law, study, best, k);
        if (size.ci95.low <= law.parameters[k].low && size.ci95.high >= law.parameters[k].high)
            doubts.push_back(fmt::format("the rows leave the size of {} open: its interval is its whole range, {:.4g} to {:.4g}{}{}",
                                         name_of(law.effects[e]), size.ci95.low, size.ci95.high, size.unit.empty() ? "" : " ", size.unit));
    }
    return doubts;
}

diagnosis::Grounds grounds_of(const Study& study, const Law& law, bool doubted) {
    const Candidate& best = study.candidates[study.best];
    double next = 0.0;
    for (const Candidate& t : study.candidates)
        if (&t != &best) next = std::max(next, t.probability);
    const bool left = best.unseen_gap(0) > inference::kStructure * law.setup_floor;
    diagnosis::Grounds grounds{true, inference::rivalled(best.probability, next), !best.effects.empty(), doubted};
    grounds.doubted = grounds.doubted || (grounds.named && study.hidden);
    grounds.rivalled = grounds.rivalled || (grounds.named && left && study.stability < inference::kStable);
    grounds.explains = grounds.named || grounds.rivalled || !left;  // what is named need not explain all
    return grounds;
}

void put_effects(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    const Candidate& best = study.candidates[study.best];
    for (const std::size_t e : best.effects) {
        const auto& parameters = law.effects[e].parameters;
        diagnosis::FoundEffect found{law.effects[e].cause, study.probability_of(e), parameter_of(law, study, best, parameters.front()), {}};
        for (std::size_t k = 1; k < parameters.size(); ++k)
            found.extra.emplace_back(law.parameters[parameters[k]].name, best.fit.values[parameters[k]]);
        out.effects.push_back(std::move(found));
    }
    for (std::size_t k = 0; k < law.nominal; ++k) out.build.emplace_back(law.parameters[k].name, parameter_of(law, study, best, k));
    if (law.open_input) {
        const double choice = law.open_input->choices[study.choice].first;
        out.build.emplace_back(law.parameters[law.open_input->parameter].name, diagnosis::Parameter{choice, {choice, choice}, ""});
    }
    for (const Candidate& t : study.candidates)
        if (&t != &best && t.probability >= inference::kLeastAlternative) out.alternatives.push_back({causes_of(law, t), t.probability});
    std::sort(out.alternatives.begin(), out.alternatives.end(),
              [](const diagnosis::Alternative& a, const diagnosis::Alternative& b) { return a.probability > b.probability; });
}

void put_ranking(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    double most = study.candidates.front().log_evidence;
    for (const Candidate& t : study.candidates) most = std::max(most, t.log_evidence);
    for (const Candidate& t : study.candidates) {
        diagnosis::Hypothesis h{causes_of(law, t),
                                t.log_evidence - most,
                                t.probability,
                                t.fit.cost,
                                t.unseen.empty() ? diagnosis::kNoFigure : t.unseen_gap(),
                                {}};
        for (const std::size_t e : t.effects) h.parameters.push_back(parameter_of(law, study, t, law.effects[e].parameters.front()));
        out.ranking.push_back(std::move(h));
    }
    std::stable_sort(out.ranking.begin(), out.ranking.end(), [](const diagnosis::Hypothesis& a, const diagnosis::Hypothesis& b) {
        return a.probability != b.probability ? a.probability > b.probability : a.log_evidence > b.log_evidence;
    });
}

/// The nominal law with its parameters fitted is the fit without any effect.
void put_absorption(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    const Candidate &plain = study.candidates.front(), &best = study.candidates[study.best];
    if (best.effects.empty() || law.nominal == 0) return;
    diagnosis::Absorption absorption{{}, out.gap.before, out.gap.heldout_before};
    for (std::size_t k = 0; k < law.nominal; ++k)
        absorption.moved.push_back(
            {law.parameters[k].name, plain.fit.values[k], diagnosis::kNoFigure, best.fit.values[k], law.parameters[k].unit});
    out.absorption = std::move(absorption);
}

void put_map(const LawModel& model, const Values& before, const Values& after, diagnosis::Diagnosis& out) {
    const inference::Problem problem(model);
    const Eigen::VectorXd nominal = problem.residual(model.outputs(before));
    out.map = diagnosis::gap_map(problem, nominal, problem.residual(model.outputs(after)));
    out.where = diagnosis::gap_contributions(problem, nominal);
}

diagnosis::Gap gap_over(const Candidate& nominal, const Candidate& best, const std::vector<std::size_t>& blocks, double floor) {
    const auto over = [&](const Misfit& m) { return std::sqrt(m.mean_square(blocks)); };
    return {over(nominal.seen),      over(best.seen),      floor,
            over(nominal.unseen[0]), over(best.unseen[0]), {diagnosis::kNoFigure, diagnosis::kNoFigure}};
}

void put_gaps(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    const Candidate &nominal = study.candidates.front(), &best = study.candidates[study.best];
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t b = 0; b < law.blocks.size(); ++b) groups[law.targets[law.blocks[b].record].group].push_back(b);
    out.gap = gap_over(nominal, best, all_blocks(law), law.cycle_floor);
    out.gap.heldout_after_95 = study.heldout_after_95;
    for (const auto& [group, blocks] : groups) {
        diagnosis::ExperimentGap part{group, 0, gap_over(nominal, best, blocks, law.cycle_floor), out.gap.heldout_after};
        for (const std::size_t b : blocks) part.rows += law.blocks[b].rows.size();
        out.experiments.push_back(std::move(part));
    }
}

void put_traces(const Case& subsystem_case, const Law& law, const Values& before, const Values& after, diagnosis::Diagnosis& out) {
    std::vector<double> nominal, found;
    for (std::size_t r = 0; r < law.targets.size(); ++r) {
        const Target& target = law.targets[r];
        law.predict(r, before, nominal);
        law.predict(r, after, found);
        diagnosis::Trace trace;
        trace.experiment = target.group;
        trace.label = fmt::format("{} of {}", law.measured_name, subsystem_case.records[r].file);
        trace.y_name = law.measured_name;
        const auto& columns = subsystem_case.records[r].columns;
        trace.x_name = columns.contains("t_s") && !law.over_region ? "t_s" : law.region_name;
        const std::vector<double>& x = columns.at(trace.x_name);
        const std::size_t rows = target.measured.size(), thin = x.size() / rows + (x.size() % rows > rows / 2 ? 1 : 0);
        for (std::size_t i = 0; i < rows; i += (rows + inference::kMostPoints - 1) / inference::kMostPoints) {
            const double at = x[std::min(i * std::max<std::size_t>(1, thin), x.size() - 1)];
            if (law.over_region && !trace.x.empty() && trace.x.back() == at) continue;  // at rest
            trace.x.push_back(at);
            trace.measured.push_back(target.measured[i]);
            trace.before.push_back(nominal[i]);
            trace.after.push_back(found[i]);
            trace.sigma.push_back(target.sigma[i]);
        }
        out.traces.push_back(std::move(trace));
    }
}

double entropy_bits(const Study& study) {
    double bits = 0.0;
    for (const Candidate& t : study.candidates)
        if (t.probability > 0.0) bits -= t.probability * std::log2(t.probability);
    return bits;
}

/// By the engine of every model.
diagnosis::Diagnosis diagnose_exact(const Case& subsystem_case, const Law& law, const diagnosis::DiagnoseOptions& options) {
    require_rows(law);
    diagnosis::Diagnosis out = diagnosis::diagnose_model(LawModel(law), {subsystem_case.name, subsystem_case.sha256}, options);
    out.remarks.insert(out.remarks.begin(), subsystem_case.remarks.begin(), subsystem_case.remarks.end());
    out.doubts = defaults_of(law, out.gap.after);
    if (std::any_of(out.effects.begin(), out.effects.end(), [&](const diagnosis::FoundEffect& found) {
            return std::find(law.same_rows.begin(), law.same_rows.end(), found.cause.id) != law.same_rows.end();
        }))
        out.doubts.push_back(fmt::format("{} give the same rows in any such test", fmt::join(law.same_rows, " and ")));
    const bool certain = out.verdict == diagnosis::VerdictKind::kIdentified || out.verdict == diagnosis::VerdictKind::kNone;
    if (certain) out.verdict = diagnosis::verdict_of({.named = !out.effects.empty(), .doubted = !out.doubts.empty()});
    out.next.push_back(law.next());
    out.next_experiment = out.next.back().text;
    return out;
}

}  // namespace

diagnosis::Diagnosis diagnose(const Case& subsystem_case, const diagnosis::DiagnoseOptions& options) {
    if (subsystem_case.records.empty()) throw core::InvalidInput("experiments", "no file", "at least one");
    const auto law = law_of(subsystem_case);
    if (law->exact) return diagnose_exact(subsystem_case, *law, options);
    Study study = subsystem::study(*law, options);
    diagnosis::Diagnosis out;
    out.case_name = subsystem_case.name;
    out.case_sha256 = subsystem_case.sha256;
    out.remarks = subsystem_case.remarks;
    share_with_refused(*law, study, out);
    out.doubts = doubts_of(*law, study);
    out.verdict = diagnosis::verdict_of(grounds_of(study, *law, !out.doubts.empty()));
    put_effects(*law, study, out);
    put_ranking(*law, study, out);
    put_gaps(*law, study, out);
    put_absorption(*law, study, out);
    const Values &before = study.candidates.front().fit.values, &after = study.candidates[study.best].fit.values;
    put_map(LawModel(*law), before, after, out);
    put_traces(subsystem_case, *law, before, after, out);
    put_remarks(*law, study, out);
    out.next.push_back(law->next());
    if (const std::string split = law->split(open_effects(study)); !split.empty())
        out.next.back().text = split + "; " + out.next.back().text;
    out.next.back().information = entropy_bits(study);
    out.next_experiment = out.next.back().text;
    if (out.verdict != diagnosis::VerdictKind::kIdentified && out.verdict != diagnosis::VerdictKind::kAmbiguous) out.effects.clear();
    return out;
}

}  // namespace fusee::subsystem
