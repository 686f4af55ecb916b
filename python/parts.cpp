#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "arrays.h"
#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/folder.h"
#include "fusee/core/text.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/step.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "results.h"
#include "work.h"

namespace fusee::python {

namespace {

using cam::Contact;

/// An array over the working positions of a part's cam.
template <class Get>
auto working(const Get& get) {
    return [get](const PartResult& p) { return column(p.part, p.part->cam.working, get); };
}

void def_arms(py::class_<PartResult>& type) {
    type.def_property_readonly("tau", working([](const Contact& c) -> const double& { return c.arm.tau; }), doc("cam::ArmPoint::tau"))
        .def_property_readonly("angle", working([](const Contact& c) -> const double& { return c.arm.angle; }), doc("cam::ArmPoint::angle"))
        .def_property_readonly("arm", working([](const Contact& c) -> const double& { return c.arm.arm; }), doc("cam::ArmPoint::arm"))
        .def_property_readonly("tension", working([](const Contact& c) -> const double& { return c.arm.tension; }),
                               doc("cam::ArmPoint::tension"))
        .def_property_readonly("state", working([](const Contact& c) -> const double& { return c.arm.state; }), doc("cam::ArmPoint::state"))
        .def_property_readonly("psi", working([](const Contact& c) -> const double& { return c.path.psi; }),
                               "Direction of the cable's normal [rad], not wrapped: a helix continues beyond 2 pi.")
        .def_property_readonly("h", working([](const Contact& c) -> const double& { return c.path.h; }), doc("cam::PathPoint::h"))
        .def_property_readonly("rho", working([](const Contact& c) -> const double& { return c.path.rho; }), doc("cam::PathPoint::rho"))
        .def_property_readonly("z", working([](const Contact& c) -> const double& { return c.path.z; }),
                               "Height of the cable's centreline in the body frame [m].")
        .def_property_readonly("fleet", working([](const Contact& c) -> const double& { return c.fleet; }), doc("cam::Contact::fleet"));
}

/// The cable's centreline on the whole groove.
py::array_t<double> contour(const PartResult& p, std::size_t count) {
    if (count < 2) throw py::value_error("count: at least 2");
    auto points = std::make_shared<std::vector<std::array<double, 3>>>();
    for (std::size_t i = 0; i < count; ++i) {
        const cam::PathPoint point = p.part->cam.path(p.part->cam.groove_psi.level(i, count));
        points->push_back({point.x(), point.y(), point.z});
    }
    return table(points, *points);
}

/// The mesh as an object of the package trimesh, which copies it. @throws ImportError of Python if the package is missing
py::object to_trimesh(const PartResult& p) {
    py::object package;
    try {
        package = py::module_::import("trimesh");
    } catch (py::error_already_set& e) {
        if (!e.matches(PyExc_ImportError)) throw;
        throw py::import_error(
            "Part.to_trimesh needs the package trimesh, which is not installed: pip install trimesh. Without it, points_mm and triangles "
            "are the mesh");
    }
    using namespace pybind11::literals;
    py::dict about;
    about["name"] = p.name;
    about["units"] = "mm";
    return package.attr("Trimesh")("vertices"_a = table(p.part, p.part->mesh.points_mm), "faces"_a = table(p.part, p.part->mesh.triangles),
                                   "process"_a = false, "metadata"_a = about);
}

void write_exact(const PartResult& p, const std::filesystem::path& file) {
    const auto solid = exchange::brep::build(*p.part);
    if (!solid) throw core::InvalidInput(p.name, "no exact solid", core::to_line(solid.refusal().front()));
    exchange::write_step(file, *solid, p.name, p.provenance, {checks::designation_of(p.process), checks::material_of(p.process).density});
}

std::filesystem::path write_part(const PartResult& p, const std::filesystem::path& file, bool force) {
    const std::string ending = core::lower(file.extension().string());
    if (ending != ".stl" && ending != ".3mf" && ending != ".step" && ending != ".stp")
        throw core::InvalidInput("file", file.string(),
                                 "a name that ends in .stl, .3mf or .step; fusee.make(profile, out) writes the others");
    core::require_new_file(file, force);
    return run(py::none(), [&](Watch&) {
        if (ending == ".stl")
            exchange::write_stl(file, p.part->mesh, p.provenance);
        else if (ending == ".3mf")
            exchange::write_3mf(file, p.part->mesh, p.name, p.provenance);
        else
            write_exact(p, file);
        return file;
    });
}

}  // namespace

void bind_parts(py::module_& module) {
    py::class_<PartResult> type(module, "Part", "A cam as a solid: its mesh, its findings, and its arms over the working range.");
    type.def_readonly("name", &PartResult::name, R"("k_se", "k_pe"; the antagonist's: "k_se_mirrored", "k_pe_mirrored")")
        .def_readonly("findings", &PartResult::findings, "Of every rule on this part.")
        .def_property_readonly(
            "points_mm", [](const PartResult& p) { return table(p.part, p.part->mesh.points_mm); },
            "The mesh's points in the body frame [mm], n x 3; not a copy.")
        .def_property_readonly(
            "triangles", [](const PartResult& p) { return table(p.part, p.part->mesh.triangles); },
            "Places in points_mm, n x 3, counter-clockwise seen from outside; not a copy.")
        .def("contour", &contour, py::arg("count") = 721,
             "The cable's centreline over the groove, count x 3, in the body frame [m]; computed by this call.")
        .def_property_readonly(
            "volume_mm3", [](const PartResult& p) { return solid::volume_mm3(p.part->mesh); }, doc("solid::volume_mm3"))
        .def_property_readonly(
            "closed", [](const PartResult& p) { return solid::is_closed_and_oriented(p.part->mesh.triangles); },
            "Has every edge exactly two triangles, which run along it in opposite directions?")
        .def("to_trimesh", &to_trimesh,
             "The mesh as a trimesh.Trimesh in millimetres, a copy. Raises ImportError if the package trimesh is not installed.")
        .def("export", &write_part, py::arg("file"), py::arg("force") = false,
             "Writes the part as *.stl, *.3mf or *.step (millimetres, body frame) and returns the file's path; the bytes are those of "
             "`make`. The file is not read back. Raises InvalidInput for another ending, IoError if the file exists, unless `force`.")
        .def("__repr__", [](const PartResult& p) {
            return fmt::format("<Part {}: {} triangles, {} arms>", p.name, p.part->mesh.triangles.size(), p.part->cam.working.size());
        });
    def_arms(type);
}

}  // namespace fusee::python
