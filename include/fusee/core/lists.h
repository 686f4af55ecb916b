#pragma once
#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

/// What is done with the rows of any list or table.
namespace fusee::core {

/// The first row whose `member` equals `value`, such as that of a name; nullptr if there is none.
template <class List, class Member, class Value>
[[nodiscard]] constexpr auto find_by(List& list, Member member, const Value& value) -> decltype(&*std::begin(list)) {
    for (auto& row : list)
        if (std::invoke(member, row) == value) return &row;
    return nullptr;
}

/// The lists, one after another.
template <class Row, class... More>
[[nodiscard]] std::vector<Row> joined(std::vector<Row> list, More... more) {
    (list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end())), ...);
    return list;
}

/// A value of each row, all of one type.
template <class Value, class List, class Of>
[[nodiscard]] std::vector<Value> each(const List& list, Of of) {
    std::vector<Value> values;
    values.reserve(std::size(list));
    for (const auto& row : list) values.emplace_back(std::invoke(of, row));
    return values;
}

/// The rows in rising order, equal ones once.
template <class Row>
[[nodiscard]] std::vector<Row> sorted_unique(std::vector<Row> list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

/// The word of each row, with `between` in between.
template <class List, class Word = std::identity>
[[nodiscard]] std::string listed(const List& list, Word word = {}, std::string_view between = ", ") {
    std::string text;
    for (const auto& row : list) {
        if (!text.empty()) text += between;
        text += std::invoke(word, row);
    }
    return text;
}

/// The pieces of a text between separators; a separator at its end has none behind it. @pre the text outlives pieces that are views
template <class Piece = std::string_view>
[[nodiscard]] std::vector<Piece> pieces_of(std::string_view text, std::string_view separator) {
    std::vector<Piece> pieces;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        pieces.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + separator.size(), text.size()));
    }
    return pieces;
}

}  // namespace fusee::core
