#include <fmt/ranges.h>

#include "arguments.h"
#include "fusee/profile/keys.h"
#include "fusee/profile/profile.h"
#include "output.h"

namespace fusee::app {

namespace {

struct KeysArguments {
    bool names = false, markdown = false;
    std::vector<std::string> words;
};

Json key_json(const profile::KeyInfo& key) {
    return {{"key", key.path},        {"meaning", key.meaning},   {"unit", key.unit},
            {"allowed", key.allowed}, {"required", key.required}, {"default", key.required ? Json() : Json(key.default_value)},
            {"only", key.when}};
}

/// For a person: a block for each key.
std::string keys_text(const std::vector<profile::KeyInfo>& keys, std::size_t columns) {
    constexpr std::size_t kIndent = 4;
    std::string text, table = "none";
    for (const profile::KeyInfo& key : keys) {
        if (key.table != table) {
            table = key.table;
            text += fmt::format("{}{}\n", text.empty() ? "" : "\n", table.empty() ? "at the top" : "[" + table + "]");
        }
        text +=
            core::wrapped(fmt::format("{} = {}", key.path.substr(key.path.rfind('.') + 1), key.required ? "(required)" : key.default_value),
                          columns, 2, 2) +
            "\n";
        text += core::wrapped(key.meaning, columns, kIndent) + "\n";
        text += core::wrapped("allowed: " + key.allowed, columns, kIndent, 2) + "\n";
        if (!key.when.empty()) text += core::wrapped(fmt::format("{}", fmt::join(key.when, ", ")), columns, kIndent, 2) + "\n";
    }
    return text;
}

int run_keys(const KeysArguments& arguments, Reply& reply) {
    const std::vector<profile::KeyInfo> found = profile::find_keys(arguments.words);
    Json all = Json::array();
    for (const profile::KeyInfo& key : found) {
        all.push_back(key_json(key));
        if (arguments.names) reply.print(key.path + "\n");
    }
    reply.result = all;
    if (arguments.names) return 0;
    if (arguments.markdown)
        reply.print(arguments.words.empty() ? profile::profile_reference() : profile::profile_reference(found));
    else
        reply.print(keys_text(found, columns_out()));
    return 0;
}

}  // namespace

void add_keys(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "keys", run_keys);
    command->add_option("words", arguments->words, "Beginning of keys or tables, or a word in them; default: all")->type_name("KEY");
    CLI::Option* names = command->add_flag("--names", arguments->names, "Print only the names, one per line");
    command->add_flag("--markdown", arguments->markdown, "Print a Markdown table for each table of the profile")->excludes(names);
    command->footer("Example:\n  fusee keys law\n  fusee keys spring preload\n  fusee keys | less\n  fusee keys --markdown > keys.md");
}

}  // namespace fusee::app
