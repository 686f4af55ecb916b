#include "fusee/simulator/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <list>
#include <mutex>
#include <unordered_map>

#include "experiments.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "menu.h"
#include "ports.h"

namespace fusee::simulator {

/// An answer, or why there is none.
struct Answered {
    Columns outputs;
    std::optional<std::string> refused;
};

/// Answers by question, each asked for once while it is kept; the oldest are dropped. Thread-safe.
class Answers {
public:
    using Answer = std::shared_ptr<const Answered>;
    /// @param ask is called if nobody has asked yet; what it throws, every thread gets that waits for this answer
    [[nodiscard]] Answer of(const std::string& question, const std::function<Answered()>& ask);

private:
    static constexpr std::size_t kMostNumbers = 32'000'000;  ///< of all answers together: 256 MB
    struct Kept {
        std::string question;
        std::size_t numbers = 0;
    };
    std::mutex mutex_;
    std::unordered_map<std::string, std::shared_future<Answer>> all_;
    std::list<Kept> order_;
    std::size_t numbers_ = 0;
};

Answers::Answer Answers::of(const std::string& question, const std::function<Answered()>& ask) {
    std::promise<Answer> promise;
    std::shared_future<Answer> future;
    {
        const std::scoped_lock lock(mutex_);
        if (const auto known = all_.find(question); known != all_.end())
            future = known->second;
        else
            all_.emplace(question, promise.get_future().share());
    }
    if (future.valid()) return future.get();
    Answer answer;
    try {
        answer = std::make_shared<const Answered>(ask());
    } catch (...) {
        promise.set_exception(std::current_exception());
        throw;
    }
    promise.set_value(answer);
    const std::scoped_lock lock(mutex_);
    Kept& own = order_.emplace_back(Kept{question, 1});
    for (const auto& [name, values] : answer->outputs) own.numbers += values.size();
    numbers_ += own.numbers;
    while (numbers_ > kMostNumbers && order_.size() > 1) {
        numbers_ -= order_.front().numbers;
        all_.erase(order_.front().question);
        order_.pop_front();
    }
    return answer;
}

namespace {

/// What is at work in one prediction.
struct AtWork {
    std::vector<double> parameters;
    std::vector<std::pair<const Port*, double>> ports;
};

std::string_view bytes_of(const std::vector<double>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)};
}

}  // namespace

std::string fault_of(const Columns& answer, const Request& request) {
    const std::size_t rows = request.experiment->runs[request.run].rows();
    for (const Output& output : request.experiment->outputs) {
        const auto found = answer.find(output.name);
        if (found == answer.end()) return fmt::format("an answer without the output {}", output.name);
        if (found->second.size() != rows) return fmt::format("{} values of {} for {} rows", found->second.size(), output.name, rows);
        const auto bad = std::find_if(found->second.begin(), found->second.end(), [](double value) { return !std::isfinite(value); });
        if (bad != found->second.end()) return fmt::format("{} in row {} of {}", *bad, bad - found->second.begin() + 1, output.name);
    }
    return "";
}

struct Simulated::Parts {
    const Case& of_case;
    Simulate simulate;
    std::vector<inference::Experiment> experiments;
    std::vector<inference::BuildParameter> build;
    std::vector<inference::Effect> effects;
    std::vector<Port> ports;
    mutable Answers answers;

    Parts(const Case& own, Simulate ask)
        : of_case(own), simulate(std::move(ask)), experiments(engine_experiments(own)), build(engine_build(own)), ports(ports_of(own)) {
        for (const Effect& effect : own.effects) effects.push_back(engine_effect(effect, own));
        const auto has_effect = [&](std::size_t place) {
            return std::any_of(own.effects.begin(), own.effects.end(), [&](const Effect& effect) { return effect.frees.front() == place; });
        };
        for (std::size_t p = 0; p < own.parameters.size(); ++p)
            if (own.parameters[p].sigma > 0.0 && !has_effect(p)) effects.push_back(figure_effect(own.parameters[p], own));
        for (const Port& port : ports) effects.push_back(port.effect);
    }

    [[nodiscard]] double& parameter(AtWork& at_work, const std::string& name) const {
        const Parameter* found = core::find_by(of_case.parameters, &Parameter::name, name);
        return at_work.parameters[static_cast<std::size_t>(found - of_case.parameters.data())];
    }

    void apply(const inference::Setting::Applied& applied, AtWork& at_work) const {
        const std::string& id = applied.cause.id;
        for (const Port& port : ports)
            if (port.effect.id == id) at_work.ports.emplace_back(&port, applied.values.front());
        if (id.starts_with("port.")) return;
        const Effect* effect = core::find_by(of_case.effects, &Effect::id, id);
        if (effect == nullptr) {
            parameter(at_work, id) += applied.values.front();
            return;
        }
        at_work.parameters[effect->frees.front()] += applied.values.front();
        for (std::size_t k = 1; k < effect->frees.size(); ++k) at_work.parameters[effect->frees[k]] = applied.values[k];
    }

    /// Is an effect at work whose size is the deviation of this parameter? Its tolerance then says nothing more.
    [[nodiscard]] bool is_replaced(const std::string& name, const inference::Setting& setting) const {
        return std::any_of(setting.effects.begin(), setting.effects.end(), [&](const inference::Setting::Applied& applied) {
            if (applied.cause.id == name) return true;
            return std::any_of(of_case.effects.begin(), of_case.effects.end(), [&](const Effect& effect) {
                return effect.id == applied.cause.id && of_case.parameters[effect.frees.front()].name == name;
            });
        });
    }

