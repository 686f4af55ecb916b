#pragma once

#include <cmath>
#include <string>

#include "fusee/simulator/case.h"

namespace fusee::fixtures {

/// A spring that is pulled: F = k x, with friction over the direction; three runs of 24 rows.
inline gap_case::CaseTexts pulled_spring() {
    gap_case::CaseTexts texts;
    texts["case.toml"] = R"([model]
command = ["python3", "spring.py"]

[experiments.pull]
files = ["a.csv", "b.csv", "c.csv"]
inputs = ["t_s", "x_m"]
outputs = {force_N = 0.1}

[parameters]
rate_N_per_m = {nominal = 1000.0, tolerance = 0.02}
friction_N = {nominal = 0.0}

[effects.friction]
frees = ["friction_N"]
usual = 1.0
range = [0.0, 10.0]
meaning = "The slide rubs."
remedy = "Oil it."
)";
    for (const char* file : {"a.csv", "b.csv", "c.csv"}) {
        std::string csv = "t_s,x_m,force_N\n";
        for (int i = 0; i < 24; ++i) {
            const double x = 0.02 * std::sin(0.4 * i + file[0]);
            csv += std::to_string(0.1 * i) + "," + std::to_string(x) + "," + std::to_string(1000.0 * x + 0.1 * ((i * 7) % 5 - 2)) + "\n";
        }
        texts[file] = csv;
    }
    return texts;
}

inline simulator::Case read_case(const gap_case::CaseTexts& texts) {
    return simulator::read_case(gap_case::CaseFiles("spring", texts), false);
}

}  // namespace fusee::fixtures
