#include "fusee/core/output_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <system_error>
#include <utility>

#include "durable.h"
#include "fusee/core/destination.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/core/stop.h"
#include "fusee/core/temporary_folder.h"
#include "manifest.h"

namespace fs = std::filesystem;

namespace fusee::core {

namespace {

constexpr const char* kItself = ".";  // a source: the output folder itself
constexpr const char* kElsewhere = "move it, or choose another folder";

/// The folder's path without links and dots; it need not exist. @throws IoError
fs::path place_of(const fs::path& target) {
    std::error_code gone;
    if (target.is_relative() && (static_cast<void>(fs::current_path(gone)), gone))
        throw IoError(target.string(), "the working folder no longer exists: " + gone.message());
    if (target.empty()) throw IoError("\"\"", "the name of a folder is empty");
    try {
        const fs::path place = fs::weakly_canonical(fs::absolute(target));
        return place.has_filename() ? place : place.parent_path();
    } catch (const fs::filesystem_error& e) {
        throw IoError(target.string(), e.code().message());
    }
}

std::string relative_source(const fs::path& source, const fs::path& place) {
    return source.empty() ? "" : place_of(source).lexically_relative(place).generic_string();
}

/// The first entry that is not a scratch file of fusee; empty if there is none.
std::string first_entry(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error))
        if (std::string name = entry->path().filename().string(); !is_temporary_name(name, kStagingPrefix)) names.insert(std::move(name));
    if (error) throw IoError(folder.string(), "cannot be read: " + error.message());
    return names.empty() ? "" : *names.begin();
}

/// Lets one run at a time into a folder.
class Lock {
public:
    explicit Lock(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        while (file_ >= 0 && ::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
        }
    }
    ~Lock() {
        if (file_ >= 0) ::close(file_);
    }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

private:
    int file_;
};

/// The present file of a name.
struct Standing {
    bool there = false, regular = false;
    std::string hash;  ///< of a regular file
};

/// @throws IoError if a part of the path is a link or a file: the file would be written elsewhere
Standing standing(const fs::path& folder, const std::string& name, const std::string& shown) {
    std::error_code ignored;
    fs::path at = folder;
    const fs::path relative(name);
    for (const fs::path& part : relative.parent_path()) {
        const fs::file_status status = fs::symlink_status(at /= part, ignored);
        if (!fs::exists(status)) return {};
        if (!fs::is_directory(status)) throw IoError(shown, fmt::format("{} is not a folder; {}", part.string(), kElsewhere));
    }
    const fs::file_status status = fs::symlink_status(folder / relative, ignored);
    Standing found{fs::exists(status), fs::is_regular_file(status), {}};
    if (found.regular) found.hash = sha256_of_file(folder / relative);
    return found;
}

/// Decides what a run may do to the files of a folder.
class Judge {
public:
    Judge(const fs::path& target, const fs::path& place, const OutputRun& run, const std::string& source)
        : target_(target), place_(place), run_(run), source_(source) {
        if (auto read = read_manifest(place)) {
            manifest_ = std::move(*read);
        } else if (!run.among_others) {
            require_empty();
        }
        require_owner();
    }

    [[nodiscard]] const Manifest& manifest() const { return manifest_; }

    /// @param hash of the bytes that will be written; empty if not known yet @returns the hash of the present file; empty: none
    [[nodiscard]] std::string require_replaceable(const std::string& name, const std::string& hash) const {
        const std::string shown = (target_ / name).string();
        const Standing found = standing(place_, name, shown);
        if (!found.there) return "";
        if (!found.regular) throw IoError(shown, fmt::format("is not a regular file, and a file is written here; {}", kElsewhere));
        const auto made = manifest_.find(name);
        if (!hash.empty() && found.hash == hash) return found.hash;
        if (made == manifest_.end())
            throw IoError(shown, fmt::format("fusee did not make this file and does not replace it: {}", kElsewhere));
        require_unchanged(made->second, found.hash, shown, is_sheet(name));
        if (is_foreign(made->second) && !run_.force)
            throw IoError(shown,
                          fmt::format("was made from {}: --force replaces it, or choose another folder", named(made->second.source)));
        return found.hash;
    }

    /// Does this run remove the file unless it makes it again?
    [[nodiscard]] bool is_stale(const MadeFile& made) const {
        if (made.source == source_) return made.command == run_.command;
        return run_.force && !run_.many_sources && is_foreign(made);
    }

    /// May a file that is no longer made be removed? A filled-in sheet stays. @throws IoError if it was changed, unless forced
    [[nodiscard]] bool require_removable(const std::string& name, const MadeFile& made) const {
        const std::string shown = (target_ / name).string();
        const Standing found = standing(place_, name, shown);
        if (!found.there || made.holds(found.hash)) return true;
        if (made.sheet || !found.regular) return false;
        require_unchanged(made, found.hash, shown, false);
        return true;
    }

