#include "fusee/study/store.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/core/lists.h"
#include "fusee/core/progress.h"
#include "fusee/core/resource_error.h"
#include "fusee/core/text.h"

namespace fusee::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestRow = 1'000'000;  // bytes
constexpr std::string_view kSum = R"(,"sha256":")", kEnd = R"("})";
constexpr std::size_t kSumLength = 64;

/// The key of a design in the map of places: its row has to have this name too.
std::array<std::uint64_t, 2> design_of(const std::string& key, const std::string& name) {
    const std::string hash = core::sha256_hex(key + '\n' + name);
    const auto word = [&](std::size_t at) { return std::stoull(hash.substr(at, 16), nullptr, 16); };
    return {word(0), word(16)};
}

/// What is wrong with the checksum of a line; empty: nothing.
std::string sum_fault(const std::string& line) {
    const std::size_t tail = kSum.size() + kSumLength + kEnd.size();
    const std::size_t begin = line.size() < tail ? std::string::npos : line.size() - tail;
    if (begin == std::string::npos || line.compare(begin, kSum.size(), kSum) != 0 || !line.ends_with(kEnd))
        return "has no checksum at its end: it was cut off, or made by an older version or another program";
    if (line.compare(begin + kSum.size(), kSumLength, core::sha256_hex(std::string_view(line).substr(0, begin))) != 0)
        return "was changed: its checksum is another one";
    return "";
}

bool is_key(const std::string& key) { return key.size() == kSumLength && key.find_first_not_of("0123456789abcdef") == std::string::npos; }

Figure figure_of(const core::JsonNode& node) {
    if (node.is_null()) return std::nan("");
    return node.is_text() ? Figure(node.text()) : Figure(node.number());
}

}  // namespace

const Figure* Row::find(std::string_view wanted) const {
    const auto* found = core::find_by(
        figures, [](const auto& figure) -> std::string_view { return figure.first; }, wanted);
    return found != nullptr ? &found->second : nullptr;
}

std::string to_json_line(const Row& row) {
    Json figures = Json::object();
    for (const auto& [name, figure] : row.figures)
        std::visit([&, &key = name](const auto& value) { figures[key] = value; }, figure);  // NaN becomes null
    const Json json{{"key", row.key}, {"index", row.index}, {"name", row.name}, {"seconds", row.seconds}, {"figures", std::move(figures)}};
    std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    line.pop_back();  // its '}'
    return line + std::string(kSum) + core::sha256_hex(line) + std::string(kEnd) + '\n';
}

Row parse_row(const std::string& line, const std::string& place) {
    if (const std::string why = sum_fault(line); !why.empty()) throw core::InvalidInput(place, "row", why);
    const Json json = core::parse_json(line, place);
    const core::JsonNode node = core::JsonNode::of_file(json, place);
    Row row{node["key"].text(), node["index"].count(), node["name"].text(), {}, node["seconds"].number()};
    for (const auto& [name, figure] : node["figures"].members()) row.figures.emplace_back(name, figure_of(figure));
    if (!is_key(row.key)) node["key"].refuse("64 digits of base 16");
    // Another order, a key twice, a key too many: all that a row has no place for.
    if (to_json_line(row) != line + '\n') throw core::InvalidInput(place, "row", "the keys of a row, each once and in their order");
    return row;
}

RowLog::RowLog(const core::OutputFolder& study, std::string shard)
    : study_(std::make_unique<core::OpenFolder>(study.open())), shard_(std::move(shard)) {
    const auto rows = study_->find_inside("rows");
    if (!rows) return;
    for (const std::string& name : rows->names())
        if (name.starts_with(shard_ + '.') && rows->kind(name) != core::OpenFolder::Kind::kFile)
            throw core::IoError((rows->shown() / name).string(), "is a link, a folder or a pipe, and rows are written here: remove it");
}

RowLog::~RowLog() = default;

void RowLog::create() {
    const core::OpenFolder rows = study_->make_inside("rows");
    for (int number = 1; !file_; ++number) {
        name_ = (rows.shown() / (number == 1 ? shard_ + ".jsonl" : fmt::format("{}.{}.jsonl", shard_, number))).string();
        if (core::Descriptor made = rows.create_file(fs::path(name_).filename().string()))
            file_ = std::make_unique<core::Descriptor>(std::move(made));
    }
    rows.sync();
}

