#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "foreign.h"
#include "fusee/core/error.h"

namespace fusee::exchange {

namespace {

constexpr std::string_view kBlank = " \t\r";

/// Removes the next word from the line; empty at its end.
std::string_view next_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(kBlank));
    line.remove_prefix(word.size());
    return word;
}

class ObjScan {
public:
    explicit ObjScan(const std::filesystem::path& path) : path_(path) {}

    void statement(std::string_view line, std::size_t number) {
        line_ = number;
        const std::string_view kind = next_word(line);
        if (kind == "v") vertex(line);
        if (kind == "f" || kind == "l" || kind == "p") face(line);
    }

private:
    [[noreturn]] void fail(const std::string& why) const { throw core::IoError(path_.string(), fmt::format("line {}: {}", line_, why)); }

    void vertex(std::string_view line) {
        for (int i = 0; i < 3; ++i) {
            std::string_view word = next_word(line);
            if (word.starts_with('+')) word.remove_prefix(1);
            double value = 0.0;
            const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (error == std::errc::result_out_of_range && std::abs(std::atof(std::string(word).c_str())) < 1.0) continue;  // nearly 0
            if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
                fail(fmt::format("a coordinate of a point is not a finite number"));
        }
        ++points_;
    }
    void face(std::string_view line) {
        std::size_t corners = 0;
        for (std::string_view word = next_word(line); !word.empty() && !word.starts_with('#'); word = next_word(line)) {
            if (++corners > kMostCorners) fail(fmt::format("a face has more than {} corners; divide it", kMostCorners));
            long long index = 0;
            const std::string_view digits = word.substr(0, word.find('/'));
            const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
            if (error != std::errc() || end != digits.data() + digits.size()) fail("a corner of a face is not the number of a point");
            const long long most = points_;
            if (index == 0 || index > most || index < -most)
                fail(fmt::format("a corner of a face is point {}; the file has {} points so far", index, most));
        }
    }

    const std::filesystem::path& path_;
    std::size_t line_ = 0;
    long long points_ = 0;
};

}  // namespace

void require_sound_obj(const std::string& bytes, const std::filesystem::path& path) {
    ObjScan scan(path);
    std::string_view rest = bytes;
    std::string joined;  // lines that end in a backslash
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::size_t end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        const bool goes_on = line.ends_with('\\');
        if (goes_on) line.remove_suffix(1);
        if (goes_on || !joined.empty()) joined.append(line).append(" ");
        if (goes_on) continue;
        scan.statement(joined.empty() ? line : std::string_view(joined), number);
        joined.clear();
    }
}

}  // namespace fusee::exchange
