#include "fusee/batch/slurm.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "pipeline/fixture.h"
#include "refused.h"

namespace fusee::batch {
namespace {

namespace fs = std::filesystem;

/// A program sbatch that stands first on PATH.
class Slurm : public fixtures::TempFolder {
protected:
    void SetUp() override {
        fixtures::TempFolder::SetUp();
        path_ = std::getenv("PATH");
        ::setenv("PATH", (bin().string() + ':' + path_).c_str(), 1);
    }
    void TearDown() override {
        ::setenv("PATH", path_.c_str(), 1);
        fixtures::TempFolder::TearDown();
    }
    [[nodiscard]] fs::path bin() const { return folder_ / "bin"; }
    void sbatch(const std::string& script) const {
        const fs::path program = write("bin/sbatch", "#!/bin/sh\n" + script);
        fs::permissions(program, fs::perms::owner_all);
    }
    [[nodiscard]] study::Plan plan() const {
        write("base.toml", core::read_file(fixtures::shipped("pnrvsa")));
        return study::Plan(study::read_study(write("s.toml", "[study]\nbase = \"base.toml\"\n[vary]\nk_se.hub.bore_mm = [5.0, 6.0]\n")));
    }
    [[nodiscard]] SlurmJobs submit(const std::string& out = "out") const {
        return submit_slurm(plan(), {.paths = {folder_ / "s.toml"},
                                     .name = "batch",
                                     .out = folder_ / out,
                                     .tasks = 2,
                                     .sbatch = "",
                                     .patience = std::chrono::seconds(1)});
    }
    [[nodiscard]] std::string refusal() const {
        try {
            (void)submit();
        } catch (const core::IoError& e) {
            return e.what();
        }
        return "accepted";
    }
    [[nodiscard]] std::string jobs() const { return core::read_file(folder_ / "out/s/slurm/jobs.txt"); }
    void expect_refused(std::initializer_list<const char*> words) const {
        const std::string why = refusal();
        for (const char* word : words) EXPECT_NE(why.find(word), std::string::npos) << word << " in " << why;
    }

private:
    std::string path_;
};

TEST_F(Slurm, BothJobsAreSubmittedAndTheirNumbersKept) {
    sbatch("case \"$*\" in *afterany:41*) echo '42;cluster';; *) echo 'sbatch: warning: slow'; echo 41;; esac\n");
    const SlurmJobs done = submit();
    EXPECT_EQ(done.array_job, "41");
    EXPECT_EQ(done.merge_job, "42");
    EXPECT_EQ(jobs(), "array.sh 41\nindex.sh 42\n");
    EXPECT_EQ(submit().merge_job, "42") << "again";
}

TEST_F(Slurm, TheFirstJobIsToldIfTheSecondFails) {
    sbatch("case \"$*\" in *afterany*) echo 'queue is full' >&2; exit 1;; *) echo 41;; esac\n");
    expect_refused({"index.sh", "queue is full", "job 41", "--dependency=afterany:41", "scancel 41"});
    EXPECT_EQ(jobs(), "array.sh 41\n");
}

TEST_F(Slurm, AnAnswerThatIsNoNumberIsRefused) {
    sbatch("echo 'Submitted, I think'\n");
    expect_refused({"array.sh", "Submitted, I think", "squeue"});
    EXPECT_FALSE(fs::exists(folder_ / "out/s/slurm/jobs.txt"));
}

TEST_F(Slurm, ASubmissionThatHangsIsTold) {
    sbatch("sleep 100\n");
    const auto begin = std::chrono::steady_clock::now();
    expect_refused({"array.sh", "no answer in 1 s", "squeue"});
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(Slurm, AScriptOfTheUsersIsNotReplacedAndNoLinkIsFollowed) {
    sbatch("echo 41\n");
    EXPECT_EQ(refusal(), "accepted");
    write("out/s/slurm/array.sh", "mine");
    expect_refused({"slurm/array.sh", "was changed"});
    fs::remove_all(folder_ / "out/s/slurm");
    fs::create_directories(folder_ / "victim");
    fs::create_directory_symlink(folder_ / "victim", folder_ / "out/s/slurm");
    expect_refused({"slurm", "is a link"});
    EXPECT_TRUE(fs::is_empty(folder_ / "victim"));
    fs::remove(folder_ / "out/s/slurm");
    fs::remove(folder_ / "out/s/study.toml");
    write("out/s/.fusee.json", "{\"files\":{}}");
    write("out/s/slurm/array.sh", "mine");
    expect_refused({"slurm/array.sh", "did not make"});
    EXPECT_EQ(core::read_file(folder_ / "out/s/slurm/array.sh"), "mine");
}

// What Slurm's own parser of #SBATCH lines and the shell make of each path is tried by tests/house/slurm_test.sh.
TEST_F(Slurm, PathsAreQuotedOrRefused) {
    sbatch("echo 41\n");
    const std::string name = "a 'b' \"c\" $(d) `e` 50% #f";
    const std::string script = core::read_file(submit(name).array_script);
    EXPECT_NE(script.find("#SBATCH --output=\"" + (folder_ / "a 'b' \\\"c\\\" $(d) `e` 50%% #f/s/slurm/%a.log").string() + "\"\n"),
              std::string::npos)
        << script;
    EXPECT_NE(script.find("--out '" + (folder_ / "a '\\''b'\\'' \"c\" $(d) `e` 50% #f").string() + "'"), std::string::npos) << script;
    for (const char* wrong : {"a\nb", "a\\b", "a\tb"}) {
        EXPECT_EQ(field_refused([&] { return submit(wrong); }), "--out") << wrong;
        EXPECT_FALSE(fs::exists(folder_ / wrong)) << wrong;
    }
}

}  // namespace
}  // namespace fusee::batch
