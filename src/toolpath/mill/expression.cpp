#include "mill/expression.h"

#include <charconv>

namespace fusee::toolpath::mill {

namespace {

void skip_spaces(std::string_view& text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
}

bool take(std::string_view& text, char c) {
    skip_spaces(text);
    if (text.empty() || text.front() != c) return false;
    text.remove_prefix(1);
    return true;
}

bool take_product(std::string_view& text, const Parameters& parameters, double& value) {
    if (!take_value(text, parameters, value)) return false;
    for (;;) {
        const bool times = take(text, '*'), over = !times && take(text, '/');
        double next = 0.0;
        if (!times && !over) return true;
        if (!take_value(text, parameters, next)) return false;
        value = times ? value * next : value / next;
    }
}

bool take_sum(std::string_view& text, const Parameters& parameters, double& value) {
    if (!take_product(text, parameters, value)) return false;
    for (;;) {
        const bool plus = take(text, '+'), minus = !plus && take(text, '-');
        double next = 0.0;
        if (!plus && !minus) return true;
        if (!take_product(text, parameters, next)) return false;
        value += plus ? next : -next;
    }
}

}  // namespace

bool take_value(std::string_view& text, const Parameters& parameters, double& value) {
    skip_spaces(text);
    if (text.starts_with("-[") || text.starts_with("-#")) {
        text.remove_prefix(1);
        if (!take_value(text, parameters, value)) return false;
        value = -value;
        return true;
    }
    if (take(text, '[')) return take_sum(text, parameters, value) && take(text, ']');
    if (text.substr(0, 2) == "#<") {
        const std::size_t end = text.find('>');
        if (end == std::string_view::npos) return false;
        const auto found = parameters.find(std::string(text.substr(2, end - 2)));
        text.remove_prefix(end + 1);
        if (found == parameters.end()) return false;
        value = found->second;
        return true;
    }
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return true;
}

}  // namespace fusee::toolpath::mill
