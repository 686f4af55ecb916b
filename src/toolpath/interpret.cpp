#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/lists.h"
#include "fusee/core/process.h"
#include "fusee/core/units.h"
#include "words.h"

namespace fusee::toolpath {

namespace {

constexpr const char* kInterpreter = "rs274";
constexpr std::chrono::seconds kTimeout{120};
constexpr const char* kEnd = "PROGRAM_END()";      // a full disk would end the rows before it
constexpr std::size_t kLongest = 500'000'000;      // bytes of canonical commands
constexpr const char* kTop = "5220 1\n5223 -4\n";  // parameters of G54: its zero is 4 inches (101.6 mm) below the machine's top, G53 Z0
constexpr double kChord_mm = 5e-5;                 // of an arc's chords: the interpreter prints to 1e-4 mm

/// Reads canonical commands one row at a time.
class Parser {
public:
    explicit Parser(const std::string& file) { program_.file = file; }

    void take(std::string_view row) {
        const std::size_t number = std::min(row.find_first_not_of(' '), row.size());
        std::from_chars(row.data() + number, row.data() + row.size(), row_);  // unchanged if it is not a number
        const std::size_t open = row.find('('), close = row.rfind(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return;
        const std::size_t space = row.rfind(' ', open);
        const std::string_view name = row.substr(space + 1, open - space - 1), inside = row.substr(open + 1, close - open - 1);
        if (name == "COMMENT" && inside.size() >= 2)
            program_.notes.push_back({program_.moves.size(), std::string(inside.substr(1, inside.size() - 2))});
        else if (name == "STRAIGHT_TRAVERSE" || name == "STRAIGHT_FEED")
            straight(name == "STRAIGHT_TRAVERSE", numbers(inside, 4));
        else if (name == "ARC_FEED")
            arc(numbers(inside, 7));
        else if (name == "SET_FEED_RATE")
            feed_ = numbers(inside, 1)[0];
        else if ((name == "USE_LENGTH_UNITS" && inside != "CANON_UNITS_MM") || (name == "SELECT_PLANE" && inside != "CANON_PLANE_XY"))
            throw core::IoError(program_.file, fmt::format("row {}: {} is not understood here", row_, row));
    }
    [[nodiscard]] Interpreted done() && { return std::move(program_); }

private:
    [[nodiscard]] std::vector<double> numbers(std::string_view inside, std::size_t least) const {
        std::vector<double> values;
        for (std::size_t at = 0; at <= inside.size();) {
            const std::size_t end = std::min(inside.find(',', at), inside.size());
            std::string_view word = inside.substr(at, end - at);
            word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
            double value = 0.0;
            if (std::from_chars(word.data(), word.data() + word.size(), value).ec == std::errc()) values.push_back(value);
            at = end + 1;
        }
        if (values.size() < least) throw core::IoError(program_.file, fmt::format("row {}: too few numbers in ({})", row_, inside));
        return values;
    }

    void go(bool rapid, const Pose& to) {
        program_.moves.push_back({rapid, program_.moves.empty() ? to : here_, to, feed_, row_});
        here_ = to;
    }

    void straight(bool rapid, const std::vector<double>& v) { go(rapid, {v[0], v[1], v[2], v[3]}); }

    /// End x, y, centre x, y, turns (above 0: counter-clockwise), end z, a.
    void arc(const std::vector<double>& v) {
        const double radius = std::hypot(here_.x - v[2], here_.y - v[3]), turns = v[4];
        const double begin = std::atan2(here_.y - v[3], here_.x - v[2]);
        double sweep = std::atan2(v[1] - v[3], v[0] - v[2]) - begin;
        const double turn = 2.0 * core::kPi, sense = turns > 0.0 ? 1.0 : -1.0;
        while (sense * sweep <= 1e-9) sweep += sense * turn;  // an end at the start is a whole turn
        sweep += sense * turn * (std::abs(turns) - 1.0);
        const double step = 2.0 * std::sqrt(2.0 * kChord_mm / std::max(radius, 1e-3));
        const int whole =
            std::max(1, static_cast<int>(std::abs(turns)));  // every turn has the same chords, so that equal turns are recognised
        const int count = whole * std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step / whole)));
        const Pose start = here_;
        for (int i = 1; i <= count; ++i) {
            const double s = static_cast<double>(i) / count, angle = begin + s * sweep;
            const Pose on{v[2] + radius * std::cos(angle), v[3] + radius * std::sin(angle), start.z + s * (v[5] - start.z),
                          start.a + s * (v[6] - start.a)};
            go(false, i < count ? on : Pose{v[0], v[1], v[5], v[6]});
        }
    }

