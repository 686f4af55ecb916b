#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "equals.h"
#include "fusee/core/error.h"
#include "fusee/math/statistics.h"
#include "remarks.h"
#include "study.h"
#include "transfer.h"
#include "verdicts.h"

namespace fusee::subsystem {

namespace {

constexpr double kSure = 0.8;                  // probability of an identified answer
constexpr double kStable = 0.95;               // share of agreeing splits, if much of the gap remains
constexpr double kLeastAlternative = 0.01;     // less likely ones are not listed
constexpr double kStructure = 3.0;             // times the floor: a larger gap has a cause
constexpr double kIndependentStructure = 1.3;  // the same for rows whose sigma is known
constexpr double kRefusedShare = 0.25;         // probability given to such a set
constexpr double kOtherSigma = 1.5;            // times a default of sigma: the rows have another one
constexpr std::size_t kBins = 8;
constexpr std::size_t kTraceRows = 400;

double sum_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum;
}

/// 95 % interval of a parameter: the wider of the fit's covariance, for rows that depend on each other, and the jackknife over what is held
/// out one by one (J. W. Tukey, Ann. Math. Statist. 29, 1958).
diagnosis::Parameter parameter_of(const Law& law, const Study& study, const Candidate& candidate, std::size_t parameter) {
    const auto& free = candidate.fit.free;
    const auto j = static_cast<std::size_t>(std::find(free.begin(), free.end(), parameter) - free.begin());
    const double rows = sum_of(study.effective_rows), square = law.rows_independent ? 1.0 : std::pow(candidate.seen_gap(), 2);
    double variance = candidate.fit.covariance[j][j] * square * candidate.fit.rows / rows;
    double freedom = std::max(1.0, rows - static_cast<double>(free.size()));
    if (!candidate.refits.empty() && candidate.refits[0].size() > 2) {
        const auto& refits = candidate.refits[0];
        const auto n = static_cast<double>(refits.size());
        double mean = 0.0, spread = 0.0;
        for (const Values& v : refits) mean += v[parameter] / n;
        for (const Values& v : refits) spread += std::pow(v[parameter] - mean, 2);
        const double jackknife = spread * (n - 1.0) / n;
        if (!law.rows_independent && jackknife > variance) variance = jackknife, freedom = n - 1.0;
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
    if (law.rows_independent || best.seen_gap() <= kStructure * law.setup_floor) return nullptr;
    const Candidate* most = &best;
    for (const Candidate& t : study.candidates)
        if (t.effects.size() <= law.most_effects && !t.refused.empty() && !t.unlikely && !t.stopped && t.log_evidence > most->log_evidence)
            most = &t;
    return most->log_evidence > best.log_evidence + kDisagreement ? most : nullptr;
}

void share_with_refused(const Law& law, Study& study, diagnosis::Diagnosis& out) {
    const Candidate* other = study.equals.empty() ? preferred_by_evidence(law, study) : nullptr;
    if (other == nullptr) return;
    const auto place = static_cast<std::size_t>(other - study.candidates.data());
    for (Candidate& t : study.candidates) t.probability *= 1.0 - kRefusedShare;
    study.candidates[place].probability += kRefusedShare;
    out.remarks.push_back(fmt::format("evidence and splits disagree: the evidence prefers {} by {:.0f} nats, which the splits refuse ({})",
                                      name_of(law, other->effects), other->log_evidence - study.candidates[study.best].log_evidence,
                                      other->refused));
}

/// The set that the evidence prefers although the search for one of its effects stopped at an end, if a gap remains.
const Candidate* beyond_range(const Law& law, const Study& study) {
    const Candidate& best = study.candidates[study.best];
    if (!law.rows_independent && best.seen_gap() <= law.setup_floor) return nullptr;
    const Candidate* most = nullptr;
    for (const Candidate& t : study.candidates)
        if (t.stopped && t.log_evidence > (most != nullptr ? most->log_evidence : best.log_evidence + kDisagreement)) most = &t;
    return most;
}

/// What forbids a certain answer.
std::vector<std::string> doubts_of(const Law& law, const Study& study) {
    const Candidate& best = study.candidates[study.best];
    std::vector<std::string> doubts = law.defaults;
    if (!law.default_sigma.empty() && (best.seen_gap() < 1.0 / kOtherSigma || best.seen_gap() > kOtherSigma))
        doubts.push_back(fmt::format("{}, but the fit leaves {:.2g} of it", law.default_sigma, best.seen_gap()));
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

diagnosis::VerdictKind likely_verdict(const Law& law, const Study& study) {
    const Candidate& best = study.candidates[study.best];
    const double limit = law.rows_independent ? kIndependentStructure : kStructure * law.setup_floor;
    if (best.probability < kSure) return diagnosis::VerdictKind::kAmbiguous;
    if (!best.effects.empty() && best.unseen_gap(0) > limit && study.stability < kStable) return diagnosis::VerdictKind::kAmbiguous;
    if (!best.effects.empty()) return diagnosis::VerdictKind::kIdentified;
    return best.unseen_gap(0) > limit ? diagnosis::VerdictKind::kUnknown : diagnosis::VerdictKind::kNone;
}

/// With a doubt there is no certain answer: `identified` becomes `ambiguous`, and `none` `inconclusive`.
diagnosis::VerdictKind verdict_of(const Law& law, const Study& study, const std::vector<std::string>& doubts) {
    const diagnosis::VerdictKind likely = likely_verdict(law, study);
    if (doubts.empty()) return likely;
    if (likely == diagnosis::VerdictKind::kIdentified) return diagnosis::VerdictKind::kAmbiguous;
    return likely == diagnosis::VerdictKind::kNone ? diagnosis::VerdictKind::kInconclusive : likely;
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
        if (&t != &best && t.probability >= kLeastAlternative) out.alternatives.push_back({causes_of(law, t), t.probability});
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

struct Residuals {
    std::vector<std::vector<double>> before, after;  // [record][row], sigma
};

/// Squared residuals in the bins of one group of files.
struct GroupMap {
    double low = 0.0, high = 0.0;
    std::array<double, kBins> before{}, after{}, rows{};
    std::size_t count = 0;
};

std::map<std::string, GroupMap> maps_of(const Law& law, const Residuals& residuals) {
    std::map<std::string, GroupMap> maps;
    const auto each_row = [&](const auto& visit) {
        for (const Block& block : law.blocks)
            for (const std::size_t i : block.rows) visit(maps[law.targets[block.record].group], block.record, i);
    };
    each_row([&](GroupMap& map, std::size_t r, std::size_t i) {
        const double at = law.targets[r].region[i];
        map.low = map.count == 0 ? at : std::min(map.low, at);
        map.high = map.count == 0 ? at : std::max(map.high, at);
        ++map.count;
    });
    each_row([&](GroupMap& map, std::size_t r, std::size_t i) {
        const double share = map.high > map.low ? (law.targets[r].region[i] - map.low) / (map.high - map.low) : 0.0;
        const std::size_t bin = std::min(kBins - 1, static_cast<std::size_t>(share * kBins));
        map.before[bin] += residuals.before[r][i] * residuals.before[r][i];
        map.after[bin] += residuals.after[r][i] * residuals.after[r][i];
        map.rows[bin] += 1.0;
    });
    return maps;
}

/// The shortest run of bins with at least 60 % of the group's gap.
std::pair<std::size_t, std::size_t> region_of(const GroupMap& map) {
    double all = 0.0;
    for (const double b : map.before) all += b;
    for (std::size_t length = 1; length <= kBins; ++length)
        for (std::size_t first = 0; first + length <= kBins; ++first) {
            double part = 0.0;
            for (std::size_t b = first; b < first + length; ++b) part += map.before[b];
            if (part >= 0.6 * all) return {first, first + length};
        }
    return {0, kBins};
}

void put_map(const Law& law, const Residuals& residuals, diagnosis::Diagnosis& out) {
    const auto maps = maps_of(law, residuals);
    double all = 0.0;
    for (const auto& [group, map] : maps)
        for (const double b : map.before) all += b;
    for (const auto& [group, map] : maps) {
        const auto edge = [&map = map](std::size_t bin) {
            return map.low + (map.high - map.low) * static_cast<double>(bin) / static_cast<double>(kBins);
        };
        double part = 0.0;
        for (std::size_t b = 0; b < kBins; ++b) {
            part += map.before[b];
            if (map.rows[b] > 0.0)
                out.map.push_back({group,
                                   law.region_name,
                                   {edge(b), edge(b + 1)},
                                   std::sqrt(map.before[b] / map.rows[b]),
                                   std::sqrt(map.after[b] / map.rows[b]),
                                   static_cast<std::size_t>(map.rows[b])});
        }
        const auto [first, last] = region_of(map);
        out.where.push_back({group, part / std::max(all, 1e-300), law.region_name, {edge(first), edge(last)}, ""});
    }
    std::stable_sort(out.where.begin(), out.where.end(),
                     [](const diagnosis::GapContribution& a, const diagnosis::GapContribution& b) { return a.share > b.share; });
}

diagnosis::Gap gap_over(const Candidate& nominal, const Candidate& best, const std::vector<std::size_t>& blocks, double floor) {
    const auto over = [&](const Misfit& m) {
        double squares = 0.0, rows = 0.0;
        for (const std::size_t b : blocks) squares += m.squares[b], rows += m.rows[b];
        return std::sqrt(squares / rows);
    };
    return {over(nominal.seen),      over(best.seen),      floor,
            over(nominal.unseen[0]), over(best.unseen[0]), {diagnosis::kNoFigure, diagnosis::kNoFigure}};
}

void put_gaps(const Law& law, const Study& study, diagnosis::Diagnosis& out) {
    const Candidate &nominal = study.candidates.front(), &best = study.candidates[study.best];
    std::vector<std::size_t> all;
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t b = 0; b < law.blocks.size(); ++b) {
        all.push_back(b);
        groups[law.targets[law.blocks[b].record].group].push_back(b);
    }
    out.gap = gap_over(nominal, best, all, law.cycle_floor);
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
        for (std::size_t i = 0; i < rows; i += (rows + kTraceRows - 1) / kTraceRows) {
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

}  // namespace

diagnosis::Diagnosis diagnose(const Case& subsystem_case, const diagnosis::DiagnoseOptions& options) {
    if (subsystem_case.records.empty()) throw core::InvalidInput("experiments", "no file", "at least one");
    const auto law = law_of(subsystem_case);
    Study study = subsystem::study(*law, options);
    diagnosis::Diagnosis out;
    out.case_name = subsystem_case.name;
    out.case_sha256 = subsystem_case.sha256;
    out.remarks = subsystem_case.remarks;
    share_with_refused(*law, study, out);
    out.doubts = doubts_of(*law, study);
    out.verdict = verdict_of(*law, study, out.doubts);
    put_effects(*law, study, out);
    put_ranking(*law, study, out);
    put_gaps(*law, study, out);
    const Values &before = study.candidates.front().fit.values, &after = study.candidates[study.best].fit.values;
    Residuals residuals;
    for (std::size_t r = 0; r < law->targets.size(); ++r) {
        residuals.before.push_back(residuals_of(*law, r, before));
        residuals.after.push_back(residuals_of(*law, r, after));
    }
    put_map(*law, residuals, out);
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
