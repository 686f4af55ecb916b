// fuzz_inputs: the names of the readers. fuzz_inputs READER: the files to start from, one a line. fuzz_inputs READER dictionary: a dictionary
// for libFuzzer: the words of the seeds, and for profiles every key, table and allowed word of the key schema.
#include <fmt/format.h>

#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "fusee/core/file.h"
#include "fusee/profile/keys.h"
#include "readers.h"

namespace {

constexpr std::size_t kShortest = 3, kLongest = 40, kMost = 3000;

/// The words of a text: letters, digits and what joins them in a key, a unit or a G-code word.
void add_words(std::set<std::string>& words, const std::string& text) {
    std::string word;
    for (const char c : text + "\n") {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-' || c == '$') {
            word += c;
            continue;
        }
        if (word.size() >= kShortest && word.size() <= kLongest) words.insert(word);
        word.clear();
    }
}

void print_dictionary(const fusee::fuzz::Reader& reader) {
    std::set<std::string> words{"nan", "inf", "-inf", "1e400", "-0.0", "18446744073709551616", "1e-320"};
    for (const auto& seed : fusee::fuzz::seeds(reader)) add_words(words, fusee::core::read_file(seed));
    if (std::string(reader.name) == "profile") {
        for (const fusee::profile::KeyInfo& key : fusee::profile::key_infos()) {
            words.insert(key.path.substr(key.path.rfind('.') + 1));
            words.insert("[" + key.table + "]");
            add_words(words, key.allowed);
        }
    }
    std::size_t count = 0;
    for (const std::string& word : words)
        if (count++ < kMost) fmt::print("\"{}\"\n", word);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.empty()) {
        for (const auto& each : fusee::fuzz::readers()) fmt::print("{}\n", each.name);
        return 0;
    }
    const fusee::fuzz::Reader* reader = fusee::fuzz::reader(words.front());
    if (reader == nullptr || words.size() > 2 || (words.size() == 2 && words.back() != "dictionary")) {
        fmt::print(stderr, "usage: fuzz_inputs [READER [dictionary]]\n");
        return 2;
    }
    if (words.size() == 2) return print_dictionary(*reader), 0;
    for (const auto& seed : fusee::fuzz::seeds(*reader)) fmt::print("{}\n", seed.string());
    return 0;
}
