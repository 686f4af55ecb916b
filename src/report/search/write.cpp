#include "fusee/core/file.h"
#include "fusee/report/search.h"

namespace fusee::report {

namespace fs = std::filesystem;

void write_search(const search::codesign::RunResult& result, const fs::path& folder) {
    for (const search::codesign::FoundProfile& profile : result.profiles) {
        core::make_folder((folder / profile.file).parent_path());
        core::write_file(folder / profile.file, profile.toml);
    }
    std::string summary;
    for (const std::string& line : result.summary) summary += line + "\n";
    if (const auto& search = result.search) {
        core::write_file(folder / "history.csv", history_csv(search->history));
        if (!search->costs.empty()) core::write_file(folder / "figure_9.csv", figure_9_csv(search->costs));
        core::write_file(folder / "design.json", search_json(*search));
        core::write_file(folder / "design.html", search_html(*search, summary));
    }
    if (const auto& pareto = result.pareto) {
        core::write_file(folder / "pareto.json", pareto_json(*pareto));
        core::write_file(folder / "pareto.csv", pareto_csv(*pareto));
        core::write_file(folder / "pareto.html", pareto_html(*pareto, summary));
    }
}

}  // namespace fusee::report
