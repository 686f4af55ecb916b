#include <fmt/format.h>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "page/html.h"

namespace fusee::report {

std::string transfer_section(const diagnosis::Diagnosis& diagnosis) {
    if (diagnosis.transfer.empty()) return "";
    Rows rows;
    for (const diagnosis::Transfer& t : diagnosis.transfer) {
        const bool falls = t.heldout_after < t.heldout_before;
        std::string sizes;
        for (const diagnosis::Parameter& p : t.parameters) sizes += (sizes.empty() ? "" : ", ") + amount(for_reading(p));
        rows.push_back({num(causes_name(t.effects)),
                        num(sizes),
                        plain(t.fitted + ": " + change(t.fit_before, t.fit_after)),
                        plain(t.heldout + ": " + change(t.heldout_before, t.heldout_after)),
                        {falls ? "better" : "<b>worse</b>", ""}});
    }
    return section("Does it transfer",
                   paragraph(fmt::format("Each effect fitted on one part of the files and applied to the file that is held out: root mean "
                                         "square error in {}, before \u2192 after. A false cause fits its own file and worsens the other.",
                                         diagnosis.transfer.front().unit)) +
                       html_table("Error on the files of the fit and on the held-out file",
                                  {"effects", "size", "fitted to", "held out", "held out is"}, rows));
}

}  // namespace fusee::report
