#include <unistd.h>

#include <optional>

#include "arguments.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "fusee/report/search.h"
#include "fusee/search/design.h"
#include "fusee/search/one_spring.h"
#include "init_session.h"

namespace fusee::app {

namespace {

struct InitArguments {
    std::vector<std::string> columns;
    fs::path profile;
    std::map<std::string, std::string> answers;  // option to text
    fs::path catalogue;
    bool yes = false, repair = false, force = false;
    std::string kind = "joint";
    unsigned jobs = 0;
};

/// The file must be new, or may be replaced, and its name that of a design.
void require_new(const fs::path& file, bool force) {
    if (file.extension() != ".toml") throw core::InvalidInput("init", file.string(), "a file name that ends in .toml");
    if (!profile::is_name(file.stem().string()))
        throw core::InvalidInput("init", file.string(), std::string("a file whose name without .toml is ") + profile::kAllowedName);
    core::require_new_file(file, force);
}

/// What the options answer.
search::init::Answers given_answers(const InitArguments& arguments) {
    search::init::Answers answers;
    answers.columns = core::CsvMapping::of(arguments.columns);
    answers.spring = arguments.kind == "spring";
    core::Mistakes mistakes;
    std::map<std::string, std::string> left = arguments.answers;
    for (const search::init::Question& question : search::init::questions(answers.spring))
        if (const auto given = left.extract(question.option)) mistakes.collect([&] { question.enter(answers, given.mapped()); });
    for (const auto& [option, text] : left)
        mistakes.collect([&] { throw core::InvalidInput(option, text, fmt::format("no such question with --kind {}", arguments.kind)); });
    mistakes.throw_if_any();
    return answers;
}

/// The options beside the answers, for a command that is to be given again. @param asked the answers came from questions
std::string other_options(const InitArguments& arguments, bool asked) {
    std::string text;
    for (const std::string& column : arguments.columns) text += " --columns " + core::shell_word(column);
    if (!arguments.catalogue.empty()) text += " --catalogue " + core::shell_word(arguments.catalogue.string());
    if (arguments.jobs != 0) text += fmt::format(" --jobs {}", arguments.jobs);
    return text + (arguments.repair ? " --repair" : "") + (arguments.yes || asked ? " --yes" : "");
}

constexpr std::size_t kSteps = 20;  ///< of the bar

search::init::Result find_design(const InitArguments& arguments, const search::init::Answers& answers) {
    search::init::require_consistent(answers);
    core::Progress progress("init", kSteps);
    const auto show = [&](double share, const std::string& step) { progress.reach(std::size_t(share * kSteps), step); };
    return search::init::find_design(
        arguments.profile.stem().string(), answers,
        {.jobs = arguments.jobs,
         .catalogue = arguments.catalogue.empty() ? spring::Catalogue() : spring::read_catalogue(arguments.catalogue),
         .repair = arguments.repair,
         .progress = show,
         .stop = core::interrupted});
}

fs::path law_file(const fs::path& profile) { return profile.parent_path() / (profile.stem().string() + "-law.csv"); }

/// The changed law stands beside its profile.
void write_law(const InitArguments& arguments, search::init::Result& result, Reply& reply) {
    const fs::path file = law_file(arguments.profile);
    core::require_new_file(file, arguments.force);
    core::write_file(file, search::init::repair_csv(*result.repair));
    profile::TablePair& law = std::get<profile::TablePair>(result.design->profile.law.curves);
    law.file = file.filename();
    result.design->profile.columns = {};
    reply.result["law"] = file.string();
}

/// What was written after questions: all was shown before.
std::string written_text(const InitArguments& arguments, const search::init::Answers& answers) {
    const std::string file = core::shell_word(arguments.profile.string()), options = search::init::options_text(answers);
    return fmt::format("written: {}\nthe same in one command:\n  fusee init {}{}{}{}{}\nnext:\n  fusee make {}\n  fusee watch {}\n",
                       core::printable(arguments.profile.string()), file, answers.spring ? " --kind spring" : "",
                       options.empty() ? "" : " ", options, other_options(arguments, true), file, file);
}

int write_profile(const InitArguments& arguments, const search::init::Answers& answers, search::init::Result& result, bool asked,
                  Reply& reply) {
    result.design->profile = search::codesign::moved(result.design->profile, fs::absolute(arguments.profile).parent_path());
    core::require_new_file(arguments.profile, arguments.force);  // it may have appeared since
    if (result.repair) write_law(arguments, result, reply);
    core::write_file(arguments.profile, search::init::profile_text(*result.design, answers));
    reply.result["profile"] = arguments.profile.string();
    reply.say(asked ? written_text(arguments, answers)
                    : report::init_text(result, arguments.profile.string(), other_options(arguments, false)));
    return 0;
}

/// Other answers: each with its old and new value, and all options.
Json other_json(const search::init::OtherAnswers& other) {
    Json changes = Json::array();
    for (const core::Change& change : other.changes)
        changes.push_back({{"option", change.key}, {"value", change.value}, {"was", change.was}});
    return {{"changes", changes}, {"options", other.options}};
}

std::vector<search::one_spring::Family> find_families(const InitArguments& arguments, const search::init::Answers& answers) {
    search::one_spring::Options options{.repair = arguments.repair, .jobs = arguments.jobs, .stop = core::interrupted};
    core::Progress progress("init", (options.repair ? 2 : 1) * options.families.size() + 1);
    options.progress = [&](const std::string& family) { progress.advance(family); };
    if (!arguments.catalogue.empty()) options.catalogue = spring::read_catalogue(arguments.catalogue);
    return search::one_spring::find_smallest(search::init::first_spring(arguments.profile, answers), options);
}

/// The smallest part of any family for one spring.
int find_spring(const InitArguments& arguments, search::init::Answers& answers, std::optional<InitSession>& session, Reply& reply) {
    std::vector<search::one_spring::Family> families;
    std::string text;
    const search::one_spring::Family* best = nullptr;
    do {
        if (session) session->ask(answers);
        families = find_families(arguments, answers);
        best = search::one_spring::smallest(families);
        text = report::families_text(arguments.profile.stem().string(), families, !arguments.repair);
    } while (session && !session->is_settled(text, best != nullptr, nullptr, answers));
    reply.set("families", report::families_json(families));
    if (best == nullptr) return session ? void() : reply.warn(text), kRefused;
    profile::Profile found = *best->profile;
    found.name = arguments.profile.stem().string();
    core::require_new_file(arguments.profile, arguments.force);  // it may have appeared since
    core::write_file(arguments.profile, profile::to_commented_toml(found));
    reply.result["profile"] = arguments.profile.string();
    reply.say(session ? written_text(arguments, answers)
                      : text + fmt::format("written: {}, the {}; `fusee make {}` makes it\n", arguments.profile.string(), best->name,
                                           core::shell_word(arguments.profile.string())));
    return 0;
}

int find_joint(const InitArguments& arguments, search::init::Answers& answers, std::optional<InitSession>& session, Reply& reply) {
    search::init::Result result;
    std::string text;
    do {
        if (session) session->ask(answers);
        result = find_design(arguments, answers);
        text = result.design ? report::init_summary(result)
                             : report::init_text(result, arguments.profile.string(), other_options(arguments, session.has_value()));
    } while (session && !session->is_settled(text, result.design.has_value(), result.nearest ? &*result.nearest : nullptr, answers));
    if (result.design) return write_profile(arguments, answers, result, session.has_value(), reply);
    reply.result["levers"] = Json::array();
    for (const search::init::OtherAnswers& lever : result.levers) reply.result["levers"].push_back(other_json(lever));
    reply.result["nearest"] = result.nearest ? other_json(*result.nearest) : Json();
    if (!session) reply.warn(text);
    return kRefused;
}

int run_init(const InitArguments& arguments, Reply& reply) {
    require_thread();
    require_new(arguments.profile, arguments.force);
    search::init::Answers answers = given_answers(arguments);
    std::optional<InitSession> session;  // on a terminal, without --yes and --json
    try {
        if (!arguments.yes && !reply.json() && ::isatty(STDIN_FILENO) != 0)
            session.emplace(arguments.profile, arguments.answers, answers, arguments.repair);
        const int code = answers.spring ? find_spring(arguments, answers, session, reply) : find_joint(arguments, answers, session, reply);
        if (session && code == 0) session->end();
        return code;
    } catch (const core::Stopped&) {
        const std::string kept = session ? session->kept() : "";
        if (kept.empty()) throw;
        return reply.fail("stopped: " + kept), reply.warn("stopped: " + kept), kInterrupted;
    }
}

/// An option for each question that has none yet.
void add_questions(CLI::App& command, const std::shared_ptr<InitArguments>& arguments, bool spring) {
    const search::init::Answers defaults;
    for (const search::init::Question& question : search::init::questions(spring)) {
        if (command.get_option_no_throw(question.option) != nullptr) continue;
        command
            .add_option_function<std::string>(
                question.option, [arguments, option = question.option](const std::string& text) { arguments->answers[option] = text; },
                fmt::format("{}{}{} ({}); default: {}", question.text, question.unit.empty() ? "" : ", ", question.unit, question.allowed,
                            question.shown(defaults)))
            ->type_name("VALUE");
    }
}

}  // namespace

void add_init(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "init", run_init);
    command->add_option("profile", arguments->profile, "Profile to write (*.toml); an existing file is refused")
        ->type_name("FILE.toml")
        ->required();
    command
        ->add_option(
            "--kind", arguments->kind,
            "joint, or spring: one spring with its part, which needs --law (a formula also --from and --to), cable, shaft and machine")
        ->check(one_of({"joint", "spring"}))
        ->capture_default_str();
    add_questions(*command, arguments, false);
    add_questions(*command, arguments, true);
    add_columns(*command, arguments->columns);
    add_catalogue(*command, arguments->catalogue,
                  "Springs on sale: those that hold the work of the law are named, and springs are wound; one spring takes one of them");
    command->add_flag("--repair", arguments->repair,
                      "A law that cannot be made is changed as little as possible, shown beside the wanted one and written as "
                      "PROFILE-law.csv, of one spring as points of its profile");
    command->add_flag("-y,--yes", arguments->yes, "Ask nothing: the defaults answer what no option answers");
    add_force_file(*command, arguments->force);
    add_jobs(*command, arguments->jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    command->footer(
        "Example:\n  fusee init my_joint.toml\n  fusee init my_joint.toml --torque 1 --friction 0.05 --cable 'dyneema 0.8' --shaft 6 "
        "--yes\n  fusee init my_spring.toml --kind spring --law '0.98*sin(x)' --from -30 --to 120 --yes\n\n"
        "Exit code: 0 the profile is written, 1 no such joint can be made (the binding limit and the nearest change are printed, nothing "
        "is written), 2 bad input, or the file exists, 3 internal error, 130 stopped by Ctrl-C: no profile is written, "
        "the answers are kept in PROFILE.answers.");
}

}  // namespace fusee::app
