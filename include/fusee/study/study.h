#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fusee/profile/profile.h"

/// Many designs from one file: a base profile whose keys vary, or a list of profiles (docs/guides/batch.md).
namespace fusee::study {

/// How the values of the keys are chosen.
enum class Method {
    kGrid,            ///< every combination of the values; the last key changes fastest
    kRandom,          ///< independent uniform values
    kLatinHypercube,  ///< each key takes each of `count` equal intervals once
    kSobol,           ///< Joe and Kuo's low-discrepancy sequence, without its first point
    kCsv,             ///< one row of a table for each design
};

/// What each design leaves on disk.
enum class Outputs {
    kFigures,  ///< its row of the index
    kMeshes,   ///< also STL, SCAD, DXF and PART.json
    kAll,      ///< every file that `fusee make` writes
};
[[nodiscard]] const char* to_string(Outputs outputs);  ///< "figures", "meshes", "all"

/// A key of the base profile that varies, in the key's unit: over a list of values, or over a range.
struct Variation {
    std::string key;                  ///< "cable.diameter_mm"
    std::vector<std::string> values;  ///< as TOML; empty: a range
    double from = 0.0, to = 0.0;      ///< ends of the range, both included
    bool logarithmic = false;         ///< equal steps of the logarithm
    std::size_t steps = 0;            ///< values in a range; 0: continuous, not for a grid
    bool whole = false;               ///< whole numbers only
};

/// A condition between keys, e.g. "k_se.hub.outer_mm > k_se.hub.bore_mm + 4": a design for which it is 0 (false) is left out.
struct Constraint {
    std::string name;
    std::string formula;  ///< keys of numbers in their units, and muParser's operators and functions
};

/// A study as its file states it.
struct Study {
    std::string name;                             ///< of its folder out/NAME
    std::filesystem::path file;                   ///< the study's file; empty: a list of profiles
    std::vector<std::filesystem::path> profiles;  ///< the base profile alone, or the list
    Method method = Method::kGrid;
    std::size_t count = 0;  ///< designs of a random, Latin-hypercube or Sobol study
    std::uint64_t seed = 1;
    Outputs outputs = Outputs::kAll;
    std::vector<double> torques;  ///< co-contractions at which the index has the dead-band [Nm]; empty: least, peak and overdrive torque
    std::vector<Variation> vary;
    std::vector<Constraint> constraints;
    std::vector<std::vector<std::string>> rows;  ///< of a CSV study: one value for each of `vary`
    std::vector<std::string> row_names;          ///< of a CSV study with a column "name", or of a list of profiles; else empty

    [[nodiscard]] bool varies() const { return !file.empty(); }
};

/// The most designs of one study.
inline constexpr std::size_t kMostDesigns = 10'000'000;

/// Is this TOML file a study, that is, has it a table [study]? @throws core::IoError if it cannot be read or is not TOML
[[nodiscard]] bool is_study(const std::filesystem::path& file);
/// @throws core::IoError; core::InvalidInput(s) naming file, line and key
[[nodiscard]] Study read_study(const std::filesystem::path& file);
/// A list of profiles; the names of the files are those of the designs. @throws core::InvalidInput if it is empty or two names are equal
[[nodiscard]] Study study_of(std::vector<std::filesystem::path> profiles, std::string name);

/// One design of a study before it is made.
struct Planned {
    std::size_t index = 0;
    std::string name;                 ///< of the design and its folder, e.g. "pnrvsa-diameter_mm-0.8"
    std::vector<std::string> values;  ///< of the keys that vary, as TOML, in the order of Study::vary
    std::string excluded_by;          ///< the constraint that excludes it; empty: none
};

/// The designs of a study, each computed from its index alone, so that a million of them take no memory. Immutable; thread-safe.
class Plan {
public:
    /// @throws core::IoError; core::InvalidInput naming the study's key: one that the base profile does not have, a constraint that is no
    /// formula
    explicit Plan(Study study);
    ~Plan();

    [[nodiscard]] const Study& study() const;
    [[nodiscard]] std::size_t size() const;
    /// Is any of its profiles of kind "joint", of kind "spring"? One that cannot be read counts as a joint.
    [[nodiscard]] bool has_joints() const;
    [[nodiscard]] bool has_springs() const;
    /// @pre index < size()
    [[nodiscard]] Planned at(std::size_t index) const;
    /// SHA-256 of all that the study's files say of the design: the profile, the CSV files that it names, the keys that vary with their
    /// values. @throws as profile()
    [[nodiscard]] std::string digest(const Planned& planned) const;
    /// The design's profile: the base with its values, or the file of the list. @throws as profile::read_profile; a mistake in a value that
    /// varies names the study's key
    [[nodiscard]] profile::Profile profile(const Planned& planned) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fusee::study
