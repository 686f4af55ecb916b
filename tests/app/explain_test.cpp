#include <regex>
#include <set>

#include "app/run.h"
#include "fusee/core/error.h"
#include "fusee/profile/edit.h"

namespace fusee::app {
namespace {

using Json = nlohmann::json;

TEST_F(Program, ExplainsRulesKeysEffectsAndTerms) {
    expect_words(run("explain spring.index").out,
                 {"spring.index: rule", "guards against: ", "measured: ", "limit: ", "example: ", "source: "});
    expect_words(run("explain law.start_torque_Nm").out,
                 {"law.start_torque_Nm: key", "unit: Nm", "allowed: ", "good: law.start_torque_Nm = 0.6, as in profiles/pnrvsa.toml",
                  "bad: law.start_torque_Nm = 0\n"});
    expect_words(run("explain term.motor.ripple").out, {"term.motor.ripple: generic term", "enters at: motor", "depends on: angle"});
    expect_words(run("explain gear.coulomb").out, {"gear.coulomb: effect", "seen by: breakaway", "distinguished from gear.load_friction",
                                                   "profile key: rig.gear_friction_constant_Nm"});
    expect_words(run("explain gear.backlash").out, {"advice: remove the play"});
    expect_words(run("explain rig.capstan_radius_m").out,
                 {"rig.capstan_radius_m: key of case.toml", "range: 0.0005 to 0.5", "means: r_c, of the capstan"});
    expect_words(run("explain pe_preload_m").out, {"tolerance.pe_preload_m: key of case.toml", "default: 5e-5"});
    expect_words(run("explain experiments.breakaway").out, {"measured columns: load_torque_Nm"});
    for (const char* name : {"parameters.NAME", "parameters.mass_kg", "parameters.mass_kg.tolerance"})
        expect_words(run(std::string("explain ") + name).out,
                     {"parameters.NAME: key of case.toml of a model of one's own", "tolerance_abs"});
    expect_words(run("explain model.command").out, {"model.command: key of case.toml", "default: required without mjcf"});
    expect_words(run("explain experiments.swing.outputs").out, {"experiments.NAME.outputs: key", "columns that are compared"});
    expect_words(run("explain study.method").out, {"study.method: key of a study", "default: grid"});
    expect_words(run("explain vary").out, {"vary: key of a study", "a line for each key"});
    expect_words(run("explain 'not judged'").out, {"not judged: term", "a rule that applies and lacks data"});
    EXPECT_EQ(run("explain not_judged").out, run("explain 'Not judged'").out);
    expect_words(run("explain cable").out, {"cable: group", "cable.bend_ratio", "cable: table", "cable.diameter_mm"});
    expect_words(run("explain bore_mm").out, {"k_se.hub.bore_mm: key", "k_pe.hub.bore_mm: key"});
}

TEST_F(Program, EveryRuleAndKeyAndTermOfTheDiagnosisIsExplained) {
    std::string names;
    for (const Json& rule : result_of(run("rules --json"))) names += " " + rule.at("rule").get<std::string>();
    for (const Json& key : result_of(run("keys --json"))) names += " " + key.at("key").get<std::string>();
    const Ended all = run("explain --json" + names);
    ASSERT_EQ(all.code, 0) << all.err;
    std::size_t keys = 0;
    const Json result = result_of(all);  // outlives the loop
    for (const Json& entry : result.at("entries")) keys += entry.at("kind") == "key" ? 1 : 0;
    EXPECT_GE(keys, profile::key_names().size()) << "a rule may have the name of a key";
    for (const char* verdict : {"identified", "ambiguous", "unknown", "refused", "warning"})
        EXPECT_EQ(run(std::string("explain ") + verdict).code, 0);
}

/// Every "group.name" in the sources is an id that some message prints. Not so: names of files and of streams of random numbers, arguments
/// of functions (`require_positive("rig.ratio", ...)`) and the keys of case.toml and of studies, which their own documents explain; outside
/// effects of the blind benchmark and beginnings of ids.
TEST_F(Program, EveryIdOfTheSourcesIsExplained) {
    const std::regex literal(R"re((\w*\(?)"([a-z_]+\.[a-z][a-z_0-9]*)[" ])re"), argument(R"re((require\w*|InvalidInput)\()re"),
        no_id(R"re(.*\.(h|csv|tbl|txt|toml|json|html|xml|py|mjs|sh|md|svg|png|pdf|stl|step|dxf|scad|ngc|gcode|sqlite|sealed|so)|mix\..*|)re"
              R"re((study|bench|model|sensors|protocol|experiments)\..*|rig\.springs|outside\..*|figure\.(joint|motor))re");
    std::set<std::string> ids;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FUSEE_SOURCE_DIR) / "src")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string text = core::read_file(entry.path());
        for (std::sregex_iterator at(text.begin(), text.end(), literal), end; at != end; ++at)
            if (!std::regex_match((*at)[1].str(), argument) && !std::regex_match((*at)[2].str(), no_id)) ids.insert((*at)[2]);
    }
    ASSERT_GT(ids.size(), 300u);
    std::string names;
    for (const std::string& id : ids) names += " " + id;
    const Ended all = run("explain --json" + names);
    EXPECT_EQ(all.code, 0) << all.err;  // names the first that is not known
}

