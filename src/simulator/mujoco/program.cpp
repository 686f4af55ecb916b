#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/json.h"
#include "run.h"

// fusee-mujoco MODEL.xml: answers each line of JSON with a line (docs/guides/my-simulator-does-not-match.md#the-process).
namespace fusee::mujoco {

namespace {

using Json = nlohmann::ordered_json;

struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
};

class Engine {
public:
    /// @throws core::InputError with MuJoCo's words
    explicit Engine(const std::string& file) {
        char why[1000] = "";
        model_.reset(mj_loadXML(file.c_str(), nullptr, why, sizeof why));
        if (!model_) {
            std::replace(std::begin(why), std::end(why), '\n', ' ');
            throw core::InputError("MuJoCo " + std::string(mj_versionString()) + ": " + file + ": " + why);
        }
        model_->opt.enableflags &= ~mjENBL_SENSORNOISE;  // the same question has the same answer
        timestep_ = model_->opt.timestep;
        data_.reset(mj_makeData(model_.get()));
        mj_setConst(model_.get(), data_.get());
        description_ = describe(*model_);
    }

    [[nodiscard]] Json answer(const core::JsonNode& question) {
        Json reply;
        reply["id"] = question["id"].count();
        if (question.has("describe")) {
            add_description(reply);
            return reply;
        }
        apply(question["parameters"]);
        Columns inputs;
        for (const auto& [name, values] : question["inputs"].members())
            for (const core::JsonNode& cell : values.cells()) inputs[name].push_back(cell.number());
        std::vector<std::string> outputs;
        for (const core::JsonNode& name : question["outputs"].cells()) outputs.push_back(name.text());
        for (const auto& [name, values] : simulate(*model_, *data_, timestep_, inputs, outputs)) reply["outputs"][name] = values;
        return reply;
    }

private:
    void apply(const core::JsonNode& values) {
        for (const Figure& figure : description_.figures) {
            const double value = values.has(figure.name) ? values[figure.name].number() : figure.nominal;
            if (value < figure.least)
                throw core::InvalidInput(figure.name, std::to_string(value), "not below " + std::to_string(figure.least));
            figure.apply(*model_, value);
        }
        mj_setConst(model_.get(), data_.get());
    }

    void add_description(Json& reply) const {
        reply["engine"] = "MuJoCo " + std::string(mj_versionString());
        for (const Figure& figure : description_.figures) {
            Json& own = reply["parameters"][figure.name];
            own["nominal"] = figure.nominal;
            if (figure.tolerance > 0.0) own["tolerance"] = figure.tolerance;
            if (figure.tolerance_abs > 0.0) own["tolerance_abs"] = figure.tolerance_abs;
        }
        for (const Cause& cause : description_.causes)
            reply["effects"][cause.frees.front()] = {{"frees", cause.frees},
                                                     {"usual", cause.usual},
                                                     {"range", cause.range},
                                                     {"meaning", cause.meaning},
                                                     {"remedy", cause.remedy}};
    }

    std::unique_ptr<mjModel, Free> model_;
    std::unique_ptr<mjData, Free> data_;
    Description description_;
    double timestep_ = 0.0;
};

/// The answer to one line; what cannot be answered is its `error`.
std::string reply_to(const std::string& line, const std::string& file, std::unique_ptr<Engine>& engine) {
    Json reply;
    try {
        const Json json = core::parse_json(line, "question");
        const core::JsonNode question(json, "question");
        reply["id"] = question["id"].count();
        if (!engine) engine = std::make_unique<Engine>(file);
        reply = engine->answer(question);
    } catch (const core::InputError& e) {
        reply["error"] = e.what();
    }
    return reply.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

}  // namespace fusee::mujoco

int main(int count, char** words) {
    // MuJoCo's own handlers write a file beside the case, and read a key.
    mju_user_error = [](const char* text) {
        std::fprintf(stderr, "MuJoCo: %s\n", text);
        std::_Exit(1);
    };
    mju_user_warning = [](const char* text) { std::fprintf(stderr, "MuJoCo: %s\n", text); };
    if (count != 2) {
        std::fprintf(stderr, "fusee-mujoco MODEL.xml: the companion of fusee diagnose, MuJoCo %s\n", mj_versionString());
        return 2;
    }
    std::unique_ptr<fusee::mujoco::Engine> engine;
    for (std::string line; std::getline(std::cin, line);) std::cout << fusee::mujoco::reply_to(line, words[1], engine) << std::endl;
}
