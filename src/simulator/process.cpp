#include "fusee/simulator/process.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>

#include "fusee/core/companion.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/core/parallel.h"
#include "fusee/core/process.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"

namespace fusee::simulator {

namespace {

constexpr std::size_t kMostProcesses = 48;        // of the places that end_processes() knows
constexpr std::size_t kShown = 160;               // characters of an answer in a message
constexpr std::chrono::milliseconds kGlance{20};  // between two looks for a signal

using core::Companion;

/// Numbers as JSON: the shortest digits that give them back.
void add_numbers(std::string& line, const std::vector<double>& numbers) {
    line += '[';
    for (std::size_t i = 0; i < numbers.size(); ++i) fmt::format_to(std::back_inserter(line), "{}{}", i == 0 ? "" : ",", numbers[i]);
    line += ']';
}

/// The question as one line. @pre names need no escape: read_case allows letters, figures, _ and -
std::string line_of(const Case& of_case, const Request& request, std::size_t id) {
    std::string line =
        fmt::format(R"({{"id": {}, "experiment": "{}", "run": {}, "parameters": {{)", id, request.experiment->name, request.run);
    for (std::size_t p = 0; p < of_case.parameters.size(); ++p)
        line += fmt::format(R"({}"{}": {})", p == 0 ? "" : ", ", of_case.parameters[p].name, (*request.parameters)[p]);
    line += "}, \"inputs\": {";
    bool first = true;
    for (const std::string& name : request.experiment->inputs) {
        line += fmt::format(R"({}"{}": )", first ? "" : ", ", name);
        add_numbers(line, request.inputs->at(name));
        first = false;
    }
    std::string outputs;
    for (const Output& output : request.experiment->outputs) outputs += fmt::format(R"({}"{}")", outputs.empty() ? "" : ", ", output.name);
    return line + "}, \"outputs\": [" + outputs + "]}";
}

/// What is wrong with an answer that cannot be read. @param why of its reader
std::string unreadable(const std::string& line, const std::string& why) {
    const std::string start = line.substr(0, kShown);
    if (line.find("NaN") != std::string::npos || line.find("Infinity") != std::string::npos)
        return "no such answer, as NaN and Infinity are no numbers of JSON: " + start;
    return line.starts_with("{") ? fmt::format("no such answer, {}: {}", why, start) : "no such answer: " + start;
}

class Workers {
public:
    Workers(const Case& of_case, std::size_t count) : case_(of_case) {
        require_program();
        // Started here, by one thread: a process ends with the thread that started it.
        for (std::size_t i = 0; i < count; ++i)
            idle_.push_back(std::make_unique<Companion>(case_.command, folder(), std::vector<std::string>{"PYTHONUNBUFFERED=1"}, place()));
    }

    [[nodiscard]] Columns answer(const Request& request) {
        const std::size_t id = ++last_id_;
        const std::string question = line_of(case_, request, id);
        std::unique_ptr<Companion> process = take();
        std::string line;
        const Companion::End end = process->ask(question, case_.timeout, line);
        if (end != Companion::End::kAnswered) fail(request, question, how_it_ended(*process, end), process->errors());
        Columns outputs;
        std::string wrong, refused;
        try {
            refused = read_answer(line, request, id, outputs);
            if (refused.empty()) wrong = fault_of(outputs, request);
        } catch (const core::InputError& e) {
            wrong = unreadable(line, e.what());
        }
        if (!wrong.empty()) fail(request, question, "it printed " + wrong, process->errors());
        give_back(std::move(process));
        if (!refused.empty()) throw inference::Refusal(refused);
        return outputs;
    }

private:
    [[nodiscard]] std::string place() const { return case_.model.string() + ": model.command"; }
    [[nodiscard]] fs::path folder() const { return case_.model.parent_path(); }

