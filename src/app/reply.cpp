#include "reply.h"

#include <unistd.h>

#include "exit_codes.h"
#include "fusee/core/provenance.h"
#include "fusee/core/text.h"
#include "fusee/report/findings.h"
#include "output.h"

namespace fusee::app {

namespace {

core::Colour colour_of(const std::string& word) {
    if (word == "always") return core::Colour::kAlways;
    return word == "never" ? core::Colour::kNever : core::Colour::kAuto;
}

void put(std::FILE* file, std::string_view text, const std::string& colour) {
    const int number = file == stdout ? STDOUT_FILENO : STDERR_FILENO;
    const bool marked = core::is_coloured(colour_of(colour), number);
    const std::string safe = core::printable_lines(text);  // names of files, keys and cells are in it
    const std::string lines = core::is_terminal(number) ? core::fitted(safe, core::terminal_columns(number)) : safe;
    const std::string shown = marked ? core::coloured(lines) : lines;
    file == stderr ? core::say_error(shown) : print_out(shown);
}

const char* verdict_of(int code) {
    switch (code) {
        case 0:
            return "done";
        case kRefused:
            return "refused";
        case kBadInput:
            return "bad input";
        case kInterrupted:
            return "stopped";
        default:
            return "internal error";
    }
}

template <class Number>
Json or_null(Number number) {
    return number == 0 ? Json() : Json(number);
}

}  // namespace

Json mistakes_json(const std::vector<core::InvalidInput>& mistakes) {
    Json all = Json::array();
    for (const core::InvalidInput& e : mistakes) {
        const core::Location at = core::location_of(e.field());
        all.push_back({{"file", at.file.empty() ? Json() : Json(at.file)},
                       {"line", or_null(at.line)},
                       {"column", or_null(at.column)},
                       {"field", at.field},
                       {"value", e.value()},
                       {"allowed", e.allowed()}});
    }
    return all;
}

bool Reply::is_heard() const { return settings_.json || is_output_open(); }

void Reply::print(std::string_view text) const {
    if (!settings_.json) put(stdout, text, settings_.colour);
}

void Reply::say(std::string_view text) const {
    if (!settings_.quiet) print(text);
}

void Reply::detail(std::string_view text) const {
    if (settings_.verbose) warn(text);
}

void Reply::warn(std::string_view text) const { put(stderr, text, settings_.colour); }

void Reply::close(int code, std::string_view text) const { code == 0 ? say(text) : warn(text); }

void Reply::show(const core::Findings& findings) {
    for (const core::Finding& finding : findings)
        if (finding.severity != core::Severity::kPass) warn(core::to_line(finding) + "\n");
    set("findings", report::findings_list_json(findings));
}

void Reply::set(const std::string& member, const std::string& json_text) {
    if (settings_.json) result[member] = Json::parse(json_text);
}

void Reply::set_all(const std::string& json_text) {
    if (settings_.json) result = Json::parse(json_text);
}

void Reply::fail(const std::string& message, const std::vector<core::InvalidInput>& mistakes) {
    if (error_.is_null()) error_ = {{"message", message}, {"mistakes", mistakes_json(mistakes)}};
}

void Reply::fail(const core::InputError& error) {
    if (const auto* one = dynamic_cast<const core::InvalidInput*>(&error)) return fail(error.what(), {*one});
    if (const auto* several = dynamic_cast<const core::InvalidInputs*>(&error)) return fail(error.what(), several->all());
    fail(std::string(error.what()));
    if (const auto* file = dynamic_cast<const core::IoError*>(&error); file != nullptr && error_["mistakes"].empty())
        error_["mistakes"].push_back(
            {{"file", file->path()}, {"line", nullptr}, {"column", nullptr}, {"field", ""}, {"value", file->why()}, {"allowed", ""}});
}

std::string Reply::envelope(const std::string& command, int code) const {
    const char* const verdict = code == kBadInput && lacks_resources_ ? "out of resources" : verdict_of(code);
    const Json all{{"fusee", core::version()}, {"command", command}, {"exit_code", code},
                   {"verdict", verdict},       {"error", error_},    {"result", result}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::app
