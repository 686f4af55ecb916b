#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <optional>
#include <thread>

#include "fusee/batch/batch.h"
#include "fusee/core/file.h"
#include "fusee/core/file_watch.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/profile/edit.h"
#include "run_each.h"

namespace fusee::batch {

namespace {

using std::chrono::milliseconds;
constexpr milliseconds kLook{50}, kQuiet{15};  // an editor writes a file in several steps
constexpr std::size_t kMostChanges = 4;        // shown in one line

double ms_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// The full make of one profile at a time, on its own thread; a newer one waits until the stopped one has ended.
class Maker {
public:
    explicit Maker(const OutFolder& folder) : folder_(folder) {}
    ~Maker() { cancel(); }  // the thread joins

    void start(profile::Profile profile) {
        cancel();
        next_ = std::move(profile);
    }
    void cancel() {
        next_.reset();
        stop_ = true;
    }
    /// A make that has ended.
    struct Ended {
        Row row;
        bool of_earlier_save;  // it was stopped too late: its files are complete, and a newer save has been answered
    };
    /// Begins what waits. @returns the make that has ended, unless it was stopped in time
    std::optional<Ended> look() {
        std::optional<Ended> done;
        if (thread_.joinable() && ended_) {
            thread_.join();
            if (row_.outcome != Outcome::kInterrupted) done = Ended{std::move(row_), stop_.load()};
        }
        if (!thread_.joinable() && next_) begin(*std::exchange(next_, std::nullopt));
        return done;
    }

private:
    void begin(const profile::Profile& profile) {
        stop_ = ended_ = false;
        row_ = Row{};
        row_.profile = profile.file;
        thread_ = std::jthread([this, profile] {
            const auto start = std::chrono::steady_clock::now();
            guarded(row_, [&] {
                row_.result = make(profile, folder_, {.stop = [this] { return stop_.load() || core::interrupted(); }});
                row_.result.design.reset();
                row_.outcome = row_.result.made ? Outcome::kMade : Outcome::kRefused;
            });
            row_.seconds = 1e-3 * ms_since(start);
            ended_ = true;
        });
    }
    OutFolder folder_;
    std::optional<profile::Profile> next_;
    Row row_;  // of the thread until `ended_`
    std::atomic<bool> stop_ = false, ended_ = false;
    std::jthread thread_;
};

/// "k_pe.spring.preload_mm 14.6 -> 12", of each key that differs.
std::vector<std::string> changed_keys(const profile::Profile& from, const profile::Profile& to) {
    std::vector<std::string> changes;
    for (const std::string& key : profile::key_names()) {
        const auto was = profile::value_text(from, key), is = profile::value_text(to, key);
        if (was != is) changes.push_back(fmt::format("{} {} -> {}", key, was.value_or("none"), is.value_or("none")));
    }
    return changes;
}

std::string listed(std::vector<std::string> items) {
    const std::size_t all = items.size();
    if (all > kMostChanges) items.resize(kMostChanges);
    return fmt::format("{}{}", fmt::join(items, ", "), all > kMostChanges ? fmt::format(" and {} more", all - kMostChanges) : "");
}

/// Rule and part of each finding of this severity or worse.
std::vector<std::string> broken_rules(const core::Findings& findings) {
    std::vector<std::string> rules;
    for (const core::Finding& f : findings)
        if (core::is_broken(f)) rules.push_back(fmt::format("{} ({})", f.rule, f.where.substr(0, f.where.find(' '))));
    return rules;
}

std::vector<std::string> without(std::vector<std::string> rules, const std::vector<std::string>& others) {
    std::erase_if(rules, [&](const std::string& rule) { return std::find(others.begin(), others.end(), rule) != others.end(); });
    return rules;
}

std::string clock_text() { return fmt::format("{:%H:%M:%S}", fmt::localtime(std::time(nullptr))); }

/// Answers each save.
class Watch {
public:
    Watch(const fs::path& file, const WatchOptions& options) : file_(file), options_(options), maker_(options.folder) {}

