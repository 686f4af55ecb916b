#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "compare.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/units.h"

namespace fusee::readback {

namespace {

/// Reads G-code one line at a time: path of the nozzle along external perimeters.
class Reader {
public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void take(std::string_view line) {
        ++row_;
        if (const auto offset = value_after(line, "; fusee: z of the part = Z + ")) offset_ = offset;
        if (const auto z = value_after(line, ";Z:")) top_ = *z;
        if (const auto height = value_after(line, ";HEIGHT:")) height_ = *height;
        if (const auto width = value_after(line, ";WIDTH:")) width_ = *width;
        if (line.starts_with(";TYPE:")) outer_ = line == ";TYPE:External perimeter";
        const std::string_view command = line.substr(0, line.find(';'));
        const std::string_view name = command.substr(0, command.find(' '));
        for (const char* other : {"G2", "G3", "G20", "G91"})
            if (name == other) fail(fmt::format("{} is not understood here", other));
        if (name == "M82" || name == "M83") relative_ = name == "M83";
        if (name == "G92") filament_ = word(command, 'E').value_or(filament_);
        if (name == "G0" || name == "G1") move(command);
    }

    [[nodiscard]] Sliced done() && {
        if (!offset_) throw core::IoError(file_, "no line states the part's height: \"; fusee: z of the part = Z + ...\"");
        if (print_.outer.empty()) throw core::IoError(file_, "has no external perimeter (\";TYPE:External perimeter\")");
        for (BeadPoint& p : print_.outer) p.z_mm += *offset_;
        return std::move(print_);
    }

private:
    [[noreturn]] void fail(const std::string& why) const { throw core::IoError(fmt::format("{}:{}", file_, row_), why); }

    [[nodiscard]] std::optional<double> value_after(std::string_view line, std::string_view begin) const {
        return line.starts_with(begin) ? std::optional(number(line.substr(begin.size()))) : std::nullopt;
    }
    [[nodiscard]] double number(std::string_view text) const {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || !std::isfinite(value)) fail(fmt::format("\"{}\" is no number", text));
        return value;
    }
    [[nodiscard]] std::optional<double> word(std::string_view command, char letter) const {
        const std::size_t at = command.find(letter, 1);
        return at == std::string_view::npos ? std::nullopt : std::optional(number(command.substr(at + 1)));
    }

    void move(std::string_view command) {
        const Point from = here_;
        here_ = {word(command, 'X').value_or(here_[0]), word(command, 'Y').value_or(here_[1])};
        const std::optional<double> e = word(command, 'E');
        const bool lays = e && *e > (relative_ ? 0.0 : filament_) && here_ != from;
        if (e && !relative_) filament_ = *e;
        if (!lays || !outer_) return;
        if (!(height_ > 0.0 && width_ >= height_)) fail("needs a height and width of the bead before it, the width at least the height");
        for (const Point& p : {from, here_}) print_.outer.push_back({p, top_ - height_ / 2.0, width_, height_});
        print_.layer_mm = std::max(print_.layer_mm, height_);
    }

    std::string file_;
    std::size_t row_ = 0;
    Sliced print_;
    Point here_{};
    double top_ = 0.0, height_ = 0.0, width_ = 0.0, filament_ = 0.0;
    bool outer_ = false, relative_ = false;
    std::optional<double> offset_;
};

/// Height of the cable over the azimuth, where there is a cable.
class CableHeight {
public:
    /// Takes the same points of the floor as for a mesh, and sets the fields of `floor` that follow from the rows.
    CableHeight(const exchange::PartFile& part, Floor& floor) {
        floor = find_floor(
            [this](double azimuth, double z_mm) {
                places_.push_back({azimuth, z_mm});
                return std::nullopt;
            },
            part);
        planar_ = floor.planar;
        if (places_.front().azimuth > places_.back().azimuth) std::reverse(places_.begin(), places_.end());
    }

    /// The unwrapped azimuths of a point in that direction, each with the cable's height there.
    struct Place {
        double azimuth = 0.0, z_mm = 0.0;
    };
    [[nodiscard]] std::vector<Place> at(const Point& p) const {
        const double azimuth = std::atan2(p[1], p[0]);
        if (planar_) return {{azimuth, places_.front().z_mm}};
        std::vector<Place> found;
        const double low = places_.front().azimuth, high = places_.back().azimuth;
        for (double a = core::within_turn(azimuth, low); a <= high; a += core::kTurn) {
            const auto above =
                std::upper_bound(places_.begin() + 1, places_.end() - 1, a, [](double x, const Place& q) { return x < q.azimuth; });
            const Place &q = *above, &b = *(above - 1);
            found.push_back({a, b.z_mm + (q.z_mm - b.z_mm) * (a - b.azimuth) / (q.azimuth - b.azimuth)});
        }
        return found;
    }

private:
    std::vector<Place> places_;
    bool planar_ = true;
};

/// A round cable at a height of `off` over a bead's middle rests on the half circle at the bead's edge. Returns the distance of their
/// centrelines in the plane; nothing if they do not touch.
std::optional<double> reach(const BeadPoint& bead, double cable_mm, double off) {
    const double centres = (cable_mm + bead.height_mm) / 2.0;
    if (std::abs(off) >= centres) return std::nullopt;
    return (bead.width_mm - bead.height_mm) / 2.0 + std::sqrt(centres * centres - off * off);
}

}  // namespace

Sliced read_sliced(const std::filesystem::path& gcode) {
    const std::string text = core::read_file(gcode);
    Reader reader(gcode.string());
    for (const std::string_view line : core::pieces_of(text, "\n")) reader.take(line);
    return std::move(reader).done();
}

Floor sliced_floor(const Sliced& print, const exchange::PartFile& part) {
    Floor floor;
    const CableHeight cable(part, floor);
    for (const BeadPoint& bead : print.outer)
        for (const CableHeight::Place& place : cable.at(bead.xy_mm))
            if (const auto distance = reach(bead, part.cable_diameter_mm, place.z_mm - bead.z_mm)) {
                floor.points.push_back({bead.xy_mm, place.azimuth});
                floor.reach_mm.push_back(*distance);
            }
    return floor;
}

}  // namespace fusee::readback
