#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fusee/plant/case_files.h"

/// A blind benchmark: cases from the plant with a sealed label file (docs/theory/plant.md).
namespace fusee::blind {

/// An effect built into a case.
struct LabelEffect {
    std::string id, side;                               ///< as in the case format; "outside.NAME" for effects outside its table
    double size = 0.0;                                  ///< in the format's unit
    std::vector<std::pair<std::string, double>> extra;  ///< further parameters, by name
    [[nodiscard]] bool operator==(const LabelEffect&) const = default;
};
struct Label {
    std::string case_name;              ///< of its folder, "case007"
    std::vector<LabelEffect> effects;   ///< none: a rig within its tolerances
    bool in_library = true;             ///< false: "unknown" is the right answer
    std::string doubt = {};             ///< why an answer may well be wrong: "three effects", "linear springs"; "": an ordinary case
    plant::Conditions conditions = {};  ///< usual ones but of a doubtful case
    [[nodiscard]] bool operator==(const Label&) const = default;
};

/// Shares of the cases; the rest up to 1 are rigs with one effect, evenly over the ids of the format.
struct Mix {
    double none = 0.15, two = 0.15, outside = 0.15;
};
/// Source of the measurements.
enum class Maker {
    kPlant,   ///< the rig that the model does not know
    kModel,   ///< the model with noise: upper limit of a diagnosis. It has no effects from outside
    kMujoco,  ///< the same rig, moved by MuJoCo with its friction: by the program fusee-mujoco-plant
    kSiconos  ///< the same rig, moved by Siconos with set-valued friction: by the program fusee-siconos-plant
};
/// Names of the makers, in their order: "plant", "model", "mujoco", "siconos".
[[nodiscard]] const std::vector<std::string>& maker_names();
[[nodiscard]] inline const std::string& to_string(Maker maker) { return maker_names()[static_cast<std::size_t>(maker)]; }
/// The effects from outside.
enum class Family {
    kUsual,      ///< each has the equation of a generic term of the diagnosis
    kFormBlind,  ///< no effect and no term of the diagnosis has the equation of any
    kEngine,     ///< kUsual, and those that only the rig of another engine has
    kDoubtful    ///< each case is one that a reader would doubt: draw_labels takes doubts() in turn, instead of the mix
};
/// Three and four effects, sides with sizes of their own, figures that case.toml states wrongly, noise that it does not state (with an
/// effect and without), two experiments of six, linear springs.
[[nodiscard]] std::vector<std::string> doubts();
inline constexpr Mix kOutsideOnly{0.0, 0.0, 1.0};
struct BenchmarkOptions {
    std::uint64_t seed = 1;
    std::size_t cases = 20;
    std::filesystem::path out;  ///< receives the benchmark, whole or not at all
    bool force = false;         ///< as in core::OutputRun
    unsigned jobs = 0;          ///< threads, 0: as many as cores; the bytes do not depend on it
    Mix mix;
    Maker maker = Maker::kPlant;  ///< kModel: one effect instead of those from outside
    Family family = Family::kUsual;
    /// Called first with done = 0 and "seal sha256:HASH" before any case is written, then after each finished case, never concurrently.
    /// May throw to stop: then nothing is written.
    std::function<void(std::size_t done, std::size_t of, const std::string& what)> progress;
};

/// The labels of all cases: kinds by the shares of the mix; order, sides and sizes from the seed. @throws core::InvalidInput
[[nodiscard]] std::vector<Label> draw_labels(std::uint64_t seed, std::size_t cases, const Mix& mix = {}, Family family = Family::kUsual);

/// Writes labels.sealed and seal.txt, then case000, case001, ... without any hint at their label.
/// @return the seal: the SHA-256 of labels.sealed, in hexadecimal
/// @throws core::InvalidInput "cases", "mix...", "out", "family" (the model has no outside effects) or "plant" (its program is not
/// installed, or failed), core::IoError
std::string make_benchmark(const BenchmarkOptions& options);

/// The bytes of labels.sealed: salted JSON in base64 against accidental reading; the seal proves that
/// it is unchanged.
[[nodiscard]] std::string seal_labels(const std::vector<Label>& labels, std::uint64_t seed);
/// The bytes of labels.sealed, checked against this seal and seal.txt; nothing is decoded.
/// @throws as open_seal
[[nodiscard]] std::string check_seal(const std::filesystem::path& folder, const std::string& hash);
/// The labels of `folder`, checked against this seal and seal.txt.
/// @param hash as make_benchmark returned it, with or without "sha256:"
/// @throws core::InvalidInput "seal" if it is broken, core::IoError
[[nodiscard]] std::vector<Label> open_seal(const std::filesystem::path& folder, const std::string& hash);

}  // namespace fusee::blind
