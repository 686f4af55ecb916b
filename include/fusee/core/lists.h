#pragma once
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

}  // namespace fusee::core
