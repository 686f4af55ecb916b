#include "fusee/core/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fusee::core {

Finding required_change(std::string rule, std::string what, double measured, Bound bound, double allowed, std::string unit) {
    Finding f;
    f.rule = std::move(rule);
    f.severity = Severity::kRequired;
    f.what = std::move(what);
    f.measured = measured;
    f.bound = bound;
    f.allowed = allowed;
    f.unit = std::move(unit);
    return f;
}

Finding judged(Finding finding, Severity when_broken) {
    const bool holds = finding.bound == Bound::kAtMost ? finding.measured <= finding.allowed : finding.measured >= finding.allowed;
    finding.severity = holds && !std::isnan(finding.measured) ? Severity::kPass : when_broken;
    if (finding.severity == Severity::kPass) finding.suggestion.clear();
    return finding;
}

bool any_required(const Findings& findings) {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == Severity::kRequired; });
}

const char* to_string(Severity severity) {
    switch (severity) {
        case Severity::kPass:
            return "pass";
        case Severity::kReview:
            return "review and accept";
        case Severity::kRequired:
            return "required change";
    }
    return "";
}

std::string to_line(const Finding& f) {
    const std::string unit = f.unit.empty() ? "" : " " + f.unit;
    return fmt::format("{}: {}: {}: measured {:.4g}{}, allowed {} {:.4g}{}{}{}", to_string(f.severity), f.rule, f.what, f.measured, unit,
                       f.bound == Bound::kAtMost ? "at most" : "at least", f.allowed, unit,
                       f.where.empty() ? "" : fmt::format(" ({})", f.where),
                       f.suggestion.empty() ? "" : fmt::format("; nearest feasible: {}", f.suggestion));
}

void append(Findings& to, const Findings& more) { to.insert(to.end(), more.begin(), more.end()); }

}  // namespace fusee::core
