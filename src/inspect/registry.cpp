#include "measure.h"

namespace fusee::inspect {

#include "rules_registry.h"

std::span<const Rule> rules() {
    static const Rules all = checks::make_rules<Rule>(kRegistered);
    return all;
}

std::vector<Marked> check(const Foreign& part, const std::string& name) {
    std::vector<Marked> all;
    for (const Rule& rule : rules()) {
        if (rule.of_file != (part.file != nullptr)) continue;
        auto marked = rule.measure(part, Allowed(rule, part.overrides));
        if (!marked) continue;
        core::Finding& f = marked->finding;
        f.where = f.where.empty() ? name : name + " " + f.where;
        checks::complete(f, rule, name);
        if (f.severity == core::Severity::kPass) marked->triangles.clear();
        all.push_back(std::move(*marked));
    }
    return all;
}

void set_place(core::Finding& f, const Vec3& at) {
    f.where = fmt::format("at ({:.2f}, {:.2f}, {:.2f}) mm", at[0], at[1], at[2]);
    f.place = core::Place{std::atan2(at[1], at[0]), at};
}

std::string named(const File& file, std::size_t piece) {
    const std::string& name = file.pieces()[piece].name;
    return name.empty() ? "the body" : name;
}

Vec3 middle_of(const Body& body, std::uint32_t triangle) {
    const solid::Triangle& t = body.mesh().triangles[triangle];
    const auto& p = body.mesh().points_mm;
    return (1.0 / 3.0) * (p[t[0]] + p[t[1]] + p[t[2]]);
}

std::vector<std::uint32_t> triangles_of(const Body& body, const std::function<bool(const Sample&)>& wanted) {
    std::vector<std::uint32_t> triangles;
    for (const Sample& s : body.samples())  // by ascending triangle
        if ((triangles.empty() || triangles.back() != s.triangle) && wanted(s)) triangles.push_back(s.triangle);
    return triangles;
}

}  // namespace fusee::inspect
