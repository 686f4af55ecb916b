#include "words.h"

#include <charconv>

#include "fusee/core/error.h"
#include "fusee/core/text.h"

namespace fusee::toolpath {

double number_in(const Interpreted& program, const std::vector<std::string>& words, std::size_t which) {
    double value = 0.0;
    if (which < words.size()) {
        const std::string& w = words[which];
        if (const auto end = std::from_chars(w.data(), w.data() + w.size(), value); end.ec == std::errc() && end.ptr == w.data() + w.size())
            return value;
    }
    throw core::IoError(program.file, "a comment that begins with \"" + (words.empty() ? "" : words.front()) + "\" lacks a number");
}

std::vector<std::string> find_words(const Interpreted& program, const std::string& begin, std::size_t count) {
    for (const Note& note : program.notes)
        if (auto words = core::words_of(note.text); words.size() == count && words.front() == begin) return words;
    return {};
}

}  // namespace fusee::toolpath
