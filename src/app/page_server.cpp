#include "page_server.h"

#include <fmt/format.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <deque>
#include <list>
#include <optional>
#include <thread>
#include <utility>

#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fusee::app {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using Failure = beast::error_code;

constexpr std::size_t kLargestPage = 200'000'000;
constexpr std::size_t kMostClients = 128;  // the oldest connection makes space for one more
constexpr std::size_t kMostEvents = 16;    // that a page has not taken: it is gone
constexpr unsigned kLargestHeader = 8192;
constexpr std::chrono::seconds kToAsk{10}, kToTake{60};  // for a whole request, for a whole answer: a drip of bytes gains nothing
constexpr std::chrono::milliseconds kToAccept{100};      // until the next try, without a free file descriptor

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

constexpr const char* kEvents =
    "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n: alive\n\n";

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

/// The path of a request without its query, %XX decoded. None for what no browser asks.
std::optional<std::string> path_of(std::string_view target) {
    target = target.substr(0, target.find('?'));
    if (!target.starts_with('/')) return std::nullopt;
    std::string path;
    for (std::size_t i = 0; i < target.size(); ++i) {
        if (target[i] != '%') {
            path += target[i];
            continue;
        }
        const auto digit = [&](std::size_t at) {
            return at < target.size() ? std::string_view("0123456789abcdef").find(static_cast<char>(target[at] | 0x20)) : std::string::npos;
        };
        const std::size_t high = digit(i + 1), low = digit(i + 2);
        if (high == std::string::npos || low == std::string::npos || high + low == 0) return std::nullopt;
        path += static_cast<char>(16 * high + low);
        i += 2;
    }
    return path;
}

class Client;

/// What is served, and to whom. Used by the server's one thread only.
struct Site {
    int port = 0;
    fs::path folder;
    std::list<std::shared_ptr<Client>> clients;  ///< from the oldest

    /// Is it asked by a name of this machine? A page of another host must not read these files.
    [[nodiscard]] bool is_own(const http::fields& header) const {
        const auto [begin, end] = header.equal_range(http::field::host);
        if (begin == end || std::next(begin) != end) return false;
        const std::string host(begin->value().data(), begin->value().size());
        return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
    }
    /// The file of a path, inside the folder, links followed.
    [[nodiscard]] std::optional<fs::path> file_of(const std::string& path) const {
        std::error_code error;
        const fs::path file = fs::weakly_canonical(folder / (path == "/" ? "report.html" : path.substr(1)), error);
        const std::string inside = error ? "" : (fs::weakly_canonical(folder, error) / "").string();
        if (error || !file.string().starts_with(inside) || !fs::is_regular_file(file, error)) return std::nullopt;
        return file;
    }
};

/// One connection: requests one after the other, or the events of one page.
class Client : public std::enable_shared_from_this<Client> {
public:
    Client(tcp::socket socket, Site& site) : stream_(std::move(socket)), site_(site) {}

    void read() {
        parser_.emplace();
        parser_->header_limit(kLargestHeader);
        parser_->body_limit(0);
        stream_.expires_after(kToAsk);
        http::async_read(stream_, buffer_, *parser_,
                         [self = shared_from_this()](Failure failure, std::size_t) { failure ? self->close() : self->answer(); });
    }
    /// Called also when another connection needs its place.
    void close() {
        Failure ignored;
        stream_.socket().close(ignored);
        site_.clients.remove(shared_from_this());
    }
    /// An event of the page's stream; nothing for other connections.
    void send(const std::string& event) {
        if (!listens_) return;
        if (events_.size() == kMostEvents) return close();
        events_.push_back(event);
        if (events_.size() == 1) write_event();
    }

private:
    void answer() {
        const auto& request = parser_->get();
        const std::optional<std::string> path = path_of({request.target().data(), request.target().size()});
        if (!site_.is_own(request)) return refuse(http::status::forbidden);
        if (request.method() != http::verb::get) return refuse(http::status::method_not_allowed);
        if (!path) return refuse(http::status::bad_request);
        if (*path == "/events") return listen();
        if (site_.folder.empty()) return put(page_response(kWaiting));
        const std::optional<fs::path> file = site_.file_of(*path);
        if (!file) return refuse(http::status::not_found);
        try {
            file->extension() == ".html" ? put(page_response(core::read_file(*file, kLargestPage))) : put_file(*file);
        } catch (const std::exception&) {  // it is gone, too large, or there is no memory
            refuse(http::status::internal_server_error);
        }
    }
    void refuse(http::status status) { put(http::response<http::string_body>(status, 11)); }

