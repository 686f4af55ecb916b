#include "fusee/core/file.h"
#include "fusee/report/paper.h"
#include "fusee/report/simulation.h"

namespace fusee::report {

namespace fs = std::filesystem;

void write_paper(const Paper& paper, const fs::path& folder) {
    const auto write = [&folder](const char* name, const std::string& bytes) { core::write_file(folder / name, bytes); };
    write("figure_1.csv", figure_1_csv(paper.figure_1));
    write("figure_2.csv", figure_2_csv(paper.figure_2));
    write("figure_2_passive.csv", figure_2_passive_csv(paper.figure_2));
    if (paper.table_1.simulation.path) write("figure_6.csv", figure_6_csv(*paper.table_1.simulation.path));
    write("figure_8.csv", figure_8_csv(paper.figure_8));
    write("figure_9.csv", figure_9_csv(paper.figure_9.costs));
    write("figure_9_springs.csv", figure_9_springs_csv(paper.figure_9.found));
    write("figure_9_arms.csv", figure_9_arms_csv(paper.figure_9.cams));
    write("table_1.csv", table_csv(paper.table_1));
    write("table_2.csv", table_csv(paper.table_2));
    write("relatives.csv", relatives_csv(paper.relatives));
    write("paper.json", paper_json(paper));
    write("paper.html", paper_html(paper));
}

}  // namespace fusee::report
