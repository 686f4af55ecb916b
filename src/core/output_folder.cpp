#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "manifest.h"

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

/// A file that is a link keeps its name: it is the same source wherever it leads, as a profile in a Kubernetes volume does.
std::string relative_source(const fs::path& source, const fs::path& place) {
    std::error_code ignored;
    if (source.empty()) return "";
    const bool link = fs::is_symlink(source, ignored) && fs::is_regular_file(source, ignored);
    const fs::path found = link ? place_of(fs::absolute(source).parent_path()) / source.filename() : place_of(source);
    return found.lexically_relative(place).generic_string();
}

/// The first entry that is not a scratch file of fusee; empty if there is none.
std::string first_entry(const OpenFolder& folder) {
    for (const std::string& name : folder.names())
        if (!is_temporary_name(name, kStagingPrefix)) return name;
    return "";
}

/// Lets one run at a time into a folder.
class Lock {
public:
    explicit Lock(const OpenFolder& folder) : folder_(folder.reading()) {
        while (::flock(folder_.get(), LOCK_EX) != 0 && errno == EINTR) {
        }
    }

private:
    Descriptor folder_;
};

/// The present file of a name.
struct Standing {
    bool there = false, regular = false;
    std::string hash;  ///< of a regular file
};

/// @throws IoError if a part of the path is a link or a file: the file would be written elsewhere
Standing standing(const OpenFolder* place, const fs::path& name) {
    const auto folder = place != nullptr ? place->find_inside(name.parent_path()) : std::nullopt;
    if (!folder) return {};
    const std::string leaf = name.filename().string();
    const OpenFolder::Kind kind = folder->kind(leaf);
    Standing found{kind != OpenFolder::Kind::kNone, kind == OpenFolder::Kind::kFile, {}};
    if (found.regular) found.hash = folder->sha256(leaf);
    return found;
}

/// Decides what a run may do to the files of a folder.
class Judge {
public:
    /// @param place nullptr: it does not exist
    Judge(const fs::path& target, const OpenFolder* place, const OutputRun& run, const std::string& source)
        : target_(target), place_(place), run_(run), source_(source) {
        if (auto read = place != nullptr ? read_manifest(*place) : std::nullopt) {
            manifest_ = std::move(*read);
        } else if (place != nullptr && !run.among_others) {
            require_empty();
        }
        require_owner();
    }

    [[nodiscard]] const Manifest& manifest() const { return manifest_; }

    /// @param hash of the bytes that will be written; empty if not known yet @returns the hash of the present file; empty: none
    [[nodiscard]] std::string require_replaceable(const std::string& name, const std::string& hash) const {
        const std::string shown = (target_ / name).string();
        const Standing found = standing(place_, name);
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
        const Standing found = standing(place_, name);
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
        if (const std::string entry = first_entry(*place_); !entry.empty())
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

    const fs::path& target_;
    const OpenFolder* place_;
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
    Commit(const fs::path& target, const OpenFolder& place, const fs::path& staging, const OutputRun& run, const std::string& source)
        : place_(place),
          staging_path_(staging),
          stays_(run.stays),
          staging_(*place_.find_inside(staging.filename())),
          judge_(target, &place, run, source),
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
        sync_tree(staging_path_);
        const StopHold hold;  // a stop finds all moves made, or none
        if (interrupted() && !stays_) throw Stopped();
        put_manifest();
        for (const std::string& name : made_) move(name, !next_[name].earlier.empty());
        for (const std::string& name : stale_) remove(name);
        for (auto& [name, made] : next_) made.earlier.clear();
        sync_folders();
        put_manifest();
        place_.sync();
    }

private:
    void plan(const std::string& name, const OutputRun& run, const std::string& source) {
        const fs::path path(name);
        const auto folder = staging_.find_inside(path.parent_path());
        MadeFile made{run.command, source, folder ? folder->sha256(path.filename().string()) : "", {}, judge_.is_sheet(name)};
        made.earlier = judge_.require_replaceable(name, made.sha256);
        next_[name] = std::move(made);
        made_.insert(name);
    }
    void put_manifest() {
        write_file(staging_path_ / kManifestName, manifest_text(next_));
        sync(staging_path_ / kManifestName);
        move(kManifestName, true);
        place_.sync();
    }
    void move(const fs::path& name, bool replaces) {
        const auto from = staging_.find_inside(name.parent_path());
        if (!from) throw IoError((place_.shown() / name).string(), "was removed while fusee ran");
        from->move(name.filename().string(), place_.make_inside(name.parent_path()), name.filename().string(), replaces);
    }
    void remove(const fs::path& name) {
        if (const auto folder = place_.find_inside(name.parent_path())) folder->remove(name.filename().string());
        for (fs::path empty = name.parent_path(); !empty.empty(); empty = empty.parent_path()) {
            const auto parent = place_.find_inside(empty.parent_path());
            if (parent && !parent->remove_folder(empty.filename().string())) break;
        }
        next_.erase(name.generic_string());
    }
    void sync_folders() const {
        std::set<fs::path> folders{""};
        for (const std::string& name : made_) folders.insert(fs::path(name).parent_path());
        for (const fs::path& name : folders)
            if (const auto folder = place_.find_inside(name)) folder->sync();
    }

