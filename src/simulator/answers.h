#pragma once
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "fusee/simulator/case.h"

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

}  // namespace fusee::simulator
