#include "guide_pdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <sstream>

#include "fusee/core/markup.h"
#include "fusee/render/svg.h"

namespace fusee::report {

namespace {

using core::coordinate;

constexpr double kWidth_mm = 210.0, kHeight_mm = 297.0, kMargin_mm = 18.0;  // A4
constexpr double kBody_mm = 3.1, kLetter = 0.602;                           // font size; width of a letter over it
constexpr double kLine = 1.5;                                               // from line to line, in font sizes
constexpr double kTable_mm = 2.7;                                           // font size of tables
constexpr std::size_t kGap = 2;                                             // letters between two columns
constexpr double kMostPicture_mm = 150.0;                                   // height

/// Letters of a size in one line.
std::size_t letters(double size_mm, double indent_mm = 0.0) {
    return static_cast<std::size_t>((kWidth_mm - 2.0 * kMargin_mm - indent_mm) / (kLetter * size_mm));
}

/// Words in lines of at most `most` letters; a longer word has a line of its own.
std::vector<std::string> wrap(const std::string& text, std::size_t most) {
    std::istringstream words(text);
    std::vector<std::string> lines(1);
    for (std::string word; words >> word;) {
        std::string& line = lines.back();
        if (line.empty())
            line = word;
        else if (line.size() + 1 + word.size() <= most)
            line += " " + word;
        else
            lines.push_back(word);
    }
    return lines;
}

/// Text without the marks of bold type, and links by their words.
std::string plain_text(std::string text) {
    for (std::size_t at = text.find("**"); at != std::string::npos; at = text.find("**")) text.erase(at, 2);
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](")) {
        text.erase(at, text.find(')', at) + 1 - at);
        text.erase(text.rfind('[', at), 1);
    }
    return text;
}

/// In letters, with the gap to the next one. @pre no row is longer than the first
std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows, std::size_t most) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size() + kGap);
    const auto whole = [&] { return std::accumulate(widths.begin(), widths.end(), std::size_t{0}); };
    while (whole() > most) {
        const auto widest = std::max_element(widths.begin(), widths.end());
        if (*widest <= kGap + 1) break;
        --*widest;
    }
    return widths;
}

/// Pages that are filled from above.
class Pages {
public:
    void text(const std::string& words, double size_mm, double indent_mm = 0.0, bool bold = false) {
        need(kLine * size_mm);
        y_ += kLine * size_mm;
        write(words, kMargin_mm + indent_mm, size_mm, bold);
    }
    void heading(const std::string& words, double size_mm) {
        need(4.0 * kLine * size_mm);  // not alone at the foot of a page
        space(1.2 * size_mm);
        text(words, size_mm, 0.0, true);
        space(0.4 * size_mm);
    }
    void paragraph(const std::string& words, const std::string& mark) {
        const double indent = mark.empty() ? 0.0 : 6.0;
        bool first = true;
        for (const std::string& line : wrap(words, letters(kBody_mm, indent))) {
            text(line, kBody_mm, indent);
            if (first && !mark.empty()) write(mark, kMargin_mm, kBody_mm, false);
            first = false;
        }
        space(0.5 * kBody_mm);
    }
    /// Columns as wide as their longest cell; where they do not fit, the longest ones are wrapped to the same width.
    void table(const std::vector<std::vector<std::string>>& rows) {
        const std::vector<std::size_t> widths = column_widths(rows, letters(kTable_mm));
        for (const auto& row : rows) {
            std::vector<std::vector<std::string>> columns;
            std::size_t lines = 1;
            for (std::size_t i = 0; i < row.size(); ++i) {
                columns.push_back(wrap(row[i], widths[i] - kGap));
                lines = std::max(lines, columns.back().size());
            }
            need(static_cast<double>(lines) * kLine * kTable_mm);
            for (std::size_t line = 0; line < lines; ++line) {
                y_ += kLine * kTable_mm;
                double x = kMargin_mm;
                for (std::size_t i = 0; i < columns.size(); x += static_cast<double>(widths[i++]) * kLetter * kTable_mm)
                    if (line < columns[i].size()) write(columns[i][line], x, kTable_mm, &row == &rows.front());
            }
        }
        space(kBody_mm);
    }
    /// @param svg with a viewBox, no wider than the page is then
    void picture(const std::string& svg) {
        const std::size_t from = svg.find("viewBox=\"") + 9, content = svg.find('>') + 1;
        const std::string box = svg.substr(from, svg.find('"', from) - from);
        double x = 0.0, y = 0.0, width = 1.0, height = 1.0;
        std::istringstream(box) >> x >> y >> width >> height;
        const double scale = std::min((kWidth_mm - 2.0 * kMargin_mm) / width, kMostPicture_mm / height);
        need(scale * height);
        pages_.back() += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{}\">{}", coordinate(kMargin_mm),
                                     coordinate(y_), coordinate(scale * width), coordinate(scale * height), box, svg.substr(content));
        y_ += scale * height + kBody_mm;
    }
    [[nodiscard]] std::vector<std::string> svgs(const std::string& title) const {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < pages_.size(); ++i)
            all.push_back(fmt::format(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\"><style>text{{font-family:'DejaVu Sans Mono','Liberation "
                "Mono','Courier New',monospace}}</style>{2}<text x=\"{3}\" y=\"{4}\" font-size=\"2.6\">{5}, page {6} of {7}"
                "</text></svg>",
                kWidth_mm, kHeight_mm, pages_[i], kMargin_mm, kHeight_mm - 0.5 * kMargin_mm, core::escape(title), i + 1, pages_.size()));
        return all;
    }

