#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/file.h"
#include "fusee/exchange/dxf.h"

namespace fusee::exchange {

namespace {

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

const DxfLayer* DxfDrawing::layer(const std::string& name) const {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const DxfLayer& l) { return l.name == name; });
    return found == layers.end() ? nullptr : &*found;
}

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
