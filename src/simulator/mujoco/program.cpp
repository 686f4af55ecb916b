#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "figures.h"
#include "fusee/core/error.h"
#include "fusee/core/json.h"

// fusee-mujoco MODEL.xml: answers each line of JSON with a line (docs/guides/my-simulator-does-not-match.md#the-process).
namespace fusee::mujoco {

namespace {

using Columns = std::map<std::string, std::vector<double>>;

constexpr const char* kBegin = "_begin_";

/// Where a column is read from or written to.
struct Bound {
    const std::vector<double>* values = nullptr;
    int actuator = -1, position = -1, speed = -1;
};

std::vector<std::string> names_of(const mjModel& model, mjtObj kind, int count) {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) names.push_back(name_of(model, kind, i));
    return names;
}

/// The longest of the names with which a column begins, whole words: "elbow_flex" of "elbow_flex_rad". @returns its place, -1: none
int longest(const std::string& column, const std::vector<std::string>& names) {
    int best = -1;
    std::size_t size = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string& name = names[i];
        const bool fits = column == name || column.starts_with(name + "_");
        if (fits && name.size() > size) best = static_cast<int>(i), size = name.size();
    }
    return best;
}

[[noreturn]] void refuse(const std::string& what, const std::string& column, const std::vector<std::string>& names, const char* more) {
    throw core::InvalidInput(what + " " + column, "no such name in the model",
                             fmt::format("{}{}{}", names.empty() ? "none" : "", fmt::join(names, ", "), more));
}

std::string unit_after(const std::string& column, const std::string& name) {
    return column.substr(std::min(column.size(), name.size() + 1));
}

bool is_single(const mjModel& model, int joint) { return model.jnt_type[joint] == mjJNT_HINGE || model.jnt_type[joint] == mjJNT_SLIDE; }

/// 1: position, 2: speed, 0: another unit than this joint's.
int derivative(const mjModel& model, int joint, const std::string& unit) {
    if (!is_single(model, joint)) return 0;
    const std::string own = model.jnt_type[joint] == mjJNT_SLIDE ? "m" : "rad";
    return unit == own ? 1 : unit == own + "_per_s" ? 2 : 0;
}

Bound bound_input(const mjModel& model, const std::string& column, const std::vector<double>& values) {
    Bound bound{&values};
    if (const std::size_t begin = column.rfind(kBegin); begin != std::string::npos) {
        const std::vector<std::string> joints = names_of(model, mjOBJ_JOINT, model.njnt);
        const auto found = std::find(joints.begin(), joints.end(), column.substr(0, begin));
        const int joint = found == joints.end() ? -1 : static_cast<int>(found - joints.begin());
        const int order = joint < 0 ? 0 : derivative(model, joint, column.substr(begin + std::string(kBegin).size()));
        if (order == 0) refuse("input", column, joints, ", then _begin_ and rad or rad_per_s of a hinge, m or m_per_s of a slide");
        if (order == 1) bound.position = model.jnt_qposadr[joint];
        if (order == 2) bound.speed = model.jnt_dofadr[joint];
        return bound;
    }
    const std::vector<std::string> actuators = names_of(model, mjOBJ_ACTUATOR, model.nu);
    bound.actuator = longest(column, actuators);
    if (bound.actuator < 0) refuse("input", column, actuators, " (actuators, also with _UNIT), t_s, JOINT_begin_rad");
    return bound;
}

