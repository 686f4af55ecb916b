#pragma once
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/path.h"

namespace fusee::core {

/// A program of fusee's that it does not link: the file beside this program, else the name if it is on PATH; "": it is not installed.
[[nodiscard]] std::string companion_program(const std::string& name);

/// A program that answers each line with a line. It runs as run_process (process.h) says, until this object ends, with its children. Not
/// thread-safe.
class Companion {
public:
    /// How a question ended.
    enum class End {
        kAnswered,
        kEnded,      ///< the program ended, or closed its output
        kOutOfTime,  ///< no line within the time
        kTooLong     ///< more than `kLongestAnswer` bytes without a line end
    };
    static constexpr std::size_t kLongestAnswer = 500'000'000;

    /// @param folder it works in. @param environment "NAME=value", besides fusee's own @throws IoError if it cannot be started
    Companion(const std::vector<std::string>& words, const std::filesystem::path& folder, const std::vector<std::string>& environment,
              const std::string& about);
    ~Companion();
    Companion(const Companion&) = delete;
    Companion& operator=(const Companion&) = delete;

    /// Sends `line` and waits for the next line that it prints, which is `answer` then, both without a line end. After any end but
    /// kAnswered the program is ended. @throws Stopped if `interrupted()` meanwhile
    End ask(std::string_view line, std::chrono::milliseconds timeout, std::string& answer);
    /// The end of what it printed to standard error.
    [[nodiscard]] const std::string& errors() const { return errors_; }
    /// Its exit code once it ended; -1: a signal ended it, or fusee.
    [[nodiscard]] int code() const { return code_; }

private:
    bool send(std::string_view& rest);
    bool receive();
    void listen();
    void close_all();

    int process_ = -1, input_ = -1, output_ = -1, error_ = -1, code_ = -1;
    std::string received_, errors_;
};

}  // namespace fusee::core
