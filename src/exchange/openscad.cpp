#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "fusee/core/error.h"
#include "fusee/core/process.h"
#include "fusee/exchange/scad.h"

namespace fusee::exchange {

namespace fs = std::filesystem;

void render_scad(const fs::path& scad, const fs::path& stl, std::chrono::seconds timeout) {
    const std::string about = scad.string();
    const fs::path temporary = stl.parent_path() / fmt::format(".{}.render-{}", stl.filename().string(), ::getpid());
    // openscad takes a file name that begins with a dash for an option.
    const auto name = [](const fs::path& p) { return fs::absolute(p).string(); };
    const core::ProcessResult result =
        core::run_process({"openscad", "--hardwarnings", "--export-format", "binstl", "-o", name(temporary), name(scad)}, about, timeout);
    std::error_code error;
    if (result.in_time && result.code == 0) {
        fs::rename(temporary, stl, error);
        if (error) throw core::IoError(stl.string(), error.message());
        return;
    }
    fs::remove(temporary, error);
    if (!result.in_time) throw core::IoError(about, fmt::format("openscad was still running after {} s", timeout.count()));
    throw core::IoError(about, fmt::format("openscad ended with {}: {}", result.code, core::last_words(result.output)));
}

}  // namespace fusee::exchange
