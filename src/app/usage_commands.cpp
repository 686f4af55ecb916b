#include <memory>

#include "commands.h"
#include "fusee/core/provenance.h"
#include "fusee/profile/keys.h"
#include "numbers.h"
#include "reply.h"
#include "usage/render.h"

namespace fusee::app {

namespace {

/// The words without bash's separate "=".
std::vector<std::string> joined_at_equals(std::vector<std::string> words) {
    if (words.empty() || words.back() == "=") words.emplace_back();
    std::erase(words, "=");
    return words;
}

const Argument* find_option(const Command& command, std::string_view name) {
    for (const Argument& option : command.options)
        if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
    return nullptr;
}

/// The state of a command line before its last word.
struct Typed {
    const Command* command = nullptr;
    const Argument* unfinished = nullptr;  ///< the option that waits for its value
    std::vector<const Argument*> options;  ///< given ones
    std::size_t positionals = 0;
};

Typed read_words(const Command& program, const std::vector<std::string>& words) {
    Typed typed{&program, nullptr, {}, 0};
    for (auto word = words.begin(); word + 1 < words.end(); ++word) {
        const auto below = std::find_if(typed.command->commands.begin(), typed.command->commands.end(),
                                        [&](const Command& command) { return command.name == *word; });
        if (typed.unfinished != nullptr) {
            typed.unfinished = nullptr;
        } else if (word->starts_with('-')) {
            const Argument* option = find_option(*typed.command, std::string_view(*word).substr(0, word->find('=')));
            if (option == nullptr) continue;
            typed.options.push_back(option);
            if (option->takes != Takes::kNothing && word->find('=') == std::string::npos) typed.unfinished = option;
        } else if (below != typed.command->commands.end()) {
            typed.command = &*below;
        } else {
            ++typed.positionals;
        }
    }
    return typed;
}

/// A line for each word that begins with `begun`.
class Offers {
public:
    explicit Offers(std::string_view begun) : begun_(begun) {}
    void add(const std::string& word, const std::string& meaning = "") {
        if (word.starts_with(begun_)) text_ += word + (meaning.empty() ? "" : "\t" + meaning) + "\n";
    }
    void add_values(const Argument& argument) {
        switch (argument.takes) {
            case Takes::kChoice:
                for (const std::string& word : argument.words) add(word);
                break;
            case Takes::kFile:
                text_ += fmt::format("/folders\n/files {}\n", fmt::join(argument.words, "|"));
                break;
            case Takes::kFolder:
                text_ += "/folders\n";
                break;
            case Takes::kKey:
                text_ += "/open\n";
                for (const profile::KeyInfo& key : profile::key_infos()) add(key.path);
                break;
            case Takes::kNothing:
            case Takes::kText:
                break;
        }
    }
    /// The commands below, and the options that may be given now.
    void add_menu(const Typed& typed) {
        for (const Command& below : typed.command->commands) add(below.name, headline(below.description));
        for (const Argument& option : typed.command->options) {
            const bool given = std::find(typed.options.begin(), typed.options.end(), &option) != typed.options.end();
            if (given && !option.repeats) continue;
            for (const std::string& name : option.names) add(name, headline(option.meaning));
        }
    }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string begun_, text_;
};

/// The length of "--out=" or "-o" before the value in the same word; 0: there is no value.
std::size_t value_begin(const std::string& word) {
    if (word.starts_with("--")) return word.find('=') + 1;
    return word.starts_with('-') && word.size() > 2 ? 2 : 0;
}

/// What can stand in place of the last of `words`, which are those behind the program's name; the last one may be empty or begun. A line
/// each:
///     WORD<tab>MEANING   begins as the last word does; the meaning may be missing
///     /folders           folders
///     /files toml|csv    folders, and files with one of these endings
///     /open              no space follows the word
///     /behind --out=     only what is behind this in the last word is completed
/// The scripts of the shells (completions/) read them. Bash's "--out", "=", "FOLDER" is one word.
std::string completions_of(const Command& program, std::vector<std::string> words) {
    words = joined_at_equals(std::move(words));
    const Typed typed = read_words(program, words);
    const std::string& word = words.back();
    const auto& positionals = typed.command->positionals;
    if (const std::size_t begin = typed.unfinished == nullptr ? value_begin(word) : 0; begin > 0) {
        const std::string name = word.substr(0, begin);
        const Argument* option = find_option(*typed.command, name.substr(0, name.find('=')));
        if (option == nullptr) return "";
        Offers values(std::string_view(word).substr(begin));
        values.add_values(*option);
        return "/behind " + name + "\n" + values.text();
    }
    Offers lines(word);
    if (typed.unfinished != nullptr)
        lines.add_values(*typed.unfinished);
    else if (word.starts_with('-') || positionals.empty())
        lines.add_menu(typed);
    else
        lines.add_values(positionals[std::min(typed.positionals, positionals.size() - 1)]);
    return lines.text();
}

int answer_text(const std::string& text, Reply& reply) {
    reply.result = {{"text", text}};
    reply.print(text);
    return 0;
}

}  // namespace

void add_completion(CLI::App& app, Action& action) {
    struct Asked {
        std::string of;
        std::vector<std::string> words;
    };
    const auto asked = std::make_shared<Asked>();
    CLI::App* completion = add_command(app, "completion");
    completion->add_option("shell", asked->of, "Shell that reads the script")->required()->check(one_of({"bash", "zsh", "fish", "words"}));
    completion->add_option("words", asked->words, "Of a command line; the script asks what can stand in place of the last one")->group("");
    completion->footer("Example:\n  source <(fusee completion bash)");
    completion->callback([asked, &app, &action] {
        action = [asked, &app](Reply& reply) {
            const bool script = asked->of != "words";
            return answer_text(script ? std::string(completion_script(asked->of)) : completions_of(read_command_tree(app), asked->words),
                               reply);
        };
    });
}

void add_man(CLI::App& app, Action& action) {
    CLI::App* man = add_command(app, "man");
    man->footer("Example:\n  fusee man | man -l -");
    man->callback([&app, &action] {
        action = [&app](Reply& reply) { return answer_text(man_page(read_command_tree(app), core::version()), reply); };
    });
}

}  // namespace fusee::app
