#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// A mill that is simulated from the words of its G-code. Nothing here knows how programs are made, nor LinuxCNC's interpreter.
namespace fusee::millsim {

/// Position of the cutter's tip, radius compensation included: X, Y, Z [mm] and A [deg].
struct Pose {
    double x = 0.0, y = 0.0, z = 0.0, a = 0.0;
};

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

struct Program {
    std::string name;
    std::vector<Move> moves;
    std::vector<Comment> comments;
};

/// Interprets G0 G1 G2 G3 (X Y Z A I J P), G40 and G41.1 D, G93 G94, T, F, named parameters and expressions in brackets; words that set
/// no path (G17 G21 G43 H, G64, S, M) are read over. Tangent joints are assumed under compensation.
/// @throws IoError naming program and line: a word that is not understood, inches, a feed of 0, a number above 1e12, an arc of more than
/// 100 turns, more than 4,000,000 moves
[[nodiscard]] Program read_program(const std::string& text, const std::string& name);

}  // namespace fusee::millsim