    /// A path is one of the model's folder, where the process works.
    void require_program() const {
        const std::string& program = case_.command.front();
        const bool is_path = program.find('/') != std::string::npos;
        if (is_path ? ::access((folder() / program).c_str(), X_OK) == 0 : core::on_path(program)) return;
        const bool is_line = case_.command.size() == 1 && program.find(' ') != std::string::npos;
        throw core::InvalidInput(place(), "\"" + program + "\"",
                                 is_line ? "an array of words, as [\"python3\", \"model.py\"]"
                                         : "a program on PATH, or an executable file named from the folder of this file, ./model");
    }

    std::unique_ptr<Companion> take() {
        std::unique_lock lock(mutex_);
        while (idle_.empty()) {
            if (core::interrupted()) throw core::Stopped();
            if (failed_) throw core::InvalidInput(*failed_);
            (void)returned_.wait_for(lock, kGlance);
        }
        if (failed_) throw core::InvalidInput(*failed_);
        std::unique_ptr<Companion> process = std::move(idle_.back());
        idle_.pop_back();
        return process;
    }
    void give_back(std::unique_ptr<Companion> process) {
        {
            const std::scoped_lock lock(mutex_);
            idle_.push_back(std::move(process));
        }
        returned_.notify_one();
    }

    /// @returns why it refuses; "": `outputs` are its answer
    static std::string read_answer(const std::string& line, const Request& request, std::size_t id, Columns& outputs) {
        const nlohmann::ordered_json json = core::parse_json(line, "answer");
        const core::JsonNode root(json, "answer");
        if (root["id"].count() != id) root["id"].refuse("the id of the question");
        if (root.has("error") && !root["error"].is_null()) return root["error"].text();
        for (const Output& output : request.experiment->outputs) {
            const core::JsonNode outs = root["outputs"];
            if (!outs.has(output.name)) continue;
            std::vector<double>& values = outputs[output.name];
            for (const core::JsonNode& cell : outs[output.name].cells()) values.push_back(cell.number());
        }
        return "";
    }

    [[nodiscard]] std::string how_it_ended(const Companion& process, Companion::End end) const {
        if (end == Companion::End::kOutOfTime)
            return fmt::format("no answer within {:g} s (model.timeout_s)", std::chrono::duration<double>(case_.timeout).count());
        if (end == Companion::End::kTooLong) return "a line without an end";
        return process.code() < 0 ? "it ended by a signal" : fmt::format("it ended with exit code {}", process.code());
    }

    [[noreturn]] void fail(const Request& request, const std::string& question, const std::string& what, const std::string& errors) {
        const std::scoped_lock lock(mutex_);
        if (failed_) throw core::InvalidInput(*failed_);
        const fs::path file = fs::temp_directory_path() / fmt::format("fusee_question_{}.json", ::getpid());
        core::write_file(file, question + "\n");
        const std::string words = errors.empty() ? "" : "; on standard error: " + core::last_words(errors);
        std::string command = "cd " + core::shell_word(folder().string()) + " &&";
        for (const std::string& word : case_.command) command += " " + core::shell_word(word);
        failed_.emplace(place(),
                        fmt::format("{}, asked for {} of {}", what, request.experiment->runs[request.run].file, request.experiment->name),
                        fmt::format("one line of JSON with the outputs of every row, finite, or with \"error\"; to repeat it: {} < {}{}",
                                    command, core::shell_word(file.string()), words));
        returned_.notify_all();
        throw core::InvalidInput(*failed_);
    }

    const Case& case_;
    std::mutex mutex_;
    std::condition_variable returned_;
    std::vector<std::unique_ptr<Companion>> idle_;
    std::optional<core::InvalidInput> failed_;
    std::atomic<std::size_t> last_id_ = 0;
};

}  // namespace

Simulate start_processes(const Case& of_case, unsigned jobs) {
    const auto workers = std::make_shared<Workers>(of_case, core::worker_count(jobs, kMostProcesses));
    return [workers](const Request& request) { return workers->answer(request); };
}

}  // namespace fusee::simulator
