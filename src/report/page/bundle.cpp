#include "page/bundle.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "fusee/core/text.h"

// The assembler copies the files: compiling them as C++ literals takes seconds. FUSEE_WEB is the folder of the files.
#define FUSEE_EMBED(name, file)                                                                                     \
    asm(".pushsection .rodata\n" #name "_begin:\n.incbin \"" FUSEE_WEB "/" file "\"\n" #name "_end:\n.popsection"); \
    extern "C" const char name##_begin[] __attribute__((visibility("hidden")));                                     \
    extern "C" const char name##_end[] __attribute__((visibility("hidden")))

FUSEE_EMBED(fusee_shell_html, "src/shell.html");
FUSEE_EMBED(fusee_page_js, "built/page.js");
FUSEE_EMBED(fusee_page_css, "built/page.css");
FUSEE_EMBED(fusee_joint_js, "built/joint.js");
FUSEE_EMBED(fusee_joint_css, "built/joint.css");

namespace fusee::report {

namespace {

/// Adds JSON as a script element: no text ends the element, and each letter is ASCII.
void embed(std::string& out, const PageData& data) {
    using Json = nlohmann::ordered_json;
    const std::string text = data.compact ? "" : Json::parse(data.json).dump(-1, ' ', true, Json::error_handler_t::replace);
    out += "<script type=\"application/json\" id=\"" + data.id + "\">";
    for (const char c : data.compact ? data.json : text) c == '<' ? out += "\\u003c" : out += c;
    out += "</script>\n";
}

using Pieces = std::vector<std::string_view>;

/// The template with a text for each "{name}".
std::string filled(std::string_view form, const std::vector<std::pair<std::string_view, Pieces>>& texts) {
    std::string out;
    std::size_t size = form.size();
    for (const auto& [name, text] : texts)
        for (const std::string_view piece : text) size += piece.size();
    out.reserve(size);
    for (std::size_t at = 0; at < form.size();) {
        const std::size_t open = std::min(form.find('{', at), form.size()), close = form.find('}', open);
        out += form.substr(at, open - at);
        if (open == form.size()) break;
        for (const auto& [name, text] : texts)
            if (form.substr(open + 1, close - open - 1) == name)
                for (const std::string_view piece : text) out += piece;
        at = close + 1;
    }
    return out;
}

/// The scripts of every page, where `fusee.plot` is uPlot, then those of the joint in 3D.
Pieces scripts(bool scene) {
    Pieces all{"<script>", {fusee_page_js_begin, fusee_page_js_end}, "</script>\n"};
    if (scene)
        all.insert(all.end(), {"<style>",
                               {fusee_joint_css_begin, fusee_joint_css_end},
                               "</style><script>",
                               {fusee_joint_js_begin, fusee_joint_js_end},
                               "</script>\n"});
    return all;
}

}  // namespace

std::string_view style_sheet() { return {fusee_page_css_begin, fusee_page_css_end}; }

void add_joint(Page& page, std::string plan, std::string scene) {
    page.data.push_back({"plan", std::move(plan), true});
    page.data.push_back({"joint-scene", std::move(scene), true});
    page.scene = true;
}

std::string page_file(const Page& page) {
    std::string data;
    for (const PageData& one : page.data) embed(data, one);
    const std::string title = core::escape(page.title), summary = core::escape(page.summary);
    return filled({fusee_shell_html_begin, fusee_shell_html_end}, {{"title", {title}},
                                                                   {"page", {page.name}},
                                                                   {"style", {style_sheet()}},
                                                                   {"summary", {summary}},
                                                                   {"data", {data}},
                                                                   {"script", scripts(page.scene)}});
}

}  // namespace fusee::report
