#pragma once
#include <string>
#include <vector>

#include "fusee/core/path.h"

/// A fault of fusee leaves a folder with what is needed to reproduce it: version, command, copies of the inputs, message, stack.
namespace fusee::core {

/// From now on a fatal signal (a failed assert, an access to no memory, an uncaught exception) writes a crash report, says where on
/// standard error, and ends the program with exit code 3.
/// @param program name, version and build @param words the command line; files that it names are inputs
void begin_crash_reports(const std::string& program, const std::vector<std::string>& words);

/// The file is an input of this run: a crash report gets a copy of it. The first 256 files are kept. Thread-safe.
void note_input(const std::filesystem::path& file) noexcept;

/// Notes the stack of an exception that is being thrown; the report shows the last 4. Thread-safe. @param type its mangled name
void note_throw(const char* type) noexcept;

/// Writes a crash report into the working folder, else into the folder for temporary files. Calls only functions that a signal handler
/// may call. @param what the message @returns the folder; "" if none can be written, or if begin_crash_reports was not called
[[nodiscard]] const char* write_crash_report(const char* what) noexcept;

}  // namespace fusee::core
