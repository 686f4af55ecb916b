#pragma once
#include <gtest/gtest.h>

#include <regex>
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

/// The contents of every element, without tags. @param name "h2", "li", ...
inline std::vector<std::string> elements(const std::string& html, const std::string& name) {
    std::vector<std::string> all;
    const std::string close = "</" + name + ">";
    for (std::size_t at = html.find("<" + name); at != std::string::npos; at = html.find("<" + name, at + 1)) {
        const std::size_t begin = html.find('>', at) + 1, end = html.find(close, begin);
        all.push_back(std::regex_replace(html.substr(begin, end - begin), std::regex("<[^>]*>"), ""));
    }
    return all;
}

/// The first tag that does not close the innermost open one; "" if all are balanced.
inline std::string first_unbalanced(const std::string& html) {
    static const std::regex kTag("<(/?)([a-zA-Z0-9]+)([^<>]*?)(/?)>");
    std::vector<std::string> open;
    for (auto it = std::sregex_iterator(html.begin(), html.end(), kTag); it != std::sregex_iterator(); ++it) {
        const std::string name = (*it)[2];
        if ((*it)[4].length() > 0 || name == "meta" || name == "br") continue;
        if ((*it)[1].length() == 0) {
            open.push_back(name);
        } else {
            if (open.empty() || open.back() != name) return (*it)[0];
            open.pop_back();
        }
    }
    return open.empty() ? "" : open.back();
}

/// A well-formed page that loads nothing and shows unknown figures as dashes.
inline void expect_page(const std::string& html) {
    EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
    const auto begin = html.find("<style>"), end = html.find("</style>");
    EXPECT_EQ(first_unbalanced(html.substr(0, begin) + html.substr(end + 8)), "");
    expect_none(html, {"http://", "https://", "url(", "@import", "<script", "<link", "<img", "src=", ">nan", "nan<", "nan to", "\"nan",
                       ">inf", "-inf", "inf\"", "inf "});
}

}  // namespace fusee::report
