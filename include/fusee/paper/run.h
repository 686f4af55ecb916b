#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "fusee/core/finding.h"
#include "fusee/core/progress.h"

namespace fusee::paper {

struct Options {
    std::filesystem::path profiles = "profiles";  ///< holds first_prototype.toml, pnrvsa.toml, paper/, relatives/ and examples/
    std::filesystem::path out = "out";            ///< the result lands in out/paper, complete or not at all
    unsigned jobs = 0;                            ///< threads of figure 9's search; 0 = one for each processor; no influence on the result
    bool force = false;                           ///< where files are written: as core::OutputRun has it
    std::function<void(const std::string& piece)> note = {};  ///< told of each finished piece, kPieces times; may be empty
    std::function<bool()> stop = core::interrupted;           ///< asked before each piece
};
inline constexpr std::size_t kPieces = 7;

struct Result {
    bool made = false;
    bool interrupted = false;
    std::filesystem::path folder;  ///< empty when nothing was written
    core::Findings findings;       ///< not made: which law cannot be, and why
    std::string summary;           ///< for a terminal
};

/// Makes every table and figure of the paper anew: out/paper with paper.html, paper.json and a CSV file for each (docs/guides/paper.md).
/// @throws core::InvalidInput, core::IoError
[[nodiscard]] Result run(const Options& options = {});

}  // namespace fusee::paper
