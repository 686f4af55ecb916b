#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/toml.h"
#include "fusee/profile/follow.h"
#include "fusee/study/study.h"
#include "sample.h"

namespace fusee::study {

namespace {

constexpr const char* kNameCharacters = "0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.";

template <class Action>
auto guarded(const std::string& field, const std::string& formula, const Action& action) {
    try {
        return action();
    } catch (const mu::Parser::exception_type& error) {
        throw core::InvalidInput(field, fmt::format("\"{}\": {}", formula, error.GetMsg()),
                                 "a formula between keys such as k_se.hub.bore_mm + 2*cable.diameter_mm < 20");
    }
}

mu::Parser parser_of(const std::string& formula) {
    mu::Parser parser;
    parser.DefineNameChars(kNameCharacters);  // the keys hold dots
    parser.SetExpr(formula);
    return parser;
}

/// The names of keys in a formula. @throws core::InvalidInput naming `field` if it is no formula
std::vector<std::string> keys_in(const std::string& field, const std::string& formula) {
    return guarded(field, formula, [&] {
        std::vector<std::string> keys;
        mu::Parser parser = parser_of(formula);
        for (const auto& [key, unused] : parser.GetUsedVar()) keys.push_back(key);
        return keys;
    });
}

/// The formula's value. @param number the value of a key that it names
/// @throws core::InvalidInput naming `field` if it cannot be evaluated or is not finite
double evaluate(const std::string& field, const std::string& formula, const std::function<double(const std::string&)>& number) {
    struct Variables {
        const std::function<double(const std::string&)>& number;
        std::map<std::string, double> values;
        static double* make(const char* key, void* self) {
            auto& all = *static_cast<Variables*>(self);
            return &all.values.emplace(key, all.number(key)).first->second;
        }
    };
    return guarded(field, formula, [&] {
        Variables variables{number, {}};
        mu::Parser parser = parser_of(formula);
        parser.SetVarFactory(&Variables::make, &variables);
        int results = 0;
        const double value = parser.Eval(results)[0];
        if (results != 1 || !std::isfinite(value))
            throw core::InvalidInput(field, fmt::format("\"{}\" has {}", formula, results != 1 ? "several values" : "no finite value"),
                                     "one finite number for every design; 0 leaves the design out");
        return value;
    });
}

constexpr std::size_t kMostKeysInName = 3;

/// The fields of a study's messages.
std::string field_of(const Study& study, const std::string& key) { return study.file.string() + ": " + key; }

/// Throws the caught mistake again, of a key that varies as a mistake of the study: its line in the base profile is not that value's.
[[noreturn]] void rethrow_in_study(const Study& study) {
    core::Mistakes moved, mistakes;
    mistakes.collect([] { throw; });
    for (const core::InvalidInput& mistake : mistakes.all()) {
        const auto is_of = [&](const Variation& v) { return mistake.field().ends_with(": " + v.key); };
        const auto found = std::find_if(study.vary.begin(), study.vary.end(), is_of);
        moved.add(found == study.vary.end()
                      ? mistake
                      : core::InvalidInput(field_of(study, "vary." + found->key), mistake.value(), mistake.allowed()));
    }
    moved.throw_if_any();
    throw;
}

std::string number_text(double value, bool whole) { return whole ? fmt::format("{:.0f}", value) : fmt::format("{:.6g}", value); }

/// @param u place in the variation, 0 to 1
std::string value_at(const Variation& v, double u) {
    if (!v.values.empty())
        return v.values[std::min(static_cast<std::size_t>(u * static_cast<double>(v.values.size())), v.values.size() - 1)];
    double share = u;
    if (v.steps == 1) share = 0.0;
    if (v.steps > 1) {
        const auto steps = static_cast<double>(v.steps);
        share = std::min(std::floor(u * steps), steps - 1.0) / (steps - 1.0);
    }
    const double value = v.logarithmic ? v.from * std::pow(v.to / v.from, share) : v.from + share * (v.to - v.from);
    return number_text(value, v.whole);
}

std::size_t levels(const Variation& v) { return v.values.empty() ? v.steps : v.values.size(); }

double number_in(const std::string& toml) {
    double value = std::nan("");
    std::from_chars(toml.data(), toml.data() + toml.size(), value);
    return value;
}

/// The value as it stands in a name: letters, digits, '.', '_' and '-'.
std::string name_part(const std::string& toml) {
    std::string part;
    for (const char c : toml)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-') part += c;
    return part;
}

/// The value of a grid's key on one of its levels.
std::string value_on(const Variation& v, std::size_t level) {
    return value_at(v, (static_cast<double>(level) + 0.5) / static_cast<double>(levels(v)));
}

/// False of formulas such as "a + b" and "a * b".
bool values_differ_in_names(const Variation& v) {
    std::set<std::string> seen;
    for (std::size_t level = 0; level < levels(v); ++level)
        if (const std::string part = name_part(value_on(v, level)); part.empty() || !seen.insert(part).second) return false;
    return true;
}

std::string leaf_of(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The last word of each key, or the whole key where two end alike.
std::vector<std::string> short_keys(const std::vector<Variation>& vary) {
    std::map<std::string, int> uses;
    for (const Variation& v : vary) ++uses[leaf_of(v.key)];
    return core::each<std::string>(vary, [&](const Variation& v) { return uses[leaf_of(v.key)] == 1 ? leaf_of(v.key) : v.key; });
}

bool states_spring(const std::filesystem::path& file) {
    try {
        const auto profile = core::parse_toml(core::read_file(file, profile::kLargestFile), file.string());
        return profile["kind"].value_or<std::string>("") == "spring";
    } catch (const core::InputError&) {  // reported with its design
        return false;
    }
}

}  // namespace

struct Plan::Parts {
    Study study;
    std::size_t size = 0;
    std::string base_text;
    std::optional<profile::Profile> base;
    std::unique_ptr<Sample> sample;
    std::vector<std::string> name_keys;          ///< of a grid whose names hold the values; else empty
    bool varies_files = false;                   ///< a key that varies names a CSV file
    std::map<std::string, double> base_numbers;  ///< of the keys that the constraints name
    std::set<std::string> following;             ///< those among them that follow from keys that vary
    int digits = 1;                              ///< of the greatest index
    bool joints = false, springs = false;        ///< kinds of its profiles

