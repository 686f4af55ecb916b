#pragma once
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

/// Every reader of a file that somebody else may have made, behind one signature: for the fuzzers and for the replay of what they found.
namespace fusee::fuzz {

struct Reader {
    const char* name;  ///< of the harness fuzz_NAME and of the folder of its reproducers
    /// Reads the bytes as a file. A refusal (core::InputError) is a good end; anything else that is thrown is a finding.
    void (*read)(std::string_view bytes);
    const char* shipped;  ///< shipped files to start from, relative to the sources: one name, or "FOLDER/*.ENDING"; "": none
    bool third_party;  ///< a library reads it: fusee reads such a file in a process of its own (docs/decisions/0006)
};

[[nodiscard]] std::span<const Reader> readers();
/// nullptr if there is none.
[[nodiscard]] const Reader* reader(std::string_view name);
/// The files to start from: the shipped ones, and those of tests/fuzz/seeds/NAME.
[[nodiscard]] std::vector<std::filesystem::path> seeds(const Reader& reader);
/// Runs a reader; a refusal is swallowed. @returns whether the bytes were accepted
bool accepts(const Reader& reader, std::string_view bytes);

}  // namespace fusee::fuzz
