#include "constraint.h"

#include <fmt/format.h>
#include <muParser.h>

#include <cmath>
#include <map>

#include "fusee/core/error.h"

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

}  // namespace

std::vector<std::string> keys_in(const std::string& field, const std::string& formula) {
    return guarded(field, formula, [&] {
        std::vector<std::string> keys;
        mu::Parser parser = parser_of(formula);
        for (const auto& [key, unused] : parser.GetUsedVar()) keys.push_back(key);
        return keys;
    });
}

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

}  // namespace fusee::study
