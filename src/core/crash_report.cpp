#include "fusee/core/crash_report.h"

#include <execinfo.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <system_error>

#include "fusee/core/folder.h"

namespace fusee::core {

namespace {

constexpr std::size_t kMostInputs = 256, kFrames = 64, kPath = 4096;
constexpr unsigned kThrows = 4;                   // of which the stacks are kept
constexpr std::size_t kLargestCopy = 32'000'000;  // [bytes] of one input
constexpr int kInternalError = 3;                 // exit code (docs/commands.md)
constexpr int kReportNames = 100;                 // of folders tried

/// The stack of a thrown exception.
struct Thrown {
    const char* type = nullptr;  // mangled; a type's name is never freed
    int frames = 0;
    std::array<void*, kFrames> stack{};
};

/// All that a report needs, written before a signal arrives: its handler may not allocate.
struct Prepared {
    std::string program, script, folder, temporary;
    std::array<std::atomic<const char*>, kMostInputs> inputs{};
    std::array<Thrown, kThrows> thrown{};
    std::atomic<unsigned> throws = 0;
    std::array<char, kPath> report{};             // the folder written
    alignas(16) std::array<char, 65536> stack{};  // of the handler, for a stack overflow
};

std::atomic<Prepared*> g_prepared = nullptr;
std::atomic<bool> g_begun = false;  // one report for each process

/// A path put together without memory of its own.
class PathText {
public:
    explicit PathText(std::string_view begin) { add(begin); }
    PathText& add(std::string_view text) {
        const std::size_t count = std::min(text.size(), text_.size() - 1 - size_);
        std::memcpy(text_.data() + size_, text.data(), count);
        size_ += count;
        whole_ = whole_ && count == text.size();
        return *this;
    }
    PathText& add_number(long value) {
        std::array<char, 24> digits{};
        std::size_t at = digits.size();
        do digits[--at] = static_cast<char>('0' + value % 10);
        while ((value /= 10) > 0);
        return add({digits.data() + at, digits.size() - at});
    }
    [[nodiscard]] const char* text() const { return text_.data(); }
    [[nodiscard]] char* data() { return text_.data(); }
    [[nodiscard]] bool whole() const { return whole_; }

private:
    std::array<char, kPath> text_{};
    std::size_t size_ = 0;
    bool whole_ = true;
};

void put(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(file, text.data(), text.size());
        if (count < 0 && errno != EINTR) return;
        if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
    }
}

int create(const char* path, mode_t mode = 0644) { return ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode); }

/// Creates the folders above a file.
void make_parents(PathText& path) {
    for (char* at = path.data() + 1; *at != '\0'; ++at)
        if (*at == '/') *at = '\0', (void)::mkdir(path.text(), 0755), *at = '/';
}

/// @returns what became of it, for the list
const char* copy(const char* from, const char* to) {
    const int in = ::open(from, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (in < 0) return "gone";
    struct stat about {};
    if (::fstat(in, &about) != 0 || !S_ISREG(about.st_mode)) return ::close(in), "not a file";
    if (static_cast<std::size_t>(about.st_size) > kLargestCopy) return ::close(in), "too large, not copied";
    const int out = create(to);
    if (out < 0) return ::close(in), "not copied";
    std::array<char, 16384> buffer;
    for (ssize_t got = 0; (got = ::read(in, buffer.data(), buffer.size())) > 0;) put(out, {buffer.data(), static_cast<std::size_t>(got)});
    ::close(in), ::close(out);
    return "copied";
}

void write_inputs(const Prepared& prepared, const char* folder) {
    const int list = create(PathText(folder).add("/inputs.txt").text());
    PathText working(folder);
    working.add("/inputs").add(prepared.folder).add("/");
    make_parents(working);  // the command is repeated there
    for (const auto& each : prepared.inputs) {
        const char* input = each.load();
        if (input == nullptr) break;
        PathText to(folder);
        to.add("/inputs").add(input);
        make_parents(to);
        const char* what = to.whole() ? copy(input, to.text()) : "its path is too long";
        put(list, what), put(list, ": "), put(list, input), put(list, "\n");
    }
    ::close(list);
}

void write_stack(const Prepared& prepared, const char* folder) {
    const int file = create(PathText(folder).add("/stack.txt").text());
    std::array<void*, kFrames> frames;
    put(file, "Where the report was begun (c++filt < stack.txt gives readable names):\n");
    ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), kFrames), file);
    const unsigned count = prepared.throws.load();
    for (unsigned i = count > kThrows ? count - kThrows : 0; i < count; ++i) {
        const Thrown& thrown = prepared.thrown[i % kThrows];
        put(file, "\nThrown: "), put(file, thrown.type), put(file, "\n");
        ::backtrace_symbols_fd(thrown.stack.data(), thrown.frames, file);
    }
    ::close(file);
}

void write_texts(const Prepared& prepared, const char* folder, const char* what) {
    const int about = create(PathText(folder).add("/README.txt").text());
    put(about, "A fault of fusee, not of your input.\n\nMessage: ");
    put(about, what), put(about, "\nProgram: "), put(about, prepared.program), put(about, "\nWorking folder: "),
        put(about, prepared.folder);
    put(about,
        "\n\nstack.txt     the calls that led to it\ninputs.txt    the files that were read\ninputs/       copies of them, with their "
        "folders\nreproduce.sh  the same command on the copies\n\nPlease report it with this folder as an archive, to the issue tracker of "
        "the "
        "project\n(SECURITY.md says when to write to the maintainers instead). Look through inputs/ before:\nit holds your files, and "
        "inputs.txt and README.txt name your folders.\n");
    ::close(about);
    const int script = create(PathText(folder).add("/reproduce.sh").text(), 0755);
    put(script, prepared.script);
    ::close(script);
}