    static http::response<http::string_body> page_response(std::string page) {
        http::response<http::string_body> response(http::status::ok, 11, with_script(std::move(page)));
        response.set(http::field::content_type, type_of("x.html"));
        return response;
    }
    void put_file(const fs::path& file) {
        http::response<http::file_body> response(http::status::ok, 11);
        Failure failure;
        response.body().open(file.c_str(), beast::file_mode::scan, failure);
        if (failure) return refuse(http::status::not_found);
        response.set(http::field::content_type, type_of(file));
        put(std::move(response));
    }
    /// The whole answer: a Range is not served, as the standard allows.
    template <class Body>
    void put(http::response<Body>&& response) {
        response.set(http::field::cache_control, "no-store");
        response.set("X-Content-Type-Options", "nosniff");
        response.set("Cross-Origin-Resource-Policy", "same-origin");
        response.keep_alive(parser_->get().keep_alive());
        response.prepare_payload();
        const auto kept = std::make_shared<http::response<Body>>(std::move(response));
        stream_.expires_after(kToTake);
        http::async_write(stream_, *kept, [self = shared_from_this(), kept](Failure failure, std::size_t) {
            failure || !kept->keep_alive() ? self->close() : self->read();
        });
    }

    void listen() {
        stream_.expires_never();
        listens_ = true;
        send(kEvents);
        wait_for_end();
    }
    /// A page that listens says nothing more: what can be read is its end.
    void wait_for_end() {
        stream_.async_read_some(asio::buffer(ignored_), [self = shared_from_this()](Failure failure, std::size_t) {
            failure ? self->close() : self->wait_for_end();
        });
    }
    void write_event() {
        asio::async_write(stream_, asio::buffer(events_.front()), [self = shared_from_this()](Failure failure, std::size_t) {
            if (failure) return self->close();
            self->events_.pop_front();
            if (!self->events_.empty()) self->write_event();
        });
    }

    beast::tcp_stream stream_;
    Site& site_;
    beast::flat_buffer buffer_{kLargestHeader};
    std::optional<http::request_parser<http::empty_body>> parser_;
    bool listens_ = false;
    std::deque<std::string> events_;
    std::array<char, 256> ignored_{};
};

}  // namespace

struct PageServer::State {
    asio::io_context context{1};
    tcp::acceptor acceptor{context};
    asio::steady_timer again{context};
    Site site;
    std::jthread thread;

    ~State() {
        context.stop();
        if (thread.joinable()) thread.join();
        site.clients.clear();
    }
    /// Only one server listens: no SO_REUSEPORT. SO_REUSEADDR lets the next one begin where old connections are about to end.
    Failure listen(int port) {
        Failure failure;
        acceptor.open(tcp::v4(), failure);
        if (!failure) acceptor.set_option(tcp::acceptor::reuse_address(true), failure);
        if (!failure) acceptor.bind({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)}, failure);
        if (!failure) acceptor.listen(asio::socket_base::max_listen_connections, failure);
        if (!failure) site.port = acceptor.local_endpoint(failure).port();
        return failure;
    }
    void accept() {
        acceptor.async_accept([this](Failure failure, tcp::socket socket) {
            if (failure) {
                again.expires_after(kToAccept);
                return again.async_wait([this](Failure) { accept(); });
            }
            if (site.clients.size() == kMostClients) std::shared_ptr(site.clients.front())->close();
            site.clients.push_back(std::make_shared<Client>(std::move(socket), site));
            site.clients.back()->read();
            accept();
        });
    }
    void send(const std::string& event) {
        for (const auto& client : std::list(site.clients)) client->send(event);
    }
};

PageServer::PageServer(int port) : state_(std::make_unique<State>()) {
    State& s = *state_;
    if (const Failure failure = s.listen(port))
        throw core::IoError(fmt::format("--serve {}", port), "this port of 127.0.0.1 is taken or not allowed: " + failure.message());
    s.accept();
    s.thread = std::jthread([&s] { s.context.run(); });
}

PageServer::~PageServer() = default;

std::string PageServer::address() const { return fmt::format("http://127.0.0.1:{}/", state_->site.port); }

void PageServer::tell(const std::string& verdict) {
    asio::post(state_->context, [&s = *state_, event = fmt::format("event: verdict\ndata: {}\n\n", json_text(verdict))] { s.send(event); });
}

void PageServer::show(const fs::path& folder) {
    asio::post(state_->context, [&s = *state_, folder] {
        s.site.folder = folder;
        s.send("event: reload\ndata: 1\n\n");
    });
}

}  // namespace fusee::app
