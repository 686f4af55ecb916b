// The figures of a diagnosis in one line, and the comparison of two files of such lines.
//   diagnosis_digest print NAME DIAGNOSIS.json     -> {"case": NAME, "diagnosis": {...}}
//   diagnosis_digest compare WANTED.jsonl FOUND.jsonl: each line of FOUND against the line of the same case in WANTED; 1 if one differs
// The last digits of a number depend on the processor, since the C library has variants of exp and log with and without fused
// multiply-add: the same program on the same case then differs by up to 1.1e-8. So numbers may differ by kRelative; texts, keys and the
// order of lists may not differ.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"

namespace {

using Json = nlohmann::ordered_json;

constexpr double kRelative = 1e-5;  // a thousand times the difference between processors
constexpr double kNearZero = 1e-9;  // of numbers that are zero up to rounding: residual means, differences

// Version, machine and what follows from the case alone; maps, traces and words are long and follow from the rest.
const std::vector<std::string> kLeftOut{"fusee",  "build",    "case_sha256", "renamed_fields", "isolability", "map",
                                        "traces", "sentence", "meanings",    "term_units",     "absorption"};

// Of every experiment and of all: rows that the refits of the folds have not seen. They follow from the fits too.
const std::vector<std::string> kHeldOut{"heldout_after", "heldout_after_95", "forecast", "held_out", "in_unit"};

double rounded(double number) { return std::strtod(fmt::format("{:.8g}", number).c_str(), nullptr); }

Json with_rounded_numbers(const Json& value) {
    if (value.is_number_float()) return rounded(value.get<double>());
    if (!value.is_structured()) return value;
    Json result = value;
    for (const std::string& key : kHeldOut)
        if (result.is_object()) result.erase(key);
    for (Json& item : result) item = with_rounded_numbers(item);
    return result;
}

std::string digest(const std::string& name, const std::string& file) {
    Json diagnosis = fusee::core::read_json(file);
    for (const std::string& key : kLeftOut) diagnosis.erase(key);
    return Json{{"case", name}, {"diagnosis", with_rounded_numbers(diagnosis)}}.dump();
}

bool equal_numbers(double a, double b) { return std::abs(a - b) <= kNearZero + kRelative * std::max(std::abs(a), std::abs(b)); }

std::string shortened(const Json& value) { return value.dump().substr(0, 60); }

// Appends "path: wanted, found" for every difference.
void compare(const std::string& path, const Json& wanted, const Json& found, std::vector<std::string>& differences) {
    const auto differ = [&](const std::string& was, const std::string& is) {
        differences.push_back(fmt::format("{}: wanted {}, found {}", path, was, is));
    };
    if (wanted.is_number() && found.is_number()) {
        if (!equal_numbers(wanted.get<double>(), found.get<double>())) differ(wanted.dump(), found.dump());
    } else if (wanted.is_array() && found.is_array()) {
        if (wanted.size() != found.size()) return differ(fmt::format("{} items", wanted.size()), fmt::format("{} items", found.size()));
        for (std::size_t i = 0; i < wanted.size(); ++i) compare(fmt::format("{}[{}]", path, i), wanted[i], found[i], differences);
    } else if (wanted.is_object() && found.is_object()) {
        for (const auto& [key, value] : wanted.items()) {
            if (found.contains(key))
                compare(path + '.' + key, value, found[key], differences);
            else
                differences.push_back(fmt::format("{}.{} is missing", path, key));
        }
        for (const auto& [key, value] : found.items())
            if (!wanted.contains(key)) differences.push_back(fmt::format("{}.{} is new", path, key));
    } else if (wanted != found) {
        differ(shortened(wanted), shortened(found));
    }
}

std::map<std::string, Json> read_lines(const std::string& file) {
    std::map<std::string, Json> cases;
    std::istringstream lines(fusee::core::read_file(file));
    for (std::string line; std::getline(lines, line);) {
        const Json read = fusee::core::parse_json(line, file);
        cases[read.at("case").get<std::string>()] = read.at("diagnosis");
    }
    return cases;
}

int compare_files(const std::string& wanted_file, const std::string& found_file) {
    const std::map<std::string, Json> wanted = read_lines(wanted_file);
    const std::map<std::string, Json> found = read_lines(found_file);
    int changed = 0;
    for (const auto& [name, diagnosis] : found) {
        std::vector<std::string> differences;
        if (wanted.contains(name))
            compare(name, wanted.at(name), diagnosis, differences);
        else
            differences.push_back(name + " is not in " + wanted_file);
        for (std::size_t i = 0; i < std::min<std::size_t>(differences.size(), 10); ++i) std::cerr << differences[i] << '\n';
        if (differences.size() > 10) std::cerr << name << ": " << differences.size() - 10 << " more differences\n";
        if (!differences.empty()) ++changed;
    }
    if (changed == 0) std::cout << found.size() << " diagnoses as before\n";
    return changed == 0 && !found.empty() ? 0 : 1;
}

}  // namespace

int main(int count, char** words) try {
    const std::vector<std::string> arguments(words + 1, words + count);
    if (arguments.size() != 3 || (arguments[0] != "print" && arguments[0] != "compare")) {
        std::cerr << "diagnosis_digest print NAME FILE | compare WANTED FOUND\n";
        return 2;
    }
    if (arguments[0] == "compare") return compare_files(arguments[1], arguments[2]);
    std::cout << digest(arguments[1], arguments[2]) << '\n';
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
