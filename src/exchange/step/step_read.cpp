#include <fmt/format.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <gp_Vec.hxx>
#include <mutex>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "brep/kernel/failure.h"
#include "brep/kernel/measure.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/step.h"
#include "kernel.h"
#include "step_model.h"
#include "step_rays.h"

namespace fusee::exchange {

namespace {

constexpr std::string_view kBegin = "ISO-10303-21", kEnd = "END-ISO-10303-21";
constexpr std::size_t kHeader = 1000;  // bytes that must contain kBegin
constexpr int kDeepestNesting = 100;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }

/// The number of an entity and its line.
struct Entity {
    std::uint64_t number = 0;
    std::size_t line = 0;
};
bool operator<(const Entity& a, const Entity& b) { return a.number != b.number ? a.number < b.number : a.line < b.line; }

class StepScan {
public:
    StepScan(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}

    void run() {
        while (at_ < bytes_.size()) token();
        if (depth_ != 0) fail("a parenthesis is not closed");
        std::sort(defined_.begin(), defined_.end());
        const auto same = [](const Entity& a, const Entity& b) { return a.number == b.number; };
        if (const auto twice = std::adjacent_find(defined_.begin(), defined_.end(), same); twice != defined_.end())
            fail_at((twice + 1)->line, fmt::format("#{} is defined twice", twice->number));
        for (const Entity& e : referenced_) {
            const auto found = std::lower_bound(defined_.begin(), defined_.end(), Entity{e.number, 0});
            if (found == defined_.end() || found->number != e.number)
                fail_at(e.line, fmt::format("#{} is referenced but not defined", e.number));
        }
    }

private:
    [[noreturn]] void fail_at(std::size_t line, const std::string& why) const {
        throw core::IoError(path_.string(), fmt::format("line {}: {}", line, why));
    }
    [[noreturn]] void fail(const std::string& why) const { fail_at(line_, why); }

    [[nodiscard]] char peek(std::size_t ahead = 0) const { return at_ + ahead < bytes_.size() ? bytes_[at_ + ahead] : '\0'; }

    void token() {
        const char c = peek();
        if (c == '\'' || c == '"') return skip_to(c, 1, "a text is not closed");
        if (c == '/' && peek(1) == '*') return skip_comment();
        if (c == '#') return entity();
        if (depth_ > 0 && (is_digit(c) || c == '+' || c == '-' || c == '.')) return value();
        if (depth_ > 0 && is_letter(c)) return word();
        if (c == '(' && ++depth_ > kDeepestNesting) fail(fmt::format("parentheses are nested more than {} deep", kDeepestNesting));
        if (c == ')' && --depth_ < 0) fail("a closing parenthesis has no opening one");
        if (c == ';' && depth_ != 0) fail("a parenthesis is not closed");
        advance(1);
    }

    void advance(std::size_t count) {
        const std::string_view passed = bytes_.substr(at_, count);
        line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
        at_ += passed.size();
    }
    /// Moves behind the next `mark` at or after `from`.
    void skip_to(char mark, std::size_t from, const char* why) {
        const std::size_t end = bytes_.find(mark, at_ + from);
        if (end == std::string_view::npos) fail(why);
        advance(end + 1 - at_);
    }
    void skip_comment() {
        const std::size_t end = bytes_.find("*/", at_ + 2);
        if (end == std::string_view::npos) fail("a comment is not closed");
        advance(end + 2 - at_);
    }

    /// #N: a definition if "=" follows, else a reference.
    void entity() {
        Entity entity{0, line_};
        const char* const first = bytes_.data() + at_ + 1;
        const auto [end, error] = std::from_chars(first, bytes_.data() + bytes_.size(), entity.number);
        if (error != std::errc()) fail("# is not followed by the number of an entity");
        advance(static_cast<std::size_t>(end - first) + 1);
        while (peek() == ' ' || peek() == '\t' || peek() == '\r' || peek() == '\n') advance(1);
        (depth_ == 0 && peek() == '=' ? defined_ : referenced_).push_back(entity);
    }