/// A new folder in `parent`. @returns false if there can be none
bool make_report_folder(Prepared& prepared, const std::string& parent) {
    for (int i = 0; i < kReportNames; ++i) {
        PathText name(parent);
        name.add("/fusee-crash-").add_number(::getpid());
        if (i > 0) name.add("-").add_number(i);
        if (!name.whole()) return false;
        if (::mkdir(name.text(), 0755) == 0) return std::memcpy(prepared.report.data(), name.text(), kPath), true;
        if (errno != EEXIST) return false;
    }
    return false;
}

const char* signal_text(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "access to memory that is not there (SIGSEGV)";
        case SIGBUS:
            return "access to a file or memory that is gone (SIGBUS)";
        case SIGFPE:
            return "arithmetic fault (SIGFPE)";
        case SIGILL:
            return "instruction that this processor does not have (SIGILL)";
        default:
            return "failed assertion or uncaught exception (SIGABRT)";
    }
}

void on_fatal_signal(int signal) {
    if (g_begun.load())
        for (;;) ::pause();  // another thread writes the report and ends the program
    const char* folder = write_crash_report(signal_text(signal));
    put(STDERR_FILENO, "fusee: internal error, please report it: "), put(STDERR_FILENO, signal_text(signal)), put(STDERR_FILENO, "\n");
    if (*folder != '\0') put(STDERR_FILENO, "fusee: what reproduces it is in "), put(STDERR_FILENO, folder), put(STDERR_FILENO, "\n");
    ::_exit(kInternalError);
}

/// One word of a shell command; an absolute path leads to the copies.
std::string shell_word(const std::string& word) {
    const std::size_t path = word.starts_with('/') ? 0 : word.starts_with('-') ? word.find("=/") : std::string::npos;
    const std::size_t begin = path == std::string::npos ? word.size() : path == 0 ? 0 : path + 1;
    const auto quoted = [](const std::string& text) {
        std::string all = "'";
        for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return text.empty() ? std::string() : all + "'";
    };
    const std::string text = quoted(word.substr(0, begin)) + (begin < word.size() ? "\"$here/inputs\"" + quoted(word.substr(begin)) : "");
    return text.empty() ? "''" : text;
}

std::string script_of(const std::string& folder, const std::vector<std::string>& words) {
    std::string script =
        "#!/bin/sh\n# The command that failed, on copies of its inputs. FUSEE=/path/to/fusee chooses another program.\n"
        "here=$(cd \"$(dirname \"$0\")\" && pwd)\ncd " +
        shell_word(folder) + " || exit 1\nexec \"${FUSEE:-fusee}\"";
    for (std::size_t i = 1; i < words.size(); ++i) script += " " + shell_word(words[i]);
    return script + "\n";
}

}  // namespace

void begin_crash_reports(const std::string& program, const std::vector<std::string>& words) {
    static Prepared prepared;
    std::error_code error;
    prepared.program = program;
    prepared.folder = fs::current_path(error).string();
    const char* temporary = std::getenv("TMPDIR");
    prepared.temporary = temporary == nullptr || *temporary == '\0' ? "/tmp" : temporary;
    prepared.script = script_of(prepared.folder, words);
    std::array<void*, 1> first;
    (void)::backtrace(first.data(), 1);  // the first call loads a library
    g_prepared = &prepared;
    for (std::size_t i = 1; i < words.size(); ++i)
        if (fs::is_regular_file(words[i], error)) note_input(words[i]);
    const stack_t own{prepared.stack.data(), 0, prepared.stack.size()};
    ::sigaltstack(&own, nullptr);
    struct sigaction action {};
    action.sa_handler = on_fatal_signal;
    action.sa_flags = SA_ONSTACK | SA_RESETHAND;  // a fault of the handler itself ends the program
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(signal, &action, nullptr);
}

void note_input(const fs::path& file) noexcept {
    Prepared* prepared = g_prepared.load();
    if (prepared == nullptr || is_in_temporary_folder(file)) return;
    try {
        const std::string path = fs::absolute(file).lexically_normal().string();
        static std::mutex one_at_a_time;
        const std::scoped_lock lock(one_at_a_time);
        for (auto& place : prepared->inputs) {
            const char* noted = place.load();
            if (noted != nullptr && path == noted) return;
            if (noted == nullptr) return place.store(::strdup(path.c_str()));
        }
    } catch (const std::exception&) {  // no memory, or the working folder is gone: the report lacks the file
    }
}

void note_throw(const char* type) noexcept {
    Prepared* prepared = g_prepared.load();
    if (prepared == nullptr) return;
    static std::atomic_flag busy;
    if (busy.test_and_set()) return;  // two threads at once: one stack is enough
    Thrown& thrown = prepared->thrown[prepared->throws.load() % kThrows];
    thrown.type = type;
    thrown.frames = ::backtrace(thrown.stack.data(), kFrames);
    ++prepared->throws;
    busy.clear();
}

const char* write_crash_report(const char* what) noexcept {
    Prepared* prepared = g_prepared.load();
    if (prepared == nullptr || g_begun.exchange(true)) return "";
    if (!make_report_folder(*prepared, prepared->folder) && !make_report_folder(*prepared, prepared->temporary)) return "";
    const char* folder = prepared->report.data();
    write_texts(*prepared, folder, what);
    write_stack(*prepared, folder);
    write_inputs(*prepared, folder);
    return folder;
}

}  // namespace fusee::core
