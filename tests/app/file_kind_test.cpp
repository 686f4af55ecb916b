#include "app/run.h"

// A file of another kind than the command reads: what it is, and which command reads it.
namespace fusee::app {
namespace {

class OtherKinds : public Program {
protected:
    void SetUp() override {
        Program::SetUp();
        const fs::path profiles = fs::path(FUSEE_SOURCE_DIR) / "profiles", examples = profiles / "examples";
        for (const auto& [from, to] : {std::pair{profiles / "pnrvsa.toml", "profile.toml"},
                                       {profiles / "studies" / "pnrvsa.toml", "study.toml"},
                                       {examples / "break_away.csv", "tests.csv"},
                                       {examples / "coupon.csv", "coupon.csv"},
                                       {examples / "k_pe_inspection.csv", "inspection.csv"},
                                       {profiles / "measured_table.csv", "springs.csv"},
                                       {profiles / "springs" / "catalogue.csv", "catalogue.csv"}})
            fs::copy_file(from, folder_ / to);
        fs::copy(profiles / "gap" / "paper_table_1", folder_ / "case");
        write("part.stl", "solid part\n");
        write("diagnosis.json", "{}");
        write("report.html", "<!doctype html>");
        write("note.txt", "hello\n");
    }
    /// The refusal names each of these words, and no mistake inside the file.
    void expect_kind(const std::string& arguments, std::initializer_list<std::string> words) const {
        SCOPED_TRACE(arguments);
        const Ended refused = run(arguments);
        EXPECT_EQ(refused.code, 2) << refused.all();
        expect_words(refused.err, words);
        for (const char* noise : {"header", "mistakes", "missing", "not valid TOML", "ASCII"})
            EXPECT_EQ(refused.err.find(noise), std::string::npos) << refused.err;
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
};

TEST_F(OtherKinds, AreNamedWithTheCommandThatReadsThem) {
    struct Kind {
        const char *file, *is;
    };
    const std::initializer_list<Kind> csv{{"tests.csv", "is a sheet of break-away tests, which fusee identify reads"},
                                          {"coupon.csv", "is a sheet of coupons, which fusee calibrate reads"},
                                          {"inspection.csv", "is the inspection sheet of a part, which fusee calibrate reads"},
                                          {"springs.csv", "is a table of measured springs, which fusee init --law reads"},
                                          {"catalogue.csv", "is a list of springs on sale, which fusee springs --catalogue reads"},
                                          {"case/dead_band.csv", "is a sheet of a case; fusee diagnose reads its folder"},
                                          {"note.txt", "is a CSV file"}};
    const std::initializer_list<Kind> others{{"study.toml", "is a study, which fusee batch reads"},
                                             {"case/case.toml", "is the file of a case; fusee diagnose reads its folder"},
                                             {"part.stl", "is a mesh, which fusee check reads"},
                                             {"diagnosis.json", "is a diagnosis, which fusee predict --effects reads"},
                                             {"report.html", "is a page for a browser"}};
    for (const auto& kinds : {csv, others})
        for (const Kind& kind : kinds) expect_kind(std::string("make ") + kind.file, {kind.file, kind.is, "(allowed: a profile"});
    for (const Kind& kind : others) expect_kind(std::string("identify ") + kind.file, {kind.is, "allowed: a CSV file of break-away tests"});
    expect_kind("identify profile.toml", {"csv: profile.toml is a profile, which fusee make reads", "More: fusee identify --help"});
    expect_kind("identify coupon.csv", {"which fusee calibrate reads"});
    expect_kind("calibrate tests.csv", {"which fusee identify reads"});
    expect_kind("calibrate coupon.csv --profile study.toml", {"--profile", "which fusee batch reads"});
}

TEST_F(OtherKinds, AreNamedByEveryCommandThatReadsFiles) {
    for (const char* command : {"simulate", "watch", "check", "fix", "springs", "budget", "coupons", "design"})
        expect_kind(command + std::string(" study.toml"), {"study.toml", "is a study, which fusee batch reads"});
    expect_kind("case-template study.toml --out new", {"is a study", "with --next the folder of a case"});
    expect_kind("case-template case --next profile.toml --out new", {"--next", "is a profile", "diagnosis.json"});
    expect_kind("render tests.csv --out new.png", {"is a sheet of break-away tests", "a profile"});
    expect_kind("batch tests.csv", {"is a sheet of break-away tests", "a study, or profiles"});
    expect_kind("query study.toml 'SELECT 1'", {"is a study", "the folder that fusee batch wrote"});
    for (const char* command : {"diagnose", "predict"}) {
        expect_kind(command + std::string(" profile.toml --out new"), {"is a profile", "fusee case-template PROFILE"});
        expect_kind(command + std::string(" case/case.toml --out new"), {"reads its folder", "the folder of a case"});
        expect_kind(command + std::string(" case --model profile.toml --out new"), {"--model", "is a profile", "a file with [model]"});
    }
    expect_kind("diagnose case --against tests.csv --out new", {"--against", "is a sheet of break-away tests"});
    expect_kind("springs profile.toml --catalogue tests.csv", {"--catalogue", "is a sheet of break-away tests"});
    expect_kind("identify case", {"is the folder of a case, which fusee diagnose reads"});
}

// What is not recognised is left to the command's reader, which knows its place.
TEST_F(OtherKinds, AreNotGuessed) {
    for (const char* file : {"new.csv", "case/new.csv"}) {
        write(file, "Seite,Richtung,Moment\n");
        expect_words(run(std::string("identify ") + file).err, {"new.csv:1:", "header"});
    }
    write("half.toml", "name = \"t\"\n[rig\n");
    expect_words(run("check half.toml").err, {"half.toml:2:", "not valid TOML"});
    write("bad.toml", "[law]\nkind = 3\n");
    expect_words(run("check bad.toml").err, {"mistakes", "law.kind"});
    EXPECT_EQ(run("diagnose nowhere --out new").code, 2);
}

// One of several: the others are made.
TEST_F(OtherKinds, AreOneRowOfSeveral) {
    const std::string good = quick("pnrvsa");
    const Ended ended = run("simulate " + good + " study.toml");
    EXPECT_EQ(ended.code, 2) << ended.all();
    expect_words(ended.all(), {"simulated", "study.toml: is a study, which fusee batch reads"});
}

}  // namespace
}  // namespace fusee::app
