#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

/// The structure of a page, so that tests do not depend on its prose.
namespace fusee::report {

inline bool holds(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

inline std::size_t occurrences(const std::string& text, const std::string& what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
    return n;
}

inline void expect_all(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_TRUE(holds(text, part)) << "'" << part << "' in\n" << text;
}
inline void expect_none(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts) EXPECT_FALSE(holds(text, part)) << part;
}

/// The texts of every element. @param name "h2", "li", ...
inline std::vector<std::string> elements(const std::string& html, const std::string& name) {
    std::vector<std::string> all;
    for (std::size_t at = html.find("<" + name); at != std::string::npos; at = html.find("<" + name, at + 1)) {
        const std::size_t begin = html.find('>', at) + 1, end = html.find("</" + name + ">", begin);
        std::string& text = all.emplace_back(html.substr(begin, end - begin));
        for (std::size_t tag = text.find('<'); tag != std::string::npos; tag = text.find('<'))
            text.erase(tag, text.find('>', tag) + 1 - tag);
    }
    return all;
}

/// The first tag that does not close the innermost open one; "" if all are balanced.
inline std::string first_unbalanced(const std::string& html) {
    std::vector<std::string> open;
    for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
        const std::string tag = html.substr(at + 1, html.find('>', at) - at - 1), name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag.starts_with("!") || tag.ends_with("/") || name == "meta" || name == "br") continue;
        if (!name.starts_with("/")) {
            open.push_back(name);
        } else {
            if (open.empty() || "/" + open.back() != name) return tag;
            open.pop_back();
        }
    }
    return open.empty() ? "" : open.back();
}

/// A page without its elements of this name: the bundled library is tested in a browser (tests/browser).
inline std::string without(std::string html, const std::string& name) {
    const std::string closing = "</" + name + ">";
    for (std::size_t at = html.find("<" + name + ">"); at != std::string::npos; at = html.find("<" + name + ">"))
        html.erase(at, html.find(closing, at) + closing.size() - at);
    return html;
}

/// A well-formed page that loads nothing and shows unknown figures as dashes.
inline void expect_page(const std::string& html) {
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    const std::string content = without(without(html, "style"), "script");
    EXPECT_EQ(first_unbalanced(content), "");
    expect_none(html, {"src=", "<link", "<img"});
    expect_none(content, {"http://", "https://", "url(", "@import", "<script", "<link", "<img", "src=", ">nan", "nan<", "nan to", "\"nan",
                          ">inf", "-inf", "inf\"", "inf "});
}

}  // namespace fusee::report
