#include "fusee/study/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/core/json.h"

namespace fs = std::filesystem;

namespace fusee::study {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void throw_io(const fs::path& path) { throw core::IoError(path.string(), std::strerror(errno)); }

std::array<std::uint64_t, 2> short_key(const std::string& key) {
    const auto word = [&](std::size_t at) { return std::stoull(key.substr(at, 16), nullptr, 16); };
    return {word(0), word(16)};
}

Figure figure_of(const core::JsonNode& node) {
    if (node.is_null()) return std::nan("");
    return node.is_text() ? Figure(node.text()) : Figure(node.number());
}

}  // namespace

const Figure* Row::find(std::string_view wanted) const {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const auto& figure) { return figure.first == wanted; });
    return found != figures.end() ? &found->second : nullptr;
}

std::string to_json_line(const Row& row) {
    Json figures = Json::object();
    for (const auto& [name, figure] : row.figures)
        std::visit([&, &key = name](const auto& value) { figures[key] = value; }, figure);  // NaN becomes null
    const Json json{{"key", row.key}, {"index", row.index}, {"name", row.name}, {"seconds", row.seconds}, {"figures", std::move(figures)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Row parse_row(const std::string& line, const std::string& file) {
    const Json json = core::parse_json(line, file);
    const core::JsonNode node = core::JsonNode::of_file(json, file);
    Row row{node["key"].text(), node["index"].count(), node["name"].text(), {}, node["seconds"].number()};
    for (const auto& [name, figure] : node["figures"].members()) row.figures.emplace_back(name, figure_of(figure));
    return row;
}

RowLog::RowLog(const fs::path& study, const std::string& shard) {
    const fs::path folder = study / "rows";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw core::IoError(folder.string(), error.message());
    for (int number = 1; file_ < 0; ++number) {
        path_ = folder / (number == 1 ? shard + ".jsonl" : fmt::format("{}.{}.jsonl", shard, number));
        file_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
        if (file_ < 0) throw_io(path_);
        if (::flock(file_, LOCK_EX | LOCK_NB) == 0) break;
        if (errno != EWOULDBLOCK && errno != EINTR) throw_io(path_);
        ::close(std::exchange(file_, -1));
    }
    // A killed process may have left half a line: it ends here.
    char last = '\n';
    const off_t end = ::lseek(file_, 0, SEEK_END);
    if (end > 0 && ::pread(file_, &last, 1, end - 1) == 1 && last != '\n' && ::write(file_, "\n", 1) != 1) throw_io(path_);
}

RowLog::~RowLog() { ::close(file_); }

void RowLog::append(const Row& row) {
    const std::string line = to_json_line(row);
    const std::lock_guard lock(mutex_);
    const off_t end = ::lseek(file_, 0, SEEK_END);
    const ssize_t written = ::write(file_, line.data(), line.size());
    if (written != static_cast<ssize_t>(line.size())) {  // a full disk: half a line would spoil the next one
        const int reason = written < 0 ? errno : ENOSPC;
        if (::ftruncate(file_, end) == 0) errno = reason;
        throw_io(path_);
    }
    if (::fdatasync(file_) != 0) throw_io(path_);
}

RowIndex::RowIndex(const fs::path& study) {
    const fs::path folder = study / "rows";
    if (!fs::exists(folder)) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".jsonl") files_.push_back(entry.path());
    std::sort(files_.begin(), files_.end());
    for (std::uint32_t file = 0; file < files_.size(); ++file) scan(file);
}

void RowIndex::scan(std::uint32_t file) {
    constexpr std::string_view kBegin = R"({"key":")";
    constexpr std::size_t kKeyLength = 64;
    std::ifstream in(files_[file], std::ios::binary);
    if (!in) throw_io(files_[file]);
    std::uint64_t offset = 0;
    for (std::string line; std::getline(in, line); offset += line.size() + 1) {
        if (in.eof()) break;  // an unfinished last line
        if (!line.starts_with(kBegin) || line.size() < kBegin.size() + kKeyLength || !Json::accept(line)) continue;
        places_.emplace(short_key(line.substr(kBegin.size(), kKeyLength)), Place{file, offset});
    }
}

std::optional<RowIndex::Place> RowIndex::find(const std::string& key) const {
    const auto found = places_.find(short_key(key));
    return found != places_.end() ? std::optional(found->second) : std::nullopt;
}

Row RowIndex::read(const Place& place) const {
    std::ifstream in(files_[place.file], std::ios::binary);
    in.seekg(static_cast<std::streamoff>(place.offset));
    std::string line;
    if (!std::getline(in, line)) throw_io(files_[place.file]);
    return parse_row(line, files_[place.file].string());
}

}  // namespace fusee::study
