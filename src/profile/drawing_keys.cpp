#include "key.h"

namespace fusee::profile {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

std::vector<Key> drawing_keys() {
    return {
        text_line("drawing.owner", "legal owner, ISO 7200", FIELD(title.owner)),
        text_line("drawing.number", "identification number of the design; each part's has its name behind it: \"4711-k_se\"",
                  FIELD(title.number)),
        text_line("drawing.revision", "index of the revision", FIELD(title.revision)),
        text_line("drawing.date", "of issue, as it is to be printed; a drawing has no other date", FIELD(title.date)),
        text_line("drawing.created_by", "creator, ISO 7200", FIELD(title.created_by)),
        text_line("drawing.approved_by", "approval person, ISO 7200", FIELD(title.approved_by)),
    };
}

#undef FIELD

}  // namespace fusee::profile
