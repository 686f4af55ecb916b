#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "fusee/core/finding.h"
#include "fusee/core/progress.h"
#include "fusee/paper/paper.h"

namespace fusee::paper {

struct Options {
    std::filesystem::path profiles = "profiles";  ///< holds first_prototype.toml, pnrvsa.toml, paper/, relatives/ and examples/
    unsigned jobs = 0;                            ///< threads of figure 9's search; 0 = one for each processor; no influence on the result
    std::function<void(const std::string& piece)> note = {};  ///< called after each finished piece, kPieces times; may be empty
    std::function<bool()> stop = core::interrupted;           ///< asked before each piece
};
inline constexpr std::size_t kPieces = 7;

struct Result {
    std::optional<Paper> paper;  ///< none: interrupted or refused
    bool interrupted = false;
    core::Findings findings;  ///< refused: which law cannot exist, and why
};

/// Reproduces every table and figure of the paper (docs/guides/paper.md). Writes nothing. @throws core::InvalidInput, core::IoError
[[nodiscard]] Result run(const Options& options = {});

}  // namespace fusee::paper
