#include "answers.h"

namespace fusee::simulator {

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

}  // namespace fusee::simulator
