#pragma once
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A program as its controller interprets it. Nothing here knows how programs are made, or what a cam is.
namespace fusee::toolpath {

/// Position of the cutter's tip, radius compensation included: X, Y, Z [mm] and A [deg].
struct Pose {
    double x = 0.0, y = 0.0, z = 0.0, a = 0.0;
};

/// A straight move; arcs are chords with a chordal error of at most 5e-5 mm.
struct Move {
    bool rapid = false;
    Pose from, to;
    double feed = 0.0;    ///< [mm/min], as set by the controller; for inverse time: along the path in X, Y, Z, A
    std::size_t row = 0;  ///< of the interpreter's output, from 1
};

/// A comment and the index of the next move.
struct Note {
    std::size_t before = 0;
    std::string text;
};

struct Interpreted {
    std::string file;
    std::vector<Move> moves;  ///< the first starts at its end: the position before it is unknown
    std::vector<Note> notes;
};

/// True if programs can be interpreted here: LinuxCNC's `rs274` is on PATH.
[[nodiscard]] bool can_interpret();

/// Runs `rs274 -g` on the program and reads the canonical commands that it prints.
/// @throws IoError naming the file: rs274 cannot be started or refuses the program (with its message), or units other than mm
[[nodiscard]] Interpreted interpret(const std::filesystem::path& program);
/// Canonical commands as text, as rs274 prints them. @throws IoError naming `file` and the row
[[nodiscard]] Interpreted parse_canonical(const std::string& output, const std::string& file);

/// Errors of the moves, each with its row: a rapid inside the stock, a feed that is not above 0, no stated stock.
[[nodiscard]] std::vector<std::string> faults(const Interpreted& program);

/// The groove's floor that a program leaves: the stock without the space that the cutter's end sweeps in its feed moves.
class CutFloor {
public:
    /// Distance from the axis to the end of the first material that a horizontal ray meets, beyond a bore; empty where nothing is cut.
    /// @param azimuth in the part's body frame [rad] @param z_mm height there; half plates are cut in the plane z = 0 only
    [[nodiscard]] std::optional<double> radius(double azimuth, double z_mm) const;
    [[nodiscard]] const std::string& name() const { return name_; }  ///< "lower", "upper", "wrap"

private:
    friend std::vector<CutFloor> cut_floors(const Interpreted& program);
    class Swept;
    CutFloor(std::string name, std::shared_ptr<const Swept> swept) : name_(std::move(name)), swept_(std::move(swept)) {}
    std::string name_;
    std::shared_ptr<const Swept> swept_;
};

/// All groove floors that the program cuts, by the words of its comments; none for a blank or a boss.
/// @throws IoError naming the file if its comments do not state the cuts and the cutter
[[nodiscard]] std::vector<CutFloor> cut_floors(const Interpreted& program);

}  // namespace fusee::toolpath
