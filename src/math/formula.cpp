#include <fmt/format.h>
#include <muParser.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/math/chebyshev.h"
#include "fusee/math/curve.h"

namespace fusee::math {

namespace {

/// 'Unexpected token "y"': the place is told beside it.
std::string without_place(const std::string& message) { return message.substr(0, message.find(" found at position")); }

/// muParser with one variable. Evaluation writes into it, so it stays in the thread that parses.
class Formula {
public:
    Formula(const std::string& field, const std::string& formula, const std::string& variable)
        : field_(field), formula_(formula), variable_(variable) {
        guarded([&] {
            parser_.DefineVar(variable, &x_);
            parser_.SetExpr(formula);
        });
    }

    [[nodiscard]] double operator()(double x) {
        x_ = x;
        int results = 0;
        double value = 0.0;
        guarded([&] { value = parser_.Eval(results)[0]; });
        if (results != 1) throw core::InvalidInput(field_, quoted(), fmt::format("one formula in {}, not {}", variable_, results));
        if (!std::isfinite(value))
            throw core::InvalidInput(field_, fmt::format("{} is {:g} at {} = {:g}", quoted(), value, variable_, x), "finite there");
        return value;
    }
    [[nodiscard]] std::string quoted() const { return fmt::format("\"{}\"", formula_); }

private:
    template <class Action>
    void guarded(Action action) const {
        try {
            action();
        } catch (const mu::Parser::exception_type& error) {
            const auto at = static_cast<std::size_t>(error.GetPos());
            const std::string place = at < formula_.size() ? fmt::format(", at character {}", at + 1) : "";
            throw core::InvalidInput(field_, fmt::format("{}{}: {}", quoted(), place, without_place(error.GetMsg())),
                                     fmt::format("a formula in {} such as 0.9*exp(-{})", variable_, variable_));
        }
    }

    std::string field_, formula_, variable_;
    double x_ = 0.0;
    mu::Parser parser_;
};

class Resolved final : public Curve, public EnclosedCurve {
public:
    explicit Resolved(PiecewiseChebyshev series) : series_(std::move(series)) {}

    [[nodiscard]] core::Range domain() const override { return series_.domain(); }
    [[nodiscard]] double value(double x) const override { return series_.value(x); }
    [[nodiscard]] double derivative(double x, int order) const override { return series_.derivative(x, order); }
    [[nodiscard]] std::vector<double> breaks() const override { return series_.breaks(); }
    [[nodiscard]] Jet over(const Interval& x, int order) const override { return series_.over(x, order); }

private:
    PiecewiseChebyshev series_;
};

}  // namespace

CurvePtr make_formula(const std::string& field, const std::string& formula, const std::string& variable, core::Range domain) {
    if (!std::isfinite(domain.low) || !std::isfinite(domain.high) || !(domain.low < domain.high))
        throw core::InvalidInput(field, fmt::format("over {:g} .. {:g}", domain.low, domain.high), "a range that ends above its start");
    Formula parsed(field, formula, variable);
    PiecewiseChebyshev series([&](double x) { return parsed(x); }, domain);
    if (series.rough())
        throw core::InvalidInput(field, fmt::format("{} has a step or kink at {} = {:.4g}", parsed.quoted(), variable, *series.rough()),
                                 "a formula whose first two derivatives are continuous");
    return std::make_shared<Resolved>(std::move(series));
}

}  // namespace fusee::math