void RowLog::append(const Row& row) {
    const std::string line = to_json_line(row);
    const std::lock_guard lock(mutex_);
    const core::StopHold hold;  // a stop leaves no half of a line
    if (!file_) create();
    const off_t end = ::lseek(file_->get(), 0, SEEK_END);
    int failed = core::write_all(file_->get(), line);
    if (failed == 0 && ::fdatasync(file_->get()) != 0) failed = errno;
    if (failed == 0) return;
    (void)!::ftruncate(file_->get(), end);  // a full disk: half a line would spoil the next one
    core::refuse_write(name_, failed);
}

void BadRows::add(std::string place_and_why) {
    if (count++ < kShown) first.push_back(std::move(place_and_why));
}

RowIndex::RowIndex(const core::OutputFolder& study, const RowFault& fault) {
    const auto place = study.find();
    auto rows = place ? place->find_inside("rows") : std::nullopt;
    if (!rows) return;
    folder_ = std::make_unique<core::OpenFolder>(std::move(*rows));
    for (std::string& name : folder_->names())
        if (name.ends_with(".jsonl")) files_.push_back(std::move(name));
    for (std::uint32_t file = 0; file < files_.size(); ++file) scan(file, fault);
}

RowIndex::~RowIndex() = default;

void RowIndex::scan(std::uint32_t file, const RowFault& fault) {
    if (folder_->kind(files_[file]) != core::OpenFolder::Kind::kFile) {
        bad_.add((folder_->shown() / files_[file]).string() + ": is a link, a folder or a pipe, and is not read");
        return;
    }
    std::string line;
    Place place{file, 0, 0, 1, 0};
    const auto end_line = [&](std::uint64_t length) {
        place.length = static_cast<std::uint32_t>(line.size());
        index_row(line, place, fault);
        line.clear();
        place.offset += length;
        ++place.line;
    };
    std::uint64_t length = 0;  // of the present line
    folder_->read(files_[file], [&](std::string_view piece) {
        for (const char c : piece) {
            ++length;
            if (c == '\n')
                end_line(std::exchange(length, 0));
            else if (line.size() <= kLongestRow)
                line += c;
        }
        if (core::interrupted()) throw core::Stopped();
    });
    if (length > 0) end_line(length);  // a killed process left it, or one writes it now
}

void RowIndex::index_row(const std::string& line, Place place, const RowFault& fault) {
    const std::string where = named(place);
    if (line.size() > kLongestRow) return bad_.add(fmt::format("{}: is longer than {} bytes", where, kLongestRow));
    if (const std::string why = sum_fault(line); !why.empty()) return bad_.add(where + ": " + why);
    try {
        const Row row = parse_row(line, where);
        if (const std::string why = fault ? fault(row) : ""; !why.empty()) return bad_.add(where + ": " + why);
        std::string figures;
        for (const auto& [name, figure] : row.figures)
            figures += name + '=' + std::visit([](const auto& value) { return fmt::format("{}\n", value); }, figure);
        place.figures = std::hash<std::string>{}(figures);
        const auto [first, is_new] = places_.emplace(design_of(row.key, row.name), place);
        if (!is_new && first->second.figures != place.figures)
            bad_.add(
                fmt::format("{}: has other figures of {} than {}, which counts", where, core::printable(row.name), named(first->second)));
    } catch (const core::InputError& e) {
        bad_.add(e.what());
    }
}

std::optional<RowIndex::Place> RowIndex::find(const std::string& key, const std::string& name) const {
    const auto found = places_.find(design_of(key, name));
    return found != places_.end() ? std::optional(found->second) : std::nullopt;
}

Row RowIndex::read(const Place& place) const {
    const core::Descriptor file = folder_->open_file(files_[place.file]);
    std::string line(place.length, '\0');
    const ssize_t count = ::pread(file.get(), line.data(), line.size(), static_cast<off_t>(place.offset));
    if (count != static_cast<ssize_t>(line.size())) throw core::IoError(named(place), "is gone: the log was changed while fusee ran");
    return parse_row(line, named(place));
}

std::string RowIndex::named(const Place& place) const {
    return fmt::format("{}:{}", (folder_->shown() / files_[place.file]).string(), place.line);
}

void RowIndex::each(const std::function<void(const Place&)>& take) const {
    for (const auto& [design, place] : places_) take(place);
}

}  // namespace fusee::study
