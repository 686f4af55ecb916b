#include "fusee/core/change.h"

#include <regex>

namespace fusee::core {

std::vector<Changes> suggested_changes(std::string_view suggestion) {
    static const std::regex change(R"re(\b([a-z]\w*(?:\.\w+)+) = (-?\d+(?:\.\d+)?(?:e[-+]?\d+)?|"[^"]*"|\[[^\]]*\]))re");
    static const std::regex other(R"(, or | \(or )");
    std::vector<Changes> alternatives;
    std::cregex_iterator at(suggestion.data(), suggestion.data() + suggestion.size(), change), end;
    for (; at != end; ++at) {
        const std::string between = at->prefix();
        if (alternatives.empty() || std::regex_search(between, other)) alternatives.emplace_back();
        alternatives.back().push_back({(*at)[1], (*at)[2]});
    }
    return alternatives;
}

}  // namespace fusee::core