    void run() {
        (void)core::read_file(file_, profile::kLargestFile);  // a missing profile is refused, not waited for
        files_.watch({file_});
        answer();
        while (!options_.stop()) {
            if (const auto ended = maker_.look()) show(*ended);
            if (files_.wait(kLook, kQuiet)) answer();
        }
    }

private:
    /// The fast answer; then the make begins, unless an error forbids it.
    void answer() {
        const auto begin = std::chrono::steady_clock::now();
        try {
            profile::Profile now = profile::read_profile(file_);
            if (last_ && last_->sha256 == now.sha256 && !bad_) return;  // saved without a change
            core::Findings findings = with_places_of(now);
            bad_ = false;
            tell(now, findings, ms_since(begin));
            watch_files_of(now);
            if (core::any_error(findings))
                maker_.cancel();
            else
                maker_.start(now);
            last_ = std::move(now);
            last_rules_ = broken_rules(findings);
        } catch (const core::InputError& e) {
            bad_ = true;
            maker_.cancel();
            say(fmt::format("{} bad profile, waiting for the next save:\n    {}", clock_text(), e.what()));
        }
    }
    static core::Findings with_places_of(const profile::Profile& profile) {
        try {
            return pipeline::evaluate(profile, pipeline::Depth::kOutline).all();
        } catch (const core::InvalidInput& e) {
            throw core::InvalidInput(profile.place_of(e.field()), e.value(), e.allowed());
        }
    }

    void tell(const profile::Profile& now, const core::Findings& findings, double ms) {
        const std::size_t errors = core::count(findings, core::Severity::kError);
        std::string text =
            fmt::format("{} {}: {}, {}, {} not judged; law, contours and rules without a solid in {:.0f} ms", clock_text(), now.name,
                        core::counted(errors, "error"), core::counted(core::count(findings, core::Severity::kWarning), "warning"),
                        core::count(findings, core::Severity::kNotJudged), ms);
        if (last_)
            if (const auto changes = changed_keys(*last_, now); !changes.empty()) text += "\n    changed: " + listed(changes);
        const std::vector<std::string> rules = broken_rules(findings);
        if (const auto gone = without(last_rules_, rules); !gone.empty()) text += "\n    gone: " + listed(gone);
        if (const auto fresh = without(rules, last_rules_); last_ && !fresh.empty()) text += "\n    new: " + listed(fresh);
        for (const core::Finding& f : findings)
            if (f.severity == core::Severity::kError) text += "\n    " + core::to_line(f);
        say(text);
    }
    void say(const std::string& text) {
        options_.say(text);
        if (options_.answered) options_.answered(text.substr(0, text.find('\n')));
    }

    void watch_files_of(const profile::Profile& now) {
        std::vector<fs::path> files{file_};
        for (const std::string& key : profile::key_names()) {
            const auto value = profile::names_file(key) ? profile::value_text(now, key) : std::nullopt;
            if (value && value->size() > 2) files.push_back(file_.parent_path() / value->substr(1, value->size() - 2));
        }
        files_.watch(files);
    }

    void show(const Maker::Ended& ended) {
        const Row& row = ended.row;
        std::string text = closing_table({row});
        if (!text.empty() && text.back() == '\n') text.pop_back();
        if (ended.of_earlier_save) text += "\n    of an earlier save: its files were complete when the newer one came";
        options_.say(clock_text() + " " + text);
        if (row.outcome == Outcome::kMade && options_.made) options_.made(row.result.folder);
    }

    fs::path file_;
    const WatchOptions& options_;
    core::FileWatch files_;
    std::optional<profile::Profile> last_;
    std::vector<std::string> last_rules_;
    bool bad_ = false;
    Maker maker_;
};

}  // namespace

void watch_profile(const fs::path& profile, const WatchOptions& options) { Watch(profile, options).run(); }

}  // namespace fusee::batch