/// Where an output stands in the data.
const mjtNum* bound_output(const mjModel& model, const mjData& data, const std::string& column) {
    const std::vector<std::string> sensors = names_of(model, mjOBJ_SENSOR, model.nsensor);
    const std::vector<std::string> joints = names_of(model, mjOBJ_JOINT, model.njnt);
    const int joint = longest(column, joints);
    const bool is_sensor = std::find(sensors.begin(), sensors.end(), column) != sensors.end();
    if (const int order =
            joint < 0 || is_sensor ? 0 : derivative(model, joint, unit_after(column, joints[static_cast<std::size_t>(joint)])))
        return order == 1 ? data.qpos + model.jnt_qposadr[joint] : data.qvel + model.jnt_dofadr[joint];
    const int sensor = longest(column, sensors);
    if (sensor < 0) {
        std::vector<std::string> all = sensors;
        all.insert(all.end(), joints.begin(), joints.end());
        refuse("output", column, all,
               " (sensors, also with _UNIT, or _0, _1 of several values; joints with _rad, _rad_per_s, _m, _m_per_s)");
    }
    const std::string rest = unit_after(column, sensors[static_cast<std::size_t>(sensor)]);
    int place = 0;
    const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), place);
    const bool numbered = !rest.empty() && read.ec == std::errc() && read.ptr == rest.data() + rest.size();
    const int values = model.sensor_dim[sensor];
    if (numbered ? place >= values : values > 1)
        refuse("output", column, {fmt::format("{}_0 to _{}", sensors[static_cast<std::size_t>(sensor)], values - 1)}, "");
    return data.sensordata + model.sensor_adr[sensor] + (numbered ? place : 0);
}

void begin(const mjModel& model, mjData& data, const std::vector<Bound>& bounds) {
    if (model.nkey > 0)
        mj_resetDataKeyframe(&model, &data, 0);
    else
        mj_resetData(&model, &data);
    for (const Bound& bound : bounds) {
        if (bound.position >= 0) data.qpos[bound.position] = bound.values->front();
        if (bound.speed >= 0) data.qvel[bound.speed] = bound.values->front();
    }
}

void require_finite(const mjData& data, double time) {
    for (const mjtWarning warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC, mjWARN_BADCTRL})
        if (data.warning[warning].number > 0) throw core::InputError(fmt::format("the integration diverged at {:g} s", time));
}

/// One run: commands hold from their row to the next; a sensor or joint is read at the time of its row, before the command of the next.
/// It begins in the first keyframe, or in the pose of the file, and where columns JOINT_begin_UNIT say. Several inputs may be one
/// actuator's: their sum.
/// @param inputs t_s, and actuators and begins by name. @param outputs names: sensors, SENSOR_UNIT, SENSOR_0, JOINT_rad, JOINT_rad_per_s
/// @param timestep longest step of integration [s]
/// @throws core::InvalidInput for a name that the model lacks, or if the integration diverges
Columns simulate(mjModel& model, mjData& data, double timestep, const Columns& inputs, const std::vector<std::string>& outputs) {
    const auto clock = inputs.find("t_s");
    if (clock == inputs.end() || clock->second.empty()) refuse("input", "t_s", {"the time of each row, t_s"}, "");
    const std::vector<double>& time = clock->second;
    std::vector<Bound> bounds;
    for (const auto& [name, values] : inputs)
        if (name != "t_s") bounds.push_back(bound_input(model, name, values));
    std::vector<std::pair<const mjtNum*, std::vector<double>*>> read;
    Columns answer;
    for (const std::string& name : outputs) read.emplace_back(bound_output(model, data, name), &answer[name]);
    begin(model, data, bounds);
    for (std::size_t i = 0; i < time.size(); ++i) {
        std::fill_n(data.ctrl, model.nu, 0.0);
        for (const Bound& bound : bounds)
            if (bound.actuator >= 0) data.ctrl[bound.actuator] += bound.values->at(i);
        mj_forward(&model, &data);
        for (const auto& [value, column] : read) column->push_back(*value);
        const double span = i + 1 < time.size() ? time[i + 1] - time[i] : 0.0;
        const int steps = span > 0.0 ? std::max(1, static_cast<int>(std::ceil(span / timestep - 1e-6))) : 0;
        if (steps > 0) model.opt.timestep = span / steps;
        for (int k = 0; k < steps; ++k) mj_step(&model, &data);
        require_finite(data, time[i]);
    }
    return answer;
}

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
