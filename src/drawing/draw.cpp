#include <fmt/format.h>

#include "body.h"
#include "development.h"
#include "fusee/drawing/drawing.h"
#include "groove_view.h"
#include "marks.h"
#include "table.h"
#include "title.h"
#include "words.h"

namespace fusee::drawing {

namespace {

constexpr double kTableTop = 13.0, kTableGap = 5.0;
constexpr double kTableBottom = kTitleCorner[1] - 3.0;
constexpr double kTablesTo = 408.0;
constexpr Box kBodyRoom{{23.0, 13.0}, {290.0, 202.0}};
constexpr Box kGrooveRoom{{24.0, 208.0}, {112.0, 285.0}};
constexpr Box kIsometricRoom{{298.0, 13.0}, {406.0, 112.0}};
constexpr Box kNotesRoom{{116.0, 206.0}, {227.0, 286.0}};
constexpr double kCheckNotesTop = 150.0, kCheckNotesBottom = 220.0;  // under tables of 25 rows
constexpr Box kDevelopmentRoom{{24.0, 184.0}, {226.0, 286.0}};
constexpr Box kTolerancesRoom{{296.0, 116.0}, {408.0, 219.0}};

/// Divides a sentence into lines of at most `letters`.
std::vector<std::string> wrapped(const std::string& sentence, std::size_t letters) {
    std::vector<std::string> lines{""};
    for (std::size_t from = 0; from < sentence.size();) {
        const std::size_t space = std::min(sentence.find(' ', from), sentence.size());
        const std::string word = sentence.substr(from, space - from);
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > letters) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
        from = space + 1;
    }
    return lines;
}

}  // namespace

void write_notes(Sheet& sheet, const std::vector<std::string>& notes, const Box& area) {
    const double width = area.high[0] - area.low[0], size = Text::kSmall;
    const auto letters = static_cast<std::size_t>(width / width_of("n", size));
    double y = area.low[1];
    for (const std::string& note : notes) {
        for (const std::string& line : wrapped(note, letters)) sheet.texts.push_back({line, {area.low[0], y += 3.7}, Align::kLeft, size});
        y += 1.0;
    }
}

namespace {

/// Writes tables column by column, on a new sheet where the last one is full.
class Flow {
public:
    explicit Flow(std::vector<Sheet>& sheets) : sheets_(sheets) {}

    void write(const Table& table) {
        for (std::size_t next = 0; next < table.rows.size();) {
            if (x_ + table.width() > kTablesTo) {
                sheets_.push_back({sheets_.front().title});
                x_ = Sheet::kFrame.low[0] + kTableGap;
            }
            next = write_table(sheets_.back(), table, next, {x_, kTableTop}, kTableBottom);
            x_ += table.width() + kTableGap;
        }
    }

private:
    std::vector<Sheet>& sheets_;
    double x_ = kTablesTo;  // the first sheet holds no table
};

}  // namespace

std::vector<Sheet> draw(const Subject& subject) {
    const solid::Part& part = subject.part;
    std::vector<Sheet> sheets{{fmt::format("{} {}", subject.design, subject.name)}};
    const double scale = draw_body(sheets.front(), subject, kBodyRoom);
    draw_groove(sheets.front(), subject, kGrooveRoom);
    draw_isometric(sheets.front(), subject, kIsometricRoom);
    write_notes(sheets.front(), notes(subject), kNotesRoom);
    write_notes(sheets.front(), tolerance_notes(subject), kTolerancesRoom);
    draw_general_marks(sheets.front(), subject);
    const Table checks = check_table(part), torques = torque_table(part.cam);
    Flow tables(sheets);
    for (const Table& table : {checks, torques, inspection_table(part)}) tables.write(table);
    const double left = Sheet::kFrame.low[0] + kTableGap;
    write_notes(sheets[1], check_notes(part),
                {{left, kCheckNotesTop}, {left + checks.width() + kTableGap + torques.width(), kCheckNotesBottom}});
    draw_development(sheets[1], part, kDevelopmentRoom);
    for (std::size_t i = 0; i < sheets.size(); ++i) draw_title(sheets[i], subject, title_of(subject), scale, i + 1, sheets.size());
    return sheets;
}

}  // namespace fusee::drawing
