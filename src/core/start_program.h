#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

/// How programs are started, for run_process, run_child and Companion.
namespace fusee::core {

/// A pipe whose ends no other program inherits. @throws IoError naming `about`
struct Pipe {
    int read = -1, write = -1;
    explicit Pipe(const std::string& about);
    ~Pipe() { close_read(), close_write(); }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_read() { close(read); }
    void close_write() { close(write); }

private:
    static void close(int& end);
};

/// What a program is connected with.
struct Ends {
    int input = -1;  ///< descriptor of its standard input; -1: empty input
    int output = -1;
    int errors = -1;                            ///< -1: they are lost
    std::filesystem::path folder = {};          ///< in which it works; "": that of fusee
    std::vector<std::string> environment = {};  ///< "NAME=value", besides fusee's own
    bool bound = true;                          ///< it ends when fusee does, also by kill -9
};

/// Starts a program found on PATH in a process group of its own, with LC_ALL=C.UTF-8; end_processes() ends it with its children.
/// @param about the file that an error names @throws IoError if it cannot be started
[[nodiscard]] pid_t start_program(std::vector<std::string> words, const Ends& ends, const std::string& about);

/// Has the program ended?
[[nodiscard]] bool program_has_ended(pid_t program);

/// Ends a program of start_program with its children. @returns its exit code, or minus the signal that ended it
int end_program(pid_t program);

}  // namespace fusee::core
