#include "fusee/diagnosis/diagnosis.h"

#include <fmt/format.h>

#include "arrays.h"
#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/report/diagnosis.h"
#include "gap_case.h"
#include "html.h"
#include "simulator.h"
#include "work.h"

namespace fs = std::filesystem;

namespace fusee::python {

namespace {

using diagnosis::Diagnosis, diagnosis::Trace;

/// A diagnosis that arrays can share.
struct Found {
    std::shared_ptr<const Diagnosis> value;  ///< never null
};

gap_case::Case case_of(const py::object& given) {
    if (py::isinstance<gap_case::Case>(given)) return given.cast<gap_case::Case>();
    return gap_case::read_case(path_of(given, "a Case"));
}

/// The same kind of thing as `given`, on which the causes are tried.
void require_alike(const py::object& given, const py::object& against) {
    if (py::isinstance<OwnModel>(given) != py::isinstance<OwnModel>(against))
        throw core::InvalidInput("against", py::repr(py::type::of(against)).cast<std::string>(), "two Models, or two cases of a joint");
    if (py::isinstance<OwnModel>(given)) simulator::require_same_model(*given.cast<OwnModel>().value, *against.cast<OwnModel>().value);
}

Found diagnose(const py::object& given, const py::object& against, unsigned jobs, const py::object& progress) {
    const bool own = py::isinstance<OwnModel>(given), carried = !against.is_none();
    if (carried) require_alike(given, against);
    const auto model_in = [own](const py::object& of) { return own && !of.is_none() ? of.cast<OwnModel>() : OwnModel{}; };
    const auto rig_in = [own](const py::object& of) { return own || of.is_none() ? gap_case::Case{} : case_of(of); };
    const OwnModel model = model_in(given), other = model_in(against);
    const gap_case::Case rig = rig_in(given), other_rig = rig_in(against);
    return run(progress, [&](Watch& watch) {
        const auto told = [&watch](std::size_t done, std::size_t total, const std::string& what) { watch.tell(done, total, what); };
        const diagnosis::DiagnoseOptions options{jobs, told};
        Diagnosis found;
        if (own) {
            const simulator::Simulated simulated(*model.value, simulate_by(model, watch));
            found = diagnosis::diagnose_model(simulated, {model.value->name, model.value->sha256}, options);
            if (carried)
                found.against = diagnosis::against(simulator::Simulated(*other.value, simulate_by(other, watch)),
                                                   {other.value->name, other.value->sha256}, found, options);
        } else {
            found = diagnosis::diagnose(rig, options);
            if (carried) found.against = diagnosis::against(other_rig, found, options);
        }
        return Found{std::make_shared<const Diagnosis>(std::move(found))};
    });
}

py::dict predict(const py::object& given, const std::optional<Found>& found, const std::optional<py::dict>& inputs) {
    const gap_case::Case rig = py::isinstance<EmptyCase>(given) ? nominal_of(given.cast<EmptyCase>()) : case_of(given);
    const Diagnosis nominal, &effects = found ? *found->value : nominal;
    const gap_case::Rows rows = inputs ? inputs_of(rig, *inputs) : rig.rows;
    diagnosis::require_possible(rig, effects, "diagnosis");
    return arrays_of(run(py::none(), [&](Watch&) { return diagnosis::predict(rig, effects, rows); }));
}

std::vector<std::pair<std::string, std::string>> causes(const std::vector<effects::Cause>& all) {
    std::vector<std::pair<std::string, std::string>> words;
    for (const effects::Cause& cause : all) words.emplace_back(cause.id, cause.side);
    return words;
}

void bind_effects(py::module_& module) {
    using diagnosis::FoundEffect, diagnosis::Alternative, diagnosis::NextExperiment;
    py::class_<FoundEffect>(
        module, "FoundEffect",
        "An effect found: behaviour of the rig that the nominal model lacks. `fusee explain ID` tells what it means and what to do.")
        .def_property_readonly(
            "id", [](const FoundEffect& e) { return e.cause.id; }, R"(Of the effect, "gear.coulomb".)")
        .def_property_readonly(
            "side", [](const FoundEffect& e) { return e.cause.side; },
            R"("agonist", "antagonist", "both"; "none" for an effect without sides.)")
        .def_readonly("probability", &FoundEffect::probability, "Of the effect, 0 to 1.")
        .def_property_readonly(
            "value", [](const FoundEffect& e) { return e.parameter.value; }, "Its size in `unit`.")
        .def_property_readonly(
            "ci95", [](const FoundEffect& e) { return std::pair(e.parameter.ci95.low, e.parameter.ci95.high); },
            "95 % interval of the size.")
        .def_property_readonly(
            "unit", [](const FoundEffect& e) { return e.parameter.unit; }, "Of value and ci95.")
        .def("__repr__", [](const FoundEffect& e) {
            return fmt::format("<{} on {}: {:.4g} {}, probability {:.3g}>", e.cause.id, e.cause.side, e.parameter.value, e.parameter.unit,
                               e.probability);
        });
    py::class_<Alternative>(module, "Alternative", "A hypothesis that remains possible.")
        .def_property_readonly(
            "effects", [](const Alternative& a) { return causes(a.effects); }, "Pairs of effect and side; empty: no effect at all.")
        .def_readonly("probability", &Alternative::probability, "Of this hypothesis, 0 to 1.");
    py::class_<NextExperiment>(module, "NextExperiment", doc("diagnosis::NextExperiment"))
        .def_readonly("text", &NextExperiment::text, doc("diagnosis::NextExperiment::text"))
        .def_readonly("information", &NextExperiment::information, doc("diagnosis::NextExperiment::information"))
        .def_readonly("cost", &NextExperiment::cost, doc("diagnosis::NextExperiment::cost"));
}

void bind_traces(py::module_& module) {
    py::class_<Trace, std::shared_ptr<Trace>> type(module, "Trace", doc("diagnosis::Trace"));
    const auto member = [&type](const char* name, std::vector<double> Trace::*values, const char* text) {
        type.def_property_readonly(
            name, [values](const std::shared_ptr<Trace>& t) { return numbers(t, (*t).*values); }, text);
    };
    type.def_readonly("experiment", &Trace::experiment, "The experiment's name.")
        .def_readonly("label", &Trace::label, R"(What over what: "q_high_rad over cocontraction_Nm".)")
        .def_readonly("x_name", &Trace::x_name, "Column of `x`.")
        .def_readonly("y_name", &Trace::y_name, "Column of the other arrays.");
    member("x", &Trace::x, "The variable.");
    member("measured", &Trace::measured, "As measured.");
    member("before", &Trace::before, "Predicted by the nominal rig.");
    member("after", &Trace::after, "Predicted by the rig with the effects found.");
    member("sigma", &Trace::sigma, "One standard deviation of a measured value.");
}

std::vector<std::shared_ptr<Trace>> traces_of(const Found& f) {
    std::vector<std::shared_ptr<Trace>> traces;
    const std::shared_ptr<Diagnosis> owner = std::const_pointer_cast<Diagnosis>(f.value);  // pybind11 knows no pointers to const
    for (Trace& trace : owner->traces) traces.emplace_back(owner, &trace);
    return traces;
}

py::object gap_of(const Found& f) {
    const diagnosis::Gap& gap = f.value->gap;
    py::dict figures;
    figures["before"] = gap.before;
    figures["after"] = gap.after;
    figures["noise_floor"] = gap.noise_floor;
    figures["heldout_before"] = gap.heldout_before;
    figures["heldout_after"] = gap.heldout_after;
    figures["heldout_after_95"] = std::pair(gap.heldout_after_95.low, gap.heldout_after_95.high);
    return dataclass_of("Gap", figures);
}

py::object absorption_of(const Found& f) {
    if (!f.value->absorption) return py::none();
    const diagnosis::Absorption& plain = *f.value->absorption;
    py::dict parameters, all;
    for (const diagnosis::Absorption::Moved& own : plain.moved) {
        py::dict moved;
        moved["value"] = own.value;
        moved["tolerances"] = own.tolerances;
        moved["with_cause"] = own.with_cause;
        moved["unit"] = own.unit;
        parameters[own.name.c_str()] = moved;
    }
    all["parameters"] = parameters;
    all["after"] = plain.after;
    all["heldout_after"] = plain.heldout_after;
    all["sentence"] = report::absorption_sentence(*f.value);
    return dataclass_of("Absorption", all);
}

py::object against_of(const Found& f) {
    if (!f.value->against) return py::none();
    const diagnosis::Against& other = *f.value->against;
    py::list carried;
    for (const diagnosis::Against::Carried& own : other.causes) {
        py::dict cause;
        cause["id"] = own.cause.id;
        cause["side"] = own.cause.side;
        cause["here"] = own.here.value;
        cause["there"] = own.there.value;
        cause["there_ci95"] = std::pair(own.there.ci95.low, own.there.ci95.high);
        cause["unit"] = own.here.unit;
        cause["survival"] = diagnosis::to_string(own.survival);
        carried.append(cause);
    }
    py::dict all;
    all["case"] = other.case_name;
    all["causes"] = carried;
    all["gap"] = py::dict(py::arg("before") = other.before, py::arg("carried") = other.carried, py::arg("refitted") = other.refitted,
                          py::arg("own") = other.own);
    all["verdict"] = diagnosis::to_string(other.verdict);
    all["effects"] = other.effects;
    return dataclass_of("Against", all);
}

/// Verdict, effects, gap and next experiment.
std::string html_of_diagnosis(const Found& f) {
    const Diagnosis& found = *f.value;
    std::vector<std::pair<std::string, std::string>> figures{{diagnosis::to_string(found.verdict), "verdict"}};
    for (const diagnosis::FoundEffect& e : found.effects)
        figures.emplace_back(
            fmt::format("{:.4g} {} ({:.4g} to {:.4g})", e.parameter.value, e.parameter.unit, e.parameter.ci95.low, e.parameter.ci95.high),
            fmt::format("{} on {}, probability {:.3g}: {}", e.cause.id, e.cause.side, e.probability, report::meaning(e.cause.id)));
    figures.emplace_back(fmt::format("{:.3g} to {:.3g} sigma", found.gap.before, found.gap.after),
                         fmt::format("gap before and after, noise floor {:.3g}", found.gap.noise_floor));
    if (!found.next_experiment.empty()) figures.emplace_back("next", found.next_experiment);
    return html_of(found.case_name, figures, {});
}

void bind_found(py::module_& module) {
    py::class_<Found>(module, "Diagnosis", "What a diagnosis found: verdict, effects, gap, next measurement.")
        .def_property_readonly(
            "verdict", [](const Found& f) { return diagnosis::to_string(f.value->verdict); },
            R"("identified", "none", "ambiguous", "unknown", "inconclusive" or "partly_explained")")
        .def_property_readonly(
            "effects", [](const Found& f) { return f.value->effects; }, "The effects found, with their sizes.")
        .def_property_readonly(
            "alternatives", [](const Found& f) { return f.value->alternatives; },
            "Hypotheses that remain possible, with their probability.")
        .def_property_readonly("gap", &gap_of, "Root mean square of (measured - predicted)/sigma, before and after.")
        .def_property_readonly(
            "next_experiment", [](const Found& f) { return f.value->next_experiment; },
            "The best one of `next` in a sentence; empty: none.")
        .def_property_readonly(
            "next", [](const Found& f) { return f.value->next; }, "Further measurements that distinguish the alternatives, the best first.")
        .def_property_readonly("traces", &traces_of, "Measured and predicted curves, for a plot.")
        .def_property_readonly("absorption", &absorption_of,
                               "What a fit of all parameters would have claimed, without any effect; None without a cause.")
        .def_property_readonly("against", &against_of, "The causes on the other case, where one was given; else None.")
        .def_property_readonly(
            "remarks", [](const Found& f) { return f.value->remarks; }, doc("diagnosis::Diagnosis::remarks"))
        .def(
            "json", [](const Found& f) { return diagnosis::diagnosis_json(*f.value); },
            "The text of diagnosis.json (docs/gap.md lists its keys); NaN is null.")
        .def_static(
            "parse",
            [](const std::string& json, const std::string& file) {
                return Found{std::make_shared<const Diagnosis>(diagnosis::parse_diagnosis(json, file))};
            },
            py::arg("json"), py::arg("file") = "diagnosis.json",
            "Reads the text of a diagnosis.json, of fusee or of another program, for `predict`: verdict, effects, build parameters, next "
            "measurements. `file` is its name in messages. Raises InvalidInput naming the key.")
        .def("_repr_html_", &html_of_diagnosis)
        .def("__repr__", [](const Found& f) {
            return fmt::format("<Diagnosis of {}: {}, {} effects>", f.value->case_name, diagnosis::to_string(f.value->verdict),
                               f.value->effects.size());
        });
}

}  // namespace

void bind_diagnosis(py::module_& module) {
    bind_effects(module);
    bind_traces(module);
    bind_found(module);
    module.def("diagnose", &diagnose, py::arg("case"), py::kw_only(), py::arg("against") = py::none(), py::arg("jobs") = 0,
               py::arg("progress") = py::none(),
               "Finds where model and rig differ, which effect that the model lacks causes it, and how far the gap shrinks with that "
               "effect in the model (docs/gap.md). `case` is a Case or the folder of one; `jobs` threads, 0: one for each processor; the "
               "result does not depend on it. `progress` is called with the number of finished steps, that of all, and a text. Raises "
               "InvalidInput if the case has too few rows. `against`: another case of the same kind and model (another unit, gain, load or "
               "day), on which the causes are tried: `Diagnosis.against`.");
    module.def("predict", &predict, py::arg("case"), py::arg("diagnosis") = py::none(), py::arg("inputs") = py::none(),
               "Predicts the measured columns of each experiment of a case, a folder or a template, at the inputs of the case or at "
               "`inputs`, columns by experiment and name as "
               "in Case.from_arrays, with the effects of a diagnosis or of the nominal rig. Raises InvalidInput.");
}

}  // namespace fusee::python
