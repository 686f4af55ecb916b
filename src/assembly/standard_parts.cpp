#include <fmt/format.h>

#include <cmath>

#include "layout.h"

// Sizes of bought parts. Between the sizes of a table the model takes the nearest proportion.
namespace fusee::assembly {

namespace {

constexpr double kSame_mm = 0.05;

struct Size {
    double shaft_mm, outside_mm, width_mm;
};
/// Sintered sleeve bearings of ISO 2795 in usual stock (practice).
constexpr std::array kSleeves{Size{3, 6, 0},   Size{4, 8, 0},   Size{5, 9, 0},   Size{6, 10, 0}, Size{8, 12, 0},
                              Size{10, 16, 0}, Size{12, 18, 0}, Size{15, 21, 0}, Size{20, 26, 0}};
/// Set collars of DIN 705 A in usual stock (practice).
constexpr std::array kCollars{Size{3, 7, 5},    Size{4, 8, 5},    Size{5, 10, 6},   Size{6, 12, 8},  Size{8, 16, 8},
                              Size{10, 20, 10}, Size{12, 22, 12}, Size{15, 25, 12}, Size{20, 32, 14}};
/// Retaining rings of DIN 471: thickness (capitalbolts).
constexpr std::array kRings{Size{3, 0, 0.4}, Size{4, 0, 0.4}, Size{5, 0, 0.6}, Size{6, 0, 0.7}, Size{8, 0, 0.8},
                            Size{10, 0, 1},  Size{12, 0, 1},  Size{15, 0, 1},  Size{20, 0, 1.2}};

/// Support washers of DIN 988: outside diameter (practice).
constexpr std::array kWashers{Size{3, 6, 0},   Size{4, 8, 0},   Size{5, 10, 0},  Size{6, 12, 0}, Size{8, 14, 0},
                              Size{10, 16, 0}, Size{12, 18, 0}, Size{15, 21, 0}, Size{20, 28, 0}};

/// Deep-groove ball bearing of ISO 15.
struct Bearing {
    double shaft_mm, outside_mm, width_mm;
    const char* name;
    double rating;  ///< static, C0 (ISO 76) [N]: SKF, of 6001 NTN; 0: not read
};
/// The series of usual use.
constexpr std::array kBearings{Bearing{3, 10, 4, "623", 180},    Bearing{4, 13, 5, "624", 290},  Bearing{5, 16, 5, "625", 380},
                               Bearing{6, 19, 6, "626", 950},    Bearing{8, 22, 7, "608", 1370}, Bearing{10, 26, 8, "6000", 1960},
                               Bearing{12, 28, 8, "6001", 2390}, Bearing{15, 32, 9, "6002", 0},  Bearing{20, 42, 12, "6004", 0}};

template <class Row, std::size_t N>
const Row* find(const std::array<Row, N>& table, double shaft_mm) {
    for (const Row& row : table)
        if (std::abs(row.shaft_mm - shaft_mm) < kSame_mm) return &row;
    return nullptr;
}

}  // namespace

double sleeve_mm(double bore_mm) {
    const Size* size = find(kSleeves, bore_mm);
    return size ? size->outside_mm : bore_mm + 4.0;
}
Collar collar_of(double shaft_mm) {
    const Size* size = find(kCollars, shaft_mm);
    return size ? Collar{size->outside_mm, size->width_mm} : Collar{2.0 * shaft_mm, 1.3 * shaft_mm};
}
std::string bearing_of(double bore_mm) {
    const Bearing* bearing = find(kBearings, bore_mm);
    if (bearing == nullptr) return fmt::format("bore {:g} mm: none of the usual sizes", bore_mm);
    return fmt::format("ISO 15 {}, {:g} x {:g} x {:g} mm", bearing->name, bearing->shaft_mm, bearing->outside_mm, bearing->width_mm);
}
double bearing_rating(double bore_mm) {
    const Bearing* bearing = find(kBearings, bore_mm);
    return bearing ? bearing->rating : 0.0;
}
std::optional<double> bore_of_rating(double rating) {
    for (const Bearing& bearing : kBearings)
        if (bearing.rating >= rating) return bearing.shaft_mm;
    return std::nullopt;
}
double bearing_width_mm(double bore_mm) {
    const Bearing* bearing = find(kBearings, bore_mm);
    return bearing ? bearing->width_mm : std::max(4.0, 0.7 * bore_mm);
}
double bearing_seat_mm(double bore_mm) {
    const Bearing* bearing = find(kBearings, bore_mm);
    return bearing ? bearing->outside_mm : 2.0 * bore_mm + 6.0;
}
double washer_mm(double shaft_mm) {
    const Size* size = find(kWashers, shaft_mm);
    return size ? size->outside_mm : shaft_mm + 6.0;
}
int pin_length_mm(double most_mm) {
    constexpr std::array kLengths_mm{3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20, 24, 28, 32, 35, 40};  // ISO 2338
    const auto longer = std::find_if(kLengths_mm.begin(), kLengths_mm.end(), [&](int mm) { return mm > most_mm + kSame_mm; });
    return longer == kLengths_mm.begin() ? *longer : *(longer - 1);
}
std::string pin_of(double diameter_mm, double most_mm) {
    return fmt::format("ISO 2338, {:g} x {} mm", diameter_mm, pin_length_mm(most_mm));
}
double ring_mm(double shaft_mm) {
    const Size* size = find(kRings, shaft_mm);
    return size ? size->width_mm : 1.0;
}

}  // namespace fusee::assembly
