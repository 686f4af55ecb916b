#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "page/html.h"

namespace fusee::report {

std::string power_section(const diagnosis::Diagnosis& diagnosis) {
    if (diagnosis.power.empty()) return "";
    std::vector<diagnosis::Power> power = diagnosis.power;
    std::stable_partition(power.begin(), power.end(), [](const diagnosis::Power& own) { return !own.shown; });
    Rows rows;
    for (const diagnosis::Power& own : power) {
        const diagnosis::Parameter least = for_reading({own.least, {}, own.unit}), usual = for_reading({own.usual, {}, own.unit});
        rows.push_back({plain(cause_name(own.cause)), num(least.value, 2), num(usual.value, 2), plain(usual.unit),
                        {own.shown ? "yes" : "<b>no</b>", ""}});
    }
    const auto unseen = std::count_if(power.begin(), power.end(), [](const diagnosis::Power& own) { return !own.shown; });
    return folded_section("What these rows would have shown", fmt::format("{} of {} causes at their usual size", power.size() - static_cast<std::size_t>(unseen), power.size()),
                          paragraph("The size of each cause that would have been named in 95 of 100 cases: the least one; of a limit, as "
                                    "a stop, the greatest. A cause of a smaller size may be there.") +
                              dense_table("Size of each cause that would have been named", {"cause", "size", "usual", "unit", "shown"}, rows));
}

}  // namespace fusee::report
