#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/toolpath/read_back.h"

/// A mill that is simulated from the words of its G-code. Nothing here knows how programs are made, nor LinuxCNC's interpreter.
namespace fusee::toolpath::mill {

/// A straight move; arcs are chords with a chordal error of at most 2e-3 mm.
struct Move {
    std::size_t line = 0;  ///< of the program, from 1
    bool rapid = false;
    int tool = 0;  ///< in the spindle; 0: none was called
    Pose from, to;
    double minutes = 0.0;
};

/// A comment, split at spaces.
struct Comment {
    std::size_t line = 0;
    std::vector<std::string> words;
};

/// One kind of fault, at the first line where it occurs.
struct Contact {
    std::string rule;  ///< "millsim.rapid", "millsim.clamp": docs/guides/milling.md has all
    std::string what;
    std::size_t line = 0;
    double measured = 0.0;  ///< depth or overlap there [mm]; 1 if the fault has no length
    std::size_t moves = 0;  ///< that have it
};

struct Program {
    std::string name;
    std::vector<Move> moves;
    std::vector<Comment> comments;
    /// That need no stock: "millsim.tool_change", "millsim.approach", "millsim.arc_mode", "millsim.tool_length", "millsim.spindle".
    std::vector<Contact> faults;
};

/// The machine's top, where G53 G0 Z0 leads, above the program's zero [mm]: assumed.
inline constexpr double kMachineTop_mm = 100.0;

/// Interprets G0 G1 G2 G3 (X Y Z A I J P), G53 G0 Z0, G40 and G41.1 D, G43 H and G49, G91.1, G93 G94, T, M3 to M6, F, named parameters and
/// expressions in brackets; words that set no path (G17 G21 G64, S, other M) are read over. Tangent joints are assumed under compensation.
/// After M6 the spindle's X and Y are unknown.
/// @throws IoError naming program and line: a word that is not understood, inches, a feed of 0, a number above 1e12, an arc of more than
/// 100 turns, more than 4,000,000 moves
[[nodiscard]] Program read_program(const std::string& text, const std::string& name);

/// Material as intervals along Z above square cells of X and Y (dexels). On a rotary axis these are the part's body axes; then the
/// machine's X is the body's Z.
class Stock {
public:
    using Interval = std::array<double, 2>;  ///< low, high [mm]
    Stock(double x_low, double x_high, double y_low, double y_high, double cell_mm);
    /// A cell's material, from below.
    [[nodiscard]] const std::vector<Interval>& at(double x, double y) const;
    /// Highest material [mm]; empty: no material.
    [[nodiscard]] std::optional<double> top(double x, double y) const;
    /// Removes an interval. @returns the length removed [mm]
    double remove(std::size_t cell, double low, double high);

    double x_low, y_low, cell;  ///< corner of cell 0 and width of a cell [mm]
    std::size_t columns, rows;
    std::vector<std::vector<Interval>> cells;  ///< row by row
    [[nodiscard]] double x_of(std::size_t i) const { return x_low + (static_cast<double>(i) + 0.5) * cell; }
    [[nodiscard]] double y_of(std::size_t j) const { return y_low + (static_cast<double>(j) + 0.5) * cell; }
    /// The cells whose middles may lie in [low, high] along an axis of `count` cells: first and one past the last.
    [[nodiscard]] std::array<std::size_t, 2> span(double low, double high, double origin, std::size_t count) const;
};

/// The piece nearest to X0 Y0 without the rest of its sheet: material that is not thicker than tabs is filed away.
[[nodiscard]] Stock released(Stock stock, double tab_height_mm);

struct Result {
    Stock stock;
    std::vector<Contact> contacts;  ///< the program's own faults first
    double minutes = 0.0;           ///< with rapids at 3 m/min
};

/// Moves cutter, shank and holder through the stock. Setup from the program's comments (docs/guides/milling.md):
/// "stock box", "stock round", "tool", "clamp box", "clamp round", "held box", "board", "rotary"; what must be there afterwards: "hole",
/// what the blank must bring: "index"; where it then stands: "A: ... A".
/// @param blank of a rotary program: the simulated stock of the blank's program, moved up by `lift_mm` along Z into the body frame
/// @throws IoError naming the program: no stock, or a cut without a described tool
[[nodiscard]] Result simulate(const Program& program, double cell_mm, const Stock* blank = nullptr, double lift_mm = 0.0);

/// Each contact as an error. @param name of the file
[[nodiscard]] core::Findings contact_findings(const Result& result, const std::string& name);

}  // namespace fusee::toolpath::mill
