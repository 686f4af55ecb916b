#pragma once
#include <sys/wait.h>

#include <initializer_list>
#include <nlohmann/json.hpp>

#include "pipeline/fixture.h"

namespace fusee::app {

namespace fs = std::filesystem;

/// What the program said and how it ended.
struct Ended {
    int code = -1;
    std::string out, err;
    [[nodiscard]] std::string all() const { return out + err; }
};

class Program : public fixtures::TempFolder {
protected:
    /// A shipped design, copied into the test's folder, whose files are STL alone: its name there. For tests of all but the formats.
    std::string quick(const std::string& name) const {
        lay_tables();
        write(name + ".toml", fixtures::with_key(core::read_file(fixtures::shipped(name)), "outputs.formats", R"(["stl"])"));
        return name + ".toml";
    }
    /// Runs `fusee ARGUMENTS` in the test's folder; the arguments go through the shell. More than 120 s is a hang: exit code 124.
    Ended run(const std::string& arguments) const {
        const std::string out = (folder_ / ".stdout").string(), err = (folder_ / ".stderr").string();
        const std::string command =
            "cd '" + folder_.string() + "' && timeout 120 '" FUSEE_PROGRAM "' " + arguments + " >'" + out + "' 2>'" + err + "' </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, core::read_file(out), core::read_file(err)};
    }
};

/// The result in the JSON that the program printed (docs/json.md).
inline nlohmann::json result_of(const Ended& ended) {
    const auto json = nlohmann::json::parse(ended.out);
    EXPECT_EQ(json.at("exit_code"), ended.code);
    EXPECT_EQ(json.at("error").is_null(), ended.code < 2) << ended.out;
    return json.at("result");
}

inline void expect_words(const std::string& text, std::initializer_list<std::string> words) {
    for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in\n" << text;
}

}  // namespace fusee::app
