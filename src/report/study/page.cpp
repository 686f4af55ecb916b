#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fusee/core/file.h"
#include "fusee/core/provenance.h"
#include "fusee/report/study.h"
#include "page/html.h"
#include "study/script.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json columns_json(const std::vector<study::Column>& columns) {
    Json all = Json::array();
    for (const study::Column& column : columns)
        all.push_back({{"name", column.name}, {"meaning", column.meaning}, {"text", column.is_text}});
    return all;
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

/// "</script>" inside a text must not end the script.
std::string inside_script(std::string json) {
    for (std::size_t at = 0; (at = json.find("</", at)) != std::string::npos; at += 3) json.replace(at, 2, "<\\/");
    return json;
}

}  // namespace

void write_study_page(const std::filesystem::path& file, const study::Study& study, const std::vector<study::Column>& columns,
                      const study::EachRow& rows) {
    Json data{{"columns", columns_json(columns)}, {"has_reports", study.outputs == study::Outputs::kAll}, {"rows", Json::array()}};
    std::size_t count = 0;
    rows([&](const study::Row& row) {
        if (count++ < kMostStudyRows) data["rows"].push_back(row_json(row, columns));
    });
    Head head{.kind = "fusee study",
              .title = study.name,
              .verdict = {},
              .sentence = counted(count, "design") + ".",
              .stamp = std::string("fusee ") + core::version(),
              .tiles = {}};
    if (count > kMostStudyRows)
        head.sentence += fmt::format(" This page shows the first {} of them; index.csv and index.sqlite hold all.", kMostStudyRows);
    const std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
    core::write_file(file, html_page(study.name, head,
                                     fmt::format("<style>{}</style>{}<script>{{const data={};{}}}</script>", study_style(), study_body(),
                                                 inside_script(json), study_script())));
}

}  // namespace fusee::report
