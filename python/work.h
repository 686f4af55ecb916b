#pragma once
#include <atomic>
#include <chrono>
#include <future>
#include <optional>

#include "bindings.h"
#include "fusee/core/progress.h"

/// Long work: without the interpreter's lock, and Ctrl-C stops it.
namespace fusee::python {

/// What a running computation and the interpreter tell each other.
class Watch {
public:
    /// @param progress a function of the caller; None: nobody listens
    explicit Watch(py::object progress) : progress_(std::move(progress)), listens_(!progress_.is_none()) {}

    [[nodiscard]] bool stopped() const { return stop_; }
    /// Calls the caller's function. @throws core::Stopped once the work is to stop: after Ctrl-C, or if that function raised
    template <class... Told>
    void tell(const Told&... told) {
        if (stop_) throw core::Stopped();
        if (!listens_) return;
        const py::gil_scoped_acquire lock;
        try {
            progress_(told...);
        } catch (py::error_already_set& e) {
            fail(e);
            throw core::Stopped();
        }
    }
    /// Asks the work to stop, for this exception of Python. @pre the interpreter's lock is held
    void fail(const py::error_already_set& error) {
        if (!error_) error_.emplace(error);
        stop_ = true;
    }
    /// @throws the exception that stopped the work. @pre the interpreter's lock is held
    void raise_if_failed() const {
        if (error_) throw *error_;
    }

private:
    py::object progress_;
    bool listens_;
    std::atomic<bool> stop_ = false;
    std::optional<py::error_already_set> error_;
};

/// Runs `work(watch)` on a thread of its own while this one, which alone may receive signals, waits for them.
/// @throws what `work` throws; Python's exception of a signal (KeyboardInterrupt) or of the caller's function
template <class Work>
auto run(const py::object& progress, const Work& work) {
    using namespace std::chrono_literals;
    Watch watch(progress);
    auto done = std::async(std::launch::async, [&] { return work(watch); });
    {
        const py::gil_scoped_release unlocked;
        while (done.wait_for(20ms) != std::future_status::ready) {
            const py::gil_scoped_acquire lock;
            if (PyErr_CheckSignals() != 0) watch.fail(py::error_already_set());
        }
    }
    try {
        auto result = done.get();
        watch.raise_if_failed();
        return result;
    } catch (const core::Stopped&) {
        watch.raise_if_failed();
        throw;
    }
}

}  // namespace fusee::python
