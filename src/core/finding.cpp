#include "fusee/core/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "fusee/core/lists.h"

namespace fusee::core {

namespace {

/// Both numbers with four digits, or with as many more as make them differ.
std::pair<std::string, std::string> distinct_texts(double measured, double allowed) {
    for (int digits = 4; digits < std::numeric_limits<double>::max_digits10; ++digits) {
        std::string left = fmt::format("{:.{}g}", measured, digits), right = fmt::format("{:.{}g}", allowed, digits);
        if (left != right || measured == allowed) return {std::move(left), std::move(right)};
    }
    return {fmt::format("{}", measured), fmt::format("{}", allowed)};
}

std::string unjudged_line(const Finding& f) {
    return fmt::format("{}: {}: {}{}; missing: {}", to_string(f.severity), f.rule, f.what,
                       f.where.empty() ? "" : fmt::format(" ({})", f.where), f.suggestion.text());
}

/// No key takes a value that a rule could not compute.
bool is_possible(const Change& change) {
    const bool is_text = change.value.starts_with('"');
    return is_text || (change.value.find("nan") == std::string::npos && change.value.find("inf") == std::string::npos);
}

}  // namespace

Finding error_finding(std::string rule, std::string what, double measured, Bound bound, double allowed, std::string unit) {
    Finding f;
    f.rule = std::move(rule);
    f.severity = Severity::kError;
    f.what = std::move(what);
    f.measured = measured;
    f.bound = bound;
    f.allowed = allowed;
    f.unit = std::move(unit);
    return f;
}

Finding not_judged(std::string rule, std::string what, std::string missing) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    Finding f;
    f.rule = std::move(rule);
    f.severity = Severity::kNotJudged;
    f.what = std::move(what);
    f.measured = f.allowed = kUnknown;
    f.suggestion = std::move(missing);
    return f;
}

Finding judged(Finding finding, Severity when_broken) {
    const bool holds = finding.bound == Bound::kAtMost ? finding.measured <= finding.allowed : finding.measured >= finding.allowed;
    finding.severity = holds && !std::isnan(finding.measured) ? Severity::kPass : when_broken;
    if (finding.severity == Severity::kPass) finding.suggestion.clear();
    return finding;
}

bool any_error(const Findings& findings) {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == Severity::kError; });
}

std::size_t count(const Findings& findings, Severity severity) {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(), [severity](const Finding& f) { return f.severity == severity; }));
}

bool is_broken(const Finding& finding) { return finding.severity == Severity::kWarning || finding.severity == Severity::kError; }

const char* to_string(Severity severity) {
    switch (severity) {
        case Severity::kPass:
            return "pass";
        case Severity::kNotJudged:
            return "not judged";
        case Severity::kWarning:
            return "warning";
        case Severity::kError:
            return "error";
    }
    return "";
}

std::string to_line(const Finding& f) {
    if (f.severity == Severity::kNotJudged) return unjudged_line(f);
    const auto [measured, allowed] = distinct_texts(f.measured, f.allowed);
    const std::string unit = f.unit.empty() ? "" : " " + f.unit;
    return fmt::format("{}: {}: {}: measured {}{}, allowed {} {}{}{}{}", to_string(f.severity), f.rule, f.what, measured, unit,
                       f.bound == Bound::kAtMost ? "at most" : "at least", allowed, unit,
                       f.where.empty() ? "" : fmt::format(" ({})", f.where),
                       f.suggestion.empty() ? "" : fmt::format("; nearest feasible: {}", f.suggestion.text()));
}

void append(Findings& to, const Findings& more) { to.insert(to.end(), more.begin(), more.end()); }

std::string number(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + '"';
}

std::string Alternative::text() const {
    std::string text = before;
    for (std::size_t i = 0; i < changes.size(); ++i) text += fmt::format("{}{} = {}", i ? " with " : "", changes[i].key, changes[i].value);
    return text + after;
}

Suggestion::Suggestion(std::string words) {
    if (!words.empty()) alternatives_.push_back({std::move(words), {}, {}});
}

Suggestion& Suggestion::with(std::string key, std::string value) {
    assert(!empty() && "a change goes with another one");
    alternatives_.back().changes.push_back({std::move(key), std::move(value)});
    return *this;
}

Suggestion& Suggestion::begun(std::string words) {
    assert(!empty() && "words stand beside a change");
    alternatives_.back().before = std::move(words);
    return *this;
}

Suggestion& Suggestion::noted(std::string words) {
    assert(!empty() && "words stand beside a change");
    alternatives_.back().after = std::move(words);
    return *this;
}

Suggestion& Suggestion::or_else(const Suggestion& other) {
    const std::vector<Alternative> more = other.alternatives_;  // the other may be this one
    alternatives_.insert(alternatives_.end(), more.begin(), more.end());
    return *this;
}

Suggestion Suggestion::of_table(const std::string& table) const {
    Suggestion named = *this;
    for (Alternative& alternative : named.alternatives_)
        for (Change& change : alternative.changes) change.key = table + "." + change.key;
    return named;
}

std::vector<Changes> Suggestion::changes() const {
    std::vector<Changes> all;
    for (const Alternative& alternative : alternatives_)
        if (!alternative.changes.empty() && std::all_of(alternative.changes.begin(), alternative.changes.end(), is_possible))
            all.push_back(alternative.changes);
    return all;
}

std::string Suggestion::text() const { return listed(alternatives_, &Alternative::text, ", or "); }

Suggestion change(std::string key, std::string value) { return {std::move(key), std::move(value)}; }

}  // namespace fusee::core
