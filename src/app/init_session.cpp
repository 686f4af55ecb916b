#include "init_session.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <iostream>
#include <sstream>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/core/terminal.h"
#include "fusee/core/text.h"
#include "output.h"

namespace fusee::app {

namespace {

constexpr const char* kBackWord = "back";
constexpr std::size_t kLargestKept = 100'000;  // bytes

/// Waits for a line of the terminal: reading it would go on after Ctrl-C. @returns false after Ctrl-C
bool is_answered() {
    while (!core::interrupted()) {
        pollfd waiting{STDIN_FILENO, POLLIN, 0};
        if (::poll(&waiting, 1, -1) > 0) return true;
    }
    return false;
}

std::string typed_line() {
    std::string line;
    if (flush_out() && is_answered() && std::getline(std::cin, line)) return line;
    print_out("\n");
    throw core::Stopped();
}

void show(const std::string& text) { print_out(core::fitted(core::printable_lines(text), core::terminal_columns())); }

/// The mistake of this answer beside those before; that of a later question is found there.
void require_fitting(const search::init::Question& question, const search::init::Answers& answers) {
    try {
        search::init::require_consistent(answers);
    } catch (const core::InvalidInput& e) {
        if (e.field() == question.option) throw;
    }
}

}  // namespace

InitSession::InitSession(const std::filesystem::path& profile, const std::map<std::string, std::string>& given,
                         search::init::Answers& answers)
    : profile_(profile), file_(profile.string() + ".answers") {
    for (const search::init::Question& question : search::init::questions(answers.spring))
        if (!given.contains(question.option)) questions_.push_back(&question);
    show(fmt::format("Enter takes the value in brackets, {} returns to the question before. Ctrl-C keeps the answers in {}.\n", kBackWord,
                     file_.string()));
    read_kept(answers);
}

void InitSession::read_kept(search::init::Answers& answers) {
    if (!std::filesystem::is_regular_file(file_)) return;
    std::istringstream lines(core::read_file(file_, kLargestKept));
    for (std::string line; texts_.size() < questions_.size() && std::getline(lines, line);) {
        const search::init::Question& question = *questions_[texts_.size()];
        if (!line.starts_with(question.option + " ")) break;  // other options were given then
        try {
            question.enter(answers, line.substr(question.option.size() + 1));
        } catch (const core::InputError&) {
            break;  // a file that is gone: asked again
        }
        texts_.push_back(line.substr(question.option.size() + 1));
    }
    if (!texts_.empty())
        show(fmt::format("from the last session: {}; delete the file to begin anew.\n", core::counted(texts_.size(), "answer")));
}

void InitSession::keep() const {
    std::string text;
    for (std::size_t i = 0; i < texts_.size(); ++i) text += questions_[i]->option + " " + texts_[i] + "\n";
    core::write_file(file_, text);
}

InitSession::Step InitSession::ask_one(const search::init::Question& question, search::init::Answers& answers) const {
    while (true) {
        print_out(question.prompt(answers));
        const std::string line = typed_line();
        if (line == kBackWord) return Step::kBack;
        search::init::Answers changed = answers;
        try {
            if (!line.empty()) question.enter(changed, line);
            require_fitting(question, changed);
            answers = changed;
            return Step::kNext;
        } catch (const core::InputError& e) {
            show(fmt::format("  {}\n", e.what()));
        }
    }
}

void InitSession::ask(search::init::Answers& answers) {
    if (texts_.size() == questions_.size() && !texts_.empty()) texts_.pop_back();
    while (texts_.size() < questions_.size()) {
        const search::init::Question& question = *questions_[texts_.size()];
        if (ask_one(question, answers) == Step::kNext)
            texts_.push_back(question.shown(answers));
        else if (!texts_.empty())
            texts_.pop_back();
        keep();
    }
}

bool InitSession::confirm(const std::string& summary) const {
    show(summary);
    while (true) {
        show(fmt::format("Enter writes {}, {} returns to the questions, Ctrl-C keeps the answers: ", profile_.string(), kBackWord));
        const std::string line = typed_line();
        if (line.empty()) return true;
        if (line == kBackWord) return false;
    }
}

void InitSession::end() const {
    std::error_code none;
    std::filesystem::remove(file_, none);
}

}  // namespace fusee::app
