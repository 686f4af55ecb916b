#include "fusee/pipeline/verify.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

/// A folder of this process that is gone when it is no longer needed.
class PassingFolder {
public:
    PassingFolder() {
        static std::atomic<int> count = 0;
        path_ = fs::temp_directory_path() / fmt::format("fusee-{}-{}", ::getpid(), count++);
    }
    ~PassingFolder() {
        std::error_code ignored;  // what is left in a temporary folder is no failure
        fs::remove_all(path_, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

}  // namespace

MakeResult make_to_verify(const profile::Profile& profile) {
    const PassingFolder folder;
    MakeResult result = make(profile, {.out = folder.path()});
    result.folder.clear();
    return result;
}

}  // namespace fusee::pipeline
