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
    /// @param given the options of the command line @post `answers` holds what an earlier session kept
    InitSession(const std::filesystem::path& profile, const std::map<std::string, std::string>& given, search::init::Answers& answers);
    /// Asks until every question is answered; again from the last one if all are. @throws core::Stopped at the end of the input and after
    /// Ctrl-C: the answers are kept
    void ask(search::init::Answers& answers);
    /// Shows what would be written. @returns false if the person goes back to the questions @throws core::Stopped likewise
    [[nodiscard]] bool confirm(const std::string& summary) const;
    /// Removes the kept answers.
    void end() const;

private:
    enum class Step { kNext, kBack };
    Step ask_one(const search::init::Question& question, search::init::Answers& answers) const;
    void read_kept(search::init::Answers& answers);
    void keep() const;

    std::filesystem::path profile_, file_;
    std::vector<const search::init::Question*> questions_;  ///< that no option answers
    std::vector<std::string> texts_;                        ///< answered so far
};

}  // namespace fusee::app