    /// A number, or an enumeration between dots.
    void value() {
        if (peek() == '.' && is_letter(peek(1))) return skip_to('.', 1, "an enumeration is not closed");
        const std::size_t begin = peek() == '+' ? at_ + 1 : at_;  // from_chars accepts no +
        std::size_t end = begin;
        while (end < bytes_.size() &&
               (is_digit(bytes_[end]) || is_letter(bytes_[end]) || bytes_[end] == '.' || bytes_[end] == '+' || bytes_[end] == '-'))
            ++end;
        double number = 0.0;
        const auto [stop, error] = std::from_chars(bytes_.data() + begin, bytes_.data() + end, number);
        const bool small =
            error == std::errc::result_out_of_range && bytes_.substr(begin, end - begin).find("E-") != std::string_view::npos;
        if (!small && (error != std::errc() || stop != bytes_.data() + end || !std::isfinite(number)))
            fail(fmt::format("{} is not a finite number", shown(begin, end)));
        advance(end - at_);
    }
    /// A typed value: LENGTH_MEASURE(1.0). @throws IoError for nan and any other word without a value
    void word() {
        std::size_t end = at_;
        while (end < bytes_.size() && (is_letter(bytes_[end]) || is_digit(bytes_[end]))) ++end;
        const std::size_t next = std::min(bytes_.find_first_not_of(" \t\r\n", end), bytes_.size());
        if (next == bytes_.size() || bytes_[next] != '(') fail(fmt::format("{} is not a value", shown(at_, end)));
        advance(end - at_);
    }
    /// Quotes at most 40 characters of the file: letters, digits and signs.
    [[nodiscard]] std::string shown(std::size_t begin, std::size_t end) const {
        return fmt::format("'{}'", bytes_.substr(begin, std::min<std::size_t>(end - begin, 40)));
    }

    std::string_view bytes_;
    const std::filesystem::path& path_;
    std::size_t at_ = 0, line_ = 1;
    int depth_ = 0;
    std::vector<Entity> defined_, referenced_;
};

/// Checks a STEP file (ISO 10303-21) before OpenCASCADE reads it: OpenCASCADE follows references to missing entities.
/// @throws core::IoError naming file and line: header or end missing, a reference to a missing entity, an entity
///         defined twice, a number that is not finite, a word in the place of a value, parentheses that are nested deeper than 100 or not
///         closed
void require_sound_step(std::string_view bytes, const std::filesystem::path& path) {
    if (bytes.substr(0, kHeader).find(kBegin) == std::string_view::npos)
        throw core::IoError(path.string(), fmt::format("is not a STEP file: {} is missing", kBegin));
    const std::size_t end = bytes.rfind(kEnd);
    if (end == std::string_view::npos) throw core::IoError(path.string(), fmt::format("is a STEP file without an end ({})", kEnd));
    StepScan(bytes.substr(0, end), path).run();
}

constexpr double kScale = 1e-9;  // a scale of a placement that is none

class OpenCascadeSolid : public StepSolid {
public:
    OpenCascadeSolid(const TopoDS_Shape& solid, std::string product) : solid_(solid), product_(std::move(product)), rays_(solid) {}
    [[nodiscard]] std::size_t faces() const override { return brep::count_faces(solid_); }
    [[nodiscard]] double volume_mm3() const override { return brep::volume_mm3(solid_); }
    [[nodiscard]] std::string product() const override { return product_; }
    [[nodiscard]] std::optional<double> outermost(double azimuth, double z_mm) const override {
        std::optional<double> found;
        brep::guard([&] { found = rays_.outermost(azimuth, z_mm); });
        return found;
    }

private:
    TopoDS_Shape solid_;
    std::string product_;
    StepRays rays_;
};

std::string product_of(const STEPControl_Reader& reader) {
    const Handle(StepData_StepModel) model = reader.StepModel();
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i)); !product.IsNull())
            return product->Name()->ToCString();
    return "";
}

/// In place of a direction that is not stated; all three of a placement that mirrors are.
gp_Vec direction(bool stated, const Handle(StepGeom_Direction) & d, const gp_Vec& otherwise) {
    if (!stated || d.IsNull() || d->NbDirectionRatios() < 3) return otherwise;
    return {d->DirectionRatiosValue(1), d->DirectionRatiosValue(2), d->DirectionRatiosValue(3)};
}

/// OpenCASCADE 7.6 turns a part that is placed as its mirror image, and leaves out a scale: nothing would be where the file has it.
/// @throws core::IoError
void require_rigid_placements(const STEPControl_Reader& reader, const std::filesystem::path& path) {
    const Handle(StepData_StepModel) model = reader.StepModel();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto placement = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(model->Value(i));
        if (placement.IsNull()) continue;
        const gp_Vec x = direction(placement->HasAxis1(), placement->Axis1(), {1, 0, 0}),
                     y = direction(placement->HasAxis2(), placement->Axis2(), {0, 1, 0}),
                     z = direction(placement->HasAxis3(), placement->Axis3(), x.Crossed(y));
        const bool mirrors = x.Crossed(y).Dot(z) < 0.0, scales = placement->HasScale() && std::abs(placement->Scale() - 1.0) > kScale;
        if (!mirrors && !scales) continue;
        throw core::IoError(path.string(),
                            fmt::format("#{} places a part {} (CARTESIAN_TRANSFORMATION_OPERATOR_3D), which OpenCASCADE does not "
                                        "do; export the part as it stands, without its placement",
                                        model->IdentLabel(placement), mirrors ? "as its mirror image" : "with a scale"));
    }
}

