#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/finding.h"
#include "fusee/core/terminal.h"

namespace fusee::app {

using Json = nlohmann::ordered_json;

/// The options of every command.
struct Settings {
    bool json = false, quiet = false, verbose = false;
    std::string colour = "auto";
};

/// What a command answers: texts for a person, or under --json one object on standard output (docs/json.md). Messages of trouble go to
/// standard error in both cases.
class Reply {
public:
    explicit Reply(const Settings& settings) : settings_(settings) {}

    [[nodiscard]] bool json() const { return settings_.json; }
    [[nodiscard]] bool quiet() const { return settings_.quiet; }
    [[nodiscard]] bool verbose() const { return settings_.verbose; }

    /// Does anybody take what is printed? false once a reader has left or a write has failed.
    [[nodiscard]] bool is_heard() const;
    /// What was asked for, on standard output; not under --json.
    void print(std::string_view text) const;
    /// What was done, on standard output; not under --json or -q.
    void say(std::string_view text) const;
    /// More than usual, on standard error: only with -v.
    void detail(std::string_view text) const;
    /// Trouble, on standard error.
    void warn(std::string_view text) const;
    /// `say` if `code` is 0, else `warn`.
    void close(int code, std::string_view text) const;
    /// Warns of each finding but passes, and keeps them all as "findings" of the result.
    void show(const core::Findings& findings);

    /// The member of the result: a text that holds JSON. Not parsed unless --json asks for it.
    void set(const std::string& member, const std::string& json_text);
    /// The whole result likewise.
    void set_all(const std::string& json_text);

    /// The error of the envelope, of the first call. @param mistakes the wrong values, if the message names some
    void fail(const std::string& message, const std::vector<core::InvalidInput>& mistakes = {});
    void fail(const core::InputError& error);
    /// The verdict of exit code 2 becomes "out of resources": no value is wrong.
    void lack_resources() { lacks_resources_ = true; }

    /// The message of that error; "" if there is none.
    [[nodiscard]] std::string failure() const { return error_.is_null() ? "" : error_.at("message").get<std::string>(); }

    /// One object: fusee, command, exit_code, verdict, error, result.
    [[nodiscard]] std::string envelope(const std::string& command, int code) const;

    Json result = Json::object();  ///< what docs/json-schema/fusee.json states for the command

private:
    Settings settings_;
    Json error_;  ///< null: none
    bool lacks_resources_ = false;
};

/// {"file", "line", "column", "field", "value", "allowed"}; null where a mistake has no place.
[[nodiscard]] Json mistakes_json(const std::vector<core::InvalidInput>& mistakes);

}  // namespace fusee::app
