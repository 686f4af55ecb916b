#include "fusee/gap_case/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fusee/core/file.h"
#include "fusee/core/text.h"

namespace fusee::gap_case {

namespace {

/// Why a folder is no case, and where one is.
std::string why_no_case(const fs::path& folder) {
    constexpr std::size_t kMostNamed = 4;
    const char* const what = "a case is a folder with case.toml, which `fusee case-template PROFILE --out FOLDER` writes";
    std::error_code error;
    if (!fs::is_directory(folder, error))
        return std::string(fs::exists(folder, error) ? "is a file: " : "there is no such folder: ") + what;
    std::vector<std::string> cases;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (fs::is_regular_file(at->path() / "case.toml", error)) cases.push_back(core::printable(at->path().filename().string()));
    std::sort(cases.begin(), cases.end());  // the system lists them in any order
    if (cases.size() > kMostNamed) cases.resize(kMostNamed), cases.emplace_back("...");
    return cases.empty() ? fmt::format("has no case.toml: {}", what)
                         : fmt::format("has no case.toml; cases in it: {}", fmt::join(cases, ", "));
}

}  // namespace

std::string CaseFiles::name() const {
    if (texts_ != nullptr) return folder_.string();
    return fs::absolute(folder_ / "case.toml").lexically_normal().parent_path().filename().string();
}

bool CaseFiles::has(const std::string& file) const {
    if (texts_ != nullptr) return texts_->contains(file);
    std::error_code absent;
    return fs::is_regular_file(folder_ / file, absent);
}

bool CaseFiles::same(const std::string& one, const std::string& other) const {
    std::error_code none;
    return one == other || (texts_ == nullptr && fs::equivalent(folder_ / one, folder_ / other, none));
}

std::string CaseFiles::read(const std::string& file, std::size_t most) const {
    if (texts_ == nullptr && file == "case.toml" && !has(file)) throw core::IoError(folder_.string(), why_no_case(folder_));
    if (texts_ == nullptr) return core::read_file(folder_ / file, most);
    const auto text = texts_->find(file);
    if (text == texts_->end()) throw core::IoError((folder_ / file).string(), "the case has no such file");
    if (text->second.size() > most) throw core::IoError((folder_ / file).string(), "larger than " + std::to_string(most) + " bytes");
    return text->second;
}

core::CsvTable CaseFiles::read_csv(const std::string& file, const std::vector<core::CsvColumn>& columns, const core::CsvOptions& options,
                                   const std::function<void(std::string_view)>& seen) const {
    if (texts_ == nullptr) return core::read_csv(folder_ / file, columns, options, seen);
    const std::string text = read(file, options.largest_bytes);
    seen(text);
    return core::parse_csv(text, (folder_ / file).string(), columns, options);
}

}  // namespace fusee::gap_case
