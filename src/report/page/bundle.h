#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Pages are drawn in the browser from the JSON of a result, by the scripts of web/ (docs/guides/add-a-page-section.md).
namespace fusee::report {

/// A JSON text inside a page; the script reads it by its id.
struct PageData {
    std::string id, json;
    bool compact = false;  ///< the text has no space between its words, and each letter is ASCII: it is embedded as it is
};
struct Page {
    std::string name;  ///< of the module in web/src/pages
    std::string title;
    std::string summary;         ///< for a reader without scripts
    std::vector<PageData> data;  ///< the result is "result"
    bool scene = false;          ///< it shows the joint in 3D
};
/// Gives a page the joint in 3D and its drawing along the axis, as compact JSON, and the script.
void add_joint(Page& page, std::string plan, std::string scene);
/// One file that opens offline, without a request. @pre each text of `data` is JSON
[[nodiscard]] std::string page_file(const Page& page);

/// The style sheet: light and dark, screen and paper.
[[nodiscard]] std::string_view style_sheet();

}  // namespace fusee::report
