#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// A benchmark whose answers nobody has seen: cases from the plant with a sealed label file (docs/theory/plant.md).
namespace fusee::blind {

/// An effect that was built into a case.
struct LabelEffect {
    std::string id, side;                               ///< as in the case format; "outside.NAME" for what no table holds
    double size = 0.0;                                  ///< in the format's unit
    std::vector<std::pair<std::string, double>> extra;  ///< further parameters, by name
    [[nodiscard]] bool operator==(const LabelEffect&) const = default;
};
struct Label {
    std::string case_name;             ///< of its folder, "case007"
    std::vector<LabelEffect> effects;  ///< none: a rig inside its tolerances
    bool in_library = true;            ///< false: "unknown" is the right answer
    [[nodiscard]] bool operator==(const Label&) const = default;
};

/// Shares of the cases; what is left to 1 are rigs with one effect, evenly over the format's ids.
struct Mix {
    double none = 0.15, two = 0.15, outside = 0.15;
};
/// Who makes the measurements.
enum class Maker {
    kPlant,  ///< the rig that the model does not know
    kModel,  ///< the model itself, with noise: what a diagnosis could be worth at best. It knows no effect from outside
};
struct BenchmarkOptions {
    std::uint64_t seed = 1;
    std::size_t cases = 20;
    std::filesystem::path out;  ///< gets the benchmark, whole or not at all
    bool force = false;         ///< as core::OutputRun has it
    unsigned jobs = 0;          ///< threads, 0: as many as cores; the bytes are the same for any
    Mix mix;
    Maker maker = Maker::kPlant;  ///< kModel: one effect in place of those from outside
    /// Told first, with done = 0, "seal sha256:HASH", before any case is written; then each case as it is finished. Calls do not overlap.
    /// May throw to stop: then nothing is written.
    std::function<void(std::size_t done, std::size_t of, const std::string& what)> progress;
};

/// What is built into each case: kinds by the mix's shares, order, sides and sizes from the seed. @throws core::InvalidInput
[[nodiscard]] std::vector<Label> draw_labels(std::uint64_t seed, std::size_t cases, const Mix& mix = {});

/// Writes labels.sealed and seal.txt, then case000, case001, ... with nothing in them that tells their label.
/// @return the seal: the SHA-256 of labels.sealed, in hexadecimal
/// @throws core::InvalidInput "cases", "mix..." or "out", core::IoError
std::string make_benchmark(const BenchmarkOptions& options);

/// The bytes of labels.sealed: salted JSON in base64, so that no one reads it by accident; anyone can on purpose, and the seal shows that
/// nobody changed it.
[[nodiscard]] std::string seal_labels(const std::vector<Label>& labels, std::uint64_t seed);
/// The bytes of labels.sealed, found to have this seal and seal.txt to name it; nothing is decoded.
/// @throws as open_seal
[[nodiscard]] std::string check_seal(const std::filesystem::path& folder, const std::string& hash);
/// The labels of `folder` after its labels.sealed was found to have this seal, and seal.txt to name it.
/// @param hash as make_benchmark returned it, with or without "sha256:"
/// @throws core::InvalidInput "seal" if it is broken, core::IoError
[[nodiscard]] std::vector<Label> open_seal(const std::filesystem::path& folder, const std::string& hash);

}  // namespace fusee::blind
