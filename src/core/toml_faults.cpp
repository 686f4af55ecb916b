#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fusee/core/text.h"
#include "fusee/core/toml.h"

namespace fusee::core {

namespace {
constexpr std::size_t kMostKept = 100;
constexpr std::size_t kLongestPath = 200;  // characters of a key that a message repeats
}  // namespace

std::string toml_place(const std::string& file, const toml::source_region& at, std::string_view path) {
    return fmt::format("{}:{}:{}: {}", file, at.begin.line, at.begin.column, printable(path, kLongestPath));
}

void TomlFaults::add(const toml::source_region& at, std::string_view path, std::string value, std::string allowed) {
    ++count_;
    if (full())
        ++left_out_;
    else
        here_.push_back({at.begin, InvalidInput(toml_place(file_, at, path), std::move(value), std::move(allowed))});
}

bool TomlFaults::full() const { return here_.size() >= kMostKept; }

void TomlFaults::throw_if_any() {
    const auto position = [](const Fault& fault) { return std::pair(fault.at.line, fault.at.column); };
    std::stable_sort(here_.begin(), here_.end(), [&](const Fault& a, const Fault& b) { return position(a) < position(b); });
    Mistakes all;
    for (Fault& fault : here_) all.add(std::move(fault.mistake));
    if (left_out_ > 0) all.add(InvalidInput(file_, fmt::format("{} more mistakes", left_out_), "none"));
    all.collect([this] { elsewhere_.throw_if_any(); });
    all.throw_if_any();
}

}  // namespace fusee::core
