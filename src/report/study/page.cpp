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

Json to_json(const study::Figure& figure) {
    if (const auto* number = std::get_if<double>(&figure)) return std::isfinite(*number) ? Json(*number) : Json(nullptr);
    return std::get<std::string>(figure);
}

Json columns_json(const std::vector<study::Column>& columns) {
    Json all = Json::array();
    for (const study::Column& column : columns)
        all.push_back({{"name", column.name}, {"meaning", column.meaning}, {"text", column.is_text}});
    return all;
}

/// [name, [figures in the order of the columns], outline of K_SE, outline of K_PE]
Json row_json(const study::Row& row, const std::vector<study::Column>& columns) {
    std::map<std::string_view, const study::Figure*> known;
    for (const auto& [name, figure] : row.figures) known[name] = &figure;
    const auto value = [&](std::string_view name) {
        const auto found = known.find(name);
        return found != known.end() ? to_json(*found->second) : Json(nullptr);
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
    const std::string more =
        count > kMostStudyRows ? fmt::format(" This page shows the first {} of them; index.csv and index.sqlite hold all.", kMostStudyRows)
                               : "";
    const std::string json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
    core::write_file(
        file, fmt::format("<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title><style>{1}{2}</style></head>"
                          "<body><main><p class=\"eyebrow\">Study</p><h1>{0}</h1><p>{3} designs.{4}</p>{5}"
                          "<p class=\"stamp\">fusee {6}</p></main><script>const data={7};{8}</script></body></html>\n",
                          escape(study.name), style_sheet(), study_style(), count, more, study_body(), core::version(), inside_script(json),
                          study_script()));
}

}  // namespace fusee::report
