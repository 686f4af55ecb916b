#pragma once
#include <map>
#include <string>

namespace fusee::report {

/// A4 pages of a guide in Markdown: headings, paragraphs, lists, tables and pictures, nothing else. @param pictures SVGs by the names of
/// their files without ending @pre every picture of the text is among them @throws core::IoError
[[nodiscard]] std::string guide_pdf(const std::string& markdown, const std::string& title,
                                    const std::map<std::string, std::string>& pictures);

}  // namespace fusee::report