private:
    void write(const std::string& words, double x, double size_mm, bool bold) {
        pages_.back() += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}>{}</text>", coordinate(x), coordinate(y_),
                                     coordinate(size_mm), bold ? " font-weight=\"bold\"" : "", core::escape(words));
    }
    void need(double height_mm) {
        if (!pages_.empty() && y_ + height_mm <= kHeight_mm - kMargin_mm) return;
        pages_.emplace_back();
        y_ = kMargin_mm;
    }
    void space(double height_mm) { y_ += height_mm; }

    std::vector<std::string> pages_;
    double y_ = kHeight_mm;
};

std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> all;
    std::istringstream parts(row.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
        const std::size_t from = cell.find_first_not_of(' '), to = cell.find_last_not_of(' ');
        all.push_back(from == std::string::npos ? "" : plain_text(cell.substr(from, to + 1 - from)));
    }
    return all;
}

/// One block of Markdown: heading, table, picture, list item or paragraph.
struct Block {
    enum class Kind { kTitle, kHeading, kTable, kPicture, kText } kind = Kind::kText;
    std::string text, mark;  ///< of a list item: its mark
    std::vector<std::vector<std::string>> rows;
};

/// "1. " or "- " at the start of a line; else "".
std::string list_mark(const std::string& line) {
    const std::size_t digits = line.find_first_not_of("0123456789");
    if (digits != 0 && digits != std::string::npos && line.substr(digits, 2) == ". ") return line.substr(0, digits + 2);
    return line.starts_with("- ") ? "- " : "";
}

std::vector<Block> blocks_of(const std::string& markdown) {
    using Kind = Block::Kind;
    std::vector<Block> blocks;
    std::istringstream lines(markdown);
    bool open = false;  // the last block may continue
    for (std::string line; std::getline(lines, line);) {
        const bool table = line.starts_with("|");
        const std::string mark = list_mark(line);
        if (line.empty()) {
            open = false;
        } else if (line.starts_with("## ") || line.starts_with("# ")) {
            const bool title = line[1] == ' ';
            blocks.push_back({title ? Kind::kTitle : Kind::kHeading, line.substr(title ? 2 : 3), "", {}});
            open = false;
        } else if (line.starts_with("![")) {
            const std::size_t from = line.find('(') + 1;
            blocks.push_back({Kind::kPicture, line.substr(from, line.find(')') - from), "", {}});
        } else if (table && open && blocks.back().kind == Kind::kTable) {
            if (!line.starts_with("|--")) blocks.back().rows.push_back(cells(line));
        } else if (table) {
            blocks.push_back({Kind::kTable, "", "", {cells(line)}});
            open = true;
        } else if (open && mark.empty() && blocks.back().kind == Kind::kText) {
            blocks.back().text += " " + line;
        } else {
            blocks.push_back({Kind::kText, line.substr(mark.size()), mark, {}});
            open = true;
        }
    }
    return blocks;
}

}  // namespace

std::string guide_pdf(const std::string& markdown, const std::string& title, const std::map<std::string, std::string>& pictures) {
    Pages pages;
    for (const Block& block : blocks_of(markdown)) switch (block.kind) {
            case Block::Kind::kTitle:
                pages.heading(block.text, 5.5);
                break;
            case Block::Kind::kHeading:
                pages.heading(block.text, 4.0);
                break;
            case Block::Kind::kTable:
                pages.table(block.rows);
                break;
            case Block::Kind::kPicture:
                pages.picture(pictures.at(std::filesystem::path(block.text).stem().string()));
                break;
            case Block::Kind::kText:
                pages.paragraph(plain_text(block.text), block.mark);
        }
    return render::pdf_of_svgs(pages.svgs(title), kWidth_mm, kHeight_mm, title);
}

}  // namespace fusee::report
