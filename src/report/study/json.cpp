#include "data/json.h"

#include "fusee/core/file.h"
#include "fusee/core/text.h"
#include "fusee/report/study.h"
#include "page/bundle.h"

namespace fusee::report {

namespace {

Json columns_json(const std::vector<study::Column>& columns) {
    return json_list(columns, [](const study::Column& column) {
        return Json{{"name", column.name}, {"meaning", column.meaning}, {"text", column.is_text}};
    });
}

/// [name, [figures in the order of the columns], outline of K_SE, outline of K_PE]
Json row_json(const study::Row& row, const std::vector<study::Column>& columns) {
    const auto value = [&row](std::string_view name) {
        const study::Figure* figure = row.find(name);
        return figure != nullptr ? std::visit([](const auto& known) { return Json(known); }, *figure) : Json(nullptr);  // NaN becomes null
    };
    Json figures = Json::array();
    for (const study::Column& column : columns) figures.push_back(value(column.name));
    return {row.name, std::move(figures), value("k_se_outline"), value("k_pe_outline")};
}

}  // namespace

void write_study_page(const std::filesystem::path& file, const study::Study& study, const std::vector<study::Column>& columns,
                      const study::EachRow& rows) {
    Json data{{"fusee", core::version()},
              {"name", study.name},
              {"columns", columns_json(columns)},
              {"has_reports", study.outputs == study::Outputs::kAll},
              {"count", 0},
              {"rows", Json::array()}};
    std::size_t count = 0;
    rows([&](const study::Row& row) {
        if (count++ < kMostStudyRows) data["rows"].push_back(row_json(row, columns));
    });
    data["count"] = count;
    const std::string summary = core::counted(count, "design") + "; index.csv and index.sqlite hold all.";
    core::write_file(file, page_file({"study", study.name, summary, {{"result", json_text(std::move(data))}}}));
}

}  // namespace fusee::report