    const OpenFolder& place_;
    const fs::path& staging_path_;
    bool stays_;
    OpenFolder staging_;
    Judge judge_;
    Manifest next_;
    std::set<std::string> made_, stale_;
};

}  // namespace

struct OutputFolder::Staged {
    Staged(const fs::path& place, const fs::path& shown) : target(place, shown), folder(place, kStagingPrefix) { require_same(place); }
    /// @throws IoError if the folder's name leads to another one now
    void require_same(const fs::path& place) const {
        const OpenFolder& mine = target.folder();
        const auto now = OpenFolder::find(place, mine.shown());
        if (!now || !now->is(mine) || mine.kind(folder.path().filename().string()) != OpenFolder::Kind::kFolder)
            throw IoError(mine.shown().string(), "was moved or replaced while fusee ran; nothing was written");
    }
    NewFolder target;
    TemporaryFolder folder;  // destroyed first
};

OutputFolder::OutputFolder(fs::path target, OutputRun run) : OutputFolder(std::move(target), {}, std::move(run)) {}

OutputFolder::OutputFolder(const fs::path& out, const fs::path& below, OutputRun run)
    : target_(below.empty() ? out : out / below),
      place_(below.empty() ? place_of(out) : place_of(out) / below),
      run_(std::move(run)),
      source_(relative_source(run_.source, place_)) {
    require_plain_name(target_);
    for (const std::string& name : run_.files) require_plain_name(target_ / name);
    const std::optional<OpenFolder> place = OpenFolder::find(place_, target_);
    if (place) remove_left_behind(place_, kStagingPrefix);
    const Judge judge(target_, place ? &*place : nullptr, run_, source_);
    for (const std::string& name : run_.files) (void)judge.require_replaceable(name, "");
    for (const std::string& name : run_.sheets) (void)judge.require_replaceable(name, "");
    for (const auto& [name, made] : judge.manifest())
        if (judge.is_stale(made)) (void)judge.require_removable(name, made);
}

OutputFolder::~OutputFolder() = default;
OutputFolder::OutputFolder(OutputFolder&&) noexcept = default;

const fs::path& OutputFolder::path() {
    if (!staged_) staged_ = std::make_unique<Staged>(place_, target_);
    return staged_->folder.path();
}

OpenFolder OutputFolder::open() const { return OpenFolder::make(place_, target_); }
std::optional<OpenFolder> OutputFolder::find() const { return OpenFolder::find(place_, target_); }

void OutputFolder::commit() {
    if (interrupted() && !run_.stays) throw Stopped();
    const fs::path& staging = path();
    const Lock lock(staged_->target.folder());
    staged_->require_same(place_);
    try {
        Commit(target_, staged_->target.folder(), staging, run_, source_).carry_out();
    } catch (const fs::filesystem_error& e) {
        throw IoError(target_.string(), e.what());
    }
    staged_.reset();
}

}  // namespace fusee::core
