#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <string_view>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/kept.h"
#include "fusee/exchange/dxf.h"

namespace fusee::exchange {

namespace {

/// Collects the entities that dxflib finds in a drawing.
class Collector : public DL_CreationAdapter {
public:
    explicit Collector(const std::filesystem::path& path) : path_(path) {}

    void addComment(const std::string& text) override {
        if (drawing.provenance.empty()) drawing.provenance = text;
    }
    void setVariableInt(const std::string& key, int value, int) override {
        if (key == "$INSUNITS") units = value;
    }
    void addLayer(const DL_LayerData& data) override {
        if (data.name != "0") layer(data.name);
    }
    void addPolyline(const DL_PolylineData& data) override {
        finish();
        layer(attributes.getLayer()).polylines.push_back({{}, (data.flags & 1) != 0});
        open_ = attributes.getLayer();
        awaited_ = data.number;
    }
    void addVertex(const DL_VertexData& v) override {
        if (!open_.empty()) layer(open_).polylines.back().points_mm.push_back(point(v.x, v.y));
    }
    void addSpline(const DL_SplineData& data) override {
        finish();
        layer(attributes.getLayer()).splines.push_back({static_cast<int>(data.degree), {}, {}});
        spline_ = attributes.getLayer();
        knots_ = data.nKnots;
        poles_ = data.nControl;
    }
    void addKnot(const DL_KnotData& knot) override {
        if (!spline_.empty()) layer(spline_).splines.back().knots.push_back(point(knot.k, 0.0)[0]);
    }
    void addControlPoint(const DL_ControlPointData& p) override {
        if (!spline_.empty()) layer(spline_).splines.back().control_mm.push_back(point(p.x, p.y));
    }
    void addCircle(const DL_CircleData& c) override {
        require_radius(c.radius);
        layer(attributes.getLayer()).circles.push_back({point(c.cx, c.cy), c.radius});
    }
    void addArc(const DL_ArcData& a) override {
        require_radius(a.radius);
        const Vec2 angles = point(a.angle1, a.angle2);
        layer(attributes.getLayer()).arcs.push_back({point(a.cx, a.cy), a.radius, angles[0], angles[1]});
    }
    void addLine(const DL_LineData& l) override { layer(attributes.getLayer()).lines.push_back({point(l.x1, l.y1), point(l.x2, l.y2)}); }

    /// The last polyline or spline is complete when the file ends or the next one begins. @throws IoError if a part of it is missing
    void finish() {
        if (!spline_.empty()) {
            const brep::PlaneSpline& s = layer(spline_).splines.back();
            // dxflib replaces missing values by zeros.
            const bool whole = s.knots.size() == knots_ && s.control_mm.size() == poles_ && std::is_sorted(s.knots.begin(), s.knots.end());
            if (!whole || s.degree < 1 || knots_ != poles_ + static_cast<unsigned>(s.degree) + 1U)
                throw core::IoError(path_.string(), fmt::format("layer {}: a spline lacks knots or control points", spline_));
        }
        spline_.clear();
        if (!open_.empty() && layer(open_).polylines.back().points_mm.size() != static_cast<std::size_t>(awaited_))
            throw core::IoError(path_.string(), fmt::format("layer {}: a polyline lacks vertices", open_));
        open_.clear();
    }

    DxfDrawing drawing;
    int units = 0;

private:
    DxfLayer& layer(const std::string& name) {
        auto& layers = drawing.layers;
        const auto found = std::find_if(layers.begin(), layers.end(), [&](const DxfLayer& l) { return l.name == name; });
        return found == layers.end() ? layers.emplace_back(DxfLayer{name, {}, {}}) : *found;
    }
    void require_radius(double radius) const {
        if (!(radius > 0.0)) throw core::IoError(path_.string(), "contains a circle with a radius that is not above 0");
    }
    [[nodiscard]] Vec2 point(double x, double y) const {
        if (!std::isfinite(x) || !std::isfinite(y)) throw core::IoError(path_.string(), "contains a coordinate that is not finite");
        return {x, y};
    }

