#pragma once
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "fusee/core/file.h"

namespace fusee::fixtures {

/// Changes a folder's files as an editor, a spreadsheet or an attacker may; the same seed gives the same changes.
class Mutator {
public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    /// One to three changes in the files of `folder`. @returns what was done
    std::string change(const std::filesystem::path& folder, const std::vector<std::string>& files) {
        std::string done;
        for (std::size_t i = 0, n = 1 + below(3); i < n; ++i) {
            const std::string& file = files[below(files.size())];
            std::vector<std::string> lines = split(core::read_file(folder / file));
            done += file + ": " + change(lines) + "; ";
            std::string text;
            for (const std::string& line : lines) text += line + "\n";
            core::write_file(folder / file, text);
        }
        return done;
    }

private:
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
    static std::vector<std::string> split(const std::string& text) {
        std::vector<std::string> lines;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            lines.push_back(text.substr(at, end - at));
            at = end + 1;
        }
        return lines;
    }
    /// The place of a number in a line, and its length; length 0 if it has none.
    std::pair<std::size_t, std::size_t> number_in(const std::string& line) {
        const char* const digits = "0123456789";
        std::vector<std::pair<std::size_t, std::size_t>> all;
        for (std::size_t at = line.find_first_of(digits); at != std::string::npos; at = line.find_first_of(digits, at)) {
            const std::size_t end = std::min(line.find_first_not_of("0123456789.e-+", at), line.size());
            all.emplace_back(at, end - at);
            at = end;
        }
        return all.empty() ? std::pair<std::size_t, std::size_t>{0, 0} : all[below(all.size())];
    }
    std::string put_number(std::string& line) {
        static const char* const kFigures[] = {"nan", "inf", "-inf", "1e308", "-1e308", "1e400", "5e-324", "0",
                                               "-0",  "-1",  "1e9",  "1e-12", "",       "abc",   "0x10",   "1,5",
                                               "1e",  "100", "57.3", "1000",  "-0.02",  "0.001"};
        const auto [at, length] = number_in(line);
        const std::string figure = kFigures[below(std::size(kFigures))];
        line.replace(at, length, figure);
        return "number " + figure;
    }
    /// Every number of a column times a factor: another unit.
    std::string scale(std::vector<std::string>& lines) {
        static const double kFactors[] = {100.0, 0.01, 1000.0, -1.0, 57.3, 0.0};
        const double factor = kFactors[below(std::size(kFactors))];
        const std::size_t column = below(7);
        for (std::string& line : lines) {
            std::size_t begin = 0;
            for (std::size_t c = 0; c < column && begin != std::string::npos; ++c)
                begin = line.find(',', begin) == std::string::npos ? std::string::npos : line.find(',', begin) + 1;
            if (begin == std::string::npos) continue;
            const std::size_t end = std::min(line.find(',', begin), line.size());
            char* stop = nullptr;
            const std::string cell = line.substr(begin, end - begin);
            const double value = std::strtod(cell.c_str(), &stop);
            if (stop != cell.c_str() && *stop == '\0') line.replace(begin, end - begin, std::to_string(factor * value));
        }
        return "column " + std::to_string(column) + " times " + std::to_string(factor);
    }
    std::string change(std::vector<std::string>& lines) {
        if (lines.empty()) return "nothing";
        std::string& line = lines[below(lines.size())];
        const auto place = static_cast<std::ptrdiff_t>(below(lines.size()));
        switch (below(10)) {
            case 0:
                lines.erase(lines.begin() + place);
                return "line erased";
            case 1:
                lines.insert(lines.begin() + place, std::string(line));
                return "line doubled";
            case 2:
                std::swap(line, lines[static_cast<std::size_t>(place)]);
                return "lines swapped";
            case 3:
                if (!line.empty()) line[below(line.size())] = static_cast<char>(below(256));
                return "a byte changed";
            case 4:
                lines.resize(static_cast<std::size_t>(place));
                return "cut off";
            case 5:
                line.insert(below(line.size() + 1), std::string(1 + below(300), ",=\"[]{}.#-\n"[below(11)]));
                return "signs put in";
            case 6:
                return scale(lines);
            default:
                return put_number(line);
        }
    }

    std::mt19937_64 random_;
};

/// How many mutations a test makes: FUSEE_MUTATIONS, else `usual`.
inline unsigned mutations(unsigned usual) {
    const char* asked = std::getenv("FUSEE_MUTATIONS");
    return asked != nullptr ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : usual;
}

}  // namespace fusee::fixtures