    [[nodiscard]] AtWork at_work_in(const inference::Setting& setting) const {
        AtWork at_work;
        for (const Parameter& own : of_case.parameters) at_work.parameters.push_back(own.nominal);
        for (std::size_t i = 0; i < build.size(); ++i)
            if (!is_replaced(build[i].name, setting)) parameter(at_work, build[i].name) += setting.build[i];
        for (const inference::Setting::Applied& applied : setting.effects) apply(applied, at_work);
        return at_work;
    }

    /// Does what the ports of one kind do to the columns of a run.
    void apply_ports(const AtWork& at_work, bool outputs, const Columns& run, const std::string& time, Columns& columns) const {
        for (const auto& [port, size] : at_work.ports)
            if (const auto column = columns.find(port->column); port->output == outputs && column != columns.end())
                apply_port(port->kind, size, time.empty() ? nullptr : &run.at(time), column->second);
    }

    [[nodiscard]] Columns inputs_of(const Experiment& experiment, std::size_t r, const AtWork& at_work) const {
        Columns inputs;
        for (const std::string& name : experiment.inputs) inputs[name] = experiment.runs[r].columns.at(name);
        apply_ports(at_work, false, experiment.runs[r].columns, experiment.time(), inputs);
        return inputs;
    }

    [[nodiscard]] Answered ask(const Request& request) const {
        try {
            return {simulate(request), {}};
        } catch (const inference::Refusal& refusal) {
            return {{}, refusal.what()};
        }
    }

    /// One run, outputs through their ports: asked for once with these figures and inputs.
    [[nodiscard]] Columns run(const Experiment& experiment, std::size_t r, const AtWork& at_work) const {
        const Columns inputs = inputs_of(experiment, r, at_work);
        core::Sha256 question;
        question.add(fmt::format("{} {} ", experiment.name, r));
        question.add(bytes_of(at_work.parameters));
        for (const auto& [name, values] : inputs) question.add(bytes_of(values));
        const Answers::Answer answer = answers.of(question.hex(), [&] { return ask({&experiment, r, &at_work.parameters, &inputs}); });
        if (answer->refused) throw inference::Refusal(*answer->refused);
        Columns outputs = answer->outputs;
        apply_ports(at_work, true, experiment.runs[r].columns, experiment.time(), outputs);
        return outputs;
    }

    void prove() const {
        const std::string place = of_case.model.string();
        const AtWork nominal = at_work_in({std::vector<double>(build.size(), 0.0), {}});
        for (std::size_t e = 0; e < of_case.experiments.size(); ++e)
            for (std::size_t r = 0; r < of_case.experiments[e].runs.size(); ++r) try {
                    const Experiment& experiment = of_case.experiments[e];
                    const Columns first = run(experiment, r, nominal), inputs = inputs_of(experiment, r, nominal);
                    if (e == 0 && r == 0 && ask({&experiment, r, &nominal.parameters, &inputs}).outputs != first)
                        throw core::InvalidInput(place + ": model", "two different answers to the nominal parameters",
                                                 "a simulator that answers the same question in the same way: a fixed seed, no state");
                } catch (const inference::Refusal& refusal) {
                    throw core::InvalidInput(fmt::format("{}: model: {}", place, of_case.experiments[e].runs[r].file),
                                             fmt::format("the nominal parameters are refused: {}", refusal.what()),
                                             "nominal parameters that can be simulated");
                }
    }
};

Simulated::Simulated(const Case& of_case, Simulate simulate) : parts_(std::make_unique<Parts>(of_case, std::move(simulate))) {
    parts_->prove();
}
Simulated::~Simulated() = default;

const std::vector<inference::Experiment>& Simulated::experiments() const { return parts_->experiments; }
const std::vector<inference::BuildParameter>& Simulated::build() const { return parts_->build; }
const std::vector<inference::Effect>& Simulated::effects() const { return parts_->effects; }
std::vector<std::string> Simulated::remarks() const { return parts_->of_case.remarks; }

std::unique_ptr<inference::Menu> Simulated::menu() const { return std::make_unique<RunsAgain>(*this, parts_->of_case); }

std::vector<Experiment> Simulated::predict_at(const inference::Setting& setting, std::vector<Experiment> inputs) const {
    const AtWork at_work = parts_->at_work_in(setting);
    for (Experiment& experiment : inputs)
        for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
            Columns outputs = parts_->run(experiment, r, at_work);
            for (auto& [name, values] : outputs) experiment.runs[r].columns[name] = std::move(values);
        }
    return inputs;
}

inference::Outputs Simulated::predict(const inference::Setting& setting, inference::Extent extent) const {
    inference::Outputs all(parts_->experiments.size());
    if (extent == inference::Extent::kDirect) return all;  // none is
    const AtWork at_work = parts_->at_work_in(setting);
    for (std::size_t e = 0; e < all.size(); ++e) {
        const Experiment& experiment = parts_->of_case.experiments[e];
        const std::size_t stride = stride_of(experiment);
        all[e].reserve(parts_->experiments[e].size());
        for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
            const Columns outputs = parts_->run(experiment, r, at_work);
            for (std::size_t i = 0; i < experiment.runs[r].rows(); i += stride)
                for (const Output& output : experiment.outputs) all[e].push_back(outputs.at(output.name)[i]);
        }
    }
    return all;
}

}  // namespace fusee::simulator
