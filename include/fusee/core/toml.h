#pragma once
#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/error.h"

namespace fusee::core {

/// Parses TOML 1.0. Text outside strings and comments must be ASCII: bare keys are ASCII, and toml++ 3.3 has undefined behaviour on some
/// others (its issue 295). At most 32 nested brackets and 32 names in a dotted key; texts hold no control characters except tab and line
/// end. `file` is for the message. @throws IoError with line and column
[[nodiscard]] toml::table parse_toml(std::string_view bytes, const std::string& file);

/// A refused value for a message: as TOML, at most 80 characters.
[[nodiscard]] std::string shown(const toml::node& node);

/// "pnrvsa.toml:12:5: rig.gear_friction", the place of a mistake.
[[nodiscard]] std::string toml_place(const std::string& file, const toml::source_region& at, std::string_view path);

/// The mistakes of one TOML file. Reading continues after each, so that all are reported at once; of thousands the first hundred are kept.
class TomlFaults {
public:
    explicit TomlFaults(std::string file) : file_(std::move(file)) {}

    void add(const toml::source_region& at, std::string_view path, std::string value, std::string allowed);
    /// Runs `read`, of another file that this one names; keeps what it throws as InvalidInput or InvalidInputs.
    template <class Read>
    void collect(const Read& read) {
        if (!elsewhere_.collect(read)) ++count_;
    }

    [[nodiscard]] const std::string& file() const { return file_; }
    /// The number of mistakes, at least one for each call that found one: a step failed if it has risen.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// True if there are so many mistakes that no more are kept: suggestions are then not worth their time.
    [[nodiscard]] bool full() const;
    /// Throws the mistakes in the order of the file's lines, then those of other files. @throws InvalidInput or, of several, InvalidInputs
    void throw_if_any();

private:
    struct Fault {
        toml::source_position at;
        InvalidInput mistake;
    };
    std::string file_;
    std::vector<Fault> here_;
    Mistakes elsewhere_;
    std::size_t count_ = 0, left_out_ = 0;
};

}  // namespace fusee::core