TEST_F(Program, SymbolsAndFindingsOfStepsAreExplained) {
    expect_words(run("explain tau_f").out, {"stiction: term", "gear friction: term"});
    expect_words(run("explain C").out, {"spring law, law: term"});
    expect_words(run("explain c").out, {"compliance: term"});
    expect_words(run("explain D/d").out, {"bend ratio: term"});
    expect_words(run("explain cover.least").out, {"cover.least: limit of a search", "what to change: a greater rig.least_torque_Nm"});
    expect_words(run("explain readback.arm").out, {"finding of a step", "what to change: "});
    expect_words(run("explain law.transmission").out, {"law.transmission: key", "law.transmission: finding of a step"});
    expect_words(run("explain law.hysteresis").out, {"effect of a subsystem case", "Unloading gives back less torque"});
    expect_words(run("explain hub.bore_mm").out, {"k_se.hub.bore_mm: key", "k_pe.hub.bore_mm: key"});
}

/// The bad values that `explain` shows are refused, the good ones are read.
TEST_F(Program, GoodAndBadValuesOfKeysAreTrue) {
    const std::string toml = core::read_file(fixtures::shipped("pnrvsa"));
    const std::filesystem::path file = fixtures::shipped("pnrvsa");
    const profile::Profile shipped = profile::read_profile(file);
    std::string names;
    for (const std::string& key : profile::key_names()) names += " " + key;
    std::size_t refused = 0;
    const Json result = result_of(run("explain --json" + names));  // outlives the loop
    for (const Json& entry : result.at("entries")) {
        if (entry.at("kind") != "key") continue;  // a rule of the same name
        const std::string key = entry.at("name");
        if (!profile::value_text(shipped, key)) continue;  // has no meaning in this profile
        const auto read = [&](const std::string& value) {
            return profile::parse_profile(profile::with_edits(toml, shipped, {{key, value, "", ""}}), file);
        };
        if (!entry.at("bad").is_null()) {
            EXPECT_THROW((void)read(entry.at("bad")), core::InputError) << key << " = " << entry.at("bad");
            ++refused;
        }
        if (!entry.at("good").is_null() && toml.find(entry.at("good").get<std::string>()) != std::string::npos) {
            EXPECT_NO_THROW((void)read(entry.at("good"))) << key << " = " << entry.at("good");
        }
    }
    EXPECT_GT(refused, 100u);
}

TEST_F(Program, KeysAndRulesAreFilteredByBeginningAndByWord) {
    EXPECT_EQ(run("keys --names law").out.find("cable"), std::string::npos);
    expect_words(run("keys --names law").out, {"law.kind\n"});
    expect_words(run("keys law.start").out, {"[law]\n", "  start_torque_Nm = "});
    EXPECT_EQ(run("keys law.start").out.find("end_torque"), std::string::npos);
    expect_words(run("keys --names friction").out, {"rig.gear_friction\n"});
    const std::string rules = run("rules cable").out;
    expect_words(rules, {"cable.bend_ratio", "source: "});
    EXPECT_EQ(rules.find("groove."), std::string::npos);
    EXPECT_NE(run("rules").out.find(rules), std::string::npos) << "the same lines as in the whole list";
    expect_words(run("rules spring.index cable.bend_ratio").out, {"spring.index", "cable.bend_ratio"});
}

}  // namespace
}  // namespace fusee::app
