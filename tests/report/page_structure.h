#pragma once
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fusee/core/text.h"

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

/// The JSON with an id inside a page.
inline nlohmann::json data_of(const std::string& page, const std::string& id = "result") {
    const std::string open = "<script type=\"application/json\" id=\"" + id + "\">";
    const std::size_t at = page.find(open);
    if (at == std::string::npos) return nullptr;
    return nlohmann::json::parse(page.substr(at + open.size(), page.find("</script>", at) - at - open.size()));
}

/// A page that the browser draws from the JSON of its result: one file that loads nothing, with a summary for a reader without scripts.
inline void expect_shell(const std::string& page, const std::string& name, const std::string& json, const std::string& summary) {
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    expect_all(page, {("<body data-page=\"" + name + "\">").c_str(), "<noscript>", "<title>"});
    expect_none(page, {"src=", "<link", "<img"});
    EXPECT_EQ(data_of(page), nlohmann::json::parse(json));
    EXPECT_TRUE(holds(page, core::escape(summary))) << summary;
}

}  // namespace fusee::report