    void read_base();
    void check_constraints();
    [[nodiscard]] std::vector<std::string> values_at(std::size_t index) const;
    [[nodiscard]] std::string name_of(std::size_t index, const std::vector<std::string>& values) const;
    [[nodiscard]] std::vector<profile::Edit> edits_of(const std::vector<std::string>& values) const;
    [[nodiscard]] std::string excluded_by(const std::vector<std::string>& values, const std::function<profile::Profile()>& profile) const;
};

void Plan::Parts::read_base() {
    base_text = core::read_file(study.profiles.front(), profile::kLargestFile);
    base = profile::parse_profile(base_text, study.profiles.front());
    for (const Variation& v : study.vary) {
        profile::require_key(field_of(study, "vary"), v.key);
        if (!profile::value_text(*base, v.key)) {
            const std::string own = profile::counterpart(v.key, *base);
            throw core::InvalidInput(field_of(study, "vary." + v.key), "has no meaning in " + study.profiles.front().string(),
                                     own.empty() ? "a key of numbers or text that applies to the base profile" : own);
        }
    }
    varies_files = std::any_of(study.vary.begin(), study.vary.end(), [](const Variation& v) { return profile::names_file(v.key); });
    if (study.method == Method::kGrid && study.vary.size() <= kMostKeysInName &&
        std::all_of(study.vary.begin(), study.vary.end(), &values_differ_in_names))
        name_keys = short_keys(study.vary);
}

void Plan::Parts::check_constraints() {
    for (const Constraint& constraint : study.constraints) {
        const std::string field = field_of(study, "constraints." + constraint.name);
        for (const std::string& key : keys_in(field, constraint.formula)) {
            profile::require_key(field, key);
            const auto text = profile::value_text(*base, key);
            const double value = text ? number_in(*text) : std::nan("");
            if (std::isnan(value)) throw core::InvalidInput(field, key, "keys of numbers that apply to the base profile");
            base_numbers[key] = value;
        }
    }
    if (base_numbers.empty() || size == 0) return;
    for (const profile::Edit& edit : profile::following(*base, edits_of(values_at(0)))) following.insert(edit.key);
}

std::vector<profile::Edit> Plan::Parts::edits_of(const std::vector<std::string>& values) const {
    std::vector<profile::Edit> edits;
    for (std::size_t key = 0; key < values.size(); ++key) edits.push_back({{study.vary[key].key, values[key]}, {}});
    return edits;
}

std::vector<std::string> Plan::Parts::values_at(std::size_t index) const {
    if (study.method == Method::kCsv) return study.rows.at(index);
    std::vector<std::string> values(study.vary.size());
    if (study.method == Method::kGrid) {
        for (std::size_t key = values.size(); key-- > 0;) {
            const std::size_t count = levels(study.vary[key]);
            values[key] = value_on(study.vary[key], index % count);
            index /= count;
        }
        return values;
    }
    const std::vector<double> point = sample->point(index);
    for (std::size_t key = 0; key < values.size(); ++key) {
        const Variation& v = study.vary[key];
        values[key] = value_at(v, point[key]);
    }
    return values;
}

std::string Plan::Parts::name_of(std::size_t index, const std::vector<std::string>& values) const {
    if (!study.row_names.empty()) return study.row_names.at(index);
    std::string name = base->name;
    for (std::size_t key = 0; key < name_keys.size(); ++key) name += "-" + name_keys[key] + "-" + name_part(values[key]);
    if (!name_keys.empty() && name.size() <= profile::kLongestName) return name;
    const std::string number = fmt::format("-{:0{}}", index, digits);
    return base->name.substr(0, profile::kLongestName - number.size()) + number;
}

/// @param profile makes the design's profile, of which only keys that follow are asked
std::string Plan::Parts::excluded_by(const std::vector<std::string>& values, const std::function<profile::Profile()>& profile) const {
    std::optional<profile::Profile> made;
    const auto number = [&](const std::string& key) {
        for (std::size_t i = 0; i < values.size(); ++i)
            if (study.vary[i].key == key) return number_in(values[i]);
        if (!following.contains(key)) return base_numbers.at(key);
        if (!made) made = profile();
        return number_in(*profile::value_text(*made, key));
    };
    for (const Constraint& constraint : study.constraints)
        if (evaluate(field_of(study, "constraints." + constraint.name), constraint.formula, number) == 0.0) return constraint.name;
    return "";
}

Plan::Plan(Study study) : parts_(std::make_unique<Parts>()) {
    Parts& p = *parts_;
    p.study = std::move(study);
    const Study& s = p.study;
    if (!s.varies()) {
        p.size = s.profiles.size();
        for (const std::filesystem::path& file : s.profiles) (states_spring(file) ? p.springs : p.joints) = true;
        return;
    }
    p.read_base();
    (p.base->is_spring() ? p.springs : p.joints) = true;
    p.size = s.count;
    if (s.method == Method::kCsv) p.size = s.rows.size();
    if (s.method == Method::kGrid) {
        p.size = 1;
        for (const Variation& v : s.vary) p.size *= levels(v);
    } else if (s.method != Method::kCsv) {
        p.sample = make_sample(s.method, s.vary.size(), s.count, s.seed);
    }
    p.digits = static_cast<int>(std::to_string(p.size - 1).size());
    p.check_constraints();
}

Plan::~Plan() = default;

const Study& Plan::study() const { return parts_->study; }
std::size_t Plan::size() const { return parts_->size; }
bool Plan::has_joints() const { return parts_->joints; }
bool Plan::has_springs() const { return parts_->springs; }

std::string Plan::digest(const Planned& planned) const {
    if (!parts_->study.varies() || parts_->varies_files) return profile(planned).sha256;
    std::string all = parts_->base->sha256 + '\n';
    for (std::size_t key = 0; key < planned.values.size(); ++key)
        all += fmt::format("{} = {}\n", parts_->study.vary[key].key, planned.values[key]);
    return core::sha256_hex(all);
}

Planned Plan::at(std::size_t index) const {
    if (!parts_->study.varies()) return {index, parts_->study.row_names.at(index), {}, {}};
    Planned planned{index, {}, parts_->values_at(index), {}};
    planned.name = parts_->name_of(index, planned.values);
    planned.excluded_by = parts_->excluded_by(planned.values, [&] { return profile(planned); });
    return planned;
}

profile::Profile Plan::profile(const Planned& planned) const {
    const Parts& p = *parts_;
    if (!p.study.varies()) return profile::read_profile(p.study.profiles.at(planned.index));
    const std::vector<profile::Edit> moved = p.edits_of(planned.values), following = profile::following(*p.base, moved);
    std::vector<profile::Edit> edits = moved;
    edits.insert(edits.end(), following.begin(), following.end());
    edits.push_back({{"name", core::quoted(planned.name)}, {}});
    try {
        profile::Profile made = profile::parse_profile(profile::with_edits(p.base_text, *p.base, edits), p.study.profiles.front());
        profile::let_anchors_follow(made, moved);
        return made;
    } catch (const core::InputError&) {
        rethrow_in_study(p.study);
    }
}

}  // namespace fusee::study
