#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>

#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/mill.h"

namespace fusee::toolpath::mill {

namespace {

using Parameters = std::map<std::string, double>;

void skip_spaces(std::string_view& text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
}

bool take(std::string_view& text, char c) {
    skip_spaces(text);
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

/// Takes one value from the front of `text`: a number, #<name> or an expression in brackets. @returns false if there is none
bool take_value(std::string_view& text, const Parameters& parameters, double& value);

bool take_product(std::string_view& text, const Parameters& parameters, double& value) {
    if (!take_value(text, parameters, value)) return false;
    for (;;) {
        const bool times = take(text, '*'), over = !times && take(text, '/');
        double next = 0.0;
        if (!times && !over) return true;
        if (!take_value(text, parameters, next)) return false;
        value = times ? value * next : value / next;
    }
}

bool take_sum(std::string_view& text, const Parameters& parameters, double& value) {
    if (!take_product(text, parameters, value)) return false;
    for (;;) {
        const bool plus = take(text, '+'), minus = !plus && take(text, '-');
        double next = 0.0;
        if (!plus && !minus) return true;
        if (!take_product(text, parameters, next)) return false;
        value += plus ? next : -next;
    }
}

bool take_value(std::string_view& text, const Parameters& parameters, double& value) {
    skip_spaces(text);
    if (text.starts_with("-[") || text.starts_with("-#")) {
        text.remove_prefix(1);
        if (!take_value(text, parameters, value)) return false;
        value = -value;
        return true;
    }
    if (take(text, '[')) return take_sum(text, parameters, value) && take(text, ']');
    if (text.substr(0, 2) == "#<") {
        const std::size_t end = text.find('>');
        if (end == std::string_view::npos) return false;
        const auto found = parameters.find(std::string(text.substr(2, end - 2)));
        text.remove_prefix(end + 1);
        if (found == parameters.end()) return false;
        value = found->second;
        return true;
    }
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return true;
}

constexpr double kChord_mm = 2e-3;
constexpr double kLargest = 1e12;  // of a number in a word
constexpr double kRapid_mm_per_min = 3000.0;
constexpr double kMostTurns = 100.0;           // of one arc
constexpr std::size_t kMostMoves = 4'000'000;  // of a program: some 350 MB
constexpr std::string_view kReadOver = "GMSQRPD";
constexpr int kToolChange = 6, kTurn = 3, kTurnBack = 4, kStop = 5;  // M

using Vec = std::array<double, 2>;

/// The words of one line.
struct Block {
    std::map<char, double> words;
    std::vector<int> codes;  ///< G, in tenths
    std::vector<int> m;      ///< M
    [[nodiscard]] bool has(char letter) const { return words.contains(letter); }
    [[nodiscard]] double get(char letter, double otherwise) const { return has(letter) ? words.at(letter) : otherwise; }
};

class Reader {
public:
    explicit Reader(std::string name) { program_.name = std::move(name); }

    void take(std::string line) {
        ++line_;
        line = without_comments(std::move(line));
        if (line.starts_with("#<")) return assign(line);
        const Block block = parse(line);
        for (const int code : block.codes) set_mode(code);
        if (block.has('T')) tool_ = static_cast<int>(std::lround(block.words.at('T')));
        for (const int m : block.m) turn_spindle(m);
        if (has_code(block, 430)) length_of_ = block.has('H') ? static_cast<int>(std::lround(block.words.at('H'))) : tool_;
        if (has_code(block, 490)) length_of_ = 0;
        if (block.has('F')) feed_ = block.words.at('F');
        if (has_code(block, 411)) offset_ = 0.5 * block.get('D', 0.0);
        if (has_code(block, 400)) offset_ = 0.0;
        if (has_code(block, 530)) return to_machine_top(block);
        if (block.has('X') || block.has('Y') || block.has('Z') || block.has('A')) move(block);
    }
    [[nodiscard]] Program done() && { return std::move(program_); }

private:
    [[noreturn]] void refuse(const std::string& why) const { throw core::IoError(program_.name, fmt::format("line {}: {}", line_, why)); }
    [[noreturn]] void refuse_length() const { refuse(fmt::format("more than {} moves, chords of arcs included", kMostMoves)); }
    static bool has_code(const Block& block, int code) {
        return std::find(block.codes.begin(), block.codes.end(), code) != block.codes.end();
    }

    std::string without_comments(std::string line) {
        for (std::size_t open = line.find('('); open != std::string::npos; open = line.find('(')) {
            const std::size_t close = line.find(')', open);
            if (close == std::string::npos) refuse("a comment does not end");
            program_.comments.push_back({line_, core::words_of(std::string_view(line).substr(open + 1, close - open - 1))});
            line.erase(open, close - open + 1);
        }
        return line;
    }

    void assign(const std::string& line) {
        const std::size_t end = line.find('>'), equals = line.find('=');
        if (end == std::string::npos || equals == std::string::npos) refuse("an assignment that is not understood");
        std::string_view rest = std::string_view(line).substr(equals + 1);
        double value = 0.0;
        if (!take_value(rest, parameters_, value)) refuse("a value that is not understood");
        parameters_[line.substr(2, end - 2)] = value;
    }

    [[nodiscard]] Block parse(std::string_view rest) const {
        Block block;
        for (;;) {
            while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\r')) rest.remove_prefix(1);
            if (rest.empty()) {
                std::sort(block.m.rbegin(), block.m.rend());  // a tool is changed before the spindle starts
                return block;
            }
            const char letter = rest.front();
            rest.remove_prefix(1);
            double value = 0.0;
            if (!take_value(rest, parameters_, value)) refuse(fmt::format("the word {} is not understood", letter));
            if (!(std::abs(value) <= kLargest)) refuse(fmt::format("{}{:g}: at most {:g} is allowed", letter, value, kLargest));
            if (letter == 'G')
                block.codes.push_back(static_cast<int>(std::lround(10.0 * value)));
            else if (letter == 'M')
                block.m.push_back(static_cast<int>(std::lround(value)));
            else if (std::string_view("XYZAIJPFTDH").find(letter) != std::string_view::npos)
                block.words[letter] = value;
            else if (kReadOver.find(letter) == std::string_view::npos)
                refuse(fmt::format("the word {} is not understood", letter));
        }
    }

    void set_mode(int code) {
        switch (code) {
            case 0:
            case 10:
            case 20:
            case 30:
                motion_ = code / 10;
                break;
            case 911:
                relative_centres_ = true;
                break;
            case 930:
                inverse_ = true;
                break;
            case 940:
                inverse_ = false;
                break;
            case 170:
            case 210:
            case 400:
            case 411:
            case 430:
            case 490:
            case 530:
            case 540:
            case 640:
            case 800:
            case 900:
                break;
            default:
                refuse(fmt::format("G{:g} is not understood", 0.1 * code));
        }
    }

    /// Counts a fault at its first line.
    void fault(const char* rule, const char* what) {
        auto& all = program_.faults;
        const auto same = std::find_if(all.begin(), all.end(), [&](const Contact& c) { return c.rule == rule; });
        if (same == all.end()) return all.push_back({rule, what, line_, 1.0, 1});
        ++same->moves;
    }

    void turn_spindle(int m) {
        if (m == kTurn) turns_ = true;
        if (m == kTurnBack || m == kStop || m == kToolChange) turns_ = false;
        if (m != kToolChange) return;
        if (!retracted_) fault("millsim.tool_change", "M6 without G53 G0 Z0 before it: the spindle is not known to stand clear");
        known_x_ = known_y_ = placed_ = false;
        length_of_ = 0;
    }

    /// G53 G0 Z0: straight up from where the spindle is.
    void to_machine_top(const Block& block) {
        if (motion_ != 0 || block.has('X') || block.has('Y') || block.has('A') || block.get('Z', 1.0) != 0.0)
            refuse("G53 is understood as G53 G0 Z0 only");
        programmed_.z = kMachineTop_mm;
        retracted_ = true;
        if (!placed_) return;
        const std::size_t first = program_.moves.size();
        straight(programmed_);
        set_times(first);
    }

    void move(const Block& block) {
        if (block.has('Z') && !(known_x_ && known_y_)) fault("millsim.approach", "Z is moved after a tool change before X and Y are");
        if (block.has('Z')) retracted_ = false;
        if (block.has('Z') && length_of_ != tool_)
            fault("millsim.tool_length", "Z is moved without G43 and the H of the tool in the spindle: its length is not known");
        if (motion_ > 0 && !turns_) fault("millsim.spindle", "a feed without M3 after the last stop or tool change");
        const Pose next{block.get('X', programmed_.x), block.get('Y', programmed_.y), block.get('Z', programmed_.z),
                        block.get('A', programmed_.a)};
        // Until X and Y are programmed the spindle's place is unknown, and nothing is simulated.
        known_x_ = known_x_ || block.has('X');
        known_y_ = known_y_ || block.has('Y');
        if (!placed_) here_ = next;
        placed_ = known_x_ && known_y_;
        if (!placed_) {
            programmed_ = next;
            return;
        }
        if (motion_ > 0 && !(feed_ > 0.0)) refuse("a feed that is not above 0");
        const std::size_t first = program_.moves.size();
        if (motion_ < 2)
            straight(next);
        else
            arc(next, block);
        set_times(first);
        programmed_ = next;
    }

    void push(const Pose& to) {
        if (program_.moves.size() >= kMostMoves) refuse_length();
        program_.moves.push_back({line_, motion_ == 0, tool_, here_, to, 0.0});
        here_ = to;
    }

    void straight(const Pose& next) {
        const double dx = next.x - programmed_.x, dy = next.y - programmed_.y, way = std::hypot(dx, dy);
        Pose to = next;
        if (offset_ > 0.0 && way > 0.0) to.x -= offset_ * dy / way, to.y += offset_ * dx / way;
        if (offset_ > 0.0 && way == 0.0) to.x = here_.x, to.y = here_.y;
        push(to);
    }

    void arc(const Pose& next, const Block& block) {
        if (!relative_centres_)
            fault("millsim.arc_mode", "I and J of an arc without G91.1 before it: a controller in G90.1 reads another centre");
        const Vec centre{programmed_.x + block.get('I', 0.0), programmed_.y + block.get('J', 0.0)};
        const double sense = motion_ == 3 ? 1.0 : -1.0;
        const double turns = block.get('P', 1.0);
        if (!(turns >= 1.0 && turns <= kMostTurns && turns == std::floor(turns)))
            refuse(fmt::format("an arc of P{:g} turns: a whole number from 1 to {:g} is allowed", turns, kMostTurns));
        const double radius = std::hypot(programmed_.x - centre[0], programmed_.y - centre[1]) - sense * offset_;
        if (!(radius > 0.0)) refuse("an arc that the cutter's radius does not fit into");
        const double begin = std::atan2(programmed_.y - centre[1], programmed_.x - centre[0]);
        double sweep = std::atan2(next.y - centre[1], next.x - centre[0]) - begin;
        while (sense * sweep <= 1e-9) sweep += sense * core::kTurn;
        sweep += sense * core::kTurn * (turns - 1.0);
        const double chords = std::abs(sweep) / std::min(0.5, 2.0 * std::sqrt(2.0 * kChord_mm / radius));
        if (!(chords < static_cast<double>(kMostMoves))) refuse_length();
        const int count = 1 + static_cast<int>(chords);
        const Pose start = here_;
        for (int i = 1; i <= count; ++i) {
            const double s = static_cast<double>(i) / count, angle = begin + s * sweep;
            push({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), start.z + s * (next.z - start.z), next.a});
        }
    }

    void set_times(std::size_t first) {
        double way = 0.0;
        const auto length = [](const Move& m) {
            const double d = std::hypot(m.to.x - m.from.x, m.to.y - m.from.y, m.to.z - m.from.z);
            return d > 0.0 ? d : std::abs(m.to.a - m.from.a);
        };
        for (std::size_t i = first; i < program_.moves.size(); ++i) way += length(program_.moves[i]);
        for (std::size_t i = first; i < program_.moves.size(); ++i) {
            Move& m = program_.moves[i];
            const double speed = m.rapid ? kRapid_mm_per_min : inverse_ ? feed_ * way : feed_;
            m.minutes = way > 0.0 ? length(m) / speed : 0.0;
        }
    }

    Program program_;
    Parameters parameters_;
    Pose programmed_, here_;
    double feed_ = 0.0, offset_ = 0.0;
    int tool_ = 0, motion_ = 0, length_of_ = 0;  ///< the last: of which tool G43 knows the length
    bool turns_ = false, inverse_ = false, placed_ = false, known_x_ = false, known_y_ = false;
    bool relative_centres_ = false, retracted_ = false;
    std::size_t line_ = 0;
};

}  // namespace

Program read_program(const std::string& text, const std::string& name) {
    Reader reader(name);
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) reader.take(std::move(line));
    return std::move(reader).done();
}

}  // namespace fusee::toolpath::mill
