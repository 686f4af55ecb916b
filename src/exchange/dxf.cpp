#include "fusee/exchange/dxf.h"

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
#include "fusee/core/lists.h"

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
        DxfLayer* found = core::find_by(drawing.layers, &DxfLayer::name, name);
        return found == nullptr ? drawing.layers.emplace_back(DxfLayer{name, {}, {}}) : *found;
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

/// Collects the file in memory, so that it is written at once. Prints numbers itself: dxflib uses printf, which depends on the locale.
class MemoryWriter : public DL_WriterA {
public:
    MemoryWriter() : DL_WriterA("/dev/null", DL_Codes::AC1015) {}
    void dxfReal(int code, double value) const override { put(code, fmt::format("{}", value)); }
    void dxfInt(int code, int value) const override { put(code, fmt::format("{}", value)); }
    void dxfHex(int code, int value) const override { put(code, fmt::format("{:X}", value)); }
    void dxfString(int code, const char* value) const override { put(code, value); }
    void dxfString(int code, const std::string& value) const override { put(code, value); }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    void put(int code, std::string_view value) const { bytes_ += fmt::format("{:>3}\n{}\n", code, value); }
    mutable std::string bytes_;
};

constexpr int kPlanar = 8;  // flag of a SPLINE

/// The empty tables that R2000 requires before and after the layers.
void write_tables(DL_Dxf& dxf, MemoryWriter& out, const DxfDrawing& drawing) {
    out.sectionTables();
    dxf.writeVPort(out);
    out.tableLinetypes(3);
    for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"}) dxf.writeLinetype(out, DL_LinetypeData(name, name, 0, 0, 0.0));
    out.tableEnd();
    out.tableLayers(static_cast<int>(drawing.layers.size()) + 1);
    const DL_Attributes look("", 7, 25, "CONTINUOUS", 1.0);  // colour 7 (black or white), line width 0.25 mm
    dxf.writeLayer(out, DL_LayerData("0", 0), look);
    for (const DxfLayer& layer : drawing.layers) dxf.writeLayer(out, DL_LayerData(layer.name, 0), look);
    out.tableEnd();
    out.tableStyle(1);
    dxf.writeStyle(out, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
    out.tableEnd();
    dxf.writeView(out);
    dxf.writeUcs(out);
    out.tableAppid(1);
    dxf.writeAppid(out, "ACAD");
    out.tableEnd();
    dxf.writeDimStyle(out, 1, 1, 1, 1, 1);
    dxf.writeBlockRecord(out);
    out.tableEnd();
    out.sectionEnd();
    out.sectionBlocks();
    for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
        dxf.writeBlock(out, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
        dxf.writeEndBlock(out, name);
    }
    out.sectionEnd();
}

void write_layer(DL_Dxf& dxf, MemoryWriter& out, const DxfLayer& layer) {
    const DL_Attributes look(layer.name, 256, -1, "BYLAYER", 1.0);
    for (const DxfPolyline& line : layer.polylines) {
        dxf.writePolyline(out, DL_PolylineData(static_cast<int>(line.points_mm.size()), 0, 0, line.closed ? 1 : 0), look);
        for (const Vec2& p : line.points_mm) dxf.writeVertex(out, DL_VertexData(p[0], p[1], 0.0, 0.0));
        dxf.writePolylineEnd(out);
    }
    for (const brep::PlaneSpline& s : layer.splines) {
        const auto knots = static_cast<int>(s.knots.size()), poles = static_cast<int>(s.control_mm.size());
        dxf.writeSpline(out, DL_SplineData(s.degree, knots, poles, 0, kPlanar), look);
        for (const double knot : s.knots) dxf.writeKnot(out, DL_KnotData(knot));
        for (const Vec2& p : s.control_mm) dxf.writeControlPoint(out, DL_ControlPointData(p[0], p[1], 0.0, 1.0));
    }
    for (const DxfArc& a : layer.arcs)
        dxf.writeArc(out, DL_ArcData(a.centre_mm[0], a.centre_mm[1], 0.0, a.radius_mm, a.begin_deg, a.end_deg), look);
    for (const DxfLine& l : layer.lines)
        dxf.writeLine(out, DL_LineData(l.from_mm[0], l.from_mm[1], 0.0, l.to_mm[0], l.to_mm[1], 0.0), look);
    for (const DxfCircle& c : layer.circles) dxf.writeCircle(out, DL_CircleData(c.centre_mm[0], c.centre_mm[1], 0.0, c.radius_mm), look);
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

const DxfLayer* DxfDrawing::layer(const std::string& name) const { return core::find_by(layers, &DxfLayer::name, name); }

void write_dxf(const std::filesystem::path& path, const DxfDrawing& drawing) {
    DL_Dxf dxf;  // writes R2000 by default
    MemoryWriter out;
    out.comment(drawing.provenance.c_str());
    dxf.writeHeader(out);
    out.dxfString(9, "$INSUNITS");
    out.dxfInt(70, 4);
    out.dxfString(9, "$MEASUREMENT");
    out.dxfInt(70, 1);
    out.sectionEnd();
    write_tables(dxf, out, drawing);
    out.sectionEntities();
    for (const DxfLayer& layer : drawing.layers) write_layer(dxf, out, layer);
    out.sectionEnd();
    dxf.writeObjects(out);
    dxf.writeObjectsEnd(out);
    out.dxfEOF();
    core::write_file(path, out.bytes());
}

}  // namespace fusee::exchange
