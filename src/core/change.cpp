#include "fusee/core/change.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace fusee::core {

std::string number(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }
std::string quoted(const std::string& text) { return '"' + text + '"'; }

namespace {

/// No key takes a value that a rule could not compute.
bool is_possible(const Change& change) {
    const bool is_text = change.value.starts_with('"');
    return is_text || (change.value.find("nan") == std::string::npos && change.value.find("inf") == std::string::npos);
}

}  // namespace

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

std::string Suggestion::text() const {
    std::string text;
    for (const Alternative& alternative : alternatives_) text += (text.empty() ? "" : ", or ") + alternative.text();
    return text;
}

Suggestion change(std::string key, std::string value) { return {std::move(key), std::move(value)}; }

}  // namespace fusee::core
