#include <algorithm>
#include <array>
#include <cstring>

#include "fusee/exchange/part_file.h"
#include "stl_bytes.h"

namespace fusee::exchange {

namespace {

template <std::size_t N>
bool reflected(std::array<double, N> image, const std::array<double, N>& p) {
    image[1] = -image[1];
    return image == p;
}

bool reflected(const PartGuide& image, const PartGuide& guide) {
    const bool same_sizes = image.kind == guide.kind && image.radius_mm == guide.radius_mm && image.z_mm == guide.z_mm &&
                            image.offset_mm == guide.offset_mm && image.start_mm == guide.start_mm && image.arm_mm == guide.arm_mm &&
                            image.lever_mm == guide.lever_mm && image.spring_mm == guide.spring_mm;
    const bool other_side = (guide.kind != "idler" && guide.kind != "arm") || image.sense == -guide.sense;
    return same_sizes && other_side && reflected(image.direction, guide.direction) && reflected(image.position_mm, guide.position_mm);
}

bool reflected(const TargetRow& image, const TargetRow& row) {
    return image.angle_rad == row.angle_rad && image.arm_mm == row.arm_mm && image.load == row.load && image.lift_mm == row.lift_mm &&
           image.stretch_mm == row.stretch_mm && reflected(image.contact_mm, row.contact_mm);
}

using Float3 = std::array<float, 3>;

struct StlTriangle {
    Float3 normal, a, b, c;
    std::array<char, 2> attribute;

    explicit StlTriangle(const char* bytes) {
        for (Float3* each : {&normal, &a, &b, &c}) {
            std::memcpy(each->data(), bytes, sizeof *each);
            bytes += sizeof *each;
        }
        std::memcpy(attribute.data(), bytes, attribute.size());
    }
};

bool reflected(const Float3& image, const Float3& p) { return image[0] == p[0] && image[1] == -p[1] && image[2] == p[2]; }

bool reflected(const StlTriangle& image, const StlTriangle& t) {
    return reflected(image.normal, t.normal) && reflected(image.a, t.a) && reflected(image.b, t.c) && reflected(image.c, t.b) &&
           image.attribute == t.attribute;
}

}  // namespace

bool is_mirror_image(const PartFile& image, const PartFile& part) {
    const bool same = image.part == part.part && image.cable_diameter_mm == part.cable_diameter_mm &&
                      image.spring_kind == part.spring_kind && image.spring_rate == part.spring_rate &&
                      image.spring_preload == part.spring_preload && !image.compensated && !part.compensated;
    return same && image.rotation_sign == -part.rotation_sign && image.torque_sign == -part.torque_sign &&
           reflected(image.guide, part.guide) &&
           std::equal(image.target.begin(), image.target.end(), part.target.begin(), part.target.end(),
                      [](const TargetRow& a, const TargetRow& b) { return reflected(a, b); });
}

bool is_mirrored_stl(std::string_view image, std::string_view stl) {
    constexpr std::size_t kBegin = kStlHeader + 4;
    if (stl.size() < kBegin || image.size() != stl.size() || (stl.size() - kBegin) % kStlTriangle != 0) return false;
    if (image.substr(kStlHeader, 4) != stl.substr(kStlHeader, 4)) return false;  // the count
    for (std::size_t at = kBegin; at < stl.size(); at += kStlTriangle)
        if (!reflected(StlTriangle(image.data() + at), StlTriangle(stl.data() + at))) return false;
    return true;
}

}  // namespace fusee::exchange
