#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/read_back.h"
#include "swept.h"
#include "words.h"

namespace fusee::toolpath {

namespace {

constexpr double kBelow_mm = 1e-3;      // a shallower move does not count as a cut
constexpr double kTurnStep_deg = 0.25;  // a rotary move's chord: 30 mm (0.0044)^2/8 = 7e-5 mm

/// A half plate as it lies on the machine.
struct PlateFrame {
    std::string name;
    double x = 0.0;
    bool turned = false;
    [[nodiscard]] std::array<double, 3> body(const Pose& p) const { return {p.x - x, turned ? -p.y : p.y, 0.0}; }
};

/// Just below the stock's top the cutter has removed everything that it passed at any depth: there the groove's floor is exposed.
std::vector<Capsule> discs(const Interpreted& program, std::size_t first, std::size_t last, const PlateFrame& frame, double radius) {
    std::vector<Capsule> capsules;
    for (std::size_t i = first; i < last; ++i) {
        const Move& move = program.moves[i];
        if (!move.rapid && std::min(move.from.z, move.to.z) < -kBelow_mm)
            capsules.push_back({frame.body(move.from), frame.body(move.to), radius});
    }
    return capsules;
}

/// Centre of the nose in the body frame: the part is turned back by A; x of the body is the spindle's direction, y against the machine's.
std::array<double, 3> nose_centre(const Pose& tip, double nose, double sign) {
    const double back = -sign * core::rad_from_deg(tip.a), u = tip.z + nose, v = -tip.y;
    return {u * std::cos(back) - v * std::sin(back), u * std::sin(back) + v * std::cos(back), tip.x};
}

std::vector<Capsule> noses(const Interpreted& program, double nose, double sign) {
    std::vector<Capsule> capsules;
    for (const Move& move : program.moves) {
        if (move.rapid) continue;
        const int steps = 1 + static_cast<int>(std::abs(move.to.a - move.from.a) / kTurnStep_deg);
        const auto at = [&](int i) {
            const double s = static_cast<double>(i) / steps;
            const Pose &p = move.from, &q = move.to;
            return nose_centre({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z), p.a + s * (q.a - p.a)}, nose, sign);
        };
        for (int i = 0; i < steps; ++i) capsules.push_back({at(i), at(i + 1), nose});
    }
    return capsules;
}

std::vector<std::string> require_words(const Interpreted& program, const std::string& begin, std::size_t count) {
    auto words = find_words(program, begin, count);
    if (words.empty()) throw core::IoError(program.file, "no comment that begins with \"" + begin + "\" says what is cut");
    return words;
}

}  // namespace

std::optional<double> CutFloor::radius(double azimuth, double z_mm) const { return swept_->floor(azimuth, z_mm); }

std::vector<CutFloor> cut_floors(const Interpreted& program) {
    const std::string cuts = require_words(program, "cuts", 2)[1];
    const double radius = 0.5 * number_in(program, require_words(program, "cutter", 3), 2);
    std::vector<CutFloor> floors;
    if (cuts == "wrap") {
        const double sign = number_in(program, require_words(program, "rotary", 2), 1);
        floors.push_back(CutFloor("wrap", std::make_shared<CutFloor::Swept>(noses(program, radius, sign))));
    } else if (cuts == "floor") {
        std::vector<std::pair<std::size_t, PlateFrame>> plates;
        for (const Note& note : program.notes)
            if (const auto w = core::words_of(note.text); w.size() == 5 && w[0] == "plate" && w[2] == "at")
                plates.emplace_back(note.before, PlateFrame{w[1], number_in(program, w, 3), w[4] == "turned"});
        for (std::size_t i = 0; i < plates.size(); ++i) {
            const std::size_t last = i + 1 < plates.size() ? plates[i + 1].first : program.moves.size();
            const PlateFrame& frame = plates[i].second;
            floors.push_back(CutFloor(frame.name, std::make_shared<CutFloor::Swept>(discs(program, plates[i].first, last, frame, radius))));
        }
    }
    return floors;
}

}  // namespace fusee::toolpath
