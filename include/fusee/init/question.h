#pragma once
#include <functional>
#include <span>
#include <string>

#include "fusee/init/answers.h"

namespace fusee::init {

/// One question of `fusee init`, and the option that answers it in a script.
struct Question {
    std::string option;                                            ///< "--torque"
    std::string text;                                              ///< "Torque of one motor at the joint, held for long"
    std::string unit;                                              ///< "Nm"; empty: none
    std::string allowed;                                           ///< "0.001 to 1000", "fdm, sla or mill"
    std::function<std::string(const Answers&)> shown;              ///< the answer now, as a person enters it
    std::function<void(Answers&, const std::string& text)> enter;  ///< @throws core::InvalidInput, core::IoError

    /// "Torque of one motor at the joint, held for long in Nm (0.001 to 1000) [1]: "
    [[nodiscard]] std::string prompt(const Answers& answers) const;
};

/// All questions in the order in which they are asked.
[[nodiscard]] std::span<const Question> questions();

/// The options that give `answers` again: "--torque 2 --cable "steel 1.5""; an answer equal to its default is left out.
[[nodiscard]] std::string options_text(const Answers& answers);

}  // namespace fusee::init
