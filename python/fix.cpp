#include "fusee/search/fix.h"

#include <fmt/format.h>

#include "bindings.h"
#include "fusee/profile/edit.h"
#include "fusee/profile/places.h"
#include "work.h"

namespace fs = std::filesystem;

namespace fusee::python {

namespace {

const char* word_of(search::fix::Fix::End end) {
    switch (end) {
        case search::fix::Fix::End::kNothingToDo:
            return "nothing to do";
        case search::fix::Fix::End::kFixed:
            return "fixed";
        case search::fix::Fix::End::kShortened:
            return "shortened";
        case search::fix::Fix::End::kCannot:
            break;
    }
    return "cannot";
}

search::fix::Fix find(const py::object& given, const std::vector<std::string>& keep, bool reviews, int most, const py::object& progress) {
    const LoadedProfile loaded = profile_of(given);
    for (const std::string& key : keep) profile::require_key("keep", key);
    const fs::path own = loaded.value.file;
    return run(progress, [&](Watch& watch) {
        search::fix::FixOptions options;
        options.file = own.parent_path() / (own.stem().string() + "-fixed.toml");
        options.reviews = reviews;
        options.keep = keep;
        options.most_judged = most;
        options.progress = [&watch](const std::string& step) { watch.tell(step); };
        options.stop = [&watch] { return watch.stopped(); };
        return profile::with_places(loaded.value, [&] { return search::fix::find_fix(loaded.value, loaded.toml, options); });
    });
}

std::optional<LoadedProfile> profile_found(const search::fix::Fix& found) {
    if (found.toml.empty()) return std::nullopt;
    return LoadedProfile{profile::parse_profile(found.toml, found.file), found.toml};
}

void bind_parts_of_fix(py::module_& module) {
    using search::fix::MadeChange, search::fix::Conflict;
    py::class_<MadeChange>(module, "Change", doc("search::fix::MadeChange"))
        .def_readonly("key", &MadeChange::key, "The key that changes.")
        .def_readonly("old", &MadeChange::was, "As TOML.")
        .def_readonly("new", &MadeChange::value, "As TOML.")
        .def_readonly("asks_for", &MadeChange::asks_for, doc("search::fix::MadeChange::asks_for"))
        .def_readonly("because", &MadeChange::because, doc("search::fix::MadeChange::because"))
        .def_readonly("follows", &MadeChange::follows, doc("search::fix::MadeChange::follows"))
        .def("__repr__", [](const MadeChange& c) { return fmt::format("<Change {}: {} to {}>", c.key, c.was, c.value); });
    py::class_<Conflict>(module, "Conflict", doc("search::fix::Conflict"))
        .def_readonly("one", &Conflict::one, "The finding that the change is for.")
        .def_readonly("other", &Conflict::other, "The finding that it causes.")
        .def_property_readonly(
            "key", [](const Conflict& c) { return c.change.key; }, "Of the change made for `one`.")
        .def_property_readonly(
            "old", [](const Conflict& c) { return c.change.was; }, "As TOML.")
        .def_property_readonly(
            "new", [](const Conflict& c) { return c.change.value; }, "As TOML.");
}

}  // namespace

void bind_fix(py::module_& module) {
    bind_parts_of_fix(module);
    py::class_<search::fix::Fix>(module, "Fix", doc("search::fix::Fix"))
        .def_property_readonly(
            "ok", [](const search::fix::Fix& f) { return f.end != search::fix::Fix::End::kCannot; },
            "Can it be made, as it is or with the changes?")
        .def_property_readonly(
            "end", [](const search::fix::Fix& f) { return word_of(f.end); }, R"("nothing to do", "fixed", "shortened" or "cannot")")
        .def_readonly("changes", &search::fix::Fix::changes, "Of the fixed profile, or of the candidate that is nearest.")
        .def_readonly("findings", &search::fix::Fix::left, doc("search::fix::Fix::left"))
        .def_readonly("conflicts", &search::fix::Fix::conflicts, doc("search::fix::Fix::conflicts"))
        .def_readonly("unchanged", &search::fix::Fix::unchanged, doc("search::fix::Fix::unchanged"))
        .def_property_readonly("profile", &profile_found, "The new profile, not written yet; None unless it is fixed.")
        .def_readonly(
            "band_before", &search::fix::Fix::band_before,
            "Exact dead-band at peak torque, full width at the joint [rad]; None where the law does not exist or does not reach that far.")
        .def_readonly("band_after", &search::fix::Fix::band_after, "The same of the new profile.")
        .def("__repr__", [](const search::fix::Fix& f) {
            return fmt::format("<Fix of {}: {}, {} changes>", f.profile_name, word_of(f.end), f.changes.size());
        });
    module.def(
        "fix", &find, py::arg("profile"), py::kw_only(), py::arg("keep") = std::vector<std::string>{}, py::arg("reviews") = false,
        py::arg("most") = search::fix::FixOptions{}.most_judged, py::arg("progress") = py::none(),
        "Applies the changes that the findings suggest, best first, until the profile can be made with all its files (docs/guides/fix.md): "
        "drawn features before bought parts, the law last. No single change of the result can be left out. Facts (rig, machine, strength "
        "of a material) are never changed, nor the keys in `keep`; `reviews` mends warnings too; at most `most` candidates are judged. "
        "Nothing is written. `progress` is called with a text. Raises InvalidInput, also naming a key of `keep` that does not exist.");
}

}  // namespace fusee::python
