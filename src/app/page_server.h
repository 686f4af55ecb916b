#pragma once
#include <filesystem>
#include <memory>
#include <string>

namespace fusee::app {

/// Serves the pages of one folder to a browser on this machine (127.0.0.1) and reloads them: each HTML page gets a small script while it
/// is served; the files stay as they are. Requests that name another host are refused.
class PageServer {
public:
    /// @param port 0: a free one @throws core::IoError if the port is taken
    explicit PageServer(int port);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;

    [[nodiscard]] std::string address() const;  ///< "http://127.0.0.1:8080/"
    /// Tells the open pages what the last save gave.
    void tell(const std::string& verdict);
    /// Serves `folder` from now on and reloads the open pages.
    void show(const std::filesystem::path& folder);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace fusee::app
