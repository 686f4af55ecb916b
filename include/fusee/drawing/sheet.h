#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// Workshop drawings: the content of a sheet of paper (docs/drawing.md).
namespace fusee::drawing {

using Point = std::array<double, 2>;  ///< [mm] from the sheet's upper left corner, y downwards
using Line = std::vector<Point>;

/// Widths and dashes of ISO 128-2: 0.5 mm for visible edges, 0.25 mm for the rest.
enum class Pen { kOutline, kThin, kHidden, kCentre, kCut };

struct Stroke {
    Pen pen = Pen::kThin;
    Line line;
    bool closed = false;
    const char* role = "";  ///< what it belongs to, as a second class in the SVG: "datum", "isometric"
};

/// A filled arrowhead, 2.5 mm long.
struct Arrow {
    Point tip{};
    double towards = 0.0;  ///< direction in which it points [rad], y downwards
};

enum class Align { kLeft, kMiddle, kRight };

/// One line of text in a monospaced font, so that its width is known for any font of the reader's machine.
struct Text {
    std::string words;
    Point at{};  ///< start, middle or end of its baseline
    Align align = Align::kLeft;
    double size = kBody;   ///< font size [mm]; the height of capitals is 0.73 of it
    bool upright = false;  ///< read from below to above

    static constexpr double kBody = 3.4, kSmall = 3.0, kTitle = 4.8;  // capitals of 2.5, 2.2 and 3.5 mm
};

/// Upright rectangle on the sheet.
struct Box {
    Point low{}, high{};
    [[nodiscard]] bool overlaps(const Box& other) const;
    [[nodiscard]] bool holds(const Box& other) const;
    /// Does the straight line from a to b cross it?
    [[nodiscard]] bool meets(const Point& a, const Point& b) const;
};
/// Space of a text, from the foot of a "g" to the top of a capital.
[[nodiscard]] Box box_of(const Text& text);
/// Width of a text [mm]: 0.602 of its size per letter, the widest of the usual monospaced fonts.
[[nodiscard]] double width_of(const std::string& words, double size);

/// One sheet, A3 across.
struct Sheet {
    static constexpr double kWidth = 420.0, kHeight = 297.0;
    static constexpr Box kFrame{{20.0, 10.0}, {410.0, 287.0}};  ///< ISO 5457: 20 mm at the left for filing

    std::string title;
    std::vector<Stroke> strokes = {};
    std::vector<Arrow> arrows = {};
    std::vector<Text> texts = {};

    /// True if the box contains neither text nor line.
    [[nodiscard]] bool clear(const Box& box) const;
    /// Writes the first candidate in a clear place, otherwise the last one.
    void write_clear(const std::vector<Text>& candidates);
};

/// One sheet as SVG 1.1: its unit is the millimetre, and texts are text elements. Equal sheets give equal bytes.
[[nodiscard]] std::string svg(const Sheet& sheet);

// By cairo, with Pango's letters or librsvg's. Texts use the fonts of the machine: equal input gives equal bytes on machines with the same
// libraries and fonts. Thread-safe.

/// Draws an SVG on white. @param longest_px width or height, whichever is larger @throws IoError naming `name`
[[nodiscard]] std::string png_of_svg(const std::string& svg, const std::string& name, int longest_px);

/// Every sheet as a page of one PDF without a date. @throws IoError naming the first one's title
[[nodiscard]] std::string pdf(const std::vector<Sheet>& sheets);

/// `base`.svg with the first sheet, `base`_2.svg with the second and so on. @returns the files written @throws IoError
std::vector<std::filesystem::path> write_svg(const std::filesystem::path& base, const std::vector<Sheet>& sheets);

/// Fields of a title block (ISO 7200) that only the owner of a drawing knows; empty: not stated.
struct TitleOptions {
    std::string owner;        ///< legal owner
    std::string number;       ///< identification number of the design; a part's has its name behind it
    std::string revision;     ///< index
    std::string date;         ///< of issue
    std::string created_by;   ///< creator
    std::string approved_by;  ///< approval person
};

}  // namespace fusee::drawing
