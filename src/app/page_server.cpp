#include "page_server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestPage = 200'000'000;
constexpr std::chrono::seconds kBeat{1};  // the stream says that it lives, and learns that the server ends

/// Reloads the page, and shows the verdict of a save that has not been made.
constexpr const char* kScript = R"(<script>
(() => {
  const note = document.createElement('div');
  note.setAttribute('role', 'status');
  note.style.cssText = 'position:fixed;left:0;right:0;bottom:0;z-index:9999;padding:4px 12px;font:14px sans-serif;' +
                       'background:#222;color:#fff;display:none';
  document.body.append(note);
  const events = new EventSource('/events');
  events.addEventListener('verdict', e => { note.textContent = JSON.parse(e.data); note.style.display = 'block'; });
  events.addEventListener('reload', () => location.reload());
})();
</script>)";

constexpr const char* kWaiting =
    "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>fusee watch</title><body><p>No design has been made yet. This page "
    "loads itself when there is one.</p></body></html>";

std::string type_of(const fs::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".html") return "text/html; charset=utf-8";
    if (ending == ".svg") return "image/svg+xml";
    if (ending == ".json") return "application/json";
    if (ending == ".png") return "image/png";
    if (ending == ".csv" || ending == ".txt" || ending == ".scad" || ending == ".ngc") return "text/plain; charset=utf-8";
    return "application/octet-stream";
}

std::string with_script(std::string page) {
    const std::size_t end = page.rfind("</body>");
    return page.insert(end == std::string::npos ? page.size() : end, kScript);
}

std::string json_text(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out + "\"";
}

}  // namespace

struct PageServer::State {
    httplib::Server server;
    int port = 0;
    std::mutex mutex;
    std::condition_variable changed;
    fs::path folder;
    std::string verdict;
    long verdicts = 0, reloads = 0;
    bool ends = false;
    std::jthread thread;

    /// The page or file of a request, inside the folder; 404 otherwise.
    void answer(const httplib::Request& request, httplib::Response& response) {
        const std::string name = request.path == "/" ? "report.html" : request.path.substr(1);
        fs::path place;
        {
            const std::scoped_lock lock(mutex);
            place = folder;
        }
        if (place.empty()) return response.set_content(with_script(kWaiting), type_of("x.html"));
        const fs::path file = fs::weakly_canonical(place / name);
        const std::string inside = (fs::weakly_canonical(place) / "").string();
        if (!file.string().starts_with(inside) || !fs::is_regular_file(file)) {
            response.status = 404;
            return;
        }
        std::string bytes = core::read_file(file, kLargestPage);
        response.set_header("Cache-Control", "no-store");
        response.set_content(file.extension() == ".html" ? with_script(std::move(bytes)) : std::move(bytes), type_of(file));
    }

    /// The next event of one page's stream; waits for it at most kBeat. @returns false when the server ends
    bool next_event(long& seen_verdict, long& seen_reload, httplib::DataSink& sink) {
        std::string event = ": alive\n\n";
        {
            std::unique_lock lock(mutex);
            changed.wait_for(lock, kBeat, [&] { return ends || verdicts != seen_verdict || reloads != seen_reload; });
            if (ends) return false;
            if (reloads != seen_reload)
                event = "event: reload\ndata: 1\n\n";
            else if (verdicts != seen_verdict)
                event = fmt::format("event: verdict\ndata: {}\n\n", json_text(verdict));
            seen_reload = reloads, seen_verdict = verdicts;
        }
        return sink.write(event.data(), event.size());
    }

    void stream(httplib::Response& response) {
        const std::scoped_lock lock(mutex);
        response.set_header("Cache-Control", "no-store");
        response.set_chunked_content_provider(
            "text/event-stream",
            [this, v = verdicts, r = reloads](std::size_t, httplib::DataSink& sink) mutable { return next_event(v, r, sink); });
    }
};

PageServer::PageServer(int port) : state_(std::make_unique<State>()) {
    State& s = *state_;
    s.server.set_pre_routing_handler([&s](const httplib::Request& request, httplib::Response& response) {
        const std::string host = request.get_header_value("Host");  // a page of another host must not read these files
        if (host == fmt::format("127.0.0.1:{}", s.port) || host == fmt::format("localhost:{}", s.port))
            return httplib::Server::HandlerResponse::Unhandled;
        response.status = 403;
        return httplib::Server::HandlerResponse::Handled;
    });
    s.server.Get("/events", [&s](const httplib::Request&, httplib::Response& response) { s.stream(response); });
    s.server.Get("/.*", [&s](const httplib::Request& request, httplib::Response& response) { s.answer(request, response); });
    s.port = port == 0 ? s.server.bind_to_any_port("127.0.0.1") : (s.server.bind_to_port("127.0.0.1", port) ? port : -1);
    if (s.port < 0) throw core::IoError(fmt::format("--serve {}", port), "this port of 127.0.0.1 is taken or not allowed");
    s.thread = std::jthread([&s] { s.server.listen_after_bind(); });
    while (!s.server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

PageServer::~PageServer() {
    {
        const std::scoped_lock lock(state_->mutex);
        state_->ends = true;
    }
    state_->changed.notify_all();
    state_->server.stop();
}

std::string PageServer::address() const { return fmt::format("http://127.0.0.1:{}/", state_->port); }

void PageServer::tell(const std::string& verdict) {
    const std::scoped_lock lock(state_->mutex);
    state_->verdict = verdict;
    ++state_->verdicts;
    state_->changed.notify_all();
}

void PageServer::show(const fs::path& folder) {
    const std::scoped_lock lock(state_->mutex);
    state_->folder = folder;
    ++state_->reloads;
    state_->changed.notify_all();
}

}  // namespace fusee::app
