#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/search/init.h"

namespace fusee::app {

/// The questions of `fusee init` that no option answers, on a terminal. "back" returns to the question before; each answer is judged at its
/// question. Until the profile is written, the answers stand in a file beside it, so that a session that ended goes on where it was.
class InitSession {
public:
    /// @param given the options of the command line @param repair a law that cannot be made is no obstacle
    /// @post `answers` holds what an earlier session kept
    InitSession(const std::filesystem::path& profile, const std::map<std::string, std::string>& given, search::init::Answers& answers,
                bool repair);
    /// Asks until every question is answered. @throws core::Stopped at the end of the input and after Ctrl-C: the answers are kept
    void ask(search::init::Answers& answers);
    /// Shows what would be written, or why nothing can be. @param nearest what Enter changes of a design that cannot be made; none: Enter
    /// ends
    /// @returns false if the questions go on, also after a change @throws core::Stopped likewise
    [[nodiscard]] bool is_settled(const std::string& text, bool made, const search::init::OtherAnswers* nearest,
                                  search::init::Answers& answers);
    /// "3 answers are kept in FILE: ..."; empty: none.
    [[nodiscard]] std::string kept() const;
    /// Removes the kept answers.
    void end() const;

private:
    enum class Step { kNext, kBack, kStay };
    Step ask_one(search::init::Answers& answers);
    /// Takes one answer back, if there is one.
    void go_back(const search::init::Answers& answers);
    /// Enters an answer, if it fits the others; a mistake is shown, but for one of the questions that are still asked, from `open` on.
    bool is_entered(const search::init::Question& question, const std::string& text, std::size_t open,
                    search::init::Answers& answers) const;
    /// "--torque 2" at any question: an earlier answer anew.
    void change(const std::string& line, search::init::Answers& answers);
    void require_fitting(std::size_t open, const search::init::Answers& answers) const;
    /// Back to their defaults: what is not asked beside these answers, from `open` on.
    void clear_unasked(std::size_t open, search::init::Answers& answers) const;
    [[nodiscard]] bool is_asked(std::size_t number, const search::init::Answers& answers) const;
    void read_kept(search::init::Answers& answers);
    void keep() const;

    std::filesystem::path profile_, file_;
    bool repair_;
    std::vector<const search::init::Question*> questions_;  ///< that no option answers
    std::vector<std::string> texts_;                        ///< answered so far
};

}  // namespace fusee::app
