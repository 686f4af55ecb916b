#include "init_session.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/core/terminal.h"
#include "fusee/core/text.h"
#include "fusee/report/search.h"
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

}  // namespace

InitSession::InitSession(const std::filesystem::path& profile, const std::map<std::string, std::string>& given,
                         search::init::Answers& answers, bool repair)
    : profile_(profile), file_(profile.string() + ".answers"), repair_(repair) {
    for (const search::init::Question& question : search::init::questions(answers.spring))
        if (!given.contains(question.option)) questions_.push_back(&question);
    show(
        fmt::format("Enter takes the value in brackets, ? explains the question, {} returns to the one before, an option such as {} VALUE "
                    "changes an earlier answer. Ctrl-C keeps the answers in {}.\n",
                    kBackWord, answers.spring ? "--law" : "--torque", file_.string()));
    read_kept(answers);
}

void InitSession::read_kept(search::init::Answers& answers) {
    if (!std::filesystem::is_regular_file(file_)) return;
    std::istringstream lines(core::read_file(file_, kLargestKept));
    for (std::string line; texts_.size() < questions_.size() && std::getline(lines, line);) {
        const search::init::Question& question = *questions_[texts_.size()];
        if (!line.starts_with(question.option + " ")) break;  // other options were given then
        if (!is_entered(question, line.substr(question.option.size() + 1), texts_.size() + 1, answers))
            break;  // a file that is gone: asked again
        texts_.push_back(line.substr(question.option.size() + 1));
    }
    if (texts_.empty()) return;
    const std::string options = search::init::options_text(answers);
    show(fmt::format("{} of the last session, {}; delete the file to begin anew\n", core::counted(texts_.size(), "answer"),
                     options.empty() ? "the defaults" : options + " where not the default"));
}

void InitSession::keep() const {
    std::string text;
    for (std::size_t i = 0; i < texts_.size(); ++i) text += questions_[i]->option + " " + texts_[i] + "\n";
    core::write_file(file_, text);
}

bool InitSession::is_asked(std::size_t number, const search::init::Answers& answers) const {
    return !questions_[number]->of_formula || !search::init::names_file(answers.torque_law);
}

void InitSession::clear_unasked(std::size_t open, search::init::Answers& answers) const {
    for (std::size_t i = open; i < questions_.size(); ++i)
        if (!is_asked(i, answers)) questions_[i]->enter(answers, questions_[i]->shown({}));
}

/// The mistake of this answer beside those before; that of a later question is found there.
void InitSession::require_fitting(std::size_t open, const search::init::Answers& answers) const {
    const auto is_later = [&](const std::string& option) {
        return std::any_of(questions_.begin() + std::ptrdiff_t(open), questions_.end(),
                           [&option](const search::init::Question* q) { return q->option == option; });
    };
    try {
        search::init::require_consistent(answers);
        if (answers.spring) (void)search::init::first_spring(profile_, answers);
    } catch (const core::InvalidInput& e) {
        if (!is_later(e.field())) throw;
    }
}

bool InitSession::is_entered(const search::init::Question& question, const std::string& text, std::size_t open,
                             search::init::Answers& answers) const {
    search::init::Answers changed = answers;
    try {
        if (!text.empty()) question.enter(changed, text);
        clear_unasked(open, changed);
        require_fitting(open, changed);
        answers = changed;
        return true;
    } catch (const core::InputError& e) {
        show(fmt::format("  {}\n", e.what()));
        return false;
    }
}

void InitSession::change(const std::string& line, search::init::Answers& answers) {
    const std::size_t space = line.find(' ');
    std::string all;
    for (const search::init::Question& question : search::init::questions(answers.spring)) {
        const auto number = std::size_t(std::find(questions_.begin(), questions_.end(), &question) - questions_.begin());
        if (number >= texts_.size() && number < questions_.size()) continue;  // not yet answered
        all += (all.empty() ? "" : ", ") + question.option;
        if (space == std::string::npos || line.substr(0, space) != question.option) continue;
        const std::string text = line.substr(space + 1);
        // A formula's range is asked for, and a file has its own: what follows the law is asked again.
        const bool asks_again =
            answers.spring && question.option == "--law" && search::init::names_file(text) != search::init::names_file(answers.torque_law);
        const std::size_t open = !asks_again ? texts_.size() : number < texts_.size() ? number + 1 : 0;
        if (!is_entered(question, text, open, answers)) return;
        if (number < texts_.size()) texts_[number] = question.shown(answers);
        texts_.resize(open);
        show(fmt::format("  changed: {} {}\n", question.option, question.shown(answers)));
        return keep();
    }
    show(fmt::format("  {}: {}\n", core::printable(line, 60),
                     all.empty() ? "no question is answered yet: enter the value alone" : "an option and its value; answered: " + all));
}

InitSession::Step InitSession::ask_one(search::init::Answers& answers) {
    const std::size_t number = texts_.size();
    const search::init::Question& question = *questions_[number];
    print_out(question.prompt(answers));
    const std::string line = typed_line();
    if (line == kBackWord) return Step::kBack;
    if (line == "?") return show(fmt::format("  {}\n", question.help)), Step::kStay;
    if (line.starts_with("--")) return change(line, answers), Step::kStay;
    if (!is_entered(question, line, number + 1, answers)) return Step::kStay;
    const bool last_of_law = !repair_ && question.of_law && (number + 1 == questions_.size() || !questions_[number + 1]->of_law);
    if (const auto refused = last_of_law ? search::init::refused_by_law(answers) : std::nullopt) {
        show(report::init_refusal(*refused));
        return Step::kStay;
    }
    return Step::kNext;
}

void InitSession::go_back(const search::init::Answers& answers) {
    do {
        if (texts_.empty()) return show("  this is the first question\n");
        texts_.pop_back();
    } while (!is_asked(texts_.size(), answers));
}

void InitSession::ask(search::init::Answers& answers) {
    while (texts_.size() < questions_.size()) {
        const std::size_t number = texts_.size();
        const Step step = is_asked(number, answers) ? ask_one(answers) : Step::kNext;
        if (step == Step::kNext) texts_.push_back(questions_[number]->shown(answers));
        if (step == Step::kBack) go_back(answers);
        keep();
    }
}

bool InitSession::is_settled(const std::string& text, bool made, const search::init::OtherAnswers* nearest,
                             search::init::Answers& answers) {
    show(text);
    const std::string enter = made      ? "Enter writes " + profile_.string()
                              : nearest ? "Enter takes the nearest one that can be made"
                                        : "Enter ends";
    while (true) {
        show(fmt::format("{}, {} returns to the questions, an option such as --bed VALUE changes an answer: ", enter, kBackWord));
        const std::string line = typed_line();
        if (line.starts_with("--")) return change(line, answers), false;
        if (line == kBackWord) return go_back(answers), false;
        if (!line.empty()) continue;
        if (made || !nearest) return true;
        for (const core::Change& each : nearest->changes) change(each.key + " " + each.value, answers);
        return false;
    }
}

std::string InitSession::kept() const {
    if (texts_.empty()) return "";
    return fmt::format("{} kept in {}: the same command goes on with them\n", core::counted(texts_.size(), "answer"), file_.string());
}

void InitSession::end() const {
    std::error_code none;
    std::filesystem::remove(file_, none);
}

}  // namespace fusee::app