    std::filesystem::path path_;
    std::string open_;  ///< layer of the polyline whose vertices follow
    int awaited_ = 0;
    std::string spline_;  ///< layer of the spline whose knots and control points follow
    unsigned knots_ = 0, poles_ = 0;
};

/// Group codes of the numbers of parts for which dxflib takes memory.
bool counts_parts(std::string_view entity, long code) {
    if (entity == "SPLINE") return code == 72 || code == 73 || code == 74;  // knots, control points, fit points
    if (entity == "LWPOLYLINE") return code == 90;                          // vertices
    return (entity == "LEADER" && code == 76) || (entity == "HATCH" && (code == 91 || code == 93));
}

constexpr std::size_t kLongestLine =
    1023;  // dxflib does not end on a longer one: its getline fails and its loop waits for the end of the file

/// What dxflib does not survive is refused first. It takes memory for as many knots, points and vertices as an entity states before it
/// reads one of them: each takes lines of its own. As dxflib does, a group code is what the line begins with, and 0 if that is no number.
void require_readable(const std::string& bytes, const std::filesystem::path& path) {
    const auto lines = std::count(bytes.begin(), bytes.end(), '\n') + 1;
    std::istringstream in(bytes);
    std::string entity, text;
    long code = -1;  // of the line before
    for (long line = 1; std::getline(in, text); ++line) {
        if (text.size() >= kLongestLine)
            throw core::IoError(path.string(),
                                fmt::format("line {}: {} characters, at most {} are allowed", line, text.size(), kLongestLine - 1));
        text.erase(text.find_last_not_of(" \t\r") + 1);
        text.erase(0, text.find_first_not_of(" \t"));
        const long number = std::strtol(text.c_str(), nullptr, 10);
        if (code == 0 && !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0) entity = text;
        if (counts_parts(entity, code) && (number < 0 || number > lines))
            throw core::IoError(path.string(), fmt::format("line {}: a {} of {} parts in a file of {} lines", line, entity, text, lines));
        code = number;
    }
}

/// dxflib counts lines in one variable for all readers.
void collect(const std::string& bytes, Collector& collector) {
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    std::istringstream in(bytes);
    in.imbue(std::locale::classic());
    DL_Dxf().in(in, &collector);
}

DxfDrawing drawing_of(const std::string& bytes, const std::filesystem::path& path) {
    // dxflib treats the end of the stream as the end of the drawing: only the last group shows that the file is complete.
    const std::size_t end = bytes.find_last_not_of(" \r\n");
    if (end == std::string::npos || end < 2 || bytes.compare(end - 2, 3, "EOF") != 0)
        throw core::IoError(path.string(), "is not a DXF file or is cut short: EOF is missing");
    require_readable(bytes, path);
    Collector collector(path);
    collect(bytes, collector);
    collector.finish();
    if (collector.units != 4) throw core::IoError(path.string(), fmt::format("$INSUNITS is {}, not 4 (millimetres)", collector.units));
    return std::move(collector.drawing);
}

}  // namespace

// What dxflib found in the same bytes behind fusee's stamp, the comment in the first two lines, is taken over.
DxfDrawing read_dxf(const std::filesystem::path& path) {
    constexpr std::size_t kFiles = 8, kMostBytes = 1 << 20;
    static core::Kept<std::string, DxfDrawing> files(kFiles);
    constexpr std::string_view kComment = "999\n";
    const std::string bytes = core::read_file(path);
    const std::size_t end = bytes.starts_with(kComment) ? bytes.find('\n', kComment.size()) : std::string::npos;
    if (end == std::string::npos || end == kComment.size()) return drawing_of(bytes, path);
    std::string unstamped = bytes.substr(end);
    if (auto known = files.find(unstamped)) {
        known->provenance = bytes.substr(kComment.size(), end - kComment.size());
        return std::move(*known);
    }
    DxfDrawing drawing = drawing_of(bytes, path);
    if (unstamped.size() <= kMostBytes) files.keep(std::move(unstamped), drawing);
    return drawing;
}

}  // namespace fusee::exchange
