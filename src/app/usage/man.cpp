#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/lists.h"
#include "render.h"

namespace fusee::app {

namespace {

/// No character of the text is markup.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

/// The paragraphs of a help text; indented lines are examples.
std::string paragraphs(const std::string& text) {
    std::string out;
    bool example = false;
    for (const std::string& line : core::pieces_of<std::string>(text, "\n")) {
        const bool indented = line.starts_with("  ");
        if (indented != example) out += indented ? ".EX\n" : ".EE\n";
        example = indented;
        out += line.empty() ? ".PP\n" : escaped(line) + "\n";
    }
    return text.empty() ? "" : ".PP\n" + out + (example ? ".EE\n" : "");
}

/// "profiles..." or "[profiles...]".
std::string usage_word(const Argument& positional) {
    const std::string word = italic(positional.names.front()) + (positional.repeats ? "..." : "");
    return positional.required ? word : "[" + word + "]";
}

std::string usage(const Command& command) {
    std::string text = bold("fusee" + (command.path.empty() ? "" : " " + command.path));
    if (!command.commands.empty()) text += " " + italic("COMMAND");
    text += " [" + italic("OPTIONS") + "]";
    for (const Argument& positional : command.positionals) text += " " + usage_word(positional);
    return text + "\n";
}

std::string item(const Argument& argument, bool positional) {
    std::string text = ".TP\n";
    for (const std::string& name : argument.names)
        text += (&name == &argument.names.front() ? "" : ", ") + (positional ? italic(name) : bold(name));
    if (argument.takes != Takes::kNothing) text += " " + italic(argument.value.name);
    text += "\n" + escaped(argument.meaning) + ".";
    if (!argument.value.allowed.empty()) text += " Allowed: " + escaped(argument.value.allowed) + ".";
    if (!argument.default_value.empty()) text += " Default: " + escaped(argument.default_value) + ".";
    if (argument.required && !positional) text += " Required.";
    return text + "\n";
}

std::string items(const Command& command) {
    std::string text;
    for (const Argument& positional : command.positionals) text += item(positional, true);
    for (const Argument& option : command.options)
        if ((!option.ends && !option.everywhere) || command.path.empty()) text += item(option, false);
    return text;
}

std::string section(const Command& command) {
    return ".SS " + escaped("fusee " + command.path) + "\n" + escaped(command.description) + ".\n.PP\n" + usage(command) + items(command) +
           paragraphs(command.footer);
}

}  // namespace

std::string man_page(const Command& program, const std::string& version) {
    std::string text = ".\\\" Printed by `fusee man`.\n";
    text += fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n", upper(program.name), program.name, version);
    text += fmt::format(".SH NAME\n{} \\- {}\n", program.name, escaped(program.description));
    text += ".SH SYNOPSIS\n" + usage(program) + ".SH OPTIONS\n" + items(program) + ".SH DESCRIPTION\n" + paragraphs(program.footer);
    text += ".SH COMMANDS\n";
    for (const Command* command : all_commands(program))
        if (!command->path.empty()) text += section(*command);
    return text;
}

}  // namespace fusee::app