    Interpreted program_;
    Pose here_;
    double feed_ = 0.0;
    std::size_t row_ = 0;
};

constexpr double kProbe_mm = 0.1;   // step along a rapid: a thicker stock is never missed
constexpr double kTouch_mm = 1e-4;  // the last printed digit of the interpreter: a rapid may run along the top

struct Stock {
    bool round = false;
    double x_low = 0.0, x_high = 0.0, y_low = 0.0, y_high = 0.0, z_low = 0.0, z_high = 0.0, radius = 0.0;
    /// Is the cutter's tip inside its outline and below its top? Also below the stock: a rapid could only get there through it.
    [[nodiscard]] bool holds(const Pose& p) const {
        if (p.x < x_low || p.x > x_high) return false;
        if (round) return std::abs(p.y) < radius && p.z < std::sqrt(radius * radius - p.y * p.y) - kTouch_mm;
        return p.y > y_low && p.y < y_high && p.z < z_high - kTouch_mm;
    }
};

std::optional<Stock> stock_of(const Interpreted& program) {
    const auto number = [&](const std::vector<std::string>& words, std::size_t i) { return number_in(program, words, i); };
    if (const auto box = find_words(program, "stock", 8); !box.empty() && box[1] == "box")
        return Stock{false, number(box, 2), number(box, 3), number(box, 4), number(box, 5), number(box, 6), number(box, 7), 0.0};
    if (const auto round = find_words(program, "stock", 5); !round.empty() && round[1] == "round")
        return Stock{true, number(round, 3), number(round, 4), 0.0, 0.0, 0.0, 0.0, number(round, 2)};
    return std::nullopt;
}

bool passes_through(const Stock& stock, const Move& move) {
    const double way = std::hypot(move.to.x - move.from.x, move.to.y - move.from.y, move.to.z - move.from.z);
    const int probes = 1 + static_cast<int>(way / kProbe_mm);
    for (int i = 0; i <= probes; ++i)
        if (stock.holds(between(move.from, move.to, static_cast<double>(i) / probes))) return true;
    return false;
}

}  // namespace

bool can_interpret() { return core::on_path(kInterpreter); }

Interpreted parse_canonical(const std::string& output, const std::string& file) {
    Parser parser(file);
    for (const std::string_view line : core::pieces_of(output, "\n")) parser.take(line);
    return std::move(parser).done();
}

Interpreted interpret(const std::filesystem::path& program) {
    const std::string file = program.string();
    // A separate home folder: rs274 maps the file ~/.tool.mmap and truncates it at its start, so that two processes at a time would end
    // each other. Its output goes to a file: into a pipe it would write row by row.
    const core::TemporaryFolder home;
    const std::filesystem::path rows = home.path() / "canonical";
    const std::filesystem::path table = home.path() / "tool.tbl";  // lengths of 0: G43 asks for a table
    std::string tools;
    for (int number = 1; number <= 9; ++number) tools += fmt::format("T{0} P{0} Z0 D1\n", number);
    core::write_file(table, tools);
    const std::filesystem::path parameters = home.path() / "parameters.txt";
    core::write_file(parameters, kTop);
    const core::ProcessResult result =
        core::run_process({"env", "HOME=" + home.path().string(), kInterpreter, "-g", "-t", table.string(), "-v", parameters.string(),
                           std::filesystem::absolute(program).string(), rows.string()},
                          file, kTimeout);
    if (!result.in_time) throw core::IoError(file, fmt::format("{} was still running after {} s", kInterpreter, kTimeout.count()));
    if (result.code != 0)
        throw core::IoError(file, fmt::format("{} ended with {}: {}", kInterpreter, result.code, core::last_words(result.output)));
    const std::string output = core::read_file(rows, kLongest);
    if (output.find(kEnd) == std::string::npos)
        throw core::IoError(file,
                            fmt::format("{} does not reach the end of the program: {}", kInterpreter, core::last_words(result.output)));
    return parse_canonical(output, file);
}

std::vector<std::string> faults(const Interpreted& program) {
    std::vector<std::string> found;
    const auto stock = stock_of(program);
    if (!stock) found.emplace_back("no comment states the stock");
    if (program.moves.empty()) found.emplace_back("nothing moves");
    for (const Move& move : program.moves) {
        if (!move.rapid && !(move.feed > 0.0)) found.push_back(fmt::format("row {}: a feed of {} mm/min", move.row, move.feed));
        if (move.rapid && stock && passes_through(*stock, move))
            found.push_back(fmt::format("row {}: a rapid to X{:.3f} Y{:.3f} Z{:.3f} passes through the stock", move.row, move.to.x,
                                        move.to.y, move.to.z));
    }
    return found;
}

}  // namespace fusee::toolpath