    [[nodiscard]] bool is_sheet(const std::string& name) const {
        return std::find(run_.sheets.begin(), run_.sheets.end(), name) != run_.sheets.end();
    }

private:
    void require_empty() const {
        std::error_code ignored;
        if (!fs::exists(place_, ignored)) return;
        if (const std::string entry = first_entry(place_); !entry.empty())
            throw IoError(target_.string(), fmt::format("fusee did not make this folder: it holds {} and no {}. Nothing was written. Move "
                                                        "the folder away, or choose another one",
                                                        entry, kManifestName));
    }
    void require_owner() const {
        if (run_.many_sources || run_.force) return;
        for (const auto& [name, made] : manifest_)
            if (is_foreign(made))
                throw IoError(target_.string(),
                              fmt::format("holds files that fusee {} made from {}; this run uses {}. Nothing was written. --force replaces "
                                          "those files, or choose another folder",
                                          made.command, named(made.source), named(source_)));
    }
    void require_unchanged(const MadeFile& made, const std::string& hash, const std::string& shown, bool sheet) const {
        if (made.holds(hash)) return;
        if (sheet || made.sheet)
            throw IoError(shown, fmt::format("was changed since fusee {} made it, and is a sheet to fill in: it is never replaced. {}",
                                             made.command, "Move it, or choose another folder"));
        if (!run_.force)
            throw IoError(shown, fmt::format("was changed since fusee {} made it: --force replaces it; or move it", made.command));
    }
    /// Is the file of another source? A folder that is its own source accepts all, and belongs to all.
    [[nodiscard]] bool is_foreign(const MadeFile& made) const {
        return made.source != source_ && made.source != kItself && source_ != kItself;
    }
    /// A source as a user names it.
    [[nodiscard]] std::string named(const std::string& source) const {
        return source.empty() ? "another source" : (target_ / source).lexically_normal().string();
    }

    const fs::path &target_, &place_;
    const OutputRun& run_;
    const std::string& source_;
    Manifest manifest_;
};

/// Every file below a folder, by its relative name.
std::set<std::string> files_below(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory()) names.insert(entry.path().lexically_relative(folder).generic_string());
    return names;
}

/// The steps that move staged files into their places.
class Commit {
public:
    Commit(const fs::path& target, const fs::path& place, const fs::path& staging, const OutputRun& run, const std::string& source)
        : target_(target),
          place_(place),
          staging_(staging),
          stays_(run.stays),
          judge_(target, place, run, source),
          next_(judge_.manifest()) {
        for (const std::string& name : files_below(staging)) plan(name, run, source);
        for (const auto& [name, made] : judge_.manifest()) {
            if (made_.contains(name) || !judge_.is_stale(made)) continue;
            if (judge_.require_removable(name, made))
                stale_.insert(name);
            else
                next_.erase(name);  // now the user's
        }
    }

    /// Writes the manifest first, with old and new files: after a crash it names them all.
    void carry_out() {
        sync_tree(staging_);
        const StopHold hold;  // a stop finds all moves made, or none
        if (interrupted() && !stays_) throw Stopped();
        put_manifest();
        for (const std::string& name : made_) {
            make_folder((place_ / name).parent_path());
            move(staging_ / name, name);
        }
        for (const std::string& name : stale_) remove(name);
        for (auto& [name, made] : next_) made.earlier.clear();
        sync_folders();
        put_manifest();
        sync(place_);
    }

private:
    void plan(const std::string& name, const OutputRun& run, const std::string& source) {
        MadeFile made{run.command, source, sha256_of_file(staging_ / name), {}, judge_.is_sheet(name)};
        made.earlier = judge_.require_replaceable(name, made.sha256);
        next_[name] = std::move(made);
        made_.insert(name);
    }
    void put_manifest() const {
        const fs::path text = staging_ / kManifestName;
        write_file(text, manifest_text(next_));
        sync(text);
        move(text, kManifestName);
        sync(place_);
    }
    void move(const fs::path& from, const std::string& name) const {
        std::error_code error;
        fs::rename(from, place_ / name, error);
        if (error) throw IoError((target_ / name).string(), "cannot be written: " + error.message());
    }
    void remove(const std::string& name) {
        std::error_code error;
        fs::remove(place_ / name, error);
        if (error) throw IoError((target_ / name).string(), "cannot be removed: " + error.message());
        for (fs::path folder = (place_ / name).parent_path(); folder != place_; folder = folder.parent_path())
            if (!fs::remove(folder, error) || error) break;  // not empty
        next_.erase(name);
    }
    void sync_folders() const {
        std::set<fs::path> folders{place_};
        for (const std::string& name : made_) folders.insert((place_ / name).parent_path());
        for (const fs::path& folder : folders) sync(folder);
    }

    const fs::path &target_, &place_, &staging_;
    bool stays_;
    Judge judge_;
    Manifest next_;
    std::set<std::string> made_, stale_;
};

}  // namespace

struct OutputFolder::Staged {
    explicit Staged(const fs::path& place) : target(place), folder(place, kStagingPrefix) {}
    NewFolder target;
    TemporaryFolder folder;  // destroyed first
};

OutputFolder::OutputFolder(fs::path target, OutputRun run)
    : target_(std::move(target)), place_(place_of(target_)), run_(std::move(run)), source_(relative_source(run_.source, place_)) {
    std::error_code ignored;
    if (fs::exists(place_, ignored) && !fs::is_directory(place_, ignored)) throw IoError(target_.string(), "is a file, not a folder");
    remove_left_behind(place_, kStagingPrefix);
    const Judge judge(target_, place_, run_, source_);
    for (const std::string& name : run_.files) (void)judge.require_replaceable(name, "");
    for (const std::string& name : run_.sheets) (void)judge.require_replaceable(name, "");
    for (const auto& [name, made] : judge.manifest())
        if (judge.is_stale(made)) (void)judge.require_removable(name, made);
}

OutputFolder::~OutputFolder() = default;
OutputFolder::OutputFolder(OutputFolder&&) noexcept = default;

const fs::path& OutputFolder::path() {
    if (!staged_) staged_ = std::make_unique<Staged>(place_);
    return staged_->folder.path();
}

void OutputFolder::commit() {
    if (interrupted() && !run_.stays) throw Stopped();
    const fs::path& staging = path();
    const Lock lock(place_);
    try {
        Commit(target_, place_, staging, run_, source_).carry_out();
    } catch (const fs::filesystem_error& e) {
        throw IoError(target_.string(), e.what());
    }
    staged_.reset();
}

}  // namespace fusee::core
