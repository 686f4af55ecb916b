#include "verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "answer.h"
#include "fusee/diagnosis/grounds.h"
#include "fusee/inference/interval.h"
#include "power.h"
#include "rivals.h"

namespace fusee::diagnosis {

namespace {

/// Share of the rows of an experiment whose prediction is ill-conditioned.
double share_of_slips(const inference::Problem& problem, const inference::Fit& fit, std::size_t experiment) {
    double slips = 0.0, rows = 0.0;
    for (int i = 0; i < fit.spread.size(); ++i)
        if (problem.experiment_of(i) == experiment) {
            slips += fit.spread[i] > inference::kSlip ? 1.0 : 0.0;
            rows += 1.0;
        }
    return rows > 0.0 ? slips / rows : 0.0;
}

void check_experiments(Scrutiny& scrutiny, const inference::Problem& problem, const inference::Fit& best) {
    const std::vector<double> left = misfits(problem, best.seen());
    for (std::size_t e = 0; e < left.size(); ++e) {
        const inference::Experiment& experiment = problem.experiments()[e];
        const double misfit = left[e], limit = experiment.unexplained;
        if (misfit <= limit) {
            scrutiny.evidence = scrutiny.evidence || experiment.rows > 0;
            continue;
        }
        if (const double share = share_of_slips(problem, best, e); share > inference::kSlips) {
            scrutiny.remarks.push_back(
                fmt::format("{}: {:.0f} % of the rows stick and slip, which cannot be predicted row by row ({:.1f} "
                            "sigma): not counted as evidence against the model",
                            experiment.name, 100.0 * share, misfit));
            continue;
        }
        scrutiny.unexplained = true;
        scrutiny.remarks.push_back(fmt::format(
            "{}: the best hypothesis leaves a gap of {:.1f} sigma; a correct model leaves at most {:.2f}", experiment.name, misfit, limit));
    }
}

void check_tolerances(Scrutiny& scrutiny, const inference::Problem& problem, const inference::Search& search) {
    const inference::WorstNuisancePull most = worst_nuisance_pull(problem, search.best());
    if (std::abs(most.sigmas) <= inference::kImpossible) return;
    scrutiny.unexplained = true;
    scrutiny.remarks.push_back(
        fmt::format("{}: the best of the {} hypotheses that were fitted needs a deviation of {:+.1f} tolerance sigmas",
                    problem.build()[most.parameter].name, search.fits.size(), most.sigmas));
}

/// A contradicted effect is refuted, also beside others: a pair that leads although the contradiction cost it its odds is better than every
/// other hypothesis that was fitted, and still no explanation.
void check_sizes(Scrutiny& scrutiny, const inference::Problem& problem, const inference::Search& search) {
    const inference::Fit& best = search.best();
    for (const inference::Cause& cause : inference::contradicted(problem, best, search.left_out.front())) {
        scrutiny.unexplained = true;
        scrutiny.remarks.push_back(fmt::format("{} ({}): refits without one experiment each disagree on its size", cause.id, cause.side));
    }
    for (const inference::Cause& cause : inference::at_bounds(problem, best)) {
        scrutiny.unexplained = true;
        scrutiny.remarks.push_back(
            fmt::format("{} ({}): its size is at a bound of its law, so the true cause is another one", cause.id, cause.side));
    }
}

std::string names_of(const inference::Causes& causes) {
    std::string names;
    for (const inference::Cause& cause : causes)
        names += (names.empty() ? "" : " with ") + cause.id + (cause.side == "none" ? "" : " (" + cause.side + ")");
    return names;
}

/// "se.rate (agonist) 0.065, se.rate (antagonist) 0.103"
std::string names_and_sizes(const inference::Problem& problem, const inference::Fit& fit) {
    const std::vector<Parameter> sizes = sizes_of(problem, fit, {});
    std::vector<std::string> all;
    for (std::size_t c = 0; c < sizes.size(); ++c)
        all.push_back(
            fmt::format("{} {:.3g}{}", names_of({fit.causes[c]}), sizes[c].value, sizes[c].unit == "1" ? "" : " " + sizes[c].unit));
    return fmt::format("{}", fmt::join(all, ", "));
}

/// Of the hypotheses at `places` that nothing distinguishes from the best, and of those that have a size for each side.
std::vector<std::string> indistinct_remarks(const inference::Problem& problem, const inference::Search& search,
                                            const std::vector<std::size_t>& places) {
    std::vector<std::string> others, remarks;
    for (const std::size_t h : places)
        if (search.fits[h].causes.size() > search.best().causes.size())
            remarks.push_back("one size for both sides is more likely, but fitted separately the sizes of the sides differ: " +
                              names_and_sizes(problem, search.fits[h]));
        else
            others.push_back(names_of(search.fits[h].causes));
    if (!others.empty())
        remarks.push_back(fmt::format("no {} distinguishes {} from: {}",
                                      problem.model().knows_usual_sizes() ? "usual measurement" : "row of these runs",
                                      names_of(search.best().causes), fmt::join(others, "; ")));
    return remarks;
}

std::string unseen_remark(const std::vector<inference::Cause>& unseen) {
    std::vector<std::string> ids;
    for (const inference::Cause& cause : unseen)
        if (ids.empty() || ids.back() != cause.id) ids.push_back(cause.id);
    return fmt::format("these rows would not show a usual size of: {}", fmt::join(ids, ", "));
}

}  // namespace

VerdictKind verdict_of(const Grounds& grounds) {
    if (!grounds.explains) return VerdictKind::kUnknown;
    if (grounds.rivalled) return VerdictKind::kAmbiguous;
    if (grounds.named) return grounds.doubted ? VerdictKind::kAmbiguous : VerdictKind::kIdentified;
    return grounds.doubted ? VerdictKind::kInconclusive : VerdictKind::kNone;
}

Scrutiny scrutinize(const inference::Problem& problem, const inference::Search& search, unsigned jobs) {
    Scrutiny scrutiny;
    check_experiments(scrutiny, problem, search.best());
    check_tolerances(scrutiny, problem, search);
    check_sizes(scrutiny, problem, search);
    scrutiny.rivalled = search.probability.size() > 1 && inference::rivalled(search.probability[0], search.probability[1]);  // they fall
    if (!scrutiny.holds() || scrutiny.rivalled) return scrutiny;
    scrutiny.indistinct = indistinct(problem, search, jobs);
    scrutiny.rivalled = !scrutiny.indistinct.empty();
    return scrutiny;
}

std::optional<inference::FoundTerms> terms_of(const inference::Problem& problem, const inference::Search& found, const Scrutiny& scrutiny,
                                              unsigned jobs) {
    const inference::Causes& best = found.best().causes;
    const bool named = scrutiny.holds() && (scrutiny.rivalled || !best.empty());
    const bool little_left = inference::evidence_left(problem, found.best().seen()) < inference::kMuchLeft;
    const std::vector<inference::Cause> terms =
        named && best.size() == 1 && little_left ? inference::terms_like(problem, best.front().id) : inference::possible_terms(problem);
    if (terms.empty() || (named && best.empty())) return std::nullopt;
    const inference::Fit& null = found.fits[found.null];
    const double to_beat = null.log_evidence - found.log_posterior[found.null];  // of the library, its odds included
    return inference::pursue_terms(problem, null, to_beat, terms, {.jobs = jobs, .progress = {}});
}

Decision decide(const inference::Problem& problem, const inference::Search& search, const Scrutiny& scrutiny,
                const std::optional<inference::FoundTerms>& terms, bool part_stands, const Isolability& isolability) {
    Grounds grounds{scrutiny.holds(), scrutiny.rivalled, !search.best().causes.empty(), false};
    Decision decision{verdict_of(grounds), Shown::kNull, scrutiny.remarks, {}, {}, {}};
    const bool named = decision.verdict == VerdictKind::kIdentified || decision.verdict == VerdictKind::kAmbiguous;
    if (terms) {
        if (named)
            decision.remarks.push_back(fmt::format("an unknown effect explains the gap better than {}", names_of(search.best().causes)));
        decision.verdict = VerdictKind::kUnknown;
        decision.shown = Shown::kTerms;
        return decision;
    }
    if (named) decision.shown = Shown::kBest;
    if (named && !scrutiny.indistinct.empty()) {
        decision.indistinct = scrutiny.indistinct;
        for (std::string& remark : indistinct_remarks(problem, search, scrutiny.indistinct)) decision.remarks.push_back(std::move(remark));
    }
    if (decision.verdict == VerdictKind::kUnknown && part_stands) {
        decision.verdict = VerdictKind::kPartlyExplained;
        decision.shown = Shown::kPart;
    }
    if (decision.verdict != VerdictKind::kNone) return decision;
    decision.power = powers_of(problem, isolability);
    decision.unseen = not_shown(decision.power);
    grounds.doubted = !decision.unseen.empty();
    decision.verdict = verdict_of(grounds);
    if (grounds.doubted) decision.remarks.push_back(unseen_remark(decision.unseen));
    return decision;
}

}  // namespace fusee::diagnosis
