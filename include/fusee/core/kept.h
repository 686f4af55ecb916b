#pragma once
#include <algorithm>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace fusee::core {

/// The last results of a costly function, by all that they depend on: designs of a study that differ in a key of one part ask for the same
/// of the other part again. What was asked for last is kept longest. Thread-safe.
template <class Key, class Result>
class Kept {
public:
    explicit Kept(std::size_t most) : most_(most) {}

    [[nodiscard]] std::optional<Result> find(const Key& key) {
        const std::scoped_lock lock(mutex_);
        const auto known = std::find_if(known_.begin(), known_.end(), [&key](const auto& one) { return one.first == key; });
        if (known == known_.end()) return {};
        std::rotate(known_.begin(), known, known + 1);
        return known_.front().second;
    }
    void keep(Key key, Result result) {
        const std::scoped_lock lock(mutex_);
        known_.emplace_front(std::move(key), std::move(result));
        if (known_.size() > most_) known_.pop_back();
    }

private:
    std::size_t most_;
    std::mutex mutex_;
    std::deque<std::pair<Key, Result>> known_;
};

}  // namespace fusee::core
