#include "picture/standalone.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "data/figures.h"
#include "page/bundle.h"

namespace fusee::report {

namespace {

constexpr double kMargin = 12.0, kCaption = 22.0, kGap = 10.0;  // drawing units, as the charts'

/// The text between two marks, from `at` on; moves `at` behind the second one. npos in `at` if there is none.
std::string_view between(std::string_view text, std::string_view open, std::string_view close, std::size_t& at) {
    const std::size_t begin = text.find(open, at);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find(close, begin + open.size());
    if (end == std::string_view::npos) {
        at = end;
        return {};
    }
    at = end + close.size();
    return text.substr(begin + open.size(), end - begin - open.size());
}

using Colours = std::map<std::string, std::string>;

/// Adds "--name:value;" of a ":root{...}" block.
void read_variables(std::string_view block, Colours& colours) {
    for (std::size_t at = 0; (at = block.find("--", at)) != std::string_view::npos;) {
        const std::size_t colon = block.find(':', at), end = std::min(block.find_first_of(";}", at), block.size());
        if (colon > end) break;
        colours[std::string(block.substr(at, colon - at))] = std::string(block.substr(colon + 1, end - colon - 1));
        at = end;
    }
}

/// The colours of the style sheet: its first block, and for dark pages its second one over it.
Colours colours_of(std::string_view css, Theme theme) {
    Colours colours;
    std::size_t at = 0;
    read_variables(between(css, ":root{", "}", at), colours);
    if (theme == Theme::kDark) read_variables(between(css, ":root{", "}", at), colours);
    return colours;
}

std::string without_variables(std::string text, const Colours& colours) {
    for (std::size_t at = 0; (at = text.find("var(--", at)) != std::string::npos;) {
        const std::size_t end = text.find(')', at);
        if (end == std::string::npos) break;
        const auto known = colours.find(text.substr(at + 4, end - at - 4));
        text.replace(at, end - at + 1, known == colours.end() ? "currentColor" : known->second);
    }
    return text;
}

/// The rules of the style sheet for what charts draw: those of ".plot", curves, dots and bands.
std::string chart_style(std::string_view css) {
    std::string rules;
    for (const char* name : {".plot ", ".curve", ".dashed", ".dot", ".band", "svg text"})
        for (std::size_t at = 0; (at = css.find(name, at)) != std::string_view::npos;) {
            const std::size_t end = css.find('}', at);
            if (end == std::string_view::npos) break;
            if (at == 0 || css[at - 1] == '}' || css[at - 1] == '\n') rules += std::string(css.substr(at, end - at + 1));
            at = end;
        }
    return rules;
}

}  // namespace

std::string standalone(const std::vector<Figure>& figures, Theme theme) {
    const std::string_view css = style_sheet();
    const Colours colours = colours_of(css, theme);
    double width = 0.0, height = kMargin;
    std::string content;
    for (const Figure& figure : figures) {
        content += fmt::format("<text class=\"title\" x=\"{}\" y=\"{}\">{}</text><g transform=\"translate({} {})\">{}</g>\n", kMargin,
                               coordinate(height + 14.0), escape(figure.caption), kMargin, coordinate(height + kCaption), figure.content);
        width = std::max(width, figure.width + 2.0 * kMargin);
        height += kCaption + figure.height + kGap;
    }
    return without_variables(
        fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
                    "font-family=\"sans-serif\"><style>{2}.plot .title{{font-size:14px;font-weight:600;fill:var(--ink)}}</style>"
                    "<rect width=\"{0}\" height=\"{1}\" style=\"fill:var(--card)\"/><g class=\"plot\">\n{3}</g></svg>\n",
                    coordinate(width), coordinate(height), chart_style(css), content),
        colours);
}

}  // namespace fusee::report