std::string text(const Handle(TCollection_HAsciiString) & from) { return from.IsNull() ? "" : from->ToCString(); }

using Use = Handle(StepRepr_NextAssemblyUsageOccurrence);

/// Those of products that are used nowhere themselves, in the file's order.
std::vector<Use> uses_of_root(const Handle(StepData_StepModel) & model) {
    std::vector<Use> all;
    std::set<const StepBasic_ProductDefinition*> used;
    for (int i = 1; i <= model->NbEntities(); ++i)
        if (const auto use = Use::DownCast(model->Value(i)); !use.IsNull()) {
            all.push_back(use);
            used.insert(use->RelatedProductDefinition().get());
        }
    std::erase_if(all, [&](const Use& use) { return used.count(use->RelatingProductDefinition().get()) > 0; });
    return all;
}

StepBody body_of(const Use& use, const TopoDS_Shape& shape) {
    return {text(use->Name()),
            text(use->RelatedProductDefinition()->Formation()->OfProduct()->Name()),
            std::make_shared<TopoDS_Shape>(shape),
            brep::count_solids(shape),
            brep::volume_mm3(shape),
            brep::bounding_box(shape)};
}

bool meet(const solid::Box& a, const solid::Box& b) {
    for (std::size_t i = 0; i < 3; ++i)
        if (a.high_mm[i] < b.low_mm[i] || b.high_mm[i] < a.low_mm[i]) return false;
    return true;
}

}  // namespace

std::mutex& step_session() {
    static std::mutex mutex;
    static const bool ready = [] {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        return STEPControl_Controller::Init();
    }();
    (void)ready;
    return mutex;
}

void with_step_shape(const std::filesystem::path& path, const std::string& bytes,
                     const std::function<void(const TopoDS_Shape&, STEPControl_Reader&)>& take) {
    require_sound_step(bytes, path);
    const std::scoped_lock lock(step_session());
    try {
        brep::guard([&] {
            STEPControl_Reader reader;  // converts every unit to millimetres
            std::istringstream in(bytes);
            if (reader.ReadStream(path.c_str(), in) != IFSelect_RetDone) throw core::IoError(path.string(), "is not a STEP file");
            require_rigid_placements(reader, path);
            if (reader.TransferRoots() == 0) throw core::IoError(path.string(), "contains no shape");
            take(reader.OneShape(), reader);
        });
    } catch (const brep::Failure& failure) {
        throw core::IoError(path.string(), failure.what());
    }
}

std::unique_ptr<StepSolid> read_step(const std::filesystem::path& path) {
    std::unique_ptr<StepSolid> solid;
    with_step_shape(path, core::read_file(path), [&](const TopoDS_Shape& shape, const STEPControl_Reader& reader) {
        if (!brep::is_one_solid(shape)) throw core::IoError(path.string(), "does not contain exactly one valid solid");
        solid = std::make_unique<OpenCascadeSolid>(shape, product_of(reader));
    });
    return solid;
}

std::vector<StepBody> read_step_assembly(const std::filesystem::path& path) {
    std::vector<StepBody> bodies;
    with_step_shape(path, core::read_file(path), [&](const TopoDS_Shape&, const STEPControl_Reader& reader) {
        const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
        for (const Use& use : uses_of_root(reader.StepModel())) {
            const TopoDS_Shape shape = TransferBRep::ShapeResult(process, use);
            if (!brep::is_valid(shape)) throw core::IoError(path.string(), "contains no valid solid named \"" + text(use->Name()) + "\"");
            bodies.push_back(body_of(use, shape));
        }
    });
    if (bodies.empty()) throw core::IoError(path.string(), "contains no instance of a product");
    return bodies;
}

std::vector<Interference> interferences(const std::vector<StepBody>& bodies, double least_mm3) {
    std::vector<Interference> all;
    brep::guard([&] {
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t k = i + 1; k < bodies.size(); ++k) {
                if (!meet(bodies[i].box, bodies[k].box)) continue;
                const double common = brep::common_volume_mm3(*bodies[i].shape, *bodies[k].shape);
                if (common >= least_mm3) all.push_back({bodies[i].name, bodies[k].name, common});
            }
    });
    std::stable_sort(all.begin(), all.end(), [](const Interference& a, const Interference& b) { return a.common_mm3 > b.common_mm3; });
    return all;
}

}  // namespace fusee::exchange
