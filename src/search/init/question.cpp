#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <vector>

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/text.h"
#include "fusee/gap_case/break_away.h"
#include "fusee/math/curve.h"
#include "scale.h"

namespace fusee::search::init {

namespace {

constexpr const char* kFrictionOption = "--friction";
constexpr const char* kLawOption = "--law";
constexpr const char* kNoLaw = "none";

const std::vector<std::string> kProcesses{"fdm", "sla", "sls", "mill", "mill4"};  // edm and laser cut plates, which have no boss

/// What "?" answers.
const std::map<std::string, const char*> kHelp{
    {"--torque", "What motor and gear hold at the joint without getting too hot. It is the largest co-contraction of the design."},
    {"--overdrive", "What they give for seconds. The springs may not end before it; a smaller one makes smaller cams."},
    {"--least", "The softest state in use. The dead-band is widest there."},
    {"--ratio", "Radius of the joint's pulley over that of the capstan: 2 halves the torques at the capstan."},
    {"--range", "The springs have to allow this angle of the joint."},
    {kLawOption, "Torque of each spring over the capstan's angle. Then cams and base springs alone are searched; none: also the law."},
    {"--joint-stiffness", "How hard the joint resists a push while both motors hold the torque. 0: what gives the smallest dead-band."},
    {kFrictionOption,
     "mu: a gear with motor torque tau rests under loads from tau/(1+mu) to tau/(1-mu). `fusee identify` finds it from tests."},
    {"--friction-constant", "Friction of the gear without load."},
    {"--cable", "fibre: UHMWPE, such as Dyneema; steel: rope 7x49. A part with a thinner cable is smaller."},
    {"--breaking-load", "Of the cable's data sheet."},
    {"--shaft", "The part's bore, with a keyway."},
    {"--process",
     "fdm, sla, sls: printed; mill: 3 axes; mill4: with a turning axis. Each has its least wall, gap and error: `fusee rules`."},
    {"--material", "Its strength bounds pressure, keys and walls."},
    {"--bed", "No part is larger."},
    {"--size", "For a joint that has less room than the bed."},
    {"--from", "The spring has its preload there."},
    {"--to", "The spring holds the law's work there."},
};
constexpr const char* kHelpOfSpring =
    "Positive: it works against a rising angle. Columns with units, such as angle [deg],torque [Nm], or a formula: 0.3 + 0.1*x^2.";

/// A plain decimal number; none for anything else, nan and inf included.
std::optional<double> number_in(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::string plain(double value) { return fmt::format("{:.6g}", value); }

/// A question for a number of `Answers`. @param unit_si one of the unit in SI
Question number(const char* option, const char* text, const char* unit, double unit_si, core::Range allowed, double Answers::*member) {
    const std::string range = fmt::format("{:g} to {:g}", allowed.low, allowed.high);
    return {option,
            text,
            unit,
            range,
            [=](const Answers& a) { return plain(a.*member / unit_si); },
            [=](Answers& a, const std::string& entered) {
                const auto value = number_in(entered);
                if (!value || *value < allowed.low || *value > allowed.high)
                    throw core::InvalidInput(option, core::printable(entered, 60), fmt::format("a number, {} {}", range, unit));
                a.*member = *value * unit_si;
            }};
}

Question choice(const char* option, const char* text, const std::vector<std::string>& names,
                std::function<std::string(const Answers&)> shown, std::function<void(Answers&, const std::string&)> set) {
    const std::string allowed = fmt::format("{}", fmt::join(names, ", "));
    return {option, text, "", allowed, std::move(shown), [=](Answers& a, const std::string& entered) {
                if (std::find(names.begin(), names.end(), entered) == names.end())
                    throw core::InvalidInput(option, core::printable(entered, 60), allowed);
                set(a, entered);
            }};
}

/// "dyneema 0.8", "7x49 3": what riggers call it, and its diameter.
void enter_cable(Answers& a, const std::string& entered) {
    static constexpr std::pair<const char*, const char*> kNames[] = {{"fibre", "fibre"}, {"dyneema", "fibre"}, {"uhmwpe", "fibre"},
                                                                     {"steel", "7x49"},  {"7x7", "7x7"},       {"7x19", "7x19"},
                                                                     {"7x49", "7x49"}};
    std::istringstream words(entered);
    std::string name, size, rest;
    words >> name >> size >> rest;
    const auto found = std::find_if(std::begin(kNames), std::end(kNames), [&](const auto& known) { return name == known.first; });
    const auto diameter = number_in(size);
    if (found == std::end(kNames) || !diameter || *diameter < 0.2 || *diameter > 8.0 || !rest.empty())
        throw core::InvalidInput(
            "--cable", core::printable(entered, 60),
            "fibre (dyneema, uhmwpe), steel (7x49), 7x7, 7x19 or 7x49, and a diameter of 0.2 to 8 mm: \"dyneema 0.8\"");
    a.construction = found->second;
    a.cable = *diameter * 1e-3;
}

/// The share of the load, or a file of break-away tests.
void enter_friction(Answers& a, const std::string& entered) {
    if (const auto share = number_in(entered)) {
        if (*share < 0.005 || *share > 0.6)
            throw core::InvalidInput(kFrictionOption, entered, "a share of the load, 0.005 to 0.6, or a CSV file of break-away tests");
        a.friction = *share;
        return;
    }
    if (!names_file(entered))
        throw core::InvalidInput(kFrictionOption, core::printable(entered, 60),
                                 "a share of the load, 0.005 to 0.6, or a CSV file (.csv) of break-away tests");
    const std::string bytes = core::read_file(entered, gap_case::kLargestBreakAwayFile);
    const auto report = gap_case::identify_friction(gap_case::parse_break_away(bytes, entered, columns_of_friction(a.columns)));
    if (!report.law)
        throw core::InvalidInput(kFrictionOption, entered, "break-away tests that a friction law fits: fusee identify shows why");
    a.friction = std::stod(plain(report.law->mu));
    a.friction_constant = std::stod(plain(report.law->constant));
}

/// The measured law is read now, so that a bad row is told before the search.
void enter_law(Answers& a, const std::string& entered) {
    if (entered == kNoLaw) return a.law.reset();
    if (!names_file(entered))
        throw core::InvalidInput(kLawOption, core::printable(entered, 60),
                                 "a CSV file (.csv) with angle_rad,series_Nm,parallel_Nm, or none");
    a.law = profile::read_measured_law(entered, columns_of_law(a.columns));
}

std::vector<std::string> materials() {
    std::vector<std::string> names{checks::kByProcess};
    for (const checks::Material& material : checks::material_table()) names.emplace_back(material.name);
    return names;
}

std::vector<Question> joint_questions() {
    return {
        number("--torque", "Torque of one motor at the joint, held for long", "Nm", 1.0, {0.01, 1000}, &Answers::torque),
        number("--overdrive", "Torque of one motor at the joint for a short time; 0 = 1.5 times as much", "Nm", 1.0, {0, 1000},
               &Answers::overdrive),
        number("--least", "Least co-contraction in use, at the joint; 0 = 0.85 of the torque", "Nm", 1.0, {0, 1000}, &Answers::least),
        number("--ratio", "Turns of a capstan for one turn of the joint", "", 1.0, {0.2, 5}, &Answers::ratio),
        number("--range", "Range of the joint between its stops; 0 = what the springs allow", "deg", core::rad_from_deg(1.0), {0, 720},
               &Answers::joint_range),
        {kLawOption, "Springs that you measured at the capstan: a CSV file with angle_rad,series_Nm,parallel_Nm", "", "FILE.csv, or none",
         [](const Answers& a) { return a.law ? a.law->file.string() : kNoLaw; }, enter_law},
        number("--joint-stiffness", "Stiffness of the joint at the torque, capstans held; 0 = chosen", "Nm/rad", 1.0, {0, 1e5},
               &Answers::joint_stiffness),
        {kFrictionOption, "Friction of each gear: share of the load, or a CSV file of break-away tests", "", "0.005 to 0.6, or FILE.csv",
         [](const Answers& a) { return plain(a.friction); }, enter_friction},
        number("--friction-constant", "Part of the gear friction that does not grow with the load, at the capstan", "Nm", 1.0, {0, 100},
               &Answers::friction_constant),
    };
}

std::vector<Question> part_questions() {
    std::vector<Question> all{
        {"--cable", "Cable and its diameter", "mm", "fibre, steel, 7x7, 7x19 or 7x49, then 0.2 to 8",
         [](const Answers& a) { return fmt::format("{} {}", a.construction, plain(core::mm_from_m(a.cable))); }, enter_cable},
        number("--breaking-load", "Breaking load of the cable; 0 = that of a usual one", "N", 1.0, {0, 1e5}, &Answers::breaking_load),
        number("--shaft", "Diameter of the motors' shafts", "mm", 1e-3, {2, 50}, &Answers::shaft),
        choice(
            "--process", "How the parts are made", kProcesses, [](const Answers& a) { return checks::to_string(a.process); },
            [](Answers& a, const std::string& name) {
                for (const checks::ProcessLimits& row : checks::process_table())
                    if (name == checks::to_string(row.kind)) a.process = row.kind;
            }),
        choice(
            "--material", "Material of the parts; by_process: the usual one", materials(), [](const Answers& a) { return a.material; },
            [](Answers& a, const std::string& name) { a.material = name; }),
        number("--bed", "Side of the machine's bed", "mm", 1e-3, {50, 2000}, &Answers::bed),
        number("--size", "Largest diameter of spool, cam, capstan and joint's pulley; 0 = side of the bed", "mm", 1e-3, {0, 2000},
               &Answers::size),
    };
    for (Question& question : all) question.of_law = false;
    return all;
}

/// Its spelling; whether it has a value at each angle shows when the range is known.
void require_formula(const std::string& entered) {
    try {
        (void)math::make_formula(kLawOption, entered, "x", {0.1, 1.0});
    } catch (const core::InvalidInput& e) {
        if (e.allowed().starts_with("a formula")) throw;
    }
}

/// Those of one spring: its law, and what its part and shop share with a joint's.
std::vector<Question> spring_questions() {
    const auto text = [](const Answers& a) { return a.torque_law.empty() ? std::string(kNoLaw) : a.torque_law; };
    std::vector<Question> all{
        {kLawOption, "Torque of the spring: a CSV file with angle and torque, or a formula of Nm in x, the angle in rad", "",
         "FILE.csv, or such as 0.98*sin(x)", text,
         [](Answers& a, const std::string& entered) {
             if (entered != kNoLaw && !names_file(entered)) require_formula(entered);
             a.torque_law = entered == kNoLaw ? "" : entered;
         }},
        number("--from", "First angle of a formula", "deg", core::rad_from_deg(1.0), {-1e4, 1e4}, &Answers::first_angle),
        number("--to", "Last angle of a formula", "deg", core::rad_from_deg(1.0), {-1e4, 1e4}, &Answers::last_angle),
    };
    all[1].of_formula = all[2].of_formula = true;
    for (Question& question : part_questions())
        if (question.option != "--size") all.push_back(std::move(question));
    std::find_if(all.begin(), all.end(), [](const Question& q) { return q.option == "--shaft"; })->text = "Diameter of the part's shaft";
    for (Question& question : all) question.help = kHelp.at(question.option);
    all.front().help = kHelpOfSpring;
    return all;
}

}  // namespace

std::string Question::prompt(const Answers& answers) const {
    return fmt::format("{}{}{} ({}) [{}]: ", text, unit.empty() ? "" : ", ", unit, allowed, shown(answers));
}

std::span<const Question> questions(bool spring) {
    static const std::vector<Question> of_spring = spring_questions();
    if (spring) return of_spring;
    static const std::vector<Question> all = [] {
        std::vector<Question> joint = joint_questions(), parts = part_questions();
        std::move(parts.begin(), parts.end(), std::back_inserter(joint));
        for (Question& question : joint) question.help = kHelp.at(question.option);
        return joint;
    }();
    return all;
}

std::string options_text(const Answers& answers) {
    const Answers untouched;
    std::vector<std::string> words;
    for (const Question& question : questions(answers.spring))
        if (const std::string now = question.shown(answers); now != question.shown(untouched))
            words.push_back(question.option + " " + core::shell_word(now));
    return fmt::format("{}", fmt::join(words, " "));
}

namespace {

/// The greatest load of a capstan that rests, at the overdrive torque, must stand in the measured law.
void require_covered(const Answers& a) {
    if (a.joint_stiffness > 0.0)
        throw core::InvalidInput("--joint-stiffness", plain(a.joint_stiffness), "0 with --law: the measured springs have their stiffness");
    const spring::FrictionLaw friction = spring::FrictionLaw::affine(a.friction_constant, a.friction);
    const double most = a.law->series.back() + a.law->parallel.back();
    if (const double needed = friction.resting_loads(a.overdrive_torque()).high; needed > most)
        throw core::InvalidInput(
            "--law", core::printable(a.law->file.string(), 60),
            fmt::format("springs of at least {:.4g} Nm together, since stiction holds that load at an overdrive torque "
                        "of {:.4g} Nm at the capstan; these end at {:.4g} Nm: measure further, or state a smaller "
                        "--torque or --overdrive",
                        needed, a.overdrive_torque(), most));
}

/// A file has its own range, a formula needs one.
void require_law_of_spring(const Answers& a) {
    const bool file = names_file(a.torque_law), ranged = a.first_angle != 0.0 || a.last_angle != 0.0;
    if (a.torque_law.empty()) throw core::InvalidInput(kLawOption, kNoLaw, "a CSV file (.csv) with angle and torque, or a formula in x");
    if (file && ranged)
        throw core::InvalidInput("--to", plain(core::deg_from_rad(a.last_angle)), "0 with a CSV file: its rows have the range");
    if (!file && !ranged)
        throw core::InvalidInput("--to", "not stated", "the range of a formula: --from and --to in degrees, such as --from 0 --to 90");
    if (!file && !(a.columns.columns.empty() && a.columns.decimal == 0))
        throw core::InvalidInput("--columns", a.torque_law, "only with a CSV file (.csv) as --law, not with a formula");
    if (!file && a.last_angle <= a.first_angle)
        throw core::InvalidInput("--to", plain(core::deg_from_rad(a.last_angle)),
                                 fmt::format("above --from {:g} deg, for a formula", core::deg_from_rad(a.first_angle)));
    if (!file) (void)math::make_formula(kLawOption, a.torque_law, "x", {a.first_angle, a.last_angle});
}

}  // namespace

void require_consistent(const Answers& a) {
    if (a.spring) return require_law_of_spring(a);
    if (a.law) require_covered(a);
    if (a.overdrive > 0.0 && a.overdrive < a.torque)
        throw core::InvalidInput("--overdrive", plain(a.overdrive), fmt::format("0, or at least --torque {:g} Nm", a.torque));
    if (a.least >= a.torque) throw core::InvalidInput("--least", plain(a.least), fmt::format("0, or below --torque {:g} Nm", a.torque));
    if (a.friction_constant >= 0.5 * a.least_torque())
        throw core::InvalidInput("--friction-constant", plain(a.friction_constant),
                                 fmt::format("below half of the least torque at the capstan, {:g} Nm", 0.5 * a.least_torque()));
}

bool names_file(const std::string& answer) { return core::lower(answer).ends_with(".csv"); }

}  // namespace fusee::search::init
