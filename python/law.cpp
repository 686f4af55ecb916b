#include <fmt/format.h>

#include "arrays.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/places.h"
#include "html.h"
#include "results.h"

namespace fusee::python {

namespace {

using spring::LawPoint, spring::SpringLawPtr;

LawCurve at(const Numbers& x, const SpringLawPtr& law, LawPoint (spring::SpringLaw::*point)(double) const) {
    auto rows = std::make_shared<std::vector<LawPoint>>();
    for (py::ssize_t i = 0; i < x.size(); ++i) rows->push_back((law.get()->*point)(x.data()[i]));
    return {std::move(rows)};
}

void bind_curve(py::module_& module) {
    py::class_<LawCurve> type(module, "LawCurve", doc("spring::LawPoint"));
    const auto member = [&type](const char* name, double LawPoint::*value, const char* text) {
        type.def_property_readonly(
            name,
            [value](const LawCurve& c) {
                return column(c.rows, *c.rows, [value](const LawPoint& p) -> const double& { return p.*value; });
            },
            text);
    };
    member("tau", &LawPoint::tau, doc("spring::LawPoint::tau"));
    member("theta", &LawPoint::theta, doc("spring::LawPoint::theta"));
    member("f_se", &LawPoint::f_se, doc("spring::LawPoint::f_se"));
    member("f_pe", &LawPoint::f_pe, doc("spring::LawPoint::f_pe"));
    member("s", &LawPoint::s, doc("spring::LawPoint::s"));
    member("p", &LawPoint::p, doc("spring::LawPoint::p"));
    member("s_slope", &LawPoint::s_slope, doc("spring::LawPoint::s_slope"));
    member("p_slope", &LawPoint::p_slope, doc("spring::LawPoint::p_slope"));
    member("u_se", &LawPoint::u_se, doc("spring::LawPoint::u_se"));
    member("u_pe", &LawPoint::u_pe, doc("spring::LawPoint::u_pe"));
    type.def_property_readonly(
            "transmission",
            [](const LawCurve& c) {
                py::array_t<double> shares(static_cast<py::ssize_t>(c.rows->size()));
                for (std::size_t i = 0; i < c.rows->size(); ++i) shares.mutable_data()[i] = (*c.rows)[i].transmission();
                return shares;
            },
            doc("spring::LawPoint::transmission"))
        .def("__len__", [](const LawCurve& c) { return c.rows->size(); })
        .def("__repr__", [](const LawCurve& c) { return fmt::format("<LawCurve of {} loads>", c.rows->size()); });
}

void bind_law_type(py::module_& module) {
    py::class_<spring::SpringLaw, std::shared_ptr<spring::SpringLaw>>(
        module, "Law",
        "A pair of spring laws, K_SE and K_PE at one capstan. Load [Nm] and angle [rad] name the same point: both rise together.")
        .def_property_readonly(
            "loads", [](const spring::SpringLaw& l) { return std::pair(l.loads().low, l.loads().high); }, doc("spring::SpringLaw::loads"))
        .def_property_readonly(
            "angles", [](const spring::SpringLaw& l) { return std::pair(l.angles().low, l.angles().high); },
            doc("spring::SpringLaw::angles"))
        .def(
            "at_load",
            [](const std::shared_ptr<spring::SpringLaw>& l, const Numbers& tau) { return at(tau, l, &spring::SpringLaw::at_load); },
            py::arg("tau"), "Points of the law at loads `tau` [Nm]; loads outside of `loads` become its ends.")
        .def(
            "at_angle",
            [](const std::shared_ptr<spring::SpringLaw>& l, const Numbers& theta) { return at(theta, l, &spring::SpringLaw::at_angle); },
            py::arg("theta"), "Points of the law at capstan angles `theta` [rad]; angles outside of `angles` become its ends.")
        .def(
            "sample",
            [](const spring::SpringLaw& l, std::size_t count) {
                return LawCurve{std::make_shared<std::vector<LawPoint>>(spring::sample_by_load(l, count))};
            },
            py::arg("count") = 401, doc("spring::sample_by_load"))
        .def("__repr__", [](const spring::SpringLaw& l) {
            return fmt::format("<Law {:g} to {:g} Nm, {:g} rad>", l.loads().low, l.loads().high, l.angles().high);
        });
}

void bind_potential(py::module_& module) {
    using spring::Potential;
    py::class_<Potential, std::shared_ptr<Potential>>(module, "Potential", doc("spring::Potential"))
        .def_property_readonly(
            "domain", [](const Potential& p) { return std::pair(p.domain().low, p.domain().high); }, "Least and greatest deflection [rad].")
        .def(
            "energy", [](const Potential& p, const Numbers& x) { return each(x, [&](double one) { return p.energy(one); }); }, py::arg("x"),
            doc("spring::Potential::energy"))
        .def(
            "torque", [](const Potential& p, const Numbers& x) { return each(x, [&](double one) { return p.force(one); }); }, py::arg("x"),
            doc("spring::Potential::force"))
        .def(
            "stiffness", [](const Potential& p, const Numbers& x) { return each(x, [&](double one) { return p.stiffness(one); }); },
            py::arg("x"), doc("spring::Potential::stiffness"))
        .def("__repr__", [](const Potential& p) { return fmt::format("<Potential {:g} to {:g} rad>", p.domain().low, p.domain().high); });
    module.def(
        "tabulated",
        [](const Numbers& x, const Numbers& torque, int knots, double smoothing) {
            return std::const_pointer_cast<Potential>(spring::make_tabulated(vector_of(x), vector_of(torque), {knots, smoothing}));
        },
        py::arg("x"), py::arg("torque"), py::arg("knots") = spring::TableOptions{}.knots,
        py::arg("smoothing") = spring::TableOptions{}.smoothing,
        "A quintic smoothing spline through noisy rows of deflection `x` [rad], rising, and `torque` [Nm] (penalised B-spline, Eilers and "
        "Marx 1996). `knots` is the number of its intervals, `smoothing` the weight of its roughness, below 0: chosen by cross-validation. "
        "Raises InvalidInput naming the row.");
}

Design resolve(const py::object& given) {
    const LoadedProfile loaded = profile_of(given);
    const auto made = profile::with_places(loaded.value, [&] { return pipeline::resolve(loaded.value); });
    if (!made) return {nullptr, made.refusal()};
    return {std::make_shared<pipeline::ResolvedDesign>(*made), made->findings};
}

std::optional<LawCurve> arms_law(const Design& design) {
    if (!design.value) return std::nullopt;
    return LawCurve{std::make_shared<std::vector<LawPoint>>(spring::sample_by_load(*design.value->law(), 401))};
}

}  // namespace

void bind_law(py::module_& module) {
    bind_curve(module);
    bind_law_type(module);
    bind_potential(module);
    py::class_<Design>(module, "Design", "A profile's springs and joint, before any cam.")
        .def_property_readonly(
            "ok", [](const Design& d) { return d.value != nullptr; }, "Is the law a pair of springs?")
        .def_readonly("findings", &Design::findings, "Why the law is no pair of springs, or what to review about it.")
        .def_property_readonly(
            "law", [](const Design& d) { return d.value ? std::const_pointer_cast<spring::SpringLaw>(d.value->law()) : nullptr; },
            "The law of the springs, lead-in included; None if there is none.")
        .def_property_readonly("curve", &arms_law, "The law at 401 loads; None if there is none.")
        .def("_repr_html_",
             [](const Design& d) {
                 if (!d.value) return html_of("Cannot be made", {}, d.findings);
                 const spring::SpringLaw& law = *d.value->law();
                 return html_of(d.value->profile.name,
                                {{fmt::format("{:.4g} to {:.4g} Nm", law.loads().low, law.loads().high), "loads of the law"}}, d.findings);
             })
        .def("__repr__", [](const Design& d) {
            return d.value ? fmt::format("<Design {}>", d.value->profile.name)
                           : fmt::format("<Design refused: {} findings>", d.findings.size());
        });
    module.def("resolve", &resolve, py::arg("profile"),
               "Springs and joint of a profile, without cams. A law that cannot be made is a result with findings. Raises InvalidInput and "
               "IoError for a profile that cannot be read.");
}

}  // namespace fusee::python
