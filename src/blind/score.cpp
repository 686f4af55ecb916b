#include "fusee/blind/score.h"

#include <algorithm>

#include "answer.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "side_by_side.h"

namespace fusee::blind {

namespace {

std::string told_hash(const ScoreOptions& options) {
    constexpr std::size_t kLargestSeal = 1000;
    return options.hash.empty() ? core::read_file(options.folder / "seal.txt", kLargestSeal) : options.hash;
}

std::vector<Answer> answer_all(const ScoreOptions& options) {
    const std::vector<std::string> names = case_names(options.folder, options.limit);
    std::vector<Answer> answers(names.size());
    side_by_side(
        names.size(), options.jobs,
        [&](std::size_t i) {
            if (options.stop && options.stop()) throw core::Stopped();
            answers[i] = answer_case(options, names[i]);
        },
        [&](std::size_t done, std::size_t i) {
            if (options.progress) options.progress(done, names.size(), names[i] + ": " + answer_name(answers[i]));
        });
    return answers;
}

}  // namespace

Score score(const ScoreOptions& options) {
    const std::string hash = told_hash(options);
    const std::string seal = core::sha256_hex(check_seal(options.folder, hash));
    const std::vector<Answer> answers = answer_all(options);
    std::vector<Label> labels = open_seal(options.folder, hash);
    if (options.limit != 0)  // labels of the cases that were left out
        std::erase_if(labels, [&](const Label& label) {
            return std::none_of(answers.begin(), answers.end(), [&](const Answer& a) { return a.case_name == label.case_name; });
        });
    Score score = score_answers(labels, answers);
    score.seal = seal;
    return score;
}

}  // namespace fusee::blind
