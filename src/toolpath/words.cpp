#include "words.h"

#include <charconv>
#include <sstream>

#include "fusee/core/error.h"

namespace fusee::toolpath {

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

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
        if (auto words = words_of(note.text); words.size() == count && words.front() == begin) return words;
    return {};
}

}  // namespace fusee::toolpath
