#pragma once
#include <span>

#include "commands.h"

namespace fusee::app {

/// A command that a program holds. @pre kCommands (catalogue.h) has the name
struct HeldCommand {
    const char* name;
    void (*add)(CLI::App&, Action&);
};

/// Everything but the commands: parses the line, runs the command, answers, and returns the exit code. The help lists the commands of
/// kCommands; those that are not held are done by the whole program.
int run_program(int argc, char** argv, std::span<const HeldCommand> held);

/// Starts the same command line in the program with all commands, in place of this process: by the launcher that FUSEE_LAUNCHER names,
/// which builds it first, or as `fusee` beside this program. Called before the command has made or said anything.
/// @throws core::InputError if it does not start
[[noreturn]] void continue_in_whole_program();

}  // namespace fusee::app
